#include "space/broad_phase/frame_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "space/broad_phase/asked_span.hpp"
#include "space/broad_phase/swept_columns.hpp"

namespace plumb::space {
namespace {

// Nanoseconds, on a machine that others used as well, of which the ratios count: a box that has moved, where each is held
// against those near it; another that is near it; a key of a column that makes room; a box in a column, where all are swept.
constexpr double of_moved = 500, of_near = 8, of_shifted = 0.3, of_swept = 70;

constexpr unsigned start_shift = 34;  // in keys, above places of 32 bits and two marks
constexpr std::uint64_t key_of(std::int32_t start, std::uint32_t place) {
  return static_cast<std::uint64_t>(start) << start_shift | std::uint64_t{place} << 2;
}
constexpr std::uint32_t place_in(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 2); }

/// Below 0 apart, above 0 overlapping; at 0 the boxes say.
std::int32_t least_overlap(const OrdinalSpan& a, const OrdinalSpan& b) {
  std::int32_t least = beyond_ordinals;
  for (std::size_t k = 0; k < 3; ++k) least = std::min({least, b.high[k] - a.low[k], a.high[k] - b.low[k]});
  return least;
}

BoxPair pair_of(const FrameEntry& a, const FrameEntry& b) {
  return {std::min(a.slot, b.slot), std::max(a.slot, b.slot)};
}

std::size_t copies_of(const StripReach& r) { return std::size_t{r.to1 + 1U - r.from1} * (r.to2 + 1U - r.from2); }

bool is_one(const OrdinalSpan& s) { return s.high[0] >= 0; }

OrdinalSpan around(const OrdinalSpan& a, const OrdinalSpan& b) {
  OrdinalSpan both = a;
  for (std::size_t k = 0; k < 3; ++k) {
    both.low[k] = std::min(a.low[k], b.low[k]), both.high[k] = std::max(a.high[k], b.high[k]);
  }
  return both;
}

/// A guess of when a box is better swept twice than as all that it has passed.
bool is_far(const OrdinalSpan& a, const OrdinalSpan& b) {
  const OrdinalSpan both = around(a, b);
  bool far = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t longer = std::max(a.high[k] - a.low[k], b.high[k] - b.low[k]);
    far |= both.high[k] - both.low[k] - longer > longer / 2;
  }
  return far && is_one(a) && is_one(b);
}

/// work(number of the column, strip, strip) of each.
template <class Work>
void for_each_column(const StripReach& r, const std::array<std::uint32_t, 2>& strips, const Work& work) {
  for (std::uint32_t s = r.from1; s <= r.to1; ++s) {
    for (std::uint32_t t = r.from2; t <= r.to2; ++t) work(std::size_t{s} * strips[1] + t, s, t);
  }
}

}  // namespace

StripReach FrameSweep::reach_of(const OrdinalSpan& span) const {
  if (!is_one(span)) return {};
  const auto strip = [&](std::int32_t of, std::size_t k) {
    return static_cast<std::uint16_t>(strip_of(of, strips_[k - 1]));
  };
  return {strip(span.low[1], 1), strip(span.high[1], 1), strip(span.low[2], 2), strip(span.high[2], 2)};
}

/// Where the map takes all boxes to be at one number, it is there.
bool FrameSweep::is_as_flat(const Aabb3& box) const {
  const auto x = numbers_of(box);
  bool is_so = true;
  for (std::size_t k = 0; k < 3; ++k) is_so &= !is_flat_[k] || (x[k] == bounds_.min[k] && x[k + 3] == bounds_.max[k]);
  return is_so;
}

/// Does it reach beyond the bounds?
bool FrameSweep::is_beyond(const Aabb3& box) const {
  const auto x = numbers_of(box);
  bool is_so = false;
  for (std::size_t k = 0; k < 3; ++k) is_so |= x[k] < bounds_.min[k] || bounds_.max[k] < x[k + 3];
  return is_so;
}

