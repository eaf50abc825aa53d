#include "space/broad_phase/frame_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "space/broad_phase/swept_columns.hpp"

namespace plumb::space {
namespace {

/// Below 0 apart, above 0 overlapping; at 0 the boxes say.
std::int32_t least_overlap(const OrdinalSpan& a, const OrdinalSpan& b) {
  std::int32_t least = beyond_ordinals;
  for (std::size_t k = 0; k < 3; ++k) least = std::min({least, b.high[k] - a.low[k], a.high[k] - b.low[k]});
  return least;
}

std::size_t copies_of(const StripReach& r) { return std::size_t{r.to1 + 1U - r.from1} * (r.to2 + 1U - r.from2); }

bool is_one(const OrdinalSpan& s) { return s.high[0] >= 0; }

/// A guess of when a box is better swept twice than as all that it has passed.
bool is_far(const OrdinalSpan& a, const OrdinalSpan& b) {
  bool far = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t both = std::max(a.high[k], b.high[k]) - std::min(a.low[k], b.low[k]);
    const std::int32_t longer = std::max(a.high[k] - a.low[k], b.high[k] - b.low[k]);
    far |= both - longer > longer / 2;
  }
  return far && is_one(a) && is_one(b);
}

}  // namespace

/// Of a box that has moved.
StripReach FrameSweep::reach_of(const FrameEntry& e) const {
  if (!is_one(e.now) && !is_one(e.before)) return {};
  const auto strip = [&](std::int32_t of, std::size_t k) {
    return static_cast<std::uint16_t>(strip_of(of, strips_[k - 1]));
  };
  return {strip(std::min(e.now.low[1], e.before.low[1]), 1), strip(std::max(e.now.high[1], e.before.high[1]), 1),
          strip(std::min(e.now.low[2], e.before.low[2]), 2), strip(std::max(e.now.high[2], e.before.high[2]), 2)};
}

/// Where the map takes all boxes to be at one number, it is there.
bool FrameSweep::is_as_flat(const Aabb3& box) const {
  const auto x = numbers_of(box);
  bool is_so = true;
  for (std::size_t k = 0; k < 3; ++k) is_so &= !is_flat_[k] || (x[k] == bounds_.min[k] && x[k + 3] == bounds_.max[k]);
  return is_so;
}

/// Where the bounds have space around, is it at none of them?  A guess of whether they still fit.
bool FrameSweep::is_inside(const OrdinalSpan& s) const {
  constexpr std::int32_t last = (1 << ordinal_bits) - 1;
  const std::int32_t low = (s.low[0] - 1) | (s.low[1] - 1) | (s.low[2] - 1);
  const std::int32_t high = (last - 1 - s.high[0]) | (last - 1 - s.high[1]) | (last - 1 - s.high[2]);
  return !has_space_ || (low | high) >= 0;
}

std::uint32_t FrameSweep::place_for(std::uint32_t slot) {
  for (std::size_t s = place_of_.size(); s <= slot; ++s) {
    place_of_.push_back(static_cast<std::uint32_t>(entries_.size()));
    entries_.emplace_back().slot = static_cast<std::uint32_t>(s);
  }
  return place_of_[slot];
}

template <class Change>
void FrameSweep::change(std::uint32_t slot, const Change& change) {
  const std::uint32_t place = place_for(slot);
  FrameEntry& e = entries_[place];
  there_ -= is_one(e.now) ? 1 : 0;
  const bool is_first = e.moved_in != frame_;
  if (is_first) e.before = e.now, e.moved_in = frame_;
  change(e.now);
  there_ += is_one(e.now) ? 1 : 0;
  is_any_again_ |= !is_first;
  if (is_first) leave_if_far(e);
  StripReach reach = reach_of(e);
  if (!is_first && e.reach.from1 <= e.reach.to1) {  // it stays in the columns in which it was put before
    const StripReach r = reach.from1 <= reach.to1 ? reach : e.reach;
    reach = {std::min(e.reach.from1, r.from1), std::max(e.reach.to1, r.to1), std::min(e.reach.from2, r.from2),
             std::max(e.reach.to2, r.to2)};
  }
  put_in_columns(e, place, reach);
}

