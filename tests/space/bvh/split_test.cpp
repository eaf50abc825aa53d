// Do trees with spatial splits answer as trees without, each once?  And do the parts hold their triangles, certainly?
#include <gmock/gmock.h>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/poses.hpp"
#include "space/bvh/tree_check.hpp"
#include "space/bvh/tree_laws.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;
using ::testing::HasSubstr;

/// Long thin triangles that lie anyhow in a cube.
TriangleMesh needles(std::size_t n) {
  TriangleMesh mesh;
  Entropy e(4711);
  const auto number = [&] { return 100 * signed_unit_coordinate(e); };
  for (std::uint32_t i = 0; i < n; ++i) {
    const Point3 a{number(), number(), number()}, b{number(), number(), number()};
    mesh.vertices.insert(mesh.vertices.end(), {a, b, {a.x + number() / 100, a.y + number() / 100, a.z}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

Bvh split(const TriangleMesh& mesh, double share, BvhMethod method = BvhMethod::binned) {
  BvhOptions options;
  options.method = method;
  options.split_share = static_cast<float>(share);
  options.execution = Execution::serial;
  return build_bvh(mesh, options);
}

/// In rationals: is the middle of so many corners of each in a box of one of its leaves?
void expect_covered(const Bvh& bvh, const TriangleMesh& mesh, const std::string& about) {
  std::vector<std::vector<BoxNode>> leaves(mesh.triangles.size());
  for (const BoxNode& node : bvh.tree.nodes) {
    for (std::uint32_t slot = node.link; node.is_leaf() && slot < node.link + node.count; ++slot) {
      leaves[bvh.tree.items[slot]].push_back(node);
      ASSERT_EQ(bvh.triangles[slot], mesh.triangles[bvh.tree.items[slot]]) << about;
    }
  }
  const BoxFrame frame = bvh.tree.frame;
  mpq_class unit = 1;
  if (frame.exponent() > 0) unit <<= static_cast<unsigned>(frame.exponent());
  if (frame.exponent() < 0) unit >>= static_cast<unsigned>(-frame.exponent());
  const auto is_at_most = [&](float f, const mpq_class& x) {
    return std::isinf(f) ? f < 0 : mpq_class(static_cast<double>(f)) * unit <= x;
  };
  const auto is_at_least = [&](float f, const mpq_class& x) {
    return std::isinf(f) ? f > 0 : mpq_class(static_cast<double>(f)) * unit >= x;
  };
  constexpr int fine = 8;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    ASSERT_FALSE(leaves[t].empty()) << about;
    const Triangle3 s = mesh_rays::triangle_of(mesh, t);
    for (int i = 0; i <= fine; ++i) {
      for (int k = 0; i + k <= fine; ++k) {
        const auto at = [&](double a, double b, double c) {
          return mpq_class((mpq_class(a) * i + mpq_class(b) * k + mpq_class(c) * (fine - i - k)) / fine);
        };
        const mpq_class p[] = {at(s.a.x, s.b.x, s.c.x), at(s.a.y, s.b.y, s.c.y), at(s.a.z, s.b.z, s.c.z)};
        EXPECT_TRUE(std::ranges::any_of(leaves[t],
                                        [&](const BoxNode& n) {
                                          for (std::size_t j = 0; j < 3; ++j) {
                                            if (!is_at_most(n.min[j], p[j]) || !is_at_least(n.max[j], p[j]))
                                              return false;
                                          }
                                          return true;
                                        }))
            << about << " triangle " << t << " at " << i << ", " << k;
      }
    }
  }
}

struct Question {
  AnyRay ray;
  Point3 point;
  Vector3 by;
  Aabb3 box;
  Pose pose;
};

/// All that a mesh may be asked, of two meshes in one string of numbers: what differs is seen there.
template <class Mesh>
void expect_same(const Mesh& a, const Mesh& b, const Mesh& other, const Question& q, const std::string& about) {
  for (const HitRule rule : {HitRule::closed, HitRule::half_open}) {
    EXPECT_EQ(first_hit(a, q.ray, rule), first_hit(b, q.ray, rule)) << about;
    EXPECT_EQ(first_triangle(a, q.ray, rule), first_triangle(b, q.ray, rule)) << about;
    EXPECT_EQ(any_hit(a, q.ray, rule), any_hit(b, q.ray, rule)) << about;
    EXPECT_EQ(hits(a, q.ray, rule), hits(b, q.ray, rule)) << about;
    EXPECT_EQ(count_hits(a, q.ray, rule), count_hits(b, q.ray, rule)) << about;
  }
  EXPECT_EQ(locate(a, q.point), locate(b, q.point)) << about;
  EXPECT_EQ(winding_number(a, q.point), winding_number(b, q.point)) << about;
  EXPECT_EQ(closest_on_mesh(a, q.point), closest_on_mesh(b, q.point)) << about;
  for (const std::size_t k : {1U, 3U, 1000U}) {
    EXPECT_EQ(nearest_triangles(a, q.point, k), nearest_triangles(b, q.point, k)) << about << " k " << k;
  }
  if (const auto near = nearest_triangles(b, q.point, 4); !near.empty()) {
    const double d = near.back().distance;
    EXPECT_EQ(triangles_within(a, q.point, d), triangles_within(b, q.point, d)) << about;
  }
  EXPECT_EQ(meeting(a, q.box), meeting(b, q.box)) << about;
  EXPECT_EQ(intersecting_pairs(a, other), intersecting_pairs(b, other)) << about;
  EXPECT_EQ(intersecting_pairs(other, a), intersecting_pairs(other, b)) << about;
  EXPECT_EQ(count_intersecting_pairs(a, other), count_intersecting_pairs(b, other)) << about;
  EXPECT_EQ(intersecting_pairs(a), intersecting_pairs(b)) << about;
  EXPECT_EQ(count_intersecting_pairs(a), count_intersecting_pairs(b)) << about;
  EXPECT_EQ(any_intersecting_pair(a, other).has_value(), any_intersecting_pair(b, other).has_value()) << about;
  EXPECT_EQ(any_intersecting_pair(a).has_value(), any_intersecting_pair(b).has_value()) << about;
  EXPECT_EQ(closest_triangles(a, other, {.first = true}), closest_triangles(b, other, {.first = true})) << about;
  EXPECT_EQ(closest_triangles(other, a, {.first = true}), closest_triangles(other, b, {.first = true})) << about;
  const auto pairs = intersecting_pairs(b, other);
  const auto common = intersections(a, other, pairs);
  EXPECT_EQ(common.size(), pairs.size());
}

TEST(Split, AnswersAsWholeTrees) {
  on_shapes(1501, 60, [](Material& m) {
    const TriangleMesh mesh = mesh_rays::drawn_mesh(m, 14), small = mesh_rays::drawn_mesh(m, 4);
    BvhOptions options = mesh_rays::any_options(m);
    const Bvh whole = build_bvh(mesh, options), other = build_bvh(small);
    options.split_share = static_cast<float>(1 + m.below(8));
    const Bvh parts = build_bvh(mesh, options);
    const std::string about = m.about();
    EXPECT_EQ(space::broken_law(parts), "") << about;
    expect_covered(parts, mesh, about);
    for (int i = 0; i < 4; ++i) {
      const Point3 p = m.probe3(), q = m.probe3();
      const Question question{mesh_rays::ray_of(m), m.probe3(), m.vector3(), fit_aabb(Segment3{p, q}),
                              poses::integer_pose(m)};
      expect_same(parts, whole, other, question, about);
      if (i == 0) {
        expect_same(PosedMesh{parts, question.pose}, PosedMesh{whole, question.pose}, PosedMesh{other, Pose{}},
                    question, about);
        EXPECT_EQ(first_contact(parts, question.by, other), first_contact(whole, question.by, other)) << about;
        EXPECT_EQ(first_contact(other, question.by, parts), first_contact(other, question.by, whole)) << about;
      }
    }
  });
}

TEST(Split, AnswersAsBruteForceOfNeedles) {
  const TriangleMesh mesh = needles(300);
  std::vector<TrianglePair> own;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::uint32_t k = i + 1; k < mesh.triangles.size(); ++k) {
      const Relation r = relate(mesh_rays::triangle_of(mesh, i), mesh_rays::triangle_of(mesh, k));
      if (r != Relation::disjoint) own.push_back({i, k, r});
    }
  }
  for (const BvhMethod method : bvh_methods) {
    const Bvh bvh = split(mesh, 4, method);
    EXPECT_GT(bvh.triangles.size(), 2 * mesh.triangles.size()) << name_of(method);
    EXPECT_LE(bvh.triangles.size(), 5 * mesh.triangles.size()) << name_of(method);
    EXPECT_EQ(space::broken_law(bvh), "") << name_of(method);
    EXPECT_EQ(intersecting_pairs(bvh), own) << name_of(method);
    EXPECT_EQ(count_intersecting_pairs(bvh).touching + count_intersecting_pairs(bvh).overlapping, own.size());
    Entropy e(12);
    const auto number = [&] { return 100 * signed_unit_coordinate(e); };
    for (int i = 0; i < 100; ++i) {
      const AnyRay ray = Segment3{{number(), number(), number()}, mesh.vertices[e.below(mesh.vertices.size())]};
      const auto expected = mesh_rays::true_hits(ray, mesh, HitRule::closed);
      const auto found = hits(bvh, ray);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t h = 0; h < found.size(); ++h) EXPECT_EQ(found[h].index, expected[h].index);
      EXPECT_EQ(count_hits(bvh, ray), expected.size());
      const auto first = first_triangle(bvh, ray);
      EXPECT_EQ(first.value_or(no_triangle), expected.empty() ? no_triangle : expected[0].index);
    }
  }
}

