// Where a line enters each convex piece of a posed figure, by what bounds it; of round ones as the line is seen before the
// pose.
#include <string>

#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/ray/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_set.hpp"
#include "query/overlap/polygon_relation.hpp"
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

Rational exact_number(const mpq_class& x) { return Rational(BigRational{x}); }

}  // namespace

std::optional<Hit> posed_first_hit(const AnyRay& ray, const Posed<Triangle3>& triangle, HitRule rule) {
  const PosedView view = posed_view(triangle);
  as_given(ray, [&](const auto& given) { require_posed("first_hit", posed_view(given), view); });
  return first_hit(ray, triangle, rule);
}

std::optional<RayParameter> posed_first_hit_parameter(std::string_view function, const PosedView& ray,
                                                      const PosedView& figure) {
  require_posed(function, ray, figure);
  ExactShot shot = exact_shot(ray);
  const PosedSet s = posed_set(figure);
  if (s.is_round()) {
    if (is_singular(s.map)) {
      throw UnevenPose(std::string(function)
                           .append(": ")
                           .append(spoken(figure.figure))
                           .append(": its pose flattens it; give one whose matrix is not singular"));
    }
    const ExactMap back = inverse(s.map);
    shot.from = image(back, shot.from), shot.along = turned(back, shot.along);
    return first_in_fat(shot, s.core, s.radius);
  }
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
  if (!first) return {};
  return RayParameter{exact_number(*first)};
}

}  // namespace plumb::query
