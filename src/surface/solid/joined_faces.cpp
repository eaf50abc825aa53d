#include "surface/solid/joined_faces.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "plumb/surface/topology/adjacency.hpp"
#include "surface/solid/wound_triangles.hpp"
#include "surface/topology/region_rings.hpp"

namespace plumb::surface {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// A mesh uses a face so often, more often turned as the corners are than the other way around.
struct FaceOfMesh {
  std::uint32_t mesh;
  std::int32_t times;
  std::uint32_t source;
};

/// The faces of all meshes side by side, so that no two meshes have a vertex in common.
struct SeparateFaces {
  std::vector<FaceOfMesh> faces;
  TriangleMesh mesh;       // as the faces' meshes run; vertices are numbers alone
  Numbers number_in_pool;  // of vertices
};

SeparateFaces separate_faces(const FacePool& pool) {
  SeparateFaces made;
  std::vector<std::pair<FaceOfMesh, std::uint32_t>> found;
  for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
    const auto uses = pool.uses_of(f);
    for (std::size_t i = 0, next = 0; i < uses.size(); i = next) {
      std::int32_t times = 0;
      for (next = i; next < uses.size() && uses[next].face.mesh == uses[i].face.mesh; ++next)
        times += uses[next].opposite ? -1 : 1;
      if (times == 0) continue;
      const auto at = std::ranges::find(uses.subspan(i, next - i), times < 0, &FacetSource::opposite);
      found.push_back({{uses[i].face.mesh, std::abs(times), at->face.triangle}, 2 * f + (times < 0 ? 1U : 0U)});
    }
  }
  std::ranges::stable_sort(found, {}, [](const auto& row) { return row.first.mesh; });
  Numbers number(pool.mesh.vertices.size());
  std::vector<std::uint32_t> of_mesh(number.size(), pool.meshes);
  for (const auto& [face, turned_face] : found) {
    auto corners = pool.mesh.triangles[turned_face / 2];
    if (turned_face % 2 != 0) std::swap(corners[1], corners[2]);
    for (std::uint32_t& v : corners) {
      if (std::exchange(of_mesh[v], face.mesh) != face.mesh) {
        number[v] = static_cast<std::uint32_t>(made.number_in_pool.size());
        made.number_in_pool.push_back(v);
      }
      v = number[v];
    }
    made.faces.push_back(face);
    made.mesh.triangles.push_back(corners);
  }
  made.mesh.vertices.resize(made.number_in_pool.size());
  return made;
}

class FaceJoiner {
 public:
  explicit FaceJoiner(const FacePool& pool)
      : pool_(pool),
        all_(separate_faces(pool)),
        twin_(half_edges(all_.mesh, find_edges(all_.mesh)).twin),
        polygon_(all_.faces.size(), none),
        rings_(all_.mesh.triangles, twin_, polygon_),
        beside_(all_.mesh.vertices.size()),
        stays_(all_.mesh.vertices.size()) {}

  /// Nothing where no polygon has fewer triangles.
  std::vector<PooledTriangle> run() {
    for (std::uint32_t t = 0; t < polygon_.size(); ++t)
      if (polygon_[t] == none) grow(t);
    for (std::uint32_t v = 0; v < stays_.size(); ++v) stays_[v] = beside_.is_passed(v) && !is_straight(v);
    for (const Grown& polygon : grown_)
      if (!join(polygon)) keep(polygon.triangles);
    if (!is_joined_) return {};
    keep(alone_);
    return std::move(made_);
  }

 private:
  struct Grown {
    Numbers triangles;
    std::vector<Numbers> rings;
    int axis;
  };

  [[nodiscard]] TriangleMesh::Triangle in_pool(std::uint32_t t) const {
    const auto& [a, b, c] = all_.mesh.triangles[t];
    return {all_.number_in_pool[a], all_.number_in_pool[b], all_.number_in_pool[c]};
  }
  [[nodiscard]] Sign turn_along(std::uint32_t t, int axis) const {
    const auto [a, b, c] = in_pool(t);
    return points_.turn_along(axis, a, b, c);
  }

  void grow(std::uint32_t seed) {
    Grown grown{{seed}, {}, -1};
    const auto [a, b, c] = in_pool(seed);
    Sign turn = Sign::zero;
    polygon_[seed] = polygons_++;
    for (std::size_t i = 0; i < grown.triangles.size(); ++i) {
      for (std::uint32_t h = 3 * grown.triangles[i]; h < 3 * grown.triangles[i] + 3; ++h) {
        const std::uint32_t beyond = twin_[h];
        if (beyond == no_half_edge || polygon_[beyond / 3] != none) continue;
        const std::uint32_t third = all_.mesh.triangles[beyond / 3][previous_half_edge(beyond) % 3];
        if (points_.orient(a, b, c, all_.number_in_pool[third]) != Sign::zero) continue;
        if (all_.faces[beyond / 3].times != all_.faces[seed].times) continue;
        if (turn == Sign::zero) {
          for (const int axis : guessed_axes({points_.nearest(a), points_.nearest(b), points_.nearest(c)})) {
            grown.axis = axis;
            turn = turn_along(seed, axis);
            if (turn != Sign::zero) break;
          }
        }
        if (turn_along(beyond / 3, grown.axis) != turn) continue;
        polygon_[beyond / 3] = polygon_[seed];
        grown.triangles.push_back(beyond / 3);
      }
    }
    if (grown.triangles.size() == 1) {
      alone_.push_back(seed);
      beside_.add(all_.mesh.triangles[seed]);
      return;
    }
    grown.rings = rings_.of(grown.triangles);
    for (const Numbers& ring : grown.rings) beside_.add(ring);
    grown_.push_back(std::move(grown));
  }