TEST(Split, CoversNeedlesAndSavesArea) {
  const TriangleMesh mesh = needles(400);
  const Bvh whole = split(mesh, 0), parts = split(mesh, 2);
  EXPECT_EQ(whole.triangles.size(), mesh.triangles.size());
  expect_covered(parts, mesh, "needles");
  EXPECT_LT(cost_of(parts.tree).total(1, 0.5), 0.8 * cost_of(whole.tree).total(1, 0.5));
}

TEST(Split, IsTheSameOnAnyThreads) {
  const TriangleMesh mesh = needles(6000);
  for (const BvhMethod method : {BvhMethod::binned, BvhMethod::linear}) {
    const Bvh one = split(mesh, 0.5, method);
    for (const std::size_t threads : {1U, 2U}) {
      const ThreadLimit control(threads);
      const Bvh many = build_bvh(mesh, {.method = method, .split_share = 0.5F});
      EXPECT_TRUE(std::ranges::equal(one.tree.nodes.view(), many.tree.nodes.view()));
      EXPECT_TRUE(std::ranges::equal(one.tree.items.view(), many.tree.items.view()));
    }
  }
}

TEST(Split, MovesAndIsRebuilt) {
  TriangleMesh mesh = needles(150);
  Bvh bvh = split(mesh, 3);
  for (Point3& p : mesh.vertices) p = {p.y + 0.25, p.x, -1.5 * p.z};
  refit(bvh, mesh.vertices, Execution::serial);
  EXPECT_EQ(space::broken_law(bvh), "");
  expect_covered(bvh, mesh, "refitted");
  const auto own = intersecting_pairs(split(mesh, 0));
  EXPECT_EQ(intersecting_pairs(bvh), own);
  EXPECT_GT(rebuild_parts(bvh, 1), 0u);
  EXPECT_EQ(space::broken_law(bvh), "");
  EXPECT_EQ(intersecting_pairs(bvh), own);
  const Point3 p{1, 2, 3};
  EXPECT_EQ(nearest_triangles(bvh, p, 20), nearest_triangles(split(mesh, 0), p, 20));
}

