// Two hulls of few points and a distance: what doubles prove, and what integers tell of the rest, against exact
// distances.
#include "query/convex/near_pair.hpp"

#include <gtest/gtest.h>

#include "plumb/degenerate/entropy.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_vertices.hpp"

namespace plumb::query {
namespace {

struct Told {
  int by_doubles = 0, by_integers = 0, by_none = 0, touching = 0;
};

template <class A, class B>
void ask(const A& a, const B& b, double radius_a, double radius_b, Told& told) {
  LikelyEnds likely;
  const auto quick = quick_gap(vertices(a), vertices(b), radius_a, radius_b, &likely);
  const auto exact =
      quick ? quick : integer_gap(vertices<ShortDyadic>(a), vertices<ShortDyadic>(b), radius_a, radius_b, likely);
  ++(quick ? told.by_doubles : exact ? told.by_integers : told.by_none);
  if (!exact) return;
  const mpq_class reach = mpq_class(radius_a) + mpq_class(radius_b);
  const int gap = sgn(mpq_class(*squared_distance(flat_set(a), flat_set(b)) - reach * reach));
  EXPECT_EQ(static_cast<int>(*exact), gap);
  told.touching += gap == 0 ? 1 : 0;
}

/// On a grid of so many steps of this length, where much touches.
class GridShapes {
 public:
  GridShapes(std::uint64_t seed, std::uint64_t steps, double unit) : entropy_(97, seed), steps_(steps), unit_(unit) {}

  double number() {
    return (static_cast<double>(entropy_.below(2 * steps_ + 1)) - static_cast<double>(steps_)) * unit_;
  }
  double radius() { return static_cast<double>(1 + entropy_.below(steps_)) * unit_; }
  Point3 point() { return {number(), number(), number()}; }
  Vector3 vector() { return {number() / unit_, number() / unit_, number() / unit_}; }
  Segment3 segment() { return {point(), point()}; }
  Aabb3 box() {
    const Point3 p = point(), q = point();
    return {{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
            {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}};
  }

 private:
  Entropy entropy_;
  std::uint64_t steps_;
  double unit_;
};

TEST(NearPair, WhatIsToldIsSoAndIntegersTellWhatTouches) {
  for (const double unit : {1.0, 0x1p-200, 1.0 + 0x1p-52}) {
    SCOPED_TRACE(unit);
    Told told;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      SCOPED_TRACE(i);
      GridShapes s(i, 3 + i % 3, unit);
      ask(Triangle3{s.point(), s.point(), s.point()}, s.point(), 0, s.radius(), told);
      ask(s.segment(), s.segment(), s.radius(), s.radius(), told);
      ask(s.box(), s.segment(), 0, s.radius(), told);
      ask(Tetrahedron3{s.point(), s.point(), s.point(), s.point()}, s.segment(), 0, s.radius(), told);
      ask(Obb3{s.point(), {s.vector(), s.vector(), s.vector()}, {s.radius(), s.radius(), s.radius()}}, s.point(), 0,
          s.radius(), told);
    }
    EXPECT_GE(told.touching, 50);
    EXPECT_GE(told.by_integers, told.touching);
    EXPECT_LE(told.by_none, told.by_integers / 10);
  }
}

TEST(NearPair, NothingIsToldOfNoRadius) {
  LikelyEnds likely;
  const Point3 p{1, 2, 3};
  EXPECT_FALSE(quick_gap(vertices(p), vertices(p), 0, 0, &likely));
  EXPECT_FALSE(integer_gap(vertices<ShortDyadic>(p), vertices<ShortDyadic>(p), 0, 0, likely));
}

TEST(NearPair, NumbersTooFarApartAreLeftToOthers) {
  const Point3 p{0x1p1000, 0, 0}, q{0x1p-1000, 0, 0};
  const LikelyEnds likely{.ends = {{{0, 0}}}, .size = 1};
  EXPECT_FALSE(integer_gap(vertices<ShortDyadic>(p), vertices<ShortDyadic>(q), 0, 0x1p1000, likely));
}

}  // namespace
}  // namespace plumb::query
