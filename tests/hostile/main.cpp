// hostile: random requests, each made by all backends, whose answers must be the same to the byte.
// The points of some are relaxed over pictures that are nearly white.
//
//     hostile [--seconds S] [--seed N] [--skip K]
//
// It runs for S seconds (20) and prints the seed, which is a new one each time unless it is given;
// --skip goes to request K of the seed. Ends with 1 at the first difference, and names the request.
#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/options.h"
#include "hostile/random_request.h"

namespace {

using namespace lacuna;

constexpr std::array<std::string_view, 3> kOptions{"--seconds", "--seed", "--skip"};
constexpr double kSeconds = 20;

// The available backends, the reference first.
std::vector<std::string> backends() {
    std::vector<std::string> names = {"reference", "cpu"};
    for (const Device& device : devices())
        if (device.unusable.empty() && (device.backend == "opencl" || device.backend == "vulkan") &&
            names.back() != device.backend)
            names.push_back(device.backend);
    return names;
}

// A set, or the reason why there is none, which must be the same on each backend.
struct Answer {
    Result result;
    std::string refusal;
};

// The reference compares each point with the whole lattice.
constexpr std::size_t kMostToRelax = 200;

Answer answer_of(const tests::HostileRequest& made, const std::string& backend) {
    Request request = made.request;
    request.backend = backend;
    try {
        Answer answer{sample(request), ""};
        if (!made.sparse) return answer;
        std::vector<Point>& points = answer.result.points;
        points.resize(std::min(points.size(), kMostToRelax));
        RelaxOptions options;
        options.width = request.width;
        options.height = request.height;
        options.boundary = request.boundary;
        options.iterations = made.iterations;
        options.backend = backend;
        options.threads = request.threads;
        points = relax(points, made.sparse.get(), options).points;
        return answer;
    } catch (const BadRequest& error) {
        return {{}, error.what()};
    }
}

bool are_same(const Answer& a, const Answer& b) {
    if (a.refusal != b.refusal || a.result.rounds != b.result.rounds ||
        a.result.draws != b.result.draws || a.result.maximal != b.result.maximal ||
        a.result.points.size() != b.result.points.size())
        return false;
    for (std::size_t i = 0; i < a.result.points.size(); ++i)
        if (a.result.points[i].x != b.result.points[i].x ||
            a.result.points[i].y != b.result.points[i].y)
            return false;
    return true;
}

std::string told(const Answer& answer) {
    if (!answer.refusal.empty()) return answer.refusal;
    return std::to_string(answer.result.points.size()) + " points, " +
           std::to_string(answer.result.rounds) + " rounds, " +
           std::to_string(answer.result.draws) + " draws";
}

// Whether all backends answer alike.
bool passes(const tests::HostileRequest& made, const std::vector<std::string>& names) {
    const Answer expected = answer_of(made, names.front());
    for (const std::string& name : names) {
        std::string got;
        try {
            const Answer answer = answer_of(made, name);
            if (are_same(expected, answer)) continue;
            got = told(answer);
        } catch (const std::exception& error) {
            got = error.what();
        }
        std::cerr << "hostile: " << name << " answers: " << got << "\n  " << names.front()
                  << " answers: " << told(expected) << "\n";
        return false;
    }
    return true;
}

// Returns the program's exit code.
int run(const tests::HostileOptions& options) {
    const std::vector<std::string> names = backends();
    std::cout << "hostile: seed " << options.seed << ", backends";
    for (const std::string& name : names) std::cout << " " << name;
    std::cout << std::endl;

    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const double seconds = options.seconds.value_or(kSeconds);
    tests::RandomRequests requests(options.seed);
    std::uint64_t number = 0;
    for (; number < options.skip; ++number) requests.next();
    do {
        const tests::HostileRequest made = requests.next();
        if (!passes(made, names)) {
            std::cerr << "  at --seed " << options.seed << " --skip " << number << ": "
                      << tests::describe(made) << std::endl;
            return EXIT_FAILURE;
        }
        ++number;
    } while (std::chrono::duration<double>(Clock::now() - start).count() < seconds);
    std::cout << "hostile: " << number - options.skip << " requests, failures 0" << std::endl;
    return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(tests::read_hostile_options(argc, argv, kOptions));
    } catch (const std::exception& error) {
        std::cerr << "hostile: " << error.what() << std::endl;
        return EXIT_FAILURE;
    }
}
