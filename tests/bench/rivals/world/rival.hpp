// Bullet's collision world and FCL's manager, for what bench_world measures.
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
  /// Does the way from one point to another meet any?  The first that it meets is found.
  [[nodiscard]] bool is_met(const std::array<double, 3>& from, const std::array<double, 3>& to) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same cubes in FCL's tree of boxes.
class FclCubes {
 public:
  explicit FclCubes(std::size_t n);
  ~FclCubes();
  void place(std::size_t i, const std::array<double, 4>& at);
  /// Brings the boxes of those that were placed up to date, or all of them; how many pairs meet.
  std::size_t detect();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb::rivals
