#include "plumb/surface/solid/merge_pieces.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "plumb/arith/error.hpp"
#include "surface/solid/mesh_in_order.hpp"
#include "surface/solid/plane_view.hpp"
#include "surface/solid/wound_triangles.hpp"
#include "surface/topology/region_rings.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

constexpr std::uint32_t no_polygon = std::numeric_limits<std::uint32_t>::max();

/// The numbers alone decide who is whose neighbor.
Numbers twins_of(const ExactMesh& mesh) {
  const TriangleMesh numbered{std::vector<Point3>(mesh.vertices.size()), mesh.triangles};
  return half_edges(numbered, find_edges(numbered)).twin;
}

/// Triangles of one plane, and how they are seen: counterclockwise along the axis, or not.
struct CoplanarPieces {
  Numbers triangles;
  int axis = 2;
  Sign turn = Sign::zero;
  std::vector<Numbers> rings;
};

class PieceMerger {
 public:
  explicit PieceMerger(const ExactMesh& mesh)
      : mesh_(mesh),
        twin_(twins_of(mesh)),
        polygon_(mesh.triangles.size(), no_polygon),
        rings_(mesh.triangles, twin_, polygon_),
        beside_(mesh.vertices.size()),
        stays_(mesh.vertices.size()) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      if (polygon_[t] == no_polygon) grow(t);
  }

  ExactMesh run() {
    for (const CoplanarPieces& p : polygons_)
      for (const Numbers& ring : p.rings) beside_.add(ring);
    for (std::uint32_t v = 0; v < stays_.size(); ++v) stays_[v] = beside_.is_passed(v) && !is_straight(v);
    for (const CoplanarPieces& p : polygons_) add(p);
    return surface::mesh_in_order(mesh_.vertices, std::move(made_));
  }

 private:
  [[nodiscard]] const ExactPoint3& corner(std::uint32_t t, std::uint32_t k) const {
    return mesh_.vertices[mesh_.triangles[t][k]];
  }
  [[nodiscard]] Sign turn_along(std::uint32_t t, int axis) const {
    return orient2d(surface::shadow(corner(t, 0), axis), surface::shadow(corner(t, 1), axis),
                    surface::shadow(corner(t, 2), axis));
  }

  void look_at(CoplanarPieces& grown) const {
    const std::uint32_t t = grown.triangles[0];
    for (const int axis :
         surface::guessed_axes({approximate(corner(t, 0)), approximate(corner(t, 1)), approximate(corner(t, 2))})) {
      grown.axis = axis;
      grown.turn = turn_along(t, axis);
      if (grown.turn != Sign::zero) return;
    }
  }

  void grow(std::uint32_t seed) {
    CoplanarPieces grown{{seed}, 2, Sign::zero, {}};
    polygon_[seed] = static_cast<std::uint32_t>(polygons_.size());
    for (std::size_t i = 0; i < grown.triangles.size(); ++i) {
      for (std::uint32_t h = 3 * grown.triangles[i]; h < 3 * grown.triangles[i] + 3; ++h) {
        const std::uint32_t beyond = twin_[h];
        if (beyond == no_half_edge || polygon_[beyond / 3] != no_polygon) continue;
        const ExactPoint3& third = corner(beyond / 3, previous_half_edge(beyond) % 3);
        if (orient3d(corner(seed, 0), corner(seed, 1), corner(seed, 2), third) != Sign::zero) continue;
        if (grown.turn == Sign::zero) look_at(grown);
        if (grown.turn == Sign::zero || turn_along(beyond / 3, grown.axis) != grown.turn) continue;
        polygon_[beyond / 3] = polygon_[seed];
        grown.triangles.push_back(beyond / 3);
      }
    }
    grown.rings = rings_.of(grown.triangles);
    polygons_.push_back(std::move(grown));
  }

  /// The order of numbers is that of points along a line.
  [[nodiscard]] bool is_straight(std::uint32_t v) const {
    return beside_.is_straight(v, [this](std::uint32_t a, std::uint32_t p, std::uint32_t b) {
      return std::min(a, b) < p && p < std::max(a, b) &&
             collinear(mesh_.vertices[a], mesh_.vertices[p], mesh_.vertices[b]);
    });
  }

  void add(const CoplanarPieces& polygon) {
    SourceFace source = mesh_.sources[polygon.triangles[0]];
    for (const std::uint32_t t : polygon.triangles) source = std::min(source, mesh_.sources[t]);
    std::vector<Numbers> rings = polygon.rings;
    Numbers on_rings;
    for (Numbers& ring : rings) {
      std::erase_if(ring, [this](std::uint32_t v) { return !stays_[v]; });
      on_rings.insert(on_rings.end(), ring.begin(), ring.end());
    }
    const std::size_t corners = on_rings.size();
    std::ranges::sort(on_rings);
    on_rings.erase(std::unique(on_rings.begin(), on_rings.end()), on_rings.end());
    const Numbers vertices = kept_vertices(polygon);
    // Rings of n corners around n - 2 triangles would be one without holes; a vertex in the midst makes two more.
    const std::size_t fewest = corners + 2 * rings.size() - 4 + 2 * (vertices.size() - on_rings.size());
    if (fewest >= polygon.triangles.size()) {
      for (const std::uint32_t t : polygon.triangles) made_.emplace_back(mesh_.triangles[t], mesh_.sources[t]);
      return;
    }
    const std::size_t before = made_.size();
    triangulate(polygon, rings, vertices, source);
    if (made_.size() != before + fewest)
      throw InvalidShape("merge_pieces: triangles overlap in the plane of triangle " +
                         std::to_string(polygon.triangles[0]));
  }

  /// Those of its rings, and those that other polygons have in its midst.
  [[nodiscard]] Numbers kept_vertices(const CoplanarPieces& polygon) const {
    Numbers kept;
    for (const std::uint32_t t : polygon.triangles)
      for (const std::uint32_t v : mesh_.triangles[t])
        if (stays_[v]) kept.push_back(v);
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
  }

  void triangulate(const CoplanarPieces& polygon, const std::vector<Numbers>& rings, const Numbers& vertices,
                   const SourceFace& source) {
    std::vector<ExactPoint2> seen;
    for (const std::uint32_t v : vertices) seen.push_back(surface::shadow(mesh_.vertices[v], polygon.axis));
    const auto place = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, v) - vertices.begin());
    };
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const Numbers& ring : rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({place(ring[i]), place(ring[(i + 1) % ring.size()])});
    const auto wound = surface::wound_triangles(std::span<const ExactPoint2>(seen), edges);
    if (!wound) return;  // what crosses is told by the number of triangles
    for (const auto& [corners, winding] : *wound) {
      if (winding != (polygon.turn == Sign::positive ? 1 : -1)) continue;
      TriangleMesh::Triangle triangle{vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]};
      if (polygon.turn == Sign::negative) std::swap(triangle[1], triangle[2]);
      made_.emplace_back(triangle, source);
    }
  }

  const ExactMesh& mesh_;
  Numbers twin_, polygon_;  // of half-edges, of triangles
  surface::RegionRings rings_;
  surface::RingNeighbors beside_;
  std::vector<bool> stays_;  // of vertices
  std::vector<CoplanarPieces> polygons_;
  std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> made_;
};

}  // namespace

ExactMesh merge_pieces(const ExactMesh& mesh) {
  if (mesh.sources.size() != mesh.triangles.size())
    throw UnequalLengths("merge_pieces: there are " + std::to_string(mesh.sources.size()) + " sources of " +
                         std::to_string(mesh.triangles.size()) + " triangles; give one for each");
  return PieceMerger(mesh).run();
}

}  // namespace plumb
