// Backends of relax under test, by name, as in backends/available.h: tests of a missing one are
// skipped, or fail if LACUNA_REQUIRE holds its name.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>

#include "backends/available.h"
#include "relax/relax_backends.h"

namespace lacuna::relaxing::tests {

// All except the reference, with which they are compared.
inline const auto kRelaxBackends = lacuna::tests::kParallelBackends;
using lacuna::tests::name_of_parameter;
using lacuna::tests::OnBackend;

// Throws Unavailable.
inline std::unique_ptr<RelaxBackend> make_backend(const std::string& name, const Lattice& lattice,
                                                  std::span<const Site> sites,
                                                  std::uint32_t threads = 0) {
    return make_relax_backend({.backend = name, .threads = threads}, lattice, sites).backend;
}

}  // namespace lacuna::relaxing::tests