TEST(Split, GoesToAFileWhichMustCoverItsTriangles) {
  const TriangleMesh mesh = needles(100);
  Bvh bvh = split(mesh, 3);
  const std::string path = (std::filesystem::temp_directory_path() / ("split_" + std::to_string(::getpid()))).string();
  write_bvh(path, bvh);
  const Bvh kept = map_bvh(path);
  EXPECT_TRUE(std::ranges::equal(kept.tree.nodes.view(), bvh.tree.nodes.view()));
  EXPECT_EQ(intersecting_pairs(kept), intersecting_pairs(bvh));
  std::filesystem::remove(path);

  // A leaf's box that is cut in half holds less, in half of the cases where another leaf does not.
  std::size_t refused = 0, leaves = 0;
  for (std::size_t i = 0; i < bvh.tree.nodes.size(); ++i) {
    BoxNode& node = bvh.tree.nodes.writable()[i];
    if (!node.is_leaf()) continue;
    const BoxNode before = node;
    ++leaves;
    for (std::size_t k = 0; k < 3; ++k) node.max[k] = node.min[k] + (node.max[k] - node.min[k]) / 4;
    refused += space::broken_law(bvh).empty() ? 0u : 1u;
    node = before;
  }
  EXPECT_EQ(space::broken_law(bvh), "");
  EXPECT_GT(refused, leaves * 9 / 10);

  std::vector<Bvh::Corners>& corners = bvh.triangles.writable();
  std::size_t slot = 0;
  while (std::ranges::count(bvh.tree.items.view(), bvh.tree.items[slot]) == 1) ++slot;
  std::swap(corners[slot][0], corners[slot][1]);
  EXPECT_THAT(space::broken_law(bvh), HasSubstr("has other corners in another slot"));
}

TEST(Split, RefusesSharesAndTakesNothing) {
  const auto with = [](float share) {
    return text_of<InvalidShape>([&] { (void)build_bvh(TriangleMesh{}, {.split_share = share}); });
  };
  EXPECT_THAT(with(-1), HasSubstr("build_bvh: options.split_share is -1"));
  EXPECT_THAT(with(17), HasSubstr("must lie from 0 to 16"));
  EXPECT_THAT(with(std::numeric_limits<float>::quiet_NaN()), HasSubstr("split_share is"));
  EXPECT_TRUE(split({}, 1).tree.nodes.empty());
  EXPECT_EQ(split(meshes::repeated(40), 4).triangles.size() % 40, 0u);
  EXPECT_EQ(split({{{1, 2, 3}}, {{0, 0, 0}}}, 4).triangles.size(), 1u);
}

}  // namespace
}  // namespace plumb
