// The functions by which libtiff reads a file that lies in memory.
#pragma once

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace lacuna::pictures {

// The file in memory, as libtiff reads it.
struct TiffMemory {
    std::string_view bytes;
    std::uint64_t at = 0;

    static TiffMemory& of(thandle_t handle) { return *static_cast<TiffMemory*>(handle); }
    static tmsize_t read(thandle_t handle, void* to, tmsize_t count) {
        TiffMemory& memory = of(handle);
        const std::string_view rest =
            memory.bytes.substr(std::min<std::uint64_t>(memory.at, memory.bytes.size()),
                                static_cast<std::size_t>(count));
        std::memcpy(to, rest.data(), rest.size());
        memory.at += rest.size();
        return static_cast<tmsize_t>(rest.size());
    }
    static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }
    static toff_t seek(thandle_t handle, toff_t to, int from) {
        TiffMemory& memory = of(handle);
        if (from == SEEK_CUR) to += memory.at;
        if (from == SEEK_END) to += memory.bytes.size();
        return memory.at = to;
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
    // libtiff 4.5 refuses whole tiles that are not mapped. It only reads what it maps.
    static int map(thandle_t handle, void** base, toff_t* size) {
        const std::string_view bytes = of(handle).bytes;
        *base = const_cast<char*>(bytes.data());
        *size = bytes.size();
        return 1;
    }
    static void unmap(thandle_t, void*, toff_t) {}
};

}  // namespace lacuna::pictures
