#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/query/penetration/penetration.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "world/clash_solids.hpp"

namespace plumb::world {
namespace {

struct HullOfPart {
  std::vector<Point3> corners;
  bool is_part;  // the part is convex
};

ExactMesh exact_hull(const Hull3& hull, std::span<const Point3> points) {
  ExactMesh mesh;
  mesh.vertices.assign(points.begin(), points.end());
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) mesh.triangles.push_back({face[0], face[k - 1], face[k]});
  }
  return mesh;
}

/// Does the mesh wind around what it winds around everywhere alike?
bool winds_alike(const Arrangement& of_both, std::size_t part) {
  std::int32_t all = 0;
  for (std::size_t r = 0; r < of_both.regions(); ++r) {
    const std::int32_t winding = of_both.windings_of(r)[part];
    if (winding == 0) continue;
    if (winding * winding != 1 || (all != 0 && winding != all)) return false;
    all = winding;
  }
  return true;
}

HullOfPart hull_of(const ClashPart& part, const Arrangement& of_both, std::size_t number) {
  std::vector<std::uint8_t> is_used(part.mesh().vertices.size());
  for (const auto& corners : part.mesh().triangles)
    for (const std::uint32_t v : corners) is_used[v] = 1;
  std::vector<Point3> points;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) points.push_back(part.mesh().vertices[v]);
  const Hull3 hull = convex_hull(points);
  HullOfPart made{{}, false};
  for (const std::uint32_t v : hull.vertices) made.corners.push_back(points[v]);
  // A solid fills its hull where their volumes are equal.  Where the roundings of these differ they are not, and that is
  // seen at once.
  if (!winds_alike(of_both, number) || volume(part.mesh()) != volume(convex_polyhedron(hull, points))) return made;
  ExactMesh mesh;
  mesh.vertices.assign(part.mesh().vertices.begin(), part.mesh().vertices.end());
  mesh.triangles = part.mesh().triangles;
  const Rational of_mesh = exact_volume(mesh), of_hull = exact_volume(exact_hull(hull, points));
  made.is_part = of_mesh == of_hull || -of_mesh == of_hull;
  return made;
}

/// How far from the surface of the outer part the deepest corner of the inner one is in it: rounded down.
double deepest_corner(const ClashPart& outer, const Arrangement& of_both, std::uint32_t inner_number) {
  const std::uint32_t outer_number = 1 - inner_number;
  std::vector<std::uint8_t> is_in(of_both.vertices.size());
  for (std::size_t f = 0; f < of_both.facets.size(); ++f) {
    const auto sources = of_both.sources_of(f);
    if (std::ranges::any_of(sources, [&](const FacetSource& s) { return s.face.mesh == outer_number; })) continue;
    if (of_both.windings_of(of_both.sides[f].above)[outer_number] == 0) continue;
    for (const std::uint32_t v : of_both.facets[f]) is_in[v] = 1;
  }
  double deepest = 0;
  for (std::size_t v = 0; v < is_in.size(); ++v) {
    if (is_in[v] == 0) continue;
    const auto* const p = std::get_if<Point3>(&of_both.vertices[v].as());
    if (p == nullptr) continue;
    deepest = std::max(deepest, closest_on_mesh(outer.bvh(), *p)->distance);
  }
  return std::max(0.0, std::nextafter(deepest, 0.0));
}

}  // namespace

void measure_solids(const ClashPart& a, const ClashPart& b, const Arrangement& of_both, Clash& clash) {
  clash.volume =
      exact_volume(solid_where(of_both, [](auto winding) { return winding[0] != 0 && winding[1] != 0; })).rounded();
  const HullOfPart of_a = hull_of(a, of_both, 0), of_b = hull_of(b, of_both, 1);
  const auto parting = penetration(VertexHull3{of_a.corners}, VertexHull3{of_b.corners});
  if (!parting) return;  // hulls of what meets meet
  ClashDepth& depth = clash.depth.emplace();
  depth.direction = parting->direction;
  if (of_a.is_part && of_b.is_part) {
    depth.lower = depth.upper = parting->depth;
    return;
  }
  depth.upper = std::nextafter(parting->depth, std::numeric_limits<double>::infinity());
  depth.lower = std::min(depth.upper, std::max(deepest_corner(b, of_both, 0), deepest_corner(a, of_both, 1)));
}

}  // namespace plumb::world
