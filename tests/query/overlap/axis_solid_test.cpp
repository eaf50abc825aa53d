// Cylinders and cones against convex sets, polygons and balls: is each relation that of the sets?  Held against sets cut
// by their generators and seen along the axis, against places where edges and faces meet the shape, and, of balls,
// against the section of the shape in numbers of many bits.
#include <gtest/gtest.h>

#include "plumb/figure.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/overlap/axis_oracle.hpp"
#include "query/overlap/cut_set.hpp"

namespace plumb {
namespace {

using oracle::AxisShape, oracle::RationalPoint, oracle::Spanned;
using pair_cases::Answers, pair_cases::AnyFigure, pair_cases::FigureRow, pair_cases::PairRow;
using shape_cases::Material, shape_cases::on_shapes;

Spanned without_repetition(Spanned set) {
  for (std::vector<RationalPoint>* all : {&set.points, &set.directions}) {
    std::ranges::sort(*all);
    all->erase(std::unique(all->begin(), all->end()), all->end());
  }
  return set;
}

mpq_class share_of(const AxisShape& s, const RationalPoint& p) {
  return oracle::dot(oracle::difference(p, s.from), s.axis) / oracle::dot(s.axis, s.axis);
}
/// Of a point seen from the apex or along the axis, from the middle of the base.
RationalPoint seen(const AxisShape& s, const RationalPoint& off, const mpq_class& share) {
  return oracle::times_rational(oracle::sum(off, -share, s.axis), s.is_cone ? mpq_class(1 / share) : mpq_class(1));
}

/// What lies between the planes of the ends, seen so, and whether the inside of the set reaches between them.
struct SeenPart {
  SeenPart(const Spanned& set, const AxisShape& s) {
    const mpq_class start = oracle::dot(s.axis, s.from), end = start + oracle::dot(s.axis, s.axis);
    const RationalPoint down = oracle::times_rational(s.axis, -1);
    const oracle::CutSet above(set, down, -start), below(set, s.axis, end), both(above.within, s.axis, end);
    reaches_inside = above.reaches_inside && below.reaches_inside;
    for (const RationalPoint& p : both.within.points) {
      const RationalPoint off = oracle::difference(p, s.from);
      const mpq_class share = share_of(s, p);
      if (!s.is_cone || sgn(share) > 0) {
        part.points.push_back(seen(s, off, share));
      } else if (!oracle::polygon_detail::is_zero(off)) {
        part.directions.push_back(off);
      }
    }
    part.directions.insert(part.directions.end(), both.within.directions.begin(), both.within.directions.end());
    part = without_repetition(part);
    holds_apex = s.is_cone && !both.within.points.empty() &&
                 oracle::relation(Spanned{{s.from}, {}}, both.within) != Relation::disjoint;
  }
  [[nodiscard]] std::optional<mpq_class> square() const {
    return oracle::squared_distance(Spanned{{RationalPoint{0, 0, 0}}, {}}, part);
  }
  [[nodiscard]] Relation relation(const mpq_class& radius) const {
    const auto gap = square();
    if (gap && *gap < radius * radius && reaches_inside) return Relation::overlapping;
    return (gap && *gap <= radius * radius) || holds_apex ? Relation::touching : Relation::disjoint;
  }
  Spanned part;
  bool reaches_inside, holds_apex;
};

/// Of what is three generators, a point first, the place nearest to the middle of a disk in its plane.
std::optional<RationalPoint> middle_of_chord(const RationalPoint& p, const RationalPoint& u, const RationalPoint& v,
                                             const RationalPoint& middle, const RationalPoint& axis) {
  using oracle::polygon_detail::cross;
  const RationalPoint n = cross(u, v), line = cross(n, axis), in_disk = cross(axis, line);
  const mpq_class slope = oracle::dot(n, in_disk);
  if (sgn(slope) == 0) return {};
  return oracle::sum(middle, oracle::dot(n, oracle::difference(p, middle)) / slope, in_disk);
}

/// Does the set meet the shape?  It does where an edge does, where the axis meets the set, or where what a face's plane
/// cuts out of the shape is within the face: then so is the middle of a chord.
bool meets(const Spanned& set, const AxisShape& s) {
  if (set.points.empty()) return false;
  if (oracle::relation(s.core(), set) != Relation::disjoint) return true;
  std::vector<std::pair<RationalPoint, bool>> ways;
  const auto on_line = [&](const RationalPoint& p, const RationalPoint& along, bool ends) {
    const std::optional<mpq_class> last = ends ? std::optional<mpq_class>(1) : std::nullopt;
    return oracle::relation(oracle::RationalLine{p, along, mpq_class(0), last}, s) != Relation::disjoint;
  };
  const auto in_shape = [&](const RationalPoint& p) { return on_line(p, {0, 0, 0}, true); };
  for (auto at = set.points.begin(); at != set.points.end(); ++at) {
    const RationalPoint& p = *at;
    ways.clear();
    for (auto q = at; q != set.points.end(); ++q) ways.push_back({oracle::difference(*q, p), true});
    for (const RationalPoint& d : set.directions) ways.push_back({d, false});
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (on_line(p, ways[i].first, ways[i].second)) return true;
      for (std::size_t j = 0; j < i; ++j) {
        for (const int end : {0, 1}) {
          if (end == 0 && s.is_cone) continue;
          const RationalPoint middle = oracle::sum(s.from, end, s.axis);
          const auto place = middle_of_chord(p, ways[i].first, ways[j].first, middle, s.axis);
          if (place && in_shape(*place) && oracle::relation(Spanned{{*place}, {}}, set) != Relation::disjoint)
            return true;
        }
      }
    }
  }
  return false;
}

/// Also, where the shape has an interior, how far the nearest piece is.
struct Expected {
  Relation relation = Relation::disjoint;
  std::optional<mpq_class> square;
};
Expected expected_of(const oracle::Pieces& pieces, const AxisShape& s) {
  if (s.is_ball() || s.radius == 0) return {oracle::RoundOracle(s.core(), pieces).relation(s.radius), {}};
  Expected all;
  const auto see = [&](const Spanned& any, Relation at_most) {
    if (any.points.empty()) return;
    const Spanned piece = without_repetition(any);
    const SeenPart part(piece, s);
    const Relation r = part.relation(s.radius);
    EXPECT_EQ(r != Relation::disjoint, meets(piece, s));
    all.relation = std::max(all.relation, std::min(r, at_most));
    if (const auto square = part.square(); square && (!all.square || *square < *all.square)) all.square = square;
  };
  for (const Spanned& piece : pieces.inner) see(piece, Relation::overlapping);
  for (const Spanned& piece : pieces.boundary) see(piece, Relation::touching);
  return all;
}

using AxisKinds = pair_cases::Types<Cylinder3, Cone3>;
AxisShape shape_of(const AnyFigure& round) {
  return pair_cases::on_kind<AxisShape>(AxisKinds{}, round, [](const auto& s) { return oracle::axis_shape(s); });
}
AnyFigure with_radius_of(const AnyFigure& round, double radius) {
  return pair_cases::on_kind<AnyFigure>(AxisKinds{}, round, [&]<class Shape>(const Shape& s) {
    auto* changed = new Shape(s);
    changed->radius = radius;
    return AnyFigure(round.row(), changed);
  });
}

Answers expect_flat(const PairRow& pair, std::uint64_t start) {
  Answers answers;
  const bool round_first = pair_cases::has_axis(pair.a->kind);
  const FigureRow &of_flat = round_first ? *pair.b : *pair.a, &of_round = round_first ? *pair.a : *pair.b;
  on_shapes(start,
            battery::sanitized                    ? 2
            : pair_cases::is_costly(of_flat.kind) ? 4
                                                  : 24,
            [&](Material& m) {
              const AnyFigure flat = near_figure(of_flat, m);
              AnyFigure round = pair_cases::figure(of_round, m);
              const oracle::Pieces pieces = pair_cases::pieces_of(pair_cases::Space{}, flat);
              Expected expected = expected_of(pieces, shape_of(round));
              if (const auto root = expected.square ? oracle::exact_root(*expected.square) : std::nullopt;
                  root && *root > 0) {
                if (m.below(2) == 0) {
                  round = with_radius_of(round, *root);
                  expected = expected_of(pieces, shape_of(round));
                }
              }
              answers.add(expected.relation);
              expect_relation(pair, round_first ? round : flat, round_first ? flat : round, expected.relation, m);
            });
  return answers;
}

void expect_every_answer(const Answers& all) {
  std::printf("disjoint %d, touching %d, overlapping %d\n", all.of(Relation::disjoint), all.of(Relation::touching),
              all.of(Relation::overlapping));
  if (!battery::reaches_rare) return;
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GE(all.of(r) * 20, all.all());
}

TEST(OverlapAxisSolid, FlatSetsAsTheyAreSeenAlongTheAxisOrFromTheApex) {
  Answers all;
  std::uint64_t start = 940;
  for (const PairRow& pair : pair_cases::pairs_of(pair_cases::Space{})) {
    const bool of_ball = pair.a->kind == FigureKind::ball;
    if (!of_ball && pair_cases::oracle_of(pair.a->kind, pair.b->kind) == pair_cases::PairOracle::seen)
      all.add(expect_flat(pair, start++));
  }
  expect_every_answer(all);
}

/// Numbers of many bits, and what is all but zero.
constexpr unsigned section_precision = 3000;
using Wide = mpf_class;
Wide wide(const mpq_class& x) { return Wide(x, section_precision); }
int wide_sign(const Wide& x) {
  Wide least(1, section_precision);
  mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), 1000);
  return abs(x) < least ? 0 : sgn(x);
}
Wide root_of(const mpq_class& x) { return Wide(sqrt(wide(x)), section_precision); }
struct WidePlace {
  Wide along, out;
};

