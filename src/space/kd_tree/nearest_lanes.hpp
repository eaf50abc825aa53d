// The k points of a k-d tree that are nearest to p, in lanes of doubles.
//
// Laws: (1) exactly the k nearest, by distance and then by number.  (2) What is left out is certainly farther than k
// others, or was compared with them exactly.
// Source: RTCD 7.3.7; Arya and Mount 1993 (incremental distances).
// Cost: a step down for each level, and the cells beyond planes that are nearer than what is found.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_NEAREST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_NEAREST_LANES
#undef PLUMB_NEAREST_LANES
#else
#define PLUMB_NEAREST_LANES
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>

#include "space/kd_tree/point_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::kd::HWY_NAMESPACE {
namespace {

/// Of a value at which products overflow, or are lost: a guess of when to scale, which decides no neighbor.
constexpr double least_moderate = 0x1p-900;
HWY_INLINE bool is_extreme(double value) { return !(value > least_moderate && value < infinity); }

/// The k points that are nearest as yet, the farthest of which says what may be nearer.
template <class Point>
class NearestSoFar {
 public:
  HWY_INLINE NearestSoFar(const Point& p, Candidate<Point>* room, std::size_t k) : p_(p), best_(room), k_(k) {}

  [[nodiscard]] HWY_INLINE double limit() const { return limit_; }
  [[nodiscard]] HWY_INLINE bool is_full() const { return size_ == k_; }
  [[nodiscard]] HWY_INLINE const Candidate<Point>& last() const { return best_[k_ - 1]; }
  HWY_INLINE void clear() { size_ = 0, limit_ = infinity; }

  HWY_INLINE void scan(const Query<Point>& query, LeafRun run) {
    if (run.leaves > 1) {
      Candidate<Point> c = query.one_of(run);
      if (c.value > limit_) return;
      for (const std::uint32_t number : query.numbers_of(run)) {
        c.number = number;
        if (!offer(c)) return;  // nor any behind it
      }
      return;
    }
    query.each_value(run.leaf, [&](const Many& value, std::size_t first, std::size_t i, std::size_t count) HWY_ATTR {
      unsigned may_be = bits_of(at_most(value, of_all(limit_))) & first_lanes(count - i);
      if (may_be == 0) return;
      HWY_ALIGN double values[count_of_lanes];
      hn::Store(value.v, Lanes(), values);
      // Of several the least value comes first, so that as a rule it is the only one.
      if (k_ == 1 && (may_be & (may_be - 1)) != 0) {
        double least = infinity;
        for (unsigned rest = may_be; rest != 0; rest &= rest - 1) least = std::min(least, values[__builtin_ctz(rest)]);
        may_be &= bits_of(at_most(value, of_all(Square<Point>{least}.beyond())));
      }
      for (; may_be != 0; may_be &= may_be - 1) {
        const auto k = static_cast<std::size_t>(__builtin_ctz(may_be));
        if (!(values[k] > limit_)) offer(query.candidate(first, i + k, count, values[k]));
      }
    });
  }

 private:
  /// Is it among them?
  HWY_INLINE bool offer(const Candidate<Point>& c) {
    if (size_ == k_ && !comes_first(p_, c, best_[k_ - 1])) return false;
    std::size_t place = size_ < k_ ? size_++ : k_ - 1;
    for (; place != 0 && comes_first(p_, c, best_[place - 1]); --place) best_[place] = best_[place - 1];
    best_[place] = c;
    if (size_ == k_) limit_ = Square<Point>{best_[k_ - 1].value}.beyond();
    return true;
  }

  const Point& p_;
  Candidate<Point>* best_;
  std::size_t k_, size_ = 0;
  double limit_ = infinity;
};

/// Searches again with differences times another power of two where the values are extreme, as long as that brings
/// another power.
template <class Point>
HWY_INLINE void find_nearest(const KdTree<Point>& tree, const Point& p, std::size_t leaf, NearestSoFar<Point>& found) {
  Powers powers;
  bool raised = false;
  for (bool again = true; again;) {
    again = false;
    const Query<Point> query(tree, p, powers);
    search_from(
        query, leaf, [&]() HWY_ATTR { return again ? -1 : found.limit(); },
        [&](LeafRun at) HWY_ATTR {
          found.scan(query, at);
          if (!found.is_full() || !is_extreme(found.last().value)) [[likely]]
            return;
          if (found.last().at == p) return;
          const Powers other = powers_for(tree, p, half_of_widest(p, found.last().at));
          // Nearer points only raise the power again: what is far may be infinite then, and is beyond them.
          if (other.after == powers.after || (raised && other.after < powers.after)) return;
          raised = raised || other.after > powers.after;
          powers = other, again = true;
        });
    if (again) found.clear();
  }
}

/// Up to eight, put in order by their values as these are met, which no processor foresees: so without branches.  Only
/// in the end those whose values leave doubt are compared exactly, the last of the k with those left out among them.
template <class Point>
class NearestFew {
 public:
  /// Writes the k nearest; false where their values say too little: equal points, extreme ones, many ties.
  static HWY_INLINE bool find(const KdTree<Point>& tree, const Point& p, std::size_t leaf, Candidate<Point>* room,
                              std::size_t k) {
    if (k > most) return false;
    const Query<Point> query(tree, p, {});
    NearestFew found(k);
    search_from(
        query, leaf, [&]() HWY_ATTR { return found.limit_; }, [&](LeafRun at) HWY_ATTR { found.scan(query, at); });
    if (found.is_lost_ || !(found.values_[k] < infinity)) return false;
    found.write(query, room);
    return true;
  }

