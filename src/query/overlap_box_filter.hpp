// Do plain doubles prove how an axis-aligned box lies to a triangle, or to what is straight?
//
// Everything is seen from the box's center, doubled so that nothing is halved: p' = 2 p - (min + max), and the box is
// |x'| <= max - min.  Along the cross product of axis k and an edge e, with the triangle's normal n, the gap is
//   |e x p' + n|_k - (|n_k| + reach of the box),
// for the third corner is 2 n_k farther than the edge.  All gaps of a plane have one bound of their errors: a constant
// derived from the formulas, times the largest coordinates of each axis.
// Laws: an answer is that of real arithmetic; what is near to zero, or not finite, is nothing.
// Source: Akenine-Moller 2001; RTCD 5.2.9, 5.3.3.  Cost: some 10 to 30 ns.
#pragma once

#include <cmath>
#include <limits>

#include "overlap_filters.hpp"
#include "overlap_shapes3.hpp"

namespace plumb::query {

/// Points a, b, c, min, max: along the first axis times ab, with absolute values resolved.
struct EdgeGap {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto seen_from = [&](std::size_t i) { return (p[i] + p[i]) - (p[9 + i] + p[12 + i]); };
    const auto across = (p[4] - p[1]) * (p[8] - p[5]) - (p[5] - p[2]) * (p[7] - p[4]);
    const auto y = p[4] - p[1], z = p[5] - p[2];
    return ((y * seen_from(2) - z * seen_from(1)) + across) - (across + (y * (p[14] - p[11]) + z * (p[13] - p[10])));
  }
};
/// Along the normal.
struct NormalGap {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    using predicates::difference;
    const auto seen_from = [&](std::size_t i) { return (p[i] + p[i]) - (p[9 + i] + p[12 + i]); };
    const auto n = predicates::cross(difference(p, 0, 1), difference(p, 1, 2));
    return predicates::dot(n, predicates::Triple{seen_from(0), seen_from(1), seen_from(2)}) -
           predicates::dot(n, difference(p, 3, 4));
  }
};

/// The bounds of the errors, for numbers of up to so much in each axis; NaN where a product might overflow.
struct BoxErrors {
  double yz, zx, xy, xyz;

  BoxErrors(double x, double y, double z, double guard) {
    constexpr double floor = largest_floor<NormalGap>, slack = 1 + 0x1p-40;
    constexpr double plane = largest_threshold<EdgeGap>({1, 1, 1}) * slack;
    constexpr double space = largest_threshold<NormalGap>({1, 1, 1}) * slack;
    const double lx = 2 * x + floor, ly = 2 * y + floor, lz = 2 * z + floor, all = (lx + ly + lz) * 64;
    const double most = all * all * all, doubt = (most - most) + (guard - guard);
    yz = plane * (ly * lz) + doubt;
    zx = plane * (lz * lx) + doubt;
    xy = plane * (lx * ly) + doubt;
    xyz = space * (lx * ly * lz) + doubt;
  }
};

namespace box_filter {

inline double largest(double a, double b) { return a > b ? a : b; }
inline double largest(double a, double b, double c) { return largest(largest(a, b), c); }
inline double least(double a, double b, double c) { return std::min(std::min(a, b), c); }

// The sign is exact: differences of doubles do not round to zero.
inline double axis_gap(double low, double high, double min, double max) { return largest(low - max, min - high); }

/// The relation that gaps tell, each with the bound of its error.
struct Verdict {
  double most = -std::numeric_limits<double>::infinity();  // of gap - error, positive where apart
  double doubt = most;                                     // of gap + error, negative where overlapping

  void add(double gap, double error) {
    most = largest(most, gap - error);
    doubt = largest(doubt, gap + error);
  }
  // A NaN is in every error, if in one, and so in both.
};

}  // namespace box_filter

