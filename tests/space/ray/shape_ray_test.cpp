// Do rays at trees of shapes find what asking every shape finds?
#include "plumb/space/ray/shape_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

TEST(ShapeRay, FindsWhatEverySphereSays) {
  long hit = 0, ties = 0;
  on_shapes(971, battery::fitting(400), [&](Material& m) {
    std::vector<Sphere3> shapes;
    std::vector<Aabb3> boxes;
    const auto is_small = [](double x) { return std::abs(x) < 0x1p1000; };
    for (std::size_t n = m.below(30); n-- > 0;) {
      const auto s = m.shape<Sphere3>();
      if (!is_small(s.center.x) || !is_small(s.center.y) || !is_small(s.center.z) || !is_small(s.radius)) continue;
      shapes.push_back(s);
      if (m.below(6) == 0) shapes.push_back(s);
    }
    for (const Sphere3& s : shapes) boxes.push_back(fit_aabb(s));
    const BoxTree tree = build_box_tree(boxes, any_options(m));
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_of(m);
      const auto parameter = [&](std::uint32_t i) { return first_hit_parameter(ray, shapes[i]); };
      std::vector<TrueHit> expected;
      for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (auto t = parameter(i)) expected.push_back({i, *t});
      }
      std::stable_sort(expected.begin(), expected.end(), [](const TrueHit& a, const TrueHit& b) { return a.t < b.t; });
      const auto first = first_hit(tree, ray, parameter);
      const auto all = hits(tree, ray, parameter);
      const std::string about = m.about() + " " + text_of(ray);
      ASSERT_EQ(first.has_value(), !expected.empty()) << about;
      ASSERT_EQ(any_hit(tree, ray, [&](std::uint32_t i) { return parameter(i).has_value(); }), !expected.empty());
      ASSERT_EQ(all.size(), expected.size()) << about;
      for (std::size_t i = 0; i < all.size(); ++i) {
        ASSERT_EQ(all[i].item, expected[i].index) << about;
        ASSERT_EQ(all[i].parameter, expected[i].t) << about;
      }
      if (expected.empty()) continue;
      ASSERT_EQ(first->item, expected[0].index) << about;
      ++hit;
      ties += expected.size() > 1 && expected[0].t == expected[1].t;
    }
  });
  EXPECT_GT(hit, battery::fitting(200));
  EXPECT_GT(ties, battery::fitting(20));
}

TEST(ShapeRay, TakesDoublesAsParameters) {
  const std::vector<double> walls{5, 3, 3, 8};
  std::vector<Aabb3> boxes;
  for (const double x : walls) boxes.push_back({{x, -1, -1}, {x, 1, 1}});
  const BoxTree tree = build_box_tree(boxes);
  const auto wall = [&](std::uint32_t i) { return std::optional<double>(walls[i]); };
  const Ray3 ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(first_hit(tree, ray, wall)->item, 1u);
  std::vector<std::uint32_t> order;
  for (const auto& hit : hits(tree, ray, wall)) order.push_back(hit.item);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{1, 2, 0, 3}));
  EXPECT_FALSE(first_hit(BoxTree{}, ray, wall));
}

}  // namespace
}  // namespace plumb
