#include "surface/parts/cut_cell.hpp"

#include <algorithm>
#include <unordered_set>

#include "surface/parts/around_line.hpp"
#include "surface/parts/cut_section.hpp"
#include "surface/parts/rounded_box.hpp"

namespace plumb::surface {
namespace {

/// Halves of facets, and both sides of each part of the section, as they hang together.
class CutPieces {
 public:
  CutPieces(CutSpace& space, const CutCell& cell, const CellEdges& edges, std::uint32_t plane, CutSplitter& splitter,
            const CutSection& section)
      : space_(space),
        cell_(cell),
        edges_(edges),
        plane_(plane),
        splitter_(splitter),
        section_(section),
        sets_(2 * (cell.size() + section.parts)) {
    for (const SectionEdge& e : section.edges) {
      if (e.facet == no_triangle) continue;
      sets_.unite(half(e.facet, true), cap(e.part, true));
      sets_.unite(half(e.facet, false), cap(e.part, false));
    }
    for (const SectionEdge& e : section.edges)
      if (e.facet == no_triangle) part_at_[key(e.edge.from, e.edge.to)] = e.part;
    for (const WedgedEdge& e : edges.edges) join_at(e);
    join_cavities();
  }

  [[nodiscard]] std::uint32_t half(std::uint32_t facet, bool above) const { return 2 * facet + (above ? 0 : 1); }
  [[nodiscard]] std::uint32_t cap(std::uint32_t part, bool above) const {
    return half(static_cast<std::uint32_t>(cell_.size()) + part, above);
  }
  [[nodiscard]] std::uint32_t piece(std::uint32_t half) { return sets_.find(half); }
  [[nodiscard]] bool has(std::uint32_t facet, bool above) const {
    const SplitFacet& f = section_.facets[facet];
    return above ? f.has_above : f.has_below;
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  /// The facets of a wedge hang together on each side of the plane to which the edge reaches.
  void join_at(const WedgedEdge& e) {
    const Sign of_a = splitter_.side(e.a), of_b = splitter_.side(e.b);
    if (of_a == Sign::zero && of_b == Sign::zero) {
      for (const EdgeWedge& w : edges_.wedges_of(e)) join_in_plane(e, w);
      return;
    }
    for (const EdgeWedge& w : edges_.wedges_of(e)) {
      if (of_a == Sign::positive || of_b == Sign::positive) sets_.unite(half(w.facet, true), half(w.to_facet, true));
      if (of_a == Sign::negative || of_b == Sign::negative) sets_.unite(half(w.facet, false), half(w.to_facet, false));
    }
  }
  /// Half planes of the plane that are inside of the wedge part it; what they leave hangs together.
  void join_in_plane(const WedgedEdge& e, const EdgeWedge& w) {
    std::vector<EdgeRay> inside;
    for (const int side : {1, -1})
      if (is_inside(space_, w, {plane_, side})) inside.push_back({plane_, side});
    const AroundLine around(space_, w.from);
    std::ranges::sort(inside, [&](EdgeRay l, EdgeRay r) { return around.before(l, r); });
    // Counterclockwise of the half plane of side +1 is what lies above, where the normal points.
    if (inside.empty()) {
      const bool above = starts_above(w.from);
      sets_.unite(half(w.facet, above), half(w.to_facet, above));
      return;
    }
    const std::uint32_t part = part_at_.at(key(e.a, e.b));  // both sides of the edge hang together by its vertices
    const bool first_above = inside.front().side<0, last_above = inside.back().side> 0;
    sets_.unite(half(w.facet, first_above), cap(part, first_above));
    sets_.unite(half(w.to_facet, last_above), cap(part, last_above));
  }
  /// Does the wedge that begins there lie above the plane, where no half plane of it is inside?
  [[nodiscard]] bool starts_above(EdgeRay from) const {
    if (from.plane == plane_) return from.side > 0;
    return AroundLine(space_, {plane_, 1}).quarter(from) == 1;
  }
  /// A shell that lies in others is known by its facets: it stays with all whose boxes hold it.
  void join_cavities() {
    bool any = false;
    for (const CutFacet& f : cell_) any = any || f.of_cavity;
    if (!any) return;
    struct Piece {
      bool above = false, of_cavity = true;
      RoundedBox box;
    };
    std::unordered_map<std::uint32_t, Piece> pieces;
    for (std::uint32_t f = 0; f < cell_.size(); ++f) {
      for (const bool above : {true, false}) {
        if (!has(f, above)) continue;
        Piece& p = pieces[piece(half(f, above))];
        p.above = above, p.of_cavity = p.of_cavity && cell_[f].of_cavity;
        for (const CutEdge& e : above ? section_.facets[f].above : section_.facets[f].below) {
          p.box.add(space_.point(e.from));
          p.box.add(space_.point(e.to));
        }
      }
    }
    for (const SectionEdge& e : section_.edges)
      for (const bool above : {true, false})
        if (const auto at = pieces.find(piece(cap(e.part, above))); at != pieces.end()) at->second.of_cavity = false;
    for (const auto& [number, p] : pieces) {
      if (!p.of_cavity) continue;
      for (const auto& [other, q] : pieces)
        if (!q.of_cavity && p.above == q.above && q.box.holds(p.box)) sets_.unite(number, other);
    }
  }

  CutSpace& space_;
  const CutCell& cell_;
  const CellEdges& edges_;
  std::uint32_t plane_;
  CutSplitter& splitter_;
  const CutSection& section_;
  DisjointSets sets_;
  std::unordered_map<std::uint64_t, std::uint32_t> part_at_;  // edges of the cell in the plane
};

/// Pieces, and what of the section parts them: law 3.
class KeptParts {
 public:
  KeptParts(CutPieces& pieces, std::size_t halves, const CutSection& section, CutReach reach)
      : pieces_(pieces), cells_(halves), is_kept_(section.parts) {
    for (std::uint32_t p = 0; p < section.parts; ++p)
      is_kept_[p] = reach == CutReach::everywhere || section.is_needed[p] != 0;
    for (std::uint32_t p = 0; p < section.parts; ++p) {
      if (is_kept_[p]) continue;
      const std::uint32_t above = cell(pieces.cap(p, true)), below = cell(pieces.cap(p, false));
      if (parts_any(above, below)) {
        is_kept_[p] = true;
      } else {
        cells_.unite(above, below);
      }
    }
  }
  [[nodiscard]] std::uint32_t cell(std::uint32_t half) { return cells_.find(pieces_.piece(half)); }
  [[nodiscard]] bool is_kept(std::uint32_t part) const { return is_kept_[part]; }

