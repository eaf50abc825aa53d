// Statements about the origin: which bounds were derived, and does each world tell what is so?
#include "query/gjk/origin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "certify/golden_statements.hpp"
#include "certify/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/gjk/nearest_statement.hpp"

namespace plumb::query {
namespace {

using namespace gjk_origin;

template <class Statement, class... Input>
void expect_bounds_of(const char* name, const Statement& statement, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(statement, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, statement, input...));
}

TEST(GjkOrigin, DerivedBoundsAreAsRecordedAndProved) {
  const arith::Plain n{1, 2, 0.5};
  const Point3 v{1, 2, 3}, p{0.25, -1, 2};
  expect_bounds_of("gjk_ahead", Ahead{}, n, v, p);
  const std::array<Point3, 2> all{v, {5, 6, 7}};
  const std::array<std::uint32_t, 2> of{0, 1};
  expect_bounds_of("gjk_are_ahead", AreAhead{}, n, all.data(), std::span<const std::uint32_t>(of), p);
  const Point3 o{0, 0, 0};
  const std::array<Point3, 4> at_origin{o, o, o, o};
  expect_bounds_of("gjk_around_origin", IsAroundOrigin{},
                   Pairs{{{{3, 0, -1}, {-2, 2, -1}, {-2, -2, -1}, {0, 0, 5}}}, at_origin});
  expect_bounds_of("gjk_holds_origin2", HoldsOrigin<2>{}, Pairs{{{{1, 2, 3}, {-2, -4, -6}, o, o}}, at_origin});
  expect_bounds_of("gjk_holds_origin3", HoldsOrigin<3>{}, Pairs{{{{3, 0, 0}, {-2, 2, 0}, {-2, -2, 0}, o}}, at_origin});
}

TEST(GjkNearest, DerivedBoundsAreAsRecordedAndProved) {
  // Of a triangle above the origin, and of the origin itself with one point beneath it.
  const std::array<Point3, 4> above{{{2, 0, 1}, {-1, 2, 1}, {-1, -2, 1}, {0, 0, 3}}};
  const std::array<Point3, 4> beneath{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, -1}}};
  const std::array<std::uint32_t, 3> three{0, 1, 2}, one{0, 0, 0};
  const auto asked = [](const std::array<Point3, 4>& of, std::span<const std::uint32_t> in_plane) {
    return Asked{of.data(), {}, 4, in_plane};
  };
  const Asked b = asked(beneath, std::span(one).first(1));
  expect_bounds_of("gjk_nearest3", AreNearest<3>{}, Pairs{above, beneath}, asked(above, three), b);
  const std::array<Point3, 4> edge{{{1, 0, 1}, {-1, 0, 1}, {0, 1, 2}, {0, 0, 3}}};
  expect_bounds_of("gjk_nearest2", AreNearest<2>{}, Pairs{edge, beneath}, asked(edge, std::span(three).first(2)), b);
  const std::array<Point3, 4> corner{{{0, 0, 1}, {1, 0, 2}, {-1, 0, 2}, {0, 0, 3}}};
  expect_bounds_of("gjk_nearest1", AreNearest<1>{}, Pairs{corner, beneath}, asked(corner, std::span(three).first(1)),
                   b);
}

/// What doubles tell, where they are certain, and integers and rational numbers.
template <class Statement, class Answer>
int told(const Statement& statement, const Answer& truth, const std::string& about, const auto&... input) {
  using namespace certify::one_lane;
  const auto floats = told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, statement, input...);
  const auto rationals = told_by_worlds<RationalWorld>(NoWorldRecorder{}, statement, input...);
  EXPECT_EQ(rationals, std::optional(truth)) << about;
  EXPECT_TRUE(!floats || *floats == truth) << about;
  EXPECT_EQ(certainly(statement, input...), truth) << about;
  return floats ? 1 : 0;
}

TEST(GjkOrigin, EachWorldTellsWhatIsSo) {
  std::array<int, 2> held{};
  for (const FamilyInfo& info : families) {
    int sure = 0;
    for (std::uint64_t i = 0; i < 100; ++i) {
      Entropy entropy(71, i);
      const std::vector<Point3> c = points3(info.family, Degeneracy::coplanar, 5, entropy);
      // Corners less the last of them: a tetrahedron of differences, which holds the origin where the corners' holds that.
      const Point3 o = c[4];
      const std::string about = std::string(info.name) + ", replay: " + std::to_string(i);
      const Pairs pairs{{c[0], c[1], c[2], c[3]}, {o, o, o, o}};
      const std::array signs{orient3d(o, c[1], c[2], c[3]), orient3d(c[0], o, c[2], c[3]),
                             orient3d(c[0], c[1], o, c[3]), orient3d(c[0], c[1], c[2], o)};
      const bool is_around =
          signs[0] != Sign::zero && signs[1] == signs[0] && signs[2] == signs[0] && signs[3] == signs[0];
      sure += told(IsAroundOrigin{}, is_around, about, pairs);
      if (info.family == Family::extreme) continue;  // distances that round to zero
      // The middle of an edge, where it is a double, is held by it.
      const Point3 middle{std::midpoint(c[0].x, c[1].x), std::midpoint(c[0].y, c[1].y), std::midpoint(c[0].z, c[1].z)};
      for (const Point3& at : {o, middle}) {
        const Pairs from{{c[0], c[1], c[2], c[3]}, {at, at, at, at}};
        const bool on_edge = distance(Segment3{c[0], c[1]}, at) == 0;
        told(HoldsOrigin<2>{}, on_edge, about, from);
        const bool is_flat = distance(Line3{c[0], {c[1].x - c[0].x, c[1].y - c[0].y, c[1].z - c[0].z}}, c[2]) == 0;
        if (info.family == Family::grid && !is_flat && c[0] != c[1]) {
          const bool on_face = distance(Triangle3{c[0], c[1], c[2]}, at) == 0;
          told(HoldsOrigin<3>{}, on_face, about, from);
          held[1] += on_face ? 1 : 0;
        }
        held[0] += on_edge ? 1 : 0;
      }
    }
    const bool is_plain = info.family == Family::uniform || info.family == Family::float32;
    EXPECT_GE(sure, is_plain ? 99 : 0) << info.name;
  }
  EXPECT_GE(held[0], 20);
  EXPECT_GE(held[1], 20);
}

}  // namespace
}  // namespace plumb::query
