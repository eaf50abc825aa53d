// Are the numbers that judge straight motion as near to those of real arithmetic as their types say, are mistakes
// noticed, and how much is left to slower numbers?
#include "query/time_of_impact/motion_directions.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "query/time_of_impact/balls_in_motion.hpp"
#include "query/time_of_impact/quick_search.hpp"
#include "query/time_of_impact/translating_cases.hpp"

namespace plumb::query::quick {
namespace {

using translating_cases::Draw, translating_cases::Numbers;

/// What a mutant has wrong.
enum class Mistake { none, motion, place, order, radius };

struct Tally {
  int numbers = 0, beyond = 0, signs = 0, false_signs = 0;

  template <class W, class N>
  void take(const W& w, const N& x, const Rational& exact) {
    Rational m = Rational(static_cast<double>(N::track.error)) * Rational(0x1p-85);
    Rational off = magnitude(Rational(x.value) - exact);
    const auto raise = [&](const Rational& scale, int power) {
      for (int i = 0; i < power; ++i) m = m * scale;
    };
    if constexpr (requires { w.template square_of_scale<0>(); }) {  // of roots both squared; the squares are rounded
      m = m * m * Rational(1 + 0x1p-40), off = off * off;
      raise(Rational(w.template square_of_scale<0>()), N::track.power(0, 0));
      raise(Rational(w.template square_of_scale<1>()), N::track.power(1, 0));
      raise(Rational(w.template square_of_scale<2>()), N::track.power(2, 0));
    } else {
      raise(Rational(w.template scale<0>()), N::track.power(0, 0));
      raise(Rational(w.template scale<1>()), N::track.power(1, 0));
      if constexpr (N::track.power(2, 0) != 0) raise(Rational(w.template scale<2>()), N::track.power(2, 0));
    }
    ++numbers;
    beyond += m < off ? 1 : 0;
    const bool positive = w.positive(x), negative = w.negative(x);
    signs += positive || negative ? 1 : 0;
    false_signs += (positive && exact.sign() != Sign::positive) || (negative && exact.sign() != Sign::negative) ? 1 : 0;
  }
};

Vec3<Rational> exactly(const Vec3<double>& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }
Vec3<Rational> back(const Vec3<Rational>& v) { return {negated(v.x), negated(v.y), negated(v.z)}; }

template <Mistake mistake>
auto with_mistake(const auto& exact) {
  KnownMotion m{exact.a, exact.b, exact.by, exact.apart, exact.reach};
  if constexpr (mistake == Mistake::order) {
    return KnownMotion{exact.b, exact.a, exact.by, exact.apart, exact.reach};
  } else {
    if constexpr (mistake == Mistake::motion) m.by = back(m.by);
    if constexpr (mistake == Mistake::place) m.apart = back(m.apart);
    if constexpr (mistake == Mistake::radius) m.reach = m.reach + m.reach;
    return m;
  }
}

template <class S>
Translating<S> drawn(Entropy& entropy, Numbers numbers) {
  Translating<S> t;
  Draw draw(entropy, numbers);
  draw.fill(t.shape);
  t.by = draw.motion();
  return t;
}
constexpr std::array kinds{Numbers::noisy, Numbers::ulps, Numbers::wide};

template <Mistake mistake, class A, class B>
void compare(Tally& tally, int count) {
  for (int i = 0; i < count; ++i) {
    Entropy entropy(2041, static_cast<std::uint64_t>(i));
    const Numbers numbers = kinds[static_cast<std::size_t>(i) % kinds.size()];
    const Translating<A> a = drawn<A>(entropy, numbers);
    const Translating<B> b = drawn<B>(entropy, numbers);
    const MotionSearch<A, B> search(a, b);
    const Moved<Rational, A, B> exact(a, b);
    const auto motion = known_motion(search);
    const auto truth = with_mistake<mistake>(exact);
    const auto along = [&](const auto& w, const auto& n, const Vec3<Rational>& exact_n) {
      if (!w.certain()) return;
      const auto [low, high] = reaches_along(n, motion);
      const auto [exact_low, exact_high] = reaches_along(exact_n, truth);
      tally.take(w, low, exact_low), tally.take(w, high, exact_high);
      tally.take(w, inner(n, motion.by), inner(exact_n, truth.by));
      if constexpr (std::remove_cvref_t<decltype(n.x)>::track.power(2, 0) == 0) {
        const auto limit = motion.reach * motion.reach * inner(n, n);
        tally.take(w, low * low - limit, exact_low * exact_low - truth.reach * truth.reach * inner(exact_n, exact_n));
      }
    };
    MotionWorld<> of_given;
    of_given.number<0>(search.size), of_given.number<1>(largest_of(search.between_them));
    along(of_given, given<1>(search.between_them), exactly(search.between_them));
    if constexpr (MotionSearch<A, B>::HullA::way_count > 0) {
      MotionWorld<> of_ways;
      const Vec3<double>&x = search.a.way(0), &y = search.b.way(1);
      of_ways.number<0>(search.size), of_ways.number<1>(largest_of(x)), of_ways.number<2>(largest_of(y));
      along(of_ways, outer(known<1>(x), known<2>(y)), outer(exact.a.way(0), exact.b.way(1)));
    }
  }
}
template <Mistake mistake>
Tally tally_of(int count) {
  Tally tally;
  compare<mistake, Obb3, Triangle3>(tally, count), compare<mistake, Capsule3, Aabb3>(tally, count);
  compare<mistake, Sphere3, Obb3>(tally, count);
  return tally;
}

template <Mistake mistake>
void compare_balls(Tally& tally, int count) {
  for (int i = 0; i < count; ++i) {
    Entropy entropy(2042, static_cast<std::uint64_t>(i));
    const Numbers numbers = kinds[static_cast<std::size_t>(i) % kinds.size()];
    const auto a = drawn<Sphere3>(entropy, numbers), b = drawn<Sphere3>(entropy, numbers);
    BallsWorld<> w;
    RationalWorld rationals;
    const BallsInMotion<BallsWorld<>> computed(w, a.shape.center, b.shape.center, a.shape.radius, b.shape.radius, a.by,
                                               b.by);
    const bool turned = mistake == Mistake::motion, swapped = mistake == Mistake::place;
    const BallsInMotion<RationalWorld> exact(
        rationals, swapped ? b.shape.center : a.shape.center, swapped ? a.shape.center : b.shape.center, a.shape.radius,
        mistake == Mistake::radius ? 0 : b.shape.radius, turned ? b.by : a.by, turned ? a.by : b.by);
    if (!w.certain()) continue;
    tally.take(w, computed.c(), exact.c()), tally.take(w, computed.h(), exact.h()),
        tally.take(w, computed.e(), exact.e());
    tally.take(w, computed.value_at_end(), exact.value_at_end());
    tally.take(w, computed.slope_at_end(), exact.slope_at_end());
    tally.take(w, computed.discriminant(), exact.discriminant());
  }
}

void expect_sound(const Tally& tally, double signs) {
  std::cout << tally.signs << " signs of " << tally.numbers << '\n';
  EXPECT_EQ(tally.beyond, 0);
  EXPECT_EQ(tally.false_signs, 0);
  EXPECT_GT(tally.signs, signs * tally.numbers);
}
void expect_noticed(const char* name, const Tally& tally) {
  std::cout << name << ": " << tally.beyond << " of " << tally.numbers << " beyond, " << tally.false_signs
            << " false signs\n";
  EXPECT_GT(tally.beyond, 0) << name;
  EXPECT_GT(tally.false_signs, 0) << name;
}

TEST(MotionDirections, NumbersAreWithinTheirDerivedErrors) { expect_sound(tally_of<Mistake::none>(60), 0.8); }
TEST(MotionDirections, BallsAreWithinTheirDerivedErrors) {
  Tally tally;
  compare_balls<Mistake::none>(tally, 150);
  expect_sound(tally, 0.8);
}
TEST(MotionDirections, MutantsAreNoticed) {
  expect_noticed("the motion turned back", tally_of<Mistake::motion>(9));
  expect_noticed("the place mirrored", tally_of<Mistake::place>(9));
  expect_noticed("the hulls exchanged", tally_of<Mistake::order>(9));
  expect_noticed("the reach doubled", tally_of<Mistake::radius>(9));
  Tally turned, swapped, pointed;
  compare_balls<Mistake::motion>(turned, 15), compare_balls<Mistake::place>(swapped, 15);
  compare_balls<Mistake::radius>(pointed, 15);
  expect_noticed("a ball's motion exchanged", turned);
  expect_noticed("the balls' places exchanged", swapped);
  expect_noticed("a ball's radius", pointed);
}

/// Two balls that move, by 14 numbers.
struct Balls {
  Sphere3 a, b;
  Vector3 by_a, by_b;

