// Which of two points has the farther image under a pose, along an axis of space?
//
// Law: the sign is that of the exact images.
// Source: RTCD 4.2.4.
// Cost: that of the sign along a direction where doubles hold the matrix, else some 100 ns.
#pragma once

#include "figure/basic/pose_numbers.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb::figure {

class ImageOrder {
 public:
  /// The pose must outlive this.
  explicit ImageOrder(const CertainPose& pose) : pose_(&pose) {
    if (const auto columns = pose.columns()) {
      const auto& [u, v, w] = *columns;
      rows_ = {{{u.x, v.x, w.x}, {u.y, v.y, w.y}, {u.z, v.z, w.z}}};
    }
  }

  /// Positive where the image of p is farther than that of q.
  [[nodiscard]] Sign operator()(std::size_t axis, const Point3& p, const Point3& q) const {
    if (rows_) return sign_of(predicates::OrderAlongDirection3d{}, p, q, (*rows_)[axis]);
    return pose_->sign(
        [&]<class T>(const PoseNumbers<T>& n) { return n.turned(arith::vec<T>(p) - arith::vec<T>(q), axis); });
  }
  /// Are all images equally far?
  [[nodiscard]] bool is_level(std::size_t axis) const { return rows_ && (*rows_)[axis] == Vector3{0, 0, 0}; }

 private:
  const CertainPose* pose_;
  std::optional<std::array<Vector3, 3>> rows_;
};

}  // namespace plumb::figure
