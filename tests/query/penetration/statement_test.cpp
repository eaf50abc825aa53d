// Would a wrong statement be noticed?  Mutants of what the search compares, and of what it tells.
#include <gtest/gtest.h>

#include <functional>

#include "query/penetration/parted.hpp"
#include "query/penetration/told_checks.hpp"

namespace plumb {
namespace {

using namespace penetration_oracle;
using query::parting::Difference, query::parting::EveryWay, query::parting::Fraction, query::parting::PlaneOf;

/// Takes the height for the distance, however long the normal is.
struct UnscaledHeight : EveryWay {
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t) const {
    return {plane.height() * plane.height(), T(1.0)};
  }
};
/// Divides by the normal's length instead of its square.
struct HeightNotSquared : EveryWay {
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t) const {
    return {plane.height(), dot(plane.normal, plane.normal)};
  }
};
/// Forgets one coordinate of the normal.
struct FlatNormal : EveryWay {
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t) const {
    const T h = plane.height();
    return {h * h, plane.normal.x * plane.normal.x + plane.normal.y * plane.normal.y + T(0x1p-60)};
  }
};

struct Case {
  std::array<query::Body, 2> bodies;
  Expected wanted;
  Round a, b;
};

template <class Aim>
bool is_right(const Case& c, const Aim& aim) {
  const Difference d{c.bodies[0].corners, c.bodies[1].corners};
  const auto planes = query::parting::nearest_planes(d, query::parting::core_distance(d), aim);
  if (planes.facets.empty()) return false;
  const auto way = query::parting::first_of(d, planes).way.template along<mpq_class>(d);
  return told_checks::same_direction({way.x, way.y, way.z}, c.wanted.direction);
}

struct Pair {
  Tetrahedron3 a, b;
};
Pair deep_pair(std::uint64_t i) {
  Entropy entropy(3, i);
  const auto point = [&](double s) {
    const auto number = [&] { return s * static_cast<double>(entropy.within(100)); };
    return Point3{number(), number(), number()};
  };
  return {{{-90, -80, -70}, {95, -60, -75}, {5, 90, -80}, point(0.125)}, {point(1), point(1), point(1), point(1)}};
}

TEST(PenetrationStatement, MutantsAreNoticed) {
  int all = 0;
  std::array<int, 3> noticed{};
  for (std::uint64_t i = 0; i < 60; ++i) {
    const auto [a, b] = deep_pair(i);
    const Round p = round_of(a), q = round_of(b);
    const auto wanted = expected(p, q);
    if (!wanted || wanted->core_square == 0) continue;
    const Case c{query::bodies_of("", query::body_view(a), query::body_view(b)), *wanted, p, q};
    ++all;
    EXPECT_TRUE(is_right(c, EveryWay())) << i;
    noticed[0] += is_right(c, UnscaledHeight()) ? 0 : 1;
    noticed[1] += is_right(c, HeightNotSquared()) ? 0 : 1;
    noticed[2] += is_right(c, FlatNormal()) ? 0 : 1;
  }
  EXPECT_GE(all, 20);
  for (const int n : noticed) EXPECT_GE(n * 5, all);
}

TEST(PenetrationStatement, MutatedAnswersAreRefused) {
  std::uint64_t number = 0;
  while (!penetration(deep_pair(number).a, deep_pair(number).b)) ++number;
  const auto [a, b] = deep_pair(number);
  const Round p = round_of(a), q = round_of(b);
  const auto wanted = expected(p, q);
  ASSERT_TRUE(wanted && wanted->core_square != 0);
  const Penetration told = *penetration(a, b);
  const ExactPenetration exact = *exact_penetration(a, b);
  ASSERT_EQ(told_checks::fault(*wanted, p, q, told, exact), "");
  const auto up = [](double& x) { x = std::nextafter(x, HUGE_VAL); };
  const std::vector<std::function<void(Penetration&, ExactPenetration&)>> mutants{
      [&](Penetration& t, ExactPenetration&) { up(t.depth); },
      [&](Penetration& t, ExactPenetration&) { up(t.direction.x); },
      [&](Penetration& t, ExactPenetration&) { up(t.direction.z); },
      [&](Penetration& t, ExactPenetration&) { up(t.translation.y); },
      [](Penetration& t, ExactPenetration&) { t.is_unique = !t.is_unique; },
      [](Penetration& t, ExactPenetration&) { t.feature_a.index += 1; },
      [](Penetration&, ExactPenetration& e) { e.is_unique = !e.is_unique; },
      [](Penetration&, ExactPenetration& e) { e.cores_are_apart = !e.cores_are_apart; },
      [](Penetration&, ExactPenetration& e) { e.core_square = e.core_square + Rational(1, 1000000); },
      [](Penetration&, ExactPenetration& e) { e.radii = Rational(1); },
      [](Penetration&, ExactPenetration& e) { e.direction.y = e.direction.y + Rational(1); },
      [](Penetration&, ExactPenetration& e) {
        e.direction = {-e.direction.x, -e.direction.y, -e.direction.z};
      },
      [](Penetration&, ExactPenetration& e) {
        const Rational two(2);
        e.direction = {e.direction.x * two, e.direction.y * two, e.direction.z * two};
      },
      [](Penetration&, ExactPenetration& e) { e.core_translation.x = e.core_translation.x + Rational(1, 3); },
  };
  for (std::size_t i = 0; i < mutants.size(); ++i) {
    Penetration t = told;
    ExactPenetration e = exact;
    mutants[i](t, e);
    EXPECT_NE(told_checks::fault(*wanted, p, q, t, e), "") << i;
  }
  ExactPenetration shorter = exact;
  const Rational part(99, 100);
  const ExactVector3& by = exact.core_translation;
  shorter.core_translation = {by.x * part, by.y * part, by.z * part};
  EXPECT_EQ(told_checks::fault_of_move(exact, p, q), "");
  EXPECT_NE(told_checks::fault_of_move(shorter, p, q), "");
}

}  // namespace
}  // namespace plumb
