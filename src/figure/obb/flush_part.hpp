// Minimum bounding box: which frames are left of two arcs, and how far off may the doubles be that say so?
//
// Laws: (1) normals that are perpendicular stay in the part when it is narrowed.  (2) Errors are the same sums over
// numbers that carry them, at the largest values there are.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985.
// Cost: some 20 operations.
#pragma once

#include <array>
#include <cmath>

#include "arith/running_error.hpp"
#include "figure/obb/flush_arcs.hpp"

namespace plumb::figure::frame {

// Part of an arc from s[0] to s[1], where it is at `end`: the middle of its normals and how far the others are from
// that, and no less than `width` is the hull's along any of them.
struct SearchedArc {
  FlushArc flush;
  std::array<double, 2> s;
  std::array<Vector3, 2> end;
  Vector3 center{};
  double reach = 0, width = 0;
  std::uint32_t beyond = 0;  // the vertex opposite that says so
};

// Normals n1 from s[0] to s[1] of one arc, n2 from t[0] to t[1] of another: `a` and `b` at these ends, of length one or
// slightly less.
struct SearchedPart {
  std::array<double, 2> s, t;
  std::array<Vector3, 2> a, b;
};

// By how much the doubles of the search can be off: the same sums over numbers that carry their errors.
struct SearchErrors {
  double product, width, third, direction;  // of two normals; of a width along a normal; along a product of two; of
  // given directions

  SearchErrors(double of_vertices, double of_directions) : direction(of_directions) {
    // A normal of an arc, by what it is made of: an arc turns by some 70 degrees, so a chord's is longer than 4/5, and
    // the ends are no farther apart than 5/4.
    const Running end(1, of_directions), share(1, 0), stretch(1.25, 0);
    const Running apart_ends(1.25, (end + end).error);
    const Running unit = (end + share * apart_ends) * stretch;
    const Running normal(1, unit.error);
    const Running apart = Running(1, of_vertices) + Running(1, of_vertices);
    const Running crossed = normal * normal + normal * normal;
    product = upper_error(sum(normal * normal));
    width = upper_error(sum(apart * normal));
    third = upper_error(sum(apart * crossed));
  }

 private:
  static Running sum(const Running& x) { return x + x + x; }
  static double upper_error(const Running& x) { return x.error * (1 + 0x1p-20); }
};

/// A normal of the arc, where its chord is divided by s.
inline Vector3 flush_normal(const FlushArc& arc, double s, double direction_error) {
  const Vector3 chord = plus(arc.from, times(minus(arc.to, arc.from), s));
  // The exact chord, stretched so, is no longer than one.
  return times(chord, (1 - 0x1p-48 - 8 * direction_error) / std::sqrt(dot(chord, chord)));
}

/// How much of the way from one end to the other is certainly beyond zero, of two linear functions on the same side:
/// f at this end and g at the other.
inline double beyond_zero(const std::array<double, 2>& f, const std::array<double, 2>& g, double error) {
  const double side = f[0] < 0 ? -1 : 1;
  double least = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    const double from = side * f[k] - 2 * error, by = side * (f[k] - g[k]);
    if (!(from > 0)) return 0;
    if (by > from && from / by < least) least = from / by;
  }
  return least * (1 - 0x1p-20);
}

/// Leaves out what of an arc, from s[0] to s[1], is not perpendicular to anything between two other normals: along a
/// chord the products with these are linear.
inline void narrow(const FlushArc& arc, const std::array<Vector3, 2>& others, const SearchErrors& error,
                   std::array<double, 2>& s, std::array<Vector3, 2>& end) {
  std::array<std::array<double, 2>, 2> f{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3 chord = plus(arc.from, times(minus(arc.to, arc.from), s[i]));
    f[i] = {dot(chord, others[0]), dot(chord, others[1])};
  }
  const double first = beyond_zero(f[0], f[1], error.product), last = 1 - beyond_zero(f[1], f[0], error.product);
  constexpr double worth = 0x1p-3;
  const double from = s[0], by = s[1] - s[0];
  if (first > worth) s[0] = from + by * first, end[0] = flush_normal(arc, s[0], error.direction);
  if (last < 1 - worth) s[1] = from + by * last, end[1] = flush_normal(arc, s[1], error.direction);
}

}  // namespace plumb::figure::frame
