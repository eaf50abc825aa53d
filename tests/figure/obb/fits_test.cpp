// Do all boxes fitted to points, merged and moved contain what they were made of, exactly, and are they as small as
// promised?
#include "plumb/figure/obb/fits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "figure/basic/shape_cases.hpp"
#include "figure/obb/cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::shape_cases {
namespace {

using obb_cases::exact_corners;
using obb_cases::holds;

struct Fit {
  const char* name;
  Obb3 (*box)(std::span<const Point3>);
};
constexpr std::array fits{
    Fit{"principal", [](std::span<const Point3> p) { return fit_obb_principal(p); }},
    Fit{"hull vertices", [](std::span<const Point3> p) { return fit_obb_hull_vertices(p); }},
    Fit{"hull surface", [](std::span<const Point3> p) { return fit_obb_hull_surface(p); }},
    Fit{"around principal", [](std::span<const Point3> p) { return fit_obb_around_principal(p); }},
    Fit{"brute force",
        [](std::span<const Point3> p) { return fit_obb_brute_force(p, {.orientations = 4, .refinements = 6}); }},
    Fit{"minimum", [](std::span<const Point3> p) { return minimum_obb(p); }},
};

// The largest of doubles, of which differences are none, cannot always be held.
std::optional<Obb3> fitted(const Fit& fit, std::span<const Point3> points) {
  try {
    return fit.box(points);
  } catch (const BeyondDoubles&) {
    return {};
  }
}

TEST(ObbFitsTest, ContainEveryPoint) {
  int beyond = 0, all = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 24 * more; ++i) {
      Entropy entropy(411, i);
      const auto points = points3(info.family, degeneracies[i % degeneracies.size()], 1 + entropy.below(24), entropy);
      for (const Fit& fit : fits) {
        const auto box = fitted(fit, points);
        ++all;
        if (!box) {
          ++beyond;
          EXPECT_EQ(info.family == Family::extreme || info.family == Family::mixture || info.family == Family::repeated,
                    true)
              << info.name;
          continue;
        }
        for (const Point3& p : points) ASSERT_TRUE(holds(*box, p)) << fit.name << ' ' << info.name << " 411 " << i;
        ASSERT_EQ(fit.box(points), *box) << fit.name;
      }
    }
  }
  std::cout << all << " boxes, " << beyond << " beyond doubles\n";
  EXPECT_LT(beyond * 20, all);
}

TEST(ObbFitsTest, TakeEqualCollinearAndCoplanarPoints) {
  for (const double scale : {1.0, 0x1p-1060, 0x1p900}) {
    std::vector<Point3> one(5, Point3{3 * scale, -scale, 2 * scale}), line, plane;
    for (int i = 0; i < 7; ++i) line.push_back({i * scale, 2 * i * scale, -3 * i * scale});
    for (int i = 0; i < 7; ++i) {
      for (int j = 0; j < 5; ++j) plane.push_back({(i + j) * scale, (i - j) * scale, 3 * i * scale});
    }
    for (const Fit& fit : fits) {
      const Obb3 a = fit.box(one), b = fit.box(line), c = fit.box(plane);
      EXPECT_EQ(a.half, (Vector3{0, 0, 0})) << fit.name;
      EXPECT_EQ(a.center, one.front()) << fit.name;
      for (const Point3& p : line) EXPECT_TRUE(holds(b, p)) << fit.name;
      for (const Point3& p : plane) EXPECT_TRUE(holds(c, p)) << fit.name;
      const auto least = [](const Obb3& box) { return std::min({box.half.x, box.half.y, box.half.z}); };
      const auto most = [](const Obb3& box) { return std::max({box.half.x, box.half.y, box.half.z}); };
      constexpr double few = 16 * std::numeric_limits<double>::denorm_min();
      EXPECT_LE(least(b), most(b) * 0x1p-45 + few) << fit.name;
      EXPECT_LE(least(c), most(c) * 0x1p-45 + few) << fit.name;
      EXPECT_LE(b.half.x + b.half.y + b.half.z, most(b) * (1 + 0x1p-45) + few) << fit.name;
    }
  }
}

