// The list of backends of sets in space.
#include "space/backends.h"

#include <lacuna/errors.h>

#include "space/cpu_backend.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/opencl_backend.h"
#endif
#ifdef LACUNA_VULKAN
#include "backends/vulkan/vulkan_backend.h"
#endif

namespace lacuna::space {
namespace {

std::unique_ptr<SpaceBackend> backend_of(const std::string& name, const Plan& plan,
                                         const Placement& placement) {
    if (name == "cpu") return make_cpu_backend(plan, placement.threads);
#ifdef LACUNA_OPENCL
    if (name == "opencl") return opencl::make_space_backend(plan, placement);
#endif
#ifdef LACUNA_VULKAN
    if (name == "vulkan") return vulkan::make_space_backend(plan, placement);
#endif
    throw Unavailable("backend " + name + ": this build was made without it");
}

}  // namespace

std::unique_ptr<SpaceBackend> make_backend(const std::string& name, const Plan& plan,
                                           const RunOn& run_on, Observer& observer) {
    if (name == "reference") return nullptr;
    observer.begin(Verb::first_use);
    std::unique_ptr<SpaceBackend> backend = backend_of(name, plan, {run_on.device, run_on.threads});
    observer.end(Verb::first_use);
    return backend;
}

}  // namespace lacuna::space
