// Nearest feasible points and greatest margins: their proofs, and false ones; whether there are any, by linear programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/query/lp/greatest_margin.hpp"
#include "plumb/query/lp/nearest_feasible.hpp"
#include "plumb/query/lp/simplex.hpp"
#include "plumb/query/lp/verify.hpp"
#include "query/lp/linear_cases.hpp"

namespace plumb::linear_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

inline Point2 point_of(const Vector2& v) { return {v.x, v.y}; }
inline Point3 point_of(const Vector3& v) { return {v.x, v.y, v.z}; }
inline std::vector<Rational> rationals_of(const Vector2& v) { return {v.x, v.y}; }
inline std::vector<Rational> rationals_of(const Vector3& v) { return {v.x, v.y, v.z}; }

template <std::size_t D>
void expect_nearest(Class c, std::array<int, 5>& counts) {
  for (std::uint64_t index = 0; index < (battery::sanitized ? 25 : 150); ++index) {
    Maker maker(c, index);
    const Program<D> p = maker.program<D>();
    const LinearSystem system = linear_system(p.halfspaces);
    const std::vector<Rational> from = rationals_of(p.direction);
    const auto nearest = nearest_feasible(point_of(p.direction), p.halfspaces);
    EXPECT_EQ(nearest.kind, maximize(typename Types<D>::Vector{}, p.halfspaces).kind) << maker.about(p);
    EXPECT_TRUE(verify_nearest(from, system, nearest.proof)) << maker.about(p);
    if (nearest.kind == LinearKind::infeasible) {
      ++counts[4];
      continue;
    }
    EXPECT_LE(nearest.proof.weights.size(), D) << maker.about(p);
    ++counts[nearest.proof.weights.size()];
    EXPECT_EQ(compare(nearest.exact_distance, 0.0) == Sign::zero, nearest.proof.weights.empty()) << maker.about(p);
    LinearProof mutant = nearest.proof;
    mutant.point[0] = mutant.point[0] + Rational(0x1p-1074);
    EXPECT_FALSE(verify_nearest(from, system, mutant)) << maker.about(p);
    if (!nearest.proof.weights.empty()) {
      mutant = nearest.proof, mutant.weights[0].weight = mutant.weights[0].weight * Rational(2);
      EXPECT_FALSE(verify_nearest(from, system, mutant)) << maker.about(p);
      mutant = nearest.proof, mutant.point = from;
      EXPECT_FALSE(verify_nearest(from, system, mutant)) << maker.about(p);
    }
    mutant = nearest.proof, mutant.kind = LinearKind::unbounded;
    EXPECT_FALSE(verify_nearest(from, system, mutant)) << maker.about(p);
  }
}

TEST(NearestFeasible, HasTheProofOfKarushKuhnAndTucker) {
  std::array<int, 5> counts{};  // by active constraints; infeasible
  for (const Class c : all_classes) {
    expect_nearest<2>(c, counts);
    expect_nearest<3>(c, counts);
  }
  for (const int n : counts) EXPECT_GT(n, battery::sanitized ? 3 : 30);
}

TEST(NearestFeasible, OfACorner) {
  const std::vector<Halfspace3> corner{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 2}, 0}, {{1, 1, 1}, 5}};
  const NearestFeasible3 n = nearest_feasible(Point3{3, 4, 12}, corner);
  EXPECT_EQ(n.at, (Point3{0, 0, 0}));
  EXPECT_EQ(n.distance, 13);
  const std::vector<LinearWeight> weights = n.proof.weights;
  EXPECT_EQ(weights.size(), 3u);
  EXPECT_EQ(nearest_feasible(Point3{-1, 4, -2}, corner).at, (Point3{-1, 0, -2}));
  EXPECT_EQ(nearest_feasible(Point3{-1, -4, -2}, corner).distance, 0);
  const std::vector<Halfspace2> line{{{1, 2}, 3}, {{-1, -2}, -3}};
  EXPECT_EQ(nearest_feasible(Point2{0, 0}, line).at, (Point2{0.6, 1.2}));
  EXPECT_EQ(nearest_feasible(Point2{1, 1}, line).distance, 0);
  EXPECT_EQ(nearest_feasible(Point2{5, 7}, std::span<const Halfspace2>{}).at, (Point2{5, 7}));
}

TEST(NearestFeasible, NumbersThatAreNoneThrow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Halfspace3> bad{{{1, 0, nan}, 1}};
  EXPECT_THAT([&] { (void)nearest_feasible(Point3{}, bad); },
              ThrowsMessage<NonFinite>(HasSubstr("nearest_feasible: constraints[0].normal.z is nan")));
  EXPECT_THAT(
      [&] {
        (void)nearest_feasible(Point3{0, nan, 0}, std::span<const Halfspace3>{});
      },
      ThrowsMessage<NonFinite>(HasSubstr("nearest_feasible: p.y is nan")));
}

