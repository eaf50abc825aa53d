// Rays, distances, shape casts and motions of a world: are they those of asking each figure by itself, ordered by exact
// numbers and then by user ids, also while bodies move?
#include "plumb/query/variant/questions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "world/drawn_body.hpp"

namespace plumb {
namespace {

using drawn_world::Drawn;

struct Member {
  Drawn drawn;
  BodyOptions options;
  BodyHandle handle;
};
/// By user id.
using Members = std::map<std::uint64_t, Member>;

struct Scene {
  CollisionWorld world{{.execution = Execution::serial}};
  Members members;
  std::uint64_t next_id = 1;

  void add(Entropy& e) {
    Member m{drawn_world::body(e), {.group = 1U << e.below(2), .user_id = next_id}, {}};
    m.handle = world.add(m.drawn.body, m.options);
    members.insert({next_id++, m});
  }
  void change(Entropy& e) {
    if (members.size() < 6 || e.below(4) == 0) return add(e);
    Member& m = std::next(members.begin(), std::ptrdiff_t(e.below(members.size())))->second;
    if (e.below(4) == 0) {
      world.remove(m.handle);
      members.erase(m.options.user_id);
      return;
    }
    const RigidPose pose = drawn_world::pose(e);
    m.drawn = m.drawn.under(pose);
    world.move(m.handle, pose);
  }
  [[nodiscard]] const AnyFigure& at(std::uint64_t id, const BodyPart& part) const {
    return members.at(id).drawn.figures.at(part.part).at(part.triangle);
  }
};

template <class Exact>
using ById = std::vector<std::pair<Exact, std::uint64_t>>;

/// The least number of each body of the mask, in order; asked(figure) is one or none.
template <class Exact, class Asked, class Less>
ById<Exact> least_of_each(const Scene& scene, std::uint32_t mask, const Asked& asked, const Less& less) {
  ById<Exact> all;
  for (const auto& [id, m] : scene.members) {
    if ((m.options.group & mask) == 0) continue;
    std::optional<Exact> least;
    for (const auto& part : m.drawn.figures) {
      for (const AnyFigure& f : part) {
        const std::optional<Exact> x = asked(f);
        if (x && (!least || less(*x, *least))) least = x;
      }
    }
    if (least) all.push_back({*least, id});
  }
  std::stable_sort(all.begin(), all.end(), [&](const auto& p, const auto& q) { return less(p.first, q.first); });
  return all;
}

AnyRay drawn_ray(Entropy& e, AnyFigure& as_figure) {
  const auto number = [&e] { return double(e.within(4)); };
  const Point3 from{number(), number(), number()}, to{number(), number(), number()};
  const Vector3 along{to.x, to.y, to.z};
  if (e.below(3) == 0) {
    as_figure = Segment3{from, to};
    return Segment3{from, to};
  }
  if (e.coin()) {
    as_figure = Ray3{from, along};
    return Ray3{from, along};
  }
  as_figure = Line3{from, along};
  return Line3{from, along};
}

struct Counts {
  int hit = 0, tied = 0, missed = 0;
};

void expect_rays(const Scene& scene, Entropy& e, Counts& counts) {
  AnyFigure line = Point3{0, 0, 0};
  const AnyRay ray = drawn_ray(e, line);
  const std::uint32_t mask = e.below(3) == 0 ? 1 : 3;
  const auto expected = least_of_each<RayParameter>(
      scene, mask,
      [&](const AnyFigure& f) { return f.kind() == FigureKind::segment ? std::nullopt : first_hit_parameter(line, f); },
      [](const RayParameter& p, const RayParameter& q) { return (p <=> q) < 0; });
  const std::vector<WorldHit> hits = scene.world.hits(ray, mask);
  ASSERT_EQ(hits.size(), expected.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    EXPECT_EQ(hits[i].user_id, expected[i].second) << i;
    EXPECT_EQ(hits[i].body, scene.members.at(hits[i].user_id).handle);
    const AnyFigure& f = scene.at(hits[i].user_id, hits[i].part);
    EXPECT_EQ(first_hit(line, f), hits[i].hit);
    EXPECT_TRUE((*first_hit_parameter(line, f) <=> expected[i].first) == 0);
    counts.tied += i > 0 && (expected[i].first <=> expected[i - 1].first) == 0 ? 1 : 0;
  }
  const auto first = scene.world.first_hit(ray, mask);
  EXPECT_EQ(first.has_value(), !hits.empty());
  EXPECT_EQ(scene.world.any_hit(ray, mask), !hits.empty());
  if (first && !hits.empty()) {
    EXPECT_EQ(*first, hits[0]);
  }
  std::optional<WorldHit> many;
  scene.world.first_hit(std::span(&ray, 1), std::span(&many, 1), mask);
  EXPECT_EQ(many, first);
  ++(hits.empty() ? counts.missed : counts.hit);
}

void expect_distances(const Scene& scene, Entropy& e, Counts& counts) {
  const AnyFigure figure = e.coin() ? AnyFigure(Point3{double(e.within(5)), double(e.within(5)), double(e.within(5))})
                                    : drawn_world::figure(e);
  const std::uint32_t mask = e.below(3) == 0 ? 2 : 3;
  const auto less = [](const ExactDistance& p, const ExactDistance& q) { return compare(p, q) == Sign::negative; };
  const auto expected = least_of_each<ExactDistance>(
      scene, mask, [&](const AnyFigure& f) { return std::optional(exact_distance(f, figure)); }, less);
  const auto expect_same = [&](const std::vector<WorldNear>& told, std::size_t size) {
    ASSERT_EQ(told.size(), size);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(told[i].user_id, expected[i].second) << i;
      EXPECT_EQ(distance(scene.at(told[i].user_id, told[i].part), figure), told[i].distance);
      EXPECT_TRUE(compare(exact_distance(scene.at(told[i].user_id, told[i].part), figure), expected[i].first) ==
                  Sign::zero);
      counts.tied += i > 0 && compare(expected[i].first, expected[i - 1].first) == Sign::zero ? 1 : 0;
    }
  };
  const std::size_t k = e.below(5);
  expect_same(scene.world.nearest(figure, k, mask), std::min(k, expected.size()));
  expect_same(scene.world.nearest(figure, 100, mask), expected.size());
  const double limit = double(e.below(4));
  const auto is_near = [&](const auto& p) { return compare(p.first, limit) != Sign::positive; };
  const auto near = std::size_t(std::count_if(expected.begin(), expected.end(), is_near));
  expect_same(scene.world.within(figure, limit, mask), near);
  EXPECT_TRUE(scene.world.within(figure, -1, mask).empty());
  ++(near == 0 ? counts.missed : counts.hit);
}

using IdPair = std::pair<std::uint64_t, std::uint64_t>;
using PairDistances = std::vector<std::pair<ExactDistance, IdPair>>;

bool is_less(const ExactDistance& p, const ExactDistance& q) { return compare(p, q) == Sign::negative; }

/// Of each two bodies that may meet the least distance of their figures, in order.
PairDistances all_pair_distances(const Scene& scene) {
  PairDistances all;
  const auto for_figures = [](const Member& m, const auto& call) {
    for (const auto& part : m.drawn.figures) {
      for (const AnyFigure& f : part) call(f);
    }
  };
  for (auto a = scene.members.begin(); a != scene.members.end(); ++a) {
    for (auto b = std::next(a); b != scene.members.end(); ++b) {
      if ((a->second.options.group & b->second.options.mask) == 0) continue;
      if ((b->second.options.group & a->second.options.mask) == 0) continue;
      std::optional<ExactDistance> least;
      for_figures(a->second, [&](const AnyFigure& p) {
        for_figures(b->second, [&](const AnyFigure& q) {
          const ExactDistance d = exact_distance(p, q);
          if (!least || is_less(d, *least)) least = d;
        });
      });
      all.push_back({*least, {a->first, b->first}});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return is_less(p.first, q.first); });
  return all;
}

void expect_pairs(const Scene& scene, const std::vector<WorldNearPair>& told, const PairDistances& expected,
                  std::size_t size, Counts& counts) {
  ASSERT_EQ(told.size(), size);
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_EQ((IdPair{told[i].id_a, told[i].id_b}), expected[i].second) << i;
    const AnyFigure &p = scene.at(told[i].id_a, told[i].part_a), &q = scene.at(told[i].id_b, told[i].part_b);
    EXPECT_EQ(distance(p, q), told[i].distance);
    EXPECT_EQ(compare(exact_distance(p, q), expected[i].first), Sign::zero);
    const bool is_tied = i > 0 && compare(expected[i].first, expected[i - 1].first) == Sign::zero;
    ++(is_tied ? counts.tied : told[i].distance > 0 ? counts.missed : counts.hit);
  }
}

