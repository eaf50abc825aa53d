// Does the proof of a hull see every way in which one can be wrong?  Hulls that are broken on purpose.
#include "plumb/figure/hull/verify_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb {
namespace {

using Points = std::vector<Point3>;

std::string flaw_of(const Hull3& hull, const Points& points, const HullOptions& options = {}) {
  return verify_hull(hull, points, options).flaw;
}

const Points cube{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};

TEST(VerifyHull, NamesWhatIsWrong) {
  const Hull3 hull = convex_hull(cube);
  ASSERT_EQ(flaw_of(hull, cube), "");
  const auto broken = [&](auto change) {
    Hull3 h = hull;
    change(h);
    return flaw_of(h, cube);
  };
  EXPECT_EQ(broken([](Hull3& h) { h.dimension = 4; }), "there is no dimension 4");
  EXPECT_EQ(broken([](Hull3& h) { h.dimension = -1; }), "the dimension is -1 for 8 points");
  EXPECT_EQ(broken([](Hull3& h) { h.dimension = 2; }), "the dimension is 3, not 2");
  EXPECT_EQ(broken([](Hull3& h) { h.first.clear(); }), "the list `first` does not divide the corners");
  EXPECT_EQ(broken([](Hull3& h) { h.first.back() = 99; }), "the list `first` does not divide the corners");
  EXPECT_EQ(broken([](Hull3& h) { std::swap(h.vertices[0], h.vertices[1]); }), "the vertices are not ascending");
  EXPECT_EQ(broken([](Hull3& h) { h.vertices.back() = 8; }), "a vertex names no point");
  EXPECT_EQ(broken([](Hull3& h) { h.vertices.pop_back(); }), "face 3 has a corner that is no vertex");
  EXPECT_EQ(broken([](Hull3& h) { h.corners[2] = 4'000'000'000; }), "face 0 has a corner that is no vertex");
  EXPECT_EQ(broken([](Hull3& h) { h.first[1] = 2; }), "face 0 has 2 corners");
  EXPECT_EQ(broken([](Hull3& h) { std::rotate(h.corners.begin(), h.corners.begin() + 1, h.corners.begin() + 4); }),
            "face 0 does not start at its smallest index");
  EXPECT_EQ(broken([](Hull3& h) { std::swap_ranges(h.corners.begin(), h.corners.begin() + 4, h.corners.begin() + 4); }),
            "face 1 is out of order");
  EXPECT_EQ(broken([](Hull3& h) { std::swap(h.corners[2], h.corners[3]); }), "face 0 is not convex");
  EXPECT_EQ(broken([](Hull3& h) {
              h.corners.resize(20);
              h.first.pop_back();
            }),
            "the edge from point 5 to point 4 has a face on one side only");
}

TEST(VerifyHull, SeesPointsThatAreLeftOut) {
  Points points = cube;
  const Hull3 hull = convex_hull(points);
  points.push_back({1, 1, 2});
  EXPECT_EQ(flaw_of(hull, points), "");
  EXPECT_EQ(flaw_of(hull, points, {.all_boundary_points = true}),
            "point 8 is on the boundary and no vertex stands for it");
  points[8] = {1, 1, 2.5};
  EXPECT_TRUE(flaw_of(hull, points).starts_with("point 8 is above face "));
  points[8] = {1, 1, -0x1p-1074};
  EXPECT_TRUE(flaw_of(hull, points).starts_with("point 8 is above face "));
  points[8] = {2.5, 1, 1};
  EXPECT_EQ(flaw_of(hull, points), "point 8 lies outside");
  points[8] = {2, 2, 2};
  EXPECT_EQ(flaw_of(hull, points), "");
  std::swap(points[0], points[8]);
  points[7] = {0, 0, 0};
  EXPECT_EQ(flaw_of(convex_hull(points), points), "");
}

TEST(VerifyHull, WantsTheSmallestOfEqualPoints) {
  Points points = cube;
  points.insert(points.begin(), {-0.0, 0, 0});
  Hull3 hull = convex_hull(cube);
  for (auto& v : hull.vertices) ++v;
  for (auto& c : hull.corners) ++c;
  EXPECT_EQ(flaw_of(hull, points), "vertex 1 equals point 0, whose index is smaller");
}

TEST(VerifyHull, WantsCoplanarFacesMerged) {
  const Hull3 triangles = convex_hull(cube, {.triangulate = true});
  EXPECT_TRUE(flaw_of(triangles, cube).ends_with("are coplanar"));
  EXPECT_EQ(flaw_of(triangles, cube, {.triangulate = true}), "");
  EXPECT_EQ(flaw_of(convex_hull(cube), cube, {.triangulate = true}), "face 0 has 4 corners");
}

/// Closed surfaces of triangles whose faces may wind about.
Hull3 surface_of(std::vector<std::array<std::uint32_t, 3>> faces) {
  for (auto& f : faces) std::rotate(f.begin(), std::ranges::min_element(f), f.end());
  std::ranges::sort(faces);
  Hull3 hull;
  hull.dimension = 3;
  for (const auto& f : faces) {
    hull.corners.insert(hull.corners.end(), f.begin(), f.end());
    hull.first.push_back(static_cast<std::uint32_t>(hull.corners.size()));
  }
  hull.vertices = hull.corners;
  std::ranges::sort(hull.vertices);
  hull.vertices.erase(std::unique(hull.vertices.begin(), hull.vertices.end()), hull.vertices.end());
  return hull;
}

TEST(VerifyHull, IsNotFooledByWinding) {
  // Two apexes over a pentagram: every ridge is convex, and Euler's formula holds.
  const Points star{{0, 10, 0}, {-6, -8, 0}, {9, 3, 0}, {-9, 3, 0}, {6, -8, 0}, {0, 0, 5}, {0, 0, -5}};
  std::vector<std::array<std::uint32_t, 3>> faces;
  for (std::uint32_t i = 0; i < 5; ++i) {
    faces.push_back({i, (i + 1) % 5, 5});
    faces.push_back({(i + 1) % 5, i, 6});
  }
  EXPECT_EQ(flaw_of(surface_of(faces), star, {.triangulate = true}),
            "the rim of the faces seen from one side is not convex");
  for (auto& f : faces) std::swap(f[0], f[1]);  // inside out
  EXPECT_NE(flaw_of(surface_of(faces), star, {.triangulate = true}), "");
  EXPECT_EQ(flaw_of(convex_hull(star, {.triangulate = true}), star, {.triangulate = true}), "");

  // A tetrahedron beside another: closed, every ridge convex.
  Points two{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}};
  const auto tetrahedron = [](std::uint32_t k) {
    return std::vector<std::array<std::uint32_t, 3>>{
        {k, k + 2, k + 1}, {k, k + 1, k + 3}, {k, k + 3, k + 2}, {k + 1, k + 2, k + 3}};
  };
  auto both = tetrahedron(0);
  for (const auto& f : tetrahedron(4)) both.push_back(f);
  EXPECT_TRUE(flaw_of(surface_of(both), two).starts_with("Euler's formula does not hold"));
}

TEST(VerifyHull, InThePlaneAndOnTheLine) {
  const Points square{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {1, 1, 1}, {1, 0, 1}};
  Hull3 hull = convex_hull(square);
  EXPECT_EQ(flaw_of(hull, square), "");
  std::reverse(hull.corners.begin() + 1, hull.corners.end());
  EXPECT_EQ(flaw_of(hull, square), "no face is seen from one side");
  EXPECT_EQ(flaw_of({2, {0, 1, 2}, {0, 1, 2}, {0, 3}}, square), "its outline is not that of the points");
  EXPECT_EQ(flaw_of({2, {0, 1, 2, 3, 4}, {0, 1, 4, 0, 4, 3, 1, 2, 4, 2, 3, 4}, {0, 3, 6, 9, 12}}, square,
                    {.triangulate = true}),
            "a vertex is not extreme");
  const Points line{{1, 1, 1}, {2, 2, 2}, {0, 0, 0}};
  EXPECT_EQ(flaw_of({1, {1, 2}, {}, {0}}, line), "");
  EXPECT_EQ(flaw_of({1, {0, 1}, {}, {0}}, line), "point 2 lies outside");
  EXPECT_EQ(flaw_of({1, {0, 1, 2}, {}, {0}}, line), "it has 3 vertices, and the points lie on a line");
  EXPECT_EQ(flaw_of({1, {0, 1, 2}, {}, {0}}, line, {.all_boundary_points = true}), "");
  EXPECT_EQ(flaw_of({0, {0}, {}, {0}}, line), "the dimension is 1, not 0");
}

// One number of a hull is changed, or two are swapped: that is a flaw, always.
TEST(VerifyHull, SeesEveryChangeOfANumber) {
  int seen = 0, same = 0;
  for (const CloudInfo& cloud : clouds) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy entropy(51, i * clouds.size() + static_cast<std::uint64_t>(cloud.cloud));
      const Points points = cloud3(cloud.cloud, 8 + entropy.below(60), entropy);
      const HullOptions options{.triangulate = entropy.coin(), .all_boundary_points = entropy.coin()};
      const Hull3 hull = convex_hull(points, options);
      ASSERT_EQ(flaw_of(hull, points, options), "") << cloud.name << ", start 51, index " << i;
      Hull3 broken = hull;
      auto& list = entropy.below(3) == 0 ? broken.vertices : entropy.below(4) == 0 ? broken.first : broken.corners;
      if (list.empty()) continue;
      auto& number = list[entropy.below(list.size())];
      if (entropy.coin()) {
        number = static_cast<std::uint32_t>(entropy.below(points.size() + 1));
      } else {
        std::swap(number, list[entropy.below(list.size())]);
      }
      if (broken == hull) {
        ++same;
        continue;
      }
      EXPECT_NE(flaw_of(broken, points, options), "") << cloud.name << ", start 51, index " << i;
      ++seen;
    }
  }
  EXPECT_GE(seen, 400);
  std::cout << seen << " changes seen, " << same << " that change nothing\n";
}

// A vertex is moved inward, a face's edge is flipped, a point is taken outside: by points instead of numbers.
TEST(VerifyHull, SeesPointsThatMove) {
  int seen = 0;
  for (const Cloud cloud : {Cloud::ball, Cloud::sphere, Cloud::exact_sphere, Cloud::prism, Cloud::facets}) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      Entropy entropy(52, i * clouds.size() + static_cast<std::uint64_t>(cloud));
      Points points = cloud3(cloud, 20 + entropy.below(100), entropy);
      const Hull3 hull = convex_hull(points);
      const std::uint32_t v = hull.vertices[entropy.below(hull.vertices.size())];
      points[v] = {points[v].x * -3, points[v].y * -3, points[v].z * -3};
      if (convex_hull(points) == hull) continue;
      EXPECT_NE(flaw_of(hull, points), "") << name_of(cloud) << ", start 52, index " << i;
      ++seen;
    }
  }
  EXPECT_GE(seen, 150);
}

}  // namespace
}  // namespace plumb
