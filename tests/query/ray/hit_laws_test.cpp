// Do hits, first_hit, first_hit_parameter and intersects say the same, for every pair of the table
// (query/body/hit_pairs.hpp) and every degenerate form of every kind?
#include <gtest/gtest.h>

#include "plumb/query/body/hit_pairs.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/posed.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"

namespace plumb::pair_cases {
namespace {

struct Told {
  bool hits, meets;
  std::optional<double> first;  // t
  std::optional<RayParameter> parameter;
};
using Asked = Told (*)(const void* ray, const void* shape);
template <class Ray, class Shape>
Told told(const void* r, const void* s) {
  const Ray& ray = *static_cast<const Ray*>(r);
  const Shape& shape = *static_cast<const Shape*>(s);
  const auto hit = first_hit(ray, shape);
  return {hits(ray, shape), intersects(ray, shape), hit ? std::optional(hit->t) : std::nullopt,
          first_hit_parameter(ray, shape)};
}

struct ShotRow {
  FigureKind ray, shape;
  Asked ask;
};
template <class A, class B>
consteval ShotRow row() {
  if constexpr (Hittable<A, B>) {
    return {figure_kind<A>, figure_kind<B>, &told<A, B>};
  } else {
    return {figure_kind<A>, figure_kind<B>, nullptr};
  }
}
template <class A, class... Bs>
constexpr std::array<ShotRow, sizeof...(Bs)> rows_of_first{row<A, Bs>()...};
template <class... Shapes>
std::vector<ShotRow> rows(Types<Shapes...>) {
  std::vector<ShotRow> all;
  (all.insert(all.end(), rows_of_first<Shapes, Shapes...>.begin(), rows_of_first<Shapes, Shapes...>.end()), ...);
  return all;
}

/// Under one pose, which turns both by a quarter and makes them twice as large.
bool hits_posed(const AnyFigure& ray, const AnyFigure& shape) {
  if (ray.row().dimension == 2) {
    const Pose2 pose{{{{0, 2}, {-2, 0}}}, {3, 0}};
    return query::posed_first_hit_parameter("hits", {ray.view(), &pose}, {shape.view(), &pose}).has_value();
  }
  const Pose pose{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {3, 0, -1}};
  return query::posed_first_hit_parameter("hits", {ray.view(), &pose}, {shape.view(), &pose}).has_value();
}

const std::uint64_t cases_of_shot = battery::sanitized ? 4 : 32;

template <class All>
void expect_alike(All all, int dimension, std::uint64_t start) {
  int cases = 0, hit = 0;
  for (const ShotRow& shot : rows(all)) {
    if (!query::hit_pairs.answers(shot.ray, shot.shape, dimension)) continue;
    ASSERT_NE(shot.ask, nullptr) << name_of(shot.ray) << " and " << name_of(shot.shape);
    const FigureRow &of_ray = figure_row(shot.ray, dimension), &of_shape = figure_row(shot.shape, dimension);
    shape_cases::on_shapes(start++, cases_of_shot, [&](Material& m) {
      const std::size_t form = m.below(4);
      const AnyFigure shape = form == 0 ? figure(of_shape, m) : degenerate(of_shape, m);
      const AnyFigure ray = form == 1 ? degenerate(of_ray, m) : near_figure(of_ray, m);
      const std::string about = std::string(name_of(shot.ray)) + " and " + std::string(name_of(shot.shape)) + ", " +
                                pair_cases::about(m, ray, shape);
      const Told says = shot.ask(ray.shape(), shape.shape());
      ++cases;
      hit += says.hits;
      EXPECT_EQ(says.hits, says.meets) << about;
      EXPECT_EQ(says.hits, says.first.has_value()) << about;
      EXPECT_EQ(says.hits, says.parameter.has_value()) << about;
      EXPECT_EQ(says.hits, hits_posed(ray, shape)) << "posed: " << about;
      if (says.first && says.parameter) {
        EXPECT_EQ(*says.first, says.parameter->rounded()) << about;
      }
    });
  }
  std::printf("%d of %d hit\n", hit, cases);
  EXPECT_GT(hit * 5, cases);
  EXPECT_LT(hit * 5, cases * 4);
}

TEST(HitLaws, AllThatIsAskedInThePlaneSaysTheSame) { expect_alike(Plane{}, 2, 9600); }
TEST(HitLaws, AllThatIsAskedInSpaceSaysTheSame) { expect_alike(Space{}, 3, 9700); }

TEST(HitLaws, AMeshIsHitWhereItsFirstTriangleIs) {
  int closed = 0, half_open = 0;
  shape_cases::on_shapes(9800, 400, [&](Material& m) {
    const auto mesh = m.shape<TriangleMesh>();
    const Segment3 segment{m.probe3(), m.probe3()};
    for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
      const bool hits_mesh = hits(segment, mesh, rule);
      EXPECT_EQ(hits_mesh, first_hit(segment, mesh, rule).has_value()) << m.about(segment);
      (rule == HitRule::closed ? closed : half_open) += hits_mesh;
    }
  });
  EXPECT_GT(closed, half_open);
  EXPECT_GT(half_open, 20);
}

}  // namespace
}  // namespace plumb::pair_cases
