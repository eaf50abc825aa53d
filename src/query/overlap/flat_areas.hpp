// Signed areas: how do two triangles of one plane lie, or a segment and a triangle?  By the areas that edges span with
// corners.
//
// All corners are seen from one of them, so that ten products of vectors make all twenty areas of two triangles, and
// six the ten of a segment and a triangle.  The numbers are any of which a sign can be told: doubles with one bound of
// the error for all, signs, or what wrapped_number.hpp settles.
// Laws: a pair is as far into one another as the least deep of the axes that can separate it, the normals of all edges:
// along one the most that a corner of the other reaches to the inner side.  Exact where the signs are; triangles
// without area are none of these.
// Source: RTCD 5.2.1, 5.2.10.
// Cost: some 100 operations, without a branch: where in a plane is hard to predict.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "plumb/certify/detail/filter_stage.hpp"
#include "query/overlap/signs.hpp"

namespace plumb::query {

/// From the corner that all are seen from.
template <class N>
struct Seen2 {
  N x, y;
};
template <class N>
constexpr auto area(const Seen2<N>& p, const Seen2<N>& q) {
  return p.x * q.y - p.y * q.x;
}

/// Points o, p, q, r: the area of p, q, r as it is added up here.
struct AreaFromCorner {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& c) const {
    const auto from_corner = [&](std::size_t i) {
      return Seen2<decltype(c[0] - c[0])>{c[2 * i] - c[0], c[2 * i + 1] - c[1]};
    };
    const auto p = from_corner(1), q = from_corner(2), r = from_corner(3);
    return (area(p, q) + area(q, r)) - area(p, r);
  }
};

/// What an area must exceed for its sign to be certain, for differences from the corner up to these.
constexpr double area_error(double x, double y) { return largest_threshold<AreaFromCorner>({x, y}); }

/// The same of differences as doubles have them; not a number, or infinite, where an area might overflow or a
/// difference is not finite.  Their sum serves for the largest: it is no less, as rounding is monotone, and keeps what
/// is no number.  The magnitude is no less than any number on the way to an area.
template <class... Differences>
double area_error_of(const Seen2<Differences>&... p) {
  constexpr double floor = largest_floor<AreaFromCorner>;
  const double x = (floor + ... + magnitude_of(p.x)), y = (floor + ... + magnitude_of(p.y));
  const double most = magnitude_over<AreaFromCorner>({x, y});
  return area_error(x, y) + (most - most);
}
constexpr Seen2<double> from_to(const Point2& from, const Point2& to) { return {to.x - from.x, to.y - from.y}; }

template <class N>
using Three = std::array<N, 3>;

/// Of the triangles a and b: their own areas, and those of each edge (from corner e to the next) with the corners of
/// the other.
template <class N>
struct TriangleAreas {
  N of_a, of_b;
  std::array<Three<N>, 3> over_a, over_b;
};
/// By area(i, j, k) of three corners each: those of the first triangle are 0, 1, 2, of the second 3, 4, 5.
template <class Area>
TriangleAreas<double> areas_by(const Area& area) {
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) { return static_cast<double>(area(i, j, k)); };
  const auto edge = [&](std::size_t i, std::size_t j, std::size_t from) {
    return Three<double>{at(i, j, from), at(i, j, from + 1), at(i, j, from + 2)};
  };
  return {at(0, 1, 2),
          at(3, 4, 5),
          {edge(0, 1, 3), edge(1, 2, 3), edge(2, 0, 3)},
          {edge(3, 4, 0), edge(4, 5, 0), edge(5, 3, 0)}};
}

/// From the first corner of a: its others, and those of b.
template <class N>
constexpr auto triangle_areas(const Seen2<N>& p, const Seen2<N>& q, const Three<Seen2<N>>& b) {
  using Area = decltype(area(p, q));
  const Three<Area> u{area(p, b[0]), area(p, b[1]), area(p, b[2])}, v{area(q, b[0]), area(q, b[1]), area(q, b[2])},
      w{area(b[0], b[1]), area(b[1], b[2]), area(b[2], b[0])};
  const Area all = area(p, q), none = all - all;
  const auto beyond = [&](std::size_t i) { return (all + v[i]) - u[i]; };
  const auto around = [&](std::size_t i, std::size_t j) {
    return Three<Area>{w[i], (w[i] + u[i]) - u[j], (w[i] + v[i]) - v[j]};
  };
  return TriangleAreas<Area>{all,
                             (w[0] + w[1]) + w[2],
                             {u, {beyond(0), beyond(1), beyond(2)}, {none - v[0], none - v[1], none - v[2]}},
                             {around(0, 1), around(1, 2), around(2, 0)}};
}