/// Where the bounds have space around, does it reach one of them?
bool FrameSweep::is_outside(const OrdinalSpan& s) const {
  constexpr std::int32_t last = (1 << ordinal_bits) - 1;
  bool outside = false;
  for (std::size_t k = 0; k < 3; ++k) outside |= has_space_[k] && (s.low[k] <= 0 || s.high[k] >= last);
  return outside && is_one(s);
}

bool FrameSweep::is_crowd_outside() const {
  constexpr std::size_t one_of = 16, some = 64;  // guesses
  return outside_ + leaving_ > planned_for_ / one_of + some;
}

/// Much has moved, many more copies than at first, other boxes, or boxes elsewhere; guesses but for the first line.
bool FrameSweep::is_stale() const {
  if (!is_kept_ || !is_mapped_) return true;
  constexpr std::size_t most_frames = 64;
  return moved_since_ > most_frames * (planned_for_ + 1) || far_since_ > planned_for_ + 64 || is_crowd_outside() ||
         copies_ > copies_planned_ + copies_planned_ / 2 || there_ > planned_for_ + planned_for_ / 4 ||
         there_ + there_ / 4 < planned_for_;
}

void FrameSweep::plan_anew(const TwoFrames& frames) {
  std::vector<Aabb3> all;
  all.reserve(frames.now.size());
  for (std::uint32_t slot = 0; slot < frames.now.size(); ++slot) {
    if (frames.is_there[slot] != 0) all.push_back(frames.now[slot]);
  }
  const std::size_t n = all.size();
  for (std::uint32_t slot = 0; slot < frames.now.size(); ++slot) {
    const bool is_other = frames.is_there[slot] == 0 || frames.has_changed[slot] != 0;
    if (frames.was_there[slot] != 0 && is_other) all.push_back(frames.was(slot));
  }
  find_bounds(std::span<const Aabb3>(all), bounds_);
  if (n != 0) all.resize(n);
  if (is_crowd_outside()) space_ = std::min(2 * space_, 0.5);
  std::array<bool, 3> has_space{};
  is_any_flat_ = false;
  for (std::size_t k = 0; k < 3; ++k) {  // with some space around, for what moves out; a guess
    is_flat_[k] = bounds_.min[k] == bounds_.max[k];
    const double by = bounds_.max[k] * space_ - bounds_.min[k] * space_;
    const double from = bounds_.min[k] - by, to = bounds_.max[k] + by;
    has_space[k] = from < bounds_.min[k] && bounds_.max[k] < to && from - from == 0 && to - to == 0;
    if (has_space[k]) bounds_.min[k] = from, bounds_.max[k] = to;
    is_any_flat_ |= is_flat_[k];
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
  std::array<double, 3> eighth{};  // of the mean length along each axis, as part of the bounds
  const double part = 0.125 / static_cast<double>(std::max<std::size_t>(n, 1));
  for (const Aabb3& b : all) {
    const auto x = numbers_of(b);
    for (std::size_t k = 0; k < 3; ++k) eighth[k] += x[k + 3] * part - x[k] * part;
  }
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    has_space_[k] = has_space[map_.order()[k]];
    if (!is_flat_[k]) least = std::min(least, eighth[k] * 0.5 / (bounds_.max[k] * 0.5 - bounds_.min[k] * 0.5));
  }
  surely_near_ = static_cast<std::int32_t>(std::ldexp(least, ordinal_bits - 1)) * 2;
  planned_for_ = n, moved_since_ = far_since_ = 0;
  is_mapped_ = is_kept_ = true;
}

