// The nearest point of a convex set is where no way into the set leads toward p: a feature is found by looking along
// the ways that leave it.
#include "plumb/figure/containment/voronoi_region.hpp"

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

/// Does the way from `from` to `to` lead toward p?
template <class Point>
bool toward(const Point& from, const Point& to, const Point& p) {
  return angle_sign(p, from, to) == Sign::positive;
}

/// The sign of p's distance from the line ab in the plane of a, b and c, c's side positive: zero where there is none.
Sign side(const Point2& a, const Point2& b, const Point2& c, const Point2& p) {
  return orient2d(a, b, c) * orient2d(a, b, p);
}
Sign side(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  return coplanar_orientation(a, b, c, p);
}

/// p is nearest to what is strictly between the ends of ab, as far as the line and the half planes from it through the
/// other corners know.
template <class Point, class... Others>
bool nearest_to_edge(const Point& p, const Point& a, const Point& b, const Others&... others) {
  return toward(a, b, p) && toward(b, a, p) && ((side(a, b, others, p) != Sign::positive) && ...);
}

template <class Point>
Feature region_of_segment(const Point& a, const Point& b, const Point& p) {
  if (!toward(a, b, p)) return {FeatureKind::vertex, 0};
  if (!toward(b, a, p)) return {FeatureKind::vertex, 1};
  return {FeatureKind::edge, 0};
}

template <class Point>
Feature region_of_triangle(const Point& a, const Point& b, const Point& c, const Point& p) {
  if (!toward(a, b, p) && !toward(a, c, p)) return {FeatureKind::vertex, 0};
  if (!toward(b, a, p) && !toward(b, c, p)) return {FeatureKind::vertex, 1};
  if (!toward(c, a, p) && !toward(c, b, p)) return {FeatureKind::vertex, 2};
  if (nearest_to_edge(p, a, b, c)) return {FeatureKind::edge, 0};
  if (nearest_to_edge(p, b, c, a)) return {FeatureKind::edge, 1};
  if (nearest_to_edge(p, c, a, b)) return {FeatureKind::edge, 2};
  return {FeatureKind::face, 0};
}

/// p is above the inside of the triangle abc, or in it; d is behind.
bool nearest_to_face(const Point3& p, const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return side(a, b, c, p) == Sign::positive && side(b, c, a, p) == Sign::positive &&
         side(c, a, b, p) == Sign::positive && orient3d(a, b, c, d) * orient3d(a, b, c, p) != Sign::positive;
}

Feature region_of_tetrahedron(const Tetrahedron3& t, const Point3& p) {
  const std::array corner{t.a, t.b, t.c, t.d};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const auto way = [&](std::uint32_t j) { return j != i && toward(corner[i], corner[j], p); };
    if (!way(0) && !way(1) && !way(2) && !way(3)) return {FeatureKind::vertex, i};
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> edges{
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    const auto& [a, b, c, d] = edges[i];
    if (nearest_to_edge(p, corner[a], corner[b], corner[c], corner[d])) return {FeatureKind::edge, i};
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (nearest_to_face(p, corner[(i + 1) % 4], corner[(i + 2) % 4], corner[(i + 3) % 4], corner[i]))
      return {FeatureKind::face, i};
  }
  return {FeatureKind::interior, 0};
}

}  // namespace

Feature voronoi_region(const Segment2& s, const Point2& p) {
  figure::require_sound("voronoi_region", s, part::place("p", p));
  return region_of_segment(s.a, s.b, p);
}
Feature voronoi_region(const Segment3& s, const Point3& p) {
  figure::require_sound("voronoi_region", s, part::place("p", p));
  return region_of_segment(s.a, s.b, p);
}

Feature voronoi_region(const Triangle2& t, const Point2& p) {
  require_finite_parts("voronoi_region", std::array<std::string_view, 4>{"triangle.a", "triangle.b", "triangle.c", "p"},
                       t.a, t.b, t.c, p);
  return region_of_triangle(t.a, t.b, t.c, p);
}
Feature voronoi_region(const Triangle3& t, const Point3& p) {
  require_finite_parts("voronoi_region", std::array<std::string_view, 4>{"triangle.a", "triangle.b", "triangle.c", "p"},
                       t.a, t.b, t.c, p);
  return region_of_triangle(t.a, t.b, t.c, p);
}

Feature voronoi_region(const Tetrahedron3& t, const Point3& p) {
  figure::require_sound("voronoi_region", t, part::place("p", p));
  return region_of_tetrahedron(t, p);
}

Feature voronoi_region(const Aabb3& box, const Point3& p) {
  figure::require_sound("voronoi_region", box, part::place("p", p));
  const auto min = coordinates(box.min), max = coordinates(box.max), at = coordinates(p);
  std::uint32_t free = 0, free_axes = 0, fixed_axis = 0, upper = 0, places = 0;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    if (min[axis] > max[axis])
      throw InvalidShape("voronoi_region: the box is empty, and nothing is nearest; give min at most max");
    if (at[axis] > min[axis] && at[axis] < max[axis]) {
      free = axis;
      ++free_axes;
    } else {
      fixed_axis = axis;
      upper |= static_cast<std::uint32_t>(at[axis] > min[axis] && max[axis] > min[axis]) << places++;
    }
  }
  if (free_axes == 0) return {FeatureKind::vertex, upper};
  if (free_axes == 1) return {FeatureKind::edge, 4 * free + upper};
  if (free_axes == 2) return {FeatureKind::face, 2 * fixed_axis + upper};
  return {FeatureKind::interior, 0};
}

}  // namespace plumb
