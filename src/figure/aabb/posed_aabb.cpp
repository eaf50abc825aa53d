// A bound is a sum over a weight, or of a round shape under a matrix a sum and a root.
#include "plumb/figure/aabb/posed_aabb.hpp"

#include "arith/rounded_radical.hpp"
#include "figure/aabb/ranges.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/image_order.hpp"
#include "figure/basic/in_space.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb::figure::box {
namespace {

template <class Shape>
const Shape& sound(const Shape& shape) {
  figure::require_sound("fit_aabb", shape);
  return shape;
}

std::vector<Point3> raised(const std::vector<Point2>& points) {
  std::vector<Point3> all;
  for (const Point2& p : points) all.push_back(in_space(p));
  return all;
}

/// The greatest coordinate of the image, or the least.
class Bound {
 public:
  Bound(const Reach3& shape, const CertainPose& pose, std::size_t axis, bool is_greatest)
      : shape_(shape), pose_(pose), axis_(axis), is_greatest_(is_greatest) {
    const ImageOrder order(pose);
    const Sign farther = is_greatest ? Sign::positive : Sign::negative;
    at_ = shape.points.front();
    for (const Point3& p : shape.points) {
      if (order(axis, p, at_) == farther) at_ = p;
    }
    for (const Reach3::Way& way : shape.ways) {
      const Sign leads =
          pose.sign([&]<class T>(const PoseNumbers<T>& n) { return n.turned(arith::vec<T>(way.along), axis); });
      led_.push_back((leads == Sign::positive) == is_greatest ? std::max(way.from, way.to)
                                                              : std::min(way.from, way.to));
    }
  }

  [[nodiscard]] double rounded(bool is_rigid) const {
    const Rounding outward = is_greatest_ ? Rounding::up : Rounding::down;
    if (is_rigid || shape_.radius == 0) {
      return pose_.rounded(outward, [&]<class T>(const PoseNumbers<T>& n) { return core(n) + T(radius()) * n.weight; });
    }
    // A matrix, of weight 1: its row stretches a unit vector by its length at most.
    const auto& balls = pose_.in<Ball>();
    if (const auto quick = (core(balls) + Ball(radius()) * root(row_square(balls))).rounded(outward)) return *quick;
    const auto& exact = pose_.in<BigDyadic>();
    return rounded_radical(outward, core(exact), BigDyadic(radius()), row_square(exact), BigDyadic(1.0));
  }

 private:
  [[nodiscard]] double radius() const { return is_greatest_ ? shape_.radius : -shape_.radius; }
  template <class T>
  [[nodiscard]] T core(const PoseNumbers<T>& n) const {
    T sum = n.image(arith::vec<T>(at_), axis_);
    for (std::size_t k = 0; k < led_.size(); ++k)
      sum = sum + n.turned(arith::vec<T>(shape_.ways[k].along), axis_) * T(led_[k]);
    return sum;
  }
  template <class T>
  [[nodiscard]] T row_square(const PoseNumbers<T>& n) const {
    const T &x = n.entry(axis_, 0), &y = n.entry(axis_, 1), &z = n.entry(axis_, 2);
    return x * x + y * y + z * z;
  }

  const Reach3& shape_;
  const CertainPose& pose_;
  std::size_t axis_;
  bool is_greatest_;
  Point3 at_;
  std::vector<double> led_;  // of each way
};

template <class View>
auto ranges(const Reach3& shape, View pose) {
  figure::require_sound("fit_aabb", pose);
  const bool is_rigid = pose.visit([](const auto& is) {
    return !requires { is.columns; };
  });
  return [&shape, moved = CertainPose(pose), is_rigid](std::size_t axis) {
    return Range{within_doubles(Bound(shape, moved, axis, false).rounded(is_rigid), "fit_aabb", min_name[axis]),
                 within_doubles(Bound(shape, moved, axis, true).rounded(is_rigid), "fit_aabb", max_name[axis])};
  };
}

}  // namespace

Reach3 reach_of(const Point2& s) { return {{in_space(sound(s))}, {}}; }
Reach3 reach_of(const Point3& s) { return {{sound(s)}, {}}; }
Reach3 reach_of(const Segment2& s) { return {raised({sound(s).a, s.b}), {}}; }
Reach3 reach_of(const Segment3& s) { return {{sound(s).a, s.b}, {}}; }
Reach3 reach_of(const Triangle2& s) { return {raised({sound(s).a, s.b, s.c}), {}}; }
Reach3 reach_of(const Triangle3& s) { return {{sound(s).a, s.b, s.c}, {}}; }
Reach3 reach_of(const Tetrahedron3& s) { return {{sound(s).a, s.b, s.c, s.d}, {}}; }
Reach3 reach_of(const Quadrilateral2& s) { return {raised({sound(s).a, s.b, s.c, s.d}), {}}; }
Reach3 reach_of(const Quadrilateral3& s) { return {{sound(s).a, s.b, s.c, s.d}, {}}; }
Reach3 reach_of(const Polygon2& s) { return {raised(sound(s).vertices), {}}; }
Reach3 reach_of(const Polygon3& s) { return {sound(s).vertices, {}}; }
Reach3 reach_of(const HoledPolygon2& s) { return {raised(sound(s).outer.vertices), {}}; }
Reach3 reach_of(const HoledPolygon3& s) { return {sound(s).outer.vertices, {}}; }
Reach3 reach_of(const ConvexPolyhedron3& s) { return {sound(s).mesh.vertices, {}}; }
Reach3 reach_of(const Circle2& s) { return {{in_space(sound(s).center)}, {}, s.radius}; }
Reach3 reach_of(const Sphere3& s) { return {{sound(s).center}, {}, s.radius}; }
Reach3 reach_of(const Capsule2& s) { return {raised({sound(s).a, s.b}), {}, s.radius}; }
Reach3 reach_of(const Capsule3& s) { return {{sound(s).a, s.b}, {}, s.radius}; }
Reach3 reach_of(const Lozenge3& s) { return {{sound(s).corner}, {{s.edges[0], 0, 1}, {s.edges[1], 0, 1}}, s.radius}; }
Reach3 reach_of(const Obb2& s) {
  const auto& [x, y] = sound(s).half;
  return {{in_space(s.center)}, {{in_space(s.axes[0]), -x, x}, {in_space(s.axes[1]), -y, y}}};
}
Reach3 reach_of(const Obb3& s) {
  const auto& [x, y, z] = sound(s).half;
  return {{s.center}, {{s.axes[0], -x, x}, {s.axes[1], -y, y}, {s.axes[2], -z, z}}};
}
Reach3 reach_of(const Rectangle3& s) {
  const auto& [x, y] = sound(s).half;
  return {{s.center}, {{s.axes[0], -x, x}, {s.axes[1], -y, y}}};
}

Aabb2 fit_image(const Reach3& shape, PoseView2 pose) {
  const auto range = ranges(shape, pose);
  return box_of(range(0), range(1));
}
Aabb3 fit_image(const Reach3& shape, PoseView pose) {
  const auto range = ranges(shape, pose);
  return box_of(range(0), range(1), range(2));
}

}  // namespace plumb::figure::box
