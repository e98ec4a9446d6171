// Reads HEIF, of which HEIC and AVIF are kinds, with libheif. It is loaded for the first such
// picture, because it is not installed everywhere, and binds the decoders of three kinds of video.
#include "pictures/decode.h"

#ifdef LACUNA_HEIF

#include <fmt/core.h>
#include <libheif/heif.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/loaded_library.h"
#include "base/polling.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// The functions of libheif that are used. Its library is never closed.
class Libheif {
public:
    static const Libheif& loaded() {
        static const Libheif one;
        return one;
    }

    decltype(&heif_context_alloc) alloc{};
    decltype(&heif_context_free) free{};
    decltype(&heif_context_read_from_memory_without_copy) read{};
    decltype(&heif_context_get_primary_image_handle) primary{};
    decltype(&heif_image_handle_release) release_handle{};
    decltype(&heif_image_handle_get_width) width{};
    decltype(&heif_image_handle_get_height) height{};
    decltype(&heif_image_handle_has_alpha_channel) has_alpha{};
    decltype(&heif_image_handle_is_premultiplied_alpha) is_premultiplied{};
    decltype(&heif_decoding_options_alloc) alloc_options{};
    decltype(&heif_decoding_options_free) free_options{};
    decltype(&heif_decode_image) decode{};
    decltype(&heif_image_release) release_image{};
    decltype(&heif_image_get_plane_readonly) plane{};
    decltype(&heif_image_get_width) decoded_width{};
    decltype(&heif_image_get_height) decoded_height{};

    // Empty if all functions were found.
    const std::string& missing() const { return library_.missing(); }

private:
    Libheif() {
        library_.find(alloc, "heif_context_alloc");
        library_.find(free, "heif_context_free");
        library_.find(read, "heif_context_read_from_memory_without_copy");
        library_.find(primary, "heif_context_get_primary_image_handle");
        library_.find(release_handle, "heif_image_handle_release");
        library_.find(width, "heif_image_handle_get_width");
        library_.find(height, "heif_image_handle_get_height");
        library_.find(has_alpha, "heif_image_handle_has_alpha_channel");
        library_.find(is_premultiplied, "heif_image_handle_is_premultiplied_alpha");
        library_.find(alloc_options, "heif_decoding_options_alloc");
        library_.find(free_options, "heif_decoding_options_free");
        library_.find(decode, "heif_decode_image");
        library_.find(release_image, "heif_image_release");
        library_.find(plane, "heif_image_get_plane_readonly");
        library_.find(decoded_width, "heif_image_get_width");
        library_.find(decoded_height, "heif_image_get_height");
    }

    LoadedLibrary library_{"libheif.so.1", "libheif", "libheif1"};
};

void check(const Encoded& file, const heif_error& error) {
    if (error.code == heif_error_Ok) return;
    std::string_view why = error.message;
    if (why.ends_with('\n')) why.remove_suffix(1);
    file.refuse(fmt::format("not a HEIF that libheif can decode: {}", why));
}

}  // namespace

Image decode_heif(const Encoded& file) {
    const Libheif& heif = Libheif::loaded();
    if (!heif.missing().empty()) file.refuse(fmt::format("{}; {}", kFromHeif, heif.missing()));
    const std::unique_ptr<heif_context, decltype(heif.free)> context(heif.alloc(), heif.free);
    check(file, heif.read(context.get(), file.bytes.data(), file.bytes.size(), nullptr));
    heif_image_handle* found = nullptr;
    check(file, heif.primary(context.get(), &found));
    const std::unique_ptr<heif_image_handle, decltype(heif.release_handle)> handle(
        found, heif.release_handle);
    const Size size{static_cast<std::uint64_t>(heif.width(found)),
                    static_cast<std::uint64_t>(heif.height(found))};
    check_size(file, size);
    if (heif.is_premultiplied(found) != 0)
        file.refuse("a HEIF whose colours are multiplied by its transparency: save it without");
    ask_after(size.pixels());
    const std::unique_ptr<heif_decoding_options, decltype(heif.free_options)> options(
        heif.alloc_options(), heif.free_options);
    options->convert_hdr_to_8bit = 1;
    const unsigned channels = heif.has_alpha(found) != 0 ? 4 : 3;
    heif_image* decoded = nullptr;
    check(file,
          heif.decode(found, &decoded, heif_colorspace_RGB,
                      channels == 4 ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB,
                      options.get()));
    const std::unique_ptr<heif_image, decltype(heif.release_image)> picture(decoded,
                                                                            heif.release_image);
    int stride = 0;
    const std::uint8_t* const pixels = heif.plane(picture.get(), heif_channel_interleaved, &stride);
    const auto decoded_size = [&](auto size_of) {
        return std::max(0, size_of(picture.get(), heif_channel_interleaved));
    };
    const Size decoded_as{static_cast<std::uint64_t>(decoded_size(heif.decoded_width)),
                          static_cast<std::uint64_t>(decoded_size(heif.decoded_height))};
    // libheif does not compare what a file says with what is in it.
    if (pixels == nullptr || decoded_as.columns != size.columns || decoded_as.rows != size.rows ||
        static_cast<std::uint64_t>(stride) < channels * size.columns)
        file.refuse(fmt::format("not a whole HEIF: has {} x {} pixels, but says {} x {}",
                                decoded_as.columns, decoded_as.rows, size.columns, size.rows));
    Image image = make_image(file, size);
    const std::span<double> all = image.luminance;
    for (std::size_t y = 0; y < image.rows; ++y)
        fill_row_from(pixels + y * static_cast<std::size_t>(stride), channels, false,
                      all.subspan(y * image.columns, image.columns), 255, file.reading);
    return image;
}

}  // namespace lacuna::pictures

#else

namespace lacuna::pictures {

Image decode_heif(const Encoded& file) {
    file.refuse(std::string(kFromHeif) + "; this program was built without libheif");
}

}  // namespace lacuna::pictures

#endif