// Figure 4.10: a box along the diagonal of a flat plate's corner points, and the well-aligned one.
TEST(ObbFitsTest, AlignBoxesWithTheirContents) {
  const Obb3 plate{{5, -2, 1}, {Vector3{0.6, 0.8, 0}, Vector3{-0.8, 0.6, 0}, Vector3{0, 0, 1}}, {10, 3, 0.5}};
  const auto points = corners(plate);
  for (const Fit& fit : fits) {
    EXPECT_NEAR(volume(fit.box(points)), volume(plate), volume(plate) * 0x1p-45) << fit.name;
  }
  // A cluster of points inside turns the axes of points, but not those of the hull's surface.
  std::vector<Point3> clustered(points.begin(), points.end());
  for (int i = 0; i < 400; ++i) clustered.push_back({5 + 0.005 * i, -2, 1});
  EXPECT_GT(volume(fit_obb_principal(clustered)), volume(plate) * 1.2);
  EXPECT_NEAR(volume(fit_obb_hull_surface(clustered)), volume(plate), volume(plate) * 0x1p-40);
  EXPECT_NEAR(volume(fit_obb_hull_vertices(clustered)), volume(plate), volume(plate) * 0x1p-40);
}

TEST(ObbFitsTest, MinimumIsNoLargerThanOthers) {
  int better = 0;
  for (std::uint64_t i = 0; i < 60 * more; ++i) {
    Entropy entropy(412, i);
    const auto points = points3(Family::uniform, Degeneracy::cospherical, 4 + entropy.below(30), entropy);
    const double least = volume(minimum_obb(points));
    for (const Fit& fit : fits) {
      const double other = volume(fit.box(points));
      ASSERT_LE(least, other * (1 + 0x1p-28)) << fit.name << " 412 " << i;
      better += static_cast<int>(least < other * (1 - 0x1p-10));
    }
    // Nor than any of a thousand boxes at random, each as tight as it can be.
    for (int k = 0; k < 50; ++k) {
      const Obb3 turned = obb_cases::turned(entropy);
      ASSERT_LE(least, volume(fit_obb(turned.axes, points)) * (1 + 0x1p-28)) << "412 " << i;
    }
  }
  EXPECT_GT(better, 100);
}

// The regular tetrahedron's is the cube of which it has every other corner; a box's is the box.
TEST(ObbFitsTest, MinimumIsKnownForKnownShapes) {
  const std::array tetrahedron{Point3{1, 1, 1}, Point3{1, -1, -1}, Point3{-1, 1, -1}, Point3{-1, -1, 1}};
  EXPECT_NEAR(volume(minimum_obb(tetrahedron)), 8, 0x1p-44);
  for (std::uint64_t i = 0; i < 40; ++i) {
    Entropy entropy(413, i);
    const Obb3 box = obb_cases::turned(entropy);
    EXPECT_NEAR(volume(minimum_obb(corners(box))), volume(box), volume(box) * 0x1p-40) << i;
  }
  const std::array cube{Point3{0, 0, 0}, Point3{2, 0, 0}, Point3{0, 2, 0}, Point3{2, 2, 0},
                        Point3{0, 0, 2}, Point3{2, 0, 2}, Point3{0, 2, 2}, Point3{2, 2, 2}};
  const Obb3 exact = minimum_obb(cube);
  EXPECT_EQ(volume(exact), 8);
  EXPECT_EQ(exact.center, (Point3{1, 1, 1}));
}

