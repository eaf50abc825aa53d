// How long does a method of the broad phase take for these boxes, from scratch or kept from frame to frame?
//
// Nothing depends on it but what is told of times.
// Cost: two runs, or what is kept made once and two frames.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "plumb/space/broad_phase/moving_boxes.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "plumb/space/sort_and_sweep/sweep_array.hpp"

namespace plumb::space {

/// A scene of frames: some of the boxes take a small step, forth and back by turns, a fiftieth of their edges.
class SteppedBoxes {
 public:
  SteppedBoxes(std::span<const Aabb3> boxes, double share) : boxes_(boxes.begin(), boxes.end()), still_(boxes_) {
    const double every = share > 0 ? 1 / share : 0;
    for (double at = 0; share > 0 && at < static_cast<double>(boxes.size()); at += every) {
      moving_.push_back(static_cast<std::uint32_t>(at));
    }
  }
  [[nodiscard]] const std::vector<Aabb3>& boxes() const { return boxes_; }
  [[nodiscard]] const std::vector<std::uint32_t>& moving() const { return moving_; }
  void step() {
    is_forth_ = !is_forth_;
    for (const std::uint32_t i : moving_) {
      Aabb3& b = boxes_[i];
      b = still_[i];
      if (!is_forth_) continue;
      const auto by = [](double& low, double& high) {  // where numbers end, it stays
        const double way = high * 0.02 - low * 0.02;
        if ((high + way) - (high + way) == 0) low += way, high += way;
      };
      by(b.min.x, b.max.x);
      by(b.min.y, b.max.y);
      by(b.min.z, b.max.z);
    }
  }

 private:
  std::vector<Aabb3> boxes_, still_;
  std::vector<std::uint32_t> moving_;
  bool is_forth_ = false;
};

/// The lesser of two times of what is called, after prepare().
template <class Prepare, class Call>
double least_nanoseconds(const Prepare& prepare, const Call& call) {
  double least = 0;
  for (int run = 0; run < 2; ++run) {
    prepare();
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    least = run == 0 ? took.count() : std::min(least, took.count());
  }
  return least;
}

inline double nanoseconds_of_moving_boxes(SteppedBoxes& scene) {
  MovingBoxes world;
  const std::vector<BoxHandle> handles = world.insert(scene.boxes());
  (void)world.changes();
  std::vector<BoxHandle> moving;
  for (const std::uint32_t i : scene.moving()) moving.push_back(handles[i]);
  std::vector<Aabb3> moved;
  const auto prepare = [&] {
    scene.step();
    moved.clear();
    for (const std::uint32_t i : scene.moving()) moved.push_back(scene.boxes()[i]);
  };
  return least_nanoseconds(prepare, [&] {
    world.move(moving, moved);
    (void)world.changes();
  });
}

/// From scratch, for all boxes together; at least one.
template <class Box>
double measured_nanoseconds(BroadPhaseMethod method, std::span<const Box> boxes) {
  const BroadPhaseOptions options{.execution = Execution::serial, .method = method};
  return least_nanoseconds([] {}, [&] { (void)overlapping_pairs(boxes, options); });
}
/// Kept from frame to frame, in columns or sorted along an axis.
inline double measured_nanoseconds_kept(BroadPhaseMethod method, std::span<const Aabb3> boxes, double moving_share) {
  SteppedBoxes scene(boxes, moving_share);
  if (method == BroadPhaseMethod::swept_columns) return nanoseconds_of_moving_boxes(scene);
  SweepArray sweep;
  (void)sweep.overlapping_pairs(scene.boxes());
  return least_nanoseconds([&] { scene.step(); }, [&] { (void)sweep.overlapping_pairs(scene.boxes()); });
}

}  // namespace plumb::space