/// With `skipping`, edges that are parallel to an axis count as none there, as they must; they cost two comparisons.
template <bool skipping>
std::optional<Relation> by_doubles(const Triangle3& t, const Aabb3& box) {
  using box_filter::axis_gap, box_filter::largest, box_filter::least;
  const auto& [a, b, c] = t;
  const auto& [min, max] = box;
  const double apart = largest(axis_gap(least(a.x, b.x, c.x), largest(a.x, b.x, c.x), min.x, max.x),
                               axis_gap(least(a.y, b.y, c.y), largest(a.y, b.y, c.y), min.y, max.y),
                               axis_gap(least(a.z, b.z, c.z), largest(a.z, b.z, c.z), min.z, max.z));
  const double guard = ((a.x + b.x + c.x) + (min.x + max.x)) + ((a.y + b.y + c.y) + (min.y + max.y)) +
                       ((a.z + b.z + c.z) + (min.z + max.z));
  if (apart > 0) {
    if (guard - guard == 0) return Relation::disjoint;
    return {};
  }
  const Difference center{min.x + max.x, min.y + max.y, min.z + max.z}, half = difference(min, max);
  const auto seen_from = [&](const Point3& p) {
    return Difference{(p.x + p.x) - center.x, (p.y + p.y) - center.y, (p.z + p.z) - center.z};
  };
  const std::array corner{seen_from(a), seen_from(b), seen_from(c)};
  const std::array edge{difference(a, b), difference(b, c), difference(c, a)};
  const Difference n = predicates::cross(edge[0], edge[1]);
  const Difference size_n{magnitude_of(n.x), magnitude_of(n.y), magnitude_of(n.z)};
  const auto most_of = [](double p, double q, double r, double low, double high) {
    return largest(largest(magnitude_of(p), magnitude_of(q), magnitude_of(r)), magnitude_of(low), magnitude_of(high));
  };
  const BoxErrors error(most_of(a.x, b.x, c.x, min.x, max.x), most_of(a.y, b.y, c.y, min.y, max.y),
                        most_of(a.z, b.z, c.z, min.z, max.z), guard);
  const auto gap = [](double j, double k, double at_j, double at_k, double n_i, double size_i, double half_j,
                      double half_k) {
    const double reach = magnitude_of(j) * half_k + magnitude_of(k) * half_j;
    const double g = magnitude_of((j * at_k - k * at_j) + n_i) - (size_i + reach);
    if constexpr (skipping) return j == 0 && k == 0 ? -std::numeric_limits<double>::infinity() : g;
    return g;
  };
  const auto most = [](auto gap_of) { return largest(gap_of(0), gap_of(1), gap_of(2)); };
  box_filter::Verdict verdict;
  verdict.add(most([&](std::size_t i) {
                return gap(edge[i].y, edge[i].z, corner[i].y, corner[i].z, n.x, size_n.x, half.y, half.z);
              }),
              error.yz);
  if (verdict.most > 0) return Relation::disjoint;
  verdict.add(most([&](std::size_t i) {
                return gap(edge[i].z, edge[i].x, corner[i].z, corner[i].x, n.y, size_n.y, half.z, half.x);
              }),
              error.zx);
  if (verdict.most > 0) return Relation::disjoint;
  verdict.add(most([&](std::size_t i) {
                return gap(edge[i].x, edge[i].y, corner[i].x, corner[i].y, n.z, size_n.z, half.x, half.y);
              }),
              error.xy);
  verdict.add(magnitude_of(predicates::dot(n, corner[0])) - predicates::dot(size_n, half), error.xyz);
  if (verdict.most > 0) return Relation::disjoint;
  if (verdict.doubt < 0 && apart < 0) return Relation::overlapping;
  return {};
}

