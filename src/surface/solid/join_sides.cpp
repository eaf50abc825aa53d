// In which order do facets lie around an edge, and which of their sides look at one another?
//
// Source: Zhou et al. 2016, 3.3.
#include <algorithm>
#include <tuple>

#include "surface/solid/facet_list.hpp"
#include "surface/solid/sort_by_first.hpp"
#include "surface/topology/disjoint_sets.hpp"

namespace plumb::surface {
namespace {

struct FacetAtEdge {
  std::uint32_t a, b;  // a < b
  std::uint32_t facet, apex;
  bool forward;  // the facet goes from a to b
};

std::vector<FacetAtEdge> facets_at_edges(const FacetList& list, const PointTable& table) {
  std::vector<FacetAtEdge> at;
  at.reserve(3 * list.facets.size());
  for (std::uint32_t f = 0; f < list.facets.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = list.facets[f][k], to = list.facets[f][(k + 1) % 3];
      at.push_back({std::min(from, to), std::max(from, to), f, list.facets[f][(k + 2) % 3], from < to});
    }
  }
  sort_by_first(
      at, table.size(), [](const FacetAtEdge& f) { return f.a; },
      [](const FacetAtEdge& l, const FacetAtEdge& r) {
        return std::tie(l.a, l.b, l.facet) < std::tie(r.a, r.b, r.facet);
      });
  return at;
}

/// Turns counterclockwise about the direction from a to b, from one facet on.
class TurnAboutEdge {
 public:
  TurnAboutEdge(const FacetList& list, const PointTable& table, const FacetAtEdge& from)
      : list_(list), points_(table.points()), from_(from) {}

  [[nodiscard]] bool before(const FacetAtEdge& l, const FacetAtEdge& r) const {
    const int of_l = quarter(l), of_r = quarter(r);
    if (of_l != of_r) return of_l < of_r;
    return of_l % 2 == 1 && l.facet != r.facet && ahead(l, r) == Sign::positive;
  }

 private:
  /// 0 for the facet itself, 1 for what is less than half a turn ahead, 2 for the opposite one, 3 for the rest.
  [[nodiscard]] int quarter(const FacetAtEdge& f) const {
    if (f.facet == from_.facet) return 0;
    const Sign s = ahead(from_, f);
    return s == Sign::positive ? 1 : s == Sign::zero ? 2 : 3;
  }
  [[nodiscard]] Sign ahead(const FacetAtEdge& of, const FacetAtEdge& f) const {
    const std::uint32_t plane = list_.plane_of[of.facet];
    if (plane != none && plane == list_.plane_of[f.facet]) return Sign::zero;
    const Sign side = list_.plane_of_facet(of.facet).side(points_, f.apex);
    return of.forward ? side : -side;
  }

  const FacetList& list_;
  NumberedPoints points_;
  FacetAtEdge from_;
};

}  // namespace

SideSets join_sides(const FacetList& list, const PointTable& table) {
  DisjointSets sets(2 * list.facets.size());
  std::vector<FacetAtEdge> at = facets_at_edges(list, table);
  for (std::size_t i = 0, next = 0; i < at.size(); i = next) {
    for (next = i; next < at.size() && at[next].a == at[i].a && at[next].b == at[i].b;) ++next;
    const std::span<FacetAtEdge> around(at.data() + i, next - i);
    if (around.size() > 2) {
      const TurnAboutEdge turn(list, table, around[0]);
      std::sort(around.begin() + 1, around.end(),
                [&](const FacetAtEdge& l, const FacetAtEdge& r) { return turn.before(l, r); });
    }
    for (std::size_t k = 0; k < around.size(); ++k) {
      const FacetAtEdge &f = around[k], &g = around[(k + 1) % around.size()];
      sets.unite(f.forward ? above(f.facet) : below(f.facet), g.forward ? below(g.facet) : above(g.facet));
    }
  }
  SideSets result;
  result.of.resize(2 * list.facets.size());
  for (std::uint32_t s = 0; s < result.of.size(); ++s) {
    const std::uint32_t first = sets.find(s);  // the smallest of them
    result.of[s] = first == s ? result.count++ : result.of[first];
  }
  return result;
}

}  // namespace plumb::surface
