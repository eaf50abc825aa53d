// Clashes of many parts: are they those of asking each pair, whatever the order of parts and the number of threads, and
// is what is the same in another place asked once?
#include "plumb/world/clashes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/certify/thread_limit.hpp"

namespace plumb {
namespace {

TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return mesh;
}

/// A few shapes, many times each, on a coarse lattice: touching, overlapping, in one another, twice in one place.
std::vector<TriangleMesh> drawn_assembly(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  const std::vector<TriangleMesh> shapes{
      solids::box({0, 0, 0}, {2, 2, 2}),
      solids::box({0, 0, 0}, {6, 4, 4}),
      solids::box({0, 0, 0}, {8, 1, 1}),
      solids::voxels({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}),
      solids::turned(solids::box({0, 0, 0}, {1, 2, 3})),  // rounded, so that few of its places are exact translations
      {{{0, 0, 0}, {3, 0, 0}, {0, 3, 1}}, {{0, 1, 2}}},
      solids::torus(2, 1, 8, 5),
  };
  std::uniform_int_distribution<std::size_t> shape(0, shapes.size() - 1);
  std::uniform_int_distribution<int> place(0, 7);
  std::vector<TriangleMesh> parts;
  for (std::size_t i = 0; i < count; ++i)
    parts.push_back(moved(shapes[shape(random)], {2.0 * place(random), 2.0 * place(random), double(place(random))}));
  return parts;
}

using Words = std::map<std::pair<std::uint32_t, std::uint32_t>, Clash>;

Words all_words(const std::vector<TriangleMesh>& parts, std::optional<double> clearance) {
  std::vector<ClashPart> made;
  for (const TriangleMesh& mesh : parts) made.emplace_back(mesh);
  Words words;
  for (std::uint32_t a = 0; a < made.size(); ++a) {
    for (std::uint32_t b = a + 1; b < made.size(); ++b) {
      Clash clash = find_clash(made[a], made[b], {.clearance = clearance});
      if (clash.kind != ClashKind::apart) words.emplace(std::pair(a, b), std::move(clash));
    }
  }
  return words;
}

TEST(Clashes, AreThoseOfEachPair) {
  std::map<ClashKind, int> said;
  std::size_t asked_once = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::vector<TriangleMesh> parts = drawn_assembly(seed, 60);
    const Words expected = all_words(parts, 0.5);
    const Clashes clashes = find_clashes(parts, {.clearance = 0.5});
    ASSERT_EQ(clashes.found.size(), expected.size());
    for (const PartClash& p : clashes.found) {
      SCOPED_TRACE(std::to_string(p.a) + " " + std::to_string(p.b));
      const auto at = expected.find({p.a, p.b});
      ASSERT_NE(at, expected.end());
      const Clash& e = at->second;
      EXPECT_EQ(name_of(p.clash.kind), name_of(e.kind));
      EXPECT_EQ(p.clash.distance, e.distance);
      EXPECT_EQ(p.clash.inner, e.inner);
      EXPECT_EQ(p.clash.volume, e.volume);
      EXPECT_EQ(p.clash.meeting, e.meeting);
      ASSERT_EQ(p.clash.depth.has_value(), e.depth.has_value());
      EXPECT_TRUE(!e.depth || (p.clash.depth->lower == e.depth->lower && p.clash.depth->upper == e.depth->upper));
      ++said[p.clash.kind];
    }
    asked_once += clashes.asked - clashes.answered;
    EXPECT_TRUE(std::ranges::is_sorted(clashes.found, {}, [](const PartClash& p) { return std::pair(p.a, p.b); }));
  }
  for (const ClashKind k :
       {ClashKind::within_clearance, ClashKind::touching, ClashKind::overlapping, ClashKind::enclosed})
    EXPECT_GE(said[k], 5) << name_of(k);
  EXPECT_GE(asked_once, 20U);  // images of others
}

TEST(Clashes, DependNeitherOnOrderNorOnThreads) {
  const std::vector<TriangleMesh> parts = drawn_assembly(7, 80);
  const Clashes expected = find_clashes(parts, {.clearance = 0.5});
  std::vector<std::uint32_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(1));
  std::vector<TriangleMesh> shuffled;
  for (const std::uint32_t i : order) shuffled.push_back(parts[i]);
  for (const std::size_t threads : {1U, 2U}) {
    const ThreadLimit limit(threads);
    std::map<std::pair<std::uint32_t, std::uint32_t>, const PartClash*> found;
    const Clashes clashes = find_clashes(shuffled, {.clearance = 0.5});
    for (const PartClash& p : clashes.found) found[std::minmax(order[p.a], order[p.b])] = &p;
    ASSERT_EQ(found.size(), expected.found.size());
    EXPECT_EQ(clashes.answered, expected.answered);
    for (const PartClash& e : expected.found) {
      SCOPED_TRACE(std::to_string(e.a) + " " + std::to_string(e.b));
      ASSERT_TRUE(found.contains({e.a, e.b}));
      const PartClash& p = *found[{e.a, e.b}];
      EXPECT_EQ(p.clash.kind, e.clash.kind);
      if (e.clash.kind != ClashKind::within_clearance) {  // then it is a point of the one that is named first
        EXPECT_EQ(p.clash.place, e.clash.place);
      }
      EXPECT_EQ(p.clash.volume, e.clash.volume);
      EXPECT_EQ(p.clash.distance, e.clash.distance);
      EXPECT_EQ(p.clash.meeting.size(), e.clash.meeting.size());
    }
  }
}

TEST(Clashes, AskWhatIsAskedFor) {
  const std::vector<TriangleMesh> parts{solids::box({0, 0, 0}, {1, 1, 1}),
                                        solids::box({1.25, 0, 0}, {2, 1, 1}),
                                        solids::box({2.25, 0, 0}, {3, 1, 1}),
                                        {}};
  EXPECT_EQ(pairs_in_reach(parts).size(), 0U);
  EXPECT_EQ(pairs_in_reach(parts, 0.25), (std::vector<AskedPair>{{0, 1, {}}, {1, 2, {}}}));
  const std::vector<AskedPair> pairs{{0, 1, 0.25}, {1, 2, 0.125}};
  const Clashes clashes = find_clashes(parts, pairs);
  ASSERT_EQ(clashes.found.size(), 1U);
  EXPECT_EQ(clashes.found[0].clash.distance, 0.25);
  std::vector<double> shares;
  (void)find_clashes(parts, pairs, {.progress = [&](double share) { return shares.push_back(share), true; }});
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1);
  EXPECT_THROW((void)find_clashes(parts, pairs, {.progress = [](double) { return false; }}), Cancelled);
  EXPECT_TRUE(find_clashes({}).found.empty());
}

}  // namespace
}  // namespace plumb