/// What is straight: twice its middle, or its origin, seen from the center, and its direction.  `apart` is the gap
/// along the axes of the box: its sign counts.
inline std::optional<Relation> by_doubles(const Difference& p, const Difference& d, const Difference& half,
                                          double apart, const BoxErrors& error) {
  const auto gap = [](double j, double k, double at_j, double at_k, double half_j, double half_k) {
    const double reach = magnitude_of(j) * half_k + magnitude_of(k) * half_j;
    const bool parallel = (j == 0) & (k == 0);
    const double g = magnitude_of(j * at_k - k * at_j) - reach;
    return parallel ? -std::numeric_limits<double>::infinity() : g;
  };
  box_filter::Verdict verdict;
  verdict.add(gap(d.y, d.z, p.y, p.z, half.y, half.z), error.yz);
  verdict.add(gap(d.z, d.x, p.z, p.x, half.z, half.x), error.zx);
  verdict.add(gap(d.x, d.y, p.x, p.y, half.x, half.y), error.xy);
  if (verdict.most > 0) return Relation::disjoint;
  if (verdict.doubt < 0 && apart < 0) return Relation::overlapping;
  return {};
}

inline std::optional<Relation> by_doubles(const Segment3& s, const Aabb3& box) {
  using box_filter::axis_gap, box_filter::largest;
  const auto& [a, b] = s;
  const auto& [min, max] = box;
  const double apart = largest(axis_gap(std::min(a.x, b.x), largest(a.x, b.x), min.x, max.x),
                               axis_gap(std::min(a.y, b.y), largest(a.y, b.y), min.y, max.y),
                               axis_gap(std::min(a.z, b.z), largest(a.z, b.z), min.z, max.z));
  const Difference sum{a.x + b.x, a.y + b.y, a.z + b.z}, center{min.x + max.x, min.y + max.y, min.z + max.z};
  const double guard = ((sum.x + center.x) + (sum.y + center.y)) + (sum.z + center.z);
  if (apart > 0) {
    if (guard - guard == 0) return Relation::disjoint;
    return {};
  }
  const auto most_of = [](double p, double q, double low, double high) {
    return largest(largest(magnitude_of(p), magnitude_of(q)), magnitude_of(low), magnitude_of(high));
  };
  return by_doubles({sum.x - center.x, sum.y - center.y, sum.z - center.z}, difference(a, b), difference(min, max),
                    apart,
                    BoxErrors(most_of(a.x, b.x, min.x, max.x), most_of(a.y, b.y, min.y, max.y),
                              most_of(a.z, b.z, min.z, max.z), guard));
}

/// Of a line the axes of the box ask nothing.
inline std::optional<Relation> by_doubles(Reach reach, const Point3& p, const Vector3& d, const Aabb3& box) {
  using box_filter::largest;
  const auto& [min, max] = box;
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto axis_gap = [](double o, double way, double low, double high) {
    return largest(way >= 0 ? o - high : none, way <= 0 ? low - o : none);
  };
  const double apart = reach == Reach::line
                           ? none
                           : largest(axis_gap(p.x, d.x, min.x, max.x), axis_gap(p.y, d.y, min.y, max.y),
                                     axis_gap(p.z, d.z, min.z, max.z));
  const Difference center{min.x + max.x, min.y + max.y, min.z + max.z};
  const double guard = ((p.x + center.x) + (p.y + center.y)) + (p.z + center.z) + (d.x + d.y + d.z);
  if (d.x == 0 && d.y == 0 && d.z == 0) return {};  // a point, which is soon told
  if (apart > 0) {
    if (guard - guard == 0) return Relation::disjoint;
    return {};
  }
  const auto most_of = [](double o, double way, double low, double high) {
    return largest(largest(magnitude_of(o), magnitude_of(way)), magnitude_of(low), magnitude_of(high));
  };
  return by_doubles({(p.x + p.x) - center.x, (p.y + p.y) - center.y, (p.z + p.z) - center.z}, {d.x, d.y, d.z},
                    difference(min, max), apart,
                    BoxErrors(most_of(p.x, d.x, min.x, max.x), most_of(p.y, d.y, min.y, max.y),
                              most_of(p.z, d.z, min.z, max.z), guard));
}

}  // namespace plumb::query
