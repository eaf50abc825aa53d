#include "lab/stability/hull_ways.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace plumb::lab::stability {
namespace {

using Index = std::uint32_t;
using Indices = std::vector<Index>;
using PlaneSigns = HullSigns<2>;

Corners andrew(const PlaneSigns& s) {
  const Indices order = s.in_order();
  if (order.size() < 3) return order;
  Indices corners, chain;
  const auto add = [&](Index i) {
    while (chain.size() >= 2 && s.side({chain[chain.size() - 2], chain.back()}, i) <= 0) chain.pop_back();
    chain.push_back(i);
  };
  const auto take = [&] {  // but for the last, with which the other chain begins
    corners.insert(corners.end(), chain.begin(), chain.end() - 1);
    chain.clear();
  };
  std::for_each(order.begin(), order.end(), add);
  take();
  std::for_each(order.rbegin(), order.rend(), add);
  take();
  return corners;
}

/// Appends the corners strictly left of the line from a to b, from b's side to a's; false where it ran too long.
bool left_of(const PlaneSigns& s, Index a, Index b, const Indices& points, Indices& corners, std::size_t& calls_left) {
  if (calls_left == 0) return false;
  --calls_left;
  Indices left;
  std::ranges::copy_if(points, std::back_inserter(left), [&](Index p) { return s.side({a, b}, p) > 0; });
  if (left.empty()) return true;
  Index far = left.front();
  for (const Index p : left) {
    const int farther = s.farther({a, b}, p, far);
    if (farther > 0 || (farther == 0 && s.before(far, p))) far = p;  // of equally far ones an end
  }
  if (!left_of(s, far, b, left, corners, calls_left)) return false;
  corners.push_back(far);
  return left_of(s, a, far, left, corners, calls_left);
}

Corners quickhull(const PlaneSigns& s) {
  const Indices order = s.in_order();
  if (order.size() < 3) return order;
  const Index a = order.front(), b = order.back();
  std::size_t calls_left = 2 * order.size();  // two for each corner that is found
  Indices corners{a};
  if (!left_of(s, b, a, order, corners, calls_left)) return std::nullopt;
  corners.push_back(b);
  if (!left_of(s, a, b, order, corners, calls_left)) return std::nullopt;
  return corners;
}

Corners gift_wrapping(const PlaneSigns& s) {
  const Indices order = s.in_order();
  if (order.size() < 3) return order;
  return wrapped(s, order, [&s](Index a, Index b, Index c) { return s.side({a, b}, c); });
}

/// Inserts point after point: takes away the edges that see it, which lie next to one another.
Corners incremental(const PlaneSigns& s) {
  const Indices order = s.in_order();
  if (order.size() < 3) return order;
  const auto apex = std::find_if(order.begin() + 1, order.end() - 1, [&](Index p) {
    return s.side({order.front(), order.back()}, p) != 0;
  });
  if (apex == order.end() - 1) return Indices{order.front(), order.back()};
  Indices hull{order.front(), order.back(), *apex};
  if (s.side({hull[0], hull[1]}, hull[2]) < 0) std::swap(hull[1], hull[2]);
  Indices rest(s.size());
  std::iota(rest.begin(), rest.end(), Index{0});  // in the order in which they are given
  for (const Index p : rest) {
    const std::size_t n = hull.size();
    const auto side = [&](std::size_t edge) { return s.side({hull[edge % n], hull[(edge + 1) % n]}, p); };
    std::size_t first = 0;
    while (first < n && side(first) >= 0) ++first;
    if (first == n) continue;
    std::size_t begin = first + n, end = first + n;  // edges begin ... end see it
    while (side(begin - 1) <= 0) {
      if (--begin == first + 1) return std::nullopt;  // all around: a textbook's loop goes on
    }
    while (side(end + 1) <= 0) {
      if (++end == begin + n - 1) return std::nullopt;
    }
    Indices kept{p};
    for (std::size_t i = end + 1; i <= begin + n; ++i) kept.push_back(hull[i % n]);
    hull = std::move(kept);
  }
  return hull;
}

}  // namespace

const std::vector<HullWay>& hull_ways() {
  static const std::vector<HullWay> all{
      {"Andrew", "sorts, then walks along the lower and the upper chain", andrew},
      {"quickhull", "splits by the farthest point, again and again", quickhull},
      {"gift wrapping", "turns about a corner until it finds the next", gift_wrapping},
      {"incremental", "adds a point after the other, in the order in which they come", incremental}};
  return all;
}

}  // namespace plumb::lab::stability