TEST(WorldQuestions, NearestPairsAreThoseOfEachTwoBodies) {
  Counts counts;
  for (std::uint64_t run = 0; run < 12; ++run) {
    Entropy e(4630, run);
    Scene scene;
    for (int i = 0; i < 9; ++i) scene.add(e);
    for (int step = 0; step < 3; ++step) {
      SCOPED_TRACE("replay: Entropy(4630, " + std::to_string(run) + "), step " + std::to_string(step));
      for (int i = 0; i < 4; ++i) scene.change(e);
      const PairDistances expected = all_pair_distances(scene);
      const std::size_t k = e.below(12);
      expect_pairs(scene, scene.world.nearest_pairs(k), expected, std::min(k, expected.size()), counts);
      expect_pairs(scene, scene.world.nearest_pairs(1000), expected, expected.size(), counts);
      const double limit = double(e.below(3));
      const auto near = std::size_t(std::count_if(
          expected.begin(), expected.end(), [&](const auto& p) { return compare(p.first, limit) != Sign::positive; }));
      expect_pairs(scene, scene.world.nearest_pairs(1000, limit), expected, near, counts);
      EXPECT_TRUE(scene.world.nearest_pairs(1000, -1).empty());
      EXPECT_EQ(scene.world.check(), std::vector<std::string>());
      if (::testing::Test::HasFailure()) return;
    }
  }
  std::printf("%d meet, %d apart, %d tied\n", counts.hit, counts.missed, counts.tied);
  EXPECT_GT(counts.hit, 20);
  EXPECT_GT(counts.missed, 100);
  EXPECT_GT(counts.tied, 200);
}

