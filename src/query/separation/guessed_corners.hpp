// GJK: between which corners of two hulls is the least way?  A guess in doubles, which holds no bound, over whatever tells
// corners: at(i), and least(n), the number of one that is the least along n.
//
// Law: nothing is certain of it; four corners say that the hulls are likely to meet.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// Cost: some 20 to 100 ns a corner, and what it takes to tell the least one.
#pragma once

#include <algorithm>

#include "figure/support/gjk_simplex.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query {

/// From these corners on, of which there is at least one.
template <class Hull>
DifferenceCorners guessed_between(Hull& p, Hull& q, const DifferenceCorners& from, std::uint32_t& rounds) {
  using EndsSimplex = figure::gjk::Simplex<DifferenceCorners::Ends>;
  constexpr int most_rounds = 48;
  constexpr double nearer_by = 1 - 0x1p-40;  // a guess: what is level but for roundings is no corner more
  EndsSimplex simplex({from.ends[0], p.at(from.ends[0][0]) - q.at(from.ends[0][1])});
  for (std::size_t i = 1; i < from.size && !simplex.is_full(); ++i) {
    simplex.add({from.ends[i], p.at(from.ends[i][0]) - q.at(from.ends[i][1])});
  }
  double square = arith::dot(simplex.nearest(), simplex.nearest());
  EndsSimplex last = simplex;
  for (int round = 0; round < most_rounds; ++round) {
    ++rounds;
    if (simplex.is_full()) break;
    const arith::Plain x = simplex.nearest();
    const DifferenceCorners::Ends ends{p.least(x), q.least(x * -1)};
    const arith::Plain w = p.at(ends[0]) - q.at(ends[1]);
    const bool is_new =
        std::ranges::find(simplex.corners(), ends, &EndsSimplex::Corner::ends) == simplex.corners().end();
    if (!is_new || !(arith::dot(x, w) < square * nearer_by)) break;
    last = simplex;
    simplex.add({ends, w});
    if (simplex.is_full()) continue;
    const arith::Plain next = simplex.nearest();
    const double nearer = arith::dot(next, next);
    if (!(nearer < square)) {
      simplex = last;
      break;
    }
    square = nearer;
  }
  DifferenceCorners corners;
  for (const auto& c : simplex.corners()) {
    if (c.weight > 0) corners.add(c.ends);
  }
  if (corners.size == 0) corners.add({0, 0});
  return corners;
}

}  // namespace plumb::query