  explicit Balls(const double* x)
      : a{{x[0], x[1], x[2]}, std::fabs(x[12])},
        b{{x[3], x[4], x[5]}, std::fabs(x[13])},
        by_a{x[6], x[7], x[8]},
        by_b{x[9], x[10], x[11]} {}
  template <class W>
  [[nodiscard]] BallsInMotion<W> in(W& w) const {
    return {w, a.center, b.center, a.radius, b.radius, by_a, by_b};
  }
};

TEST(MotionDirections, DoublesTellOfBallsInPromisedShare) {
  PromisedShare start("balls_start"), end("balls_end"), slope("balls_slope"), discriminant("balls_discriminant");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(300); ++i) {
      Entropy entropy(2044, i);
      std::array<double, 15> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      BallsWorld<> w;
      const auto balls = Balls(x.data()).in(w);
      const auto add = [&](PromisedShare& share, const auto& n) {
        share.add(info.family, w.certain() && (w.positive(n) || w.negative(n)));
      };
      add(start, balls.c()), add(end, balls.value_at_end());
      add(slope, balls.slope_at_end()), add(discriminant, balls.discriminant());
    }
  }
}

Sign sign_of(double x) { return static_cast<Sign>((x > 0) - (x < 0)); }
using arith::Plain;

std::string unnoticed_of_balls(const auto& number, const auto& truth) {
  return mutants::unnoticed(
      [](mutants::Draw& d) {
        std::array<double, 14> x{};
        for (double& one : x) one = d.number();
        return Balls(x.data());
      },
      [&](const Balls& b) {
        mutants::World w;
        return std::optional(number(b.in(w)).sign());
      },
      [&](const Balls& b) {
        const Plain d =
            Plain{b.a.center.x, b.a.center.y, b.a.center.z} - Plain{b.b.center.x, b.b.center.y, b.b.center.z};
        const Plain by{b.by_a.x - b.by_b.x, b.by_a.y - b.by_b.y, b.by_a.z - b.by_b.z};
        return sign_of(truth(d, by, b.a.radius + b.b.radius));
      },
      0, 3000);
}
TEST(MotionDirections, MutantsOfBallsAreNoticed) {
  using mutants::expect_noticed;
  expect_noticed("balls_start",
                 unnoticed_of_balls([](const auto& b) { return b.c(); },
                                    [](const Plain& d, const Plain&, double r) { return dot(d, d) - r * r; }),
                 "3 4 5 ");  // the motion has no part in it
  expect_noticed("balls_end", unnoticed_of_balls([](const auto& b) { return b.value_at_end(); },
                                                 [](const Plain& d, const Plain& by, double r) {
                                                   return dot(d + by, d + by) - r * r;
                                                 }));
  expect_noticed("balls_slope",
                 unnoticed_of_balls([](const auto& b) { return b.slope_at_end(); },
                                    [](const Plain& d, const Plain& by, double) { return dot(d + by, by); }));
  expect_noticed("balls_discriminant", unnoticed_of_balls([](const auto& b) { return b.discriminant(); },
                                                          [](const Plain& d, const Plain& by, double r) {
                                                            return dot(d, by) * dot(d, by) -
                                                                   dot(by, by) * (dot(d, d) - r * r);
                                                          }));
}

