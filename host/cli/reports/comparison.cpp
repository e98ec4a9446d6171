// Runs every contestant in turn.
#include "cli/reports/comparison.h"

#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "cli/reports/peak_memory.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/observers.h"
#include "files/point_files.h"
#include "options/words.h"

namespace lacuna::cli {
namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

std::optional<Difference> difference_of(const std::vector<Point>& expected,
                                        const std::vector<Point>& got) {
    const auto same = [](Point a, Point b) { return a.x == b.x && a.y == b.y; };
    const auto [a, b] =
        std::mismatch(expected.begin(), expected.end(), got.begin(), got.end(), same);
    if (a == expected.end() && b == got.end()) return std::nullopt;
    Difference difference{static_cast<std::size_t>(a - expected.begin()), {}, {}};
    if (a != expected.end()) difference.expected = *a;
    if (b != got.end()) difference.got = *b;
    return difference;
}

enum class Run { first, timed, last };

class Comparer {
public:
    Comparer(const Request& request, const Sampler& sampler, Observer& observer)
        : request_(request), sampler_(sampler), observer_(observer) {}

    void run(Entry& entry, Run run) {
        try {
            run_once(entry, run);
        } catch (const Unavailable& error) {
            entry.failure = error.what();
        } catch (const DeviceError& error) {
            entry.failure = error.what();
            entry.broke_off = true;
        } catch (const std::bad_alloc&) {
            // Each driver takes another amount of memory, so the other contestants may still run.
            entry.failure = "backend " + entry.contestant.backend + ": out of memory";
            entry.broke_off = true;
        }
    }

    double radius = 0;
    double scale = 0;

private:
    void run_once(Entry& entry, Run run) {
        Request request = request_;
        request.run_on.backend = entry.contestant.backend;
        request.run_on.device = entry.contestant.device;
        const PeakMemory memory;
        Stopwatch stopwatch(run == Run::last);
        Observers observers({observer_, stopwatch});
        const Result result = sampled(request, observers);
        const double seconds = stopwatch.seconds_so_far();
        const auto raised = memory.raised_bytes();
        judge(entry, result);
        if (run == Run::first) {
            entry.device = result.device;
            entry.points = result.points.size();
            entry.rounds = result.rounds;
            entry.sha256 = files::sha256_of(result.points);
            entry.first_run_seconds = seconds;
            entry.memory_bytes = raised;
            entry.work = result.work;
        } else if (run == Run::timed) {
            entry.seconds.push_back(seconds - stopwatch.seconds(Verb::first_use));
        } else {
            for (std::size_t i = 0; i < kVerbs.size(); ++i)
                entry.verb_seconds[i] = stopwatch.seconds(kVerbs[i]);
            entry.take_seconds_of_kernels(result.work);
        }
    }

    Result sampled(const Request& request, Observer& observer) {
        DriverAtWork driver(request.run_on.backend);
        Observers observers({driver, observer});
        return sampler_(request, observers);
    }

    void judge(Entry& entry, const Result& result) {
        if (!has_yardstick_) {
            has_yardstick_ = true;
            yardstick_ = result.points;
            radius = result.radius;
            scale = result.scale;
        }
        if (!entry.difference) entry.difference = difference_of(yardstick_, result.points);
    }

    const Request& request_;
    const Sampler& sampler_;
    Observer& observer_;
    bool has_yardstick_ = false;
    std::vector<Point> yardstick_;
};

// A backend's devices. Without a device there is one entry, with the reason.
std::vector<Contestant> contestants_of(const std::string& backend,
                                       const std::vector<Device>& devices) {
    std::vector<Contestant> found;
    for (const Device& device : devices) {
        if (device.backend != backend) continue;
        found.push_back({backend, std::to_string(found.size()), device.name, device.unusable});
    }
    if (found.empty()) found.push_back({backend, "", "", kNoDriver});
    if (found.size() == 1) found.front().device.clear();  // the request need not name it
    return found;
}

}  // namespace

std::vector<Contestant> find_contestants(const std::vector<std::string>& backends) {
    const std::vector<Device> devices = listed_devices();
    std::vector<Contestant> all;
    for (const std::string& backend :
         backends.empty() ? std::vector<std::string>{"cpu", "opencl", "vulkan"} : backends) {
        if (!options::is_among(backend, options::Words::named_backends))
            throw BadRequest("backends", shown(backend),
                             "each must be " + options::listed(options::Words::named_backends));
        const std::vector<Contestant> its = contestants_of(backend, devices);
        const bool any = std::any_of(its.begin(), its.end(),
                                     [](const Contestant& one) { return one.missing.empty(); });
        if (!any && !backends.empty())
            throw Unavailable("backend " + backend + ": " + its.front().missing);
        all.insert(all.end(), its.begin(), its.end());
    }
    return all;
}

Comparison compare(const Request& request, const std::vector<Contestant>& contestants,
                   std::uint32_t runs, const Sampler& sampler, Observer& observer) {
    Comparison comparison;
    for (const Contestant& contestant : contestants) {
        Entry& entry = comparison.entries.emplace_back();
        entry.contestant = contestant;
        entry.failure = contestant.missing;
    }
    Comparer comparer(request, sampler, observer);
    const auto run_all = [&](Run run) {
        for (Entry& entry : comparison.entries)
            if (entry.failure.empty()) comparer.run(entry, run);
    };
    run_all(Run::first);
    for (std::uint32_t i = 0; i < runs; ++i) run_all(Run::timed);
    run_all(Run::last);
    comparison.radius = comparer.radius;
    comparison.scale = comparer.scale;
    return comparison;
}

double Entry::first_use_seconds() const {
    return std::max(0.0, first_run_seconds - median_seconds());
}

void Entry::take_seconds_of_kernels(const Work& timed) {
    for (KernelWork& kernel : work.kernels)
        for (const KernelWork& same : timed.kernels)
            if (same.name == kernel.name) kernel.seconds = same.seconds;
}

double Entry::median_seconds() const {
    return median(seconds);
}

const Entry* Comparison::yardstick() const {
    const auto first = std::find_if(entries.begin(), entries.end(),
                                    [](const Entry& entry) { return entry.has_run(); });
    return first == entries.end() ? nullptr : &*first;
}

bool Comparison::agree() const {
    return std::none_of(entries.begin(), entries.end(),
                        [](const Entry& entry) { return entry.difference.has_value(); });
}

}  // namespace lacuna::cli
