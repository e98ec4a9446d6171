// The command with faults: on any backend except cpu, one bit of point 17 is wrong; with seed 9 the
// backend fails at its third set; with 10 to 13 the program is ended as drivers end it, with 14
// memory is exhausted, and with 15 the program finds a fault of its own.
#include <signal.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>

#include "cli/commands/commands.h"

namespace {

lacuna::Result faulty_sample(const lacuna::Request& request, lacuna::Observer& observer) {
    if (request.run_on.backend == "cpu") return lacuna::sample(request, observer);
    constexpr std::uint64_t kFailingSeed = 9;
    static int runs = 0;
    if (request.seed == kFailingSeed) {
        if (++runs > 2) throw lacuna::DeviceError("device of the test: lost");
        return lacuna::sample(request, observer);
    }
    lacuna::Result result = lacuna::sample(request, observer);
    constexpr std::uint64_t kExiting = 10;
    constexpr std::uint64_t kAborting = 11;
    constexpr std::uint64_t kCrashing = 12;
    constexpr std::uint64_t kThrowing = 13;
    constexpr std::uint64_t kExhausted = 14;
    if (request.seed == kExiting) std::exit(1);
    if (request.seed == kAborting) std::abort();
    if (request.seed == kCrashing) raise(SIGSEGV);
    if (request.seed == kThrowing) std::thread([] { throw std::bad_alloc(); }).join();
    constexpr std::uint64_t kBug = 15;
    if (request.seed == kExhausted) throw std::bad_alloc();
    if (request.seed == kBug) throw std::logic_error("a box of no sheet");
    constexpr std::size_t kPoint = 17;
    if (result.points.size() > kPoint) {
        double& x = result.points[kPoint].x;
        x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1);
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    return lacuna::cli::run_commands(argc, argv, faulty_sample);
}