void FrameSweep::note(std::uint32_t slot, const Aabb3& box) {
  if (!is_kept_) return;
  if (is_any_flat_) is_mapped_ &= is_as_flat(box);
  change(slot, [&](OrdinalSpan& now) {
    map_.put(box, now.low, now.high);
    is_mapped_ &= is_inside(now);
  });
}

void FrameSweep::note_removed(std::uint32_t slot) {
  if (is_kept_) change(slot, [](OrdinalSpan& now) { now = no_span; });
}

/// Where it was is swept for itself, if it has gone far.
void FrameSweep::leave_if_far(FrameEntry& e) {
  std::int32_t moved = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    moved |= std::abs(e.now.low[k] - e.before.low[k]) | std::abs(e.now.high[k] - e.before.high[k]);
  }
  if (moved < surely_near_ || !is_far(e.before, e.now)) return;
  left_.push_back(e);
  left_.back().now = no_span, left_.back().reach = {};
  e.before = no_span;
}

void FrameSweep::plan_anew(const TwoFrames& frames) {
  std::vector<Aabb3> all;
  all.reserve(frames.now.size());
  for (std::uint32_t slot = 0; slot < frames.now.size(); ++slot) {
    if (frames.is_there[slot] != 0) all.push_back(frames.now[slot]);
  }
  const std::size_t n = all.size();
  for (std::uint32_t slot = 0; slot < frames.now.size(); ++slot) {
    const bool is_other = frames.is_there[slot] == 0 || frames.has_moved[slot] != 0;
    if (frames.was_there[slot] != 0 && is_other) all.push_back(frames.was(slot));
  }
  find_bounds(std::span<const Aabb3>(all), bounds_);
  if (n != 0) all.resize(n);
  has_space_ = true, is_any_flat_ = false;
  for (std::size_t k = 0; k < 3; ++k) {  // with some space around, for what moves out; a guess
    is_flat_[k] = bounds_.min[k] == bounds_.max[k];
    const double by = bounds_.max[k] * 0.0625 - bounds_.min[k] * 0.0625;
    const double from = bounds_.min[k] - by, to = bounds_.max[k] + by;
    const bool has = from < bounds_.min[k] && bounds_.max[k] < to && from - from == 0 && to - to == 0;
    if (has) bounds_.min[k] = from, bounds_.max[k] = to;
    has_space_ &= has, is_any_flat_ |= is_flat_[k];
  }
  const BoxSet<Aabb3> set{all};
  if (method_taken(BroadPhaseMethod::automatic, all.size()) == BroadPhaseMethod::swept_columns) {
    auto [map, plan] = place_sweep(set, bounds_);
    map_ = std::move(map), strips_ = plan.columns;
  } else {
    const std::size_t axis = widest_axis(set, bounds_);
    map_ = OrdinalMap(bounds_, {axis, (axis + 1) % 3, (axis + 2) % 3}, {ordinal_bits, ordinal_bits, ordinal_bits});
    strips_ = {1, 1};
  }
  const double part = 0.5 / static_cast<double>(std::max<std::size_t>(n, 1));
  half_mean_ = {};
  for (const Aabb3& b : all) {
    half_mean_ = {half_mean_.x + (b.max.x * part - b.min.x * part), half_mean_.y + (b.max.y * part - b.min.y * part),
                  half_mean_.z + (b.max.z * part - b.min.z * part)};
  }
  double quarter = 1;  // of the mean length along an axis, as part of the bounds
  const std::array<double, 3> halves{half_mean_.x, half_mean_.y, half_mean_.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const double extent = bounds_.max[k] * 0.5 - bounds_.min[k] * 0.5;
    if (!is_flat_[k]) quarter = std::min(quarter, halves[k] / extent * 0.25);
  }
  surely_near_ = static_cast<std::int32_t>(std::ldexp(quarter, ordinal_bits - 1));
  planned_for_ = n, frames_ = 0;
  is_mapped_ = is_kept_ = true;
}