// The nearest of many are found among all, whatever leaves the pair out that would be nearer.
TEST(WorldQuestions, NearestPairsOfManyBodies) {
  Entropy e(4640);
  CollisionWorld world;
  std::vector<std::pair<BodyHandle, Point3>> all;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Point3 p{double(e.within(300)), double(e.within(300)), double(e.within(300))};
    const BodyOptions options{.mask = e.below(5) == 0 ? 2U : every_group, .user_id = i};
    const BodyHandle h = world.add(Sphere3{p, double(e.below(3))}, options);
    if (options.mask == every_group) all.push_back({h, p});
  }
  world.allow_collision(all[0].first, all[1].first);
  world.set_filter([&](const BodyHandle& a, const BodyHandle& b) {
    return (world.options(a).user_id + world.options(b).user_id) % 3 != 0;
  });
  std::vector<std::pair<ExactDistance, IdPair>> expected;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const IdPair ids{world.options(all[i].first).user_id, world.options(all[j].first).user_id};
      if ((i == 0 && j == 1) || (ids.first + ids.second) % 3 == 0) continue;
      const AnyFigure &p = world.figure(all[i].first), &q = world.figure(all[j].first);
      if (distance(p, q) < 80) expected.push_back({exact_distance(p, q), ids});
    }
  }
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& p, const auto& q) { return is_less(p.first, q.first); });
  ASSERT_GT(expected.size(), 40U);
  const std::vector<WorldNearPair> told = world.nearest_pairs(40);
  ASSERT_EQ(told.size(), 40U);
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_EQ((IdPair{told[i].id_a, told[i].id_b}), expected[i].second);
}

std::optional<Root> time_of(const AnyFigure& a, const Vector3& by_a, const AnyFigure& b, const Vector3& by_b) {
  return first_contact_time(Translating<AnyFigure>{a, by_a}, Translating<AnyFigure>{b, by_b});
}
Vector3 drawn_way(Entropy& e) { return {double(e.within(5)), double(e.within(5)), double(e.within(3))}; }

void expect_casts(const Scene& scene, Entropy& e, Counts& counts) {
  const AnyFigure figure = drawn_world::figure(e).under(drawn_world::pose(e));
  const Vector3 by = drawn_way(e);
  const std::uint32_t mask = e.below(3) == 0 ? 1 : 3;
  const auto expected = least_of_each<Root>(
      scene, mask,
      [&](const AnyFigure& f) {
        return time_of(figure, by, f, {0, 0, 0});
      },
      [](const Root& p, const Root& q) { return p < q; });
  const std::vector<WorldCast> all = scene.world.contacts_along(figure, by, mask);
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].user_id, expected[i].second) << i;
    EXPECT_EQ(all[i].contact.time, expected[i].first.rounded(Rounding::down));
    EXPECT_TRUE(*time_of(figure, by, scene.at(all[i].user_id, all[i].part), {0, 0, 0}) == expected[i].first);
    counts.tied += i > 0 && expected[i].first == expected[i - 1].first ? 1 : 0;
  }
  const auto first = scene.world.first_contact(figure, by, mask);
  EXPECT_EQ(first.has_value(), !all.empty());
  if (first && !all.empty()) {
    EXPECT_EQ(*first, all[0]);
  }
  ++(all.empty() ? counts.missed : counts.hit);
}