/// In the order of the columns in which they begin, and of their starts; false where there are too many copies.
bool FrameSweep::make_entries(const TwoFrames& f) {
  const std::size_t n = f.now.size();
  columns_.resize(std::size_t{strips_[0]} * strips_[1]);
  for (Column& column : columns_) column.clear();
  left_.clear();
  copies_ = there_ = outside_ = 0;
  std::vector<FrameEntry> made(n);
  std::vector<std::uint32_t> column_of(n), next(columns_.size() + 1);
  std::vector<std::uint64_t> by_start(n);
  for (std::uint32_t slot = 0; slot < n; ++slot) {
    FrameEntry& e = made[slot];
    e.slot = slot;
    if (f.is_there[slot] != 0) map_.put(f.now[slot], e.now.low, e.now.high);
    if (f.was_there[slot] != 0) map_.put(f.was(slot), e.before.low, e.before.high);
    there_ += is_one(e.now) ? 1 : 0, outside_ += is_outside(e.now) ? 1 : 0;
    e.moved_in = f.has_changed[slot] != 0 ? frame_ : frame_ - 1;
    const OrdinalSpan& span = is_one(e.now) ? e.now : e.before;
    const StripReach r = reach_of(span);
    by_start[slot] = static_cast<std::uint64_t>(span.low[0]) << 32 | slot;
    column_of[slot] = r.to1 < r.from1 ? 0 : r.from1 * strips_[1] + r.from2;
    ++next[column_of[slot] + 1];
  }
  for (std::size_t c = 1; c < next.size(); ++c) next[c] += next[c - 1];
  entries_.assign(n, {});
  start_of_.assign(n, 0);
  place_of_.resize(n);
  radix_sort_upper(Execution::serial, by_start);
  for (const std::uint64_t key : by_start) {
    const auto slot = static_cast<std::uint32_t>(key);
    place_of_[slot] = next[column_of[slot]]++;
    entries_[place_of_[slot]] = made[slot];
  }
  for (std::uint32_t place = 0; place < n; ++place) {
    stand_in_both(entries_[place], place);
    if (copies_ > most_copies_of(n)) return false;
  }
  return true;
}

/// The box as it is now, which does not stand there yet.
void FrameSweep::take_over(FrameEntry& e, const TwoFrames& frames) {
  there_ -= is_one(e.now) ? 1 : 0, outside_ -= is_outside(e.now) ? 1 : 0;
  e.before = e.now, e.moved_in = frame_;
  if (frames.is_there[e.slot] != 0) {
    map_.put(frames.now[e.slot], e.now.low, e.now.high);
  } else {
    e.now = no_span;
  }
  there_ += is_one(e.now) ? 1 : 0, outside_ += is_outside(e.now) ? 1 : 0;
}

void FrameSweep::put_in_columns(FrameEntry& e, std::uint32_t place, const StripReach& r) {
  const StripReach was = std::exchange(e.reach, r);
  if (r == was) return;
  copies_ += copies_of(r), copies_ -= copies_of(was);
  for_each_column(r, strips_, [&](std::size_t c, std::uint32_t s, std::uint32_t t) {
    if (!was.has(s, t)) columns_[c].push_back(key_of(0, place));
  });
}

/// To be swept.  Where it was is swept for itself, if it has gone far.
void FrameSweep::stand_in_both(FrameEntry& e, std::uint32_t place) {
  if (e.moved_in == frame_) {
    std::int32_t moved = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      moved |= std::abs(e.now.low[k] - e.before.low[k]) | std::abs(e.now.high[k] - e.before.high[k]);
    }
    if (moved >= surely_near_ && is_far(e.before, e.now)) {
      left_.push_back(e);
      left_.back().now = no_span, left_.back().reach = {};
      e.before = no_span;
      ++far_since_;
    }
  }
  put_in_columns(e, place, reach_of(around(e.now, e.was(frame_))));
}

/// For this frame alone, behind all others.
void FrameSweep::put_left() {
  for (const FrameEntry& e : left_) {
    const auto place = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back(e), start_of_.push_back(0);
    put_in_columns(entries_.back(), place, reach_of(e.before));
    copies_ -= copies_of(entries_.back().reach);
  }
  left_.clear();
}

