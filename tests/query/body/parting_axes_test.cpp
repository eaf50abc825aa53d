// Boxes under poses along their fifteen axes: which bounds were derived, does a machine confirm them, and would a slip be
// noticed?
#include "query/body/parting_axes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>

#include "arith/vec.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"

namespace plumb::query {
namespace {

using arith::Plain;

PosedBox box_of(const std::array<Vector3, 3>& axes, double half, const Vector3& at, double weight) {
  const GivenBox::Ends ends{-half, half}, middle{-0.25, 0.5};
  PosedBox b{};
  b.axes = b.columns = axes;
  b.length = {ends, ends, ends}, b.local = {middle, middle, middle};
  b.at = at, b.weight = weight;
  return b;
}

TEST(PartingAxes, DerivedBoundsAreAsRecordedAndProved) {
  // Deep in one another, so that all axes are asked.
  const PosedBox a = box_of({{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, 3, {0, 0, 0}, 2),
                 b = box_of({{{0.75, 0.5, 0.25}, {-0.5, 0.75, 0.125}, {-0.25, 0.125, 0.75}}}, 3, {0.5, 0.25, 1}, 1.5);
  FloatWorld<PartingAxes> world;
  EXPECT_EQ(PartingAxes{}(world, a, b, 0), Relation::overlapping);
  EXPECT_TRUE(world.certain());
  const auto bounds = judged_bounds(PartingAxes{}, a, b, 0U);
  expect_golden("parting_axes", bounds);
  expect_proved(bounds, judged_proofs("parting_axes", PartingAxes{}, a, b, 0U));
}

/// A box by numbers, its axes near those of space where these are small.
PosedBox drawn_box(const auto& number, const auto& positive, double along) {
  PosedBox b{};
  for (auto* columns : {&b.axes, &b.columns}) {
    for (std::size_t k = 0; k < 3; ++k) {
      (*columns)[k] = {number(), number(), number()};
      ((*columns)[k].*std::array{&Vector3::x, &Vector3::y, &Vector3::z}[k]) += along;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    b.length[k] = {-positive(), positive()}, b.local[k] = {number(), number()};
  }
  b.at = {number(), number(), number()};
  b.weight = positive();
  return b;
}

/// What is told of the boxes; nothing where a gap is zero, or a box is flat.
std::optional<Relation> told_of(auto& w, const PosedBox& a, const PosedBox& b) {
  return PartingAxes{}(w, a, b, PartingAxes::parallel(a, b));
}

/// The same of small multiples of a quarter, whose products doubles hold.
std::optional<Relation> truth(const PosedBox& a, const PosedBox& b) {
  const auto of = [](const GivenBox::Ends& e) { return e.to - e.from; };
  const auto axis = [&](std::size_t k) { return arith::vec<double>((k < 3 ? a : b).axes[k % 3]); };
  const auto length = [&](std::size_t k) {
    return k < 3 ? of(a.length[k]) * b.weight : of(b.length[k - 3]) * a.weight;
  };
  const auto twice_middle = [&](const PosedBox& p, double by) {
    Plain m = arith::vec<double>(p.at) * (2 * a.weight * b.weight);
    for (std::size_t k = 0; k < 3; ++k) m = m + arith::vec<double>(p.columns[k]) * (of(p.local[k]) * by);
    return m;
  };
  const Plain way = twice_middle(a, b.weight) - twice_middle(b, a.weight);
  bool is_open = false, is_apart = false;
  for (std::size_t k = 0; k < 6; ++k) {
    if (!(length(k) > 0)) return {};
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i + 1; j < 6; ++j) {
      const Plain n = cross(axis(i), axis(j));
      if (i < 3 && j >= 3 && dot(n, n) == 0) continue;
      double gap = std::fabs(dot(n, way));
      for (std::size_t k = 0; k < 6; ++k) gap -= std::fabs(dot(n, axis(k))) * length(k);
      is_apart = is_apart || gap > 0, is_open = is_open || gap == 0;
    }
  }
  if (is_apart) return Relation::disjoint;
  for (const std::size_t k : {0U, 3U}) is_open = is_open || dot(cross(axis(k), axis(k + 1)), axis(k + 2)) == 0;
  return is_open ? std::nullopt : std::optional(Relation::overlapping);
}

struct Drawn {
  PosedBox a, b;
};
TEST(PartingAxes, MutantsAreNoticed) {
  const auto draw = [](mutants::Draw& d) {
    const auto box = [&] { return drawn_box([&] { return d.number() / 2; }, [&] { return d.positive() - 1; }, 2); };
    Drawn x{box(), box()};
    x.a.weight += 1, x.b.weight += 1;
    return x;
  };
  // That nothing is told is an answer as well.
  using Answer = std::optional<Relation>;
  const auto ask = [](const Drawn& x) {
    mutants::World w;
    return std::optional<Answer>(told_of(w, x.a, x.b));
  };
  const auto so = [](const Drawn& x) { return truth(x.a, x.b); };
  mutants::expect_noticed("parting_axes", mutants::unnoticed(draw, ask, so, 0, 20000));
}

/// What doubles do not tell is left open.
struct Told {
  static constexpr Scales scales = PartingAxes::scales;
  static constexpr int highest = PartingAxes::highest;
  template <class W>
  std::optional<Relation> operator()(W& w, const PosedBox& a, const PosedBox& b) const {
    const auto told = told_of(w, a, b);
    if constexpr (requires { w.leave_open(); }) {
      if (!told) w.leave_open();
    }
    return told;
  }
};
TEST(PartingAxes, DoublesTellInPromisedShare) {
  expect_share<72>("parting_axes", Told{}, [](const auto& ask, const std::array<double, 72>& x) {
    std::size_t at = 0;
    const auto next = [&] { return x[at++ % x.size()]; };
    const auto box = [&] {
      return drawn_box(
          next, [&] { return std::fabs(next()); }, 0);
    };
    const PosedBox a = box();
    ask(a, box());
  });
}

}  // namespace
}  // namespace plumb::query
