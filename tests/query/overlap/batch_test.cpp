// One against many, in lanes, against the same question asked one by one.
#include "plumb/query/overlap/batch.hpp"

#include <cmath>

#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/overlap/relation_counts.hpp"

namespace plumb {
namespace {

using shape_cases::Material;

TEST(OverlapBatch, OneBoxAgainstManyTrianglesIsTheScalarAnswer) {
  std::size_t meeting = 0, asked = 0;
  shape_cases::on_shapes(71, 200, [&](Material& m) {
    const auto box = m.shape<Aabb3>();
    std::vector<Triangle3> triangles(1 + m.below(40));
    for (Triangle3& t : triangles) t = near_drawn<Triangle3>(m);
    const TriangleBatch batch(triangles);
    std::vector<std::uint8_t> out(triangles.size(), 7);
    intersects(box, batch, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_EQ(out[i], intersects(triangles[i], box)) << m.about(triangles[i], box);
      meeting += out[i];
      ++asked;
    }
  });
  EXPECT_GT(meeting * 5, asked);
  EXPECT_LT(meeting * 5, asked * 4);
}

TEST(OverlapBatch, OneSegmentAgainstManyBoxesIsTheScalarAnswer) {
  std::size_t meeting = 0, asked = 0;
  shape_cases::on_shapes(72, 200, [&](Material& m) {
    const auto segment = m.shape<Segment3>();
    std::vector<Aabb3> boxes(1 + m.below(40));
    for (Aabb3& b : boxes) b = m.below(9) == 0 ? m.shape<Aabb3>() : near_drawn<Aabb3>(m);
    const BoxBatch batch(boxes);
    std::vector<std::uint8_t> out(boxes.size(), 7);
    intersects(segment, batch, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSERT_EQ(out[i], intersects(segment, boxes[i])) << m.about(segment, boxes[i]);
      meeting += out[i];
      ++asked;
    }
  });
  EXPECT_GT(meeting * 5, asked);
  EXPECT_LT(meeting * 5, asked * 4);
}

// More than one chunk, of triangles in general position, so that the lanes decide.
TEST(OverlapBatch, LongBatches) {
  Entropy entropy(73, 0);
  const auto at = [&] { return static_cast<double>(entropy.within(1000)) / 1024 + 0x1p-40; };
  std::vector<Triangle3> triangles(3001);
  for (Triangle3& t : triangles) t = {{at(), at(), at()}, {at(), at(), at()}, {at(), at(), at()}};
  const Aabb3 box{{-0.3, -0.2, -0.1}, {0.1, 0.2, 0.3}};
  std::vector<std::uint8_t> out(triangles.size());
  intersects(box, TriangleBatch(triangles), out);
  for (std::size_t i = 0; i < out.size(); ++i) ASSERT_EQ(out[i], intersects(triangles[i], box)) << i;
}

TEST(OverlapBatch, RefusesWhatIsNoQuestion) {
  const TriangleBatch none(std::span<const Triangle3>{});
  std::vector<std::uint8_t> out;
  intersects(Aabb3{{0, 0, 0}, {1, 1, 1}}, none, out);
  out.resize(1);
  EXPECT_THROW(intersects(Aabb3{{0, 0, 0}, {1, 1, 1}}, none, out), UnequalLengths);
  const BoxBatch one(std::vector{Aabb3{{0, 0, 0}, {1, 1, 1}}});
  try {
    intersects(Segment3{{0, 0, 0}, {0, std::nan(""), 0}}, one, out);
    FAIL();
  } catch (const NonFinite& e) {
    EXPECT_EQ(std::string(e.what()).rfind("intersects: one.b.y is nan", 0), 0u) << e.what();
  }
}

}  // namespace
}  // namespace plumb
