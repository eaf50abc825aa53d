#include "plumb/query/gjk/gjk.hpp"

#include "arith/big_rounding.hpp"
#include "plumb/arith/ball.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/gjk/body_pair.hpp"
#include "query/gjk/origin.hpp"
#include "query/gjk/quick_meeting.hpp"
#include "query/gjk/quick_nearest.hpp"
#include "query/separation/guessed_corners.hpp"

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

/// Seen from near to it.
class NearHull {
 public:
  NearHull(const QuickHull& hull, const arith::Plain& origin, std::uint32_t last)
      : hull_(hull), origin_(origin), last_(last) {}
  [[nodiscard]] arith::Plain at(std::uint32_t i) const { return hull_.at(i) - origin_; }
  std::uint32_t least(const arith::Plain& n) { return last_ = hull_.farthest(n * -1, last_); }

 private:
  const QuickHull& hull_;
  arith::Plain origin_;
  std::uint32_t last_;
};

/// Of hulls without a radius by what QuickHull tells, else by corners.
DifferenceCorners guessed_at_once(const SeenBody& a, const SeenBody& b, bool is_known, DifferenceCorners from,
                                  std::uint32_t& steps) {
  QuickHull p, q;
  if (!p.set(a.view) || !q.set(b.view)) return guessed_nearest(a.corners, b.corners, from, steps);
  if (!is_known) {
    const arith::Plain way = p.middle() - q.middle();
    from.ends[0] = {p.farthest(way * -1, 0), q.farthest(way, 0)};
  }
  const auto [first_a, first_b] = from.ends[0];
  const arith::Plain origin = p.at(first_a);
  NearHull near_p(p, origin, first_a), near_q(q, origin, first_b);
  return guessed_between(near_p, near_q, from, steps);
}

/// As far as doubles prove it.
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
  guess = guessed_at_once(a, b, is_known, guess, f.steps);
  const auto j = judged<Running>(a.corners, b.corners, guess);
  if (!j || !j->holds) return {};
  f.proved = j->proved;
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
  if (!v.is_hull()) {
    if (is_one_of(v.figure.kind, {FigureKind::quadrilateral, FigureKind::polygon})) return {};
    const double radius = radius_of(v.figure);
    if (!(radius >= 0 && radius < Ball::infinity) || (radius > 0 && !is_rigid(v.pose))) return {};
  }
  auto corners = CoreCorners::of(v);
  if (corners && !is_real_but_of_solids(*corners)) return {};
  return corners;
}
double radius_at_once(const BodyView& v) { return v.is_hull() ? 0 : radius_of(v.figure); }

/// Do these corners hold the origin?  Of four the faces are asked: what is strictly inside of them is found elsewhere.
bool touches(const QuickHull& a, const QuickHull& b, const GjkSimplex& near) {
  const auto asked = [&](std::initializer_list<std::uint32_t> of) {
    gjk_origin::Pairs pairs{};
    std::size_t count = 0;
    for (const std::uint32_t i : of) {
      pairs.a[count] = a.given(near.corners[i][0]), pairs.b[count++] = b.given(near.corners[i][1]);
    }
    if (count == 1) return pairs.a[0] == pairs.b[0];
    return count == 2 ? certainly(gjk_origin::HoldsOrigin<2>{}, pairs) : certainly(gjk_origin::HoldsOrigin<3>{}, pairs);
  };
  switch (near.size) {
    case 1:
      return asked({0});
    case 2:
      return asked({0, 1});
    case 3:
      return asked({0, 1, 2});
    default:
      return asked({0, 1, 2}) || asked({0, 1, 3}) || asked({0, 2, 3}) || asked({1, 2, 3});
  }
}

bool are_real(const QuickHull& h) { return h.solid() != nullptr || h.is_finite(); }

/// Of hulls without a radius, as far as doubles, or signs at few corners, tell it.
std::optional<bool> met_at_once(const QuickBody& a, const QuickBody& b, GjkCache& cache) {
  std::uint32_t steps = 0;
  const Told told = quickly_told(a, b, cache, steps);
  if (told == Told::apart) return false;
  if (!are_real(a.hull) || !are_real(b.hull)) return {};
  if (told == Told::meet) return true;
  const bool are_given = a.hull.is_given() && b.hull.is_given();
  if (are_given && touches(a.hull, b.hull, cache.simplex)) return true;
  const auto p = CoreCorners::of(a.view), q = CoreCorners::of(b.view);
  cache.simplex = simplex_of(guessed_nearest(*p, *q, start_of(&cache, *p, *q), steps));
  if (are_given && touches(a.hull, b.hull, cache.simplex)) return true;
  return {};
}

