#include "plumb/surface/solid/boolean.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "surface/solid/arranged.hpp"
#include "surface/solid/mesh_in_order.hpp"

namespace plumb {
namespace {

using surface::FacePool;

bool is_in(std::int32_t winding, WindingRule rule) {
  switch (rule) {
    case WindingRule::positive:
      return winding > 0;
    case WindingRule::nonzero:
      return winding != 0;
    default:
      return winding % 2 != 0;
  }
}

/// The first source that turns as the triangle does, if any does.
SourceFace source_of(std::span<const FacetSource> sources, bool opposite) {
  const auto at = std::ranges::find(sources, opposite, &FacetSource::opposite);
  return (at == sources.end() ? sources.front() : *at).face;
}

FacePool pool_of(std::span<const TriangleMesh> meshes) { return surface::pool_faces(meshes); }
FacePool pool_of(std::span<const ExactMesh* const> meshes) { return surface::pool_faces(meshes); }

/// An operation keeps a point by how many solids it is in, of so many, and whether it is in the first.
enum class Operation : unsigned char { unite, intersect, subtract, symmetric_difference };

bool is_kept_by(Operation operation, std::size_t inside, std::size_t count, bool in_first) {
  switch (operation) {
    case Operation::unite:
      return inside != 0;
    case Operation::intersect:
      return inside != 0 && inside == count;
    case Operation::subtract:
      return in_first && inside == 1;
    default:
      return inside % 2 != 0;
  }
}

template <class Mesh>
ExactMesh combined(Operation operation, std::span<Mesh> meshes, WindingRule rule, Pieces pieces) {
  const ExactMesh made =
      solid_where(surface::arranged(pool_of(meshes), pieces), [&](std::span<const std::int32_t> windings) {
        std::size_t inside = 0;
        for (const std::int32_t w : windings) inside += is_in(w, rule) ? 1 : 0;
        return is_kept_by(operation, inside, windings.size(), !windings.empty() && is_in(windings[0], rule));
      });
  return pieces == Pieces::of_polygons ? merge_pieces(made) : made;
}
ExactMesh combined(Operation operation, const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  const std::array both{a, b};
  return combined(operation, std::span<const TriangleMesh>(both), rule, pieces);
}
ExactMesh combined(Operation operation, const ExactMesh& a, const ExactMesh& b, WindingRule rule, Pieces pieces) {
  const std::array both{&a, &b};
  return combined(operation, std::span<const ExactMesh* const>(both), rule, pieces);
}
ExactMesh combined(Operation operation, std::span<const ExactMesh> meshes, WindingRule rule, Pieces pieces) {
  const auto all = surface::each_of(meshes);
  return combined(operation, std::span<const ExactMesh* const>(all), rule, pieces);
}

}  // namespace

ExactMesh solid_of(const Arrangement& arrangement, std::span<const std::uint8_t> is_solid) {
  if (is_solid.size() != arrangement.regions())
    throw UnequalLengths("solid_of: " + std::to_string(is_solid.size()) + " numbers are given, and there are " +
                         std::to_string(arrangement.regions()) + " regions; give one for each");
  std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> kept;
  for (std::size_t f = 0; f < arrangement.facets.size(); ++f) {
    const auto& [above, below] = arrangement.sides[f];
    if ((is_solid[above] != 0) == (is_solid[below] != 0)) continue;
    const bool turned = is_solid[above] != 0;
    auto corners = arrangement.facets[f];
    if (turned) std::swap(corners[1], corners[2]);
    kept.emplace_back(corners, source_of(arrangement.sources_of(f), turned));
  }
  return surface::mesh_in_order(arrangement.vertices, std::move(kept));
}

ExactMesh resolve(const TriangleMesh& mesh, WindingRule rule, Pieces pieces) {
  return unite(std::span(&mesh, 1), rule, pieces);
}
ExactMesh resolve(const ExactMesh& mesh, WindingRule rule, Pieces pieces) {
  return unite(std::span(&mesh, 1), rule, pieces);
}

ExactMesh unite(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, meshes, rule, pieces);
}
ExactMesh unite(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, a, b, rule, pieces);
}
ExactMesh unite(std::span<const ExactMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, meshes, rule, pieces);
}
ExactMesh unite(const ExactMesh& a, const ExactMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, a, b, rule, pieces);
}

ExactMesh intersect(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::intersect, meshes, rule, pieces);
}
ExactMesh intersect(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::intersect, a, b, rule, pieces);
}
ExactMesh intersect(std::span<const ExactMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::intersect, meshes, rule, pieces);
}
ExactMesh intersect(const ExactMesh& a, const ExactMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::intersect, a, b, rule, pieces);
}

ExactMesh subtract(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::subtract, meshes, rule, pieces);
}
ExactMesh subtract(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::subtract, a, b, rule, pieces);
}
ExactMesh subtract(std::span<const ExactMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::subtract, meshes, rule, pieces);
}
ExactMesh subtract(const ExactMesh& a, const ExactMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::subtract, a, b, rule, pieces);
}

ExactMesh symmetric_difference(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::symmetric_difference, meshes, rule, pieces);
}
ExactMesh symmetric_difference(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::symmetric_difference, a, b, rule, pieces);
}
ExactMesh symmetric_difference(std::span<const ExactMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(Operation::symmetric_difference, meshes, rule, pieces);
}
ExactMesh symmetric_difference(const ExactMesh& a, const ExactMesh& b, WindingRule rule, Pieces pieces) {
  return combined(Operation::symmetric_difference, a, b, rule, pieces);
}

}  // namespace plumb
