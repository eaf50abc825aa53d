// Do shapes that descend together, and one that asks again and again, find what each finds alone?
#include "plumb/space/coherence/grouped_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/coherence/kept_range.hpp"
#include "space/coherence/frames.hpp"

namespace plumb {
namespace {

using namespace frames;
using Numbers = std::vector<std::uint32_t>;

template <class Shape>
void expect_groups(const TriangleMesh& mesh, const Bvh& bvh, const std::vector<Shape>& shapes, VisitStamps& seen,
                   const std::string& about, std::size_t& found) {
  std::vector<Numbers> expected(shapes.size());
  std::set<std::uint32_t> any;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Triangle3 triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
      if (intersects(triangle, shapes[i])) expected[i].push_back(t), any.insert(t);
    }
    found += expected[i].size();
  }
  const std::span<const Shape> asked(shapes);
  ASSERT_EQ(grouped_meeting(bvh, asked, {.execution = Execution::serial}), expected) << about;
  ASSERT_EQ(grouped_meeting(bvh, asked), expected) << about;
  ASSERT_EQ(meeting(bvh, asked), expected) << about;
  ASSERT_EQ(meeting_any(bvh, asked, seen), Numbers(any.begin(), any.end())) << about;
}

TEST(GroupedRange, FindsWhatEachShapeMeets) {
  std::size_t boxes_found = 0, segments_found = 0;
  VisitStamps seen;
  shape_cases::on_shapes(1781, battery::fitting(200u), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(20), m.below(30));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = 1 + static_cast<std::uint32_t>(m.below(4))});
    std::vector<Aabb3> boxes;
    std::vector<Segment3> segments;
    for (std::size_t i = m.below(12); i-- > 0;) {
      Point3 a = m.probe3(), b = m.below(5) == 0 ? a : m.probe3();
      segments.push_back({a, b});
      if (m.below(12) != 0) {  // else it may be empty
        if (a.x > b.x) std::swap(a.x, b.x);
        if (a.y > b.y) std::swap(a.y, b.y);
        if (a.z > b.z) std::swap(a.z, b.z);
      }
      boxes.push_back({a, b});
    }
    expect_groups(mesh, bvh, boxes, seen, m.about(), boxes_found);
    expect_groups(mesh, bvh, segments, seen, m.about(), segments_found);
  });
  if (battery::reaches_rare) {
    EXPECT_GT(boxes_found, 2000u);
    EXPECT_GT(segments_found, 500u);
  }
}

/// A swarm of boxes that goes through a ring: the stamps come round more than once.
TEST(GroupedRange, OfSwarmsFrameByFrame) {
  const TriangleMesh mesh = meshes::ring(10);
  const Bvh bvh = build_bvh(mesh);
  VisitStamps seen;
  std::size_t found = 0;
  for (int frame = 0; frame < 600; ++frame) {
    std::vector<Aabb3> boxes;
    for (int i = 0; i < 40; ++i) {
      const double x = -2.5 + frame * 0.005 + (i % 8) * 0.0625, y = (i / 8) * 0.0625;
      boxes.push_back({{x, y, -0.5}, {x + 0.125, y + 0.125, 0.5}});
    }
    const std::span<const Aabb3> asked(boxes);
    const auto each = meeting(bvh, asked);
    std::set<std::uint32_t> any;
    for (const Numbers& numbers : each) any.insert(numbers.begin(), numbers.end());
    ASSERT_EQ(meeting_any(bvh, asked, seen), Numbers(any.begin(), any.end())) << frame;
    if (frame % 50 == 0) {
      ASSERT_EQ(grouped_meeting(bvh, asked), each) << frame;
    }
    found += any.size();
  }
  EXPECT_GT(found, 5000u);
}

/// Shapes of hard numbers, each asked where it is and a few steps on.
TEST(KeptRange, FindsWhatTheTreeFinds) {
  std::size_t by_row = 0, by_tree = 0, found = 0;
  shape_cases::on_shapes(1783, battery::fitting(80u), [&](Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 1 + m.below(20), m.below(30));
    const Bvh bvh = build_bvh(mesh, {.most_in_leaf = 1 + static_cast<std::uint32_t>(m.below(4)),
                                     .split_share = m.below(3) == 0 ? 1.0F : 0.0F});
    const double margins[] = {0, 0.5, 8, 1e308};
    KeptRange near(bvh, margins[m.below(4)]);
    const auto ask = [&](const auto& shape) {
      const Numbers numbers = near.meeting(shape);
      ASSERT_EQ(numbers, meeting(bvh, shape)) << m.about();
      ++(near.by_row() ? by_row : by_tree);
      found += numbers.size();
    };
    for (int place = 0; place < 4; ++place) {
      Point3 a = m.probe3(), b = m.probe3();
      const double radius = std::fabs(m.number());
      const int steps = static_cast<int>(m.below(5));
      for (int step = 0; step <= steps; ++step) {
        switch (m.below(4)) {
          case 0:
            ask(Segment3{a, b});
            break;
          case 1:
            ask(Aabb3{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                      {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}});
            break;
          case 2:
            ask(Sphere3{a, radius});
            break;
          default:
            ask(Capsule3{a, b, radius});
        }
        (m.below(2) == 0 ? a.x : b.y) += m.below(2) == 0 ? 0 : m.number() / 16;
        if (!is_finite(a) || !is_finite(b)) break;
      }
    }
  });
  if (!battery::reaches_rare) return;
  EXPECT_GT(by_row, 100u);
  EXPECT_GT(by_tree, 150u);
  EXPECT_GT(found, 800u);
}