TEST(WorldQuestions, AreThoseOfEachFigure) {
  Counts rays, distances, casts;
  for (std::uint64_t run = 0; run < 6; ++run) {
    Entropy e(4600, run);
    Scene scene;
    for (int i = 0; i < 25; ++i) scene.add(e);
    for (int step = 0; step < 15; ++step) {
      SCOPED_TRACE("replay: Entropy(4600, " + std::to_string(run) + "), step " + std::to_string(step));
      for (int i = 0; i < 3; ++i) scene.change(e);
      for (int i = 0; i < 4; ++i) expect_rays(scene, e, rays);
      expect_distances(scene, e, distances);
      expect_casts(scene, e, casts);
      if (::testing::Test::HasFailure()) return;
    }
  }
  for (const Counts& c : {rays, distances, casts}) {
    std::printf("%d hit, %d missed, %d tied\n", c.hit, c.missed, c.tied);
    EXPECT_GT(c.hit, 20);
    EXPECT_GT(c.missed, 5);
    EXPECT_GT(c.tied, 20);
  }
}

// Enough questions for a tree, and bodies that leave it.
TEST(WorldQuestions, OfManyBodiesThatMoveAreThoseOfEach) {
  Entropy e(4610);
  CollisionWorld world;
  std::vector<BodyHandle> balls;
  std::vector<Sphere3> at;
  const auto place = [&] {
    return Sphere3{{double(e.within(60)), double(e.within(60)), double(e.within(60))}, double(1 + e.below(2))};
  };
  for (std::uint64_t i = 0; i < 600; ++i) {
    at.push_back(place());
    balls.push_back(world.add(at.back(), {.user_id = i}));
  }
  int hit = 0;
  for (int step = 0; step < 600; ++step) {
    const std::size_t moved = e.below(balls.size());
    at[moved] = place();
    world.replace(balls[moved], at[moved]);
    const Point3 p{double(e.within(60)), double(e.within(60)), double(e.within(60))};
    const Vector3 along{double(e.within(9)), double(e.within(9)), double(e.within(9))};
    const Line3 line{p, along};
    std::optional<std::size_t> first, nearest;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto t = first_hit_parameter(line, at[i]);
      if (t && (!first || (*t <=> *first_hit_parameter(line, at[*first])) < 0)) first = i;
      if (!nearest || compare(exact_distance(p, at[i]), exact_distance(p, at[*nearest])) == Sign::negative) nearest = i;
    }
    const auto told = world.first_hit(line);
    ASSERT_EQ(told.has_value(), first.has_value()) << step;
    if (told) {
      EXPECT_EQ(told->user_id, *first) << step;
      ++hit;
    }
    ASSERT_EQ(world.nearest(Point3{p}).at(0).user_id, *nearest) << step;
  }
  EXPECT_GT(hit, 100);
}

