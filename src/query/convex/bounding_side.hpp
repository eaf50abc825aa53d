// Supporting plane, half-space: which halfspaces bound a figure, and who is beyond one of them?
//
// Laws: a side of a polyhedron is the plane of three corners of its face, exactly; one of a k-DOP or an intersection of
// halfspaces is as its numbers say.  Signs are those of real arithmetic.
// Source: RTCD 5.3.8, 8.3.4.
// Cost: some ns a point, 50 to 200 where it is on the plane or off it by ulps.
#pragma once

#include <array>
#include <vector>

#include "query/body/number_image.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// normal . x <= offset; or below the plane of three points, which are counterclockwise from above.
struct Side {
  Vector3 normal;
  double offset;
  std::array<const Point3*, 3> corners{};
};

/// What bounds it, if halfspaces do; those without a normal are all of space, or nothing.
std::vector<Side> sides_of(const FlatView& v);

inline bool has_no_normal(const Side& side) { return side.corners[0] == nullptr && side.normal == Vector3{}; }

template <class T>
arith::Vec<T> normal_of(const Side& side) {
  if (side.corners[0] == nullptr) return arith::vec<T>(side.normal);
  const arith::Vec<T> a = arith::vec<T>(*side.corners[0]);
  return arith::cross(arith::vec<T>(*side.corners[1]) - a, arith::vec<T>(*side.corners[2]) - a);
}

/// What the side says of the numbers.
template <class T>
figure::SlackRow<T> row_of(const Side& side, const arith::Vec<T>& normal, const Image<T>& image) {
  figure::SlackRow<T> row{{T(0.0), T(0.0), T(0.0)}, T(0.0)};
  if (side.corners[0] != nullptr) {
    const arith::Vec<T> a = arith::vec<T>(*side.corners[0]);
    row.limit = arith::dot(normal, (image.has_weight ? a * image.weight : a) - image.origin);
  } else {
    const T offset(side.offset);
    row.limit = (image.has_weight ? offset * image.weight : offset) - arith::dot(normal, image.origin);
  }
  if (image.moves_only) {
    row.normal = {normal.x, normal.y, normal.z};
  } else {
    for (std::size_t k = 0; k < image.count; ++k) row.normal[k] = arith::dot(normal, image.columns[k]);
  }
  return row;
}
/// Positive beyond the side.
Sign sign_beyond(const Side& side, const Point3& p);

/// A side, ready for many points.
class Beyond {
 public:
  explicit Beyond(const Side& side) : side_(side), normal_(normal_of<Running>(side)) {
    if (side.corners[0] != nullptr) at_ = arith::vec<Running>(*side.corners[0]);
  }
  [[nodiscard]] Sign sign(const Point3& p) const {
    const auto q = arith::vec<Running>(p);
    const Running height =
        side_.corners[0] != nullptr ? arith::dot(normal_, q - at_) : arith::dot(normal_, q) - Running(side_.offset);
    const Unsure<Sign> sign = height.sign();
    return sign.certain() ? sign.value() : sign_beyond(side_, p);
  }

 private:
  const Side& side_;
  arith::Vec<Running> normal_, at_{};
};
}  // namespace plumb::query
