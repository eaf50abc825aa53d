// Which implicit points must every sign get right?  Cases for the tests of implicit points.
//
// Laws: the points of a case are made of few numbers, drawn from a pool, so that they share points: coincidences,
// parallel lines and points on planes are common in every family.  Case `index` of a family is the same everywhere.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "certify/sanitized.hpp"
#include "oracle/constructed.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/certify/implicit.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates.hpp"

namespace plumb::implicit_cases {

using oracle::Construction;
using oracle::Question;

template <class Point>
inline constexpr Construction construction_of = Construction::explicit2;
template <>
inline constexpr Construction construction_of<LineLinePoint2> = Construction::line_line2;
template <>
inline constexpr Construction construction_of<SegmentPoint2> = Construction::segment2;
template <>
inline constexpr Construction construction_of<Posed<Point2, Pose2>> = Construction::posed2;
template <>
inline constexpr Construction construction_of<Point3> = Construction::explicit3;
template <>
inline constexpr Construction construction_of<LinePlanePoint3> = Construction::line_plane3;
template <>
inline constexpr Construction construction_of<ThreePlanePoint3> = Construction::three_plane3;
template <>
inline constexpr Construction construction_of<SegmentPoint3> = Construction::segment3;
template <>
inline constexpr Construction construction_of<Posed<Point3>> = Construction::posed3;

template <class Point>
oracle::Constructed constructed(const Point& p) {
  const auto numbers = coordinates(p);
  return {construction_of<Point>, {numbers.begin(), numbers.end()}};
}

/// Small integers, or a family of hard inputs.
struct Numbers {
  bool small = true;
  Family family = Family::grid;
  [[nodiscard]] std::string name() const { return small ? "small" : std::string(name_of(family)); }
};

/// Makes points of every kind from a pool of points and poses.
class Pool {
 public:
  Pool(Numbers numbers, int dimension, Entropy& entropy) : entropy_(entropy), numbers_(numbers) {
    const std::size_t count = static_cast<std::size_t>(dimension) * (3 + entropy.below(4));
    pool_.resize(count * static_cast<std::size_t>(dimension));
    if (numbers.small) {
      for (double& x : pool_) x = static_cast<double>(entropy.within(3));
    } else {
      fill_points(numbers.family, degeneracies[entropy.below(degeneracies.size())], dimension, pool_, entropy);
    }
    for (double& t : parameters_) t = parameter();
    for (Pose2& pose : poses2_) pose = {{column2(0), column2(1)}, {number(), number()}};
    for (Pose& pose : poses3_) pose = {{column3(0), column3(1), column3(2)}, {number(), number(), number()}};
  }

  void make(Point2& p) { p = {any(2, 0), any(2, 1)}; }
  void make(Point3& p) { p = {any(3, 0), any(3, 1), any(3, 2)}; }
  void make(LineLinePoint2& p) { make_each(p.a, p.b, p.c, p.d); }
  void make(LinePlanePoint3& p) { make_each(p.p, p.q, p.a, p.b, p.c); }
  void make(ThreePlanePoint3& p) {
    for (auto* plane : {&p.first, &p.second, &p.third}) make_each((*plane)[0], (*plane)[1], (*plane)[2]);
  }
  void make(SegmentPoint2& p) {
    make_each(p.a, p.b);
    p.t = parameters_[entropy_.below(2)];
  }
  void make(SegmentPoint3& p) {
    make_each(p.a, p.b);
    p.t = parameters_[entropy_.below(2)];
  }
  void make(Posed<Point2, Pose2>& p) {
    make(p.shape);
    p.pose = poses2_[entropy_.below(2)];
  }
  void make(Posed<Point3>& p) {
    make(p.shape);
    p.pose = poses3_[entropy_.below(2)];
  }

