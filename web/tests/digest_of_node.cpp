// Replaces host/files/digest.cpp, which needs OpenSSL: node computes the SHA-256.
#include <emscripten.h>

#include <span>
#include <string>

#include "files/little_endian.h"
#include "files/point_files.h"

namespace {

// Writes 64 letters to `out`.
EM_JS(void, sha256_of_node, (const char* bytes, int size, char* out), {
    const hash = require("crypto").createHash("sha256");
    const hex = hash.update(HEAPU8.subarray(bytes, bytes + size)).digest("hex");
    for (let i = 0; i < hex.length; ++i) HEAPU8[out + i] = hex.charCodeAt(i);
});

}  // namespace

namespace lacuna::files {

std::string sha256_of(std::span<const Point> points) {
    constexpr std::size_t kLetters = 64;
    std::string bytes;
    for (const Point& point : points) {
        append_little_endian(bytes, point.x);
        append_little_endian(bytes, point.y);
    }
    std::string hex(kLetters, '-');
    sha256_of_node(bytes.data(), static_cast<int>(bytes.size()), hex.data());
    return hex;
}

}  // namespace lacuna::files