/// Do doubles tell the sign of a number of this world?
bool is_told(const auto& w, const auto& n) { return w.certain() && (w.positive(n) || w.negative(n)); }

// Of an oriented box and a triangle, whose numbers are of every family.
TEST(MotionDirections, DoublesTellOfDirectionsInPromisedShare) {
  PromisedShare reaches("motion_reaches"), gap("motion_gap"), facet_reaches("motion_facet_reaches"),
      facet_speed("motion_facet_speed");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(200); ++i) {
      Entropy entropy(2045, i);
      std::array<double, 30> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const auto point = [&](std::size_t k) { return Point3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const auto vector = [&](std::size_t k) { return Vector3{x[3 * k], x[3 * k + 1], x[3 * k + 2]}; };
      const Translating<Obb3> a{{point(0), {vector(1), vector(2), vector(3)}, vector(4)}, vector(5)};
      const Translating<Triangle3> b{{point(6), point(7), point(8)}, vector(9)};
      const MotionSearch<Obb3, Triangle3> search(a, b);
      const auto motion = known_motion(search);
      MotionWorld<> of_given, of_ways;
      of_given.number<0>(search.size), of_given.number<1>(largest_of(search.between_them));
      const auto n = given<1>(search.between_them);
      const auto low = reaches_along(n, motion).low;
      reaches.add(info.family, is_told(of_given, low));
      gap.add(info.family, is_told(of_given, low * low - motion.reach * motion.reach * inner(n, n)));
      const Vec3<double>&u = search.a.way(0), &v = search.b.way(0);
      of_ways.number<0>(search.size), of_ways.number<1>(largest_of(u)), of_ways.number<2>(largest_of(v));
      const auto facet = outer(known<1>(u), known<2>(v));
      facet_reaches.add(info.family, is_told(of_ways, reaches_along(facet, motion).low));
      facet_speed.add(info.family, is_told(of_ways, inner(facet, motion.by)));
    }
  }
}

