#include "world/clash_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/range/range_search.hpp"
#include "surface/solid/facet_list.hpp"
#include "surface/solid/line_from_facet.hpp"
#include "surface/topology/disjoint_sets.hpp"

namespace plumb::world {
namespace {

using surface::FacePool, surface::FacetList, surface::PointTable;

/// Those of its triangles; of a sheet each turned so that two in one place do not cancel one another.
TriangleMesh meeting_triangles(const ClashPart& part, std::vector<std::uint32_t> triangles) {
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<std::uint32_t> used;
  for (const std::uint32_t t : triangles)
    used.insert(used.end(), part.mesh().triangles[t].begin(), part.mesh().triangles[t].end());
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  TriangleMesh made;
  for (const std::uint32_t v : used) made.vertices.push_back(part.mesh().vertices[v]);
  const auto key = [&](std::uint32_t v) {
    return std::tie(made.vertices[v].x, made.vertices[v].y, made.vertices[v].z);
  };
  for (const std::uint32_t t : triangles) {
    TriangleMesh::Triangle corners = part.mesh().triangles[t];
    for (std::uint32_t& v : corners) v = static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
    if (!part.is_solid()) std::ranges::sort(corners, [&](std::uint32_t l, std::uint32_t r) { return key(l) < key(r); });
    made.triangles.push_back(corners);
  }
  return made;
}

std::array<TriangleMesh, 2> meeting_triangles(const ClashPart& a, const ClashPart& b,
                                              std::span<const TrianglePair> pairs) {
  std::vector<std::uint32_t> of_a, of_b;
  for (const TrianglePair& p : pairs) {
    if (of_a.empty() || of_a.back() != p.a) of_a.push_back(p.a);
    of_b.push_back(p.b);
  }
  return {meeting_triangles(a, std::move(of_a)), meeting_triangles(b, std::move(of_b))};
}

class CutContact {
 public:
  CutContact(const ClashPart& a, const ClashPart& b, const FacePool& pool, const FacetList& list,
             const PointTable& table)
      : parts_{&a, &b}, pool_(pool), list_(list), table_(table), jumps_(list.facets.size()) {
    for (std::size_t f = 0; f < jumps_.size(); ++f)
      for (const surface::CoveringFace& by : list.covers_of(f))
        for (const FacetSource& use : pool.uses_of(by.face))
          jumps_[f][use.face.mesh] += parts_[use.face.mesh]->is_solid() && by.opposite != use.opposite ? -1 : 1;
  }

  /// Does what common_of_one_piece_each does; `met` are the triangles of each part that meet the other.
  [[nodiscard]] std::optional<InCommon> common_of_one_piece_each(const std::array<std::vector<std::uint32_t>, 2>& met,
                                                                 bool gather) const {
    for (std::uint32_t f = 0; f < jumps_.size(); ++f)
      if (owners(f) == 3) return {};
    const std::vector<AtEdge> edges = facets_at_edges();
    surface::DisjointSets groups =
        joined(edges, jumps_.size() + parts_[0]->mesh().triangles.size() + parts_[1]->mesh().triangles.size());
    join_uncut(met, groups);
    std::map<std::uint32_t, bool> is_in;  // each group of facets: in the other part
    bool any_in = false;
    for (std::uint32_t f = 0; f < jumps_.size(); ++f) {
      if (owners(f) == 0) continue;
      const auto [at, is_new] = is_in.try_emplace(groups.find(f), false);
      if (is_new) at->second = winding(line_from(f), owners(f) == 1 ? 1 : 0) != 0;
      any_in |= at->second;
    }
    if (!any_in) return {};
    for (const int whole : {1, 2}) {  // of whom the rest is looked at
      const auto borders = [&](std::uint32_t f) { return is_in.at(groups.find(f)) != (owners(f) == whole); };
      surface::DisjointSets rest = groups;
      bool plain = true;
      for_edges(edges, [&](std::span<const AtEdge> here, int all) {
        if (all != 3) return;
        std::vector<std::uint32_t> around;
        for (const AtEdge& e : here)
          if (borders(e.facet)) around.push_back(e.facet);
        if (around.size() == 2) rest.unite(around[0], around[1]);
        plain = plain && (around.empty() || around.size() == 2);
      });
      std::set<std::uint32_t> pieces;
      for (std::uint32_t f = 0; f < jumps_.size(); ++f)
        if (owners(f) != 0 && borders(f)) pieces.insert(rest.find(f));
      if (!plain || pieces.size() != 1) return {};
    }
    return gather ? common(met, groups, is_in) : InCommon{};
  }

  Lying look() {
    surface::DisjointSets groups = joined(facets_at_edges(), jumps_.size());
    Lying found;
    for (std::uint32_t f = 0; f < jumps_.size(); ++f) {
      if (groups.find(f) != f) continue;
      const bool of_a = jumps_[f][0] != 0, of_b = jumps_[f][1] != 0;
      if (of_a && of_b) {
        found.same_side = found.same_side || both_on_one_side(f);
      } else if (of_a && parts_[1]->is_solid()) {
        (winding(line_from(f), 1) != 0 ? found.a_in_b : found.a_off_b) = true;
      } else if (of_b && parts_[0]->is_solid()) {
        (winding(line_from(f), 0) != 0 ? found.b_in_a : found.b_off_a) = true;
      }
    }
    return found;
  }

