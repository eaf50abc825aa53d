// By which points as given is a corner named?
//
// Laws: what is returned stands for the corner's exact point; nothing where points as given do not construct it.
// Cost: a copy.
#pragma once

#include "query/section/corner.hpp"

namespace plumb::query::meeting {

inline ExactPoint2 as_point(const std::array<double, 2>& x) { return Point2{x[0], x[1]}; }
inline ExactPoint3 as_point(const std::array<double, 3>& x) { return Point3{x[0], x[1], x[2]}; }

/// p, but for one coordinate.
template <std::size_t N>
Point<N> moved(Point<N> p, std::size_t axis) {
  part(p, axis) = part(p, axis) == 0 ? 1.0 : 0.0;
  return p;
}

/// Where the line pq crosses the bound.
inline ExactPoint2 crossing_name(const Point2& p, const Point2& q, const Bound<2>& b) {
  if (b.kind == Bound<2>::Kind::axis) {
    Point2 on{0, 0};
    part(on, b.axis) = b.offset;
    return LineLinePoint2{p, q, on, moved<2>(on, 1 - b.axis)};
  }
  return LineLinePoint2{p, q, b.a, b.b};
}
inline ExactPoint3 crossing_name(const Point3& p, const Point3& q, const Bound<3>& b) {
  if (b.kind == Bound<3>::Kind::axis) {
    Point3 on{0, 0, 0};
    part(on, b.axis) = b.offset;
    return LinePlanePoint3{p, q, on, moved<3>(on, (b.axis + 1) % 3), moved<3>(on, (b.axis + 2) % 3)};
  }
  return LinePlanePoint3{p, q, b.a, b.b, b.kind == Bound<3>::Kind::face ? b.c : moved<3>(b.a, b.axis)};
}

template <class T, std::size_t N>
auto corner_name(const Corner<T, N>& c, const ConvexSet<N>& a, const ConvexSet<N>& b) {
  using Exact = decltype(as_point(c.known));
  bool known = true;
  for (const double x : c.known) known = known && x == x;
  if (known) return std::optional<Exact>(as_point(c.known));
  if (c.origin.bound != infinity) {
    const ConvexSet<N>&set = c.origin.of_b ? b : a, &other = c.origin.of_b ? a : b;
    const Edge<N>& e = set.edges[static_cast<std::size_t>(c.origin.index)];
    const Bound<N>& bound = other.bounds[static_cast<std::size_t>(c.origin.bound)];
    const bool bounded = e.is_bounded();
    if (!set.is_exact() && bound.is_named() && (bounded || e.named)) {
      const Point<N>& p = bounded ? set.vertices[static_cast<std::size_t>(e.from)] : e.point;
      const Point<N>& q = bounded ? set.vertices[static_cast<std::size_t>(e.to)] : e.second;
      return std::optional<Exact>(crossing_name(p, q, bound));
    }
  }
  if constexpr (std::is_same_v<T, BigDyadic>) return std::optional<Exact>(rational(c.at));
  return std::optional<Exact>();
}

}  // namespace plumb::query::meeting
