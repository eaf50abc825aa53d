// Are the coefficients of what moves as near to those of real arithmetic as doubles say, and are mistakes noticed?
#include "query/time_of_impact/swept_signs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include "arith/vec.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "lab/trial/moving_cases.hpp"
#include "plumb/certify/judged_proofs.hpp"

namespace plumb::query::moving {
namespace {

using lab::moving_cases::Case, lab::moving_cases::Kind;
using Listening = SweptFloats<BoundListener>;

/// What a mutant has wrong.
enum class Mistake { none, middle, thrice, corner, side };

/// Three differences, the cubic and a side, on a piece of time, and the steps of the cubic.
template <Mistake mistake, class W>
auto coefficients(W& w, const Case& c, double s, double t) {
  const auto between_points = [&](std::size_t i) {
    return Swept{swept_difference(w, c.at_0[i], c.at_0[0]), swept_difference(w, c.at_1[i], c.at_1[0])};
  };
  const auto first = between_points(1), second = between_points(2), third = between_points(3);
  auto side = mistake == Mistake::side ? swept_side(second, first) : swept_side(first, second);
  if constexpr (mistake == Mistake::middle) side.x[1] = side.x[0];
  auto cubic = swept_cubic(third, side);
  if constexpr (mistake == Mistake::thrice) cubic[0] = cubic[1];
  auto piece = piece_of(cubic, s, mistake == Mistake::corner ? s : t);
  const std::array steps{piece[1] - piece[0], piece[2] - piece[1], piece[3] - piece[2]};
  return std::tuple(side.x, cubic, piece, piece_of(side.x, s, t), steps);
}

/// What a number of this track may be off, by the largest differences.
template <Track track>
Rational reach(const SweptFloats<>& w) {
  Rational m = Rational(static_cast<double>(track.error)) * Rational(0x1p-85);
  const std::array scales{w.scale<0>(), w.scale<1>(), w.scale<2>()};
  for (std::size_t s = 0; s < 3; ++s) {
    for (int i = 0; i < track.power(s, 0); ++i) m = m * Rational(scales[s]);
  }
  return m;
}

struct Tally {
  int numbers = 0, beyond = 0, false_signs = 0;
};

template <Mistake mistake>
Tally tally_of(int count) {
  Tally tally;
  for (const Kind kind : {Kind::any, Kind::planted, Kind::double_root, Kind::parallel}) {
    for (int i = 0; i < count; ++i) {
      Entropy entropy(2033, static_cast<std::uint64_t>(i));
      Case c = lab::moving_cases::make(kind, true, entropy);
      for (auto* points : {&c.at_0, &c.at_1}) {
        for (Point3& p : *points) p = {p.x / 3, p.y / 7 + 1e3, std::ldexp(p.z / 5, i % 2 == 0 ? 0 : -200)};
      }
      const auto part = [&] { return static_cast<double>(entropy.below(1ULL << 30)) / 0x1.8p31; };
      const double s = part(), t = i % 4 == 0 ? s : 1 - part();
      SweptFloats<> floats;
      RationalWorld rationals;
      const auto computed = coefficients<mistake>(floats, c, s, t);
      const auto exact = coefficients<Mistake::none>(rationals, c, s, t);
      EXPECT_TRUE(floats.certain());
      const auto compare = [&]<std::size_t k>() {
        const auto& numbers = std::get<k>(computed);
        const auto& truths = std::get<k>(exact);
        for (std::size_t j = 0; j < numbers.size(); ++j) {
          constexpr Track track = std::remove_cvref_t<decltype(numbers[0])>::track;
          ++tally.numbers;
          const Rational off = magnitude(Rational(numbers[j].value) - truths[j]);
          tally.beyond += reach<track>(floats) < off ? 1 : 0;
          const bool is_positive = truths[j].sign() == Sign::positive, is_negative = truths[j].sign() == Sign::negative;
          tally.false_signs += floats.positive(numbers[j]) && !is_positive ? 1 : 0;
          tally.false_signs += floats.negative(numbers[j]) && !is_negative ? 1 : 0;
        }
      };
      compare.template operator()<0>(), compare.template operator()<1>(), compare.template operator()<2>();
      compare.template operator()<3>(), compare.template operator()<4>();
    }
  }
  return tally;
}

TEST(SweptSigns, CoefficientsAreWithinTheirDerivedErrors) {
  const Tally tally = tally_of<Mistake::none>(60);
  EXPECT_EQ(tally.beyond, 0);
  EXPECT_EQ(tally.false_signs, 0);
  EXPECT_GT(tally.numbers, 4000);
}

TEST(SweptSigns, MutantsAreNoticed) {
  const auto noticed = [](const char* name, const Tally& tally) {
    std::cout << name << ": " << tally.beyond << " of " << tally.numbers << " beyond, " << tally.false_signs
              << " false signs\n";
    EXPECT_GT(tally.beyond, 0) << name;
    EXPECT_GT(tally.false_signs, 0) << name;
  };
  noticed("the side's middle", tally_of<Mistake::middle>(10));
  noticed("the cubic's ends", tally_of<Mistake::thrice>(10));
  noticed("the piece's corner", tally_of<Mistake::corner>(10));
  noticed("the side turned over", tally_of<Mistake::side>(10));
}

TEST(SweptSigns, DoublesTellThemInPromisedShare) {
  PromisedShare of_side("swept_side"), of_cubic("swept_cubic"), of_cubic_piece("swept_cubic_piece"),
      of_side_piece("swept_side_piece"), of_steps("swept_cubic_step");
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(200); ++i) {
      Entropy entropy(2035, i);
      std::array<double, 24> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      Case c;
      for (std::size_t k = 0; k < 4; ++k) {
        c.at_0[k] = {x[3 * k], x[3 * k + 1], x[3 * k + 2]};
        c.at_1[k] = {x[12 + 3 * k], x[13 + 3 * k], x[14 + 3 * k]};
      }
      SweptFloats<> w;
      const auto [side, cubic, piece, side_piece, steps] = coefficients<Mistake::none>(w, c, 0.25, 0.625);
      const auto count = [&](PromisedShare& share, const auto& numbers) {
        for (const auto& n : numbers) share.add(info.family, w.certain() && (w.positive(n) || w.negative(n)));
      };
      count(of_side, side), count(of_cubic, cubic), count(of_cubic_piece, piece);
      count(of_side_piece, side_piece), count(of_steps, steps);
    }
  }
}

