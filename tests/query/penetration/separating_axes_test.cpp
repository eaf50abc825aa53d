// Boxes by their axes, and by the search that takes any body: do both tell the same?
#include "query/penetration/separating_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/shape_pair.hpp"
#include "plumb/figure/generated/generated.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/told_checks.hpp"

namespace plumb {
namespace {

using namespace query::parting;
using degenerate::Nearness, degenerate::PositionInfo;
using Known = SumParting::Known;

struct Seen {
  int nothing = 0, apart = 0, touching = 0, deep = 0, several = 0;
};

template <class A, class B>
void expect_same(const A& a, const B& b, const std::string& about, Seen& seen) {
  const query::BodyView p = query::body_view(a), q = query::body_view(b);
  std::optional<std::array<query::CoreCorners, 2>> sound;
  try {
    sound = query::corners_of("", p, q);
  } catch (const InvalidShape&) {
    return;  // an empty box
  }
  const auto& corners = *sound;
  const Difference d{corners[0], corners[1]};
  const SumParting by_axes = parted_sums(d);
  if (by_axes.known == Known::nothing) {
    ++seen.nothing;
    return;
  }
  const auto by_search = parted(d, {});
  ASSERT_EQ(by_axes.known == Known::parting, by_search.has_value()) << about;
  if (!by_search) {
    ++seen.apart;
    return;
  }
  const auto way = by_axes.parting->way.along<mpq_class>(d), other = by_search->way.along<mpq_class>(d);
  EXPECT_TRUE(told_checks::same_direction({way.x, way.y, way.z}, {other.x, other.y, other.z})) << about;
  EXPECT_EQ(by_axes.parting->is_unique, by_search->is_unique) << about;
  const FlushPair flush = flush_pair(p, q, d, by_search->way);
  EXPECT_EQ(flush_feature(p, corners[0], by_axes.level[0], by_axes.is_plain[0]), flush.a) << about;
  EXPECT_EQ(flush_feature(q, corners[1], by_axes.level[1], by_axes.is_plain[1]), flush.b) << about;
  EXPECT_EQ(by_axes.level[0].first, flush.in_plane[0]) << about;
  EXPECT_EQ(by_axes.level[1].first, flush.in_plane[1]) << about;
  const mpq_class overlap = dot(way, d.at<mpq_class>(flush.in_plane));
  if (by_axes.overlap && by_axes.overlap->radius == 0) {
    const mpq_class high = by_axes.overlap->high, told = high + by_axes.overlap->low + overlap;
    EXPECT_EQ(sgn(told), 0) << about;
  }
  (sgn(overlap) == 0 ? seen.touching : seen.deep) += 1;
  seen.several += by_axes.parting->is_unique ? 0 : 1;
}

void expect_many(const Seen& seen, int each) {
  std::printf("nothing %d, apart %d, touching %d, deep %d, several %d\n", seen.nothing, seen.apart, seen.touching,
              seen.deep, seen.several);
  EXPECT_GE(std::min({seen.apart, seen.touching, seen.deep, seen.several}), battery::sanitized ? 0 : each);
}

template <class A, class B>
void expect_in_positions(int cases, Seen& seen) {
  for (const PositionInfo& position : degenerate::positions) {
    if (!has_position<A, B>(position.position)) continue;
    for (int i = 0; i < cases; ++i) {
      Entropy entropy(78, static_cast<std::uint64_t>(i));
      const Nearness nearness = i % 2 == 0 ? Nearness::exactly : Nearness::nearly;
      const auto [a, b] =
          pair_from<A, B>(shape_pair(generated_kind<A>, generated_kind<B>, 3, position.position, nearness, entropy));
      expect_same(a, b, std::string(position.name) + " " + std::to_string(i), seen);
    }
  }
}

TEST(SeparatingAxes, InEveryPosition) {
  const int few = battery::sanitized ? 1 : 10;
  Seen seen;
  expect_in_positions<Obb3, Obb3>(few, seen);
  expect_in_positions<Aabb3, Aabb3>(few, seen);
  expect_in_positions<Aabb3, Obb3>(few, seen);
  expect_in_positions<Obb3, Segment3>(few, seen);
  expect_many(seen, 20);
}

template <class A, class B>
void expect_pairs(std::uint64_t start, Seen& seen) {
  shape_cases::on_shapes(start, battery::sanitized ? 2 : 40, [&](pair_cases::Material& m) {
    const A a = pair_cases::figure<A>(m);
    const B b = pair_cases::near_figure<B>(m);
    expect_same(a, b, m.about(), seen);
  });
}

TEST(SeparatingAxes, OfWhateverIsASum) {
  Seen seen;
  expect_pairs<Obb3, Obb3>(1, seen);
  expect_pairs<Obb3, Aabb3>(2, seen);
  expect_pairs<Aabb3, Aabb3>(3, seen);
  expect_pairs<Obb3, Point3>(4, seen);
  expect_pairs<Aabb3, Segment3>(5, seen);
  expect_pairs<Rectangle3, Rectangle3>(6, seen);
  expect_pairs<Rectangle3, Segment3>(7, seen);
  expect_pairs<Lozenge3, Obb3>(8, seen);
  expect_many(seen, 20);
  EXPECT_GE(seen.nothing, battery::sanitized ? 1 : 20);  // those without an inside
}

/// Whole numbers of a few bits, so that much is level.
Obb3 small_box(Entropy& entropy, int exponent, bool is_flat) {
  const auto number = [&] { return std::ldexp(static_cast<double>(entropy.within(3)), exponent); };
  const auto axis = [&] { return Vector3{number(), number(), number()}; };
  const double h = is_flat ? 0 : 1;
  return {{number(), number(), number()}, {axis(), axis(), axis()}, {1, 0.5, h}};
}

TEST(SeparatingAxes, OfAxesThatAreNotAtRightAngles) {
  Seen seen;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 10 : 300); ++i) {
    Entropy entropy(79, i);
    const int exponent = i % 5 == 0 ? -330 : i % 5 == 1 ? 300 : 0;  // where products of doubles end
    const Obb3 a = small_box(entropy, exponent, i % 7 == 0), b = small_box(entropy, exponent, i % 3 == 0);
    expect_same(a, b, "small boxes " + std::to_string(i), seen);
    expect_same(a, a, "a box with itself " + std::to_string(i), seen);
    const Pose turn{{{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}, {0.1, 0.2, 0.3}};
    if (i % 4 == 0) expect_same(Posed{a, turn}, Posed{b, turn}, "posed " + std::to_string(i), seen);
    if (i % 4 == 1) expect_same(Posed{a, turn}, b, "one of them posed " + std::to_string(i), seen);
  }
  std::printf("nothing %d, apart %d, touching %d, deep %d, several %d\n", seen.nothing, seen.apart, seen.touching,
              seen.deep, seen.several);
  EXPECT_GE(std::min({seen.nothing, seen.apart, seen.deep, seen.several}), battery::sanitized ? 0 : 20);
}

TEST(SeparatingAxes, OfBoxesThatTouchOrNearlyDo) {
  Seen seen;
  for (int i = 0; i < (battery::sanitized ? 5 : 100); ++i) {
    Entropy entropy(80, static_cast<std::uint64_t>(i));
    const auto number = [&] { return 0.5 + std::ldexp(static_cast<double>(entropy.within(1 << 20)), -22); };
    const Aabb3 a{{-number(), -number(), -number()}, {number(), number(), number()}};
    for (const double x : {a.max.x, std::nextafter(a.max.x, 9), std::nextafter(a.max.x, -9)}) {
      const Aabb3 b{{x, -number(), -number()}, {x + number(), number(), number()}};
      expect_same(a, b, "side by side " + std::to_string(i), seen);
      const Obb3 turned{{x + 2, 0, 0}, {Vector3{1, 1, 0}, Vector3{-1, 1, 0}, Vector3{0, 0, 1}}, {1, 1, number()}};
      expect_same(a, turned, "an edge on a side " + std::to_string(i), seen);
      for (const double gap : {0x1p-50, -0x1p-50}) {  // which doubles alone do not tell
        const Obb3 moved{{x + 2 + gap, 0, 0}, turned.axes, turned.half};
        expect_same(a, moved, "an edge beside a side " + std::to_string(i), seen);
      }
      const double half = number();
      const Obb3 of_axes{{x + half, 0, 0}, {Vector3{0, -1, 0}, Vector3{0, 0, 2}, Vector3{1, 0, 0}}, {1, 1, half}};
      expect_same(a, of_axes, "along the axes of space " + std::to_string(i), seen);
    }
  }
  std::printf("nothing %d, apart %d, touching %d, deep %d, several %d\n", seen.nothing, seen.apart, seen.touching,
              seen.deep, seen.several);
  EXPECT_GE(std::min({seen.apart, seen.touching, seen.deep}), battery::sanitized ? 0 : 100);
}

}  // namespace
}  // namespace plumb
