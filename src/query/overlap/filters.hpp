// Signed volumes, floating-point filter: do plain doubles prove how triangles in space lie to one another, and to what
// is straight?
//
// All numbers of a test are volumes, sums of products of three differences.  Their errors have one bound: a constant
// that is derived from the formulas, times the largest differences of each axis (filter B of certify/detail/filter_stage.hpp).
// So the answer is told by the least of the numbers, without a branch on each.
// Laws: an answer is that of real arithmetic; what is near to zero, or not finite, is nothing.
// Source: Moller and Trumbore 1997, Guigue and Devillers 2003, for which products are shared.
// Cost: some 10 to 25 ns.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "plumb/arith/track.hpp"
#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/predicates/cross.hpp"
#include "query/overlap/linear3.hpp"

namespace plumb::query {

using Difference = predicates::Triple<double>;

constexpr Difference difference(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Points a, b, c, d: the volume that the differences from a span.
struct Volume {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    using predicates::difference;
    return predicates::triple(difference(p, 0, 1), difference(p, 0, 2), difference(p, 0, 3));
  }
};
/// As much as is added up of volumes.
struct ThreeVolumes {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto v = Volume{}(p);
    return v - v - v;
  }
};

/// Two numbers, of which one operation of the machine makes two others.
using Pair = double __attribute__((vector_size(16)));
inline Pair size(Pair x) {
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  return std::bit_cast<Pair>(std::bit_cast<Bits>(x) & Bits{~0ull >> 1, ~0ull >> 1});
}
// A NaN in the first is not kept: it ends in the values.
inline Pair larger(Pair x, Pair most) { return x > most ? x : most; }
inline double largest(Pair x) { return x[0] > x[1] ? x[0] : x[1]; }
inline Pair swapped(Pair x) { return Pair{x[1], x[0]}; }

/// Two vectors, coordinate by coordinate.
using PairOfDifferences = predicates::Triple<Pair>;

/// Bounds the errors of F over the largest differences of the axes; NaN where the sum of the values is not finite.
template <Formula F>
double error_bound(Pair x, Pair y, Pair z, double values) {
  const auto most = [](Pair p) { return opaque(largest(p)) + largest_floor<F>; };
  return largest_threshold<F>({most(x), most(y), most(z)}) + (values - values);
}

/// By how much the bound of volumes grows whose differences are taken from another corner: those are differences within
/// two others, of whose size the track says how much it is of both (arith/track.hpp; docs/proof.md, "Filter B").
inline constexpr double from_any_corner = [] {
  constexpr double most =
      2 * static_cast<double>(arith::track::within(0, Track{}).size) / static_cast<double>(Track::one);
  return most * most * most;
}();

/// What is straight from p in direction d; of a segment it ends at p + d.  The pairs are d and p - t.a.
inline std::optional<Relation> by_doubles(LinearKind reach, const PairOfDifferences& dw, const Triangle3& t) {
  using predicates::cross, predicates::dot;
  const auto edges = [](double a, double b, double c) { return Pair{c, b} - Pair{a, a}; };
  const PairOfDifferences fe{edges(t.a.x, t.b.x, t.c.x), edges(t.a.y, t.b.y, t.c.y), edges(t.a.z, t.b.z, t.c.z)};
  const PairOfDifferences normals = cross(dw, fe);  // d x f and w x e
  // The crossing is t.a + (u e + v f) / all, at p + d at / all.
  const Pair uv = dot(PairOfDifferences{swapped(dw.x), swapped(dw.y), swapped(dw.z)}, normals);
  const Pair all_at = dot(PairOfDifferences{swapped(fe.x), swapped(fe.y), swapped(fe.z)}, normals);
  const auto of_axis = [](Pair a, Pair b) { return larger(size(a), size(b)); };
  const Pair both = uv + all_at;
  const double error =
      error_bound<ThreeVolumes>(of_axis(dw.x, fe.x), of_axis(dw.y, fe.y), of_axis(dw.z, fe.z), both[0] + both[1]);
  const double all = all_at[0], at = all_at[1], u = uv[0], v = uv[1];
  const double way = std::copysign(1.0, all);  // no branch: it could not be predicted
  double least = std::min(std::min(u * way, v * way), (all - u - v) * way);
  if (reach != LinearKind::line) least = std::min(least, at * way);
  if (reach == LinearKind::segment) least = std::min(least, (all - at) * way);
  // Where it is positive u, v and what is left of all have one sign, and all has it, so that this is no more to ask.  No
  // branch on which it is: it could not be predicted.
  const int told = beyond(least, error);
  if (told != 0 && magnitude_of(all) > error) [[likely]]
    return static_cast<Relation>(told);
  if (reach == LinearKind::segment) {  // at, and at less all, are the heights of both ends, which may tell alone
    const double to = at - all;
    if (std::min(at, to) > error || std::max(at, to) < -error) return Relation::disjoint;
  }
  return {};
}

inline std::optional<Relation> by_doubles(const Segment3& s, const Triangle3& t) {
  const auto of_axis = [](double p, double q, double a) { return Pair{q, p} - Pair{p, a}; };
  return by_doubles(LinearKind::segment,
                    {of_axis(s.a.x, s.b.x, t.a.x), of_axis(s.a.y, s.b.y, t.a.y), of_axis(s.a.z, s.b.z, t.a.z)}, t);
}

inline std::optional<Relation> by_doubles(LinearKind reach, const Point3& p, const Vector3& d, const Triangle3& t) {
  return by_doubles(reach, {Pair{d.x, p.x - t.a.x}, Pair{d.y, p.y - t.a.y}, Pair{d.z, p.z - t.a.z}}, t);
}
inline std::optional<Relation> by_doubles(const Ray3& r, const Triangle3& t) {
  return by_doubles(LinearKind::ray, r.origin, r.direction, t);
}
inline std::optional<Relation> by_doubles(const Line3& l, const Triangle3& t) {
  return by_doubles(LinearKind::line, l.point, l.direction, t);
}

/// Which corner is alone on its side, by the bits of those below; and the two others in turn.
inline constexpr std::array<unsigned char, 8> corner_alone{0, 0, 1, 2, 2, 1, 0, 0};

/// Touching: in what the shared corners span, and nowhere else.  Overlapping: without a shared corner they cross.
std::optional<Relation> by_doubles(const Triangle3& a, const Triangle3& b);
/// The relation alone: of triangles in one plane as well, who cross, or touch, anywhere.
std::optional<Relation> relation_by_doubles(const Triangle3& a, const Triangle3& b);

}  // namespace plumb::query
