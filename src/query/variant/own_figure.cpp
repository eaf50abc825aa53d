#include "plumb/query/variant/own_figure.hpp"

#include "arith/exact_number.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/convex/containment.hpp"
#include "query/body/posed_input.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

/// The convex hull of the points, by whichever kind it is of.
AnyFigure hull_of(std::span<const Point3> points) {
  const Hull3 hull = convex_hull(points);
  const auto vertex = [&](std::size_t i) { return points[hull.vertices[i]]; };
  if (hull.dimension == -1) throw InvalidShape("a rounded hull of no places is empty; give one that has a point");
  if (hull.dimension == 0) return vertex(0);
  if (hull.dimension == 1) return Segment3{vertex(0), vertex(1)};
  if (hull.dimension == 3) return convex_polyhedron(hull, points);
  Polygon3 polygon;
  for (const std::uint32_t i : hull.face(0)) polygon.vertices.push_back(points[i]);
  return polygon;
}

bool is_thin(const RoundedView& a, const RoundedView& b) { return a.radius == 0 && b.radius == 0; }
Rational reach_of(const RoundedView& a, const RoundedView& b) { return Rational(a.radius) + Rational(b.radius); }

/// Of the figures, without their radii; the inset is that of both.
ExactDistance gap(const RoundedView& a, const RoundedView& b, Question question) {
  ExactDistance d = any_exact_distance(a.figure, b.figure, question);
  d.inset = d.inset + reach_of(a, b);
  return d;
}

constexpr bool is_convex_kind(FigureKind kind) {
  return !is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon});
}

}  // namespace

RoundedFigure rounded_figure(const PlacesAndRadius& of) {
  const AnyFigure hull = hull_of(of.places);
  if (of.radius > 0) {
    if (const Point3* p = get_if<Point3>(hull)) return {Sphere3{*p, of.radius}};
    if (const Segment3* s = get_if<Segment3>(hull)) return {Capsule3{s->a, s->b, of.radius}};
  }
  return {hull, of.radius};
}

RoundedFigure posed_figure(std::string_view function, const RoundedFigure& s, const AnyPose& pose) {
  RoundedFigure there{s.figure.under(pose), s.radius};
  if (s.radius > 0 && !is_rigid(there.figure.view().pose)) {
    throw UnevenPose(std::string(function) +
                     ": all within a radius of a hull is that of its image under a rigid pose " + "alone; " +
                     std::string(rigid_instead));
  }
  return there;
}

PosedView require_kind(std::string_view function, const RoundedView& s) {
  if (s.radius == 0) return s.figure;
  throw Unsupported(std::string(function) + " has no answer for a hull of places that are not on one line, and all " +
                    "within a radius of it; relate, distance, gjk and penetration have one");
}

// As Fat (query/separation/fat.hpp) decides it: of sets that meet or nearly do the distance is zero, whether they touch,
// so that the square tells, against that of the reach.
Relation rounded_relate(std::string_view function, const RoundedView& a, const RoundedView& b) {
  if (is_thin(a, b)) {
    if (function == "relate") return any_relate(a.figure, b.figure);
    return any_intersects(a.figure, b.figure) ? Relation::overlapping : Relation::disjoint;
  }
  const ExactDistance d = gap(a, b, function == "relate" ? Question::relate : Question::intersects);
  const auto order = d.square <=> d.inset * d.inset;
  return order > 0 ? Relation::disjoint : order < 0 ? Relation::overlapping : Relation::touching;
}

bool rounded_contains(const RoundedView& outer, const RoundedView& inner) {
  if (is_thin(outer, inner)) return any_contains(outer.figure, inner.figure);
  const FigureKind kind = outer.figure.figure.kind;
  if (outer.radius > 0) {  // of a point alone: whether the two meet
    if (inner.figure.figure.kind != FigureKind::point || inner.radius > 0) require_kind("contains", outer);
    return rounded_relate("contains", outer, inner) != Relation::disjoint;
  }
  // What is convex holds the hull of balls where it holds each of them.
  if (!is_convex_kind(kind)) require_kind("contains", inner);
  bool all = true;
  with_figure(inner.figure.figure, [&]<class Shape>(const Shape& s) {
    const auto holds = [&](const Point3& p) {
      const Sphere3 ball{p, inner.radius};
      all = all && any_contains(outer.figure, {view_of(ball), inner.figure.pose});
    };
    if constexpr (std::is_same_v<Shape, Polygon3>) {
      for (const Point3& p : s.vertices) holds(p);
    } else if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
      for (const Point3& p : s.mesh.vertices) holds(p);
    }
  });
  return all;
}

ExactDistance rounded_exact_distance(const RoundedView& a, const RoundedView& b, Question question) {
  const ExactDistance d = gap(a, b, question);
  if (is_thin(a, b) || d.square > d.inset * d.inset) return d;
  return {Rational(0.0), Rational(0.0)};  // they meet
}

double rounded_distance_as(const RoundedView& a, const RoundedView& b, Question question) {
  if (is_thin(a, b)) return any_distance(a.figure, b.figure, question);
  const ExactDistance d = gap(a, b, question);
  return rounded_distance(gmp_number(d.square), gmp_number(d.inset));
}

}  // namespace plumb::query
