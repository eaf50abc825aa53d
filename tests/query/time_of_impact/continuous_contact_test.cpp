// Do moving vertices and edges meet exactly when real arithmetic says so, and when first?
#include "plumb/query/time_of_impact/continuous_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>

#include "lab/trial/contact_judge.hpp"
#include "lab/trial/moving_cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/time_of_impact/brief_contact.hpp"
#include "query/time_of_impact/contact_filter.hpp"
#include "query/time_of_impact/exact_contact.hpp"

namespace plumb::lab::moving_cases {
namespace {

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t cases = 5000;
#else
constexpr std::uint64_t cases = 300;
#endif

constexpr double infinity = std::numeric_limits<double>::infinity();

bool meets(const Case& c, double separation = 0) {
  return of_figures(c, [&](const auto& a, const auto& b) { return intersects(a, b, {separation}); });
}
std::optional<Contact> contact(const Case& c, double separation = 0) {
  return of_figures(c, [&](const auto& a, const auto& b) { return first_contact(a, b, {separation}); });
}
std::optional<Root> time_of(const Case& c, double separation = 0) {
  return of_figures(c, [&](const auto& a, const auto& b) { return first_contact_time(a, b, {separation}); });
}

std::string shown(Kind kind, std::uint64_t index, const Case& c) {
  std::string text = std::string(name_of(kind)) + ", Entropy(2026, " + std::to_string(index) + ")" +
                     (c.vertex_face ? ", vertex and triangle:" : ", two edges:");
  for (const auto& points : {c.at_0, c.at_1}) {
    for (const Point3& p : points) {
      std::array<char, 96> line{};
      std::snprintf(line.data(), line.size(), " (%a %a %a)", p.x, p.y, p.z);
      text += line.data();
    }
  }
  return text;
}

std::string name_of(const Contact& c) {
  constexpr std::array<const char*, 4> names{"vertex", "edge", "face", "interior"};
  return std::string(names[static_cast<std::size_t>(c.feature_a.kind)]) + "-" +
         names[static_cast<std::size_t>(c.feature_b.kind)];
}

/// Against the oracle: the answer, and the first time within the double.
void check(const Case& c, double separation, std::map<std::string, int>& seen) {
  const std::vector<lab::contact_judge::Time> truth =
      lab::contact_judge::contacts(c.vertex_face, c.at_0, c.at_1, separation);
  ASSERT_EQ(meets(c, separation), !truth.empty());
  const std::optional<Contact> first = contact(c, separation);
  const std::optional<Root> exact = time_of(c, separation);
  ASSERT_EQ(first.has_value(), !truth.empty());
  ASSERT_EQ(exact.has_value(), !truth.empty());
  ++seen[truth.empty() ? "apart" : "meet"];
  if (!first) return;
  ASSERT_EQ(first->time, exact->rounded(Rounding::down));
  const mpq_class down(first->time), up(std::nextafter(first->time, infinity));
  bool reached = false;
  for (const lab::contact_judge::Time& t : truth) {
    ASSERT_GE(side(t, down), 0) << "late";
    if (side(t, up) >= 0) continue;
    reached = true;
    if (separation != 0 && first->time == 0) continue;  // the nearest features then, not any that are near enough
    ASSERT_EQ(first->feature_a, t.a);
    ASSERT_EQ(first->feature_b, t.b);
  }
  ASSERT_TRUE(reached) << "early";
  ++seen[name_of(*first)];
  ++seen[first->time == 0 ? "at 0" : first->time == 1 ? "at 1" : "between"];
  if (*exact != Rational(first->time)) ++seen["no double"];
}

void check_all(Kind kind, double separation, std::uint64_t count) {
  std::map<std::string, int> seen;
  for (std::uint64_t i = 0; i < count; ++i) {
    Entropy entropy(2026, i);
    const Case c = make(kind, entropy);
    ASSERT_NO_FATAL_FAILURE(check(c, separation, seen)) << shown(kind, i, c) << " separation " << separation;
  }
  std::cout << name_of(kind) << ", separation " << separation << ":";
  for (const auto& [name, times] : seen) std::cout << ' ' << name << ' ' << times;
  std::cout << '\n';
  const int few = static_cast<int>(count / 25);
  EXPECT_GT(seen["meet"], few);
  if (kind != Kind::planted) {
    EXPECT_GT(seen["apart"], few);
  }
  EXPECT_GT(seen["between"], few);
}

TEST(ContinuousContactTest, AgreesWithSturmSequences) {
  for (const Kind kind : kinds) {
    ASSERT_NO_FATAL_FAILURE(check_all(kind, 0, kind == Kind::family ? cases / 10 : cases));
  }
}

TEST(ContinuousContactTest, AgreesWithSturmSequencesAtADistance) {
  for (const Kind kind : kinds) {
    if (kind == Kind::family) continue;
    ASSERT_NO_FATAL_FAILURE(check_all(kind, 0.5, cases / 20));
    ASSERT_NO_FATAL_FAILURE(check_all(kind, 1, cases / 20));
  }
}

/// The same motion, with coordinates of some hundred bits together.
Case in_odd_places(Case c) {
  for (auto* points : {&c.at_0, &c.at_1}) {
    for (Point3& p : *points) p = {p.x / 3, p.y / 5 + 1, p.z / 7 - 0x1p-30};
  }
  return c;
}

TEST(ContinuousContactTest, IntegersOnTheStackAgreeWithThoseOfAnyLength) {
  using namespace query::moving;
  for (const Kind kind : kinds) {
    int filtered = 0, brief = 0, asked = 0;
    for (std::uint64_t i = 0; i < cases; ++i) {
      Entropy entropy(2032, i);
      Case c = make(kind, entropy);
      if (kind == Kind::family && i % 8 != 0) continue;
      if (kind != Kind::family && i % 2 == 0) c = in_odd_places(c);
      const ContactQuestion q{c.vertex_face ? MovingKind::vertex_triangle : MovingKind::edge_edge, c.at_0, c.at_1};
      const auto exact = exact_first_contact(q.kind, q.at_0, q.at_1, 0);
      const BriefContact first = brief_contact(q, query::ContactWanted::when);
      const BriefContact met = brief_contact(q, query::ContactWanted::whether);
      const ContactVerdict rough = contact_filter(q);
      const ContactVerdict truth = exact ? ContactVerdict::yes : ContactVerdict::no;
      ++asked;
      filtered += rough != ContactVerdict::unsure ? 1 : 0;
      if (rough != ContactVerdict::unsure) {
        ASSERT_EQ(rough, truth) << shown(kind, i, c);
      }
      if (met.verdict != ContactVerdict::unsure) {
        ASSERT_EQ(met.verdict, truth) << shown(kind, i, c);
      }
      if (first.verdict == ContactVerdict::unsure) continue;
      ++brief;
      ASSERT_EQ(first.verdict, truth) << shown(kind, i, c);
      if (!exact) continue;
      ASSERT_EQ(first.contact, (Contact{arith::rounded(Rounding::down, exact->time), exact->a, exact->b}))
          << shown(kind, i, c);
    }
    std::cout << name_of(kind) << ": of " << asked << " doubles tell " << filtered << ", integers on the stack "
              << brief << '\n';
    // Of families, whose exponents are any, some are too long.
    EXPECT_GE(brief, kind == Kind::family ? asked / 2 : asked - asked / 50 - 1) << name_of(kind);
    const bool is_hard = kind == Kind::planar || kind == Kind::parallel || kind == Kind::flat || kind == Kind::planted;
    EXPECT_GE(filtered, is_hard ? 0 : asked / 4) << name_of(kind);
  }
}

// The edges come into one plane 2^-57 before a quarter of the time, where they meet, and again 2^-57 after it, where
// they are apart: the first root lies at the end of a piece of time.
TEST(ContinuousContactTest, EdgesMeetAtTheFirstOfTwoTimesNearAQuarter) {
  const Moving<Segment3> p{
      {{-0x1.5555555555555p-3, 0x1.6666666666666p-1, -0x1.b6db6dd6db6dbp-3},
       {-0x1p-1, 0x1.0cccccccccccdp+0, -0x1.0000001p-2}},
      {{0x1p-1, 0x1.e666666666666p+0, -0x1.00000008p-1}, {0x1.8p+0, 0x1.b333333333333p-1, -0x1.924924a249249p-2}}};
  const Moving<Segment3> q{
      {{-0x1.5555555555555p-4, 0x1p+0, -0x1.2492492c92492p-1},
       {-0x1.aaaaaaaaaaaabp-2, 0x1.999999999999ap-1, -0x1.0000001p-2}},
      {{0x1p-2, 0x1.4cccccccccccdp+1, 0x1.2492491c92492p-1}, {0x1.4p+0, 0x0p+0, -0x1.924924a249249p-2}}};
  EXPECT_TRUE(intersects(p, q));
  EXPECT_TRUE(intersects(q, p));
  const auto hit = first_contact(p, q);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->time, std::nextafter(0.25, 0));
  EXPECT_LT(*first_contact_time(p, q), Rational(1) / Rational(4));
}

TEST(ContinuousContactTest, TriangleIsHitWhereItIs) {
  const Moving<Triangle3> floor{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const auto falling = [](double x, double y) { return Moving<Point3>{{x, y, 1}, {x, y, -2}}; };
  const auto hit = [&](double x, double y) { return first_contact(falling(x, y), floor); };
  const double third = 1.0 / 3;  // below 1 / 3
  EXPECT_EQ(hit(1, 1), (Contact{third, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
  EXPECT_EQ(hit(2, 0), (Contact{third, {FeatureKind::vertex, 0}, {FeatureKind::edge, 0}}));
  EXPECT_EQ(hit(2, 2), (Contact{third, {FeatureKind::vertex, 0}, {FeatureKind::edge, 1}}));
  EXPECT_EQ(hit(0, 1), (Contact{third, {FeatureKind::vertex, 0}, {FeatureKind::edge, 2}}));
  EXPECT_EQ(hit(4, 0), (Contact{third, {FeatureKind::vertex, 0}, {FeatureKind::vertex, 1}}));
  EXPECT_EQ(hit(std::nextafter(2, 3), 2), std::nullopt);
  EXPECT_EQ(first_contact(floor, falling(4, 0)), (Contact{third, {FeatureKind::vertex, 1}, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(*first_contact_time(falling(1, 1), floor), Rational(1) / Rational(3));
  EXPECT_EQ(first_contact(falling(1, 1), floor, {.separation = 0.25})->time, 0.25);
  EXPECT_EQ(first_contact(falling(1, 1), floor, {.separation = 1})->time, 0);
  // In the plane of the triangle the whole time, along an edge's line, and past a vertex.
  EXPECT_EQ(first_contact(Moving<Point3>{{-1, 0, 0}, {7, 0, 0}}, floor),
            (Contact{0.125, {FeatureKind::vertex, 0}, {FeatureKind::vertex, 0}}));
  EXPECT_FALSE(intersects(Moving<Point3>{{-1, 0, 0}, {-0x1p-1074, 0, 0}}, floor));
  EXPECT_TRUE(intersects(Moving<Point3>{{-1, 0, 0}, {0, 0, 0}}, floor));
}

TEST(ContinuousContactTest, EdgesMeetAtTimesThatNoDoubleHolds) {
  // A quarter of root 5 less 1: the root of 4 t^2 + 2 t - 1.
  const Moving<Segment3> a{{{-1, 0, 0}, {1, 0, 0}}, {{-1, 0, 0}, {1, 0, 0}}};
  const Moving<Segment3> b{{{0, -1, -1}, {0, 1, -1}}, {{0, -3, -1}, {0, -1, 3}}};
  const std::optional<Root> t = first_contact_time(a, b);
  ASSERT_TRUE(t.has_value());
  EXPECT_EQ(*t, real_roots(std::array<Rational, 3>{-1, 2, 4}, 0, 1)[0]);
  EXPECT_EQ(t->rounded(), (std::sqrt(5.0) - 1) / 4);
  EXPECT_EQ(first_contact(a, b)->time, t->rounded(Rounding::down));
  EXPECT_EQ(first_contact(a, b), swapped(*first_contact(b, a)));
}

TEST(ContinuousContactTest, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Moving<Triangle3> t{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 0}, {4, 0, 0}, {0, infinity, 0}}};
  const Moving<Point3> p{{9, 9, 9}, {9, 9, 9}}, q{{9, nan, 9}, {9, 9, 9}};
  const auto text = [](const auto& ask) {
    try {
      ask();
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(text([&] { intersects(p, t); }).find("intersects: b.to.c.y is inf"), 0u);
  EXPECT_EQ(text([&] { intersects(t, p); }).find("intersects: a.to.c.y is inf"), 0u);
  EXPECT_EQ(text([&] { static_cast<void>(first_contact(q, t)); }).find("first_contact: a.from.y is nan"), 0u);
  const Moving<Segment3> s{{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, nan}}};
  EXPECT_EQ(text([&] { static_cast<void>(first_contact_time(s, s)); }).find("first_contact_time: a.to.b.z is nan"), 0u);
  EXPECT_THROW(intersects(p, Moving<Triangle3>{}, {-1.0}), InvalidShape);
  EXPECT_THROW(intersects(p, Moving<Triangle3>{}, {nan}), NonFinite);
}

Case reversed(Case c) {
  std::swap(c.at_0, c.at_1);
  return c;
}
Case scaled(Case c, double x, double y, double z) {
  for (auto* points : {&c.at_0, &c.at_1}) {
    for (Point3& p : *points) p = {p.x * x, p.y * y, p.z * z};
  }
  return c;
}
Case scaled(const Case& c, double factor) { return scaled(c, factor, factor, factor); }
Case translated(Case c, const Point3& by) {
  for (auto* points : {&c.at_0, &c.at_1}) {
    for (Point3& p : *points) p = plus(p, by, 1);
  }
  return c;
}
Case permuted(Case c) {
  for (auto* points : {&c.at_0, &c.at_1}) {
    std::swap((*points)[2], (*points)[3]);
    if (!c.vertex_face) std::swap((*points)[0], (*points)[1]);
    if (c.vertex_face) std::swap((*points)[1], (*points)[2]);
  }
  return c;
}
std::optional<double> time_of(const std::optional<Contact>& c) { return c ? std::optional(c->time) : std::nullopt; }

TEST(ContinuousContactTest, KeepsItsLaws) {
  for (const Kind kind : kinds) {
    if (kind == Kind::family) continue;
    for (std::uint64_t i = 0; i < cases; ++i) {
      Entropy entropy(2027, i);
      const Case c = make(kind, entropy);
      const double separation = entropy.below(4) == 0 ? 1 : 0;
      const bool answer = meets(c, separation);
      const std::optional<Contact> first = contact(c, separation);
      const std::string which = shown(kind, i, c);
      ASSERT_EQ(first.has_value(), answer) << which;
      ASSERT_EQ(meets(reversed(c), separation), answer) << which;
      ASSERT_EQ(meets(permuted(c), separation), answer) << which;
      ASSERT_EQ(time_of(contact(permuted(c), separation)), time_of(first)) << which;
      ASSERT_EQ(contact(translated(c, {64, -128, 3}), separation), first) << which;
      for (const double factor : {0x1p-300, 0x1p-1010, 0x1p900, 0x1p1000}) {
        ASSERT_EQ(meets(scaled(c, factor), separation * factor), answer) << which << factor;
        ASSERT_EQ(contact(scaled(c, factor), separation * factor), first) << which << factor;
      }
      if (separation == 0 && i % 16 == 0) {  // touching is a question of affine geometry
        ASSERT_EQ(contact(scaled(c, 0x1p-545, 0x1p-530, 0x1p1000)), first) << which;
        ASSERT_EQ(contact(scaled(c, 0x1p1000, 0x1p-1000, 0x1p-60)), first) << which;
        ASSERT_EQ(meets(scaled(c, 0x1p-545, 0x1p1000, 0x1p-530)), answer) << which;
      }
      of_figures(c, [&](const auto& a, const auto& b) {
        const auto other = first_contact(b, a, {separation});
        ASSERT_EQ(other.has_value(), answer) << which;
        if (other && c.vertex_face) {
          ASSERT_EQ(swapped(*other), *first) << which;
        } else if (other) {
          ASSERT_EQ(other->time, first->time) << which;
        }
        ASSERT_EQ(intersects(b, a, {separation}), answer) << which;
      });
    }
  }
}

TEST(ContinuousContact, AxesOfAnySizeBesideOthers) {
  const auto scaled = [](const Point3& p, int x, int y, int z) {
    return Point3{std::ldexp(p.x, x), std::ldexp(p.y, y), std::ldexp(p.z, z)};
  };
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, std::array{1000, -180, 180}, std::array{500, -260, 700}}) {
    const auto at = [&, x = x, y = y, z = z](double px, double py, double pz) { return scaled({px, py, pz}, x, y, z); };
    const Moving<Segment3> a{{at(1, 2, -3), at(4, -2, 0)}, {at(1, 1, -1), at(0, -3, 0)}};
    const Moving<Segment3> b{{at(4, -1, -3), at(-4, 1, 3)}, {at(4, 0, 4), at(-1, 3, -1)}};
    EXPECT_TRUE(intersects(a, b)) << x;
    EXPECT_TRUE(first_contact(a, b)) << x;
  }
  const double u = 0x1p-1022;
  const Point3 p{0x0.0002e163fd766p0 * u, 0x1.29a482140f2dcp+500, 0x1.4f0a211b89b3p+499};
  const Triangle3 t{{0x0.0001086f6c93cp0 * u, -0x1.d9409db29308p+497, -0x1.040ac6071af78p+502},
                    {0x0.0007620661fa4p0 * u, 0x1.49a1612cffbcp+501, 0x1.5194a4c14fe4p+499},
                    {0x0.00018d8d13a5cp0 * u, 0x1.273bacd647dp+500, 0x1.815d41fcb5d48p+501}};
  EXPECT_EQ(intersects(Moving<Point3>{p, p}, Moving<Triangle3>{t, t}), contains(t, p));
}

}  // namespace
}  // namespace plumb::lab::moving_cases