 private:
  bool parts_any(std::uint32_t above, std::uint32_t below) {
    for (std::uint32_t p = 0; p < is_kept_.size(); ++p) {
      if (!is_kept_[p]) continue;
      const std::uint32_t a = cell(pieces_.cap(p, true)), b = cell(pieces_.cap(p, false));
      if ((a == above && b == below) || (a == below && b == above)) return true;
    }
    return false;
  }

  CutPieces& pieces_;
  DisjointSets cells_;
  std::vector<bool> is_kept_;
};

}  // namespace

std::vector<CutCell> cut_cell(CutSpace& space, CutCell cell, const CellEdges& edges, std::uint32_t plane,
                              CutReach reach) {
  CutSplitter splitter(space, cell, edges, plane);
  CutSection section = splitter.find();
  CutPieces pieces(space, cell, edges, plane, splitter, section);
  KeptParts kept(pieces, 2 * (cell.size() + section.parts), section, reach);

  std::unordered_map<std::uint32_t, std::uint32_t> number_of;
  std::vector<CutCell> cells;
  const auto cell_at = [&](std::uint32_t half) -> CutCell& {
    const auto [at, is_new] = number_of.try_emplace(kept.cell(half), static_cast<std::uint32_t>(cells.size()));
    if (is_new) cells.emplace_back();
    return cells[at->second];
  };
  const auto is_split = [&](std::uint32_t f) {
    return section.facets[f].has_above && section.facets[f].has_below &&
           kept.cell(pieces.half(f, true)) != kept.cell(pieces.half(f, false));
  };
  // Of facets that stay whole the edges that are cut with another facet are cut as well.
  std::unordered_set<std::uint32_t> cut_at;
  for (std::uint32_t f = 0; f < cell.size(); ++f) {
    if (!is_split(f)) continue;
    for (const std::uint32_t i : section.facets[f].closing)
      cut_at.insert(section.edges[i].edge.from), cut_at.insert(section.edges[i].edge.to);
  }
  for (std::uint32_t f = 0; f < cell.size(); ++f) {
    SplitFacet& halves = section.facets[f];
    const CutFacet& whole = cell[f];
    const auto like_it = [&](std::vector<CutEdge> of) {
      return CutFacet{whole.plane, whole.turned, whole.of_cavity, whole.triangle, std::move(of)};
    };
    if (is_split(f)) {
      for (const std::uint32_t i : halves.closing) {
        const CutEdge& e = section.edges[i].edge;
        halves.above.push_back({e.to, e.from, e.line});
        halves.below.push_back(e);
      }
      cell_at(pieces.half(f, true)).push_back(like_it(std::move(halves.above)));
      cell_at(pieces.half(f, false)).push_back(like_it(std::move(halves.below)));
      continue;
    }
    std::vector<CutEdge> all;
    for (const CutEdge& e : whole.edges) {
      const Sign from = splitter.side(e.from), to = splitter.side(e.to);
      if (from * to == Sign::negative) {
        if (const std::uint32_t at = space.meet(e.line, plane); cut_at.contains(at)) {
          all.push_back({e.from, at, e.line});
          all.push_back({at, e.to, e.line});
          continue;
        }
      }
      all.push_back(e);
    }
    cell_at(pieces.half(f, halves.has_above)).push_back(like_it(std::move(all)));
  }
  for (std::uint32_t p = 0; p < section.parts; ++p) {
    if (!kept.is_kept(p)) continue;
    CutFacet up{plane, true, false, no_triangle, {}}, down{plane, false, false, no_triangle, {}};
    for (const SectionEdge& e : section.edges) {
      if (e.part != p) continue;
      up.edges.push_back(e.edge);
      down.edges.push_back({e.edge.to, e.edge.from, e.edge.line});
    }
    cell_at(pieces.cap(p, true)).push_back(std::move(up));
    cell_at(pieces.cap(p, false)).push_back(std::move(down));
  }
  return cells;
}

}  // namespace plumb::surface
