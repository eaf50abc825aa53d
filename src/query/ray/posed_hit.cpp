// Where a line enters each convex piece of a posed figure, by what bounds it; of round ones as the line is seen before the
// pose.
#include <cstdlib>
#include <string>

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/ray/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/rounded_root.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/ray/posed_box.hpp"
#include "query/ray/posed_faces.hpp"
#include "query/ray/posed_triangle.hpp"
#include "query/ray/seen_line.hpp"

namespace plumb::query {
namespace {

/// All from + t along with t in the span.
struct ExactShot {
  Exact3 from, along;
  std::optional<mpq_class> least, most;
};

ExactShot exact_shot(const PosedView& v) {
  const PosedSet s = posed_set(v);
  const FlatSet ray = image(s);
  ExactShot shot{ray.points[0], {0, 0, 0}, {}, {}};
  if (v.figure.kind != FigureKind::line) shot.least = 0;
  if (v.figure.kind == FigureKind::segment) {
    shot.along = ray.points[1] - ray.points[0];
    shot.most = 1;
  } else if (!ray.directions.empty()) {
    shot.along = ray.directions[0];
  } else if (!ray.lines.empty()) {
    shot.along = ray.lines[0];
  }
  if (is_zero(shot.along)) shot.least = shot.most = 0;  // the point that it is
  return shot;
}

bool is_empty_span(const ExactShot& s) { return s.least && s.most && *s.least > *s.most; }

/// The least t that is left, or that nearest to zero.
mpq_class first_of_span(const ExactShot& s) {
  if (s.least) return *s.least;
  return s.most && sgn(*s.most) < 0 ? *s.most : mpq_class(0);
}

std::optional<mpq_class> first_in(ExactShot s, const FlatSet& set) {
  if (set.points.empty()) return {};
  for (const auto& [normal, offset] : halfspaces_of(set)) {
    const mpq_class slope = dot(normal, s.along), room = offset - dot(normal, s.from);
    if (sgn(slope) == 0 && sgn(room) < 0) return {};
    if (sgn(slope) == 0) continue;
    const mpq_class t = room / slope;
    if (sgn(slope) > 0 && (!s.most || t < *s.most)) s.most = t;
    if (sgn(slope) < 0 && (!s.least || t > *s.least)) s.least = t;
    if (is_empty_span(s)) return {};
  }
  return first_of_span(s);
}

/// Of a figure with straight edges and flat faces.
std::optional<mpq_class> first_in_flat(std::string_view function, const ExactShot& shot, const PosedSet& s,
                                       const PosedView& figure) {
  std::vector<FlatSet> pieces;
  if (figure.figure.kind != FigureKind::ball && is_polygon(figure.figure)) {
    const ExactChains chains = image(s.map, exact_chains(function, figure.figure));
    pieces = trapezoids(chains);
    for (FlatSet& edge : edges_of(chains)) pieces.push_back(std::move(edge));
  } else {
    pieces.push_back(image(s));
  }
  std::optional<mpq_class> first;
  for (const FlatSet& piece : pieces) {
    const auto t = first_in(shot, piece);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

Vec3<Rational> exact_vector(const Exact3& v) { return {exact_number(v[0]), exact_number(v[1]), exact_number(v[2])}; }
Exact3 exact_vector(const Vec3<Rational>& v) { return {gmp_number(v.x), gmp_number(v.y), gmp_number(v.z)}; }

/// Of that kind, with a direction or without one.
AnyRay ray_of_kind(FigureKind kind, bool has_direction) {
  const double along = has_direction ? 1 : 0;
  if (kind == FigureKind::segment) return Segment3{{0, 0, 0}, {along, 0, 0}};
  if (kind == FigureKind::line) return Line3{{0, 0, 0}, {along, 0, 0}};
  return Ray3{{0, 0, 0}, {along, 0, 0}};
}

/// Of what is round, under a pose that is not singular: as it sees the line.
std::optional<SeenHit> hit_before_pose(const ExactShot& shot, FigureKind ray, const PosedSet& s, const FigureView& v) {
  const ExactMap back = inverse(s.map);
  const SeenLine line{ray_of_kind(ray, !is_zero(shot.along)), exact_vector(image(back, shot.from)),
                      exact_vector(turned(back, shot.along))};
  return with_figure(v, [&](const auto& figure) -> std::optional<SeenHit> {
    if constexpr (requires { seen_hit(line, figure); }) {
      return seen_hit(line, figure);
    } else {
      std::abort();  // sees_line told that it does not see the line
    }
  });
}

/// Does the figure see the line?  What is round and has a radius must, or all of it becomes a point.
bool sees_line(std::string_view function, const PosedSet& s, const FigureView& figure) {
  if (is_flat_kind(figure.kind)) return false;
  if (!is_singular(s.map)) return true;
  if (!s.is_round() && !s.has_axis()) return false;
  throw UnevenPose(std::string(function)
                       .append(": ")
                       .append(spoken(figure))
                       .append(": its pose flattens it; give one whose matrix is not singular"));
}

/// base + share * root of t's square, of the sign that t has: rounded once.
double rounded_at(const mpq_class& base, const mpq_class& share, const RayParameter& t) {
  return rounded_with_root(Rounding::nearest, base, t.greater ? share : mpq_class(-share), gmp_number(t.square));
}

Hit rounded_hit(const SeenHit& seen, const ExactShot& shot, const ExactMap& map) {
  const mpq_class& base = gmp_number(seen.t.base);
  const auto at = [&](const Exact3& still, const Exact3& moving) {
    const Exact3 x = still + base * moving;
    return std::array{rounded_at(x[0], moving[0], seen.t), rounded_at(x[1], moving[1], seen.t),
                      rounded_at(x[2], moving[2], seen.t)};
  };
  const auto [x, y, z] = at(shot.from, shot.along);
  const auto [u, v, w] = at(outward(map, exact_vector(seen.still)), outward(map, exact_vector(seen.moving)));
  return {seen.t.rounded() + 0.0, {x, y, z}, seen.feature, {u, v, w}};
}

bool is_inside(const FigureView& figure, const Feature& feature) {
  return feature.kind == FeatureKind::interior || (figure.dimension == 2 && feature.kind == FeatureKind::face);
}

/// Of what is round by a radius of zero, or maps to a point, under a pose that is singular: which feature of it.  The
/// first face holds all others, of lozenges as well: its zone is closed.
Feature feature_of_thin(const FigureView& figure, const ExactMap& map, const Exact3& point) {
  return with_figure(figure, [&]<class Shape>(const Shape& s) -> Feature {
    const auto is_at = [&](const Point3& p) { return image(map, {p.x, p.y, p.z}) == point; };
    if constexpr (std::is_same_v<Shape, Cylinder3>) {
      if (s.a != s.b && is_at(s.a)) return {FeatureKind::edge, 0};
      if (s.a != s.b && is_at(s.b)) return {FeatureKind::edge, 1};
    } else if constexpr (std::is_same_v<Shape, Cone3>) {
      if (s.apex != s.base && is_at(s.apex)) return {FeatureKind::vertex, 0};
      if (s.apex != s.base && is_at(s.base)) return {FeatureKind::edge, 0};
    }
    return {figure.dimension == 2 ? FeatureKind::edge : FeatureKind::face, 0};
  });
}

double nearest(const mpq_class& x) { return rounded(Rounding::nearest, x) + 0.0; }

}  // namespace

std::optional<Hit> posed_first_hit(const AnyRay& ray, const Posed<Triangle3>& triangle, HitRule rule) {
  const PosedView view = posed_view(triangle);
  as_given(ray, [&](const auto& given) { require_posed("first_hit", posed_view(given), view); });
  return first_hit(ray, PosedTriangle3(triangle), rule);
}

std::optional<Hit> posed_first_hit(const PosedView& ray, const PosedView& figure) {
  require_posed("first_hit", ray, figure);
  if (const auto told = first_hit_of_box(ray, figure)) return *told;
  const ExactShot shot = exact_shot(ray);
  const PosedSet s = posed_set(figure);
  if (sees_line("first_hit", s, figure.figure)) {
    const auto seen = hit_before_pose(shot, ray.figure.kind, s, figure.figure);
    return seen ? std::optional(rounded_hit(*seen, shot, s.map)) : std::nullopt;
  }
  const auto t = first_in_flat("first_hit", shot, s, figure);
  if (!t) return {};
  const Exact3 point = shot.from + *t * shot.along;
  // What is near by a radius of zero is all of its surface, which has no side.
  const bool is_thin = !is_flat_kind(figure.figure.kind);
  const Feature feature =
      is_thin ? feature_of_thin(figure.figure, s.map, point) : hit_feature(figure.figure, s.map, point);
  Hit hit{nearest(*t), {nearest(point[0]), nearest(point[1]), nearest(point[2])}, feature, {0, 0, 0}};
  if (is_thin || is_inside(figure.figure, feature)) return hit;
  const Exact3 normal = normal_at(figure.figure, s.map, point, shot.along);
  hit.normal = {nearest(normal[0]), nearest(normal[1]), nearest(normal[2])};
  return hit;
}

std::optional<RayParameter> posed_first_hit_parameter(std::string_view function, const PosedView& ray,
                                                      const PosedView& figure) {
  require_posed(function, ray, figure);
  if (const auto told = first_parameter_of_box(ray, figure)) return *told;
  const ExactShot shot = exact_shot(ray);
  const PosedSet s = posed_set(figure);
  if (sees_line(function, s, figure.figure)) {
    const auto seen = hit_before_pose(shot, ray.figure.kind, s, figure.figure);
    return seen ? std::optional(seen->t) : std::nullopt;
  }
  const auto first = first_in_flat(function, shot, s, figure);
  if (!first) return {};
  return RayParameter{exact_number(*first)};
}

}  // namespace plumb::query