TEST(WorldQuestions, MotionsMeetAtTheirExactTimesInOrder) {
  int met = 0, tied = 0;
  for (std::uint64_t run = 0; run < 40; ++run) {
    SCOPED_TRACE("replay: Entropy(4620, " + std::to_string(run) + ")");
    Entropy e(4620, run);
    Scene scene;
    for (int i = 0; i < 8; ++i) scene.add(e);
    std::vector<BodyMotion> motions;
    std::map<std::uint64_t, Vector3> by;
    for (const auto& [id, m] : scene.members) {
      if (e.below(3) == 0) continue;
      motions.push_back({m.handle, by[id] = drawn_way(e)});
    }
    std::vector<std::pair<Root, std::pair<std::uint64_t, std::uint64_t>>> expected;
    for (const auto& [id_a, a] : scene.members) {
      for (const auto& [id_b, b] : scene.members) {
        if (id_a >= id_b || (!by.contains(id_a) && !by.contains(id_b))) continue;
        const auto way = [&](std::uint64_t id) { return by.contains(id) ? by[id] : Vector3{0, 0, 0}; };
        std::optional<Root> least;
        for (const auto& part_a : a.drawn.figures) {
          for (const AnyFigure& p : part_a) {
            for (const auto& part_b : b.drawn.figures) {
              for (const AnyFigure& q : part_b) {
                const auto t = time_of(p, way(id_a), q, way(id_b));
                if (t && (!least || *t < *least)) least = t;
              }
            }
          }
        }
        if (least) expected.push_back({*least, {id_a, id_b}});
      }
    }
    std::stable_sort(expected.begin(), expected.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    const std::vector<WorldImpact> told = scene.world.first_contacts(motions);
    ASSERT_EQ(told.size(), expected.size());
    std::size_t rank = 0;
    for (std::size_t i = 0; i < told.size(); ++i) {
      const bool is_tied = i > 0 && expected[i].first == expected[i - 1].first;
      rank += i > 0 && !is_tied ? 1 : 0;
      EXPECT_EQ((std::pair{told[i].id_a, told[i].id_b}), expected[i].second) << i;
      EXPECT_EQ(told[i].contact.time, expected[i].first.rounded(Rounding::down)) << i;
      EXPECT_EQ(told[i].rank, rank) << i;
      tied += is_tied ? 1 : 0, ++met;
    }
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("%d met, %d of them at the time of another\n", met, tied);
  EXPECT_GT(met, 200);
  EXPECT_GT(tied, 50);
}

// A bullet as thin as a point through a wall as thin as a plate, at any speed; two that pass one another in mid-flight.
TEST(WorldQuestions, NothingTunnels) {
  CollisionWorld world;
  const BodyHandle bullet = world.add(Point3{0, 0, 0}, {.user_id = 1});
  world.add(Triangle3{{1e9, -1, -1}, {1e9, 1, -1}, {1e9, 0, 2}}, {.user_id = 2});
  const BodyHandle other = world.add(Point3{8, 0, 0}, {.user_id = 3});
  const std::vector<BodyMotion> motions{{bullet, {1e12, 0, 0}}, {other, {-1e12, 0, 0}}};
  const std::vector<WorldImpact> told = world.first_contacts(motions);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ((std::pair{told[0].id_a, told[0].id_b}), (std::pair<std::uint64_t, std::uint64_t>{1, 3}));
  EXPECT_EQ(told[0].contact.time, 4e-12);
  EXPECT_EQ((std::pair{told[1].id_a, told[1].id_b}), (std::pair<std::uint64_t, std::uint64_t>{1, 2}));
  EXPECT_EQ(told[1].rank, 1U);
}

TEST(WorldQuestions, BadQuestionsAreRefusedAndFiltersHold) {
  CollisionWorld world;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BodyHandle a = world.add(Sphere3{{0, 0, 0}, 1}, {.user_id = 1});
  const BodyHandle b = world.add(Sphere3{{5, 0, 0}, 1}, {.user_id = 2});
  EXPECT_THROW(static_cast<void>(world.first_hit(Ray3{{nan, 0, 0}, {1, 0, 0}})), NonFinite);
  EXPECT_THROW(static_cast<void>(world.any_hit(Ray3{{nan, 0, 0}, {1, 0, 0}})), NonFinite);
  EXPECT_THROW(static_cast<void>(world.nearest(Point3{nan, 0, 0})), NonFinite);
  EXPECT_THROW(static_cast<void>(world.within(Point3{0, 0, 0}, nan)), NonFinite);
  EXPECT_THROW(static_cast<void>(world.first_contact(Point3{0, 0, 0}, {nan, 0, 0})), NonFinite);
  const std::vector<BodyMotion> no_number{{a, {0, 0, nan}}}, twice{{a, {1, 0, 0}}, {a, {1, 0, 0}}};
  EXPECT_THROW(static_cast<void>(world.first_contacts(no_number)), NonFinite);
  EXPECT_THROW(static_cast<void>(world.first_contacts(twice)), InvalidShape);
  EXPECT_THROW(static_cast<void>(world.nearest_pairs(1, nan)), NonFinite);
  std::vector<std::optional<WorldHit>> one(1);
  EXPECT_THROW(world.first_hit(std::span<const AnyRay>(), one), UnequalLengths);
  const std::vector<BodyMotion> motion{{a, {9, 0, 0}}};
  EXPECT_EQ(world.first_contacts(motion).size(), 1U);
  world.allow_collision(a, b);
  EXPECT_TRUE(world.first_contacts(motion).empty());
  world.remove(a);
  EXPECT_THROW(static_cast<void>(world.first_contacts(motion)), StaleHandle);
  EXPECT_TRUE(world.nearest(Point3{0, 0, 0}, 3, 2).empty());
  EXPECT_EQ(world.nearest(Point3{0, 0, 0}, 3).size(), 1U);
}

}  // namespace
}  // namespace plumb
