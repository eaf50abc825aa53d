// The edges of a cell, each with the wedges of the solid at it.
#include <algorithm>

#include "surface/parts/around_line.hpp"
#include "surface/parts/cut_cell.hpp"

namespace plumb::surface {
namespace {

struct EdgeSide {
  std::uint32_t low, high;  // by number, to bring together what belongs together
  std::uint32_t facet;
  bool upward;  // from low to high
  CutLine line;
};

struct SideAround {
  EdgeRay ray;
  bool opens;  // the solid is counterclockwise of it
  std::uint32_t facet;
};

class WedgeFinder {
 public:
  WedgeFinder(CutSpace& space, const CutCell& cell, CellEdges& found) : space_(space), cell_(cell), found_(found) {}

  void take(std::span<const EdgeSide> group) {
    const bool in_order = space_.before(group[0].low, group[0].high);
    around_.clear();
    for (const EdgeSide& s : group) {
      const CutFacet& facet = cell_[s.facet];
      const bool forward = s.upward == in_order;
      around_.push_back({{facet.plane, forward != facet.turned ? 1 : -1}, !forward, s.facet});
    }
    const std::array<std::uint32_t, 2> ends =
        in_order ? std::array{group[0].low, group[0].high} : std::array{group[0].high, group[0].low};
    if (!find_wedges()) {
      if (!found_.flaw) found_.flaw = ends;
      return;
    }
    found_.edges.push_back({ends[0], ends[1], group[0].line, first_, static_cast<std::uint32_t>(around_.size() / 2)});
  }

 private:
  bool find_wedges() {
    if (around_.size() % 2 != 0) return false;
    first_ = static_cast<std::uint32_t>(found_.wedges.size());
    const auto opening = std::ranges::find(around_, true, &SideAround::opens);
    if (opening == around_.end()) return false;
    std::iter_swap(around_.begin(), opening);
    if (around_.size() > 2) {
      // What closes a wedge comes before what opens the next in the same half plane: walls that touch.
      const AroundLine around(space_, around_[0].ray);
      std::sort(around_.begin() + 1, around_.end(), [&](const SideAround& l, const SideAround& r) {
        const bool l_last = around.quarter(l.ray) == 0 && !l.opens, r_last = around.quarter(r.ray) == 0 && !r.opens;
        if (l_last != r_last) return r_last;
        if (around.before(l.ray, r.ray)) return true;
        return !around.before(r.ray, l.ray) && !l.opens && r.opens;
      });
    }
    for (std::size_t i = 0; i < around_.size(); i += 2) {
      const SideAround &from = around_[i], &to = around_[i + 1];
      if (!from.opens || to.opens) return false;
      const bool notch = AroundLine(space_, from.ray).quarter(to.ray) == 3;
      found_.wedges.push_back({from.ray, to.ray, from.facet, to.facet, notch});
      if (notch) ++found_.notches;
    }
    return true;
  }

  CutSpace& space_;
  const CutCell& cell_;
  CellEdges& found_;
  std::vector<SideAround> around_;
  std::uint32_t first_ = 0;
};

}  // namespace

CellEdges edges_of(CutSpace& space, const CutCell& cell) {
  std::vector<EdgeSide> sides;
  for (std::uint32_t f = 0; f < cell.size(); ++f) {
    for (const CutEdge& e : cell[f].edges)
      sides.push_back({std::min(e.from, e.to), std::max(e.from, e.to), f, e.from < e.to, e.line});
  }
  std::ranges::sort(sides, [](const EdgeSide& l, const EdgeSide& r) {
    return std::tie(l.low, l.high, l.facet, l.upward) < std::tie(r.low, r.high, r.facet, r.upward);
  });
  CellEdges found;
  found.edges.reserve(sides.size() / 2);
  found.wedges.reserve(sides.size() / 2);
  WedgeFinder finder(space, cell, found);
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    finder.take(std::span(sides).subspan(i, end - i));
  }
  return found;
}

}  // namespace plumb::surface