/// Where columns are in order, and stay so; how many keys made room.  A key may start some way before its box.
std::size_t FrameSweep::stand_as_now(FrameEntry& e, std::uint32_t place) {
  const StripReach to = reach_of(e.now), was = std::exchange(e.reach, to);
  const std::int32_t low = e.now.low[0], start_was = start_of_[place];
  const bool is_there = start_was <= low && low - start_was <= surely_near_;
  const std::int32_t start = is_there ? start_was : std::max(low - surely_near_ / 2, 0);
  const auto at = [&](Column& column, std::int32_t from) {
    return std::lower_bound(column.begin(), column.end(), key_of(from, place));
  };
  copies_ += copies_of(to), copies_ -= copies_of(was);
  std::ptrdiff_t shifted = 0;
  for_each_column(was, strips_, [&](std::size_t c, std::uint32_t s, std::uint32_t t) {
    if (to.has(s, t)) return;
    Column& column = columns_[c];
    const auto next = column.erase(at(column, start_was));
    shifted += column.end() - next;
  });
  for_each_column(to, strips_, [&](std::size_t c, std::uint32_t s, std::uint32_t t) {
    Column& column = columns_[c];
    longest_[c] = std::max(longest_[c], e.now.high[0] - start);
    if (!was.has(s, t)) {
      const auto own = column.insert(at(column, start), key_of(start, place));
      shifted += column.end() - own;
    } else if (start != start_was) {  // only those between make room
      const auto from = at(column, start_was), till = at(column, start);
      shifted += std::abs(till - from);
      const bool is_later = from < till;
      const auto stands = is_later ? std::move(from + 1, till, from) : std::move_backward(till, from, from + 1) - 1;
      *stands = key_of(start, place);
    }
  });
  start_of_[place] = start;
  return static_cast<std::size_t>(shifted);
}

/// work(entry) of each other that is not apart from it; how many it was compared with.
template <class Work>
std::size_t FrameSweep::for_each_near(const OrdinalSpan& span, std::uint32_t place, const Work& work) const {
  const StripReach own = entries_[place].reach;
  const AskedSpan asked(span);
  constexpr std::ptrdiff_t ahead = 8;
  std::size_t compared = 0;
  for_each_column(own, strips_, [&](std::size_t c, std::uint32_t s, std::uint32_t t) {
    const Column& column = columns_[c];
    const std::uint64_t from = key_of(std::max(span.low[0] - longest_[c], 0), 0);
    const auto first = std::lower_bound(column.begin(), column.end(), from);
    auto at = first;
    for (; at != column.end() && static_cast<std::int32_t>(*at >> start_shift) <= span.high[0]; ++at) {
      if (column.end() - at > ahead) __builtin_prefetch(&entries_[place_in(at[ahead])]);
      const FrameEntry& other = entries_[place_in(*at)];
      if (asked.is_apart(other)) continue;
      const bool has_begun =
          ((s != own.from1) & (s != other.reach.from1)) | ((t != own.from2) & (t != other.reach.from2));
      if (!has_begun && place_in(*at) != place) work(other);
    }
    compared += static_cast<std::size_t>(at - first);
  });
  return compared;
}

/// What differs by this one alone, the others being as they are, or were if their turn is still to come; in how many ns.
double FrameSweep::settle(FrameEntry& e, std::uint32_t place, const TwoFrames& frames) {
  take_over(e, frames);
  const AskedSpan now(e.now), before(e.before);
  const auto meets = [&](const AskedSpan& own, const FrameEntry& other, const Aabb3& own_box) {
    const int overlap = own.overlap(other);
    if (overlap != 0) return overlap > 0;
    const bool is_to_come = frames.has_changed[other.slot] != 0 && other.moved_in != frame_;
    return boxes_meet(own_box, (is_to_come ? frames.before : frames.now)[other.slot], frames.touching);
  };
  const auto tell = [&](const FrameEntry& other, bool lost, bool added) {
    const bool do_meet = meets(now, other, frames.now[e.slot]), did_meet = meets(before, other, frames.before[e.slot]);
    if (lost && did_meet && !do_meet) lost_.push_back(pair_of(e, other));
    if (added && do_meet && !did_meet) added_.push_back(pair_of(e, other));
  };
  const bool has_gone = is_far(e.before, e.now) || is_one(e.before) != is_one(e.now);
  far_since_ += has_gone ? 1 : 0;
  std::size_t compared = 0, shifted = 0;
  if (!has_gone && reach_of(e.now) == e.reach) {
    compared = for_each_near(around(e.before, e.now), place, [&](const FrameEntry& o) { tell(o, true, true); });
    shifted = stand_as_now(e, place);
  } else {
    if (is_one(e.before)) {
      compared = for_each_near(e.before, place, [&](const FrameEntry& o) { tell(o, true, false); });
    }
    shifted = stand_as_now(e, place);
    if (is_one(e.now)) {
      compared += for_each_near(e.now, place, [&](const FrameEntry& o) { tell(o, false, true); });
    }
  }
  return of_moved + of_near * static_cast<double>(compared) + of_shifted * static_cast<double>(shifted);
}