/// In the order of the columns in which they begin; false where there are too many copies.
bool FrameSweep::make_entries(const TwoFrames& f) {
  const std::size_t n = f.now.size(), columns = std::size_t{strips_[0]} * strips_[1];
  left_.clear(), listed_.clear(), incoming_unordered_.clear();
  end_.assign(columns, 0);
  copies_ = there_ = 0;
  std::vector<FrameEntry> made(n);
  std::vector<std::uint32_t> column(n), next(columns + 1);
  for (std::uint32_t slot = 0; slot < n; ++slot) {
    FrameEntry& e = made[slot];
    e.slot = slot;
    if (f.is_there[slot] != 0) map_.put(f.now[slot], e.now.low, e.now.high);
    if (f.was_there[slot] != 0) map_.put(f.was(slot), e.before.low, e.before.high);
    there_ += is_one(e.now) ? 1 : 0;
    const bool is_moved = (f.has_moved[slot] | (f.was_there[slot] ^ f.is_there[slot])) != 0;
    e.moved_in = is_moved ? frame_ : frame_ - 1;
    if (is_moved) leave_if_far(e);
    const StripReach r = reach_of(e);
    column[slot] = r.to1 < r.from1 ? 0 : r.from1 * strips_[1] + r.from2;
    ++next[column[slot] + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  entries_.assign(n, {});
  place_of_.resize(n);
  for (std::uint32_t slot = 0; slot < n; ++slot) {
    place_of_[slot] = next[column[slot]]++;
    entries_[place_of_[slot]] = made[slot];
  }
  for (std::uint32_t place = 0; place < n; ++place) {
    put_in_columns(entries_[place], place, reach_of(entries_[place]));
    if (copies_ > 4 * n + 4096) return false;
  }
  return true;
}

void FrameSweep::put_in_columns(FrameEntry& e, std::uint32_t place, const StripReach& r) {
  const StripReach was = std::exchange(e.reach, r);
  if (r.from1 == was.from1 && r.to1 == was.to1 && r.from2 == was.from2 && r.to2 == was.to2) return;
  copies_ += copies_of(r), copies_ -= copies_of(was);
  for (std::uint32_t s = r.from1; s <= r.to1; ++s) {
    for (std::uint32_t t = r.from2; t <= r.to2; ++t) {
      if (!was.has(s, t)) incoming_unordered_.push_back({s * strips_[1] + t, place});
    }
  }
}

/// For this frame alone, behind all others.
void FrameSweep::put_left() {
  for (FrameEntry& e : left_) {
    const auto place = static_cast<std::uint32_t>(entries_.size());
    put_in_columns(e, place, reach_of(e));
    copies_ -= copies_of(e.reach);
    entries_.push_back(e);
  }
  left_.clear();
}

/// Many more copies than at first, other boxes, or boxes elsewhere; guesses but for the last.
bool FrameSweep::is_stale() const {
  constexpr std::size_t most_frames = 64;
  return !is_kept_ || !is_mapped_ || frames_ >= most_frames || copies_ > copies_planned_ + copies_planned_ / 2 ||
         there_ > planned_for_ + planned_for_ / 4 || there_ + there_ / 4 < planned_for_;
}

/// By columns.
void FrameSweep::order_incoming() {
  end_incoming_.assign(end_.size(), 0);
  for (const InColumn& i : incoming_unordered_) ++end_incoming_[i.column];
  std::uint32_t before = 0;
  for (std::uint32_t& end : end_incoming_) before += std::exchange(end, before);
  incoming_.resize(incoming_unordered_.size());
  for (const InColumn& i : incoming_unordered_) incoming_[end_incoming_[i.column]++] = i;
}

void FrameSweep::sweep_columns(const TwoFrames& frames) {
  struct Settling {
    const TwoFrames& frames;
    FrameSweep& self;
    void operator()(const FrameEntry& a, const FrameEntry& b) const {
      if (a.moved_in != self.frame_ && b.moved_in != self.frame_) return;
      const std::int32_t now = least_overlap(a.now, b.now);
      const std::int32_t before = least_overlap(a.was(self.frame_), b.was(self.frame_));
      const auto meet = [&](const Aabb3& x, const Aabb3& y) { return boxes_meet(x, y, frames.touching); };
      const bool do_meet = now > 0 || (now == 0 && meet(frames.now[a.slot], frames.now[b.slot]));
      const bool did_meet = before > 0 || (before == 0 && meet(frames.was(a.slot), frames.was(b.slot)));
      if (do_meet == did_meet) return;
      (do_meet ? self.added_ : self.lost_).push_back({std::min(a.slot, b.slot), std::max(a.slot, b.slot)});
    }
  } settling{frames, *this};
  const EntryPairTaker taker{&settling, [](void* to, std::uint32_t a, std::uint32_t b) {
                               const auto& s = *static_cast<const Settling*>(to);
                               s(s.self.entries_[a], s.self.entries_[b]);
                             }};
  listed_.swap(listed_before_), end_.swap(end_before_);
  listed_.clear(), end_.clear();
  constexpr std::size_t ahead = 24;
  std::uint32_t from = 0, from_incoming = 0;
  for (std::uint32_t s = 0; s < strips_[0]; ++s) {
    for (std::uint32_t t = 0; t < strips_[1]; ++t) {
      keys_.clear();
      const auto take = [&](std::uint32_t place) {
        FrameEntry& e = entries_[place];
        const OrdinalSpan& was = e.was(frame_);
        const std::int32_t start = std::min(e.now.low[0], was.low[0]);
        if (start == past_ordinals) copies_ -= copies_of(std::exchange(e.reach, {}));  // neither is, nor was
        if (!e.reach.has(s, t)) return;
        const std::uint64_t marks = (s != e.reach.from1 ? 1U : 0U) | (t != e.reach.from2 ? 2U : 0U);
        keys_.push_back(static_cast<std::uint64_t>(start) << 34 | std::uint64_t{place} << 2 | marks);
      };
      const std::size_t column = end_.size();
      for (; from < end_before_[column]; ++from) {
        if (from + ahead < listed_before_.size()) __builtin_prefetch(&entries_[listed_before_[from + ahead]]);
        take(listed_before_[from]);
      }
      for (; from_incoming < end_incoming_[column]; ++from_incoming) take(incoming_[from_incoming].place);
      if (is_any_again_) {  // some may have left the column in this frame, and come again
        std::sort(keys_.begin(), keys_.end());
        keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
      } else {
        order_.sort_nearly_sorted(keys_);
      }
      for (const std::uint64_t key : keys_) {
        const auto place = static_cast<std::uint32_t>(key >> 2);
        if (place < place_of_.size()) listed_.push_back(place);
      }
      end_.push_back(static_cast<std::uint32_t>(listed_.size()));
      if (keys_.size() < 2) continue;
      swept_.assign(entries_, frame_, keys_);
      sweep_frames(swept_, taker);
    }
  }
}

void FrameSweep::find(const TwoFrames& frames) {
  lost_.clear(), added_.clear();
  if (is_stale()) {
    plan_anew(frames);
    while (!make_entries(frames)) {
      for (std::uint32_t& strips : strips_) strips = (strips + 1) / 2;
    }
    copies_planned_ = copies_;
  }
  put_left();
  order_incoming();
  sweep_columns(frames);
  entries_.resize(place_of_.size());  // without what was left
  incoming_unordered_.clear();
  is_any_again_ = false;
  ++frames_, ++frame_;
  sort_pairs(lost_, other_);
  sort_pairs(added_, other_);
  strike_off_common(lost_, added_);
}

}  // namespace plumb::space
