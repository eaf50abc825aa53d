// Support mapping of a figure: which farthest points tell GJK of a cylinder, a cone, an ellipsoid or a cap?
//
//   const GjkBounds b = gjk_bounds(cylinder, box, {.within = 1e-9});
//
// What GJK, certificates, V-Clip and penetration take exactly is the hull of corners, and all within a radius of it
// (query/separation/convex_body.hpp).  A cylinder, a cone, an ellipsoid and the cap of a ball are neither: the distance
// between two of them is a root of a polynomial of a high degree.  They are known by their support points, whose
// coordinates are exact and rounded once, and what is told of them is an interval that certainly holds the number.
// Where a decision suffices, relate decides by quadratic signs: ellipsoids with one another and with what has straight
// edges (query/overlap/ellipsoid.hpp), caps, and cylinders and cones with flat figures (query/body/pairs.hpp).
// Laws: (1) those of gjk_bounds, the other figure being any that support_point takes.  (2) The rounding is derived:
// that of three coordinates which are the nearest doubles, of the size of the figure's greatest; options may state
// more.  (3) Equal to gjk_bounds of two mappings with that rounding.  (4) A figure under a pose is its exact image,
// whatever the matrix, rigid poses and chains among them; its rounding is derived from the figure's, the pose and that
// of the direction before it, some 2^-46 of the image's size.  (5) Of an AnyFigure it is that of its kind.
// Errors: those of support_point, in its name, and as it: a pose with NaN or infinity throws NonFinite, an image beyond all
// doubles BeyondDoubles.
// Source: RTCD 9.5.3; van den Bergen 1999 (support mappings of quadrics).
// Cost: that of support_point a step beside that of gjk_bounds; some microseconds more under a pose.  Bounded by
// n operations of support_point a step for n corners; of steps round figures take some tens.
#pragma once

#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/figure/support/support.hpp"
#include "plumb/query/gjk/support_mapping.hpp"
#include "plumb/query/separation/convex_body.hpp"

namespace plumb {

namespace query {

template <class Shape>
concept StandingFigure3 = std::same_as<Shape, Point3> || std::same_as<Shape, VertexHull3> ||
    requires(const Shape& s, const Vector3& direction) {
  { support_point(s, direction) } -> std::same_as<Support3>;
};

/// Along which direction the shape lies farthest before its pose: the nearest doubles of that times a power of two.
Vector3 direction_before(PoseView pose, const Vector3& direction);
/// How far from the exact one a point can be whose coordinates are the nearest doubles, no larger than this.
double rounding_of_point(double largest);
/// Of points whose coordinates are no larger than `largest`, and no more than `off` away from exact ones.
double rounding_of_image(PoseView pose, double largest, double off);

}  // namespace query

/// Whose farthest points are known to the last bit, as it stands or under a pose; or a figure whose kind is seen when it is
/// asked.
template <class Shape>
concept SupportedFigure3 = std::same_as<Shape, AnyFigure> ||
    (query::StandingFigure3<query::UnposedType<Shape>> &&
     (!query::is_posed<Shape> || requires(const Shape& s) { PoseView(s.pose); }));

/// Round by a quadric that is no core with a radius: a cylinder, a cone, an ellipsoid, a cap; or the image of one.
template <class Shape>
concept QuadricBody3 =
    std::same_as<query::UnposedType<Shape>, Cylinder3> || std::same_as<query::UnposedType<Shape>, Cone3> ||
    std::same_as<query::UnposedType<Shape>, Ellipsoid3> || std::same_as<query::UnposedType<Shape>, SphericalCap3>;

/// The mapping of a figure, which it refers to.
template <SupportedFigure3 Shape>
class FigureSupport3 {
 public:
  explicit FigureSupport3(const Shape& s) : shape_(&s) {}

  Point3 operator()(const Vector3& direction) const {
    if constexpr (std::same_as<Shape, Point3>) {
      return *shape_;
    } else if constexpr (std::same_as<Shape, VertexHull3>) {
      return support_point(shape_->vertices, direction).point;
    } else {
      return support_point(*shape_, direction).point;
    }
  }
  /// No coordinate of a point is larger.
  [[nodiscard]] double largest() const {
    double most = 0;
    const auto see = [&](double x) {
      const double size = __builtin_fabs(x);
      most = size > most ? size : most;
    };
    for (const double to : {1.0, -1.0}) {
      see((*this)({to, 0, 0}).x), see((*this)({0, to, 0}).y), see((*this)({0, 0, to}).z);
    }
    return most;
  }
  /// How far off a point can be.
  [[nodiscard]] double rounding() const { return query::rounding_of_point(largest()); }

 private:
  const Shape* shape_;
};

/// Of an exact image.
template <SupportedFigure3 Shape>
class ImageSupport3 {
 public:
  ImageSupport3(const Shape& s, PoseView pose) : figure_(s), pose_(pose) {}

  Point3 operator()(const Vector3& direction) const {
    return rounded_image(pose_, figure_(query::direction_before(pose_, direction)));
  }
  [[nodiscard]] double rounding() const {
    return query::rounding_of_image(pose_, figure_.largest(), figure_.rounding());
  }

 private:
  FigureSupport3<Shape> figure_;
  PoseView pose_;
};
template <SupportedFigure3 Shape>
requires(query::is_posed<Shape>)  //
    class FigureSupport3<Shape> : public ImageSupport3<query::UnposedType<Shape>> {
 public:
  explicit FigureSupport3(const Shape& s) : ImageSupport3<query::UnposedType<Shape>>(s.shape, s.pose) {}
};

/// That of its kind; a kind that has none, and one of the plane, throws Unsupported.
template <>
class FigureSupport3<AnyFigure> {
 public:
  explicit FigureSupport3(const AnyFigure& s) : figure_(&s) {}

  Point3 operator()(const Vector3& direction) const;
  [[nodiscard]] double rounding() const;

 private:
  const AnyFigure* figure_;
};

namespace query {

template <class Options, class A, class B>
Options with_rounding(Options options, const FigureSupport3<A>& a, const FigureSupport3<B>& b) {
  for (const double off : {a.rounding(), b.rounding()}) {
    options.rounding = off > options.rounding ? off : options.rounding;
  }
  return options;
}

}  // namespace query

template <SupportedFigure3 A, SupportedFigure3 B>
GjkBounds gjk_bounds(const A& a, const B& b, const GjkBoundsOptions& options = {}) {
  const FigureSupport3<A> of_a(a);
  const FigureSupport3<B> of_b(b);
  return gjk_bounds(of_a, of_b, query::with_rounding(options, of_a, of_b));
}

}  // namespace plumb
