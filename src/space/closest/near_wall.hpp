// Which pairs of triangles are surely no nearer than the nearest pair as yet?
//
// The way from one closest point to the other keeps the two triangles apart, and with them all pairs of which one lies
// behind the first point along it and the other ahead of the second.
// Law: what a wall stops is no nearer than the pair that it was built for.
// Source: RTCD 5.1.10, 9.5.
// Cost: the closest points exactly, and a sign a vertex, which is kept.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "query/closest/posed_triangle.hpp"
#include "space/closest/vertex_sides.hpp"

namespace plumb::space {

template <class Source>
class NearWall {
 public:
  NearWall(const Source& a, const Source& b) : a_(a), b_(b) {}

  [[nodiscard]] bool is_built() const { return wall_.has_value(); }
  void clear() { wall_.reset(); }
  void build(std::uint32_t slot_a, std::uint32_t slot_b) {
    const query::PosedTriangle3 s{Source::as_given(a_.triangle(slot_a)), a_.pose()},
        t{Source::as_given(b_.triangle(slot_b)), b_.pose()};
    const auto quick = query::quick_closest_points(s, t);
    wall_ = Wall{quick ? std::optional(Slab<Ball>(*quick, a_.pose(), b_.pose())) : std::nullopt,
                 Slab<BigDyadic>(query::exact_closest_points(s, t), a_.pose(), b_.pose()),
                 VertexSides(a_.bvh().vertices.size()), VertexSides(b_.bvh().vertices.size())};
  }

  [[nodiscard]] bool stops(std::uint32_t slot_a, std::uint32_t slot_b) {
    return wall_ && is_behind_slot(slot_a) && is_ahead_slot(slot_b);
  }
  /// The wall must have been built.
  [[nodiscard]] bool is_behind_slot(std::uint32_t slot) {
    return std::ranges::all_of(a_.bvh().triangles[slot], [&](std::uint32_t v) { return is_behind(v); });
  }
  [[nodiscard]] bool is_ahead_slot(std::uint32_t slot) {
    return std::ranges::all_of(b_.bvh().triangles[slot], [&](std::uint32_t v) { return is_ahead(v); });
  }

 private:
  template <class T>
  struct Slab {
    query::WeightedPose<T> pose_a, pose_b;
    query::Vec3<T> way;  // from the closest point of a to that of b, of any length
    T weight_a, weight_b, from, to;

    Slab(const query::WeightedPair<T>& p, const AnyPoseView& a, const AnyPoseView& b)
        : pose_a(query::weighted_pose<T>(a)),
          pose_b(query::weighted_pose<T>(b)),
          way(p[1].at * p[0].weight - p[0].at * p[1].weight),
          weight_a(p[0].weight),
          weight_b(p[1].weight),
          from(dot(p[0].at, way)),
          to(dot(p[1].at, way)) {}
    [[nodiscard]] T beyond_from(const Point3& p) const {
      return dot(pose_a.image(query::vector_of<T>(p)), way) * weight_a - from * pose_a.weight;
    }
    [[nodiscard]] T before_to(const Point3& p) const {
      return to * pose_b.weight - dot(pose_b.image(query::vector_of<T>(p)), way) * weight_b;
    }
  };
  struct Wall {
    std::optional<Slab<Ball>> quick;
    Slab<BigDyadic> exact;
    VertexSides sides_a, sides_b;
  };

  static Ball nothing() { return {0, 0, Ball::infinity}; }

  bool is_behind(std::uint32_t vertex) {
    const Point3& p = a_.bvh().vertices[vertex];
    return !wall_->sides_a.is_beyond(
        vertex, [&] { return wall_->quick ? wall_->quick->beyond_from(p) : nothing(); },
        [&] { return wall_->exact.beyond_from(p); });
  }
  bool is_ahead(std::uint32_t vertex) {
    const Point3& p = b_.bvh().vertices[vertex];
    return !wall_->sides_b.is_beyond(
        vertex, [&] { return wall_->quick ? wall_->quick->before_to(p) : nothing(); },
        [&] { return wall_->exact.before_to(p); });
  }

  const Source &a_, &b_;
  std::optional<Wall> wall_;
};

}  // namespace plumb::space