struct Drawn {
  Translating<Obb3> box;
  Translating<Triangle3> triangle;
  Translating<Capsule3> capsule;
  Plain way;
};
Drawn drawn_figures(mutants::Draw& d) {
  Drawn x{{d.turned_box(), d.vector()},
          {{d.point(), d.point(), d.point()}, d.vector()},
          {{d.point(), d.point(), d.quarter() + d.positive()}, d.vector()},
          {d.number(), d.number(), d.number()}};
  // As a rule far from one another, so that the least of all differences is above zero and below.
  x.triangle.shape.a.x += 4, x.triangle.shape.b.x += 4, x.triangle.shape.c.x += 4;
  return x;
}
Plain plain(const auto& p) { return {p.x, p.y, p.z}; }
/// The least and the most of the differences of the corners along n.
std::array<double, 2> reaches_of_corners(const Plain& n, const Obb3& a, const auto& corners_of_b) {
  std::array reaches{HUGE_VAL, -HUGE_VAL};
  for (unsigned bits = 0; bits < 8; ++bits) {
    Plain corner = plain(a.center);
    for (unsigned k = 0; k < 3; ++k) {
      const double half = std::array{a.half.x, a.half.y, a.half.z}[k];
      corner = corner + plain(a.axes[k]) * ((bits >> k & 1) != 0 ? half : -half);
    }
    for (const Plain& b : corners_of_b) {
      const double lead = dot(n, b - corner);
      reaches = {std::fmin(reaches[0], lead), std::fmax(reaches[1], lead)};
    }
  }
  return reaches;
}
using mutants::Number;
using InMutants = Moved<Number, Obb3, Triangle3>;
Vec3<Number> numbers(const Plain& v) { return {Number(v.x), Number(v.y), Number(v.z)}; }
using Signs = std::array<Sign, 2>;

