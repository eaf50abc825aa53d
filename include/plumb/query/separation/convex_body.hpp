// Convex body: which figures are the hull of a few points, or all that is near to such a hull?  What GJK, V-Clip, penetration
// depth and certificates take: points, segments, triangles, convex polygons, boxes of both kinds, rectangles, tetrahedra,
// polytopes with faces or by vertices alone, and, by a core and a radius, balls, capsules and lozenges; as they stand or
// under a pose.
//
// Laws: (1) the corners of a body are numbered as figure/containment/voronoi_region.hpp numbers vertices: those of a box by
// bits, x, y, z, or the axis, where set the greater one; of a lozenge likewise by its edges; else in the order of the members.
// (2) A pose is exact, whatever its matrix; what is round keeps its radius under a RigidPose or a RigidChain, and is as many
// times as large under a Pose whose columns are at right angles and of one rational length.
// Source: RTCD 9.1, 4.5.
// Cost: none; a view refers to the figure.
#pragma once

#include <span>

#include "plumb/query/body/posed.hpp"

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
  PoseView pose{};

  [[nodiscard]] bool is_hull() const { return figure.shape == nullptr; }
};

template <class Shape>
inline constexpr bool is_vertex_hull = false;
template <>
inline constexpr bool is_vertex_hull<VertexHull3> = true;

template <class Shape>
inline constexpr bool is_body_figure = false;
template <Figure Shape>
requires(figure_dimension<Shape> == 3)  //
    inline constexpr bool is_body_figure<Shape> =
        is_one_of(figure_kind<Shape>, {FigureKind::point, FigureKind::segment, FigureKind::triangle,
                                       FigureKind::quadrilateral, FigureKind::polygon, FigureKind::rectangle,
                                       FigureKind::tetrahedron, FigureKind::ball, FigureKind::aabb, FigureKind::obb,
                                       FigureKind::capsule, FigureKind::lozenge, FigureKind::convex_polyhedron});

template <class Shape>
BodyView body_view(const Shape& s) {
  if constexpr (is_posed<Shape>) {
    BodyView v = body_view(s.shape);
    v.pose = &s.pose;
    return v;
  } else if constexpr (is_vertex_hull<Shape>) {
    return {.vertices = s.vertices};
  } else {
    return {.figure = view_of(s)};
  }
}

}  // namespace query

/// A convex body of space, as it stands or under a pose.
template <class Shape>
concept ConvexBody3 =
    (query::is_vertex_hull<query::UnposedType<Shape>> ||
     query::is_body_figure<query::UnposedType<Shape>>)&&(!query::is_posed<Shape> || requires(const Shape& s) {
      requires PoseOfSpace<std::remove_cvref_t<decltype(s.pose)>>;
    });

}  // namespace plumb
