// Closest points of any two figures: every answer has its certificate, and pairs that have formulas of their own agree.
#include "plumb/query/separation/separation.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/closest/oracle.hpp"
#include "query/closest/straight_oracle.hpp"
#include "query/separation/certificate.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/features.hpp"

namespace plumb {
namespace {

using namespace certificate;
using pair_cases::Material;
using query::NearestPair, query::WhichPair;

struct Maker {
  FigureKind kind;
  std::function<AnyFigure(Material&)> figure, near_figure;
};

template <class... S>
std::vector<Maker> makers_of(pair_cases::Types<S...>) {
  std::vector<Maker> all;
  const auto add = [&all]<class Shape>(const Shape*) {
    if constexpr (!query::has_rim<Shape>) {
      all.push_back({figure_kind<Shape>, [](Material& m) { return any(pair_cases::figure<Shape>(m)); },
                     [](Material& m) { return any(pair_cases::near_figure<Shape>(m)); }});
    }
  };
  (add(static_cast<const S*>(nullptr)), ...);
  return all;
}

std::string name_of_pair(const FigureView& a, const FigureView& b, const Material& m) {
  return std::string(name_of(a.kind)) + " and " + std::string(name_of(b.kind)) + m.about();
}

bool is_polygon_kind(FigureKind k) {
  return query::is_one_of(k, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon});
}

struct Seen {
  int apart = 0, meet = 0, several = 0;
};

/// The answer rounded from this pair of points, both exact.
void expect_rounded(const FigureView& a, const FigureView& b, const NearestPair& pair, const std::string& name) {
  const Closest c = query::closest_points_of(a, b);
  const double ra = query::radius_of(a), rb = query::radius_of(b), d = query::distance_of(a, b, Asked::distance);
  const mpq_class radii = mpq_class(ra) + mpq_class(rb);
  EXPECT_EQ(c.distance, d) << name;
  if (pair.square <= radii * radii) {
    EXPECT_EQ(d, 0) << name;
    EXPECT_EQ(c.on_a, c.on_b) << name;
    return;
  }
  EXPECT_TRUE(is_nearest_distance(d, pair.square, radii)) << name << " " << d;
  EXPECT_EQ(c.feature_a, query::feature_at(a, pair.on_a, false)) << name;
  EXPECT_EQ(c.feature_b, query::feature_at(b, pair.on_b, false)) << name;
  const std::array on_a{c.on_a.x, c.on_a.y, c.on_a.z}, on_b{c.on_b.x, c.on_b.y, c.on_b.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class way = pair.on_b[k] - pair.on_a[k];
    EXPECT_TRUE(is_nearest_moved(on_a[k], pair.on_a[k], way, ra, pair.square)) << name;
    EXPECT_TRUE(is_nearest_moved(on_b[k], pair.on_b[k], -way, rb, pair.square)) << name;
  }
}

void expect_certified(const std::vector<Maker>& makers, std::uint64_t start, std::uint64_t cases) {
  Seen seen;
  for (std::size_t i = 0; i < makers.size(); ++i) {
    for (std::size_t j = i; j < makers.size(); ++j) {
      if (is_polygon_kind(makers[i].kind) || is_polygon_kind(makers[j].kind)) continue;
      shape_cases::on_shapes(start++, cases, [&](Material& m) {
        const AnyFigure first = makers[i].figure(m), second = makers[j].near_figure(m);
        const FigureView &a = first.view, &b = second.view;
        const std::string name = name_of_pair(a, b, m);
        const FlatSet set_a = query::core_of(a), set_b = query::core_of(b);
        const auto pair = query::nearest_of_cores(a, b, WhichPair::first);
        ASSERT_EQ(pair.has_value(), !set_a.points.empty() && !set_b.points.empty()) << name;
        if (!pair) {
          EXPECT_THROW((void)query::closest_points_of(a, b), InvalidShape) << name;
          EXPECT_THROW((void)query::distance_of(a, b, Asked::distance), InvalidShape) << name;
          return;
        }
        EXPECT_TRUE(are_nearest(set_a, set_b, pair->on_a, pair->on_b)) << name;
        EXPECT_EQ(sgn(pair->square) == 0, query::relate(set_a, set_b) != Relation::disjoint) << name;
        (sgn(pair->square) == 0 ? seen.meet : seen.apart) += 1;
        const auto any_pair = query::nearest_of_cores(a, b, WhichPair::any);
        EXPECT_EQ(any_pair->square, pair->square) << name;
        if (any_pair->on_a != pair->on_a) {
          ++seen.several;
          EXPECT_TRUE(are_nearest(set_a, set_b, any_pair->on_a, any_pair->on_b)) << name;
          EXPECT_TRUE(!pair->is_first || pair->on_a < any_pair->on_a) << name;
        }
        expect_rounded(a, b, *pair, name);
        EXPECT_EQ(query::closest_points_of(b, a), swapped(query::closest_points_of(a, b))) << name;
      });
    }
  }
  std::printf("%d apart, %d meet, %d of several pairs\n", seen.apart, seen.meet, seen.several);
  EXPECT_GT(seen.apart * 4, seen.meet);
  EXPECT_GT(seen.meet * 6, seen.apart);
  EXPECT_GT(seen.several * 40, seen.meet + seen.apart);
}

constexpr std::uint64_t cases_of_pair = battery::sanitized ? 1 : 5;

TEST(Separation, EveryPairOfTheSpaceHasItsCertificate) {
  expect_certified(makers_of(pair_cases::Space{}), 18'000, cases_of_pair);
}
TEST(Separation, EveryPairOfThePlaneHasItsCertificate) {
  expect_certified(makers_of(pair_cases::Plane{}), 19'000, cases_of_pair);
}

}  // namespace
}  // namespace plumb
