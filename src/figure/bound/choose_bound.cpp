// Two copies of the hull's vertices on a lattice, turned by integer quaternions of one norm: all of one size, and
// exact.
#include "plumb/figure/bound/choose_bound.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "arith/splitmix.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/bound/hull_overlap.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

using Points = std::vector<Point3>;

class Random {
 public:
  explicit Random(std::uint64_t start) : state_(start) {}

  /// An integer from -most to most.
  std::int64_t within(std::int64_t most) {
    const auto range = static_cast<std::uint64_t>(2 * most + 1);
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::int64_t>(static_cast<Wide>(splitmix64(state_)) * range >> 64) - most;
  }

 private:
  std::uint64_t state_;
};

constexpr std::int64_t norm = 1009;  // of quaternions: how much all turned copies are larger; thousands have it

/// norm times a rotation, by integers.
Pose turned(Random& random) {
  for (;;) {  // one in sixty tries hits, and the stream comes by all numbers in the end
    const std::int64_t b = random.within(31), c = random.within(31), d = random.within(31);
    const std::int64_t rest = norm - b * b - c * c - d * d;
    if (rest < 0) continue;
    const auto a = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(rest))));
    if (a * a != rest) continue;
    const auto vector = [](std::int64_t x, std::int64_t y, std::int64_t z) {
      return Vector3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    };
    return {{vector(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)),
             vector(2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)),
             vector(2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d)},
            {0, 0, 0}};
  }
}

/// Exact for points of the lattice.
Point3 moved(const Pose& pose, const Point3& p) {
  const auto& [x, y, z] = pose.columns;
  return {x.x * p.x + y.x * p.y + z.x * p.z + pose.translation.x,
          x.y * p.x + y.y * p.y + z.y * p.z + pose.translation.y,
          x.z * p.x + y.z * p.y + z.z * p.z + pose.translation.z};
}
Points moved(const Pose& pose, const Points& points) {
  Points result;
  result.reserve(points.size());
  for (const Point3& p : points) result.push_back(moved(pose, p));
  return result;
}

/// Integers of 28 bits: the points in steps of the lattice, from the middle of their box.
Points on_lattice(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const int size = largest > 0 ? std::ilogb(largest) + 1 : 0;
  Points scaled;
  for (const Point3& p : points)
    scaled.push_back({std::ldexp(p.x, -size), std::ldexp(p.y, -size), std::ldexp(p.z, -size)});
  const Aabb3 box = fit_aabb(scaled);
  const double width = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
  const int steps = width > 0 ? 27 - std::ilogb(width) : 0;
  const auto step = [steps](double x, double min, double max) {
    return std::nearbyint(std::ldexp(x - (min / 2 + max / 2), steps));
  };
  for (Point3& p : scaled)
    p = {step(p.x, box.min.x, box.max.x), step(p.y, box.min.y, box.max.y), step(p.z, box.min.z, box.max.z)};
  return scaled;
}

RatedPlacement placed(const Sphere3& around, Random& random) {
  RatedPlacement placement{turned(random), turned(random), false};
  const auto reach = static_cast<std::int64_t>(std::ceil(2 * around.radius * static_cast<double>(norm)));
  Vector3 way{};
  do {  // uniform in the ball in which the spheres meet
    way = {static_cast<double>(random.within(reach)), static_cast<double>(random.within(reach)),
           static_cast<double>(random.within(reach))};
  } while (way.x * way.x + way.y * way.y + way.z * way.z > static_cast<double>(reach) * static_cast<double>(reach));
  const Point3 a = moved(placement.a, around.center), b = moved(placement.b, around.center);
  placement.b.translation = {std::nearbyint(a.x - b.x) + way.x, std::nearbyint(a.y - b.y) + way.y,
                             std::nearbyint(a.z - b.z) + way.z};
  return placement;
}

struct Scene {
  Points points;  // the hull's vertices on the lattice
  double hull_volume;
  std::vector<RatedPlacement> placements;
};

Scene scene_of(std::span<const Point3> points, const RatingOptions& options) {
  const Points all = on_lattice(points);
  const Hull3 hull = convex_hull(all);
  Scene scene{};
  for (const std::uint32_t v : hull.vertices) scene.points.push_back(all[v]);
  scene.hull_volume = hull.dimension == 3 ? volume(convex_polyhedron(hull, all)) : 0;
  const Sphere3 around = minimum_sphere(scene.points).sphere;
  Random random(options.start);
  for (std::uint32_t i = 0; i < options.placements; ++i) {
    RatedPlacement p = placed(around, random);
    p.hulls_meet = figure::hulls_meet(moved(p.a, scene.points), moved(p.b, scene.points));
    scene.placements.push_back(p);
  }
  return scene;
}

bool overlap(const KDop3& a, const KDop3& b) { return intervals_overlap(a, b); }
template <class B>
bool overlap(const B& a, const B& b) {
  return intersects(a, b);
}

