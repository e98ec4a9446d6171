// Reads JPEG with libjpeg-turbo.
#include <cstdio>  // for jpeglib.h, which does not include what it needs

#include <jpeglib.h>

#include <fmt/core.h>
#include <jerror.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
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

// About ten scans are usual. A scan of a few bytes takes as long to decode as the first.
constexpr int kMaxScans = 100;

// Whether the pixels are whole in spite of the warning. The other warnings report missing or
// damaged data, which libjpeg would fill with grey.
bool is_harmless(int warning) {
    return warning == JWRN_EXTRANEOUS_DATA || warning == JWRN_TOO_MUCH_DATA ||
           warning == JWRN_ADOBE_XFORM || warning == JWRN_JFIF_MAJOR;
}

class JpegReader {
public:
    explicit JpegReader(const Encoded& file) : file_(file) {
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = on_error;
        errors_.emit_message = on_message;
        jpeg_.client_data = this;
        guarded([&] { jpeg_create_decompress(&jpeg_); });
        progress_.progress_monitor = on_progress;
        jpeg_.progress = &progress_;
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }

    Image read() {
        guarded([&] {
            jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(file_.bytes.data()),
                         file_.bytes.size());
            jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 0xffff);
            jpeg_read_header(&jpeg_, TRUE);
        });
        check_size(file_, size());
        check_kind();
        check_that_pixels_fit();
        jpeg_.out_color_space = jpeg_.jpeg_color_space == JCS_GRAYSCALE ? JCS_GRAYSCALE
                                : is_cmyk()                             ? JCS_CMYK
                                                                        : JCS_RGB;
        guarded([&] { jpeg_start_decompress(&jpeg_); });
        Image image = make_image(file_, size());
        read_rows(image);
        const int turn = orientation();  // read before libjpeg frees the markers
        guarded([&] { jpeg_finish_decompress(&jpeg_); });
        return upright(std::move(image), turn);
    }

private:
    // Calls `step`, which libjpeg leaves by longjmp on an error. So `step` must not hold anything
    // that has a destructor.
    template <class Step>
    void guarded(const Step& step) {
        if (setjmp(where_) != 0) {
            if (stopped_) std::rethrow_exception(stopped_);
            file_.refuse(fmt::format("not a whole JPEG: libjpeg says {}",
                                     files::excerpt(complaint_.data())));
        }
        step();
    }

    static void on_error(j_common_ptr jpeg) {
        auto& self = *static_cast<JpegReader*>(jpeg->client_data);
        jpeg->err->format_message(jpeg, self.complaint_.data());
        std::longjmp(self.where_, 1);
    }

    static void on_message(j_common_ptr jpeg, int level) {
        if (level < 0 && !is_harmless(jpeg->err->msg_code)) on_error(jpeg);
    }

    static void on_progress(j_common_ptr jpeg) {
        auto& self = *static_cast<JpegReader*>(jpeg->client_data);
        if (self.must_stop()) std::longjmp(self.where_, 1);
        if (self.jpeg_.input_scan_number <= kMaxScans) return;
        constexpr std::string_view kText = "more than 100 scans";
        self.complaint_ = {};
        kText.copy(self.complaint_.data(), kText.size());
        std::longjmp(self.where_, 1);
    }

    // libjpeg calls on_progress for each row of blocks. Exceptions may not pass through it.
    bool must_stop() {
        try {
            ask_after(std::size_t{jpeg_.image_width} * DCTSIZE);
        } catch (...) {
            stopped_ = std::current_exception();
        }
        return stopped_ != nullptr;
    }

    Size size() const { return {jpeg_.image_width, jpeg_.image_height}; }

    int orientation() const {
        for (const auto* marker = jpeg_.marker_list; marker != nullptr; marker = marker->next) {
            const int found =
                orientation_of({reinterpret_cast<const char*>(marker->data), marker->data_length});
            if (found != 1) return found;
        }
        return 1;
    }

    bool is_cmyk() const {
        return jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK;
    }

    void check_kind() const {
        const J_COLOR_SPACE space = jpeg_.jpeg_color_space;
        if (space != JCS_GRAYSCALE && space != JCS_RGB && space != JCS_YCbCr && !is_cmyk())
            file_.refuse(fmt::format("a JPEG of {} colour components: must be grey, RGB or CMYK",
                                     jpeg_.num_components));
        // check_that_pixels_fit() has no bound for its size, and hardly any program writes it.
        if (jpeg_.arith_code != FALSE)
            file_.refuse("a JPEG in arithmetic coding: must be Huffman coded");
    }

    // Called before memory is allocated. A block of a scan takes at least one bit.
    void check_that_pixels_fit() const {
        std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
        for (const jpeg_component_info& component :
             std::span(jpeg_.comp_info, static_cast<std::size_t>(jpeg_.num_components)))
            least = std::min(least,
                             std::uint64_t{component.width_in_blocks} * component.height_in_blocks);
        if (least / 8 > file_.bytes.size())
            file_.refuse(fmt::format("not a whole JPEG: {} bytes cannot hold {} x {} pixels",
                                     file_.bytes.size(), size().columns, size().rows));
    }

    // Converts a row of cyan, magenta, yellow and black to red, green and blue, in place, without a
    // printer's profile. Nearly all files are Adobe's, which hold 255 - ink.
    void without_ink(std::vector<JSAMPLE>& row) const {
        const bool has_paper = jpeg_.saw_Adobe_marker != FALSE;
        const auto paper = [&](JSAMPLE value) {
            return std::int32_t{has_paper ? value : static_cast<JSAMPLE>(MAXJSAMPLE - value)};
        };
        for (std::size_t from = 0, to = 0; from < row.size(); from += 4, to += 3) {
            const std::int32_t black = paper(row[from + 3]);
            for (std::size_t i = 0; i < 3; ++i)
                row[to + i] = static_cast<JSAMPLE>((paper(row[from + i]) * black + MAXJSAMPLE / 2) /
                                                   MAXJSAMPLE);
        }
    }

    void read_rows(Image& image) {
        const auto components = static_cast<unsigned>(jpeg_.output_components);
        const unsigned channels = is_cmyk() ? 3 : components;
        std::vector<JSAMPLE> bytes(std::size_t{image.columns} * components);
        const std::span<double> all = image.luminance;
        guarded([&] {
            JSAMPROW row = bytes.data();
            for (std::size_t y = 0; y < image.rows; ++y) {
                jpeg_read_scanlines(&jpeg_, &row, 1);
                if (is_cmyk()) without_ink(bytes);
                fill_row_from(row, channels, false, all.subspan(y * image.columns, image.columns),
                              MAXJSAMPLE, file_.reading);
            }
        });
    }

    const Encoded& file_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf where_{};
    std::array<char, JMSG_LENGTH_MAX> complaint_{};
    std::exception_ptr stopped_;  // what ask_after() threw
};

}  // namespace

Image decode_jpeg(const Encoded& file) {
    return JpegReader(file).read();
}

}  // namespace lacuna::pictures