std::vector<Point3> some_points(Entropy& entropy, std::int64_t most, double shift) {
  std::vector<Point3> r;
  const auto number = [&] { return static_cast<double>(entropy.within(most)); };
  for (std::size_t n = 1 + entropy.below(7); n > 0; --n) r.push_back({number() + shift, number(), number()});
  return r;
}

/// Do the hulls meet, as a system in the weights of the points?
bool hulls_meet(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  // A plane u . x = t with u . p <= t - 1 on a and u . p >= t + 1 on b: of four variables.
  LinearSystem s;
  for (const Point3& p : a) s.add({p.x, p.y, p.z, -1}, -1);
  for (const Point3& p : b) s.add({-p.x, -p.y, -p.z, 1}, -1);
  return maximize(std::vector<Rational>(4), s).kind == LinearKind::infeasible;
}

TEST(GreatestMargin, PartsWhatCanBeParted) {
  int parted = 0, met = 0, several = 0;
  for (std::uint64_t index = 0; index < (battery::sanitized ? 60 : 400); ++index) {
    Entropy entropy(9441, index);
    const std::int64_t most = 1 + static_cast<std::int64_t>(entropy.below(4));
    const std::vector<Point3> a = some_points(entropy, most, 0);
    const std::vector<Point3> b = some_points(entropy, most, static_cast<double>(entropy.below(6)));
    const auto m = greatest_margin(a, b);
    EXPECT_EQ(!m, hulls_meet(a, b)) << index;
    (m ? parted : met) += 1;
    if (!m) continue;
    EXPECT_TRUE(verify(a, b, *m)) << index;
    several += m->of_first.size() + m->of_second.size() > 2 ? 1 : 0;
    const auto back = greatest_margin(b, a);
    ASSERT_TRUE(back) << index;
    EXPECT_EQ(back->square, m->square) << index;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(back->direction[k], -m->direction[k]) << index;
    GreatestMargin3 mutant = *m;
    mutant.of_first[0].weight = mutant.of_first[0].weight + Rational(1);
    EXPECT_FALSE(verify(a, b, mutant)) << index;
    mutant = *m, mutant.square = mutant.square * Rational(2);
    EXPECT_FALSE(verify(a, b, mutant)) << index;
    mutant = *m, mutant.direction[0] = mutant.direction[0] + Rational(0x1p-60);
    EXPECT_FALSE(verify(a, b, mutant)) << index;
    mutant = *m, mutant.of_second[0].point = b.size();
    EXPECT_FALSE(verify(a, b, mutant)) << index;
    std::vector<Point3> nearer = a;
    nearer.push_back(b[0]);
    EXPECT_FALSE(verify(nearer, b, *m)) << index;
  }
  EXPECT_GT(parted, battery::sanitized ? 5 : 30);
  EXPECT_GT(met, battery::sanitized ? 5 : 30);
  EXPECT_GT(several, 10);
}

TEST(GreatestMargin, OfTwoCubes) {
  std::vector<Point3> a, b;
  for (const double x : {0.0, 1.0}) {
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) a.push_back({x, y, z}), b.push_back({x + 4, y, z + 0.5});
    }
  }
  const auto m = greatest_margin(a, b);
  ASSERT_TRUE(m);
  EXPECT_EQ(m->margin, 3);
  EXPECT_EQ(m->direction, (std::array<Rational, 3>{3, 0, 0}));
  EXPECT_EQ(m->first_end, Rational(3));
  EXPECT_EQ(m->second_end, Rational(12));
  EXPECT_FALSE(greatest_margin(a, a));
  EXPECT_FALSE(greatest_margin(a, std::vector<Point3>{{1, 0.5, 0.5}}));  // touching
  const double ulp = std::nextafter(1.0, 2.0);
  EXPECT_EQ(greatest_margin(a, std::vector<Point3>{{ulp, 0.5, 0.5}})->margin, ulp - 1);
  EXPECT_THAT([&] { (void)greatest_margin(a, {}); },
              ThrowsMessage<InvalidShape>(HasSubstr("greatest_margin: second has no points")));
  a[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { (void)greatest_margin(a, b); },
              ThrowsMessage<NonFinite>(HasSubstr("greatest_margin: first[2].y is inf")));
}

}  // namespace
}  // namespace plumb::linear_cases
