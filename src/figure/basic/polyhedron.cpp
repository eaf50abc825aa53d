#include "plumb/figure/basic/polyhedron.hpp"

#include <algorithm>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/surface_proof.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

/// Every edge leaves each of its vertices once.
void find_neighbors(ConvexPolyhedron3& polyhedron) {
  const PolygonMesh& mesh = polyhedron.mesh;
  std::vector<std::uint32_t>&first = polyhedron.first_neighbor, &neighbors = polyhedron.neighbors;
  first.assign(mesh.vertices.size() + 1, 0);
  for (const std::uint32_t v : mesh.corners) ++first[v + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  neighbors.resize(mesh.corners.size());
  std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
  const PolygonFaces faces = faces_of(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    for (std::size_t k = 0; k < corners.size(); ++k)
      neighbors[end[corners[k]]++] = corners[k + 1 < corners.size() ? k + 1 : 0];
  }
  for (std::size_t v = 0; v + 1 < first.size(); ++v)
    std::sort(neighbors.begin() + first[v], neighbors.begin() + first[v + 1]);
}

/// The side of the face on which p lies, positive below; corners on one line with the first two tell nothing.
Sign below(const PolygonFaces& faces, std::size_t face, const Point3& p) {
  const auto corners = faces[face];
  const Point3 &a = faces.at(corners[0]), &b = faces.at(corners[1]);
  for (std::size_t k = 2; k < corners.size(); ++k) {
    if (const Sign side = orient3d(a, b, faces.at(corners[k]), p); side != Sign::zero) return side;
  }
  return Sign::zero;
}

}  // namespace

ConvexPolyhedron3 convex_polyhedron(PolygonMesh mesh) {
  require_mesh("convex_polyhedron", mesh);
  ConvexPolyhedron3 polyhedron;
  const SurfaceConvexity convexity = prove_convex(mesh, &polyhedron.across);
  if (!convexity.is_convex()) throw_invalid_mesh("convex_polyhedron", describe(convexity));
  polyhedron.mesh = std::move(mesh);
  find_neighbors(polyhedron);
  return polyhedron;
}

ConvexPolyhedron3 convex_polyhedron(const TriangleMesh& mesh) {
  require_mesh("convex_polyhedron", mesh);
  return convex_polyhedron(polygon_mesh(mesh));
}

Location locate(const ConvexPolyhedron3& polyhedron, const Point3& p) {
  require_finite_parts("locate", std::array<std::string_view, 1>{"p"}, p);
  const PolygonFaces faces = faces_of(polyhedron.mesh);
  if (faces.size() == 0) throw InvalidShape("locate: the polyhedron has no faces; make it by convex_polyhedron");
  bool on_a_face = false;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Sign side = below(faces, f, p);
    if (side == Sign::negative) return Location::outside;
    on_a_face = on_a_face || side == Sign::zero;
  }
  return on_a_face ? Location::boundary : Location::inside;
}

bool contains(const ConvexPolyhedron3& polyhedron, const Point3& p) {
  return locate(polyhedron, p) != Location::outside;
}

}  // namespace plumb
