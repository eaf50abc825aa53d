#include <cmath>

#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "world/clash_surface.hpp"

namespace plumb {
namespace {

ExactMesh exact_hull_of(const Hull3& hull, std::span<const Point3> points) {
  ExactMesh mesh;
  mesh.vertices.assign(points.begin(), points.end());
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t k = 2; k < face.size(); ++k) mesh.triangles.push_back({face[0], face[k - 1], face[k]});
  }
  return mesh;
}

ClashPart::Hull hull_of_mesh(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> is_used(mesh.vertices.size());
  for (const auto& corners : mesh.triangles)
    for (const std::uint32_t v : corners) is_used[v] = 1;
  std::vector<Point3> points;
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) points.push_back(mesh.vertices[v]);
  const Hull3 hull = convex_hull(points);
  ClashPart::Hull made{{}, false, signed_volume(mesh)};
  for (const std::uint32_t v : hull.vertices) made.corners.push_back(points[v]);
  // Where the roundings of volumes differ they are not equal, and that is seen at once.
  if (std::abs(made.volume_of_part) != volume(convex_polyhedron(hull, points))) return made;
  ExactMesh exact;
  exact.vertices.assign(mesh.vertices.begin(), mesh.vertices.end());
  exact.triangles = mesh.triangles;
  const Rational of_mesh = exact_volume(exact), of_hull = exact_volume(exact_hull_of(hull, points));
  made.has_volume_of_part = of_mesh == of_hull || -of_mesh == of_hull;
  return made;
}

}  // namespace

const ClashPart::Hull& ClashPart::hull() const {
  std::call_once(surface_->hull_asked, [this] { surface_->hull = hull_of_mesh(*mesh_); });
  return surface_->hull;
}

}  // namespace plumb
