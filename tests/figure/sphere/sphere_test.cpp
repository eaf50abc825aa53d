// Do balls meet and hold one another as in real arithmetic, and does every ball made of others hold them?
#include "plumb/figure/sphere/sphere.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "figure/sphere/rational_ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/proof_script.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using namespace plumb_test;
using shape_cases::Material;
using shape_cases::on_shapes;
using testing::StartsWith;

constexpr double largest = std::numeric_limits<double>::max();

/// The sign of the distance of the centers less x.
template <class Ball>
int distance_against(const Ball& a, const Ball& b, const mpq_class& x) {
  if (x < 0) return 1;
  return cmp(squared_distance(rationals(a.center), rationals(b.center)), x * x);
}

/// The second touches or nearly touches the first, from without or within, in one case of three.
template <class Ball>
Ball neighbor(Material& m, const Ball& a) {
  Ball b = m.shape<Ball>();
  if (m.below(3) != 0) return b;
  const double ways[] = {1, -1, 0.5};
  const double x = a.center.x + a.radius + ways[m.below(3)] * b.radius;
  if (!std::isfinite(x)) return b;
  b.center = a.center;
  b.center.x = x;
  if (m.below(3) == 0) b.center.x = moved_by_ulps(x, 1);
  return b;
}

template <class Ball>
void expect_relations(std::uint64_t start) {
  std::map<Relation, int> relations;
  int holds = 0, cases = 0;
  on_shapes(start, 20000, [&](Material& m) {
    const Ball a = m.shape<Ball>(), b = neighbor(m, a);
    const std::string about = m.about(a, b);
    const mpq_class ra(a.radius), rb(b.radius);
    const int gap = distance_against(a, b, ra + rb);
    const Relation expected = gap > 0                           ? Relation::disjoint
                              : gap < 0 || (ra == 0 && rb == 0) ? Relation::overlapping
                                                                : Relation::touching;
    EXPECT_EQ(relate(a, b), expected) << about;
    EXPECT_EQ(relate(b, a), expected) << about;
    EXPECT_EQ(intersects(a, b), gap <= 0) << about;
    const bool inner = distance_against(a, b, ra - rb) <= 0;
    EXPECT_EQ(contains(a, b), inner) << about;
    ++relations[expected], ++cases, holds += inner ? 1 : 0;
  });
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping}) {
    EXPECT_GT(relations[r], cases / 40) << static_cast<int>(r);
  }
  EXPECT_GT(holds, cases / 20);
}

TEST(Sphere, RelatesAsRealNumbersDo) { expect_relations<Sphere3>(71); }
TEST(Circle, RelatesAsRealNumbersDo) { expect_relations<Circle2>(72); }

TEST(Sphere, TellsTouchingFromOverlapping) {
  const Sphere3 unit{{0, 0, 0}, 1};
  EXPECT_EQ(relate(unit, Sphere3{{3, 4, 0}, 4}), Relation::touching);
  EXPECT_EQ(relate(unit, Sphere3{{3, 4, 0x1p-30}, 4}), Relation::disjoint);
  EXPECT_EQ(relate(unit, Sphere3{{3, 4, 0}, std::nextafter(4, 5)}), Relation::overlapping);
  EXPECT_EQ(relate(unit, Sphere3{{1, 0, 0}, 0}), Relation::touching);
  EXPECT_EQ(relate(unit, Sphere3{{0.5, 0, 0}, 0}), Relation::overlapping);
  const Sphere3 point{{2, 2, 2}, 0};
  EXPECT_EQ(relate(point, point), Relation::overlapping);
  EXPECT_TRUE(contains(point, point));
  EXPECT_TRUE(contains(unit, Sphere3{{0.5, 0, 0}, 0.5}));
  EXPECT_FALSE(contains(unit, Sphere3{{0.5, 0x1p-300, 0}, 0.5}));
}

/// Is `ball` around the part, in rationals?
template <class Ball>
bool is_around(const Ball& ball, const Ball& part) {
  return distance_against(ball, part, mpq_class(ball.radius) - mpq_class(part.radius)) <= 0;
}

