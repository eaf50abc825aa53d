#include "query/contact/quick_numbers.hpp"

#include <algorithm>
#include <limits>

#include "arith/leading_digits.hpp"
#include "certify/fused.hpp"

namespace plumb::query::touching {
namespace {

/// What pairs of doubles tell too little of, by integers of just the width; nothing where these do not hold it.
template <class Of>
std::optional<Ball> by_integers(const Of& of) {
  StackDyadic::clear_range();
  const Ball leading = arith::leading_digits(of());
  if (StackDyadic::left_range() || !(leading.radius < Ball::infinity)) return {};
  return leading;
}

/// Under poses integers are so many times the bodies' own numbers; one without them.  Nothing where the normal is so as well.
std::optional<Ball> weights_of(const Pair& p) {
  if (!p.difference().a.has_scale()) return Ball(1.0);
  if (!p.way().spanned_by()) return {};
  return arith::leading_digits(p.difference().a.scale<StackDyadic>());
}
Ball unweighted(const Ball& x, const Ball& weights) {
  const bool is_one = weights.high == 1 && weights.low == 0 && weights.radius == 0;
  return is_one || certainly_zero(x) ? x : quotient(x, weights);
}

/// Along an axis of space bodies are as far apart as sums of a few numbers, which balls hold.
[[gnu::noinline]] std::optional<Ball> height_along_axis(const Pair& p) {
  if (!p.way().is_along_axis()) return {};
  const Ball height = p.height(p.normal<Ball>());
  return height.radius == 0 ? std::optional(height) : std::nullopt;
}

/// What a ball knows; its error is that many times 2^-106 of its size.
parting::FusedPair pair_of(const Ball& x) {
  using T = parting::FusedPair;
  const double size = magnitude_of(x.high);
  if (size == 0) return x.radius == 0 ? T(0.0) : T(std::numeric_limits<double>::quiet_NaN());
  return T(x.high, x.low, size, x.radius / size * 0x1p106 * (1 + T::slack), 1);
}

PLUMB_WITH_FMA std::optional<Whole> whole_fused(const Pair& p, std::optional<ToldByPairs>& by_pairs, Open& open,
                                                const Ball* height) {
  if (!by_pairs) by_pairs.emplace(p);
  return by_pairs->numbers.whole(height == nullptr ? by_pairs->height : pair_of(*height), open);
}
[[gnu::noinline]] std::optional<Whole> whole_by_balls(const Pair& p, Open& open, const Ball* height) {
  const ToldNumbers<Ball> numbers(p);
  return numbers.whole(height == nullptr ? numbers.height() : *height, open);
}

bool are_all_told(const QuickCorners& corners) {
  return std::ranges::all_of(corners, [](const auto& c) { return c.has_value(); });
}

/// What is told of the corners so far, and what is known of those that are not.
struct CornersSoFar {
  QuickCorners told;
  parting::ShortList<Open, 8> open;
  parting::ShortList<std::optional<Gap<Ball>>, 8> gap;  // by integers

  explicit CornersSoFar(const QuickCorners& so_far) : told(so_far) {
    for (std::size_t i = 0; i < told.size(); ++i) open.push_back(Open::place), gap.push_back({});
  }
  [[nodiscard]] bool lacks_gap(std::size_t i) const { return !told[i] && !gap[i] && open[i] == Open::distance; }
  [[nodiscard]] bool are_told() const { return are_all_told(told); }
};

PLUMB_WITH_FMA void corners_fused(const ToldByPairs& by_pairs, const Pair& p, const Matched& m, const Whole& whole,
                                  CornersSoFar& to) {
  using T = parting::FusedPair;
  const ToldNumbers<T>& numbers = by_pairs.numbers;
  const View<T> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<T> places(a, b, numbers.normal());
  const LevelParts level(m);
  const T none(0.0);
  const bool do_touch = whole.relation == Relation::touching && p.radii().are_none();
  const Vec<T> step = do_touch ? Vec<T>{none, none, none} : numbers.step(by_pairs.height);
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    std::optional<Corner>& told = to.told.begin()[i];
    if (told) continue;
    const Found& f = m.corners[i];
    if (level.has(f)) {
      told = numbers.level_corner(places, f, whole, step);
    } else {
      std::optional<Gap<T>> gap;
      if (const auto& g = to.gap[i]) gap.emplace(Gap<T>{pair_of(g->height), pair_of(g->whole)});
      told = numbers.corner(places, f, to.open.begin()[i], gap);
    }
  }
}

/// Of those whose distance is left open: by integers.  Is one known that was not?
[[gnu::noinline]] bool find_gaps(const Pair& pair, const Matched& m, CornersSoFar& to) {
  bool is_asked = false;
  for (std::size_t i = 0; i < m.corners.size(); ++i) is_asked = is_asked || to.lacks_gap(i);
  if (!is_asked) return false;
  const auto weights = weights_of(pair);
  if (!weights) return false;
  StackDyadic::clear_range();
  const View<StackDyadic> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<StackDyadic> places(a, b, pair.normal<StackDyadic>());
  if (StackDyadic::left_range()) return false;
  bool is_known = false;
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    if (!to.lacks_gap(i)) continue;
    std::optional<Ball> whole;
    const auto height = by_integers([&] {
      const Gap<StackDyadic> gap = places.gap(m.corners[i]);
      whole = arith::leading_digits(gap.whole);
      return gap.height;
    });
    if (!height) return is_known;
    to.gap.begin()[i] = Gap<Ball>{unweighted(*height, *weights), *whole};
    is_known = true;
  }
  return is_known;
}

