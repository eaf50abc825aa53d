#include "world/clash_solids.hpp"

#include <algorithm>

#include "surface/topology/disjoint_sets.hpp"

namespace plumb::world {
namespace {

enum class Part : unsigned char { first, second, first_alone, second_alone, both };

bool is_in(Part part, std::span<const std::int32_t> windings) {
  const bool a = windings[0] != 0, b = windings[1] != 0;
  switch (part) {
    case Part::first:
      return a;
    case Part::second:
      return b;
    case Part::first_alone:
      return a && !b;
    case Part::second_alone:
      return b && !a;
    case Part::both:
      return a && b;
  }
  return false;
}

std::vector<std::uint8_t> marked(const Arrangement& arrangement, Part part) {
  std::vector<std::uint8_t> marks(arrangement.regions());
  for (std::size_t r = 0; r < marks.size(); ++r) marks[r] = is_in(part, arrangement.windings_of(r)) ? 1 : 0;
  return marks;
}

bool any(const Arrangement& arrangement, Part part) {
  for (std::size_t r = 0; r < arrangement.regions(); ++r)
    if (is_in(part, arrangement.windings_of(r))) return true;
  return false;
}

std::size_t pieces_of(const Arrangement& arrangement, Part part) {
  return count_pieces(arrangement, marked(arrangement, part));
}

/// Its volume is that of the facets' pyramids; of those that turn inward negative.
struct Border {
  std::vector<TriangleMesh::Triangle> outward;
};

ExactMesh mesh_of(const Arrangement& arrangement, const Border& border) {
  std::vector<std::uint32_t> used;
  for (const auto& corners : border.outward) used.insert(used.end(), corners.begin(), corners.end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  ExactMesh mesh;
  for (const std::uint32_t v : used) mesh.vertices.push_back(arrangement.vertices[v]);
  for (TriangleMesh::Triangle corners : border.outward) {
    for (std::uint32_t& v : corners) v = static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

}  // namespace

std::size_t count_pieces(const Arrangement& arrangement, std::span<const std::uint8_t> is_in) {
  surface::DisjointSets sets(arrangement.regions());
  for (const FacetSides& s : arrangement.sides)
    if (is_in[s.above] != 0 && is_in[s.below] != 0) sets.unite(s.above, s.below);
  std::vector<Border> borders(arrangement.regions());
  for (std::size_t f = 0; f < arrangement.facets.size(); ++f) {
    const FacetSides& s = arrangement.sides[f];
    if ((is_in[s.above] != 0) == (is_in[s.below] != 0)) continue;
    TriangleMesh::Triangle corners = arrangement.facets[f];
    if (is_in[s.above] != 0) std::swap(corners[1], corners[2]);
    borders[sets.find(is_in[s.above] != 0 ? s.above : s.below)].outward.push_back(corners);
  }
  std::erase_if(borders, [](const Border& b) { return b.outward.empty(); });
  if (borders.size() < 2) return borders.size();
  // Regions do not know which others lie in the same cell.  The outer border of a piece encloses its hollows, so a set of
  // regions has a positive volume where that border is among theirs, and else none or that of hollows, which is negative.
  return static_cast<std::size_t>(std::ranges::count_if(
      borders, [&](const Border& b) { return exact_volume(mesh_of(arrangement, b)).sign() == Sign::positive; }));
}

void tell_solids_apart(const Arrangement& of_both, Clash& clash) {
  if (!any(of_both, Part::both)) {
    clash.kind = ClashKind::touching;
    return;
  }
  const bool a_is_within = !any(of_both, Part::first_alone), b_is_within = !any(of_both, Part::second_alone);
  if (a_is_within && b_is_within) {
    clash.kind = ClashKind::duplicate;
  } else if (a_is_within || b_is_within) {
    clash.kind = ClashKind::enclosed;
    clash.inner = a_is_within ? 0U : 1U;
  } else if (pieces_of(of_both, Part::first_alone) > pieces_of(of_both, Part::first) ||
             pieces_of(of_both, Part::second_alone) > pieces_of(of_both, Part::second)) {
    clash.kind = ClashKind::piercing;
  } else {
    clash.kind = ClashKind::overlapping;
  }
}

}  // namespace plumb::world