void remember(const GjkOptions& options, const QuickNearest& found) {
  if (options.cache == nullptr) return;
  options.cache->simplex = simplex_of(found.proved.corners);
  options.cache->direction = {found.way.x, found.way.y, found.way.z};
}

/// Of hulls as given and without a radius, as far as doubles prove it.  All corners of what is no polyhedron are asked,
/// so that a number which is none is seen.
std::optional<double> apart_at_once(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  QuickHull p, q;
  if (options.history != nullptr || !p.set(a) || !q.set(b) || !p.is_given() || !q.is_given()) return {};
  const auto found = quickly_nearest(p, q, options.cache);
  if (!found || (found->proved.meets && !(are_real(p) && are_real(q)))) return {};
  const auto d = found->proved.meets ? 0 : quick_distance(p, q, found->proved.corners);
  if (d) remember(options, *found);
  return d;
}

/// Of a polyhedron or a hull of points, of which no other corner lies in the plane.
std::optional<Feature> feature_of(const QuickHull& h, const NamedCorners& of) {
  return h.solid() != nullptr ? feature_of_mesh(*h.solid(), of.all()) : least_feature(of.all());
}

std::optional<GjkAnswer> answered_at_once(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  const auto is_known_kind = [](const BodyView& v) {
    return v.is_hull() || v.figure.kind == FigureKind::convex_polyhedron;
  };
  if (options.history != nullptr || !is_known_kind(a) || !is_known_kind(b)) return {};
  QuickHull p, q;
  if (!p.set(a) || !q.set(b) || !p.is_given() || !q.is_given()) return {};
  const auto found = quickly_nearest(p, q, options.cache);
  if (!found || found->proved.meets || !found->proved.is_alone) return {};
  auto c = quick_points(p, q, found->proved.corners);
  if (!c) return {};
  const auto feature_a = feature_of(p, found->of_a), feature_b = feature_of(q, found->of_b);
  if (!feature_a || !feature_b) return {};
  c->feature_a = *feature_a, c->feature_b = *feature_b;
  remember(options, *found);
  return GjkAnswer{false, *c, found->steps, simplex_of(found->proved.corners)};
}

}  // namespace

bool gjk_meets(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  GjkCache guess = options.cache == nullptr ? GjkCache{} : *options.cache;
  if (options.history == nullptr) {
    QuickBody first{a}, second{b};
    if (first.hull.set(a) && second.hull.set(b)) {
      const auto met = met_at_once(first, second, guess);
      if (met && options.cache != nullptr) *options.cache = guess;
      if (met) return *met;
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
  auto p = corners_at_once(a), q = corners_at_once(b);
  if (p && q) bring_to_one_weight(*p, *q);
  if (options.history == nullptr && p && q) {
    if (const auto f = quickly_found({a, *p}, {b, *q}, options)) {
      remember(options, *p, *q, f->proved);
      const QuickPair quick(*p, *q, radius_at_once(a), radius_at_once(b), f->proved);
      if (const auto d = quick.distance()) return *d;
    }
  }
  const BodyPair pair("gjk_distance", a, b);
  const Found f = certainly_found(pair.a(), pair.b(), options);
  remember(options, pair.a(), pair.b(), f.proved);
  return pair.distance(f.proved);
}

GjkAnswer gjk_answer(const BodyView& a, const BodyView& b, const GjkOptions& options) {
  if (const auto answer = answered_at_once(a, b, options)) return *answer;
  auto p = corners_at_once(a), q = corners_at_once(b);
  if (p && q) bring_to_one_weight(*p, *q);
  if (options.history == nullptr && p && q) {
    const auto f = quickly_found({a, *p}, {b, *q}, options);
    if (f && !f->proved.meets) {
      const QuickPair quick(*p, *q, radius_at_once(a), radius_at_once(b), f->proved);
      if (const auto c = closest_at_once(quick, {a, *p}, {b, *q}, f->proved)) {
        remember(options, *p, *q, f->proved);
        return {false, *c, f->steps, simplex_of(f->proved.corners)};
      }
    }
  }
  const BodyPair pair("gjk", a, b);
  const Found f = certainly_found(pair.a(), pair.b(), options);
  remember(options, pair.a(), pair.b(), f.proved);
  return {pair.meets(f.proved), pair.closest(f.proved), f.steps, simplex_of(f.proved.corners)};
}

}  // namespace plumb::query
