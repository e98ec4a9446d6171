// Makes sets on all cores.
#include "reproduce/sets.h"

#include <tbb/parallel_for.h>

#include <chrono>
#include <cstddef>
#include <limits>
#include <numeric>

#include "base/threads.h"
#include "baseline/dart_throwing.h"
#include "plan/make_plan.h"
#include "plan/plan.h"

namespace lacuna::reproduce {
namespace {

class Watch : public Observer {
public:
    explicit Watch(Work& work) : work_(work) {}
    bool keep_going(const lacuna::Progress&) override { return work_.keep_going(); }

private:
    Work& work_;
};

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Makes one set for each seed. `make(seed)` returns the points of one set.
template <class Make>
Sets make_each(std::uint64_t first_seed, std::uint32_t runs, Work& work, double cost,
               const Make& make) {
    using Clock = std::chrono::steady_clock;
    Sets sets{std::vector<std::vector<Point>>(runs), std::vector<double>(runs)};
    make_sure_of_threads();
    tbb::parallel_for(std::size_t{0}, std::size_t{runs}, [&](std::size_t i) {
        const Clock::time_point begin = Clock::now();
        sets.points[i] = make(first_seed + i);
        sets.seconds[i] = std::chrono::duration<double>(Clock::now() - begin).count();
        work.add(cost);
    });
    return sets;
}

}  // namespace

void Work::add(double done) {
    {
        const std::lock_guard lock(mutex_);
        done_ += done;
    }
    if (!keep_going()) throw Cancelled();
}

bool Work::keep_going() {
    const std::lock_guard lock(mutex_);
    if (!setting_.keep_going(done_ / total_)) cancelled_ = true;
    return !cancelled_;
}

double Sets::mean_count() const {
    double sum = 0;
    for (const auto& set : points) sum += static_cast<double>(set.size());
    return sum / static_cast<double>(points.size());
}

double Sets::mean_seconds() const {
    return mean(seconds);
}

Sets make_sets(const Request& request, std::uint32_t runs, Work& work, double cost) {
    return make_each(request.seed, runs, work, cost, [&](std::uint64_t seed) {
        Request one = request;
        one.seed = seed;
        one.run_on.threads = 1;
        Watch watch(work);
        return sample(one, watch).points;
    });
}

Sets throw_sets(const Request& request, std::uint64_t count, std::uint32_t runs, Work& work,
                double cost) {
    return make_each(request.seed, runs, work, cost, [&](std::uint64_t seed) {
        Request one = request;
        one.seed = seed;
        one.limit = count;
        const Plan plan = make_plan(one);
        constexpr auto kNoEnd = std::numeric_limits<std::uint64_t>::max();
        std::vector<Point> points;
        for (const Sample& sample : baseline::throw_darts(plan, kNoEnd).samples)
            points.push_back(plan.to_user(sample));
        return points;
    });
}

Request lines_request(double radius, Boundary boundary) {
    Request request;
    request.mode = Mode::lines;
    request.radius = radius;
    request.domain.boundary = boundary;
    request.paper2011.snap = true;
    request.run_on.backend = "cpu";
    return request;
}

}  // namespace lacuna::reproduce