/// By the section through the axis and the ball's center: a rectangle or a triangle, and what is below is inside.
Relation expected_of_ball(const Sphere3& ball, const AxisShape& s) {
  const RationalPoint p = oracle::rational(ball.center);
  const mpq_class share = share_of(s, p), width = oracle::beyond_surface({s.from, s.axis, 0, s.is_cone}, p, share);
  const Wide length = root_of(oracle::dot(s.axis, s.axis)), zero = wide(0), reach = wide(ball.radius);
  const WidePlace at{Wide(wide(share) * length), root_of(width)};
  std::vector<WidePlace> outline{{zero, zero}};
  if (!s.is_cone) outline.push_back({zero, wide(s.radius)});
  outline.push_back({length, wide(s.radius)});
  outline.push_back({length, zero});
  bool is_inside = wide_sign(at.along) >= 0 && wide_sign(at.along - length) <= 0;
  const Wide surface = s.is_cone ? Wide(wide(share) * wide(s.radius)) : wide(s.radius);
  is_inside = is_inside && wide_sign(at.out - surface) <= 0;
  if (is_inside) return Relation::overlapping;
  std::optional<Wide> least;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const auto &a = outline[i], &b = outline[i + 1];
    const Wide x = b.along - a.along, y = b.out - a.out;
    Wide t = ((at.along - a.along) * x + (at.out - a.out) * y) / (x * x + y * y);
    t = sgn(t) < 0 ? zero : t > 1 ? wide(1) : t;
    const Wide dx = a.along + t * x - at.along, dy = a.out + t * y - at.out, square = dx * dx + dy * dy;
    if (!least || square < *least) least = square;
  }
  return static_cast<Relation>(-wide_sign(*least - reach * reach));
}

