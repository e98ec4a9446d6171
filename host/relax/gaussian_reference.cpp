// The descent of the Gaussian energy written to be read, never to be fast: every sample tries every
// other one, and all of its images.
#include "relax/gaussian_reference.h"

#include <cstddef>
#include <cstdlib>
#include <utility>

namespace lacuna::relaxing::reference {
namespace {

class GaussianReference : public GaussianBackend {
public:
    GaussianReference(const GaussianField& field, std::span<const Spot> spots)
        : field_(field),
          domain_(field.domain),
          spots_(spots.begin(), spots.end()),
          momenta_(spots.size(), {0, 0}) {}

    std::string device() const override { return "1 thread"; }
    std::vector<Spot> spots() override { return spots_; }
    void watch(std::function<bool()> may_go_on) override { may_go_on_ = std::move(may_go_on); }

    void descend(std::uint32_t pace) override {
        std::vector<Force> forces;
        forces.reserve(spots_.size());
        for (const Spot& spot : spots_) forces.push_back(force_on(spot));
        for (std::size_t i = 0; i < spots_.size(); ++i) move(i, forces[i], pace);
    }

private:
    struct Momentum {
        std::int32_t x;
        std::int32_t y;
    };

    Force force_on(const Spot& spot) {
        if (may_go_on_ && !may_go_on_()) throw Cancelled();
        Force force = force_of_edges(field_, spot);
        const std::int64_t around_x = images_along(domain_.width);
        const std::int64_t around_y = images_along(domain_.height);
        for (const Spot& other : spots_)
            for (std::int64_t i = -around_x; i <= around_x; ++i)
                for (std::int64_t j = -around_y; j <= around_y; ++j)
                    add(std::int64_t{spot.x} - other.x + i * domain_.width,
                        std::int64_t{spot.y} - other.y + j * domain_.height, force);
        return force;
    }

    // Images of a sample to either side that may be in reach of another one.
    std::int64_t images_along(std::uint32_t length) const {
        if (domain_.wraps == 0) return 0;
        return (std::int64_t{GAUSSIAN_REACH} << domain_.bits) / length + 1;
    }

    void add(std::int64_t dx, std::int64_t dy, Force& force) const {
        const std::int64_t reach = std::int64_t{GAUSSIAN_REACH} << domain_.bits;
        if (std::abs(dx) >= reach || std::abs(dy) >= reach) return;
        const auto squared = static_cast<std::uint64_t>(dx * dx + dy * dy);
        const std::uint32_t entry = portable::gaussian_entry(squared, domain_.bits);
        const std::int64_t weight =
            portable::gaussian_weight(field_.weights[entry], field_.weights[entry + 1],
                                      portable::gaussian_rest(squared, domain_.bits));
        force.x += weight * dx;
        force.y += weight * dy;
    }

    void move(std::size_t i, const Force& force, std::uint32_t pace) {
        Spot& spot = spots_[i];
        Momentum& momentum = momenta_[i];
        momentum.x = portable::gaussian_momentum(momentum.x, force.x, domain_.bits);
        momentum.y = portable::gaussian_momentum(momentum.y, force.y, domain_.bits);
        spot.x = portable::gaussian_place(spot.x, momentum.x, pace, domain_.width, domain_.wraps,
                                          domain_.bits);
        spot.y = portable::gaussian_place(spot.y, momentum.y, pace, domain_.height, domain_.wraps,
                                          domain_.bits);
    }

    const GaussianField& field_;
    const portable::GaussianDomain& domain_;
    std::vector<Spot> spots_;
    std::vector<Momentum> momenta_;
    std::function<bool()> may_go_on_;
};

}  // namespace

std::unique_ptr<GaussianBackend> make_gaussian_backend(const GaussianField& field,
                                                       std::span<const Spot> spots,
                                                       const Placement&, const Poll&) {
    return std::make_unique<GaussianReference>(field, spots);
}

}  // namespace lacuna::relaxing::reference