/// One after the other, as they lie in memory; how many, where the rest would take longer than all together.
std::size_t FrameSweep::settle_each(const TwoFrames& frames, double most) {
  constexpr std::size_t ahead = 8;
  const std::size_t n = places_.size();
  double spent = 0;
  std::size_t settled = 0;
  for (; settled < n && spent <= most; ++settled) {
    if (settled + ahead < n) {
      const FrameEntry& next = entries_[places_[settled + ahead]];
      __builtin_prefetch(&frames.now[next.slot]), __builtin_prefetch(&frames.before[next.slot]);
    }
    if (settled + 2 * ahead < n) __builtin_prefetch(&entries_[places_[settled + 2 * ahead]]);
    const std::uint32_t place = places_[settled];
    spent += settle(entries_[place], place, frames);
  }
  return settled;
}

void FrameSweep::sweep_columns(const TwoFrames& frames) {
  struct Settling {
    const TwoFrames& frames;
    FrameSweep& self;
    void operator()(const FrameEntry& a, const FrameEntry& b) const {
      if (a.moved_in != self.frame_ && b.moved_in != self.frame_) return;
      const std::int32_t now = least_overlap(a.now, b.now);
      const std::int32_t before = least_overlap(a.was(self.frame_), b.was(self.frame_));
      const auto box_was = [&](const FrameEntry& e) -> const Aabb3& {
        return (e.moved_in == self.frame_ ? frames.before : frames.now)[e.slot];
      };
      const auto meet = [&](const Aabb3& x, const Aabb3& y) { return boxes_meet(x, y, frames.touching); };
      const bool do_meet = now > 0 || (now == 0 && meet(frames.now[a.slot], frames.now[b.slot]));
      const bool did_meet = before > 0 || (before == 0 && meet(box_was(a), box_was(b)));
      if (do_meet != did_meet) (do_meet ? self.added_ : self.lost_).push_back(pair_of(a, b));
    }
  } settling{frames, *this};
  const EntryPairTaker taker{&settling, [](void* to, std::uint32_t a, std::uint32_t b) {
                               const auto& s = *static_cast<const Settling*>(to);
                               s(s.self.entries_[a], s.self.entries_[b]);
                             }};
  constexpr std::size_t ahead = 24;
  const bool has_left = entries_.size() > place_of_.size();
  double near = 0;
  longest_.assign(columns_.size(), 0);
  for_each_column(
      {0, static_cast<std::uint16_t>(strips_[0] - 1), 0, static_cast<std::uint16_t>(strips_[1] - 1)}, strips_,
      [&](std::size_t c, std::uint32_t s, std::uint32_t t) {
        Column& column = columns_[c];
        if (c + 1 < columns_.size()) {
          const Column& next = columns_[c + 1];
          for (std::size_t i = 0; i < std::min(ahead, next.size()); ++i)
            __builtin_prefetch(&entries_[place_in(next[i])]);
        }
        keys_.clear();
        std::int32_t longest = 0;
        for (std::size_t i = 0; i < column.size(); ++i) {
          if (i + ahead < column.size()) __builtin_prefetch(&entries_[place_in(column[i + ahead])]);
          const std::uint32_t place = place_in(column[i]);
          FrameEntry& e = entries_[place];
          const OrdinalSpan& was = e.was(frame_);
          const std::int32_t start = std::min(e.now.low[0], was.low[0]);
          if (start == past_ordinals) copies_ -= copies_of(std::exchange(e.reach, {}));  // neither is, nor was
          if (!e.reach.has(s, t)) continue;
          start_of_[place] = start;
          longest = std::max(longest, std::max(e.now.high[0], was.high[0]) - start);
          keys_.push_back(key_of(start, place) | (s != e.reach.from1 ? 1U : 0U) | (t != e.reach.from2 ? 2U : 0U));
        }
        order_.sort_nearly_sorted(keys_);
        column.swap(keys_);
        longest_[c] = longest;
        if (column.size() < 2) return;
        swept_.assign(entries_, frame_, column);
        sweep_frames(swept_, taker);
        const double length = static_cast<double>((column.back() >> start_shift) - (column[0] >> start_shift));
        const auto n = static_cast<double>(column.size());
        near += n * n * std::min(1.0, 2.0 * longest / (length + 1));
      });
  near_each_ = 2 * near / static_cast<double>(std::max<std::size_t>(there_, 1));
  if (has_left) {
    for (Column& column : columns_)
      std::erase_if(column, [&](std::uint64_t key) { return place_in(key) >= place_of_.size(); });
    entries_.resize(place_of_.size()), start_of_.resize(place_of_.size());
  }
}

