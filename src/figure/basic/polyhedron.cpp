#include "plumb/figure/basic/polyhedron.hpp"

#include <algorithm>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/surface_proof.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

/// What spans the face at its corner k: the next corner, and where the corner lies in a straight edge one off its line.  Every
/// edge leaves each of its vertices once.
template <class Take>
void take_neighbors(const PolygonFaces& faces, std::span<const std::uint32_t> corners, std::size_t k, Take take) {
  const std::uint32_t next = corners[k + 1 < corners.size() ? k + 1 : 0],
                      before = corners[k > 0 ? k - 1 : corners.size() - 1];
  take(next);
  if (!collinear(faces.at(before), faces.at(corners[k]), faces.at(next))) return;
  const auto off_line = std::ranges::find_if(
      corners, [&](std::uint32_t c) { return !collinear(faces.at(before), faces.at(next), faces.at(c)); });
  if (off_line != corners.end()) take(*off_line);
}

void find_neighbors(ConvexPolyhedron3& polyhedron) {
  const PolygonMesh& mesh = polyhedron.mesh;
  const PolygonFaces faces = faces_of(mesh);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  pairs.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    for (std::size_t k = 0; k < corners.size(); ++k)
      take_neighbors(faces, corners, k, [&](std::uint32_t v) { pairs.push_back({corners[k], v}); });
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  polyhedron.first_neighbor.assign(mesh.vertices.size() + 1, 0);
  for (const auto& [v, neighbor] : pairs) {
    ++polyhedron.first_neighbor[v + 1];
    polyhedron.neighbors.push_back(neighbor);
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    polyhedron.first_neighbor[v + 1] += polyhedron.first_neighbor[v];
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
