// Backends of relaxation under test, by name, as in backends/available.h.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>

#include "relax/relax_backends.h"

namespace lacuna::relaxing::tests {

// All but the reference, which they are held against.
inline const auto kRelaxBackends = testing::Values("cpu");

inline std::string name_of_parameter(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

// Throws Unavailable.
inline std::unique_ptr<RelaxBackend> make_backend(const std::string& name, const Lattice& lattice,
                                                  std::span<const Site> sites,
                                                  std::uint32_t threads = 0) {
    RelaxOptions options;
    options.backend = name;
    options.threads = threads;
    return make_relax_backend(options, lattice, sites).backend;
}

}  // namespace lacuna::relaxing::tests
