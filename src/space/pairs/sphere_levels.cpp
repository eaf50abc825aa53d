// Level by level, pairs of spheres that meet, replaced by pairs of their children.
#include "plumb/space/pairs/sphere_levels.hpp"

#include <algorithm>
#include <limits>
#include <queue>

#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {
namespace space {
namespace {

constexpr double no_distance = std::numeric_limits<double>::infinity();

/// Numbers among all nodes.
struct SphereNodePair {
  std::uint32_t a, b;
};

bool spheres_of(const SphereTree& a, const SphereTree& b, SphereNodePair p) {
  return intersects(a.nodes[p.a].sphere, b.nodes[p.b].sphere);
}

/// take(pair) of each pair of children; a sphere that is not to be replaced stands for its only child.
template <class Take>
void replace_spheres(const SphereTree& a, bool of_a, const SphereTree& b, bool of_b, SphereNodePair p,
                     const Take& take) {
  const SphereNode &na = a.nodes[p.a], &nb = b.nodes[p.b];
  const std::uint32_t from_a = of_a ? na.first_child : p.a, to_a = of_a ? from_a + na.children : p.a + 1;
  const std::uint32_t from_b = of_b ? nb.first_child : p.b, to_b = of_b ? from_b + nb.children : p.b + 1;
  for (std::uint32_t i = from_a; i < to_a; ++i) {
    for (std::uint32_t k = from_b; k < to_b; ++k) take(SphereNodePair{i, k});
  }
}

/// Both one level further down, as far as levels go.
std::vector<SphereNodePair> next_level(const SphereTree& a, bool of_a, const SphereTree& b, bool of_b,
                                       const std::vector<SphereNodePair>& now) {
  std::vector<SphereNodePair> next;
  for (const SphereNodePair p : now) {
    replace_spheres(a, of_a, b, of_b, p, [&](SphereNodePair q) {
      if (spheres_of(a, b, q)) next.push_back(q);
    });
  }
  return next;
}

std::size_t tests_of_next(const SphereTree& a, bool of_a, const SphereTree& b, bool of_b,
                          const std::vector<SphereNodePair>& now) {
  std::size_t n = 0;
  for (const SphereNodePair p : now) {
    n += std::size_t{of_a ? a.nodes[p.a].children : 1} * (of_b ? b.nodes[p.b].children : 1);
  }
  return n;
}

std::uint32_t last_level(const SphereTree& tree) { return tree.levels() - 1; }

/// By their numbers in the levels.
std::vector<SpherePair> in_levels(const SphereTree& a, std::uint32_t level_a, const SphereTree& b,
                                  std::uint32_t level_b, const std::vector<SphereNodePair>& nodes,
                                  std::vector<SpherePair> pairs = {}) {
  for (const auto [i, k] : nodes) pairs.push_back({i - a.begin_of_level[level_a], k - b.begin_of_level[level_b]});
  std::ranges::sort(pairs, {}, [](const SpherePair& p) { return std::pair{p.a, p.b}; });
  return pairs;
}

Interval distance_of_centers(const Sphere3& a, const Sphere3& b) {
  const auto square = [](double x, double y) {
    const Interval d = Interval(x) - Interval(y);
    const Interval sized = d.lower >= 0 ? d : d.upper <= 0 ? Interval(-d.upper, -d.lower) : Interval(0, d.upper);
    return sized * sized;
  };
  return root(square(a.center.x, b.center.x) + square(a.center.y, b.center.y) + square(a.center.z, b.center.z));
}

/// Of two spheres that each hold a point of their surface: no pair below is nearer than least, some is as near as most.
struct BoundedPair {
  SphereNodePair pair;
  double least, most;
  bool operator<(const BoundedPair& other) const {  // the nearest is on top, of equals the first
    if (least != other.least) return least > other.least;
    return pair.a != other.pair.a ? pair.a > other.pair.a : pair.b > other.pair.b;
  }
};

BoundedPair bounded(const SphereTree& a, const SphereTree& b, SphereNodePair p) {
  const Sphere3 &s = a.nodes[p.a].sphere, &t = b.nodes[p.b].sphere;
  const Interval d = distance_of_centers(s, t), reach = Interval(s.radius) + Interval(t.radius);
  return {p, std::max(0.0, (d - reach).lower), (d + reach).upper};
}

}  // namespace
}  // namespace space