/// The median time of a test over all pairs.
template <class B>
double measured_ns(const std::vector<std::pair<B, B>>& pairs) {
  if (pairs.empty()) return 0;
  using Clock = std::chrono::steady_clock;
  std::array<double, 7> runs{};
  for (double& run : runs) {
    std::uint64_t tests = 0, overlapping = 0;
    const auto start = Clock::now();
    std::chrono::duration<double, std::nano> elapsed{};
    do {
      for (const auto& [a, b] : pairs) overlapping += static_cast<std::uint64_t>(overlap(a, b));
      tests += pairs.size();
      elapsed = Clock::now() - start;
    } while (elapsed.count() < 1e6);
    const volatile std::uint64_t kept = overlapping;
    static_cast<void>(kept);
    run = elapsed.count() / static_cast<double>(tests);
  }
  std::ranges::sort(runs);
  return runs[runs.size() / 2];
}

template <class B, class Place>
BoundRating rated(BoundKind kind, const Scene& scene, const B& bound, bool measure, Place place) {
  const double v = volume(bound);
  BoundRating rating{kind, v == scene.hull_volume ? 1 : v / scene.hull_volume, 0, 0, 0};
  std::vector<std::pair<B, B>> pairs;
  for (const RatedPlacement& placement : scene.placements) {
    pairs.emplace_back(place(placement.a), place(placement.b));
    if (!overlap(pairs.back().first, pairs.back().second)) continue;
    ++rating.overlapping;
    rating.false_overlaps += static_cast<std::uint32_t>(!placement.hulls_meet);
  }
  if (measure) rating.test_ns = measured_ns(pairs);
  return rating;
}

int directions_of(BoundKind kind) { return kind == BoundKind::k_dop_14 ? 14 : kind == BoundKind::k_dop_18 ? 18 : 26; }

BoundRating rated(BoundKind kind, const Scene& scene, bool measure) {
  return std::visit(
      [&](const auto& bound) {
        using B = std::decay_t<decltype(bound)>;
        return rated(kind, scene, bound, measure, [&](const Pose& pose) {
          if constexpr (std::is_same_v<B, Aabb3>) {
            return fit_aabb(scene.points, pose);
          } else if constexpr (std::is_same_v<B, KDop3>) {
            return fit_k_dop(scene.points, bound.directions, pose);
          } else {
            return transform(bound, pose);
          }
        });
      },
      fit_bound(kind, scene.points));
}

void require_cost(double cost, const std::string& name) {
  if (std::isnan(cost) || std::isinf(cost)) {
    const std::array<std::string_view, 1> names{name};
    throw_non_finite("choose_bound", std::array{1}, std::array{cost}, "xyz", names);
  }
  if (cost < 0) throw InvalidShape("choose_bound: " + name + " is negative; give what a test costs, zero or more");
}

}  // namespace

AnyBound fit_bound(BoundKind kind, std::span<const Point3> points) {
  switch (kind) {
    case BoundKind::sphere:
      return minimum_sphere(points).sphere;
    case BoundKind::aabb:
      return fit_aabb(points);
    case BoundKind::capsule:
      return fit_capsule(points);
    case BoundKind::lozenge:
      return fit_lozenge(points);
    case BoundKind::obb:
      return minimum_obb(points);
    default:
      return fit_k_dop(points, directions_of(kind));
  }
}

BoundRatings rate_bounds(std::span<const Point3> points, const RatingOptions& options) {
  if (points.empty()) throw InvalidShape("rate_bounds: no points; give at least one");
  figure::require_finite_points("rate_bounds", "points", points);
  Scene scene = scene_of(points, options);
  const double box = volume(fit_aabb(scene.points));
  BoundRatings ratings{{}, {}, {}, box == 0 ? 0 : scene.hull_volume / box};
  for (const BoundKind kind : bound_kinds) ratings.kinds.push_back(rated(kind, scene, options.measure_times));
  ratings.placements = std::move(scene.placements);
  ratings.lattice = std::move(scene.points);
  return ratings;
}

BoundChoice choose_bound(std::span<const Point3> points, const BoundCosts& costs, const RatingOptions& options) {
  if (points.empty()) throw InvalidShape("choose_bound: no points; give at least one");
  figure::require_finite_points("choose_bound", "points", points);
  require_cost(costs.refined_ns, "costs.refined_ns");
  for (std::size_t k = 0; k < bound_kinds.size(); ++k)
    require_cost(costs.test_ns[k], std::string("costs.test_ns[").append(std::to_string(k)).append("]"));
  BoundChoice choice{Aabb3{}, bound_kinds[0], {}, rate_bounds(points, options)};
  for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
    const double share = options.placements == 0 ? 0
                                                 : static_cast<double>(choice.ratings.kinds[k].overlapping) /
                                                       static_cast<double>(options.placements);
    choice.expected_ns[k] = costs.test_ns[k] + share * costs.refined_ns;
  }
  std::vector<BoundKind> order(bound_kinds.begin(), bound_kinds.end());
  std::ranges::stable_sort(order, {}, [&](BoundKind k) { return choice.expected_ns[static_cast<std::size_t>(k)]; });
  for (const BoundKind kind : order) {
    choice.kind = kind;
    try {
      choice.bound = fit_bound(kind, points);
      break;
    } catch (const BeyondDoubles&) {  // an axis-aligned box always can be
      if (kind == order.back()) throw;
    }
  }
  return choice;
}

}  // namespace plumb