// Against every edge of the hull, in rationals.
TEST(ObbFitsTest, RectanglesAreSmallest) {
  std::uint64_t beyond = 0;
  for (const FamilyInfo& info : families) {
    if (info.family == Family::extreme || info.family == Family::mixture) continue;
    for (std::uint64_t i = 0; i < 30 * more; ++i) {
      Entropy entropy(414, i);
      const auto points = points2(info.family, degeneracies[i % degeneracies.size()], 3 + entropy.below(12), entropy);
      Obb2 box;
      try {
        box = minimum_obb(points);
      } catch (const BeyondDoubles&) {  // a box around the largest doubles may need larger ones
        ++beyond;
        continue;
      }
      const Obb3 upright{
          {box.center.x, box.center.y, 0},
          {Vector3{box.axes[0].x, box.axes[0].y, 0}, Vector3{box.axes[1].x, box.axes[1].y, 0}, Vector3{0, 0, 1}},
          {box.half.x, box.half.y, 0}};
      for (const Point2& p : points) ASSERT_TRUE(holds(upright, Point3{p.x, p.y, 0})) << info.name << " 414 " << i;
      mpq_class least = -1;  // over the directions of all pairs of points, of which the hull's edges are some
      for (const Point2& a : points) {
        for (const Point2& b : points) {
          const mpq_class x = mpq_class(b.x) - mpq_class(a.x), y = mpq_class(b.y) - mpq_class(a.y);
          if (x == 0 && y == 0) continue;
          mpq_class low_u, high_u, low_v, high_v;
          bool first = true;
          for (const Point2& p : points) {
            const mpq_class u = x * mpq_class(p.x) + y * mpq_class(p.y), v = x * mpq_class(p.y) - y * mpq_class(p.x);
            if (first || u < low_u) low_u = u;
            if (first || u > high_u) high_u = u;
            if (first || v < low_v) low_v = v;
            if (first || v > high_v) high_v = v;
            first = false;
          }
          const mpq_class area = (high_u - low_u) * (high_v - low_v) / (x * x + y * y);
          if (least < 0 || area < least) least = area;
        }
      }
      if (least < 0) continue;  // all points equal
      const double length = std::hypot(box.axes[0].x, box.axes[0].y);
      const double area = 4 * box.half.x * length * box.half.y * length;
      if (!std::isfinite(area) || !std::isfinite(least.get_d())) continue;  // doubles hold the box, not its area
      // The corners of the box, and its center, which doubles hold to an ulp.
      const double around = (box.half.x + box.half.y) * length, ulp = 0x1p-50 * std::hypot(box.center.x, box.center.y);
      const double roundings = 0x1p-46 * around * around + ulp * (around + ulp);
      ASSERT_NEAR(area, least.get_d(), area * 0x1p-45 + roundings) << info.name << " 414 " << i;
    }
  }
  EXPECT_LE(beyond, more);
}