TEST(OverlapAxisSolid, BallsAsTheSectionThroughTheAxis) {
  Answers all;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 200u : 1500u); ++i) {
    Entropy e(37, i);
    const auto number = [&e] { return static_cast<double>(e.within(5)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    const auto radius = [&e] { return static_cast<double>(1 + e.below(6)) * (e.below(3) == 0 ? 0.5 : 1); };
    Point3 from = point(), to = point();
    double of_shape = radius();
    Sphere3 ball{point(), radius()};
    if (e.below(2) == 0) {  // along an axis, so that whole numbers touch
      from = {0, 0, 0}, to = {0, 0, 4}, of_shape = 3;
      const double x = number() * 2, y = e.coin() ? 0 : number() * 2, z = number() * 2;
      const double beside = std::fmax(std::hypot(x, y) - 3, 0), up = std::fmax(std::fmax(z - 4, -z), 0);
      ball = {{x, y, z}, std::fmax(1, std::rint(std::hypot(beside, up)))};
      if (e.below(3) == 0) ball = {{x, y, z}, std::fmax(1, std::rint(std::fabs(4 * std::hypot(x, y) - 3 * z) / 5))};
    }
    if (from == to) continue;
    const auto see = [&](const auto& round) {
      const Relation expected = expected_of_ball(ball, oracle::axis_shape(round));
      all.add(expected);
      expect_relation(ball, round, expected, "replay: " + std::to_string(i));
    };
    see(Cylinder3{from, to, of_shape});
    see(Cone3{from, to, of_shape});
  }
  expect_every_answer(all);
}

TEST(OverlapAxisSolid, WhatTouchesOnlyRims) {
  const Cylinder3 can{{0, 0, 0}, {0, 0, 10}, 5};
  EXPECT_EQ(relate(can, Aabb3{{3, 4, 10}, {9, 9, 11}}), Relation::touching);  // a corner on the rim
  EXPECT_EQ(relate(can, Aabb3{{3, std::nextafter(4, 5), 10}, {9, 9, 11}}), Relation::disjoint);
  EXPECT_EQ(relate(can, Aabb3{{5, -1, 2}, {6, 1, 3}}), Relation::touching);  // a face along a line of the side
  EXPECT_EQ(relate(can, Triangle3{{5, -9, 9}, {5, 9, 9}, {5, 0, 99}}), Relation::touching);
  EXPECT_EQ(relate(can, Triangle3{{4, -9, 10}, {4, 9, 10}, {4, 0, 99}}), Relation::touching);  // a chord of the top
  EXPECT_EQ(relate(can, Triangle3{{-99, -99, 5}, {99, -99, 5}, {0, 99, 5}}), Relation::overlapping);  // around it
  EXPECT_EQ(relate(can, Sphere3{{8, 0, 14}, 5}), Relation::touching);  // 3 and 4 off the rim
  EXPECT_EQ(relate(can, Sphere3{{8, 0, 14}, 4.9375}), Relation::disjoint);
  const Cone3 cone{{0, 0, 0}, {0, 0, 4}, 3};
  EXPECT_EQ(relate(cone, Sphere3{{0, 0, -2}, 2}), Relation::touching);  // at the apex
  EXPECT_EQ(relate(cone, Sphere3{{10, 0, 5}, 5}), Relation::disjoint);
  EXPECT_EQ(relate(cone, Sphere3{{5, 0, 0}, 4}), Relation::touching);           // along the side
  EXPECT_EQ(relate(cone, Aabb3{{-1, -1, -1}, {1, 1, 0}}), Relation::touching);  // the apex within a face
  EXPECT_EQ(relate(cone, Aabb3{{1, -1, -1}, {2, 1, 1}}), Relation::disjoint);
  const Polygon3 frame{{{-9, -9, 2}, {9, -9, 2}, {9, 9, 2}, {2, 9, 2}, {2, 2, 2}, {2, -2, 2}, {-9, -2, 2}}};
  EXPECT_EQ(relate(frame, Cone3{{0, 0, 0}, {0, 0, 4}, 4}), Relation::touching);  // of radius 2 there
  EXPECT_EQ(relate(frame, cone), Relation::disjoint);
}

TEST(OverlapAxisSolid, UnderPoses) {
  const Pose turned{{{{0.96, 0.28, 0}, {-0.28, 0.96, 0}, {0, 0, 1}}}, {0.1, 0.2, 0.3}},
      sheared{{{{2, 0, 0}, {1, 1, 0}, {0.5, 0.25, 3}}}, {1, 2, 3}},
      flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 5}};
  const Cylinder3 can{{0, 0, 0}, {0, 0, 10}, 5};
  const Aabb3 box{{3, 4, 10}, {9, 9, 11}};
  const Quadrilateral3 quad{{5, -9, 0}, {5, 9, 0}, {5, 9, 9}, {5, -9, 9}};
  for (const Pose& pose : {turned, sheared}) {
    EXPECT_EQ(relate(Posed{can, pose}, Posed{box, pose}), Relation::touching);
    EXPECT_EQ(relate(Posed{quad, pose}, Posed{can, pose}), Relation::touching);
    EXPECT_EQ(relate(Posed{Sphere3{{8, 0, 14}, 5}, pose}, Posed{can, pose}), Relation::touching);
  }
  EXPECT_THROW(relate(Posed{Sphere3{{8, 0, 14}, 5}, sheared}, can), UnevenPose);
  EXPECT_THROW(relate(Posed{can, flat}, quad), UnevenPose);
  // A disk at z = 5.
  EXPECT_EQ(relate(Posed{can, flat}, Aabb3{{3, 4, 0}, {9, 9, 11}}), Relation::touching);
  EXPECT_EQ(relate(Posed{can, flat}, Aabb3{{0, 0, 5}, {9, 9, 11}}), Relation::touching);
  EXPECT_EQ(relate(Posed{can, flat}, Aabb3{{0, 0, 4}, {9, 9, 11}}), Relation::overlapping);
}

}  // namespace
}  // namespace plumb
