// One random figure of every kind that pairs are made of: those of figure/basic/shape_cases.hpp, and planar polygons in
// space, k-DOPs and convex polyhedra besides.
//
// Laws: those of a Material; a polygon in space is exactly planar, a polyhedron proved convex.
#pragma once

#include <cmath>
#include <optional>

#include "figure/basic/shape_cases.hpp"
#include "plumb/query/body/pairs.hpp"

namespace plumb::pair_cases {

using shape_cases::Material;

/// Points of a plane that doubles hold: a coordinate is constant, or equal or opposite to another.
class RandomPlane {
 public:
  explicit RandomPlane(Material& m) : kind_(m.below(3)), turn_(m.below(3)), constant_(m.number()) {}
  Point3 operator()(const Point2& p) const {
    const double third = kind_ == 0 ? constant_ : kind_ == 1 ? p.x : -p.x;
    return turn_ == 0 ? Point3{p.x, p.y, third} : turn_ == 1 ? Point3{third, p.x, p.y} : Point3{p.x, third, p.y};
  }

 private:
  std::size_t kind_, turn_;
  double constant_;
};

inline Polygon3 lifted(const RandomPlane& plane, const Polygon2& flat) {
  Polygon3 polygon;
  for (const Point2& p : flat.vertices) polygon.vertices.push_back(plane(p));
  return polygon;
}
inline Quadrilateral3 lifted(const RandomPlane& plane, const Quadrilateral2& q) {
  return {plane(q.a), plane(q.b), plane(q.c), plane(q.d)};
}
inline HoledPolygon3 lifted(const RandomPlane& plane, const HoledPolygon2& flat) {
  HoledPolygon3 polygon{lifted(plane, flat.outer), {}};
  for (const Polygon2& hole : flat.holes) polygon.holes.push_back(lifted(plane, hole));
  return polygon;
}

template <class Vector>
KDop<Vector> random_k_dop(Material& m, const Directions<Vector>& directions) {
  using Point = std::conditional_t<std::is_same_v<Vector, Vector2>, Point2, Point3>;
  std::vector<Point> points;
  for (std::size_t n = 1 + m.below(5); n-- > 0;) {
    if constexpr (std::is_same_v<Vector, Vector2>) {
      points.push_back(m.point2());
    } else {
      points.push_back(m.point3());
    }
  }
  try {
    KDop<Vector> fitted = fit_k_dop(points, directions);
    if (m.below(4) == 0) fitted.max[m.below(fitted.max.size())] = m.number();  // cut, or empty
    return fitted;
  } catch (const BeyondDoubles&) {
    return {directions, std::vector<double>(directions.size(), 0), std::vector<double>(directions.size(), 0)};
  }
}

inline ConvexPolyhedron3 random_polyhedron(Material& m) {
  std::vector<Point3> points;
  for (std::size_t n = 4 + m.below(4); n-- > 0;) points.push_back(m.point3());
  const Hull3 hull = convex_hull(points);
  if (hull.dimension == 3) return convex_polyhedron(hull, points);
  const Point3 p = m.point3();
  const double s = p.x == 0 ? 1 : p.x;
  return convex_polyhedron(TriangleMesh{{{0, 0, 0}, {std::fabs(s), 0, 0}, {0, std::fabs(s), 0}, {0, 0, std::fabs(s)}},
                                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
}

template <class Shape>
Shape figure(Material& m) {
  if constexpr (std::is_same_v<Shape, Point2>) {
    return m.probe2();
  } else if constexpr (std::is_same_v<Shape, Point3>) {
    return m.probe3();
  } else if constexpr (std::is_same_v<Shape, Quadrilateral3>) {
    const RandomPlane plane(m);
    return lifted(plane, m.shape<Quadrilateral2>());
  } else if constexpr (std::is_same_v<Shape, Polygon3>) {
    const RandomPlane plane(m);
    return lifted(plane, m.shape<Polygon2>());
  } else if constexpr (std::is_same_v<Shape, HoledPolygon3>) {
    const RandomPlane plane(m);
    return lifted(plane, m.shape<HoledPolygon2>());
  } else if constexpr (std::is_same_v<Shape, KDop2>) {
    static const Directions2 directions = k_dop_directions2(8);
    return random_k_dop(m, directions);
  } else if constexpr (std::is_same_v<Shape, KDop3>) {
    static const Directions3 directions = k_dop_directions(14);
    return random_k_dop(m, directions);
  } else if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
    return random_polyhedron(m);
  } else {
    return m.shape<Shape>();
  }
}

/// Every second time with points near to what was drawn: in the middles of edges, on lines, at corners.
template <class Shape>
Shape near_figure(Material& m) {
  Shape s = figure<Shape>(m);
  if (m.below(2) == 0) return s;
  const auto probe = [&](auto&... p) { ((p = m.probe<std::remove_cvref_t<decltype(p)>>()), ...); };
  constexpr FigureKind kind = figure_kind<Shape>;
  if constexpr (kind == FigureKind::line || kind == FigureKind::ray) {
    auto& [from, direction] = s;
    auto to = from;
    probe(from, to);
    direction.x = to.x - from.x;
    direction.y = to.y - from.y;
    if constexpr (requires { to.z; }) direction.z = to.z - from.z;
    const auto d = coordinates(direction);
    if (!std::ranges::all_of(d, [](double x) { return std::isfinite(x); })) direction = {};
  } else if constexpr (kind == FigureKind::segment) {
    probe(s.a, s.b);
  } else if constexpr (kind == FigureKind::triangle || kind == FigureKind::three_point_plane) {
    probe(s.a, s.b, s.c);
  } else if constexpr (kind == FigureKind::tetrahedron || std::is_same_v<Shape, Quadrilateral2>) {
    probe(s.a, s.b, s.c, s.d);
  } else if constexpr (requires { s.axes; }) {
    probe(s.center);
  } else if constexpr (std::is_same_v<Shape, Polygon2>) {
    for (Point2& p : s.vertices) probe(p);
  } else if constexpr (kind == FigureKind::aabb) {
    probe(s.min, s.max);
    if (s.min.x > s.max.x) std::swap(s.min.x, s.max.x);
    if (s.min.y > s.max.y) std::swap(s.min.y, s.max.y);
    if constexpr (requires { s.min.z; }) {
      if (s.min.z > s.max.z) std::swap(s.min.z, s.max.z);
    }
  }
  return s;
}

}  // namespace plumb::pair_cases