template <class Ball>
void expect_merged(std::uint64_t start) {
  int held = 0, beyond = 0, cases = 0;
  on_shapes(start, 15000, [&](Material& m) {
    const Ball a = m.shape<Ball>(), b = neighbor(m, a);
    const std::vector<Ball> all{a, b, m.shape<Ball>(), m.shape<Ball>()};
    const std::string about = m.about(a, b);
    ++cases;
    try {
      const Ball both = merge(a, b);
      EXPECT_EQ(merge(b, a), both) << about;
      EXPECT_TRUE(is_around(both, a) && is_around(both, b)) << about;
      if (contains(a, b) || contains(b, a)) {
        EXPECT_TRUE(both == a || both == b) << about;
        ++held;
        return;
      }
      // Twice its radius against distance + radii, with room for the roundings of the center.
      double size = both.radius;
      for (const double x : coordinates(both.center)) size = std::fmax(size, std::fabs(x));
      const mpq_class spare = mpq_class(size) * mpq_class(0x1p-48) + mpq_class(0x1p-1070);
      EXPECT_GE(
          distance_against(a, b, 2 * (mpq_class(both.radius) - spare) - mpq_class(a.radius) - mpq_class(b.radius)), 0)
          << about;
      const auto p = a.center;
      EXPECT_TRUE(is_around(merge(b, p), b) && is_around(merge(b, p), Ball{p, 0})) << about;
      const Ball around = merge(std::span<const Ball>(all));
      for (const Ball& part : all) EXPECT_TRUE(is_around(around, part)) << about;
    } catch (const BeyondDoubles&) {
      ++beyond;
      double size = 0;
      for (const Ball& ball : all)
        for (const double x : coordinates(ball.center)) size = std::max({size, std::fabs(x), ball.radius});
      EXPECT_GT(size, 0x1p1000) << about;
    }
  });
  EXPECT_GT(held, cases / 20);
  EXPECT_LT(held, cases * 3 / 4);
  EXPECT_LT(beyond, cases / 10);
}

TEST(Sphere, MergesAroundBoth) { expect_merged<Sphere3>(73); }
TEST(Circle, MergesAroundBoth) { expect_merged<Circle2>(74); }

TEST(Sphere, MergesExactlyWhereDoublesCan) {
  EXPECT_EQ(merge(Sphere3{{0, 0, 0}, 1}, Sphere3{{4, 0, 0}, 1}), (Sphere3{{2, 0, 0}, 3}));
  EXPECT_EQ(merge(Sphere3{{0, 0, 0}, 2}, Sphere3{{6, 8, 0}, 2}), (Sphere3{{3, 4, 0}, 7}));
  EXPECT_EQ(merge(Circle2{{0, 0}, 1}, Point2{0, 3}), (Circle2{{0, 1}, 2}));
  EXPECT_EQ(merge(Sphere3{{-largest, 0, 0}, 0}, Sphere3{{largest, 0, 0}, 0}), (Sphere3{{0, 0, 0}, largest}));
}

/// Has the symmetric matrix no negative eigenvalue?  By symmetric elimination.
bool is_not_negative(std::vector<Rationals> a) {
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k][k] < 0) return false;
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      if (a[k][k] == 0) {
        if (a[i][k] != 0) return false;
        continue;
      }
      const mpq_class factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < a.size(); ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return true;
}

/// Does the matrix of these columns stretch nothing by more than s?
bool stretches_at_most(const std::vector<Rationals>& columns, const mpq_class& s) {
  std::vector<Rationals> rest(columns.size(), Rationals(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      rest[i][j] = i == j ? s * s : mpq_class(0);
      for (std::size_t a = 0; a < columns[i].size(); ++a) rest[i][j] -= columns[i][a] * columns[j][a];
    }
  }
  return is_not_negative(rest);
}

template <class Ball, class By>
void expect_transformed(const Ball& ball, const By& pose, const std::string& about, int& beyond) {
  std::vector<Rationals> columns;
  for (const auto& column : pose.columns) columns.push_back(rationals(column));
  try {
    const double s = largest_stretch(pose);
    EXPECT_TRUE(stretches_at_most(columns, mpq_class(s))) << about;
    if (s > 0x1p-1000) {
      EXPECT_FALSE(stretches_at_most(columns, mpq_class(s) * mpq_class(1 - 0x1p-46))) << about;
    }
    const Ball image = transform(ball, pose);
    Rationals center = rationals(pose.translation);
    for (std::size_t a = 0; a < center.size(); ++a) {
      for (std::size_t j = 0; j < center.size(); ++j) center[a] += columns[j][a] * rationals(ball.center)[j];
      EXPECT_TRUE(is_nearest(coordinates(image.center)[a], center[a])) << about;
    }
    const mpq_class rest = mpq_class(image.radius) - mpq_class(s) * mpq_class(ball.radius);
    EXPECT_GE(rest, 0) << about;
    EXPECT_GE(rest * rest, squared_distance(center, rationals(image.center))) << about;
  } catch (const BeyondDoubles&) {
    ++beyond;
  }
}

