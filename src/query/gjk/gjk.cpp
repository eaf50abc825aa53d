#include "plumb/query/gjk/gjk.hpp"

#include "arith/big_rounding.hpp"
#include "plumb/arith/ball.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/search.hpp"
#include "query/gjk/body_pair.hpp"
#include "query/gjk/met_at_once.hpp"
#include "query/gjk/quick_nearest.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

/// The simplex of a cache, where its numbers are those of corners, else the first corners of both.
DifferenceCorners start_of(const GjkCache* cache, const CoreCorners& a, const CoreCorners& b) {
  DifferenceCorners from;
  if (cache != nullptr && cache->simplex.size <= 4) {
    for (std::uint32_t i = 0; i < cache->simplex.size; ++i) {
      const GjkCorner& c = cache->simplex.corners[i];
      if (c[0] < a.size() && c[1] < b.size()) from.add(c);
    }
  }
  if (from.size == 0) from.add({0, 0});
  return from;
}

GjkSimplex simplex_of(const DifferenceCorners& corners) {
  GjkSimplex s{{}, static_cast<std::uint32_t>(corners.size)};
  for (std::size_t i = 0; i < corners.size; ++i) s.corners[i] = corners.ends[i];
  return s;
}

GjkStep step_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  GjkStep step{.simplex = simplex_of(corners)};
  const auto rounded = [](const BigDyadic& x, const BigDyadic& over) {
    return rounded_quotient(Rounding::nearest, x, over);
  };
  arith::Vec<BigDyadic> at{BigDyadic(0.0), BigDyadic(0.0), BigDyadic(0.0)};
  for (std::size_t i = 0; i < corners.size; ++i) {
    step.weight[i] = rounded(n.weight[i], n.whole);
    at = at + n.at[i] * n.weight[i];
  }
  const BigDyadic scale = a.scale<BigDyadic>(), whole = n.whole * scale;
  step.direction = {rounded(at.x, whole), rounded(at.y, whole), rounded(at.z, whole)};
  step.square = rounded(n.square, n.square_whole * (scale * scale));
  return step;
}

/// Which corners are nearest, for certain, and after how many simplices.
struct Found {
  ProvedCorners proved;
  std::uint32_t steps = 0;
};

/// As far as doubles prove it, or integers of a thousand bits.
std::optional<Found> quickly_found(const SeenBody& a, const SeenBody& b, const GjkOptions& options) {
  Found f;
  DifferenceCorners guess = start_of(options.cache, a.corners, b.corners);
  const bool is_known = options.cache != nullptr && options.cache->simplex.size != 0;
  if (is_known) {
    ++f.steps;
    if (const auto j = judged<Running>(a.corners, b.corners, guess); j && j->holds) {
      f.proved = j->proved;
      return f;
    }
  }
  guess = guessed_nearest(a.corners, b.corners, is_known ? guess : DifferenceCorners{}, f.steps);
  const auto proved = proved_nearest(a.corners, b.corners, guess);
  if (!proved) return {};
  f.proved = *proved;
  return f;
}

Found certainly_found(const CoreCorners& a, const CoreCorners& b, const GjkOptions& options) {
  DifferenceCorners guess = start_of(options.cache, a, b);
  Found f;
  std::vector<DifferenceCorners> seen;
  if (options.history == nullptr) guess = guessed_nearest(a, b, guess, f.steps);
  f.proved = certainly_nearest(a, b, guess, &seen);
  f.steps += static_cast<std::uint32_t>(seen.size());
  if (options.history != nullptr) {
    for (const DifferenceCorners& corners : seen) options.history->push_back(step_of(a, b, corners));
  }
  return f;
}

void remember(const GjkOptions& options, const CoreCorners& a, const CoreCorners& b, const ProvedCorners& proved) {
  if (options.cache == nullptr) return;
  options.cache->simplex = simplex_of(proved.corners);
  options.cache->direction = {0, 0, 0};
  if (proved.meets) return;
  CertainSigns ask;
  const auto n = nearest_of<Running>(a, b, proved.corners, ask);
  options.cache->direction = {n.way.x.value, n.way.y.value, n.way.z.value};
}

/// Is every number one?  Those of a polyhedron are what it was made of, and are not looked through.
bool is_real_but_of_solids(const CoreCorners& c) { return c.polyhedron() != nullptr || c.is_finite(); }