FrameWork FrameSweep::find(const TwoFrames& frames) {
  lost_.clear(), added_.clear();
  leaving_ = 0;
  FrameWork work;
  const auto changed = static_cast<double>(frames.changed.size());
  work.cost_of_each = changed * (of_moved + of_near * near_each_);
  work.cost_of_all = of_swept * static_cast<double>(std::max(copies_, frames.now.size()));
  if (frames.changed.empty()) return work;
  const bool is_each = work.cost_of_each < work.cost_of_all;
  constexpr std::size_t ahead = 16;
  if (is_kept_) {
    for (auto slot = static_cast<std::uint32_t>(place_of_.size()); slot < frames.now.size(); ++slot) {
      place_of_.push_back(static_cast<std::uint32_t>(entries_.size()));
      entries_.emplace_back().slot = slot, start_of_.push_back(0);
    }
    moved_since_ += frames.changed.size();
    if (is_any_flat_ || is_each) {
      for (const std::uint32_t slot : frames.changed) {
        is_mapped_ &= is_as_flat(frames.now[slot]), leaving_ += is_beyond(frames.now[slot]) ? 1 : 0;
      }
    }
    if (!is_each) {
      for (std::uint32_t place = 0; place < entries_.size(); ++place) {
        if (place + ahead < entries_.size()) __builtin_prefetch(&frames.now[entries_[place + ahead].slot]);
        FrameEntry& e = entries_[place];
        if (frames.has_changed[e.slot] != 0) take_over(e, frames), stand_in_both(e, place);
      }
    }
  }
  if (is_stale()) {
    plan_anew(frames);
    while (!make_entries(frames)) {
      for (std::uint32_t& strips : strips_) strips = (strips + 1) / 2;
    }
    copies_planned_ = copies_;
    work.planned_anew = work.all_swept = true;
  } else if (!is_each) {
    work.all_swept = true;
  } else {
    places_.clear();
    for (const std::uint32_t slot : frames.changed) places_.push_back(place_of_[slot]);
    std::sort(places_.begin(), places_.end());
    const std::size_t settled = settle_each(frames, work.cost_of_all);
    if (settled < places_.size()) {
      ++frame_;  // in which those that are settled have not moved
      for (std::size_t i = settled; i < places_.size(); ++i) {
        take_over(entries_[places_[i]], frames), stand_in_both(entries_[places_[i]], places_[i]);
      }
      work.all_swept = true;
    }
  }
  if (work.all_swept) put_left(), sweep_columns(frames);
  ++frame_;
  sort_pairs(lost_, other_);
  sort_pairs(added_, other_);
  strike_off_common(lost_, added_);
  return work;
}

}  // namespace plumb::space
