// The nearest of many against all of them compared one by one; ties, far and degenerate items, and what is refused.
#include "plumb/query/closest/batch.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "plumb/degenerate.hpp"
#include "plumb/query/closest/closest.hpp"

namespace plumb {
namespace {

template <class Item>
std::size_t first_nearest(const std::vector<Item>& items, const Point3& p) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (compare_distance(p, items[i], p, items[best]) == Sign::negative) best = i;
  }
  return best;
}

template <class Batch, class Item>
void expect_first(const std::vector<Item>& items, const Point3& p) {
  const NearestOfMany found = nearest(Batch(items), p);
  EXPECT_EQ(found.index, first_nearest(items, p));
  EXPECT_EQ(found.distance, distance(p, items[found.index]));
}

TEST(ClosestBatchTest, TheFirstOfTheNearest) {
  std::size_t ties = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    SCOPED_TRACE(testing::Message() << "start 61 index " << index);
    Entropy entropy(61, index);
    const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
    const std::size_t n = 1 + entropy.below(21);
    const std::vector<Point3> all = points3(any_family(entropy), degeneracy, n + 3, entropy);
    std::vector<Point3> points(all.begin(), all.end() - 3);
    std::vector<Segment3> segments;
    std::vector<Triangle3> triangles;
    for (std::size_t i = 0; i < n; ++i) {
      segments.push_back({all[i], all[i + 1]});
      triangles.push_back({all[i], all[i + 1], all[i + 2]});
    }
    const Point3 p = entropy.coin() ? all.back() : Point3{(all[0].x + all[1].x) / 2, all[0].y, all[0].z};
    if (!std::isfinite(p.x)) continue;
    expect_first<PointBatch>(points, p);
    expect_first<SegmentBatch>(segments, p);
    expect_first<TriangleBatch>(triangles, p);
    const std::size_t best = first_nearest(segments, p);
    for (std::size_t i = best + 1; i < n; ++i)
      ties += compare_distance(p, segments[i], p, segments[best]) == Sign::zero ? 1 : 0;
  }
  EXPECT_GT(ties, 50);
}

TEST(ClosestBatchTest, OffByTheLeast) {
  std::vector<Point3> points(100, Point3{1, 1, 1});
  points[57].x = std::nextafter(1.0, 0.0);
  points[80] = points[57];
  EXPECT_EQ(nearest(PointBatch(points), {0, 0, 0}).index, 57U);
  points[91].z = 0x1p-1074, points[91].x = points[91].y = 0;
  EXPECT_EQ(nearest(PointBatch(points), {0, 0, 0}), (NearestOfMany{91, 0x1p-1074}));
  const double most = std::numeric_limits<double>::max();
  const std::vector<Segment3> far{{{most, most, 0}, {most, 0, 0}}, {{most, 0, 0}, {most / 2, 0, 0}}};
  EXPECT_EQ(nearest(SegmentBatch(far), {-most, 0, 0}).index, 1U);
}

TEST(ClosestBatchTest, NothingIsRefusedByName) {
  EXPECT_THROW(nearest(PointBatch({}), {0, 0, 0}), InvalidShape);
  const std::vector<Segment3> bad{{}, {{0, 0, 0}, {0, std::nan(""), 0}}};
  try {
    SegmentBatch batch(bad);
    ADD_FAILURE();
  } catch (const NonFinite& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("items[1].b.y is nan"));
  }
}

TEST(ClosestBatch, SizesWhoseSixthPowersAreNoDoubles) {
  for (const double s : {1.0, 0x1p-200, 0x1p-300, 0x1p120}) {
    const std::vector<Triangle3> small{{{0, 0, 0}, {s, 0, 0}, {0, s, 0}},
                                       {{.75 * s, .25 * s, s}, {1.75 * s, .25 * s, s}, {1.75 * s, 1.25 * s, s}}};
    EXPECT_EQ(nearest(TriangleBatch(small), Point3{.25 * s, .25 * s, s}).index, 1u) << s;
  }
  for (const double s : {1.0, 0x1p172, 0x1p300, 0x1p-172}) {
    const std::vector<Triangle3> large{{{0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}},
                                       {{1.5 * s, s, .1 * s}, {2.5 * s, s, .1 * s}, {2.5 * s, 2 * s, .1 * s}}};
    EXPECT_EQ(nearest(TriangleBatch(large), Point3{s, s, .1 * s}).index, 0u) << s;
  }
}

}  // namespace
}  // namespace plumb
