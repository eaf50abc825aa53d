#include "surface/parts/cut_section.hpp"

#include <algorithm>
#include <map>

#include "surface/parts/around_line.hpp"
#include "surface/parts/rounded_box.hpp"

namespace plumb::surface {
namespace {

/// The line that two planes have in common.
CutLine line_of(std::uint32_t plane, std::uint32_t other) {
  return {std::min(plane, other), std::max(plane, other), true};
}

}  // namespace

CutSplitter::CutSplitter(CutSpace& space, const CutCell& cell, const CellEdges& edges, std::uint32_t plane)
    : space_(space), cell_(cell), edges_(edges), plane_(plane) {}

Sign CutSplitter::side(std::uint32_t vertex) {
  const auto [at, is_new] = side_of_.try_emplace(vertex, Sign::zero);
  if (is_new) at->second = space_.side(vertex, plane_);
  return at->second;
}

CutSection CutSplitter::find() {
  found_.facets.resize(cell_.size());
  for (std::uint32_t f = 0; f < cell_.size(); ++f) split(f);
  take_edges_in_plane();
  find_parts();
  return std::move(found_);
}

void CutSplitter::split(std::uint32_t facet) {
  const CutFacet& f = cell_[facet];
  SplitFacet& halves = found_.facets[facet];
  if (f.plane == plane_) {
    (f.turned ? halves.has_above : halves.has_below) = true;
    (f.turned ? halves.above : halves.below) = f.edges;
    return;
  }
  for (const CutEdge& e : f.edges) split_edge(f, e, halves);
  halves.has_above = !halves.above.empty(), halves.has_below = !halves.below.empty();
  if (halves.has_above && halves.has_below) close(facet);
}

void CutSplitter::split_edge(const CutFacet& facet, const CutEdge& edge, SplitFacet& halves) {
  const Sign from = side(edge.from), to = side(edge.to);
  if (from == Sign::zero && to == Sign::zero) {
    const bool forward = space_.before(edge.from, edge.to);
    const bool above = ((space_.bend(plane_, facet.plane) > 0) == forward) != facet.turned;
    (above ? halves.above : halves.below).push_back(edge);
  } else if (from != Sign::negative && to != Sign::negative) {
    halves.above.push_back(edge);
  } else if (from != Sign::positive && to != Sign::positive) {
    halves.below.push_back(edge);
  } else {
    const std::uint32_t at = space_.meet(edge.line, plane_);
    side_of_[at] = Sign::zero;
    (from == Sign::positive ? halves.above : halves.below).push_back({edge.from, at, edge.line});
    (to == Sign::positive ? halves.above : halves.below).push_back({at, edge.to, edge.line});
  }
}

// A chain of edges around an area goes as often into a vertex as out of it: what is missing in the plane is its line.
void CutSplitter::close(std::uint32_t facet) {
  SplitFacet& halves = found_.facets[facet];
  std::vector<std::pair<std::uint32_t, int>> missing;  // how often an edge must leave the vertex
  const auto count = [&](std::uint32_t v, int times) {
    if (side(v) != Sign::zero) return;
    const auto at = std::ranges::find(missing, v, &std::pair<std::uint32_t, int>::first);
    if (at == missing.end()) {
      missing.emplace_back(v, times);
    } else {
      at->second += times;
    }
  };
  for (const CutEdge& e : halves.above) count(e.from, -1), count(e.to, 1);
  std::ranges::sort(missing, [&](const auto& l, const auto& r) { return space_.before(l.first, r.first); });
  const CutLine line = line_of(plane_, cell_[facet].plane);
  int flow = 0;
  for (std::size_t i = 0; i + 1 < missing.size(); ++i) {
    flow += missing[i].second;
    const std::uint32_t a = missing[i].first, b = missing[i + 1].first;
    for (int k = 0; k < std::abs(flow); ++k) {
      halves.closing.push_back(static_cast<std::uint32_t>(found_.edges.size()));
      // The facet's half above runs one way, the section the other.
      found_.edges.push_back(
          {.edge = flow > 0 ? CutEdge{b, a, line} : CutEdge{a, b, line}, .at_notch = false, .facet = facet});
    }
  }
}

void CutSplitter::take_edges_in_plane() {
  for (const WedgedEdge& e : edges_.edges) {
    if (side(e.a) != Sign::zero || side(e.b) != Sign::zero) continue;
    for (const int side : {1, -1}) {
      for (const EdgeWedge& wedge : edges_.wedges_of(e)) {
        if (!is_inside(space_, wedge, {plane_, side})) continue;
        found_.edges.push_back(
            {.edge = side < 0 ? CutEdge{e.a, e.b, e.line} : CutEdge{e.b, e.a, e.line}, .at_notch = wedge.is_notch});
      }
    }
  }
}

void CutSplitter::find_parts() {
  std::unordered_map<std::uint32_t, std::uint32_t> number_of;
  for (const SectionEdge& e : found_.edges) {
    number_of.try_emplace(e.edge.from, static_cast<std::uint32_t>(number_of.size()));
    number_of.try_emplace(e.edge.to, static_cast<std::uint32_t>(number_of.size()));
  }
  DisjointSets sets(number_of.size());
  for (const SectionEdge& e : found_.edges) sets.unite(number_of[e.edge.from], number_of[e.edge.to]);
  std::map<std::uint32_t, RoundedBox> boxes;  // of what hangs together by vertices
  for (const auto& [vertex, number] : number_of) boxes[sets.find(number)].add(space_.point(vertex));
  for (auto i = boxes.begin(); i != boxes.end(); ++i)
    for (auto k = std::next(i); k != boxes.end(); ++k)
      if (i->second.holds(k->second) || k->second.holds(i->second)) sets.unite(i->first, k->first);
  std::map<std::uint32_t, std::uint32_t> part_of;
  for (SectionEdge& e : found_.edges) {
    const std::uint32_t set = sets.find(number_of[e.edge.from]);
    e.part = part_of.try_emplace(set, static_cast<std::uint32_t>(part_of.size())).first->second;
  }
  found_.parts = static_cast<std::uint32_t>(part_of.size());
  found_.is_needed.assign(found_.parts, 0);
  for (const SectionEdge& e : found_.edges)
    if (e.at_notch) found_.is_needed[e.part] = 1;
}

}  // namespace plumb::surface
