// A mesh's triangles by their numbers, and how far they reach.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "plumb/arith/interval.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/slot_triangles.hpp"

namespace plumb::space {

class NumberedTriangles {
 public:
  explicit NumberedTriangles(const Bvh& mesh) : mesh_(mesh), slots_(slots_of(mesh)) {}
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
  [[nodiscard]] const Bvh::Corners& corners(std::uint32_t i) const { return mesh_.triangles[slots_[i]]; }
  [[nodiscard]] Triangle3 operator[](std::uint32_t i) const { return mesh_.triangle(slots_[i]); }

  /// The largest of the differences of their x, of their y and of their z, rounded down; 0 where it is beyond doubles.
  [[nodiscard]] double extent() const {
    constexpr double most = std::numeric_limits<double>::max();
    Aabb3 all{{most, most, most}, {-most, -most, -most}};
    for (const Bvh::Corners& c : mesh_.triangles.view()) {
      const Aabb3 box = box_around(c, mesh_.vertices.view());
      all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y), std::min(all.min.z, box.min.z)};
      all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y), std::max(all.max.z, box.max.z)};
    }
    const auto length = [](double from, double to) { return (Interval(to) - Interval(from)).lower; };
    return std::max({0.0, length(all.min.x, all.max.x), length(all.min.y, all.max.y), length(all.min.z, all.max.z)});
  }

 private:
  const Bvh& mesh_;
  std::vector<std::uint32_t> slots_;  // one of those that it is in
};

}  // namespace plumb::space