/// Of a body that doubles may be asked of before it has been looked at: no polygon, and no radius under a pose.
std::optional<CoreCorners> corners_at_once(const BodyView& v) {
  if (!v.is_hull() && is_one_of(v.figure.kind, {FigureKind::quadrilateral, FigureKind::polygon})) return {};
  if (const double radius = radius_of(v); radius != 0) {
    if (!(radius >= 0 && radius < Ball::infinity) || (radius > 0 && !is_rigid(v.pose))) return {};
  }
  auto corners = CoreCorners::of(v);
  if (corners && !is_real_but_of_solids(*corners)) return {};
  return corners;
}

void remember(const GjkOptions& options, const QuickNearest& found) {
  if (options.cache == nullptr) return;
  options.cache->simplex = simplex_of(found.proved.corners);
  options.cache->direction = {found.way.x, found.way.y, found.way.z};
}

/// Both as given and without a radius.
bool set_given(QuickHull& p, QuickHull& q, const BodyView& a, const BodyView& b) {
  return radius_of(a) == 0 && radius_of(b) == 0 && p.set(a) && q.set(b) && p.is_given() && q.is_given();
}

/// Of hulls as given, as far as doubles prove it.  All corners of what is no polyhedron are asked, so that a number which is
/// none is seen.
std::optional<double> given_apart(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  QuickHull p, q;
  if (!set_given(p, q, a, b)) return {};
  const auto found = quickly_nearest(p, q, options.cache);
  if (!found || (found->proved.meets && !(p.is_finite_but_of_solid() && q.is_finite_but_of_solid()))) return {};
  const auto d = found->proved.meets ? 0 : quick_distance(p, q, found->proved.corners);
  if (d) remember(options, *found);
  return d;
}

/// Without rationals.
std::optional<double> apart_at_once(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  if (options.history != nullptr) return {};
  if (const auto d = given_apart(a, b, options)) return d;
  auto p = corners_at_once(a), q = corners_at_once(b);
  if (!p || !q) return {};
  bring_to_one_weight(*p, *q);
  const auto f = quickly_found({a, *p}, {b, *q}, options);
  if (!f) return {};
  remember(options, *p, *q, f->proved);
  const double radius_a = radius_of(a), radius_b = radius_of(b);
  const QuickPair quick(*p, *q, radius_a, radius_b, f->proved);
  if (const auto d = quick.distance()) return *d;
  if (gap_of(*p, *q, f->proved.corners, radius_a, radius_b) != Sign::positive) return 0;
  return rounded_distance(quick.square(), mpq_class(radius_a) + mpq_class(radius_b));
}

/// A plane touches a hull as given in these corners; others of it lie in the plane where it `is_level`.
std::optional<Feature> feature_of(const BodyView& v, const QuickHull& h, const NamedCorners& of, bool is_level) {
  if (is_level && (h.solid() == nullptr || of.size != 3)) return {};
  if (h.solid() != nullptr) return feature_of_mesh(*h.solid(), of.all());
  if (v.is_hull()) return least_feature(of.all());
  const auto corners = CoreCorners::of(v.figure);
  const std::uint64_t level = level_of(*corners, of.all());
  return feature_of_corners(v.figure, *corners, of.all(), {true, level, level});
}

/// Which of several closest pairs, of bodies that are apart and of those that meet.
struct PairsTold {
  WhichPair apart, common;
};

/// A point that both have in common.
Closest common_point(const BodyView& a, const BodyView& b, const QuickHull& p, const QuickHull& q,
                     const ProvedCorners& proved) {
  if (const auto c = quick_common(p, q, proved.corners)) return *c;
  return told_places(QuickPair(*CoreCorners::of(a), *CoreCorners::of(b), 0, 0, proved).any_pair(), 0, 0);
}

/// As far as the quick search found it, and the features are those of its corners.
std::optional<Closest> closest_of(const BodyView& a, const BodyView& b, const QuickHull& p, const QuickHull& q,
                                  const QuickNearest& found, const PairsTold& told) {
  if ((found.proved.meets ? told.common : told.apart) == WhichPair::first && !found.proved.is_alone) return {};
  if (found.proved.meets) return common_point(a, b, p, q, found.proved);
  const auto feature_a = feature_of(a, p, found.of_a, found.proved.a.level != 0);
  const auto feature_b = feature_of(b, q, found.of_b, found.proved.b.level != 0);
  if (!feature_a || !feature_b) return {};
  auto c = quick_points(p, q, found.proved.corners);
  if (c) c->feature_a = *feature_a, c->feature_b = *feature_b;
  return c;
}