 private:
  /// Who has the facet: a, b or both; what cancels is nobody's.
  [[nodiscard]] int owners(std::uint32_t f) const { return (jumps_[f][0] != 0 ? 1 : 0) | (jumps_[f][1] != 0 ? 2 : 0); }

  struct AtEdge {
    std::uint32_t a, b, facet;
  };
  /// Facets of anybody at each edge, one edge after the other.
  [[nodiscard]] std::vector<AtEdge> facets_at_edges() const {
    std::vector<AtEdge> at;
    for (std::uint32_t f = 0; f < jumps_.size(); ++f) {
      if (owners(f) == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = list_.facets[f][k], to = list_.facets[f][(k + 1) % 3];
        at.push_back({std::min(from, to), std::max(from, to), f});
      }
    }
    std::ranges::sort(
        at, [](const AtEdge& l, const AtEdge& r) { return std::tie(l.a, l.b, l.facet) < std::tie(r.a, r.b, r.facet); });
    return at;
  }
  /// The work is given the facets at an edge, and who has any of them.
  template <class Work>
  void for_edges(std::span<const AtEdge> at, const Work& work) const {
    for (std::size_t i = 0, next = 0; i < at.size(); i = next) {
      int all = 0;
      for (next = i; next < at.size() && at[next].a == at[i].a && at[next].b == at[i].b; ++next)
        all |= owners(at[next].facet);
      work(at.subspan(i, next - i), all);
    }
  }

  /// Facets of one alone that are connected apart from the other, and those of both that go on in one plane.
  [[nodiscard]] surface::DisjointSets joined(std::span<const AtEdge> edges, std::size_t nodes) const {
    surface::DisjointSets groups(nodes);
    for_edges(edges, [&](std::span<const AtEdge> here, int all) {
      const std::uint32_t first = here.front().facet, last = here.back().facet;
      const bool flat = here.size() == 2 && owners(first) == 3 && owners(last) == 3 &&
                        list_.plane_of[first] == list_.plane_of[last] && list_.plane_of[first] != surface::none &&
                        jumps_[first] == jumps_[last];
      if (all != 3 || flat)
        for (const AtEdge& other : here) groups.unite(first, other.facet);
    });
    return groups;
  }

  /// Nodes are facets, and behind them the triangles of both parts: those that nothing cuts are united with their neighbors.
  void join_uncut(const std::array<std::vector<std::uint32_t>, 2>& met, surface::DisjointSets& groups) const {
    const auto facets = static_cast<std::uint32_t>(jumps_.size());
    std::array<std::uint32_t, 2> first{facets, facets};
    first[1] += static_cast<std::uint32_t>(parts_[0]->mesh().triangles.size());
    std::array<std::vector<std::uint8_t>, 2> is_met;
    for (std::size_t part = 0; part < 2; ++part) {
      is_met[part].resize(parts_[part]->mesh().triangles.size());
      for (const std::uint32_t t : met[part]) is_met[part][t] = 1;
      for (std::uint32_t t = 0; t < is_met[part].size(); ++t)
        for (const std::uint32_t n : parts_[part]->neighbors()[t])
          if (is_met[part][t] == 0 && is_met[part][n] == 0) groups.unite(first[part] + t, first[part] + n);
    }
    // An edge to a triangle that does not meet the other part is whole, so it is that of a facet.
    for (std::uint32_t f = 0; f < facets; ++f) {
      const auto covers = list_.covers_of(f);
      if (owners(f) == 0 || covers.empty()) continue;
      const SourceFace from = pool_.uses_of(covers.front().face).front().face;
      const std::uint32_t t = met[from.mesh][from.triangle];
      const TriangleMesh& mesh = parts_[from.mesh]->mesh();
      const auto corner_at = [&](std::uint32_t point) -> std::optional<std::size_t> {
        for (std::size_t k = 0; k < 3; ++k)
          if (table_.is_given(point) && mesh.vertices[mesh.triangles[t][k]] == table_.given(point)) return k;
        return {};
      };
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = corner_at(list_.facets[f][k]), j = corner_at(list_.facets[f][(k + 1) % 3]);
        if (!i || !j) continue;
        const std::size_t edge = (*i + 1) % 3 == *j ? *i : *j;
        const std::uint32_t n = parts_[from.mesh]->neighbors()[t][edge];
        if (is_met[from.mesh][n] == 0) groups.unite(f, first[from.mesh] + n);
      }
    }
  }

