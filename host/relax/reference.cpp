// Relaxation written to be read, never to be fast: every lattice point tries every site.
#include "relax/reference.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/polling.h"

namespace lacuna::relaxing::reference {
namespace {

constexpr std::uint64_t kFarther = std::numeric_limits<std::uint64_t>::max();

class Reference : public RelaxBackend {
public:
    Reference(const Lattice& lattice, std::span<const Site> sites)
        : lattice_(lattice),
          numbers_(lattice.numbers),
          sites_(sites.begin(), sites.end()),
          owners_(std::size_t{numbers_.columns} * numbers_.rows, NO_OWNER),
          shares_(sites.size()) {}

    std::string device() const override { return "1 thread"; }

    void assign() override {
        limit_weights();
        for (std::uint32_t row = 0; row < numbers_.rows; ++row)
            for (std::uint32_t column = 0; column < numbers_.columns; ++column)
                if (lattice_.stored_at(column, row) != 0)
                    owners_[index_of(column, row)] = owner_of(column, row);
    }

    void accumulate() override {
        std::fill(shares_.begin(), shares_.end(), Share{});
        for (std::uint32_t row = 0; row < numbers_.rows; ++row)
            for (std::uint32_t column = 0; column < numbers_.columns; ++column) {
                ask_after(1);
                add(column, row);
            }
    }

    void move(std::uint32_t way) override {
        for (std::size_t i = 0; i < sites_.size(); ++i)
            sites_[i] = moved(lattice_, sites_[i], shares_[i], way);
    }

    void rest() override {
        move(WHOLE_WAY);
        for (std::uint32_t i = 0; i < sites_.size(); ++i)
            if (lattice_.stored_below(sites_[i]) == 0) go_to_importance(i);
    }

    std::vector<Site> sites() override { return sites_; }
    std::vector<Share> shares() override { return shares_; }
    std::vector<std::uint32_t> owners() override { return owners_; }
    void restore(std::span<const Site> sites) override {
        sites_.assign(sites.begin(), sites.end());
    }
    void watch(std::function<bool()> may_go_on) override { may_go_on_ = std::move(may_go_on); }

private:
    std::size_t index_of(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{row} * numbers_.columns + column;
    }

    void limit_weights() {
        for (std::size_t i = 0; i < sites_.size(); ++i) {
            ask_after(sites_.size());
            std::uint64_t nearest = portable::reach_of_weight(numbers_.farthest, sites_[i].weight);
            for (std::size_t other = 0; other < sites_.size(); ++other)
                if (other != i) nearest = std::min(nearest, distance(sites_[i], sites_[other]));
            sites_[i].weight =
                portable::bounded_weight(numbers_.farthest, sites_[i].weight, nearest);
        }
    }

    // Squared.
    std::uint64_t distance(const Site& a, const Site& b) const {
        return portable::power_of(a.x, a.y, b.x, b.y, 0, numbers_.period_x, numbers_.period_y);
    }

    std::uint64_t power_of(std::uint32_t column, std::uint32_t row, const Site& site) const {
        return portable::power_of(portable::lattice_place(column, numbers_.step_x),
                                  portable::lattice_place(row, numbers_.step_y), site.x, site.y,
                                  site.weight, numbers_.period_x, numbers_.period_y);
    }

    std::uint32_t owner_of(std::uint32_t column, std::uint32_t row) {
        ask_after(sites_.size());
        std::uint32_t owner = NO_OWNER;
        std::uint64_t least = kFarther;
        for (std::uint32_t i = 0; i < sites_.size(); ++i) {
            const std::uint64_t power = power_of(column, row, sites_[i]);
            if (power >= least) continue;
            least = power;
            owner = i;
        }
        return owner;
    }

    void add(std::uint32_t column, std::uint32_t row) {
        const std::uint32_t owner = owners_[index_of(column, row)];
        if (owner == NO_OWNER) return;
        const Site& site = sites_[owner];
        const std::uint64_t mass = lattice_.mass_at(column, row);
        Share& share = shares_[owner];
        share.points += 1;
        share.mass += mass;
        share.moment_x += mass * portable::moment_offset(column, site.x, numbers_.step_x,
                                                         numbers_.columns, numbers_.period_x);
        share.moment_y += mass * portable::moment_offset(row, site.y, numbers_.step_y,
                                                         numbers_.rows, numbers_.period_y);
    }

    // Moves to the nearest lattice point: of the site's own ones, or of all if it has none.
    void go_to_importance(std::uint32_t i) {
        const Site from{sites_[i].x, sites_[i].y, 0};
        std::uint64_t least = kFarther;
        for (std::uint32_t row = 0; row < numbers_.rows; ++row) {
            for (std::uint32_t column = 0; column < numbers_.columns; ++column) {
                ask_after(1);
                const std::uint32_t owner = owners_[index_of(column, row)];
                if (owner == NO_OWNER || (shares_[i].points != 0 && owner != i)) continue;
                const std::uint64_t distance = power_of(column, row, from);
                if (distance >= least) continue;
                least = distance;
                sites_[i].x = portable::lattice_place(column, numbers_.step_x);
                sites_[i].y = portable::lattice_place(row, numbers_.step_y);
            }
        }
    }

    // `work`: how many sites or lattice points were looked at.
    void ask_after(std::size_t work) {
        if (done_ += work; done_ < kBetweenPolls) return;
        done_ = 0;
        if (may_go_on_ && !may_go_on_()) throw Cancelled();
    }

    const Lattice& lattice_;
    const portable::RelaxLattice& numbers_;
    std::vector<Site> sites_;
    std::vector<std::uint32_t> owners_;
    std::vector<Share> shares_;
    std::function<bool()> may_go_on_;
    std::size_t done_ = kBetweenPolls;  // work since the last question
};

}  // namespace

std::unique_ptr<RelaxBackend> make_backend(const Lattice& lattice, std::span<const Site> sites,
                                           const Placement&, const Poll&) {
    return std::make_unique<Reference>(lattice, sites);
}

}  // namespace lacuna::relaxing::reference