std::optional<GjkAnswer> given_answer(const BodyView& a, const BodyView& b, const GjkOptions& options,
                                      const PairsTold& told) {
  QuickHull p, q;
  if (!set_given(p, q, a, b)) return {};
  const auto found = quickly_nearest(p, q, options.cache);
  if (!found) return {};
  const bool meets = found->proved.meets;
  if (meets && !(p.is_finite_but_of_solid() && q.is_finite_but_of_solid())) return {};
  const auto c = closest_of(a, b, p, q, *found, told);
  if (!c) return {};
  remember(options, *found);
  return GjkAnswer{meets, *c, found->steps, simplex_of(found->proved.corners)};
}

/// Without rationals.
std::optional<GjkAnswer> answered_at_once(const BodyView& a, const BodyView& b, const GjkOptions& options,
                                          const PairsTold& told) {
  if (options.history != nullptr) return {};
  if (const auto answer = given_answer(a, b, options, told)) return answer;
  auto p = corners_at_once(a), q = corners_at_once(b);
  if (!p || !q) return {};
  bring_to_one_weight(*p, *q);
  const auto f = quickly_found({a, *p}, {b, *q}, options);
  if (!f || (f->proved.meets && told.common == WhichPair::first)) return {};
  const QuickPair quick(*p, *q, radius_of(a), radius_of(b), f->proved);
  auto c = closest_at_once(quick, {a, *p}, {b, *q}, f->proved, told.common);
  if (!c && told.common == WhichPair::any && (f->proved.meets || radius_of(a) + radius_of(b) > 0)) c = quick.common();
  // By their radii alone they may touch, at a point of both surfaces.
  if (!c || (c->meets && told.common == WhichPair::first)) return {};
  remember(options, *p, *q, f->proved);
  return GjkAnswer{c->meets, c->closest, f->steps, simplex_of(f->proved.corners)};
}

}  // namespace

bool gjk_meets(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  GjkCache guess = options.cache == nullptr ? GjkCache{} : *options.cache;
  if (options.history == nullptr) {
    QuickBody first{a}, second{b};
    if (first.set() && second.set()) {
      const MetAtOnce met = met_at_once(first, second, guess);
      if (met != MetAtOnce::unsure && options.cache != nullptr) *options.cache = guess;
      if (met != MetAtOnce::unsure) return met != MetAtOnce::apart;
    }
  }
  const BodyPair pair("gjk_intersects", a, b);
  const GjkOptions from{.cache = &guess, .history = options.history};
  const Found f = certainly_found(pair.a(), pair.b(), from);
  remember(options, pair.a(), pair.b(), f.proved);
  return pair.meets(f.proved);
}

double gjk_apart_by(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  if (const auto d = apart_at_once(a, b, options)) return *d;
  const BodyPair pair("gjk_distance", a, b);
  const Found f = certainly_found(pair.a(), pair.b(), options);
  remember(options, pair.a(), pair.b(), f.proved);
  return pair.distance(f.proved);
}

GjkAnswer gjk_answer(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  if (const auto answer = answered_at_once(a, b, options, {options.pair, options.pair})) return *answer;
  const BodyPair pair("gjk", a, b);
  const Found f = certainly_found(pair.a(), pair.b(), options);
  remember(options, pair.a(), pair.b(), f.proved);
  return {pair.meets(f.proved), pair.closest(f.proved, options.pair), f.steps, simplex_of(f.proved.corners)};
}

std::optional<double> distance_by_search(const PosedView& a, const PosedView& b) {
  return apart_at_once(body_of(a), body_of(b), {});
}

std::optional<Closest> closest_by_search(const PosedView& a, const PosedView& b, WhichPair common) {
  const auto answer = answered_at_once(body_of(a), body_of(b), {}, {WhichPair::first, common});
  return answer ? std::optional(answer->closest) : std::nullopt;
}

}  // namespace plumb::query
