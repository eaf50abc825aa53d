// What is the answer to a linear program, by definition?  Asked of the simplex method in rationals, one coordinate
// after another.
//
// Laws: those of include/plumb/query/lp/linear_program.hpp, of the point and of is_unique.
#pragma once

#include "arith/rational_lp.hpp"
#include "query/lp/linear_cases.hpp"

namespace plumb::linear_cases {

struct Wanted {
  LinearKind kind = LinearKind::optimal;
  bool is_unique = true;
  arith::RationalVector point;
};

template <std::size_t D>
arith::RationalVector rationals(const std::array<double, D>& v) {
  return arith::RationalVector(v.begin(), v.end());
}

/// row . x = limit.
inline void hold(arith::Constraints& c, arith::RationalVector row, const mpq_class& limit) {
  c.add(row, limit);
  for (mpq_class& x : row) x = -x;
  c.add(std::move(row), -limit);
}

/// The first of the points that meet the constraints, of which there are some.
template <std::size_t D>
Wanted first_point(arith::Constraints c) {
  Wanted w;
  for (std::size_t k = 0; k < D; ++k) {
    arith::RationalVector up(D), down(D);
    up[k] = 1, down[k] = -1;
    const arith::Optimum least = arith::maximize(down, c), most = arith::maximize(up, c);
    const bool has_least = least.kind == arith::Optimum::Kind::optimal;
    const bool has_most = most.kind == arith::Optimum::Kind::optimal;
    w.point.push_back(has_least ? least.at[k] : has_most ? most.at[k] : mpq_class(0));
    w.is_unique = w.is_unique && has_least && has_most && least.at[k] == most.at[k];
    hold(c, up, w.point[k]);
  }
  return w;
}

template <std::size_t D>
Wanted wanted(const Program<D>& p) {
  arith::Constraints c;
  for (const auto& h : p.halfspaces) c.add(rationals<D>(array_of(h.normal)), h.offset);
  const arith::RationalVector direction = rationals<D>(array_of(p.direction));
  if (arith::maximize(arith::RationalVector(D), c).kind != arith::Optimum::Kind::optimal)
    return {LinearKind::infeasible, false, {}};
  const arith::Optimum best = arith::maximize(direction, c);
  if (best.kind != arith::Optimum::Kind::optimal) {
    Wanted w = first_point<D>(c);
    w.kind = LinearKind::unbounded, w.is_unique = false;
    return w;
  }
  hold(c, direction, arith::dot(direction, best.at));
  return first_point<D>(c);
}

}  // namespace plumb::linear_cases
