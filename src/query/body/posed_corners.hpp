// Where are the corners of a triangle under any pose, over any number type?  Times the weight of the pose
// (query/body/weighted_pose.hpp), so that nothing is divided.
//
// Laws: exact over numbers that are; of a triangle that stands or is under a matrix the weight is 1.
// Source: RTCD 3.2; Hamilton's product.
// Cost: nine products a corner, and what the pose takes.
#pragma once

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {

/// As it stands or under a pose of space, which must outlive it.
struct PosedTriangle3 {
  Triangle3 shape;
  AnyPoseView pose{};

  PosedTriangle3(const Triangle3& t, const AnyPoseView& by) : shape(t), pose(by) {}
  template <PoseOfSpace By>
  PosedTriangle3(const Posed<Triangle3, By>& t) : shape(t.shape), pose(&t.pose) {}  // NOLINT: stands for it
  template <class Kept>
  requires requires(const Kept& t) { t.pose.any_view(); }
  PosedTriangle3(const Kept& t) : shape(t.shape), pose(t.pose.any_view()) {}  // NOLINT: stands for it
};

/// As given.
inline PosedTriangle3 standing(const Triangle3& t) { return {t, AnyPoseView()}; }
inline PosedTriangle3 standing(const Segment3& s) { return {{s.a, s.b, s.b}, AnyPoseView()}; }

inline PosedView posed_view(const PosedTriangle3& t) { return {view_of(t.shape), t.pose}; }

/// matrix * p + translation.
template <class T>
Vec3<T> posed(const Point3& p, const Pose& pose) {
  const auto& [c, t] = pose;
  return vector_of<T>(c[0]) * T(p.x) + vector_of<T>(c[1]) * T(p.y) + vector_of<T>(c[2]) * T(p.z) + vector_of<T>(t);
}

/// The corners times the weight, and what is seen beside them: as many times what is given.
template <class T>
struct WeightedCorners {
  WeightedPose<T> by;
  std::array<Vec3<T>, 3> at;

  explicit WeightedCorners(const PosedTriangle3& t) : WeightedCorners(weighted_pose<T>(t.pose), t.shape) {}
  [[nodiscard]] Vec3<T> beside(const Vec3<T>& p) const { return by.has_weight ? p * by.weight : p; }
  [[nodiscard]] T beside(const T& x) const { return by.has_weight ? x * by.weight : x; }

 private:
  WeightedCorners(const WeightedPose<T>& pose, const Triangle3& t)
      : by(pose), at{by.image(vector_of<T>(t.a)), by.image(vector_of<T>(t.b)), by.image(vector_of<T>(t.c))} {}
};

/// Those of two triangles, each times the weights of both.
template <class T>
struct CornersTogether {
  std::array<Vec3<T>, 3> a, b;
  T weight;
  bool has_weight;

  CornersTogether(const PosedTriangle3& s, const PosedTriangle3& t)
      : CornersTogether(WeightedCorners<T>(s), WeightedCorners<T>(t)) {}

 private:
  CornersTogether(const WeightedCorners<T>& s, const WeightedCorners<T>& t)
      : a{t.beside(s.at[0]), t.beside(s.at[1]), t.beside(s.at[2])},
        b{s.beside(t.at[0]), s.beside(t.at[1]), s.beside(t.at[2])},
        weight(s.beside(t.by.weight)),
        has_weight(s.by.has_weight || t.by.has_weight) {}
};

}  // namespace plumb::query
