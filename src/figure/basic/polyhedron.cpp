#include "plumb/figure/basic/polyhedron.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/mesh_input.hpp"
#include "figure/basic/surface_proof.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

/// What spans the face at its corner k: the next corner, and where the corner lies in a straight edge one off its line.
/// Every edge leaves each of its vertices once.
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

/// Of four corners that are in no plane, of whose like every polyhedron has some, one is off any plane.
class OffPlane {
 public:
  explicit OffPlane(const std::vector<Point3>& all) : all_(all) {
    const auto count = static_cast<std::uint32_t>(all.size());
    std::uint32_t i = 1;
    while (all[i] == all[0]) ++i;
    std::uint32_t j = i + 1;
    while (collinear(all[0], all[i], all[j])) ++j;
    std::uint32_t k = j + 1;
    while (k < count && orient3d(all[0], all[i], all[j], all[k]) == Sign::zero) ++k;
    some_ = {0, i, j, k};
  }
  [[nodiscard]] std::uint32_t operator()(const Point3& a, const Point3& b, const Point3& c) const {
    return *std::ranges::find_if(some_, [&](std::uint32_t v) { return orient3d(a, b, c, all_[v]) != Sign::zero; });
  }

 private:
  const std::vector<Point3>& all_;
  std::array<std::uint32_t, 4> some_{};
};

/// Within a flat part of the surface, where all neighbors are in one plane with it: a corner off that plane.
std::optional<std::uint32_t> neighbor_off_plane(const std::vector<Point3>& all, const Point3& v,
                                                std::span<const std::uint32_t> neighbors, const OffPlane& off_plane) {
  const Point3& a = all[neighbors[0]];
  const auto b = std::ranges::find_if(neighbors, [&](std::uint32_t w) { return !collinear(v, a, all[w]); });
  const auto is_off = [&](std::uint32_t w) { return orient3d(v, a, all[*b], all[w]) != Sign::zero; };
  if (std::ranges::any_of(neighbors, is_off)) return {};
  return off_plane(v, a, all[*b]);
}

void find_neighbors(const PolygonMesh& mesh, std::vector<std::uint32_t>& first_of,
                    std::vector<std::uint32_t>& neighbors) {
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
  const OffPlane off_plane(mesh.vertices);
  first_of = {0};
  neighbors.clear();
  for (auto at = pairs.begin(); at != pairs.end();) {
    const std::uint32_t v = (*at)[0];
    const std::size_t first = neighbors.size();
    for (; at != pairs.end() && (*at)[0] == v; ++at) neighbors.push_back((*at)[1]);
    const auto off =
        neighbor_off_plane(mesh.vertices, mesh.vertices[v], std::span(neighbors).subspan(first), off_plane);
    if (off)
      neighbors.insert(std::upper_bound(neighbors.begin() + static_cast<std::ptrdiff_t>(first), neighbors.end(), *off),
                       *off);
    first_of.push_back(static_cast<std::uint32_t>(neighbors.size()));
  }
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
    if (has(wanted, w)) continue;
    const std::string names = std::string(vertex).append(with(" has the neighbor ", w));
    if (has(p.neighbors_of(w), v)) return std::string(names).append(", which it has not in the mesh");
    return std::string(names)
        .append(with(", but not the other way round: vertex ", w))
        .append(with(" has not the neighbor ", v));
  }
  for (const std::uint32_t w : wanted) {
    if (!has(listed, w))
      return std::string(vertex).append(with(" lacks the neighbor ", w)).append(", which it has in the mesh");
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
