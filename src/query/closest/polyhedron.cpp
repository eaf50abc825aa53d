// Convex polyhedra: the walk over their Voronoi regions names the feature.
#include "plumb/certify/direction.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

/// Three corners of a face that are not on one line.
std::array<Point3, 3> span_of_face(const PolygonMesh& m, std::uint32_t face) {
  const auto at = [&](std::uint32_t corner) -> const Point3& { return m.vertices[m.corners[corner]]; };
  const std::uint32_t first = m.first[face], last = m.first[face + 1];
  std::uint32_t c = first + 2;
  while (c + 1 < last && collinear(at(first), at(first + 1), at(c))) ++c;
  return {at(first), at(first + 1), at(c)};
}

}  // namespace

template <>
struct Nearest<ConvexPolyhedron3> {
  static void require_some(std::string_view function, const ConvexPolyhedron3& s) {
    if (s.mesh.corners.empty())
      throw InvalidShape(
          std::string(function).append(": the polyhedron has no faces; give one made by convex_polyhedron"));
  }
  static Feature feature(const ConvexPolyhedron3& s, const Point3& p) { return voronoi_region(s, p); }
  template <class T>
  static Foot<T> foot(const ConvexPolyhedron3& s, const Point3& p, const Feature& f) {
    const PolygonMesh& m = s.mesh;
    const Vec<T> q = vec<T>(p);
    if (f.kind == FeatureKind::interior) return foot_of_itself(q);
    if (f.kind == FeatureKind::vertex) return foot_on_point(vec<T>(m.vertices[f.index]), q);
    if (f.kind == FeatureKind::edge) {
      // The edge that leaves corner number f.index of its face.
      const auto face = std::ranges::upper_bound(m.first, f.index);
      const std::uint32_t to = f.index + 1 == *face ? *(face - 1) : f.index + 1;
      const Vec<T> a = vec<T>(m.vertices[m.corners[f.index]]);
      return foot_on_line(a, vec<T>(m.vertices[m.corners[to]]) - a, q);
    }
    const auto [a, b, c] = span_of_face(m, f.index);
    const Vec<T> from = vec<T>(a), n = cross(vec<T>(b) - from, vec<T>(c) - from);
    return foot_on_plane(n, dot(n, q - from), q);
  }
};

}  // namespace query

PLUMB_CLOSEST_FLAT(Closest, Point3, ConvexPolyhedron3)

}  // namespace plumb