/// Four points that move, and a piece of time.
struct Drawn {
  Case points;
  double s, t;
};
/// Which of them are asked.
enum class Of { side, side_piece, cubic, cubic_piece, step };

std::vector<mutants::Number> told(Of which, const Drawn& d) {
  using mutants::Number;
  mutants::World w;
  const auto between_points = [&](std::size_t i) {
    return Swept{swept_difference(w, d.points.at_0[i], d.points.at_0[0]),
                 swept_difference(w, d.points.at_1[i], d.points.at_1[0])};
  };
  const auto list = [](const auto&... all) {
    std::vector<Number> numbers;
    (numbers.insert(numbers.end(), all.begin(), all.end()), ...);
    return numbers;
  };
  const auto side = swept_side(between_points(1), between_points(2));
  if (which == Of::side) return list(side.x, side.y, side.z);
  if (which == Of::side_piece) {
    return list(piece_of(side.x, d.s, d.t), piece_of(side.y, d.s, d.t), piece_of(side.z, d.s, d.t));
  }
  const auto cubic = swept_cubic(between_points(3), side);
  if (which == Of::cubic) return list(cubic);
  const auto piece = piece_of(cubic, d.s, d.t);
  if (which == Of::cubic_piece) return list(piece);
  return list(std::array{piece[1] - piece[0], piece[2] - piece[1], piece[3] - piece[2]});
}
/// By the polar forms: products of the vectors at two times, or three, summed up over all orders of those.
std::vector<double> truth(Of which, const Drawn& d) {
  const auto vector_at = [&](std::size_t i, double t) {
    const auto less = [](const Point3& p, const Point3& q) { return arith::Plain{p.x - q.x, p.y - q.y, p.z - q.z}; };
    return less(d.points.at_0[i], d.points.at_0[0]) * (1 - t) + less(d.points.at_1[i], d.points.at_1[0]) * t;
  };
  const auto side = [&](double s, double t) {
    return cross(vector_at(1, s), vector_at(2, t)) + cross(vector_at(1, t), vector_at(2, s));
  };
  const auto cubic = [&](double r, double s, double t) {
    return dot(vector_at(3, r), side(s, t)) + dot(vector_at(3, s), side(t, r)) + dot(vector_at(3, t), side(r, s));
  };
  const bool is_whole = which == Of::side || which == Of::cubic;
  const double s = is_whole ? 0 : d.s, t = is_whole ? 1 : d.t;
  if (which == Of::side || which == Of::side_piece) {
    const arith::Plain a = side(s, s), b = side(s, t), c = side(t, t);
    return {a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z};
  }
  const std::vector<double> all{cubic(s, s, s), cubic(s, s, t), cubic(s, t, t), cubic(t, t, t)};
  if (which != Of::step) return all;
  return {all[1] - all[0], all[2] - all[1], all[3] - all[2]};
}
std::string unnoticed(Of which) {
  return mutants::unnoticed(
      [](mutants::Draw& draw) {
        Drawn d{{}, draw.quarter(), 1 - draw.quarter()};
        for (auto* points : {&d.points.at_0, &d.points.at_1}) {
          for (Point3& p : *points) p = draw.point();
        }
        return d;
      },
      [&](const Drawn& d) {
        std::vector<Sign> signs;
        for (const mutants::Number& n : told(which, d)) signs.push_back(n.sign());
        return std::optional(signs);
      },
      [&](const Drawn& d) {
        std::vector<Sign> signs;
        for (const double x : truth(which, d)) signs.push_back(static_cast<Sign>((x > 0) - (x < 0)));
        return signs;
      },
      0, 1000);
}
TEST(SweptSigns, WrongOperationsAreNoticed) {
  mutants::expect_noticed("swept_side", unnoticed(Of::side));
  mutants::expect_noticed("swept_side_piece", unnoticed(Of::side_piece));
  // Three times an end, or once: its sign is the same, but not that of a piece.
  mutants::expect_noticed("swept_cubic", unnoticed(Of::cubic), "68 69 99 100 ");
  mutants::expect_noticed("swept_cubic_piece", unnoticed(Of::cubic_piece));
  mutants::expect_noticed("swept_cubic_step", unnoticed(Of::step));
}

