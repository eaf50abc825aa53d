// Where a line enters each convex piece of a posed figure, by what bounds it; of round ones as the line is seen before the
// pose.
#include <string>

#include "arith/big_rounding.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/ray/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_set.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/ray/posed_faces.hpp"
#include "query/ray/posed_round.hpp"
#include "query/ray/posed_triangle.hpp"
#include "query/ray/shot.hpp"

namespace plumb::query {
namespace {

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

/// The line before the figure's pose.
ExactShot as_seen(std::string_view function, const ExactShot& shot, const PosedSet& s, const FigureView& figure) {
  if (is_singular(s.map)) {
    throw UnevenPose(std::string(function)
                         .append(": ")
                         .append(spoken(figure))
                         .append(": its pose flattens it; give one whose matrix is not singular"));
  }
  const ExactMap back = inverse(s.map);
  return {image(back, shot.from), turned(back, shot.along), shot.least, shot.most};
}

bool is_inside(const FigureView& figure, const Feature& feature) {
  return feature.kind == FeatureKind::interior || (figure.dimension == 2 && feature.kind == FeatureKind::face);
}

/// Of a ball or a capsule.
std::optional<Hit> hit_posed_round(const ExactShot& shot, const PosedSet& s, const FigureView& figure) {
  const ExactShot seen = as_seen("first_hit", shot, s, figure);
  const auto t = first_in_fat(seen, s.core, s.radius);
  if (!t) return {};
  const RoundMeeting met = round_meeting(seen, s.core, s.radius, *t);
  const mpq_class& base = t->base.value().value;
  const auto at = [&](const Exact3& still, const Exact3& moving) {
    const Exact3 x = still + base * moving;
    return std::array{rounded_at(x[0], moving[0], *t), rounded_at(x[1], moving[1], *t),
                      rounded_at(x[2], moving[2], *t)};
  };
  const bool in_plane = figure.dimension == 2;
  const auto [x, y, z] = at(shot.from, shot.along);
  Hit hit{t->rounded(), {x, y, z}, {in_plane ? FeatureKind::face : FeatureKind::interior, 0}, {0, 0, 0}};
  if (!met.part) return hit;
  hit.feature = {in_plane ? FeatureKind::edge : FeatureKind::face, *met.part};
  const auto [u, v, w] = at(outward(s.map, met.still), outward(s.map, met.moving));
  hit.normal = {u, v, w};
  return hit;
}

double nearest(const mpq_class& x) { return rounded(Rounding::nearest, x) + 0.0; }
Rational exact_number(const mpq_class& x) { return Rational(BigRational{x}); }

}  // namespace

std::optional<Hit> posed_first_hit(const AnyRay& ray, const Posed<Triangle3>& triangle, HitRule rule) {
  const PosedView view = posed_view(triangle);
  as_given(ray, [&](const auto& given) { require_posed("first_hit", posed_view(given), view); });
  return first_hit(ray, triangle, rule);
}

std::optional<Hit> posed_first_hit(const PosedView& ray, const PosedView& figure) {
  require_posed("first_hit", ray, figure);
  const ExactShot shot = exact_shot(ray);
  const PosedSet s = posed_set(figure);
  if (s.is_round()) return hit_posed_round(shot, s, figure.figure);
  const auto t = first_in_flat("first_hit", shot, s, figure);
  if (!t) return {};
  const Exact3 point = shot.from + *t * shot.along;
  // What is near by a radius of zero is a point or a segment, which is all of its surface.
  const bool is_thin = is_one_of(figure.figure.kind, {FigureKind::ball, FigureKind::capsule});
  const FeatureKind surface = figure.figure.dimension == 2 ? FeatureKind::edge : FeatureKind::face;
  const Feature feature = is_thin ? Feature{surface, 0} : hit_feature(figure.figure, s.map, point);
  Hit hit{nearest(*t), {nearest(point[0]), nearest(point[1]), nearest(point[2])}, feature, {0, 0, 0}};
  if (is_thin || is_inside(figure.figure, feature)) return hit;
  const Exact3 normal = normal_at(figure.figure, s.map, point, shot.along);
  hit.normal = {nearest(normal[0]), nearest(normal[1]), nearest(normal[2])};
  return hit;
}

std::optional<RayParameter> posed_first_hit_parameter(std::string_view function, const PosedView& ray,
                                                      const PosedView& figure) {
  require_posed(function, ray, figure);
  const ExactShot shot = exact_shot(ray);
  const PosedSet s = posed_set(figure);
  if (s.is_round()) {
    return first_in_fat(as_seen(function, shot, s, figure.figure), s.core, s.radius);
  }
  const auto first = first_in_flat(function, shot, s, figure);
  if (!first) return {};
  return RayParameter{exact_number(*first)};
}

}  // namespace plumb::query
