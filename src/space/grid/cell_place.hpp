// In which cell does a coordinate lie, and is it on a wall?  The floor of a quotient, exactly.
//
// Intervals tell most; where one holds a whole number, the exact sign at that number does; what is beyond doubles'
// whole numbers is divided exactly.
// Source: RTCD 7.1.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include "plumb/arith/interval.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/space/grid/grid_walk.hpp"

namespace plumb::space {

struct CellPlace {
  std::int64_t index;  // of the cell above, where it is on a wall
  bool on_wall;
};

/// A whole number of any size: two doubles hold it.
template <class W>
auto whole_number(const W& w, std::int64_t i) {
  const auto most = static_cast<double>(i);
  const std::int64_t rest = i - static_cast<std::int64_t>(most);
  return w.number(most) + w.number(static_cast<double>(rest));
}

/// How far the wall below cell i is from the line's beginning.
template <class W>
auto way_to_wall(const W& w, const WalkAxis& a, std::int64_t i) {
  return whole_number(w, i) * w.number(a.size) + w.difference(a.origin, a.from);
}

/// Statements of a quotient: its numerator and its denominator, over any number type.
struct PlaceOfNumber {
  template <class W>
  auto operator()(const W& w, double x, double origin, double size) const {
    return std::pair{w.difference(x, origin), w.number(size)};
  }
};
/// Where the line is on axis a, when it is at the wall below cell i of axis b.
struct PlaceAtWall {
  template <class W>
  auto operator()(const W& w, const WalkAxis& a, const WalkAxis& b, std::int64_t i) const {
    const auto way = w.difference(b.to, b.base);
    return std::pair{w.difference(a.from, a.origin) * way + w.difference(a.to, a.base) * way_to_wall(w, b, i),
                     w.number(a.size) * way};
  }
};

/// Is the quotient below k, k, or above?
template <class Quotient, class... Input>
Sign side_of_number(const Quotient& quotient, double k, const Input&... input) {
  const auto statement = [&](auto& w, const Input&... in) {
    const auto [numerator, denominator] = quotient(w, in...);
    const Sign side = w.sign(numerator - w.number(k) * denominator);
    return w.sign(denominator) == Sign::negative ? -side : side;
  };
  return certainly<ExactWorlds>(statement, input...);
}

template <class Quotient, class... Input>
[[gnu::noinline]] CellPlace far_place(const Quotient& quotient, const Input&... input) {
  const RationalWorld exact;
  const auto [numerator, denominator] = quotient(exact, input...);
  const Rational q(numerator, denominator), floor = q.floor();
  const auto index = floor.to_int64();
  if (!index || *index > most_cell || *index < -most_cell) {
    return {q.sign() == Sign::negative ? -most_cell - 1 : most_cell + 1, false};
  }
  return {*index, q.is_integer()};
}

template <class Quotient, class... Input>
CellPlace place_of(const Quotient& statement, const Input&... input) {
  constexpr double most = 0x1p52;  // below it doubles hold halves
  const ExactNumbers<Interval, WorldKind::floats> intervals;
  const auto [numerator, denominator] = statement(intervals, input...);
  const Interval q = quotient(numerator, denominator);
  if (!(q.lower > -most && q.upper < most)) return far_place(statement, input...);
  const double k = std::floor(q.upper);
  if (q.lower > k) return {static_cast<std::int64_t>(k), false};
  if (q.lower == q.upper) return {static_cast<std::int64_t>(k), true};
  if (!(q.lower > k - 1)) return far_place(statement, input...);
  const Sign side = side_of_number(statement, k, input...);
  return {static_cast<std::int64_t>(k) - (side == Sign::negative ? 1 : 0), side == Sign::zero};
}

}  // namespace plumb::space