  /// Facets of each part in the other, and its triangles that nothing cuts and that are joined to such.
  [[nodiscard]] std::optional<InCommon> common(const std::array<std::vector<std::uint32_t>, 2>& met,
                                               surface::DisjointSets& groups,
                                               const std::map<std::uint32_t, bool>& is_in) const {
    InCommon made;
    const auto add = [&](std::size_t part, std::span<const ExactPoint3, 3> corners, bool turned) {
      const auto first = static_cast<std::uint32_t>(made.border.vertices.size());
      for (const ExactPoint3& p : corners) {
        made.border.vertices.push_back(p);
        if (const auto* given = std::get_if<Point3>(&p.as())) made.corners[part].push_back(*given);
      }
      made.border.triangles.push_back({first, first + (turned ? 2 : 1), first + (turned ? 1 : 2)});
    };
    std::array<bool, 2> inward{};
    for (std::size_t part = 0; part < 2; ++part) {
      const double size = parts_[part]->hull().volume_of_part;
      if (size == 0) return {};  // below all doubles, so that its sign is not told
      inward[part] = std::signbit(size);
    }
    const auto facets = static_cast<std::uint32_t>(jumps_.size());
    for (std::uint32_t f = 0; f < facets; ++f) {
      if (owners(f) == 0 || !is_in.at(groups.find(f))) continue;
      const std::size_t part = owners(f) == 1 ? 0 : 1;
      const auto& [a, b, c] = list_.facets[f];
      const surface::NumberedPoints points = table_.points();
      add(part, std::array<ExactPoint3, 3>{points.at(a), points.at(b), points.at(c)},
          (jumps_[f][part] < 0) != inward[part]);
    }
    std::uint32_t node = facets;
    for (std::size_t part = 0; part < 2; ++part) {
      const TriangleMesh& mesh = parts_[part]->mesh();
      std::size_t next_met = 0;
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t, ++node) {
        if (next_met < met[part].size() && met[part][next_met] == t) {
          ++next_met;
          continue;
        }
        const auto at = is_in.find(groups.find(node));
        if (at == is_in.end()) return {};
        if (!at->second) continue;
        const auto& [a, b, c] = mesh.triangles[t];
        add(part,
            std::array<ExactPoint3, 3>{ExactPoint3(mesh.vertices[a]), ExactPoint3(mesh.vertices[b]),
                                       ExactPoint3(mesh.vertices[c])},
            inward[part]);
      }
    }
    for (std::vector<Point3>& corners : made.corners) {
      const auto key = [](const Point3& p) { return std::tie(p.x, p.y, p.z); };
      std::ranges::sort(corners, [&](const Point3& l, const Point3& r) { return key(l) < key(r); });
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    }
    return made;
  }

  [[nodiscard]] surface::LineFromFacet line_from(std::uint32_t f) const {
    return {table_.points(), list_.facets[f], list_.plane_of_facet(f)};
  }

  /// Of the part around what the line starts in.
  [[nodiscard]] int winding(const surface::LineFromFacet& line, std::size_t part) const {
    const TriangleMesh& mesh = parts_[part]->mesh();
    int sum = 0;
    for (const std::uint32_t t : meeting(parts_[part]->bvh(), line.box())) {
      const auto& [a, b, c] = mesh.triangles[t];
      sum += line.winding_of({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    }
    return sum;
  }

  [[nodiscard]] bool both_on_one_side(std::uint32_t f) const {
    if (!parts_[0]->is_solid() || !parts_[1]->is_solid()) return false;
    const surface::LineFromFacet line = line_from(f);
    std::array<bool, 2> here{}, beyond{};
    for (std::size_t part = 0; part < 2; ++part) {
      const int start = winding(line, part);
      here[part] = start != 0;
      beyond[part] = start + (line.starts_above() ? jumps_[f][part] : -jumps_[f][part]) != 0;
    }
    return (here[0] && here[1]) || (beyond[0] && beyond[1]);
  }

  std::array<const ClashPart*, 2> parts_;
  const FacePool& pool_;
  const FacetList& list_;
  const PointTable& table_;
  std::vector<std::array<int, 2>> jumps_;  // from above a facet to below, of each solid; of a sheet its triangles there
};

template <class Work>
auto with_cut_contact(const ClashPart& a, const ClashPart& b, std::span<const TrianglePair> pairs, const Work& work) {
  const auto meshes = meeting_triangles(a, b, pairs);
  const FacePool pool = surface::pool_open_faces(meshes);
  PointTable table(pool.mesh.vertices);
  const auto classes = surface::find_plane_classes(pool, build_bvh(pool.mesh), table);
  const FacetList list = surface::divide_planes(pool, table, classes);
  CutContact cut(a, b, pool, list, table);
  return work(cut);
}

}  // namespace

std::optional<InCommon> common_of_one_piece_each(const ClashPart& a, const ClashPart& b,
                                                 std::span<const TrianglePair> pairs, bool gather) {
  std::array<std::vector<std::uint32_t>, 2> met;
  for (const TrianglePair& p : pairs) met[0].push_back(p.a), met[1].push_back(p.b);
  for (std::vector<std::uint32_t>& triangles : met) {
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  }
  return with_cut_contact(a, b, pairs, [&](CutContact& cut) { return cut.common_of_one_piece_each(met, gather); });
}

Lying lying_at_contact(const ClashPart& a, const ClashPart& b, std::span<const TrianglePair> pairs) {
  return with_cut_contact(a, b, pairs, [](CutContact& cut) { return cut.look(); });
}

}  // namespace plumb::world