/// `told` makes a double of each area.
template <class N, class Told>
constexpr TriangleAreas<double> told_areas(const TriangleAreas<N>& x, Told told) {
  const auto three = [&](const Three<N>& t) { return Three<double>{told(t[0]), told(t[1]), told(t[2])}; };
  const auto nine = [&](const std::array<Three<N>, 3>& t) { return std::array{three(t[0]), three(t[1]), three(t[2])}; };
  return {told(x.of_a), told(x.of_b), nine(x.over_a), nine(x.over_b)};
}

/// The most that a corner reaches to the inner side of each edge, of that edge where it is least.
inline double depth(double turn, const std::array<Three<double>, 3>& over) {
  const double way = std::copysign(1.0, turn);
  const auto most = [&](const Three<double>& t) { return std::max(std::max(way * t[0], way * t[1]), way * t[2]); };
  return std::min(std::min(most(over[0]), most(over[1])), most(over[2]));
}
inline double depth(const TriangleAreas<double>& x) {
  return std::min(depth(x.of_a, x.over_a), depth(x.of_b, x.over_b));
}

/// Of the segment from p to q and a triangle.
template <class N>
struct SegmentAreas {
  N of_triangle;
  Three<N> of_p, of_q, along;  // of the edges with p and with q, of the segment with the corners
};

/// From the first corner of the triangle: its others, and the segment's ends.
template <class N>
constexpr auto segment_areas(const Seen2<N>& b, const Seen2<N>& c, const Seen2<N>& p, const Seen2<N>& q) {
  using Area = decltype(area(p, q));
  const Area bp = area(b, p), bq = area(b, q), cp = area(c, p), cq = area(c, q), all = area(b, c), pq = area(p, q),
             none = all - all;
  return SegmentAreas<Area>{
      all, {bp, (all + cp) - bp, none - cp}, {bq, (all + cq) - bq, none - cq}, {pq, (pq + bp) - bq, (pq + cp) - cq}};
}
template <class N, class Told>
constexpr SegmentAreas<double> told_areas(const SegmentAreas<N>& x, Told told) {
  const auto three = [&](const Three<N>& t) { return Three<double>{told(t[0]), told(t[1]), told(t[2])}; };
  return {told(x.of_triangle), three(x.of_p), three(x.of_q), three(x.along)};
}

/// Of a segment that is no point.
inline double depth(const SegmentAreas<double>& x) {
  const double way = std::copysign(1.0, x.of_triangle);
  const auto most = [&](std::size_t i) { return std::max(way * x.of_p[i], way * x.of_q[i]); };
  const auto& s = x.along;
  const double left = std::max(std::max(s[0], s[1]), s[2]), right = -std::min(std::min(s[0], s[1]), s[2]);
  return std::min(std::min(std::min(most(0), most(1)), most(2)), std::min(left, right));
}

/// Of two segments: of the first with the ends of the second, and the other way round.
template <class N>
struct CrossingAreas {
  std::array<N, 2> over_first, over_second;
};

/// From the first end of the first: its other end, and those of the second.
template <class N>
constexpr auto crossing_areas(const Seen2<N>& p, const Seen2<N>& c, const Seen2<N>& d) {
  using Area = decltype(area(p, c));
  const Area pc = area(p, c), pd = area(p, d), cd = area(c, d);
  return CrossingAreas<Area>{{pc, pd}, {cd, (cd + pc) - pd}};
}
template <class N, class Told>
constexpr CrossingAreas<double> told_areas(const CrossingAreas<N>& x, Told told) {
  return {{told(x.over_first[0]), told(x.over_first[1])}, {told(x.over_second[0]), told(x.over_second[1])}};
}

/// Of segments, points among them, that do not lie on one line.
inline double depth(const CrossingAreas<double>& x) {
  const auto across = [](const std::array<double, 2>& s) {
    return std::min(std::max(s[0], s[1]), -std::min(s[0], s[1]));
  };
  return std::min(across(x.over_first), across(x.over_second));
}

}  // namespace plumb::query
