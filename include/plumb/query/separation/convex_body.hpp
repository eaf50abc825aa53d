// Convex body: which figures are the hull of a few points, or all that is near to such a hull?  What GJK, V-Clip, penetration
// depth and certificates take: points, segments, triangles, convex polygons, boxes of both kinds, rectangles, tetrahedra,
// polytopes with faces or by vertices alone, and, by a core and a radius, balls, capsules, lozenges, hulls of points and
// figures of your own (query/body/rounded_hull.hpp); as they stand or under a pose.
//
// Laws: (1) the corners of a body are numbered as figure/containment/voronoi_region.hpp numbers vertices: those of a box by
// bits, x, y, z, or the axis, where set the greater one; of a lozenge likewise by its edges; else in the order of the members.
// (2) A pose is exact, whatever its matrix; what is round keeps its radius under a RigidPose or a RigidChain, and is as many
// times as large under a Pose whose columns are at right angles and of one rational length.
// Source: RTCD 9.1, 4.5.
// Cost: none; a view refers to the figure.
#pragma once

#include <concepts>
#include <span>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/body/rounded_hull.hpp"

namespace plumb {

/// A polytope by its vertices alone: the hull of these points, of which any may be inside or repeated.
struct VertexHull3 {
  std::span<const Point3> vertices;
};

namespace query {

/// A body whose type the compiler need not know: a figure, or the hull of `vertices` where there is no figure.
struct BodyView {
  FigureView figure{FigureKind::convex_polyhedron, 3, nullptr};
  std::span<const Point3> vertices{};
  AnyPoseView pose{};
  double radius = 0;  // of what is no figure: all within it of the hull

  [[nodiscard]] bool is_hull() const { return figure.shape == nullptr; }
};

template <class Shape>
inline constexpr bool is_vertex_hull = false;
template <>
inline constexpr bool is_vertex_hull<VertexHull3> = true;

constexpr bool is_body_kind(FigureKind kind) {
  return is_one_of(
      kind, {FigureKind::point, FigureKind::segment, FigureKind::triangle, FigureKind::quadrilateral,
             FigureKind::polygon, FigureKind::rectangle, FigureKind::tetrahedron, FigureKind::ball, FigureKind::aabb,
             FigureKind::obb, FigureKind::capsule, FigureKind::lozenge, FigureKind::convex_polyhedron});
}
template <class Shape>
inline constexpr bool is_body_figure = false;
template <Figure Shape>
requires(figure_dimension<Shape> == 3)  //
    inline constexpr bool is_body_figure<Shape> = is_body_kind(figure_kind<Shape>);

/// Of any other kind there is none: Unsupported.
inline BodyView body_view(const AnyFigure& s) {
  const PosedView v = s.view();
  if (v.figure.dimension != 3 || !is_body_kind(v.figure.kind)) refuse_figure("what takes convex bodies", v.figure);
  return {.figure = v.figure, .vertices = {}, .pose = v.pose};
}

inline BodyView body_view(const RoundedHull3& s) { return {.vertices = s.vertices, .radius = s.radius}; }

/// Keeps the places that a view refers to.
struct OwnBody {
  PlacesAndRadius of;
  AnyPoseView pose{};
  operator BodyView() const {
    return {.vertices = of.places, .pose = pose, .radius = of.radius};
  }  // NOLINT: where a view is asked for
};
template <RoundedHullFigure Shape>
OwnBody body_view(const Shape& s) {
  return {places_and_radius(s)};
}

template <class Shape>
requires(!RoundedHullFigure<Shape>)  //
    auto body_view(const Shape& s) {
  if constexpr (is_posed<Shape>) {
    auto v = body_view(s.shape);
    v.pose = &s.pose;
    return v;
  } else if constexpr (is_vertex_hull<Shape>) {
    return BodyView{.vertices = s.vertices};
  } else {
    return BodyView{.figure = view_of(s)};
  }
}

/// What needs no AnyFigure to be one.
template <class Shape>
concept BodyOfTypes =
    is_vertex_hull<Shape> || is_body_figure<Shape> || std::same_as<Shape, RoundedHull3> || RoundedHullFigure<Shape>;

}  // namespace query

/// A convex body of space, as it stands or under a pose; or a figure whose kind is seen when it is asked.
template <class Shape>
concept ConvexBody3 = std::same_as<Shape, AnyFigure> ||
    (query::BodyOfTypes<query::UnposedType<Shape>> && (!query::is_posed<Shape> || requires(const Shape& s) {
       requires PoseOfSpace<std::remove_cvref_t<decltype(s.pose)>>;
     }));

}  // namespace plumb
