#include "plumb/surface/solid/boolean.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "plumb/arith/error.hpp"
#include "surface/solid/arranged.hpp"
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

using KeptFacets = std::vector<std::pair<TriangleMesh::Triangle, SourceFace>>;

/// Facets with different answers on their sides, turned outward.
KeptFacets kept_facets(const Arrangement& arrangement, std::span<const std::uint8_t> is_solid) {
  KeptFacets kept;
  for (std::size_t f = 0; f < arrangement.facets.size(); ++f) {
    const auto& [above, below] = arrangement.sides[f];
    if ((is_solid[above] != 0) == (is_solid[below] != 0)) continue;
    const bool turned = is_solid[above] != 0;
    auto corners = arrangement.facets[f];
    if (turned) std::swap(corners[1], corners[2]);
    kept.emplace_back(corners, source_of(arrangement.sources_of(f), turned));
  }
  return kept;
}

template <class Mesh>
ExactMesh combined(Operation operation, const std::vector<const Mesh*>& meshes, WindingRule rule, Pieces pieces) {
  Arrangement all = surface::arranged(surface::pool_faces(meshes), pieces);
  std::vector<std::uint8_t> is_solid(all.regions());
  for (std::size_t r = 0; r < is_solid.size(); ++r) {
    const auto windings = all.windings_of(r);
    const auto inside =
        static_cast<std::size_t>(std::ranges::count_if(windings, [&](std::int32_t w) { return is_in(w, rule); }));
    is_solid[r] = is_kept_by(operation, inside, windings.size(), !windings.empty() && is_in(windings[0], rule)) ? 1 : 0;
  }
  KeptFacets kept = kept_facets(all, is_solid);
  ExactMesh made = surface::mesh_in_order(std::move(all.vertices), std::move(kept));
  if (pieces == Pieces::of_polygons) return merge_pieces(made);
  return made;
}

}  // namespace

ExactMesh solid_of(const Arrangement& arrangement, std::span<const std::uint8_t> is_solid) {
  if (is_solid.size() != arrangement.regions())
    throw UnequalLengths("solid_of: " + std::to_string(is_solid.size()) + " numbers are given, and there are " +
                         std::to_string(arrangement.regions()) + " regions; give one for each");
  return surface::mesh_in_order(arrangement.vertices, kept_facets(arrangement, is_solid));
}

ExactMesh resolve(const TriangleMesh& mesh, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, std::vector{&mesh}, rule, pieces);
}
ExactMesh resolve(const ExactMesh& mesh, WindingRule rule, Pieces pieces) {
  return combined(Operation::unite, std::vector{&mesh}, rule, pieces);
}

// Each operation takes two meshes or many, as they are given or exact.
#define PLUMB_OPERATION_OF(Mesh, operation)                                            \
  ExactMesh operation(std::span<const Mesh> meshes, WindingRule rule, Pieces pieces) { \
    return combined(Operation::operation, surface::each_of(meshes), rule, pieces);     \
  }                                                                                    \
  ExactMesh operation(const Mesh& a, const Mesh& b, WindingRule rule, Pieces pieces) { \
    return combined(Operation::operation, std::vector{&a, &b}, rule, pieces);          \
  }
#define PLUMB_SOLID_OPERATION(operation)      \
  PLUMB_OPERATION_OF(TriangleMesh, operation) \
  PLUMB_OPERATION_OF(ExactMesh, operation)

PLUMB_SOLID_OPERATION(unite)
PLUMB_SOLID_OPERATION(intersect)
PLUMB_SOLID_OPERATION(subtract)
PLUMB_SOLID_OPERATION(symmetric_difference)

#undef PLUMB_SOLID_OPERATION
#undef PLUMB_OPERATION_OF

}  // namespace plumb
