#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull2_steps.hpp"

namespace plumb {
namespace {

using figure::hull2::Indexed;

bool less(const Indexed& a, const Indexed& b) { return a.p.x < b.p.x || (a.p.x == b.p.x && a.p.y < b.p.y); }

/// Is the point one of the two, or, on their segment, not named?  Equal points are named by their smallest index.
bool may_be_on(const Indexed& p, const Indexed& a, const Indexed& b, bool all_boundary_points) {
  for (const Indexed* end : {&a, &b}) {
    if (p.p == end->p) return p.index >= end->index;
  }
  return !all_boundary_points;
}

/// A chain from a lexicographically smallest to a largest vertex, strictly ascending.
bool ascends(std::span<const Indexed> chain) {
  return std::ranges::adjacent_find(chain, [](const Indexed& a, const Indexed& b) { return !less(a, b); }) ==
         chain.end();
}

/// On the segment of the chain under or over p, or on the inner side of it; `side` is that of the chain.
bool within(std::span<const Indexed> chain, const Indexed& p, Sign inner, bool all_boundary_points) {
  const auto next = std::ranges::upper_bound(chain, p, less);  // the first vertex beyond p
  if (next == chain.begin()) return false;
  if (next == chain.end()) return p.p == chain.back().p && p.index >= chain.back().index;
  const Indexed &a = *(next - 1), &b = *next;
  const Sign s = figure::hull2::turn(a, b, p);
  return s == Sign::zero ? may_be_on(p, a, b, all_boundary_points) : s == inner;
}

std::string named(const char* what, std::size_t i) { return std::string(what).append(" ").append(std::to_string(i)); }

std::string not_within(std::uint32_t i) {
  return named("point", i).append(" is outside, or on the boundary or equal to a vertex and not named");
}

/// Of one vertex or none.
std::string flaw_of_few(const Hull2& hull, std::span<const Point2> points, std::span<const Indexed> corner) {
  if (hull.dimension != static_cast<int>(corner.size()) - 1)
    return named("the dimension is not", corner.size()).append(" less one");
  if (corner.empty()) return points.empty() ? "" : "there are points, and no vertices";
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!(points[i] == corner[0].p) || i < corner[0].index) return not_within(i);
  }
  return {};
}

std::string flaw_of(const Hull2& hull, std::span<const Point2> points, bool all) {
  const std::size_t h = hull.vertices.size();
  std::vector<Indexed> corner;
  for (const std::uint32_t i : hull.vertices) {
    if (i >= points.size()) return named("there is no point", i);
    corner.push_back({points[i], i});
  }
  if (h < 2) return flaw_of_few(hull, points, corner);
  // The first vertex is the smallest, and the way around goes up to the largest and down again, once.
  const auto top = std::ranges::max_element(corner, less);
  const std::vector<Indexed> lower(corner.begin(), top + 1);
  std::vector<Indexed> upper(top, corner.end());
  upper.push_back(corner[0]);
  std::ranges::reverse(upper);
  if (!ascends(lower) || !ascends(upper)) return "the vertices do not go around once from the smallest";
  const bool flat = hull.dimension == 1;
  if (flat ? upper.size() != 2 || (!all && h != 2) : hull.dimension != 2 || h < 3)
    return "the dimension is not that of so many vertices";
  bool turns = false;
  for (std::size_t i = 0; i < (flat ? h - 2 : h); ++i) {
    const Sign s = figure::hull2::turn(corner[i], corner[(i + 1) % h], corner[(i + 2) % h]);
    if (s == Sign::negative || (s == Sign::zero && !all) || (s != Sign::zero && flat))
      return named("the hull is not convex at vertex", hull.vertices[(i + 1) % h]);
    turns = turns || s == Sign::positive;
  }
  if (turns == flat) return "the dimension is not that of the vertices";
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Indexed p{points[i], i};
    const bool holds = flat ? within(lower, p, Sign::zero, all)
                            : within(lower, p, Sign::positive, all) && within(upper, p, Sign::negative, all);
    if (!holds) return not_within(i);
  }
  return {};
}

}  // namespace

HullVerdict verify_hull(const Hull2& hull, std::span<const Point2> points, const Hull2Options& options) {
  figure::require_finite_points("verify_hull", "points", points);
  return {flaw_of(hull, points, options.all_boundary_points)};
}

}  // namespace plumb
