// Exchanges candidates and their statuses across the borders of a strip.
#include "ranks/border.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "backends/columns.h"
#include "portable/status.h"

namespace lacuna {

Border::Border(const Strip& strip, Ranks& ranks, std::uint32_t depth)
    : strip_(strip),
      ranks_(ranks),
      own_(strip.plan.own_x()),
      first_lines_(first_lines(strip.plan, count_columns(strip.plan))),
      bin_begins_(first_lines_),
      rivals_(strip.plan) {
    const Plan& plan = strip.plan;
    const auto columns = static_cast<std::uint32_t>(first_lines_.size() - 1);
    // Rounds of a size that the user chose may be crowded, with long chains of dependence.
    if (plan.round_size != 0) depth = columns;
    low_depth_ = strip.has_low_neighbour() ? std::min(depth, columns) : 0;
    high_depth_ = strip.has_high_neighbour() ? std::min(depth, columns) : 0;
    if (low_depth_ + high_depth_ >= columns) {
        low_depth_ = columns;
        high_depth_ = 0;
    }
    const auto x_of = [&](std::uint32_t column) { return first_lines_[column] * plan.strip_width; };
    if (low_depth_ > 0)
        low_grid_ = std::make_unique<BorderGrid>(
            plan, Span{0, std::min(x_of(low_depth_) + plan.radius, plan.width)});
    if (high_depth_ > 0) {
        const std::uint32_t begin = x_of(columns - high_depth_);
        high_grid_ = std::make_unique<BorderGrid>(
            plan, Span{begin - std::min(begin, plan.radius), plan.width});
    }
}

// ------------------------------------------------------------------------------------- the bins

// The halo's bins: its lines or, in boxes, each line's rows of the sample grid.
std::size_t Border::low_bins() const {
    return std::size_t{strip_.plan.halo().low} * (are_boxes_ ? strip_.plan.grid().rows : 1);
}

std::size_t Border::high_bins() const {
    return std::size_t{strip_.plan.halo().high} * (are_boxes_ ? strip_.plan.grid().rows : 1);
}

std::span<const std::uint32_t> Border::own_lengths(std::span<const std::uint32_t> lengths) const {
    return lengths.subspan(low_bins(), lengths.size() - low_bins() - high_bins());
}

// The draw that produces a guest's position.
Draw Border::draw_of(const Rival& guest) const {
    const Plan& plan = strip_.plan;
    const std::uint32_t line = guest.x / plan.strip_width;
    const std::uint32_t offset = guest.x % plan.strip_width;
    if (!are_boxes_) return {line, guest.y, offset, 0};
    const bool is_low = line < plan.halo().low;
    const std::size_t first = is_low ? 0 : bin_begins_.back() - high_bins();
    const std::uint32_t of_halo = is_low ? line : line - plan.own_lines().end;
    const std::size_t bin =
        first + std::size_t{of_halo} * plan.grid().rows + guest.y / plan.grid().side;
    return {static_cast<std::uint32_t>(bin), guest.y % plan.grid().side, offset, 0};
}

void Border::note(const Round& round, bool are_boxes) {
    if (low_grid_) low_grid_->insert(round.samples);
    if (high_grid_) high_grid_->insert(round.samples);
    for (const Sample sample : round.samples.subspan(guests_))
        tally_.samples +=
            static_cast<std::uint64_t>(is_near_low(sample.x) || is_near_high(sample.x));
    bin_begins_.assign(round.bin_begins.begin(), round.bin_begins.end());
    are_boxes_ = are_boxes;
}

// ------------------------------------------------------------------------------------- the looks

Span Border::unseen() const {
    const auto columns = first_lines_.size() - 1;
    return {first_lines_[low_depth_] * strip_.plan.strip_width,
            first_lines_[columns - high_depth_] * strip_.plan.strip_width};
}

// Locates the draws near_, and adds the candidates that no earlier sample covers to the rivals.
template <typename IsCovered>
void Border::take(TimedBackend<Backend>& backend, const Marginal& marginal, IsCovered is_covered) {
    rivals_.clear();
    near_numbers_.clear();
    for (std::uint32_t i = 0; i < near_.size(); ++i) {
        near_numbers_.push_back(marginal.number_of(near_[i].order));
        near_[i].bin += static_cast<std::uint32_t>(low_bins());
        near_[i].order = i;
    }
    if (near_.empty()) return;
    backend.locate(near_);
    for (const Candidate& candidate : backend.located())
        if (!is_covered(candidate))
            rivals_.add(
                {candidate.x, candidate.y, near_numbers_[candidate.order], true, STATUS_UNDECIDED});
}

void Border::look(TimedBackend<Backend>& backend, const Marginal& marginal,
                  std::span<const Draw> own) {
    const std::size_t columns = first_lines_.size() - 1;
    const auto first_from = [&](std::size_t column) {
        const std::size_t bin = std::max<std::size_t>(bin_begins_[column], low_bins());
        return std::partition_point(own.begin(), own.end(),
                                    [&](const Draw& draw) { return draw.bin + low_bins() < bin; });
    };
    near_.assign(own.begin(), first_from(low_depth_));
    if (high_depth_ > 0) near_.insert(near_.end(), first_from(columns - high_depth_), own.end());
    take(backend, marginal, [&](const Candidate& candidate) {
        const BorderGrid& grid =
            low_grid_ && candidate.x < unseen().begin ? *low_grid_ : *high_grid_;
        return grid.is_covered(candidate.x, candidate.y);
    });
}

void Border::look_at_all(TimedBackend<Backend>& backend, const Marginal& marginal,
                         std::span<const Draw> own) {
    BorderGrid all(strip_.plan, {0, strip_.plan.width});
    std::vector<Sample> samples = backend.snapshot().grid;
    std::erase_if(samples, [](Sample sample) { return sample.x == NO_SAMPLE; });
    all.insert(samples);
    near_.assign(own.begin(), own.end());
    take(backend, marginal,
         [&](const Candidate& candidate) { return all.is_covered(candidate.x, candidate.y); });
    ++tally_.whole_looks;
}

// ---------------------------------------------------------------------------------- the exchanges

Sides Border::exchange(const Sides& sides) {
    messages_ += static_cast<std::uint64_t>(strip_.has_low_neighbour()) +
                 static_cast<std::uint64_t>(strip_.has_high_neighbour());
    return ranks_.exchange(sides);
}

std::vector<std::byte> Border::pack(std::span<const std::uint32_t> candidates, bool is_low) const {
    std::vector<Sent> all;
    for (const std::uint32_t index : candidates) {
        const Rival& rival = rivals_[index];
        all.push_back({is_low ? rival.x - own_.begin : own_.end - rival.x, rival.y, rival.number});
    }
    const auto bytes = std::as_bytes(std::span(all));
    return {bytes.begin(), bytes.end()};
}

// Adds the candidates that came across the low border, or the high one.
void Border::add_received(std::vector<std::uint32_t>& indices, std::span<const std::byte> bytes,
                          bool is_low) {
    std::vector<Sent> all(bytes.size() / sizeof(Sent));
    if (!all.empty()) std::memcpy(all.data(), bytes.data(), all.size() * sizeof(Sent));
    indices.clear();
    for (const Sent& sent : all) {
        const std::uint32_t x = is_low ? own_.begin - sent.distance : own_.end + sent.distance;
        indices.push_back(rivals_.add({x, sent.y, sent.number, false, STATUS_UNDECIDED}));
    }
}

// Finds all rivals. False if candidates that were not located could decide one that was sent.
bool Border::find_rivals(Span unseen) {
    add_received(low_received_, received_.low, true);
    add_received(high_received_, received_.high, false);
    std::vector<std::uint32_t> sent = low_sent_;
    sent.insert(sent.end(), high_sent_.begin(), high_sent_.end());
    return rivals_.find(sent, unseen);
}

void Border::list_sent() {
    const auto list = [&](std::vector<std::uint32_t>& sent, auto is_near) {
        sent.clear();
        for (std::uint32_t i = 0; i < rivals_.size(); ++i)
            if (is_near(rivals_[i].x)) sent.push_back(i);
        std::sort(sent.begin(), sent.end(), [&](std::uint32_t a, std::uint32_t b) {
            return rivals_[a].number < rivals_[b].number;
        });
    };
    list(low_sent_, [&](std::uint32_t x) { return is_near_low(x); });
    list(high_sent_, [&](std::uint32_t x) { return is_near_high(x); });
}

// In each pass both sides send the statuses of all candidates that were sent and are not yet
// decided, in the order in which they were sent. Then both drop the decided ones from their lists.
void Border::exchange_statuses() {
    const auto statuses_of = [&](std::vector<std::uint32_t>& sent) {
        std::vector<std::byte> statuses;
        statuses.reserve(sent.size());
        for (const std::uint32_t index : sent) statuses.push_back(std::byte(rivals_[index].status));
        std::erase_if(sent, [&](std::uint32_t i) { return rivals_[i].status != STATUS_UNDECIDED; });
        return statuses;
    };
    const auto set_statuses = [&](std::vector<std::uint32_t>& received,
                                  std::span<const std::byte> statuses) {
        for (std::size_t i = 0; i < received.size(); ++i)
            rivals_[received[i]].status = std::to_integer<std::uint32_t>(statuses[i]);
        std::erase_if(received,
                      [&](std::uint32_t i) { return rivals_[i].status != STATUS_UNDECIDED; });
    };
    for (std::uint64_t before = ~std::uint64_t{0};;) {
        std::uint64_t left = low_received_.size() + high_received_.size();
        ranks_.sum({&left, 1});
        if (left == 0) return;
        if (left >= before) throw std::logic_error("candidates at a border wait for each other");
        before = left;
        rivals_.decide();
        Sides told;
        told.low = statuses_of(low_sent_);
        told.high = statuses_of(high_sent_);
        const Sides heard = exchange(told);
        set_statuses(low_received_, heard.low);
        set_statuses(high_received_, heard.high);
    }
}

// ------------------------------------------------------------------------------------- the round

std::span<const Draw> Border::draws_with_guests(TimedBackend<Backend>& backend,
                                                const Marginal& marginal,
                                                std::span<const Draw> own) {
    messages_ = 0;
    look(backend, marginal, own);
    list_sent();
    tally_.sent += low_sent_.size() + high_sent_.size();
    received_ = exchange({pack(low_sent_, true), pack(high_sent_, false)});
    if (!find_rivals(unseen())) {
        look_at_all(backend, marginal, own);
        list_sent();
        find_rivals({0, 0});
    }
    const std::vector<std::uint32_t> low = low_received_;
    const std::vector<std::uint32_t> high = high_received_;
    exchange_statuses();
    make_draws(low, high, own);
    tally_.messages += messages_;
    tally_.most_messages = std::max(tally_.most_messages, messages_);
    return draws_;
}

void Border::make_draws(std::span<const std::uint32_t> low, std::span<const std::uint32_t> high,
                        std::span<const Draw> own) {
    draws_.clear();
    guests_ = 0;
    const auto add_guests = [&](std::span<const std::uint32_t> received) {
        const auto first = static_cast<std::ptrdiff_t>(draws_.size());
        for (const std::uint32_t index : received)
            if (rivals_[index].status == STATUS_ADMITTED) draws_.push_back(draw_of(rivals_[index]));
        std::sort(draws_.begin() + first, draws_.end(), [](const Draw& a, const Draw& b) {
            return a.bin != b.bin ? a.bin < b.bin : a.rank < b.rank;
        });
        for (auto guest = draws_.begin() + first; guest != draws_.end(); ++guest)
            guest->order = guests_++;
    };
    add_guests(low);
    const std::size_t first = draws_.size();
    draws_.insert(draws_.end(), own.begin(), own.end());
    add_guests(high);
    for (Draw& draw : std::span(draws_).subspan(first, own.size())) {
        draw.bin += static_cast<std::uint32_t>(low_bins());
        draw.order += guests_;
    }
}

}  // namespace lacuna
