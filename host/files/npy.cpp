// Reads and writes the header of .npy files.
#include "files/npy.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "files/parse.h"

namespace lacuna::files {
namespace {

constexpr std::size_t kLongestHeader = 10000;  // the same limit as NumPy's

// Reads the header, a Python dictionary such as
// {'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }
class HeaderReader {
public:
    explicit HeaderReader(std::string_view text) : rest_(text) {}

    // Empty if the text is not such a dictionary with each of the three keys exactly once.
    std::optional<NpyHeader> read() {
        NpyHeader header;
        unsigned keys = 0;
        if (!take("{")) return std::nullopt;
        while (!take("}")) {
            const unsigned key = read_entry(header);
            if (key == 0 || (keys & key) != 0) return std::nullopt;
            keys |= key;
            if (!take(",") && !rest_.starts_with('}')) return std::nullopt;
        }
        if (keys != 7 || !rest_.empty()) return std::nullopt;
        return header;
    }

private:
    // Returns the bit that stands for the key it read, or 0 if it read none.
    unsigned read_entry(NpyHeader& header) {
        std::string_view key;
        if (!take_string(key) || !take(":")) return 0;
        if (key == "descr") return take_string(header.descr) ? 1 : 0;
        if (key == "fortran_order") return take_truth(header.fortran_order) ? 2 : 0;
        if (key == "shape") return take_shape(header.shape) ? 4 : 0;
        return 0;
    }

    bool take(std::string_view token) {
        skip();
        if (!rest_.starts_with(token)) return false;
        rest_.remove_prefix(token.size());
        skip();
        return true;
    }

    bool take_string(std::string_view& value) {
        skip();
        if (!rest_.starts_with('\'') && !rest_.starts_with('"')) return false;
        const std::size_t end = rest_.find(rest_.front(), 1);
        if (end == std::string_view::npos) return false;
        value = rest_.substr(1, end - 1);
        rest_.remove_prefix(end + 1);
        skip();
        return true;
    }

    bool take_truth(bool& value) {
        value = take("True");
        return value || take("False");
    }

    bool take_shape(std::vector<std::uint64_t>& shape) {
        if (!take("(")) return false;
        while (!take(")")) {
            std::uint64_t side = 0;
            if (take_number(rest_, side) != std::errc{}) return false;
            shape.push_back(side);
            take("L");  // Python 2 writes a long integer as 3L
            if (!take(",") && !rest_.starts_with(')')) return false;
        }
        return true;
    }

    void skip() {
        const std::size_t end = rest_.find_first_not_of(" \t\r\n");
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end);
    }

    std::string_view rest_;
};

// Removes magic, version, length and header from `bytes`; the data remains. Returns the header.
std::string_view take_text(std::string_view& bytes, const std::string& name) {
    if (!bytes.starts_with(kNpyMagic))
        refuse(name, "not a .npy file: it must begin with \\x93NUMPY");
    bytes.remove_prefix(kNpyMagic.size());
    if (bytes.size() < 2) refuse(name, "ends before the version of its format");
    const auto major = load_little_endian<std::uint8_t>(bytes);
    const auto minor = load_little_endian<std::uint8_t>(bytes.substr(1));
    bytes.remove_prefix(2);
    if (major < 1 || major > 3 || minor != 0)
        refuse(name, fmt::format("version {}.{} of .npy: must be 1.0, 2.0 or 3.0", major, minor));
    const std::size_t length_size = major == 1 ? 2 : 4;
    if (bytes.size() < length_size) refuse(name, "ends before the length of its header");
    const std::size_t length = major == 1 ? load_little_endian<std::uint16_t>(bytes)
                                          : load_little_endian<std::uint32_t>(bytes);
    bytes.remove_prefix(length_size);
    if (length > kLongestHeader)
        refuse(name,
               fmt::format("a header of {} bytes: must be at most {}", length, kLongestHeader));
    if (bytes.size() < length)
        refuse(name, fmt::format("ends in its header: {} bytes of {}", bytes.size(), length));
    const std::string_view header = bytes.substr(0, length);
    bytes.remove_prefix(length);
    return header;
}

}  // namespace

NpyHeader take_npy_header(std::string_view& bytes, const std::string& name) {
    const std::string_view text = take_text(bytes, name);
    const std::optional<NpyHeader> header = HeaderReader(text).read();
    if (!header)
        refuse(name, fmt::format("the header {} must give descr, fortran_order and shape",
                                 excerpt(text)));
    return *header;
}

std::string shape_text(const std::vector<std::uint64_t>& shape) {
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

}  // namespace lacuna::files
