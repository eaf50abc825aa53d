#include "world/clash_contact.hpp"

#include <algorithm>
#include <array>
#include <tuple>

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
      : parts_{&a, &b}, list_(list), table_(table), jumps_(list.facets.size()) {
    for (std::size_t f = 0; f < jumps_.size(); ++f)
      for (const surface::CoveringFace& by : list.covers_of(f))
        for (const FacetSource& use : pool.uses_of(by.face))
          jumps_[f][use.face.mesh] += parts_[use.face.mesh]->is_solid() && by.opposite != use.opposite ? -1 : 1;
  }

  Lying look() {
    surface::DisjointSets groups = joined();
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

  /// Facets of one alone that are connected apart from the other, and those of both that go on in one plane.
  surface::DisjointSets joined() {
    struct AtEdge {
      std::uint32_t a, b, facet;
    };
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
    surface::DisjointSets groups(jumps_.size());
    for (std::size_t i = 0, next = 0; i < at.size(); i = next) {
      int all = 0;
      for (next = i; next < at.size() && at[next].a == at[i].a && at[next].b == at[i].b; ++next)
        all |= owners(at[next].facet);
      const std::uint32_t first = at[i].facet, last = at[next - 1].facet;
      const bool flat = next - i == 2 && owners(first) == 3 && owners(last) == 3 &&
                        list_.plane_of[first] == list_.plane_of[last] && list_.plane_of[first] != surface::none &&
                        jumps_[first] == jumps_[last];
      if (all != 3 || flat)
        for (std::size_t k = i + 1; k < next; ++k) groups.unite(first, at[k].facet);
    }
    return groups;
  }

  [[nodiscard]] surface::LineFromFacet line_from(std::uint32_t f) const {
    const auto& [a, b, c] = list_.facets[f];
    return {{table_.point(a), table_.point(b), table_.point(c)}, list_.plane_of_facet(f, table_)};
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
  const FacetList& list_;
  const PointTable& table_;
  std::vector<std::array<int, 2>> jumps_;  // from above a facet to below, of each solid; of a sheet its triangles there
};

}  // namespace

Lying lying_at_contact(const ClashPart& a, const ClashPart& b, std::span<const TrianglePair> pairs) {
  const auto meshes = meeting_triangles(a, b, pairs);
  const FacePool pool = surface::pool_open_faces(meshes);
  PointTable table(pool.mesh.vertices);
  const auto classes = surface::find_plane_classes(pool, build_bvh(pool.mesh), table);
  const FacetList list = surface::divide_planes(pool, table, classes);
  return CutContact(a, b, pool, list, table).look();
}

}  // namespace plumb::world
