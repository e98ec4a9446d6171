// A shared library that is loaded when it is first needed, because it is not installed everywhere.
#pragma once

#include <dlfcn.h>

#include <string>
#include <type_traits>

namespace lacuna {

// It is never closed.
class LoadedLibrary {
public:
    // `file` such as libheif.so.1 is called `name` in messages, and is in the Debian package.
    LoadedLibrary(const std::string& file, const std::string& name, const std::string& package)
        : file_(file), handle_(::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
        if (handle_ == nullptr)
            missing_ = name + " cannot be loaded: " + ::dlerror() + " (Debian: " + package + ")";
    }

    // Sets `function` to the one of this name.
    template <typename Function>
    void find(Function& function, const char* name) {
        if (handle_ == nullptr) return;
        function = reinterpret_cast<Function>(::dlsym(handle_, name));
        if (function == nullptr && missing_.empty()) missing_ = file_ + " lacks " + name;
    }

    // What is missing; empty if the library and all functions were found.
    const std::string& missing() const { return missing_; }

private:
    std::string file_;
    void* handle_;
    std::string missing_{};
};

}  // namespace lacuna