TEST(MotionDirections, WrongOperationsAreNoticed) {
  using mutants::expect_noticed;
  const auto unnoticed = [](const auto& told, const auto& truth) {
    return mutants::unnoticed(
        drawn_figures, [&](const Drawn& x) { return std::optional(told(x)); }, truth, 0, 2000);
  };
  const auto corners = [](const Triangle3& t) { return std::array{plain(t.a), plain(t.b), plain(t.c)}; };
  const auto facet = [&](const Drawn& x) {
    const Obb3& box = x.box.shape;
    return cross(plain(box.axes[0]) * std::fabs(box.half.x), plain(x.triangle.shape.b) - plain(x.triangle.shape.a));
  };
  const auto signs_of = [](const auto& reaches) { return Signs{reaches.low.sign(), reaches.high.sign()}; };
  const auto signs_of_corners = [&](const Plain& n, const Drawn& x) {
    const auto [low, high] = reaches_of_corners(n, x.box.shape, corners(x.triangle.shape));
    return Signs{sign_of(low), sign_of(high)};
  };
  // Not asked is the way between the triangle's other corners; the motion and radii have no part in where shapes start.
  const char* const unasked = "12 13 14 18 19 20 24 ";
  expect_noticed(
      "motion_reaches",
      unnoticed([&](const Drawn& x) { return signs_of(reaches_along(numbers(x.way), InMutants(x.box, x.triangle))); },
                [&](const Drawn& x) { return signs_of_corners(x.way, x); }),
      unasked);
  expect_noticed(
      "motion_facet_reaches",
      unnoticed(
          [&](const Drawn& x) {
            const InMutants moved(x.box, x.triangle);
            return signs_of(reaches_along(outer(moved.a.way(0), moved.b.way(0)), moved));
          },
          [&](const Drawn& x) { return signs_of_corners(facet(x), x); }),
      std::string(unasked) + mutants::by_compiler("73 ", "61 "));  // along the direction made of it a way has no size
  expect_noticed(
      "motion_gap",
      unnoticed(
          [](const Drawn& x) {
            const Moved<Number, Obb3, Capsule3> moved(x.box, x.capsule);
            const Vec3<Number> n = numbers(x.way);
            const auto [low, high] = reaches_along(n, moved);
            const Number limit = moved.reach * moved.reach * inner(n, n);
            return Signs{(low * low - limit).sign(), (high * high - limit).sign()};
          },
          [&](const Drawn& x) {
            const Capsule3& c = x.capsule.shape;
            const auto [low, high] = reaches_of_corners(x.way, x.box.shape, std::array{plain(c.a), plain(c.b)});
            const double limit = c.radius * c.radius * dot(x.way, x.way);
            return Signs{sign_of(low * low - limit), sign_of(high * high - limit)};
          }),
      "12 13 14 18 ");  // nor has the motion; of the radius the square is asked, and no other is there
  expect_noticed("motion_facet_speed",
                 unnoticed(
                     [](const Drawn& x) {
                       const InMutants moved(x.box, x.triangle);
                       return inner(outer(moved.a.way(0), moved.b.way(0)), moved.by).sign();
                     },
                     [&](const Drawn& x) { return sign_of(dot(facet(x), plain(x.box.by) - plain(x.triangle.by))); }),
                 "3 4 5 6 7 8 12 13 14 15 16 17 21 22 23 24 ");  // other ways, and where the shapes are
}

using certify::written::Book;
using Kind = Book::Entry::Kind;
using Written = certify::written::World<4, Scales{.count = 3}>;
/// What a search has computed is any number, rounded once, as the written differences are.
auto written_as(Book& book, Kind kind, const Track& track) {
  return [&book, kind, track](const Vec3<double>& v) {
    const auto one = [&](double x) { return certify::written::Number(book, {kind}, track, x); };
    return Vec3<certify::written::Number>{one(v.x), one(v.y), one(v.z)};
  };
}
/// All of the scale that no other exceeds.
struct OfBoth {
  Written world;

  template <std::size_t>
  certify::written::Number difference(double b, double a) {
    return world.difference<2>(b, a);
  }
  template <std::size_t>
  certify::written::Number number(double a) {
    return world.number<2>(a);
  }
};
void expect_bound(const std::string& name, const auto& w, const auto& number, const Book& book,
                  const certify::written::Number& written) {
  BoundListener::taken();
  static_cast<void>(w.positive(number));
  const std::vector<std::string> bounds = BoundListener::taken();
  expect_golden(name, bounds);
  static_cast<void>(written.sign());
  expect_proved(bounds, book.scripts(name));
}