 private:
  template <class... Points>
  void make_each(Points&... points) {
    (make(points), ...);
  }
  // A coordinate of a random point of the pool; the first axis chooses the point.
  double any(std::size_t dimension, std::size_t axis) {
    const std::size_t count = pool_.size() / dimension;
    // Seldom the point before: most constructions are to have a point.
    if (axis == 0) chosen_ = (chosen_ + 1 + entropy_.below(count - 1) + (entropy_.below(8) == 0 ? 1 : 0)) % count;
    return pool_[chosen_ * dimension + axis];
  }
  double number() { return pool_[entropy_.below(pool_.size())]; }
  double parameter() {
    constexpr std::array simple{0.0, 1.0, 0.5, -1.0, 2.0, 0.75};
    return numbers_.small || entropy_.coin() ? simple[entropy_.below(simple.size())] : number();
  }
  double entry(bool diagonal) {
    const double simple = diagonal ? 1 : 0;
    return entropy_.below(4) != 0 ? simple : number();
  }
  Vector2 column2(int i) { return {entry(i == 0), entry(i == 1)}; }
  Vector3 column3(int i) { return {entry(i == 0), entry(i == 1), entry(i == 2)}; }

  Entropy& entropy_;
  Numbers numbers_;
  std::vector<double> pool_;
  std::size_t chosen_ = 0;
  std::array<double, 2> parameters_{};
  std::array<Pose2, 2> poses2_{};
  std::array<Pose, 2> poses3_{};
};

/// How often a case ended how.
struct Tally {
  int cases = 0, degenerate = 0, negative = 0, zero = 0, positive = 0;

  void add(std::optional<Sign> sign) {
    ++cases;
    ++(!sign ? degenerate : *sign == Sign::zero ? zero : *sign == Sign::positive ? positive : negative);
  }
};

/// The library's answer; nothing where it calls a construction degenerate.
template <class Ask, class... Points>
std::optional<Sign> answer(Ask ask, const Points&... points) {
  try {
    return ask(points...);
  } catch (const DegeneratePoint&) {
    return {};
  }
}

/// A case as the judges are told of it, and what the library said.
struct Asked {
  std::vector<oracle::Constructed> told;
  std::optional<Sign> said;
};
/// All that is compiled for every mix of kinds.
template <class Ask, class... Points>
Asked asked(Numbers numbers, std::uint64_t index) {
  Entropy entropy(sizeof...(Points), index);
  Pool pool(numbers, std::array{KindOf<Points>::dimension...}[0], entropy);
  std::tuple<Points...> points;
  return std::apply(
      [&](auto&... p) -> Asked {
        (pool.make(p), ...);
        return {{constructed(p)...}, answer(Ask{}, p...)};
      },
      points);
}
using CaseOf = Asked (*)(Numbers, std::uint64_t);

/// Cases 0 ... count - 1 of a mix of kinds against the judges, the slower of which sees every fifth.
inline Tally check(Question question, CaseOf asked, Numbers numbers, std::uint64_t count) {
  Tally tally;
  for (std::uint64_t index = 0; index < count && !testing::Test::HasFailure(); ++index) {
    const auto [told, said] = asked(numbers, index);
    const std::optional<Sign> exact = oracle::rational_sign(question, told);
    EXPECT_EQ(said, exact) << numbers.name() << " case " << index;
    if (index % 5 == 0) {
      EXPECT_EQ(oracle::cgal_sign(question, told), exact) << numbers.name() << " case " << index;
    }
    tally.add(exact);
  }
  return tally;
}

template <class Point>
inline constexpr bool may_degenerate = predicates::has_weight<KindOf<Point>>;

/// All families, and small numbers, which must hold a fair share of every sign.
inline void check_all(Question question, CaseOf asked, bool may_be_degenerate, std::uint64_t cases) {
  const Tally small = check(question, asked, {}, cases);
  const int sound = small.cases - small.degenerate;
  SCOPED_TRACE(testing::Message() << "of " << small.cases << ": degenerate " << small.degenerate << ", negative "
                                  << small.negative << ", zero " << small.zero << ", positive " << small.positive);
  EXPECT_GT(sound * 50, small.cases);
  if (battery::reaches_rare) {
    EXPECT_GT(small.zero * 100, sound);
  }
  EXPECT_GT(small.positive * 5, sound);
  EXPECT_GT(small.negative * 5, sound);
  EXPECT_EQ(small.degenerate * 10 > small.cases, may_be_degenerate);
  for (const FamilyInfo& info : families) check(question, asked, {false, info.family}, cases / 25);
}
template <class... Points, class Ask>
void check_all(Question question, Ask, std::uint64_t cases) {
  if (testing::Test::HasFailure()) return;
  SCOPED_TRACE(__PRETTY_FUNCTION__);
  check_all(question, asked<Ask, Points...>, (may_degenerate<Points> || ...), cases);
}

}  // namespace plumb::implicit_cases
