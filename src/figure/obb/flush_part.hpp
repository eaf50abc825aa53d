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
#include "arith/vec.hpp"
#include "figure/obb/flush_arcs.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb::figure::frame {

// Part of an arc from s[0] to s[1], where it is at `end`: the middle of its normals and how far the others are from
// that, and no less than `width` is the hull's along any of them.
struct SearchedArc {
  FlushArc flush;
  std::size_t number;  // of FlushArcs
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

/// A double that is not above what was rounded to x, and one that is not below; x is finite.
inline double below(double x) { return x - Interval::step(x); }
inline double above(double x) { return x + Interval::step(x); }

inline arith::Vec<Running> known(const Vector3& v, double error) {
  return {Running(v.x, error), Running(v.y, error), Running(v.z, error)};
}

/// A factor that makes a vector no longer than one of which the square of the length is this, off by no more than the
/// error.
inline double shortening(double square, double error) { return below(1 / above(std::sqrt(above(square + error)))); }

// By how much the doubles of the search can be off: the same sums over numbers that carry their errors.
struct SearchErrors {
  double normal, product, width, third, direction, square;  // of a normal; of two of them; of a width along one;
  // along a product of two; of given directions; of the square of a chord's length

  SearchErrors(double of_vertices, double of_directions) : direction(of_directions) {
    // A normal of an arc, by what it is made of: a chord's is stretched to length one, and the ends are not far apart.
    constexpr double longest = 1.25;
    static_assert(longest * longest * (1 + most_turn) / 2 > 1.01 && longest * longest > 1.01 * 2 * (1 - most_turn),
                  "with room for what the cosine is off by");
    const Running end(1, of_directions), share(1, 0), stretch(longest, 0);
    const Running apart_ends(longest, (end + end).error);
    const Running chord = end + share * apart_ends, unit = chord * stretch;
    const Running near_chord(1, chord.error);
    const Running near(1, unit.error);
    const Running apart = Running(1, of_vertices) + Running(1, of_vertices);
    const Running crossed = near * near + near * near;
    normal = unit.bound();
    square = sum(near_chord * near_chord).bound();
    product = sum(near * near).bound();
    width = sum(apart * near).bound();
    third = sum(apart * crossed).bound();
  }

 private:
  static Running sum(const Running& x) { return x + x + x; }
};

/// Where the exact arc's chord is divided by s.
template <class N>
arith::Vec<N> exact_chord(const arith::Vec<N>& from, const arith::Vec<N>& to, double s) {
  return from * (N(1.0) - N(s)) + to * N(s);
}

/// A normal of the arc there; the exact chord, stretched by as much, is no longer than one.
inline Vector3 flush_normal(const FlushArc& arc, double s, const SearchErrors& error) {
  const Vector3 chord = plus(arc.from, times(minus(arc.to, arc.from), s));
  return times(chord, shortening(dot(chord, chord), error.square));
}

/// How much of the way from one end to the other is certainly beyond zero, of two linear functions on the same side:
/// f at this end and g at the other, off by no more than the error.
inline double beyond_zero(const std::array<double, 2>& f, const std::array<double, 2>& g, double error) {
  const double side = f[0] < 0 ? -1 : 1;
  double least = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    // Nearest where both are off by as much toward zero.
    const double from = below(side * f[k] - error), by = above(side * (f[k] - g[k]));
    if (!(from > 0)) return 0;
    if (by > from && from / by < least) least = from / by;
  }
  return below(least);
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
  const double first = beyond_zero(f[0], f[1], error.product), last = beyond_zero(f[1], f[0], error.product);
  constexpr double worth = 0.125;  // a guess of what pays
  const double from = s[0], to = s[1], by = below(to - from);
  if (first > worth) s[0] = below(from + below(by * first)), end[0] = flush_normal(arc, s[0], error);
  if (last > worth) s[1] = above(to - below(by * last)), end[1] = flush_normal(arc, s[1], error);
}

}  // namespace plumb::figure::frame