TEST(Sphere, TransformsAroundTheImage) {
  int beyond = 0;
  on_shapes(75, 4000, [&](Material& m) {
    const auto ball = m.shape<Sphere3>();
    const Pose pose{{m.direction3(), m.direction3(), m.direction3()}, m.vector3()};
    expect_transformed(ball, pose, m.about(ball, pose), beyond);
    const auto circle = m.shape<Circle2>();
    const Pose2 flat{{m.direction2(), m.direction2()}, m.vector2()};
    expect_transformed(circle, flat, m.about(circle, flat), beyond);
  });
  EXPECT_LT(static_cast<std::uint64_t>(beyond), 2000 * shape_cases::more);
}

TEST(Sphere, KeepsItsRadiusUnderRigidMotion) {
  const Sphere3 ball{{1, 2, 3}, 4};
  const Pose turned{{Vector3{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}, {10, 0, 0}};
  EXPECT_EQ(transform(ball, turned), (Sphere3{{7, 1, -2}, 4}));
  EXPECT_EQ(transform(Sphere3{{0, 0, 0}, 2}, Pose{{Vector3{1, 0, 0}, {0, 3, 0}, {0, 0, -5}}, {}}).radius, 10);
  Entropy entropy(76);
  for (int i = 0; i < 200; ++i) {  // rotations in doubles are nearly orthonormal: so is the stretch
    const double a = unit_coordinate(entropy) * 6, c = std::cos(a), s = std::sin(a);
    const double stretch = largest_stretch(Pose{{Vector3{c, s, 0}, {-s, c, 0}, {0, 0, 1}}, {}});
    EXPECT_NEAR(stretch, 1, 0x1p-50);
    EXPECT_GE(stretch, 1);
  }
}

TEST(Sphere, RefusesWhatIsNoBall) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere3 unit{{0, 0, 0}, 1}, negative{{0, 0, 0}, -1}, bad{{0, nan, 0}, 1}, vague{{0, 0, 0}, nan};
  EXPECT_THAT(text_of<InvalidShape>([&] { relate(unit, negative); }), StartsWith("relate: b.radius is negative"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                intersects(Sphere3{{9, 9, 9}, -20}, unit);
              }),
              StartsWith("intersects: a.radius is negative"));
  EXPECT_THAT(text_of<NonFinite>([&] { intersects(unit, bad); }), StartsWith("intersects: b.center.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { relate(vague, unit); }), StartsWith("relate: a.radius is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { contains(unit, vague); }), StartsWith("contains: inner.radius is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { merge(unit, Point3{0, HUGE_VAL, 0}); }), StartsWith("merge: p.y is inf"));
  EXPECT_THAT(text_of<InvalidShape>([&] { merge(std::span<const Sphere3>()); }), StartsWith("merge: no spheres"));
  const std::vector<Circle2> circles{{{0, 0}, 1}, {{0, 0}, -1}};
  EXPECT_THAT(text_of<InvalidShape>([&] { merge(std::span<const Circle2>(circles)); }),
              StartsWith("merge: circles[1].radius is negative"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                transform(unit, Pose{{Vector3{1, 0, 0}, {0, nan, 0}, {0, 0, 1}}, {}});
              }),
              StartsWith("transform: pose.columns[1].y is nan"));
  EXPECT_THROW(merge(Sphere3{{-largest, 0, 0}, largest}, Sphere3{{largest, 0, 0}, largest}), BeyondDoubles);
  EXPECT_THROW(transform(unit, Pose{{Vector3{largest, largest, 0}, {0, 1, 0}, {0, 0, 1}}, {}}), BeyondDoubles);
}

TEST(Sphere, AReachBeyondDoublesIsNotSure) {
  const double u = 0x1p459, far = (0x1p511 - u / 2) * 2;  // 2^512 - u
  const Sphere3 a{{0, 0, 0}, far}, b{{far, 0x1.8p485, 0x1p485 * (1 - 0x1p-53)}, 0.75 * u};
  const auto scaled = [](const Sphere3& s) {
    const double k = 0x1p-400;
    return Sphere3{{s.center.x * k, s.center.y * k, s.center.z * k}, s.radius * k};
  };
  EXPECT_EQ(relate(a, b), relate(scaled(a), scaled(b)));
  EXPECT_EQ(relate(a, b), Relation::disjoint);
}

// What doubles leave to integers: of balls at random next to none, and those that touch up to ulps.
TEST(Sphere, DoublesLeaveTouchingBallsAlone) {
  int unsure = 0, unsure_touching = 0;
  constexpr int cases = 2000;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(75, i);
    const auto at = [&] { return signed_unit_coordinate(entropy); };
    const Sphere3 a{{at(), at(), at()}, unit_coordinate(entropy)}, b{{at(), at(), at()}, unit_coordinate(entropy)};
    unsure += figure::sphere::gap(a, b).sure ? 0 : 1;
    const double apart = std::hypot(b.center.x - a.center.x, b.center.y - a.center.y, b.center.z - a.center.z);
    const Sphere3 near{a.center, moved_by_ulps(apart * 0.5, entropy.within(1))}, other{b.center, apart * 0.5};
    unsure_touching += figure::sphere::gap(near, other).sure ? 0 : 1;
  }
  EXPECT_LE(unsure, 1);
  EXPECT_GE(unsure_touching, cases * 99 / 100);
}

