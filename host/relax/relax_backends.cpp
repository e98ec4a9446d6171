// The list of backends for relaxation, in order of preference.
#include "relax/relax_backends.h"

#include <string_view>

#include "backends/backends.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/opencl_backend.h"
#endif
#ifdef LACUNA_VULKAN
#include "backends/vulkan/vulkan_backend.h"
#endif
#include "relax/cpu/cpu_relax.h"
#include "relax/cpu/gaussian.h"
#include "relax/device/device_relax.h"
#include "relax/device/gaussian.h"
#include "relax/gaussian_reference.h"
#include "relax/reference.h"

namespace lacuna::relaxing {
namespace {

struct Entry {
    std::string_view name;
    std::unique_ptr<RelaxBackend> (*make)(const Lattice&, std::span<const Site>, const Placement&,
                                          const Poll&);
    std::unique_ptr<GaussianBackend> (*make_gaussian)(const GaussianField&, std::span<const Spot>,
                                                      const Placement&, const Poll&);
};

#ifdef LACUNA_OPENCL
std::unique_ptr<RelaxBackend> make_opencl(const Lattice& lattice, std::span<const Site> sites,
                                          const Placement& placement, const Poll& poll) {
    return device::make_backend(opencl::open_queue(placement), lattice, sites, {}, poll);
}

std::unique_ptr<GaussianBackend> make_gaussian_opencl(const GaussianField& field,
                                                      std::span<const Spot> spots,
                                                      const Placement& placement, const Poll&) {
    return device::make_gaussian_backend(opencl::open_queue(placement), field, spots);
}
#endif

#ifdef LACUNA_VULKAN
std::unique_ptr<RelaxBackend> make_vulkan(const Lattice& lattice, std::span<const Site> sites,
                                          const Placement& placement, const Poll& poll) {
    return device::make_backend(vulkan::open_queue(placement), lattice, sites, {}, poll);
}

std::unique_ptr<GaussianBackend> make_gaussian_vulkan(const GaussianField& field,
                                                      std::span<const Spot> spots,
                                                      const Placement& placement, const Poll&) {
    return device::make_gaussian_backend(vulkan::open_queue(placement), field, spots);
}
#endif

#if !defined(LACUNA_OPENCL) || !defined(LACUNA_VULKAN)
std::unique_ptr<RelaxBackend> make_left_out(const Lattice&, std::span<const Site>, const Placement&,
                                            const Poll&) {
    throw Unavailable("this build was made without it");
}

std::unique_ptr<GaussianBackend> make_gaussian_left_out(const GaussianField&, std::span<const Spot>,
                                                        const Placement&, const Poll&) {
    throw Unavailable("this build was made without it");
}
#endif

constexpr Entry kBackends[] = {
    {"cpu", cpu::make_backend, cpu::make_gaussian_backend},
#ifdef LACUNA_OPENCL
    {"opencl", make_opencl, make_gaussian_opencl},
#else
    {"opencl", make_left_out, make_gaussian_left_out},
#endif
#ifdef LACUNA_VULKAN
    {"vulkan", make_vulkan, make_gaussian_vulkan},
#else
    {"vulkan", make_left_out, make_gaussian_left_out},
#endif
#ifndef LACUNA_CPU_ONLY
    {"reference", reference::make_backend, reference::make_gaussian_backend},
#endif
};

const Entry& chosen(const RunOn& run_on) {
    const std::string wanted = wanted_backend(run_on.backend);
    for (const Entry& entry : kBackends)
        if (wanted == "auto" || wanted == entry.name) return entry;
    throw no_such_backend(wanted);
}

}  // namespace

Chosen make_relax_backend(const RunOn& run_on, const Lattice& lattice, std::span<const Site> sites,
                          const Poll& poll) {
    const Entry& entry = chosen(run_on);
    return {std::string(entry.name),
            entry.make(lattice, sites, {run_on.device, run_on.threads}, poll)};
}

ChosenForGaussian make_gaussian_backend(const RunOn& run_on, const GaussianField& field,
                                        std::span<const Spot> spots, const Poll& poll) {
    const Entry& entry = chosen(run_on);
    return {std::string(entry.name),
            entry.make_gaussian(field, spots, {run_on.device, run_on.threads}, poll)};
}

}  // namespace lacuna::relaxing
