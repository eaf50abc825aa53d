// Balls and capsules nearer than this to a triangle, a box, a segment: what doubles prove against exact distances, the
// share of what they prove, and the bounds that are derived and confirmed.
#include "figure/support/near_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/separation/separation.hpp"

namespace plumb::figure::near_points {
namespace {

TEST(NearPoints, WhatIsToldIsSo) {
  std::array shares{PromisedShare("near_triangle"), PromisedShare("near_segments"), PromisedShare("near_aabb")};
  std::array<int, 3> near{};
  for (const FamilyInfo& info : families) {
    const auto add = [&](std::size_t k, const std::optional<Sign>& sign, Sign exact) {
      shares[k].add(info.family, sign.has_value());
      EXPECT_EQ(sign.value_or(exact), exact);
      near[k] += sign == Sign::negative ? 1 : 0;
    };
    for (std::uint64_t i = 0; i < 100; ++i) {
      SCOPED_TRACE(testing::Message() << info.name << ", Entropy(21, " << i << ")");
      Entropy entropy(21, i);
      std::array<double, 18> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const auto point = [&x](std::size_t k) { return Point3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const Triangle3 t{point(0), point(1), point(2)};
      const Segment3 s{point(0), point(1)}, r{point(2), point(3)};
      const Aabb3 box{{std::min(x[0], x[3]), std::min(x[1], x[4]), std::min(x[2], x[5])},
                      {std::max(x[0], x[3]), std::max(x[1], x[4]), std::max(x[2], x[5])}};
      const Point3 p = point(5);
      const double radius = std::fabs(entropy.coin() ? x[14] : x[14] - x[2]);
      const auto sign = [&](const auto& a, const auto& b) { return compare_distance(a, b, radius); };
      add(0, quick_gap(t, p, radius), sign(p, t));
      add(1, quick_gap(s, r, 0, radius), sign(s, r));
      add(2, quick_gap(box, r, radius), sign(box, r));
    }
  }
  for (const int n : near) EXPECT_GE(n, 50);
}

template <class Statement, class... Input>
void expect_bounds(const char* name, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(Statement{}, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, Statement{}, input...));
}
TEST(NearPoints, DerivedBoundsAreAsRecordedAndProved) {
  const Plain up{0, 0, 3};
  const Triangle3 t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  expect_bounds<OfTriangle>("near_triangle", t, Point3{1, 1, 3}, 4.0, 0.25, 0.25, up);
  const Segment3 s{{0, 0, 0}, {4, 0, 0}}, r{{0, 0, 3}, {0, 4, 2.5}};
  expect_bounds<OfSegments>("near_segments", r, s, 1.0, 1.0, 0.0, 0.0, up);
  expect_bounds<OfAabb>("near_aabb", Plain{0, 0, 0}, Plain{1, 1, 0}, r, 1.0, 0.0, up);
}

/// Points guessed at random, and the direction between them or any other.  Not noticed is a sum for the
/// product with 1, which leaves more open (34).
TEST(NearPoints, MutantsAreNoticed) {
  using mutants::unnoticed, mutants::told, mutants::World, mutants::Draw;
  const auto plain = [](const auto& a) { return Plain{a.x, a.y, a.z}; };
  struct OfBall {
    Point3 center;
    double radius;
    std::array<double, 3> part;
    Plain along;  // if not zero

    [[nodiscard]] Plain way(const Plain& off) const { return arith::dot(along, along) > 0 ? along : off; }
  };
  const auto of_ball = [&](Draw& d) {
    return OfBall{d.point(),
                  d.positive(),
                  {d.quarter(), d.quarter(), d.quarter()},
                  plain(d.number() > 0 ? d.vector() : Vector3{}) * (d.number() > 0 ? 0.25 : 1)};
  };
  mutants::expect_noticed(
      "near_triangle",
      unnoticed(
          [&](Draw& d) {
            return std::pair{Triangle3{d.point(), d.point(), d.point()}, of_ball(d)};
          },
          [&](const auto& input) {
            const auto& [t, ball] = input;
            const auto [b, c, unused] = ball.part;
            const Plain a = plain(t.a);
            const Plain off = plain(ball.center) - a - (plain(t.b) - a) * b - (plain(t.c) - a) * c;
            return told<World>(OfTriangle{}, t, ball.center, ball.radius, b, c, ball.way(off));
          },
          [](const auto& input) { return compare_distance(input.second.center, input.first, input.second.radius); }),
      "34 ");
  const auto segment = [](Draw& d) { return Segment3{d.point(), d.point()}; };
  const auto at = [&](const Segment3& s, double t) { return plain(s.a) + (plain(s.b) - plain(s.a)) * t; };
  const std::string of_segments = unnoticed(
      [&](Draw& d) {
        return std::tuple{segment(d), segment(d), of_ball(d)};
      },
      [&](const auto& input) {
        const auto& [pq, xy, ball] = input;
        const auto [s, t, unused] = ball.part;
        return told<World>(OfSegments{}, pq, xy, ball.radius, 0.25, s, t, ball.way(at(pq, s) - at(xy, t)));
      },
      [](const auto& input) {
        const auto& [pq, xy, ball] = input;
        return compare_distance(pq, xy, ball.radius + 0.25);
      });
  mutants::expect_noticed("near_segments", of_segments);
  const std::string of_box = unnoticed(
      [&](Draw& d) {
        return std::tuple{d.box(), segment(d), of_ball(d)};
      },
      [&](const auto& input) {
        const auto& [box, pq, ball] = input;
        const Plain p = at(pq, ball.part[0]);
        const Plain q{std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y),
                      std::clamp(p.z, box.min.z, box.max.z)};
        const Plain off = ball.way(p - q);
        const Plain corner{off.x > 0 ? box.max.x : box.min.x, off.y > 0 ? box.max.y : box.min.y,
                           off.z > 0 ? box.max.z : box.min.z};
        return told<World>(OfAabb{}, q, corner, pq, ball.radius, ball.part[0], off);
      },
      [](const auto& input) {
        const auto& [box, pq, ball] = input;
        return compare_distance(box, pq, ball.radius);
      });
  mutants::expect_noticed("near_aabb", of_box);
}

}  // namespace
}  // namespace plumb::figure::near_points
