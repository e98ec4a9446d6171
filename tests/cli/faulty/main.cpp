// The command with a fault: on any backend but cpu, one bit of point 17 is wrong.
#include <bit>
#include <cstdint>

#include "cli/commands.h"

namespace {

lacuna::Result faulty_sample(const lacuna::Request& request, lacuna::Observer& observer) {
    lacuna::Result result = lacuna::sample(request, observer);
    constexpr std::size_t kPoint = 17;
    if (request.backend != "cpu" && result.points.size() > kPoint) {
        double& x = result.points[kPoint].x;
        x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1);
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    return lacuna::cli::run_commands(argc, argv, faulty_sample);
}
