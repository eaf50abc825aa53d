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
void find_neighbors(const PolygonMesh& mesh, std::vector<std::uint32_t>& first, std::vector<std::uint32_t>& neighbors) {
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

std::string with(std::string_view words, std::size_t number) {
  return std::string(words).append(std::to_string(number));
}

/// What is not as in the list that the mesh has, in words.
std::string flaw_of_across(const ConvexPolyhedron3& p, const std::vector<std::uint32_t>& across) {
  if (p.across.size() != across.size())
    return with("polyhedron.across has ", p.across.size())
        .append(with(" faces for ", across.size()))
        .append(" corners");
  for (std::size_t c = 0; c < across.size(); ++c) {
    if (p.across[c] == across[c]) continue;
    return with("polyhedron.across[", c)
        .append(with("] is face ", p.across[c]))
        .append(with(", but beyond the edge that leaves vertex ", p.mesh.corners[c]))
        .append(with(" there is face ", across[c]));
  }
  return {};
}

std::string flaw_of_offsets(const ConvexPolyhedron3& p) {
  const auto& first = p.first_neighbor;
  const bool fits = first.size() == p.mesh.vertices.size() + 1 && first.front() == 0 &&
                    first.back() == p.neighbors.size() && std::ranges::is_sorted(first);
  if (fits) return {};
  return "polyhedron.first_neighbor does not divide polyhedron.neighbors among the vertices: it begins with 0, "
         "ascends, and "
         "ends with their number, one more than there are vertices";
}

/// Of lists that name vertices at all.
std::string flaw_of_vertex(const ConvexPolyhedron3& p, std::size_t v, std::span<const std::uint32_t> wanted) {
  const auto listed = p.neighbors_of(v);
  const auto has = [](std::span<const std::uint32_t> list, std::size_t w) {
    return std::ranges::find(list, w) != list.end();
  };
  const std::string vertex = with("vertex ", v);
  for (const std::uint32_t w : listed) {
    const std::string names = std::string(vertex).append(with(" has the neighbor ", w));
    if (!has(p.neighbors_of(w), v))
      return std::string(names)
          .append(with(", but not the other way round: vertex ", w))
          .append(with(" has not the neighbor ", v));
    if (!has(wanted, w)) return std::string(names).append(", but no edge of the mesh joins them");
  }
  for (const std::uint32_t w : wanted) {
    if (!has(listed, w))
      return std::string(vertex)
          .append(with(" lacks the neighbor ", w))
          .append(", though an edge of the mesh joins them");
  }
  if (std::ranges::equal(listed, wanted)) return {};
  return std::string("the neighbors of ").append(vertex).append(" are not each named once, in ascending order");
}

std::string flaw_of_neighbors(const ConvexPolyhedron3& p) {
  if (const std::string flaw = flaw_of_offsets(p); !flaw.empty()) return flaw;
  const std::size_t vertices = p.mesh.vertices.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    for (const std::uint32_t w : p.neighbors_of(v)) {
      if (w < vertices) continue;
      return with("vertex ", v)
          .append(with(" has the neighbor ", w))
          .append(with(", but there are ", vertices))
          .append(" vertices");
    }
  }
  std::vector<std::uint32_t> first, neighbors;
  find_neighbors(p.mesh, first, neighbors);
  if (first == p.first_neighbor && neighbors == p.neighbors) return {};
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::string flaw = flaw_of_vertex(p, v, std::span(neighbors).subspan(first[v], first[v + 1] - first[v]));
    if (!flaw.empty()) return flaw;
  }
  return {};
}

}  // namespace

void check_polyhedron(const ConvexPolyhedron3& p, std::string_view function) {
  require_mesh(function, p.mesh);
  std::vector<std::uint32_t> across;
  const SurfaceConvexity convexity = prove_convex(p.mesh, &across);
  if (!convexity.is_convex()) throw_invalid_mesh(function, describe(convexity));
  std::string flaw = flaw_of_across(p, across);
  if (flaw.empty()) flaw = flaw_of_neighbors(p);
  if (!flaw.empty()) throw_invalid_mesh(function, flaw.append("; make it by convex_polyhedron"));
}

ConvexPolyhedron3 convex_polyhedron(PolygonMesh mesh) {
  require_mesh("convex_polyhedron", mesh);
  ConvexPolyhedron3 polyhedron;
  const SurfaceConvexity convexity = prove_convex(mesh, &polyhedron.across);
  if (!convexity.is_convex()) throw_invalid_mesh("convex_polyhedron", describe(convexity));
  polyhedron.mesh = std::move(mesh);
  find_neighbors(polyhedron.mesh, polyhedron.first_neighbor, polyhedron.neighbors);
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
