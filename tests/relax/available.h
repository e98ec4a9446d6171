// Backends of relaxation under test, by name, as in backends/available.h: one that this machine
// does not have is skipped, or fails where LACUNA_REQUIRE holds its name.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>

#include "backends/available.h"
#include "relax/relax_backends.h"

namespace lacuna::relaxing::tests {

// All but the reference, which they are held against.
inline const auto kRelaxBackends = lacuna::tests::kParallelBackends;
using lacuna::tests::name_of_parameter;
using lacuna::tests::OnBackend;

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
