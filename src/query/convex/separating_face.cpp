#include "plumb/query/convex/separating_face.hpp"

#include <algorithm>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"
#include "query/body/figure_input.hpp"

namespace plumb {
namespace query {
namespace {

/// Is all of the other strictly outside of the face's plane?
bool face_parts(const ConvexPolyhedron3& of, std::uint32_t face, const ConvexPolyhedron3& other) {
  const PolygonMesh& m = of.mesh;
  const std::uint32_t from = m.first[face], to = m.first[face + 1];
  const Point3 &a = m.vertices[m.corners[from]], &b = m.vertices[m.corners[from + 1]];
  std::uint32_t third = from + 2;
  while (third < to && collinear(a, b, m.vertices[m.corners[third]])) ++third;
  if (third >= to) return false;
  const Point3& c = m.vertices[m.corners[third]];
  // Corners turn counterclockwise seen from outside, where orient3d is negative.
  return std::ranges::all_of(other.mesh.vertices,
                             [&](const Point3& p) { return orient3d(a, b, c, p) == Sign::negative; });
}

std::uint32_t faces_of(const ConvexPolyhedron3& p) {
  return p.mesh.first.empty() ? 0 : static_cast<std::uint32_t>(p.mesh.first.size() - 1);
}

std::optional<SeparatingFace> parting_face(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  for (std::uint32_t f = 0; f < faces_of(a); ++f) {
    if (face_parts(a, f, b)) return SeparatingFace{false, f};
  }
  for (std::uint32_t f = 0; f < faces_of(b); ++f) {
    if (face_parts(b, f, a)) return SeparatingFace{true, f};
  }
  return {};
}

}  // namespace
}  // namespace query

std::optional<SeparatingFace> separating_face(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  query::require_figures("separating_face", query::view_of(a), query::view_of(b));
  return query::parting_face(a, b);
}

std::optional<SeparatingFace> separating_face(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b,
                                              const SeparatingFace& last) {
  query::require_figures("separating_face", query::view_of(a), query::view_of(b));
  const ConvexPolyhedron3 &of = last.of_second ? b : a, &other = last.of_second ? a : b;
  if (last.face < query::faces_of(of) && query::face_parts(of, last.face, other)) return last;
  return query::parting_face(a, b);
}

}  // namespace plumb
