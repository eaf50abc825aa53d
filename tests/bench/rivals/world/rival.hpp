// Bullet's collision world, for what bench_world measures.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace plumb::rivals {

/// Unit cubes about the middle of their lower faces, each at a place and turned about the upright axis.
class BulletCubes {
 public:
  explicit BulletCubes(std::size_t n);
  ~BulletCubes();
  /// `at`: x, y, z and the tangent of half the angle.
  void place(std::size_t i, const std::array<double, 4>& at);
  /// All pairs anew, with their manifolds; how many points these have.
  std::size_t detect();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb::rivals