/// By balls, which know zero, those that are not told yet.
[[gnu::noinline]] void tell_by_balls(const Pair& pair, const Matched& m, CornersSoFar& to) {
  const ToldNumbers<Ball> numbers(pair);
  const View<Ball> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<Ball> places(a, b, numbers.normal());
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    if (to.told[i]) continue;
    to.told.begin()[i] = numbers.corner(places, m.corners[i], to.open.begin()[i], to.gap[i]);
  }
}

}  // namespace

std::optional<Whole> QuickNumbers::whole() const {
  if (!pair_.radii().are_doubles()) return {};
  Open open = Open::distance;
  const bool do_touch = pair_.do_cores_touch();
  std::optional<Ball> height = do_touch ? std::optional(Ball(0.0)) : std::nullopt;
  const auto known = [&] { return height ? &*height : nullptr; };
  const auto by_pairs = [&] { return has_fma ? whole_fused(pair_, by_pairs_, open, known()) : std::nullopt; };
  if (const auto told = by_pairs()) return told;
  if (open == Open::distance && !do_touch) {
    height = height_along_axis(pair_);
    const auto weights = height ? std::nullopt : weights_of(pair_);
    if (weights) height = by_integers([&] { return pair_.height(pair_.normal<StackDyadic>()); });
    if (weights && height) height = unweighted(*height, *weights);
  }
  std::optional<Whole> told = height && !do_touch ? by_pairs() : std::nullopt;
  if (!told) told = whole_by_balls(pair_, open, known());
  if (told) told->is_by_integers = height.has_value();
  return told;
}

QuickCorners QuickNumbers::corners(const Matched& m, const Whole& whole) const {
  QuickCorners at_once;
  for (std::size_t i = 0; i < m.corners.size(); ++i) at_once.push_back({});
  if (!pair_.radii().are_doubles()) return at_once;
  if (by_pairs_) tell_box_corners(pair_, m, whole, by_pairs_->numbers.zeros(), at_once);
  return are_all_told(at_once) ? at_once : remaining_corners(m, whole, at_once);
}

QuickCorners QuickNumbers::remaining_corners(const Matched& m, const Whole& whole, const QuickCorners& so_far) const {
  CornersSoFar corners(so_far);
  if (whole.is_by_integers) {
    const LevelParts level(m);
    for (std::size_t i = 0; i < m.corners.size(); ++i) {
      if (!corners.told[i] && !level.has(m.corners[i])) corners.open.begin()[i] = Open::distance;
    }
    (void)find_gaps(pair_, m, corners);
  }
  const auto tell_by_pairs = [&] {  // where a product's error is one instruction; else balls are no slower
    if (by_pairs_) corners_fused(*by_pairs_, pair_, m, whole, corners);
  };
  tell_by_pairs();
  if (!corners.are_told() && find_gaps(pair_, m, corners)) tell_by_pairs();
  if (!corners.are_told()) tell_by_balls(pair_, m, corners);
  if (!corners.are_told() && find_gaps(pair_, m, corners)) tell_by_balls(pair_, m, corners);
  return corners.told;
}

}  // namespace plumb::query::touching
