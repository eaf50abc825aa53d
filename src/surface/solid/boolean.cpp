#include "plumb/surface/solid/boolean.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "surface/solid/mesh_in_order.hpp"

namespace plumb {
namespace {

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

template <class Combine>
ExactMesh combined(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces, const Combine& combine) {
  const auto is_inside = [&](std::span<const std::int32_t> windings) {
    std::size_t inside = 0;
    for (const std::int32_t w : windings) inside += is_in(w, rule) ? 1 : 0;
    return combine(inside, !windings.empty() && is_in(windings[0], rule));
  };
  return solid_where(meshes, is_inside, pieces);
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

ExactMesh unite(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(meshes, rule, pieces, [](std::size_t inside, bool) { return inside != 0; });
}

ExactMesh intersect(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(meshes, rule, pieces,
                  [&](std::size_t inside, bool) { return inside != 0 && inside == meshes.size(); });
}

ExactMesh subtract(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(meshes, rule, pieces, [](std::size_t inside, bool in_first) { return in_first && inside == 1; });
}

ExactMesh symmetric_difference(std::span<const TriangleMesh> meshes, WindingRule rule, Pieces pieces) {
  return combined(meshes, rule, pieces, [](std::size_t inside, bool) { return inside % 2 != 0; });
}

ExactMesh unite(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return unite(std::vector{a, b}, rule, pieces);
}
ExactMesh intersect(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return intersect(std::vector{a, b}, rule, pieces);
}
ExactMesh subtract(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return subtract(std::vector{a, b}, rule, pieces);
}
ExactMesh symmetric_difference(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule, Pieces pieces) {
  return symmetric_difference(std::vector{a, b}, rule, pieces);
}

}  // namespace plumb
