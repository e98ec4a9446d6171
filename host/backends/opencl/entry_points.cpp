// Looks OpenCL's functions up.
#define LACUNA_OPENCL_OWN_NAMES
#include "backends/opencl/entry_points.h"

#include <dlfcn.h>

#define LACUNA_DEFINE(name) lacuna::opencl::EntryPoint<decltype(::name)> lacuna_##name;
LACUNA_OPENCL_ENTRIES(LACUNA_DEFINE)
#undef LACUNA_DEFINE

namespace lacuna::opencl {
namespace {

template <typename Function>
bool find(EntryPoint<Function>& entry, void* where, const char* name) {
    entry.found = reinterpret_cast<Function*>(::dlsym(where, name));
    return entry.found != nullptr;
}

// The name of a function that was not found; empty when all were found.
std::string first_missing(void* where) {
#define LACUNA_FIND(name) \
    if (!find(lacuna_##name, where, #name)) return #name;
    LACUNA_OPENCL_ENTRIES(LACUNA_FIND)
#undef LACUNA_FIND
    return "";
}

std::string look_up() {
    if (first_missing(RTLD_DEFAULT).empty()) return "";
    // Never closed: by the end of the process its drivers' threads may still run.
    void* const loader = ::dlopen("libOpenCL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (loader == nullptr) return std::string("the OpenCL loader cannot be opened: ") + ::dlerror();
    const std::string missing = first_missing(loader);
    return missing.empty() ? "" : "the OpenCL loader libOpenCL.so.1 lacks " + missing;
}

}  // namespace

std::string why_no_loader() {
    static const std::string why = look_up();
    return why;
}

}  // namespace lacuna::opencl
