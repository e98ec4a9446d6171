// Reads PNG with libpng.
#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/exif.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// The last message of libpng. It has no destructor: libpng leaves its callbacks by longjmp.
class Complaint {
public:
    void set(const char* text) { std::strncpy(text_.data(), text, text_.size() - 1); }
    std::string_view text() const { return text_.data(); }

private:
    std::array<char, 200> text_{};
};

class PngReader {
public:
    explicit PngReader(const Encoded& file)
        : file_(file),
          rest_(file.bytes),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, on_error, on_warning)) {
        if (png_ != nullptr) info_ = png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, &info_, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, read);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size has its own
        // Only pixels, palette, transparency and orientation are read. Profiles and texts are
        // skipped, because they could be large when unpacked.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        static const png_byte exif[] = "eXIf";
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_AS_DEFAULT, exif, 1);
        static const png_byte animation[] = "acTL";  // to be refused
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS, animation, 1);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    Image read() {
        check_announced_size();
        guarded([&] { png_read_info(png_, info_); });
        check_that_it_is_one();
        check_that_pixels_fit();
        int passes = 1;
        guarded([&] {
            // Expands pixels to 8 or 16 bits a channel; palette and transparent colour become
            // channels.
            png_set_expand(png_);
            passes = png_set_interlace_handling(png_);
            png_read_update_info(png_, info_);
        });
        Image image = make_image(file_, size());
        if (passes == 1)
            read_row_by_row(image);
        else
            read_interlaced(image, passes);
        guarded([&] { png_read_end(png_, info_); });
        return upright(std::move(image), orientation());
    }

private:
    // Calls `step`, which libpng leaves by longjmp on an error. So `step` must not hold anything
    // that has a destructor.
    template <class Step>
    void guarded(const Step& step) {
        if (setjmp(png_jmpbuf(png_)) != 0)
            file_.refuse(
                fmt::format("not a whole PNG: libpng says {}", files::excerpt(complaint_.text())));
        step();
    }

    static void read(png_structp png, png_bytep out, std::size_t count) {
        std::string_view& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest_;
        if (count > rest.size()) png_error(png, "the file ends too early");
        std::copy_n(rest.begin(), count, out);
        rest.remove_prefix(count);
    }

    [[noreturn]] static void on_error(png_structp png, const char* text) {
        static_cast<Complaint*>(png_get_error_ptr(png))->set(text);
        png_longjmp(png, 1);
    }

    static void on_warning(png_structp, const char*) {}

    Size size() const {
        return {png_get_image_width(png_, info_), png_get_image_height(png_, info_)};
    }

    // Reads the size from the first chunk, as the format demands, for a message of our own.
    void check_announced_size() const {
        constexpr std::size_t kColumns = 16;
        constexpr std::size_t kRows = 20;
        if (file_.bytes.size() < kRows + 4) return;  // libpng reports that the file is too short
        const auto number = [&](std::size_t at) {
            return std::uint64_t{
                files::load<std::uint32_t>(file_.bytes.substr(at), std::endian::big)};
        };
        check_size(file_, {number(kColumns), number(kRows)});
    }

    // The chunk acTL begins with the number of pictures.
    void check_that_it_is_one() const {
        png_unknown_chunkp kept = nullptr;
        if (png_get_unknown_chunks(png_, info_, &kept) <= 0 || kept->size < 4) return;
        const std::string_view number(reinterpret_cast<const char*>(kept->data), 4);
        if (files::load<std::uint32_t>(number, std::endian::big) > 1)
            file_.refuse("an animated PNG: must be one picture");
    }

    // Called before memory is allocated. Deflate packs at most 1032 bytes into one.
    void check_that_pixels_fit() const {
        check_size(file_, size());
        constexpr std::uint64_t kHighestRatio = 1032;
        const std::uint64_t unpacked = size().rows * png_get_rowbytes(png_, info_);
        if (unpacked / kHighestRatio > file_.bytes.size())
            file_.refuse(fmt::format("not a whole PNG: {} bytes cannot hold {} x {} pixels",
                                     file_.bytes.size(), size().columns, size().rows));
    }

    int orientation() {
        png_uint_32 size = 0;
        png_bytep exif = nullptr;
        if (png_get_eXIf_1(png_, info_, &size, &exif) == 0) return 1;
        return orientation_in({reinterpret_cast<const char*>(exif), size});
    }

    void convert(const png_byte* bytes, std::span<double> row) const {
        const bool is_wide = png_get_bit_depth(png_, info_) == 16;
        fill_row_from(bytes, png_get_channels(png_, info_), is_wide, row, is_wide ? 65535 : 255,
                      file_.reading);
    }

    void read_row_by_row(Image& image) {
        std::vector<png_byte> bytes(png_get_rowbytes(png_, info_));
        const std::span<double> all = image.luminance;
        guarded([&] {
            for (std::size_t y = 0; y < image.rows; ++y) {
                png_read_row(png_, bytes.data(), nullptr);
                convert(bytes.data(), all.subspan(y * image.columns, image.columns));
            }
        });
    }

    void read_interlaced(Image& image, int passes) {
        const std::size_t row_size = png_get_rowbytes(png_, info_);
        std::vector<png_byte> bytes(row_size * image.rows);
        guarded([&] {
            for (int pass = 0; pass < passes; ++pass)
                for (std::size_t y = 0; y < image.rows; ++y) {
                    ask_after(image.columns);
                    png_read_row(png_, bytes.data() + y * row_size, nullptr);
                }
        });
        const std::span<double> all = image.luminance;
        for (std::size_t y = 0; y < image.rows; ++y)
            convert(bytes.data() + y * row_size, all.subspan(y * image.columns, image.columns));
    }

    const Encoded& file_;
    std::string_view rest_;
    Complaint complaint_;
    png_structp png_;
    png_infop info_ = nullptr;
};

}  // namespace

Image decode_png(const Encoded& file) {
    return PngReader(file).read();
}

}  // namespace lacuna::pictures