TEST(KeptRange, OfABallThatRollsThroughARing) {
  TriangleMesh mesh = meshes::ring(10);
  Bvh bvh = build_bvh(mesh);
  KeptRange near(bvh);
  std::size_t rows = 0, found = 0;
  for (int frame = 0; frame < 400; ++frame) {
    const Sphere3 ball{{-1.5 + frame * 0.0078125, 0.25, 0}, 0.25};
    const Numbers numbers = near.meeting(ball);
    ASSERT_EQ(numbers, meeting(bvh, ball)) << frame;
    rows += near.by_row() ? 1 : 0, found += numbers.size();
  }
  EXPECT_GT(rows, 380u);
  EXPECT_GT(found, 100u);
  EXPECT_LT(near.row_size(), mesh.triangles.size());
  // What leaps is never kept.
  for (int leap = 0; leap < 9; ++leap) {
    (void)near.meeting(Sphere3{{leap % 2 == 0 ? 1.0 : -1.0, 0, 0}, 0.125});
    EXPECT_FALSE(near.by_row());
  }
  const Aabb3 all{{-9, -9, -9}, {9, 9, 9}};
  EXPECT_EQ(near.meeting(all).size(), mesh.triangles.size());
  for (Point3& p : mesh.vertices) p.z += 100;
  refit(bvh, mesh.vertices);
  near.forget();
  EXPECT_TRUE(near.meeting(all).empty());
  EXPECT_TRUE(near.meeting(all).empty());
  EXPECT_TRUE(near.by_row());
  EXPECT_TRUE(near.meeting(Aabb3{{1, 0, 0}, {0, 1, 1}}).empty());
  const double most = std::numeric_limits<double>::max();
  const Sphere3 world{{most, 0, 100}, most};  // which no box of doubles holds
  EXPECT_EQ(near.meeting(world), meeting(bvh, world));
  EXPECT_FALSE(near.meeting(world).empty());
  const Sphere3 negative{{0, 0, 0}, -1};
  EXPECT_EQ(text_of<InvalidShape>([&] { (void)near.meeting(negative); }),
            text_of<InvalidShape>([&] { (void)meeting(bvh, negative); }));
  EXPECT_EQ(text_of<InvalidShape>([&] { KeptRange(bvh, -1); }),
            "KeptRange: margin is -1.000000, but it must be finite and not negative");
}

TEST(GroupedRange, OfNothingAndOfNoShape) {
  const Bvh none = build_bvh(TriangleMesh{}), ring = build_bvh(meshes::ring(3));
  VisitStamps seen;
  EXPECT_TRUE(grouped_meeting(ring, std::span<const Aabb3>()).empty());
  EXPECT_TRUE(meeting_any(ring, std::span<const Segment3>(), seen).empty());
  const std::vector<Aabb3> boxes{{{-9, -9, -9}, {9, 9, 9}}, {{1, 0, 0}, {0, 1, 1}}};
  EXPECT_EQ(grouped_meeting(none, std::span<const Aabb3>(boxes)), std::vector<Numbers>(2));
  EXPECT_TRUE(meeting_any(none, std::span<const Aabb3>(boxes), seen).empty());
  EXPECT_EQ(meeting_any(ring, std::span<const Aabb3>(boxes), seen).size(), 36u);
  const std::vector<Segment3> broken{{{0, 0, 0}, {NAN, 0, 0}}};
  const std::span<const Segment3> asked(broken);
  const std::string plain = text_of<NonFinite>([&] { (void)meeting(ring, asked); });
  EXPECT_EQ(text_of<NonFinite>([&] { (void)grouped_meeting(ring, asked); }), plain);
  EXPECT_EQ(text_of<NonFinite>([&] { (void)meeting_any(ring, asked, seen); }), plain);
}

}  // namespace
}  // namespace plumb