 private:
  static constexpr std::size_t most = 8, most_doubtful = 24, lanes_at_once = std::min(most, count_of_lanes);

  /// A point as its leaf and its place there.
  using Place = std::uint64_t;

  HWY_INLINE explicit NearestFew(std::size_t k) : k_(k) {
    values_.fill(infinity);
    values_[0] = -infinity;
  }

  HWY_INLINE void scan(const Query<Point>& query, LeafRun run) {
    if (run.leaves > 1) {
      if (!(query.one_of(run).value > limit_)) give_up();
      return;
    }
    query.each_value(run.leaf, [&](const Many& value, std::size_t, std::size_t i, std::size_t count) HWY_ATTR {
      unsigned may_be = bits_of(at_most(value, of_all(limit_))) & first_lanes(count - i);
      if (may_be == 0) return;
      HWY_ALIGN double values[count_of_lanes];
      hn::Store(value.v, Lanes(), values);
      for (; may_be != 0; may_be &= may_be - 1) {
        const auto lane = static_cast<std::size_t>(__builtin_ctz(may_be));
        if (!(values[lane] > limit_)) insert(values[lane], Place{run.leaf} << 32 | (i + lane));
      }
    });
    if (values_[k_] < infinity && is_extreme(values_[k_])) [[unlikely]]
      give_up();
  }

  HWY_INLINE void give_up() { is_lost_ = true, limit_ = -1; }

  HWY_INLINE void insert(double value, Place place) {
    const bool last_stays = !(value < values_[most]);
    const double out = last_stays ? value : values_[most];
    const Place out_place = last_stays ? place : std::bit_cast<Place>(places_[most]);
    const Lanes d;
    const auto new_value = hn::Set(d, value), new_place = hn::Set(d, std::bit_cast<double>(place));
    for (std::size_t j = most + 1 - lanes_at_once; j <= most; j -= lanes_at_once) {
      const auto own = hn::LoadU(d, &values_[j]), own_place = hn::LoadU(d, &places_[j]);
      const auto before = after(values_[j - 1], own), before_place = after(places_[j - 1], own_place);
      const auto is_behind = hn::Lt(new_value, before), is_here = hn::Lt(new_value, own);
      const auto moved = hn::IfThenElse(is_behind, before, new_value);
      const auto moved_place = hn::IfThenElse(is_behind, before_place, new_place);
      hn::StoreU(hn::IfThenElse(is_here, moved, own), d, &values_[j]);
      hn::StoreU(hn::IfThenElse(is_here, moved_place, own_place), d, &places_[j]);
    }
    limit_ = Square<Point>{values_[k_]}.beyond();
    if (!(out > limit_) && out < infinity) [[unlikely]]
      leave_out(out, out_place);
  }

  /// The lanes one further on, after the first.  Loaded from one place before they would wait for what was just stored.
  static HWY_INLINE auto after(double first, hn::Vec<Lanes> lanes) {
    const Lanes d;
    const hn::RebindToSigned<Lanes> i;
    const auto up = hn::IndicesFromVec(d, hn::Max(hn::Iota(i, -1), hn::Zero(i)));
    return hn::IfThenElse(hn::FirstN(d, 1), hn::Set(d, first), hn::TableLookupLanes(lanes, up));
  }

  /// Of those in doubt some no longer are, since the limit falls.
  HWY_NOINLINE void leave_out(double value, Place place) {
    if (doubtful_ == most_doubtful) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < doubtful_; ++i) {
        if (out_values_[i] > limit_) continue;
        out_values_[kept] = out_values_[i], out_places_[kept] = out_places_[i], ++kept;
      }
      doubtful_ = kept;
      if (doubtful_ == most_doubtful) return give_up();
    }
    out_values_[doubtful_] = value, out_places_[doubtful_] = place, ++doubtful_;
  }

  HWY_INLINE Candidate<Point> candidate(const Query<Point>& query, Place place, double value) const {
    const std::size_t leaf = place >> 32, first = query.tree.first(leaf), count = query.tree.first(leaf + 1) - first;
    return query.candidate(first, static_cast<std::uint32_t>(place), count, value);
  }

  HWY_INLINE void write(const Query<Point>& query, Candidate<Point>* room) const {
    std::size_t n = 0;
    const auto put = [&](double value, Place place) HWY_ATTR {
      if (value > limit_) return;
      const Candidate<Point> c = candidate(query, place, value);
      if (n < k_) {
        ++n;
      } else if (!comes_first(query.p, c, room[k_ - 1])) {
        return;
      }
      std::size_t at = n - 1;
      for (; at != 0 && comes_first(query.p, c, room[at - 1]); --at) room[at] = room[at - 1];
      room[at] = c;
    };
    for (std::size_t j = 1; j <= most; ++j) put(values_[j], std::bit_cast<Place>(places_[j]));
    for (std::size_t i = 0; i < doubtful_; ++i) put(out_values_[i], out_places_[i]);
  }

  std::array<double, most + 1> values_;    // ascending, from 1
  std::array<double, most + 1> places_{};  // of their bits
  std::array<double, most_doubtful> out_values_;
  std::array<Place, most_doubtful> out_places_;
  std::size_t k_, doubtful_ = 0;
  double limit_ = infinity;
  bool is_lost_ = false;
};

}  // namespace
}  // namespace plumb::space::kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