/// The gap of two balls, two coordinates a difference, then both radii.
template <int axes>
struct Gap {
  static constexpr std::string_view name = axes == 2 ? "balls2" : "balls3";
  static constexpr int points = axes + 1, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 2 * points>& p) const {
    const auto squared = [](const auto& x) { return x * x; };
    const auto flat = squared(p[0] - p[1]) + squared(p[2] - p[3]);
    const auto reach = squared(p[2 * axes] + p[2 * axes + 1]);
    if constexpr (axes == 2) {
      return flat - reach;
    } else {
      return (flat + squared(p[4] - p[5])) - reach;
    }
  }
};
/// Two balls by the numbers that a gap takes.
template <int axes>
auto balls_of(const std::array<double, 2 * axes + 2>& p) {
  if constexpr (axes == 2) {
    return std::pair{Circle2{{p[0], p[2]}, p[4]}, Circle2{{p[1], p[3]}, p[5]}};
  } else {
    return std::pair{Sphere3{{p[0], p[2], p[4]}, p[6]}, Sphere3{{p[1], p[3], p[5]}, p[7]}};
  }
}
template <int axes>
std::string unnoticed_of_gaps() {
  using Numbers = std::array<double, 2 * axes + 2>;
  return mutants::unnoticed(
      [](mutants::Draw& d) {
        Numbers x{};
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = i < 2 * axes ? d.number() : d.positive();
        return x;
      },
      []<std::size_t... k>(std::index_sequence<k...>) {
        return [](const Numbers& x) { return std::optional(Gap<axes>{}(std::array{mutants::Number(x[k])...}).sign()); };
      }(std::make_index_sequence<2 * axes + 2>{}),
      [](const Numbers& x) {
        const auto [a, b] = balls_of<axes>(x);
        const Relation relation = relate(a, b);
        return relation == Relation::disjoint   ? Sign::positive
               : relation == Relation::touching ? Sign::zero
                                                : Sign::negative;
      },
      0, 2000);
}
TEST(Sphere, MutantsOfGapsAreNoticed) {
  mutants::expect_noticed("balls2", unnoticed_of_gaps<2>());
  mutants::expect_noticed("balls3", unnoticed_of_gaps<3>());
}

template <int axes>
void count_told(PromisedShare& share) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(400); ++i) {
      Entropy entropy(77, i);
      std::array<double, 12> x{};
      fill_points(info.family, Degeneracy::collinear, 3, x, entropy);
      std::array<double, 2 * axes + 2> p{};
      for (std::size_t k = 0; k < p.size(); ++k) p[k] = k < 2 * axes ? x[k] : std::fabs(x[k]);
      const auto [a, b] = balls_of<axes>(p);
      const auto gap = figure::sphere::gap(a, b);
      share.add(info.family, gap.sure);
    }
  }
}
TEST(Sphere, DoublesTellGapsInPromisedShare) {
  PromisedShare in_the_plane("balls2"), in_space("balls3");
  count_told<2>(in_the_plane);
  count_told<3>(in_space);
}

TEST(Sphere, ConstantsDoNotChangeUnnoticedAndAreProved) {
  using namespace figure::sphere;
  const auto expect = [](const auto& formula, const auto& a, const auto& b) {
    using F = std::decay_t<decltype(formula)>;
    constexpr auto e = std::decay_t<decltype(a)>::error, f = std::decay_t<decltype(b)>::error;
    constexpr double part = arith::squares::doubtful_part<e, f>;
    std::array<char, 64> line{};
    std::snprintf(line.data(), line.size(), "%a %a", part, arith::squares::doubtful_guard<e, f>);
    expect_golden(std::string(F::name), {line.data()});
    if (!gappa::is_installed() || battery::sanitized) return;
    const auto script = [](double constant) {
      return proof_script(F::name, certify::tape::program<F>(), constant, ProofScale::every);
    };
    EXPECT_EQ(gappa::prove(script(part)).code, 0) << script(part);
    EXPECT_TRUE(gappa::refuses(script(part * 0.9))) << F::name;
  };
  expect(Gap<2>{}, square_of_distance(Point2{}, Point2{}), square_of_reach(0, 0));
  expect(Gap<3>{}, square_of_distance(Point3{}, Point3{}), square_of_reach(0, 0));
}

}  // namespace
}  // namespace plumb
