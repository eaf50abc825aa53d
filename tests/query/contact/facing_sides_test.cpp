// The sides of two boxes that face each other: which bounds were derived, does a machine confirm them, and would a slip be
// noticed?
#include "query/contact/facing_sides.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"

namespace plumb::query::touching {
namespace {

using arith::Plain;

struct Asked {
  std::array<GivenBox, 2> box;
  std::array<FacingSides::Level, 2> level;
  Vector3 u, v;
  std::array<std::uint32_t, 2> side;
};

template <class W>
FacingSides::Told told_of(W& w, const Asked& x) {
  return FacingSides{}(w, x.box, x.level, x.u, x.v, [&](std::size_t i, const auto&, const auto&) { return x.side[i]; });
}

struct OfAsked {
  static constexpr Scales scales = FacingSides::scales;
  static constexpr int highest = FacingSides::highest;
  template <class W>
  FacingSides::Told operator()(W& w, const Asked& x) const {
    return told_of(w, x);
  }
};

GivenBox box_at(const Plain& middle, const std::array<Vector3, 3>& axes, const std::array<double, 3>& half) {
  const auto ends = [](double x) { return GivenBox::Ends{-x, x}; };
  return {axes, {ends(half[0]), ends(half[1]), ends(half[2])}, {ends(middle.x), ends(middle.y), ends(middle.z)}};
}

TEST(FacingSides, DerivedBoundsAreAsRecordedAndProved) {
  // One upon the other, tilted a little; the normal leads up.
  const Asked x{{box_at({0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {2, 2, 1}),
                 box_at({0.25, 0.5, 2}, {{{0.75, 0.5, 0.125}, {-0.5, 0.75, 0}, {0, 0.125, 1}}}, {1, 0.5, 1})},
                {{{4, 0}, {0, 0}}},
                {1, 0, 0},
                {0, 1, 0},
                {2, 2}};
  FloatWorld<OfAsked> world;
  EXPECT_TRUE(told_of(world, x).is_told && world.certain());
  const auto bounds = judged_bounds(OfAsked{}, x);
  expect_golden("facing_sides", bounds);
  expect_proved(bounds, judged_proofs("facing_sides", OfAsked{}, x));
}

/// Everything twice as large.
struct Corners {
  std::array<Plain, 4> at;
};
Plain axis_of(const GivenBox& b, std::size_t k) { return arith::vec<double>(b.axes[k]); }
double length_of(const GivenBox::Ends& e) { return e.to - e.from; }
Corners corners_of(const GivenBox& b, const FacingSide& s) {
  const auto sided = [&](std::size_t k, bool up) {
    return axis_of(b, k) * (up ? length_of(b.length[k]) : -length_of(b.length[k]));
  };
  const Plain middle{length_of(b.middle[0]), length_of(b.middle[1]), length_of(b.middle[2])};
  const std::size_t i = (s.axis + 1) % 3, j = (s.axis + 2) % 3;
  const auto corner = [&](bool p, bool q) { return middle + sided(s.axis, s.upper) + sided(i, p) + sided(j, q); };
  std::array around{corner(false, false), corner(true, false), corner(true, true), corner(false, true)};
  if (!s.forth) std::swap(around[0], around[3]), std::swap(around[1], around[2]);
  return {around};
}
/// The numbers are small integers, whose products doubles hold.
FacingSides::Told truth(const Asked& x) {
  const auto sign = [](double t) { return static_cast<Sign>((t > 0) - (t < 0)); };
  const Plain n = cross(arith::vec<double>(x.u), arith::vec<double>(x.v));
  FacingSides::Told told;
  for (std::size_t i = 0; i < 2; ++i) {
    const Plain out = i == 0 ? n : n * -1;
    const auto normal = [&](std::size_t k) {
      return cross(axis_of(x.box[i], (k + 1) % 3), axis_of(x.box[i], (k + 2) % 3));
    };
    const std::uint32_t k = x.side[i];
    const double along = dot(normal(k), out), turn = dot(normal(k), axis_of(x.box[i], k));
    const bool upper = (x.level[i].first >> k & 1) != 0;
    told.side[i] = {k, upper, along > 0};
    bool is_it = (x.level[i].free >> k & 1) == 0 && (upper ? along * turn > 0 : along * turn < 0);
    for (std::uint32_t j = 0; j < 3; ++j) {
      if (j == k || (x.level[i].free >> j & 1) != 0) continue;
      const double other = dot(normal(j), out);
      is_it = is_it && along * along * dot(normal(j), normal(j)) > other * other * dot(normal(k), normal(k));
    }
    told.is_told = told.is_told && is_it;
  }
  if (!told.is_told) return told;
  const std::array corners{corners_of(x.box[0], told.side[0]), corners_of(x.box[1], told.side[1])};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t l = 0; l < 4; ++l) {
      const Plain &from = corners[i].at[l], &to = corners[i].at[(l + 1) % 4];
      const Plain inward = cross(i == 0 ? n : n * -1, to - from);
      for (std::size_t j = 0; j < 4; ++j) told.sign[i][4 * l + j] = sign(dot(inward, corners[1 - i].at[j] - from));
    }
  }
  return told;
}
/// Boxes by small numbers, and as a rule the side that faces the other one.
Asked asked_of(const auto& number, const auto& positive) {
  const auto box = [&] {
    std::array<Vector3, 3> axes{};
    for (std::size_t k = 0; k < 3; ++k) {
      axes[k] = {number() / 2, number() / 2, number() / 2};
      (k == 0 ? axes[k].x : k == 1 ? axes[k].y : axes[k].z) += 2;
    }
    const Plain middle{number(), number(), number()};
    return box_at(middle, axes, {positive(), positive(), positive()});
  };
  Asked x{{box(), box()}, {}, {3, number() / 2, number() / 2}, {number() / 2, 2, number() / 2}, {}};
  const Plain n = cross(arith::vec<double>(x.u), arith::vec<double>(x.v));
  for (std::size_t i = 0; i < 2; ++i) {
    double most = -1;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Plain normal = cross(axis_of(x.box[i], (k + 1) % 3), axis_of(x.box[i], (k + 2) % 3));
      const double along = dot(n, normal), part = along * along / dot(normal, normal);
      if (part > most) most = part, x.side[i] = k;
      const bool is_up = (dot(n, axis_of(x.box[i], k)) > 0) == (i == 0);
      x.level[i].first |= is_up ? 1U << k : 0U;
    }
  }
  return x;
}
TEST(FacingSides, MutantsAreNoticed) {
  const auto draw = [](mutants::Draw& d) { return asked_of([&] { return d.number(); }, [&] { return d.positive(); }); };
  const auto ask = [](const Asked& x) {
    mutants::World w;
    return std::optional(told_of(w, x));
  };
  mutants::expect_noticed("facing_sides", mutants::unnoticed(draw, ask, truth, 0, 10000));
}

TEST(FacingSides, DoublesTellInPromisedShare) {
  expect_share<33>("facing_sides", OfAsked{}, [](const auto& ask, const std::array<double, 33>& x) {
    std::size_t at = 0;
    ask(asked_of([&] { return x[at++ % 33]; }, [&] { return std::fabs(x[at++ % 33]); }));
  });
}

}  // namespace
}  // namespace plumb::query::touching
