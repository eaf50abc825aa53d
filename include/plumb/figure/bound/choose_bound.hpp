// Which bounding volume should stand for these points?  The cheapest that culls enough, by measurement and by cost.
//
//   const BoundChoice choice = choose_bound(mesh.vertices, {.refined_ns = 5'000});
//   if (const auto* box = std::get_if<Obb3>(&choice.bound)) ...
//
// The model: a query tests two bounds, and where they overlap, it does the refined test behind them.  So a query is
// expected to cost   test + P(bounds overlap) * refined.   P is counted over placements of two copies of the points:
// turned at random, their smallest spheres meeting, at distances uniform by volume; as many as are asked for, the same
// each time.  Whether the hulls meet is counted beside it, so that what a bound overlaps falsely is known.
// Axis-aligned boxes and k-DOPs are fitted anew to the turned points, the others are turned with them.
// Laws: (1) the bound contains the points, exactly.  (2) Counts depend on points and options alone; every placement is
// exact (integer quaternions turn a copy on a lattice of 2^28 steps across), as is each overlap that is counted.
// (3) The choice has the least expected cost of all kinds that doubles can hold, the earlier kind where two are equal.
// No points throw InvalidShape, as does a negative cost; NaN and infinities throw NonFinite.
// Source: RTCD 4.1 (figure 4.2), 4.2.4, 4.6.4.
// Cost: the hull, and each kind's fit for each of the placements: some tens of milliseconds for a thousand hull
// vertices.  Bounded by n^2 operations for each placement and kind, beside the hull.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

enum class BoundKind : unsigned char { sphere, aabb, capsule, lozenge, obb, k_dop_14, k_dop_18, k_dop_26 };

inline constexpr std::array bound_kinds{BoundKind::sphere,   BoundKind::aabb,    BoundKind::capsule,
                                        BoundKind::lozenge,  BoundKind::obb,     BoundKind::k_dop_14,
                                        BoundKind::k_dop_18, BoundKind::k_dop_26};

constexpr std::string_view name_of(BoundKind kind) {
  constexpr std::array<std::string_view, bound_kinds.size()> names{"sphere", "aabb",   "capsule", "lozenge",
                                                                   "obb",    "14-dop", "18-dop",  "26-dop"};
  return names[static_cast<std::size_t>(kind)];
}

using AnyBound = std::variant<Sphere3, Aabb3, Capsule3, Lozenge3, Obb3, KDop3>;

/// The smallest sphere, the box of least volume, and the fits of figure/aabb/aabb.hpp, swept_sphere.hpp and k_dop.hpp.
AnyBound fit_bound(BoundKind kind, std::span<const Point3> points);

/// By kind, in their order.
using BoundNumbers = std::array<double, bound_kinds.size()>;

struct RatingOptions {
  std::uint32_t placements = 200;
  std::uint64_t start = 1;     // of the random placements
  bool measure_times = false;  // of the overlap tests: times vary, nothing else does
};

struct BoundRating {
  BoundKind kind;
  double tightness;              // the hull's volume fits in the bound's so often; infinite for a flat hull in a solid
  std::uint32_t overlapping;     // of the placements: bounds overlap
  std::uint32_t false_overlaps;  // of these: hulls are apart
  double test_ns;                // of one overlap test, the median of several runs; 0 where not asked for
};

/// Where the two copies of the lattice's points are, exactly, and whether their hulls meet.
struct RatedPlacement {
  Pose a, b;
  bool hulls_meet;
};

struct BoundRatings {
  std::vector<BoundRating> kinds;
  std::vector<RatedPlacement> placements;
  std::vector<Point3> lattice;  // the hull's vertices as they are placed: integers
  double hull_share;            // the hull's volume as a part of that of the axis-aligned box; 0 for a flat hull
  [[nodiscard]] std::uint32_t hulls_apart() const {
    std::uint32_t n = 0;
    for (const RatedPlacement& p : placements) n += static_cast<std::uint32_t>(!p.hulls_meet);
    return n;
  }
};

BoundRatings rate_bounds(std::span<const Point3> points, const RatingOptions& options = {});

/// In nanoseconds, or in any other unit for all.
struct BoundCosts {
  /// As measured by `plumb bounds` on the machine of docs/measurements.md; rate_bounds measures those of yours.
  BoundNumbers test_ns{1.7, 3.6, 22, 265, 37, 8.2, 10, 15};
  double refined_ns = 1'000;  // of what is asked when the bounds overlap
};

struct BoundChoice {
  AnyBound bound;
  BoundKind kind;
  BoundNumbers expected_ns;  // of a query, by kind
  BoundRatings ratings;
};

BoundChoice choose_bound(std::span<const Point3> points, const BoundCosts& costs = {},
                         const RatingOptions& options = {});

}  // namespace plumb
