// How long do a scene's decisions take, with a plan and without?  Measured on decisions that meshes ask for.
//
// Laws: decisions take the coordinates of vertices alone, and so lie on the scene's lattice; the same ones whatever the
// machine.  Times are medians over blocks of the least of some runs.
// Source: none.
// Cost: milliseconds a predicate and lattice.
#pragma once

#include <span>
#include <vector>

#include "tool/plan/scene_plan.hpp"

namespace plumb::tool {

class SceneDecisions {
 public:
  explicit SceneDecisions(std::span<const NamedMesh> meshes);

  /// Of classic number `predicate`, the coordinates snapped to multiples of 2^exponent, on this lattice.
  [[nodiscard]] DecisionTimes measure(std::size_t predicate, const Lattice& lattice, int exponent) const;

 private:
  std::array<std::vector<double>, classic_count> questions_;  // coordinates, set after set
};

}  // namespace plumb::tool