TEST(ObbFitsTest, MergesContainBoth) {
  int kept = 0, beyond = 0;
  on_shapes(415, 400, [&](Material& m) {
    const auto a = m.shape<Obb3>(), b = m.shape<Obb3>();
    try {
      const Obb3 both = merge(a, b);
      if (both == a || both == b) {
        ++kept;
        if (obb_cases::is_flat(both)) return;  // a == b, or its axes are dependent
      }
      for (const Obb3* part : {&a, &b}) {
        for (const auto& corner : exact_corners(*part)) ASSERT_TRUE(holds(both, corner)) << m.about(a, b);
      }
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  std::cout << "one held the other " << kept << ", beyond doubles " << beyond << '\n';
  EXPECT_GT(kept, 5);
  EXPECT_LT(static_cast<std::uint64_t>(beyond), 100 * more);
  // Two halves of a box give the box.
  const Obb3 left{{-1, 0, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  Obb3 right = left;
  right.center.x = 1;
  EXPECT_EQ(volume(merge(left, right)), 16);
  EXPECT_EQ(merge(left, left), left);
}

TEST(ObbFitsTest, ImagesAreContained) {
  int beyond = 0, same = 0;
  on_shapes(416, 400, [&](Material& m) {
    const auto box = m.shape<Obb3>();
    const Pose pose{{m.vector3(), m.vector3(), m.vector3()}, m.vector3()};
    try {
      const Obb3 image = transform(box, pose);
      for (const auto& corner : exact_corners(box)) {
        obb_cases::Rational3 moved = obb_cases::rational(pose.translation);
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t x = 0; x < 3; ++x) moved[x] += corner[k] * obb_cases::rational(pose.columns[k])[x];
        }
        ASSERT_TRUE(holds(image, moved)) << m.about(box);
      }
      same +=
          static_cast<int>(image.half == Vector3{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)});
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  std::cout << "the image itself " << same << ", beyond doubles " << beyond << '\n';
  EXPECT_GT(same, 20);
  EXPECT_LT(static_cast<std::uint64_t>(beyond), 150 * more);
}

// A point of the plane times a pose of the plane.
obb_cases::Rational3 image_of(const obb_cases::Rational3& p, const Pose2& pose) {
  const auto row = [&](double x, double y, double t) -> mpq_class {
    return mpq_class(x) * p[0] + mpq_class(y) * p[1] + mpq_class(t);
  };
  return {row(pose.columns[0].x, pose.columns[1].x, pose.translation.x),
          row(pose.columns[0].y, pose.columns[1].y, pose.translation.y), 0};
}

// Has a rectangle this corner of another, by the rational judge of boxes that stand on them?
bool holds_in_plane(const Obb2& box, const obb_cases::Rational3& p) {
  Obb3 standing = obb_cases::lifted(box);
  standing.axes[2] = {0, 0, 1};
  return holds(standing, p);
}

TEST(ObbFitsTest, RectanglesMergedAndMovedContainWhatTheyAreMadeOf) {
  int kept = 0, beyond = 0;
  on_shapes(418, 600, [&](Material& m) {
    const auto a = m.shape<Obb2>(), b = m.shape<Obb2>();
    const Pose2 pose{{m.vector2(), m.vector2()}, m.vector2()};
    try {
      const Obb2 both = merge(a, b);
      kept += static_cast<int>(both == a || both == b);
      if (!(both == a || both == b) || area(both) > 0) {
        for (const Obb2& part : {a, b}) {
          for (const auto& corner : exact_corners(obb_cases::lifted(part)))
            ASSERT_TRUE(holds_in_plane(both, corner)) << m.about(a, b);
        }
      }
      const Obb2 image = transform(a, pose);
      for (const auto& corner : exact_corners(obb_cases::lifted(a)))
        ASSERT_TRUE(holds_in_plane(image, image_of(corner, pose))) << m.about(a) << ' ' << m.about(image);
    } catch (const BeyondDoubles&) {
      ++beyond;
    }
  });
  std::cout << "one held the other " << kept << ", beyond doubles " << beyond << '\n';
  EXPECT_GT(kept, 5);
  EXPECT_LT(static_cast<std::uint64_t>(beyond), 150 * more);
  const Obb2 left{{-1, 0}, {Vector2{3, 4}, Vector2{-4, 3}}, {1, 1}};
  Obb2 right = left;
  right.center = {5, 8};  // two of its axes on
  EXPECT_EQ(area(merge(left, right)), 2 * area(left));
  EXPECT_EQ(merge(left, left), left);
  EXPECT_EQ(merge(left, Obb2{{-1, 0}, left.axes, {0.5, 1}}), left);
  const Pose2 quarter{{Vector2{0, 1}, Vector2{-1, 0}}, {10, 0}};
  EXPECT_EQ(transform(left, quarter), (Obb2{{10, -1}, {Vector2{-4, 3}, Vector2{-3, -4}}, {1, 1}}));
  EXPECT_EQ(oriented_box(Aabb2{{0, 0}, {2, 4}}), (Obb2{{1, 2}, {Vector2{1, 0}, Vector2{0, 1}}, {1, 2}}));
}

TEST(ObbFitsTest, MeasuresAreNearest) {
  int exact = 0;
  on_shapes(417, 600, [&](Material& m) {
    const auto box = m.shape<Obb3>();
    mpq_class truth = 8 * mpq_class(box.half.x) * mpq_class(box.half.y) * mpq_class(box.half.z);
    const auto u = obb_cases::rational(box.axes[0]), v = obb_cases::rational(box.axes[1]),
               w = obb_cases::rational(box.axes[2]);
    truth *=
        u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
    truth = abs(truth);
    const double said = volume(box);
    if (std::isinf(said)) {
      ASSERT_GT(truth, mpq_class(std::numeric_limits<double>::max())) << m.about(box);
      return;
    }
    const mpq_class off = abs(mpq_class(said) - truth);
    const double above = std::nextafter(said, std::numeric_limits<double>::infinity());
    if (std::isfinite(above)) {
      ASSERT_LE(off, abs(mpq_class(above) - truth)) << m.about(box);
    }
    if (said > 0) {
      ASSERT_LE(off, abs(mpq_class(std::nextafter(said, 0)) - truth)) << m.about(box);
    }
    exact += static_cast<int>(off == 0);
  });
  EXPECT_GT(exact, 100);
  const Obb3 box{{0, 0, 0}, {Vector3{3, 4, 0}, Vector3{-4, 3, 0}, Vector3{0, 0, 5}}, {1, 2, 3}};
  EXPECT_EQ(volume(box), 8.0 * 6 * 125);
  EXPECT_EQ(surface_area(box), 8.0 * 25 * (2 + 6 + 3));
  const Obb3 tiny{{0, 0, 0},
                  {Vector3{0x1p-600, 0, 0}, Vector3{0, 0x1p-600, 0}, Vector3{0, 0, 0x1p-600}},
                  {0x1p590, 0x1p600, 0x1p600}};
  EXPECT_EQ(surface_area(tiny), 8 * (0x1p-10 + 1 + 0x1p-10));
}

TEST(ObbFitsTest, RefuseWhatIsNoShape) {
  const std::vector<Point3> none;
  for (const Fit& fit : fits) {
    EXPECT_THROW((void)fit.box(none), InvalidShape) << fit.name;
    const std::array bad{Point3{0, 0, 0}, Point3{0, std::numeric_limits<double>::quiet_NaN(), 0}};
    EXPECT_THROW((void)fit.box(bad), NonFinite) << fit.name;
  }
  const std::array p{Point3{1, 2, 3}};
  EXPECT_THROW((void)fit_obb({Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{1, 1, 0}}, p), InvalidShape);
  EXPECT_THROW((void)fit_obb({Vector2{1, 2}, Vector2{2, 4}}, std::array{Point2{1, 2}}), InvalidShape);
  EXPECT_THROW((void)minimum_obb(std::span<const Point2>()), InvalidShape);
  EXPECT_THROW((void)oriented_box(Aabb3{{1, 0, 0}, {0, 1, 1}}), InvalidShape);
  EXPECT_THROW((void)oriented_box(Aabb2{{1, 0}, {0, 1}}), InvalidShape);
  EXPECT_THROW((void)merge(Obb2{}, Obb2{{HUGE_VAL, 0}, {}, {}}), NonFinite);
  EXPECT_THROW((void)fit_obb_surface(p, std::vector<TriangleMesh::Triangle>{{0, 0, 1}}), InvalidShape);
  EXPECT_EQ(oriented_box(Aabb3{{0, 0, 0}, {2, 4, 6}}).half, (Vector3{1, 2, 3}));
}

TEST(ObbFitsTest, MergesWhoseCornersAreBeyondDoubles) {
  const std::array<Vector3, 3> unit{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  const Obb3 a{{1.7e308, 0, 0}, unit, {2e307, 1, 1}}, b{{1.7e308, 0, 0}, unit, {2e307, .5, 2}};
  const Obb3 both = merge(a, b);
  for (const Obb3* part : {&a, &b}) {
    for (const auto& corner : exact_corners(*part)) EXPECT_TRUE(holds(both, corner));
  }
}

}  // namespace
}  // namespace plumb::shape_cases
