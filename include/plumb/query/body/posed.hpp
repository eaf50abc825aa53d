// What is asked about figures under poses?  A figure as it stands or under a pose, by its type.
//
// Laws: a figure of space is posed by a Pose, one of the plane by a Pose2; what is asked is the exact image, whatever
// the matrix: sheared, mirrored, or flattened to what it becomes.
// Source: RTCD 3.2.
// Cost: none.
#pragma once

#include "plumb/arith/pose.hpp"
#include "plumb/query/body/pairs.hpp"

namespace plumb {

namespace query {

/// A figure whose type the compiler need not know, and its pose, if it has one: of space or of the plane.
struct PosedView {
  FigureView figure;
  const Pose* in_space = nullptr;
  const Pose2* in_plane = nullptr;
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
template <Figure Shape>
struct PoseOf<Posed<Shape, Pose>> {
  static constexpr bool fits = figure_dimension<Shape> == 3;
};
template <Figure Shape>
struct PoseOf<Posed<Shape, Pose2>> {
  static constexpr bool fits = figure_dimension<Shape> == 2;
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
  } else if constexpr (figure_dimension<UnposedType<Shape>> == 3) {
    return {view_of(s.shape), &s.pose, nullptr};
  } else {
    return {view_of(s.shape), nullptr, &s.pose};
  }
}

}  // namespace query

/// A figure as it stands, or under the pose of its space.
template <class Shape>
concept PosedOrNot = Figure<query::UnposedType<Shape>> && query::has_its_pose<Shape>;

}  // namespace plumb
