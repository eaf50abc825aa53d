// What is a figure under a pose made of?  The exact set before it, what is near to that, and the map.
//
// Laws: exact; of a radius above zero the set is the core, all that is near to which is meant, before the map.
// Cost: GMP; what flat_set takes.
#pragma once

#include <optional>
#include <string_view>

#include "plumb/query/body/posed.hpp"
#include "query/body/round_axis.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/trapezoids.hpp"

namespace plumb::query {

struct PosedSet {
  FlatSet core = {};                   // of what is convex
  ExactChains chains = {};             // of polygons
  mpq_class radius = 0;                // beyond the core
  std::optional<RoundAxis> axis = {};  // that is itself, instead of the radius; the core is the axis
  const SphericalCap3* cap = nullptr;  // that has an interior, instead of the radius and the core
  ExactMap map = {};
  int dimension = 3;  // of the space

  [[nodiscard]] bool is_empty() const { return core.points.empty() && chains.empty(); }
  [[nodiscard]] bool is_polygon() const { return !chains.empty(); }
  [[nodiscard]] bool is_round() const { return sgn(radius) > 0; }
  [[nodiscard]] bool has_axis() const { return axis.has_value(); }
};

/// Of what has been looked at: finite numbers, radii that are not negative.  Balls of radius zero are points, caps
/// without an interior points or empty, and what the matrix zero maps is a point.  Chains are left to who asks.
PosedSet posed_set(const PosedView& figure);

FlatSet image(const PosedSet& s);
ExactChains image(const ExactMap& map, const ExactChains& chains);

/// The sign of root(first) + root(second) - root(third), of numbers that are not negative.
int sign_of_roots(const mpq_class& first, const mpq_class& second, const mpq_class& third);

}  // namespace plumb::query
