// Triangles and tetrahedra: the region says which corners the foot is among.
#include "plumb/figure/basic/barycentric.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

template <class T, class Point>
Foot<T> foot_on_edge(const Point& a, const Point& b, const Point& p) {
  const Vec<T> from = vec<T>(a);
  return foot_on_line(from, vec<T>(b) - from, vec<T>(p));
}
template <class T>
Foot<T> foot_on_face(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  const Vec<T> from = vec<T>(a), q = vec<T>(p), n = cross(vec<T>(b) - from, vec<T>(c) - from);
  return foot_on_plane(n, dot(n, q - from), q);
}

constexpr std::array<std::array<std::size_t, 2>, 3> edges_of_triangle{{{0, 1}, {1, 2}, {2, 0}}};
constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_tetrahedron{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

}  // namespace

template <class Triangle, class Point>
struct NearestOfTriangle {
  static Feature feature(const Triangle& s, const Point& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const Triangle& s, const Point& p, const Feature& f) {
    const std::array<Point, 3> corner{s.a, s.b, s.c};
    if (f.kind == FeatureKind::vertex) return foot_on_point(vec<T>(corner[f.index]), vec<T>(p));
    if (f.kind == FeatureKind::edge) {
      const auto [a, b] = edges_of_triangle[f.index];
      return foot_on_edge<T>(corner[a], corner[b], p);
    }
    if constexpr (std::is_same_v<Point, Point2>) {
      return foot_of_itself(vec<T>(p));
    } else {
      return foot_on_face<T>(s.a, s.b, s.c, p);
    }
  }
};
template <>
struct Nearest<Triangle2> : NearestOfTriangle<Triangle2, Point2> {};
template <>
struct Nearest<Triangle3> : NearestOfTriangle<Triangle3, Point3> {};

template <>
struct Nearest<Tetrahedron3> {
  static Feature feature(const Tetrahedron3& s, const Point3& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const Tetrahedron3& s, const Point3& p, const Feature& f) {
    const std::array corner{s.a, s.b, s.c, s.d};
    if (f.kind == FeatureKind::vertex) return foot_on_point(vec<T>(corner[f.index]), vec<T>(p));
    if (f.kind == FeatureKind::interior) return foot_of_itself(vec<T>(p));
    if (f.kind == FeatureKind::edge) {
      const auto [a, b] = edges_of_tetrahedron[f.index];
      return foot_on_edge<T>(corner[a], corner[b], p);
    }
    const auto other = [&](std::size_t i) { return corner[(f.index + i) % 4]; };
    return foot_on_face<T>(other(1), other(2), other(3), p);
  }
};

namespace {

template <class Triangle, class Point>
std::array<double, 3> weights_of(const Triangle& s, const Point& p) {
  require("closest_weights", s, p);
  const Feature f = voronoi_region(s, p);
  if (f.kind == FeatureKind::face) return barycentric(s, p);
  std::array<double, 3> weights{};
  if (f.kind == FeatureKind::vertex) {
    weights[f.index] = 1;
    return weights;
  }
  const std::array<Point, 3> corner{s.a, s.b, s.c};
  const auto [a, b] = edges_of_triangle[f.index];
  using Segment = std::conditional_t<std::is_same_v<Point, Point2>, Segment2, Segment3>;
  const std::array<double, 2> on_edge = barycentric(Segment{corner[a], corner[b]}, p);
  weights[a] = on_edge[0];
  weights[b] = on_edge[1];
  return weights;
}

}  // namespace
}  // namespace query

std::array<double, 3> closest_weights(const Triangle2& triangle, const Point2& p) {
  return query::weights_of(triangle, p);
}
std::array<double, 3> closest_weights(const Triangle3& triangle, const Point3& p) {
  return query::weights_of(triangle, p);
}

PLUMB_CLOSEST_FLAT(Closest2, Point2, Triangle2)
PLUMB_CLOSEST_FLAT(Closest, Point3, Triangle3)
PLUMB_CLOSEST_FLAT(Closest, Point3, Tetrahedron3)

}  // namespace plumb
