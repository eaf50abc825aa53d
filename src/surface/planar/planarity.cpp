#include "plumb/surface/planar/planarity.hpp"

#include <string>

#include "arith/shortest_decimal.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/surface/planar/triangulate.hpp"

namespace plumb {
namespace {

std::vector<Point3> corners_of_face(const PolygonMesh& mesh, std::size_t face) {
  std::vector<Point3> corners;
  for (const std::uint32_t v : faces_of(mesh)[face]) corners.push_back(mesh.vertices[v]);
  return corners;
}

}  // namespace

std::vector<BentFace> bent_faces(const PolygonMesh& mesh, double length) {
  if (!(length - length == 0)) throw NonFinite("bent_faces: the length is not a real number; give a finite one");
  if (length < 0) throw InvalidShape("bent_faces: the length is negative; give one of at least 0");
  require_mesh("bent_faces", mesh);
  std::vector<BentFace> bent;
  const Rational most = Rational(length) * Rational(length);
  for (std::uint32_t f = 0; f < faces_of(mesh).size(); ++f) {
    if (faces_of(mesh)[f].size() < 4) continue;
    const std::vector<Point3> corners = corners_of_face(mesh, f);
    if (plane_of_points(corners).dimension < 3) continue;
    PointsWidth width = least_width(corners);
    if (most < width.squared) bent.push_back({f, std::move(width)});
  }
  return bent;
}

Vector3 newell_normal(std::span<const Point3> polygon) {
  require_chain("newell_normal", "polygon", polygon);
  const auto coordinate = [&](int axis) {
    return arith::exact_sum::nearest([&](const auto& number) {
      const auto n = figure::signed_sums::twice_vector_area(number, polygon.size(),
                                                            [&](std::size_t i) -> const Point3& { return polygon[i]; });
      return axis == 0 ? n.x : axis == 1 ? n.y : n.z;
    });
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

TriangleMesh triangulate_planar(const PolygonMesh& mesh, double length) {
  const std::vector<BentFace> bent = bent_faces(mesh, length);
  if (!bent.empty())
    throw InvalidShape("triangulate_planar: face " + std::to_string(bent[0].face) + " is not planar, but " +
                       arith::shortest_decimal(bent[0].width.width) + " thick; allow that length, or triangulate it");
  return triangulate(mesh);
}

}  // namespace plumb
