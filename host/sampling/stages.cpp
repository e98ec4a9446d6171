// Each stage is an ordinary run, whose plan keeps the samples of the stages before.
#include "sampling/stages.h"

#include <algorithm>

#include "plan/make_plan.h"
#include "sampling/generate.h"

namespace lacuna {
namespace {

// Adds what earlier stages have done to what the current one reports.
class Onward : public Observer {
public:
    Onward(Observer& observer, const Result& result, std::uint64_t expected)
        : observer_(observer), result_(result), expected_(expected) {}

    bool keep_going(const Progress& progress) override {
        const std::uint64_t points = result_.points.size() + progress.points;
        return observer_.keep_going(
            {points, std::max(points, expected_), result_.rounds + progress.rounds});
    }
    void begin(Verb verb) override { observer_.begin(verb); }
    void end(Verb verb) override { observer_.end(verb); }
    bool times_verbs() const override { return observer_.times_verbs(); }

private:
    Observer& observer_;
    const Result& result_;
    std::uint64_t expected_;
};

}  // namespace

Stages::Stages(const CheckedRequest& request, Observer& observer, std::uint64_t expected)
    : observer_(observer), expected_(expected), workers_(request->run_on.threads) {
    begin_points(request, 0, result_);
}

void Stages::run(const CheckedRequest& stage, const Poll& poll,
                 const std::vector<std::uint64_t>& class_limits) {
    Plan plan = make_radius_field_plan(stage, poll, samples_);
    plan.first_draw = result_.draws;
    plan.class_limits = class_limits;
    Onward onward(observer_, result_, expected_);
    const Run run = run_on_backend(stage, plan, onward);

    const std::vector<Sample>& samples = run.outcome.samples;
    append_points(plan, samples, workers_, result_);
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    result_.draws += run.outcome.draws;
    result_.work += run.outcome.work;
    result_.rounds += run.outcome.rounds;
    result_.radius = plan.user_radius;
    result_.scale = plan.user_scale;
    result_.lines_per_radius = plan.lines_per_radius;
    result_.maximal = !run.outcome.is_cut;
    result_.backend = run.backend;
    result_.device = run.device;
}

}  // namespace lacuna