  [[nodiscard]] bool is_straight(std::uint32_t v) const {
    return beside_.is_straight(v, [this](std::uint32_t a, std::uint32_t p, std::uint32_t b) {
      const auto& number = all_.number_in_pool;
      return points_.order(number[a], number[p]) == points_.order(number[p], number[b]) &&
             points_.is_straight(number[a], number[p], number[b]);
    });
  }

  void add(const TriangleMesh::Triangle& corners, const FaceOfMesh& face, std::int32_t times) {
    PooledTriangle row{corners, {{face.mesh, face.source}, false}};
    for (std::uint32_t& v : row.corners) v = all_.number_in_pool[v];
    const auto& [a, b, c] = row.corners;
    const bool ascends_as_it_turns = (a < b) + (b < c) + (c < a) == 2;
    row.source.opposite = ascends_as_it_turns != (times > 0);
    std::ranges::sort(row.corners);
    made_.insert(made_.end(), static_cast<std::size_t>(std::abs(times)), row);
  }
  void keep(const Numbers& triangles) {
    for (const std::uint32_t t : triangles) add(all_.mesh.triangles[t], all_.faces[t], all_.faces[t].times);
  }

  bool join(const Grown& polygon) {
    Numbers vertices;
    for (const Numbers& ring : polygon.rings)
      for (const std::uint32_t v : ring)
        if (stays_[v]) vertices.push_back(v);
    // So many triangles a polygon has whose rings pass each vertex once.
    if (vertices.size() + 2 * polygon.rings.size() >= polygon.triangles.size() + 4) return false;
    // As the pool's numbers ascend, whatever the order of meshes.
    std::ranges::sort(vertices, {}, [this](std::uint32_t v) { return all_.number_in_pool[v]; });
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) place_[vertices[i]] = i;
    Edges edges;
    for (Numbers ring : polygon.rings) {
      std::erase_if(ring, [this](std::uint32_t v) { return !stays_[v]; });
      for (std::size_t i = 0; i < ring.size(); ++i)
        edges.push_back({place_[ring[i]], place_[ring[(i + 1) % ring.size()]]});
    }
    const auto wound = wound_around(vertices, edges, polygon.axis);
    if (!wound || wound->size() >= polygon.triangles.size()) return false;
    FaceOfMesh face = all_.faces[polygon.triangles[0]];
    for (const std::uint32_t t : polygon.triangles) face.source = std::min(face.source, all_.faces[t].source);
    for (const auto& [corners, winding] : *wound)
      add({vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]}, face, winding * face.times);
    return is_joined_ = true;
  }

  using Edges = std::vector<std::array<std::uint32_t, 2>>;

  [[nodiscard]] std::optional<std::vector<WoundTriangle>> wound_around(const Numbers& vertices, const Edges& edges,
                                                                       int axis) const {
    if (std::ranges::all_of(vertices, [this](std::uint32_t v) { return points_.is_given(all_.number_in_pool[v]); })) {
      std::vector<Point2> seen;
      for (const std::uint32_t v : vertices) seen.push_back(shadow(points_.given[all_.number_in_pool[v]], axis));
      return wound_triangles(std::span<const Point2>(seen), edges);
    }
    std::vector<ExactPoint2> seen;
    for (const std::uint32_t v : vertices) seen.push_back(shadow(points_.at(all_.number_in_pool[v]), axis));
    return wound_triangles(std::span<const ExactPoint2>(seen), edges);
  }

  const FacePool& pool_;
  NumberedPoints points_ = pool_.points();
  SeparateFaces all_;
  Numbers twin_, polygon_;      // of half-edges, of triangles
  std::uint32_t polygons_ = 0;  // also those that are one triangle
  RegionRings rings_;
  RingNeighbors beside_;
  std::vector<bool> stays_;  // of vertices
  Numbers place_ = Numbers(all_.mesh.vertices.size());
  std::vector<Grown> grown_;
  Numbers alone_;
  std::vector<PooledTriangle> made_;
  bool is_joined_ = false;
};

}  // namespace

FacePool join_coplanar_faces(FacePool pool) {
  std::vector<PooledTriangle> joined = FaceJoiner(pool).run();
  if (joined.empty()) return pool;
  FacePool made;
  made.meshes = pool.meshes;
  made.sheets = pool.sheets;
  made.mesh.vertices = std::move(pool.mesh.vertices);
  made.held = std::move(pool.held);
  add_faces(made, std::move(joined));
  return made;
}

}  // namespace plumb::surface