TEST(MotionDirections, BoundsAreTheGoldenOnesAndProved) {
  const Translating<Obb3> a{{{0, 0, 9}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {1, 2, 3}}, {1, 2, 3}};
  const Translating<Triangle3> b{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {0, 0, 0}};
  const MotionSearch<Obb3, Triangle3> search(a, b);
  const auto motion = known_motion(search);
  Book book;
  const auto coordinate = written_as(book, Kind::difference, track_of_coordinate<0>());
  const KnownMotion written{search.a.made(coordinate), search.b.made(coordinate), coordinate(search.by),
                            coordinate(search.apart), coordinate({search.reach, 0, 0}).x};
  const MotionWorld<BoundListener> w;
  const auto gap = [](const auto& n, const auto& m) {
    const auto low = reaches_along(n, m).low;
    return low * low - m.reach * m.reach * inner(n, n);
  };
  const auto n = given<1>(search.between_them);
  const auto along = written_as(book, Kind::given, GivenLeaf<1>::track)(search.between_them);
  expect_bound("motion_reaches", w, reaches_along(n, motion).low, book, reaches_along(along, written).low);
  expect_bound("motion_gap", w, gap(n, motion), book, gap(along, written));
  const auto facet = outer(known<1>(search.a.way(0)), known<2>(search.b.way(0)));
  const auto of_ways = outer(written_as(book, Kind::difference, track_of_coordinate<1>())(search.a.way(0)),
                             written_as(book, Kind::difference, track_of_coordinate<2>())(search.b.way(0)));
  expect_bound("motion_facet_reaches", w, reaches_along(facet, motion).low, book, reaches_along(of_ways, written).low);
  expect_bound("motion_facet_speed", w, inner(facet, motion.by), book, inner(of_ways, written.by));
}

TEST(MotionDirections, BoundsOfBallsAreTheGoldenOnesAndProved) {
  const auto balls = []<class W>(W& w) {
    return BallsInMotion<W>(w, {0, 0, 9}, {0, 0, 0}, 1, 1, {1, 2, 3}, {0, 0, 0});
  };
  BallsWorld<BoundListener> w;
  Written written;
  OfBoth of_both;
  const auto floats = balls(w);
  const auto apart = balls(written);
  const auto at_end = balls(of_both);
  expect_bound("balls_start", w, floats.c(), written.book(), apart.c());
  expect_bound("balls_discriminant", w, floats.discriminant(), written.book(), apart.discriminant());
  expect_bound("balls_end", w, floats.value_at_end(), of_both.world.book(), at_end.value_at_end());
  expect_bound("balls_slope", w, floats.slope_at_end(), of_both.world.book(), at_end.slope_at_end());
}

/// How many of a family doubles answer; on integers touches are common, which they never tell.
template <class A, class B>
int told_of(int count, Numbers numbers) {
  int told = 0;
  for (int i = 0; i < count; ++i) {
    Entropy entropy(2043, static_cast<std::uint64_t>(i));
    const Translating<A> a = drawn<A>(entropy, numbers);
    const Translating<B> b = drawn<B>(entropy, numbers);
    if constexpr (requires { b.shape.min; }) {
      if (is_empty(b.shape)) continue;
    }
    const MotionVerdict verdict = contact<ContactWanted::whether>(a, b).told;
    told += verdict == MotionVerdict::yes || verdict == MotionVerdict::no ? 1 : 0;
  }
  return told;
}
TEST(MotionDirections, DoublesAnswerThePromisedShare) {
  constexpr int count = 400;
  const auto promise = [&]<class A, class B>(const char* name, const Translating<A>&, const Translating<B>&,
                                             double noisy, double integers) {
    const int of_noisy = told_of<A, B>(count, Numbers::noisy), of_integers = told_of<A, B>(count, Numbers::integers);
    std::cout << name << ": of " << count << " noisy " << of_noisy << ", integers " << of_integers << '\n';
    EXPECT_GE(of_noisy, noisy * count) << name;
    EXPECT_GE(of_integers, integers * count) << name;
  };
  promise("balls", Translating<Sphere3>{}, Translating<Sphere3>{}, 0.98, 0.95);
  promise("ball, triangle", Translating<Sphere3>{}, Translating<Triangle3>{}, 0.96, 0.75);
  promise("triangles", Translating<Triangle3>{}, Translating<Triangle3>{}, 0.98, 0.8);
  promise("oriented boxes", Translating<Obb3>{}, Translating<Obb3>{}, 0.98, 0.7);
  promise("point, box", Translating<Point3>{}, Translating<Aabb3>{}, 0.93, 0.9);
}

}  // namespace
}  // namespace plumb::query::quick