TEST(SweptSigns, BoundsAreTheGoldenOnes) {
  Entropy entropy(2034, 0);
  const Case c = lab::moving_cases::make(Kind::any, true, entropy);
  Listening w;
  const auto [side, cubic, piece, side_piece, steps] = coefficients<Mistake::none>(w, c, 0.25, 0.5);
  const auto golden = [&](const std::string& name, const auto& number) {
    BoundListener::taken();
    static_cast<void>(w.positive(number));
    expect_golden(name);
  };
  golden("swept_side", side[0]);
  golden("swept_side_piece", side_piece[0]);
  golden("swept_cubic", cubic[0]);
  golden("swept_cubic_piece", piece[0]);
  golden("swept_cubic_step", steps[0]);
}

/// The coefficients of the whole time; nothing is claimed of numbers between two.
struct Coefficients {
  static constexpr int highest = 3;
  static constexpr Scales scales = swept_scales;
  bool operator()(auto& w, const Case& c) const {
    const auto between_points = [&](std::size_t i) {
      return Swept{swept_difference(w, c.at_0[i], c.at_0[0]), swept_difference(w, c.at_1[i], c.at_1[0])};
    };
    const auto side = swept_side(between_points(1), between_points(2));
    const auto cubic = swept_cubic(between_points(3), side);
    bool is_above = false;
    for (const auto& x : side.x) is_above |= w.positive(x);
    for (const auto& x : cubic) is_above |= w.positive(x);
    return is_above;
  }
};
TEST(SweptSigns, BoundsOfTheWholeTimeAreProved) {
  Entropy entropy(2034, 0);
  const Case c = lab::moving_cases::make(Kind::any, true, entropy);
  const std::vector<std::string> bounds = judged_bounds(Coefficients{}, c),
                                 scripts = judged_proofs("swept", Coefficients{}, c);
  EXPECT_EQ(scripts.size(), 5);  // the ends are alike, the others are made in other ways
  for (const std::string& script : scripts) {
    const auto claimed = [&](const std::string& bound) { return claims(script, bound); };
    EXPECT_EQ(std::ranges::count_if(bounds, claimed), 1) << script;
    expect_proved({*std::ranges::find_if(bounds, claimed)}, {script});
  }
}

}  // namespace
}  // namespace plumb::query::moving