std::vector<SpherePair> meeting_spheres(const SphereTree& a, std::uint32_t level_a, const SphereTree& b,
                                        std::uint32_t level_b, std::vector<SpherePair> rows) {
  rows.clear();
  if (a.nodes.empty() || b.nodes.empty()) return rows;
  level_a = std::min(level_a, space::last_level(a)), level_b = std::min(level_b, space::last_level(b));
  std::vector<space::SphereNodePair> now;
  if (space::spheres_of(a, b, {0, 0})) now.push_back({0, 0});
  for (std::uint32_t k = 0; k < std::max(level_a, level_b) && !now.empty(); ++k) {
    now = space::next_level(a, k < level_a, b, k < level_b, now);
  }
  return space::in_levels(a, level_a, b, level_b, now, std::move(rows));
}

bool spheres_meet(const SphereTree& a, std::uint32_t level_a, const SphereTree& b, std::uint32_t level_b) {
  if (a.nodes.empty() || b.nodes.empty() || !space::spheres_of(a, b, {0, 0})) return false;
  struct Later {
    space::SphereNodePair pair;
    std::uint32_t level;
  };
  level_a = std::min(level_a, space::last_level(a)), level_b = std::min(level_b, space::last_level(b));
  std::vector<Later> later{{{0, 0}, 0}};
  while (!later.empty()) {
    const auto [pair, level] = later.back();
    later.pop_back();
    if (level == std::max(level_a, level_b)) return true;
    space::replace_spheres(a, level < level_a, b, level < level_b, pair, [&, below = level + 1](auto next) {
      if (space::spheres_of(a, b, next)) later.push_back({next, below});
    });
  }
  return false;
}

CollisionCheck check_collision(const SphereTree& a, const SphereTree& b, const CollisionCheckOptions& options) {
  CollisionCheck check;
  if (a.nodes.empty() || b.nodes.empty()) {
    check.apart = check.is_last = true;
    return check;
  }
  if (options.most_tests < 1) throw InvalidShape("check_collision: most_tests is 0; give at least 1");
  const std::uint32_t last_a = space::last_level(a), last_b = space::last_level(b), last = std::max(last_a, last_b);
  std::vector<space::SphereNodePair> now;
  check.tests = 1;
  if (space::spheres_of(a, b, {0, 0})) now.push_back({0, 0});
  while (!now.empty() && check.level < last) {
    const bool of_a = check.level < last_a, of_b = check.level < last_b;
    const std::size_t more = space::tests_of_next(a, of_a, b, of_b, now);
    if (more > options.most_tests - check.tests) break;
    now = space::next_level(a, of_a, b, of_b, now);
    check.tests += more;
    ++check.level;
  }
  check.apart = now.empty();
  check.is_last = check.apart || check.level == last;
  check.pairs = space::in_levels(a, std::min(check.level, last_a), b, std::min(check.level, last_b), now);
  return check;
}

DistanceBounds distance_bounds(const SphereTree& a, const SphereTree& b, const DistanceBoundsOptions& options) {
  if (!(options.absolute >= 0) || !(options.relative >= 0) || options.most_tests < 1)
    throw InvalidShape("distance_bounds: absolute and relative must be at least 0, most_tests at least 1");
  if (a.nodes.empty() || b.nodes.empty()) return {space::no_distance, space::no_distance, 0};
  std::priority_queue<space::BoundedPair> later;
  later.push(space::bounded(a, b, {0, 0}));
  DistanceBounds found{later.top().least, later.top().most, 1};
  const auto is_near_enough = [&] {
    const double width = (Interval(found.most) - Interval(found.least)).upper;
    return width <= options.absolute || width <= (Interval(options.relative) * Interval(found.least)).lower;
  };
  double least_of_leaves = space::no_distance;
  while (!later.empty() && !is_near_enough()) {
    const space::BoundedPair top = later.top();
    const SphereNode &na = a.nodes[top.pair.a], &nb = b.nodes[top.pair.b];
    if (na.children == 0 && nb.children == 0) {  // no pair left is nearer than this
      least_of_leaves = top.least;
      break;
    }
    const bool of_a = nb.children == 0 || (na.children != 0 && na.sphere.radius >= nb.sphere.radius);
    const std::size_t more = of_a ? na.children : nb.children;
    if (more > options.most_tests - found.tests) break;
    later.pop();
    found.tests += more;
    space::replace_spheres(a, of_a, b, !of_a, top.pair, [&](auto next) {
      space::BoundedPair pair = space::bounded(a, b, next);
      pair.least = std::max(pair.least, top.least);
      found.most = std::min(found.most, pair.most);
      if (pair.least <= found.most) later.push(pair);
    });
    if (!later.empty()) found.least = std::max(found.least, std::min(later.top().least, found.most));
  }
  if (least_of_leaves < space::no_distance) found.least = std::max(found.least, least_of_leaves);
  return found;
}

}  // namespace plumb
