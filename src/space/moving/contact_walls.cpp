#include "space/moving/contact_walls.hpp"

#include <algorithm>

#include "arith/exact_number.hpp"

namespace plumb::space {
namespace {

using query::Vec3;

template <class T>
Vec3<T> velocity_over(const Posed<Vector3>& by) {
  const auto& c = by.pose.columns;
  const Vector3& v = by.shape;
  return query::vector_of<T>(c[0]) * T(v.x) + query::vector_of<T>(c[1]) * T(v.y) + query::vector_of<T>(c[2]) * T(v.z);
}

/// Of the plane of a triangle; of which length, and whether up or down, is left open.
template <class T>
Vec3<T> normal_over(const PosedTriangle& t) {
  const auto corner = query::WeightedCorners<T>(t).at;
  return cross(corner[1] - corner[0], corner[2] - corner[0]);
}
template <class T>
Vec3<T> turned_over(const Vec3<T>& v) {
  const T zero(0.0);
  return {zero - v.x, zero - v.y, zero - v.z};
}

/// Times the weight of the pose.
template <class T>
Vec3<T> image_over(const MeshPose& pose, const Point3& p) {
  return query::weighted_pose<T>(pose.any_view()).image(query::vector_of<T>(p));
}
Rational weight_of(const MeshPose& pose) {
  return exact_number(query::weighted_pose<BigDyadic>(pose.any_view()).weight);
}

std::array<Point3, 3> shape_corners(const Triangle3& t) { return {t.a, t.b, t.c}; }

/// The highest corner, or the lowest.
Point3 extreme_corner(const PosedTriangle& t, const Vec3<BigDyadic>& up, Sign way) {
  const auto heights = query::WeightedCorners<BigDyadic>(t).at;
  std::size_t most = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (dot(heights[i] - heights[most], up).sign() == way) most = i;
  }
  return shape_corners(t.shape)[most];
}

}  // namespace

void ContactWalls::clear() {
  axes_ = {};
  plane_.reset();
}

void ContactWalls::build(std::uint32_t slot_a, std::uint32_t slot_b, const Rational& time,
                         const std::optional<std::array<Aabb3, 2>>& boxes) {
  clear();
  if (boxes) {
    const auto& [s, t] = *boxes;
    const auto is_as_late = [&](double v, double from, double to) {
      return Rational(to) - Rational(from) == time * Rational(v);
    };
    const auto axis = [&](double v, double low, double high, double from, double to) {
      if (v > 0 && high <= from && is_as_late(v, high, from)) return Axis{Sign::positive, high, from};
      if (v < 0 && low >= to && is_as_late(v, low, to)) return Axis{Sign::negative, low, to};
      return Axis{};
    };
    const Vector3& v = by_.shape;
    axes_ = {axis(v.x, s.min.x, s.max.x, t.min.x, t.max.x), axis(v.y, s.min.y, s.max.y, t.min.y, t.max.y),
             axis(v.z, s.min.z, s.max.z, t.min.z, t.max.z)};
  }
  if (!build_plane(b_.triangle(slot_b), slot_a, slot_b, time)) {
    (void)build_plane(a_.triangle(slot_a), slot_a, slot_b, time);
  }
}

bool ContactWalls::build_plane(const PosedTriangle& plane, std::uint32_t slot_a, std::uint32_t slot_b,
                               const Rational& time) {
  Vec3<BigDyadic> up = normal_over<BigDyadic>(plane);
  const auto rise_of = [&] { return dot(velocity_over<BigDyadic>(by_), up); };
  BigDyadic rise = rise_of();
  if (rise.sign() == Sign::zero) return false;
  const bool turned = rise.sign() == Sign::negative;
  if (turned) up = turned_over(up), rise = rise_of();
  const Point3 top = extreme_corner(a_.triangle(slot_a), up, Sign::positive);
  const Point3 bottom = extreme_corner(b_.triangle(slot_b), up, Sign::negative);
  const auto heights = [&]<class T>(const Vec3<T>& way) {
    return Heights<T>{way, dot(image_over<T>(a_.pose, top), way), dot(image_over<T>(b_.pose, bottom), way)};
  };
  Heights<BigDyadic> exact = heights(up);
  const Rational gap = exact_number(exact.of_b) / weight_of(b_.pose) - exact_number(exact.of_a) / weight_of(a_.pose);
  if (!(gap == time * exact_number(rise))) return false;
  const Vec3<Ball> way = normal_over<Ball>(plane);
  plane_ = Plane{heights(turned ? turned_over(way) : way), std::move(exact), VertexSides(a_.bvh.vertices.size()),
                 VertexSides(b_.bvh.vertices.size())};
  return true;
}

bool ContactWalls::stop(const Aabb3& box_a, const Aabb3& box_b) const {
  const auto stops = [](const Axis& wall, double low, double high, double from, double to) {
    return wall.way == Sign::positive   ? high <= wall.of_a && from >= wall.of_b
           : wall.way == Sign::negative ? low >= wall.of_a && to <= wall.of_b
                                        : false;
  };
  return stops(axes_[0], box_a.min.x, box_a.max.x, box_b.min.x, box_b.max.x) ||
         stops(axes_[1], box_a.min.y, box_a.max.y, box_b.min.y, box_b.max.y) ||
         stops(axes_[2], box_a.min.z, box_a.max.z, box_b.min.z, box_b.max.z);
}

bool ContactWalls::stop(std::uint32_t slot_a, std::uint32_t slot_b) {
  if (!plane_) return false;
  const Bvh::Corners &s = a_.bvh.triangles[slot_a], &t = b_.bvh.triangles[slot_b];
  return std::ranges::all_of(s, [&](std::uint32_t v) { return stops_a(v); }) &&
         std::ranges::all_of(t, [&](std::uint32_t v) { return stops_b(v); });
}

bool ContactWalls::stops_a(std::uint32_t vertex) {
  const Point3& p = a_.bvh.vertices[vertex];
  const auto above = [&]<class T>(const Heights<T>& h) { return dot(image_over<T>(a_.pose, p), h.up) - h.of_a; };
  return !plane_->sides_a.is_beyond(
      vertex, [&] { return above(plane_->quick); }, [&] { return above(plane_->exact); });
}

bool ContactWalls::stops_b(std::uint32_t vertex) {
  const Point3& p = b_.bvh.vertices[vertex];
  const auto below = [&]<class T>(const Heights<T>& h) { return h.of_b - dot(image_over<T>(b_.pose, p), h.up); };
  return !plane_->sides_b.is_beyond(
      vertex, [&] { return below(plane_->quick); }, [&] { return below(plane_->exact); });
}

}  // namespace plumb::space
