// What is asked about figures under poses?  A figure as it stands or under a pose, by its type.
//
// Laws: a figure of space is posed by a Pose, a RigidPose or a RigidChain, one of the plane by a Pose2, a RigidPose2 or a
// RigidChain2; what is asked is the exact image, whatever the matrix: sheared, mirrored, or flattened to what it
// becomes; of a rigid pose it is as large and as round as the figure.
// Source: RTCD 3.2.
// Cost: none.
#pragma once

#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/query/body/pairs.hpp"

namespace plumb {

namespace query {

/// A figure whose type the compiler need not know, and its pose, if it has one: of space or of the plane.
struct PosedView {
  FigureView figure;
  AnyPoseView pose{};
};

template <class Shape>
struct Unposed {
  using Type = Shape;
  static constexpr bool is_posed = false;
};
template <class Shape, class By>
struct Unposed<Posed<Shape, By>> {
  using Type = Shape;
  static constexpr bool is_posed = true;
};
template <class Shape>
using UnposedType = typename Unposed<Shape>::Type;
template <class Shape>
inline constexpr bool is_posed = Unposed<Shape>::is_posed;

template <class Shape>
struct PoseOf {
  static constexpr bool fits = true;
};
template <Figure Shape, class By>
struct PoseOf<Posed<Shape, By>> {
  static constexpr bool fits = figure_dimension<Shape> == 3 ? PoseOfSpace<By> : PoseOfPlane<By>;
};
template <class Shape>
inline constexpr bool has_its_pose = PoseOf<Shape>::fits;

/// One of the two is posed, or both are.
template <class A, class B>
concept PosedFigures =
    (is_posed<A> || is_posed<B>)&&Figure<UnposedType<A>>&& Figure<UnposedType<B>>&& has_its_pose<A>&& has_its_pose<B> &&
    (figure_dimension<UnposedType<A>> == figure_dimension<UnposedType<B>>);

template <class Shape>
PosedView posed_view(const Shape& s) {
  if constexpr (!is_posed<Shape>) {
    return {view_of(s)};
  } else {
    return {view_of(s.shape), &s.pose};
  }
}

}  // namespace query

/// A figure as it stands, or under the pose of its space.
template <class Shape>
concept PosedOrNot = Figure<query::UnposedType<Shape>> && query::has_its_pose<Shape>;

}  // namespace plumb
