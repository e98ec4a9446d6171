// Unpacks gzip with zlib.
#include "files/gzip.h"

#include <zlib.h>

#include <array>
#include <memory>
#include <new>

#include "base/polling.h"
#include "files/parse.h"

namespace lacuna::files {

bool is_gzip(std::string_view bytes) {
    return bytes.starts_with("\x1f\x8b");
}

std::string unpacked_gzip(std::string_view bytes, const std::string& name, std::size_t most) {
    constexpr int kOnlyGzip = MAX_WBITS + 16;
    z_stream stream{};
    if (inflateInit2(&stream, kOnlyGzip) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> owner(&stream, inflateEnd);
    std::string all;
    std::array<char, 1 << 16> part{};
    for (int state = Z_OK; state != Z_STREAM_END;) {
        if (stream.avail_in == 0) {
            const std::string_view next = bytes.substr(0, 1U << 30U);
            bytes.remove_prefix(next.size());
            // zlib reads these bytes, but has no const.
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next.data()));
            stream.avail_in = static_cast<uInt>(next.size());
        }
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        if (state != Z_OK && state != Z_STREAM_END)
            refuse(name, "cannot be unpacked by gzip; is the file whole?");
        all.append(part.data(), part.size() - stream.avail_out);
        if (all.size() > most)
            refuse(name, fmt::format("holds more than {} MiB when unpacked: must hold less",
                                     most >> 20U));
        ask_after(part.size());
    }
    return all;
}

}  // namespace lacuna::files
