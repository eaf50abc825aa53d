// Axis-aligned boxes: exact relations in all representations, bounds that are the exact ones rounded outward once.
#include "plumb/figure/aabb/aabb.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "figure/sphere/bound_oracle.hpp"
#include "plumb/figure/aabb/climbing_aabb.hpp"
#include "plumb/figure/aabb/relation.hpp"

namespace plumb {
namespace {

using namespace bound_oracle;
using bound_oracle::Rational;  // there is also plumb::Rational
using shape_cases::Material;
using shape_cases::on_shapes;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::array<Range, 2> ranges(const Aabb2& b) { return {Range{b.min.x, b.max.x}, Range{b.min.y, b.max.y}}; }
std::array<Range, 3> ranges(const Aabb3& b) {
  return {Range{b.min.x, b.max.x}, Range{b.min.y, b.max.y}, Range{b.min.z, b.max.z}};
}
Range widths(double min, double width) { return {min, Rational(Rational(min) + abs(Rational(width)))}; }
Range center(double c, double half) {
  return {Rational(Rational(c) - abs(Rational(half))), Rational(Rational(c) + abs(Rational(half)))};
}
std::array<Range, 3> ranges(const AabbWidths3& b) {
  return {widths(b.min.x, b.widths.x), widths(b.min.y, b.widths.y), widths(b.min.z, b.widths.z)};
}
std::array<Range, 3> ranges(const AabbCenter3& b) {
  return {center(b.center.x, b.half.x), center(b.center.y, b.half.y), center(b.center.z, b.half.z)};
}

template <std::size_t n>
bool holds(const std::array<Range, n>& outer, const std::array<Range, n>& inner) {
  for (const Range& r : inner) {
    if (r.min > r.max) return true;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (outer[i].min > inner[i].min || inner[i].max > outer[i].max) return false;
  }
  return true;
}

template <class Box>
void relations_are_exact(std::uint64_t start) {
  std::map<Relation, int> count;
  int held = 0;
  on_shapes(start, 6000, [&](Material& m) {
    const auto a = m.shape<Box>(), b = m.shape<Box>();
    const Relation expected = relation(ranges(a), ranges(b));
    ++count[expected];
    ASSERT_EQ(relate(a, b), expected) << m.about(a, b);
    ASSERT_EQ(relate(b, a), expected) << m.about(a, b);
    ASSERT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about(a, b);
    ASSERT_EQ(contains(a, b), holds(ranges(a), ranges(b))) << m.about(a, b);
    held += contains(a, b);
  });
  EXPECT_GT(count[Relation::disjoint], 1000);
  EXPECT_GT(count[Relation::touching], 200);
  EXPECT_GT(count[Relation::overlapping], 500);
  EXPECT_GT(held, 100);
}

TEST(Aabb, RelationsAreExact) {
  relations_are_exact<Aabb2>(401);
  relations_are_exact<Aabb3>(402);
  relations_are_exact<AabbWidths3>(403);
  relations_are_exact<AabbCenter3>(404);
}

// Centers and half extents whose sums no double holds: the gap is a billionth of an ulp.
TEST(Aabb, RoundedSumsWouldErr) {
  const AabbCenter3 a{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(relate(a, AabbCenter3{{1, 0, 0}, {0x1p-90, 1, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(a, AabbCenter3{{1 + 0x1p-52, 0, 0}, {0x1p-52, 1, 1}}), Relation::touching);
  EXPECT_EQ(relate(a, AabbCenter3{{1 + 0x1p-52, 0, 0}, {0x1p-52 - 0x1p-105, 1, 1}}), Relation::disjoint);
  const AabbWidths3 w{{1, 0, 0}, {0x1p-80, 1, 1}};
  EXPECT_EQ(relate(w, AabbWidths3{{1, 0, 0}, {1, 1, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(w, AabbWidths3{{1 + 0x1p-52, 0, 0}, {1, 1, 1}}), Relation::disjoint);
  EXPECT_EQ(relate(Aabb3{{-1e308, 0, 0}, {1e308, 1, 1}}, Aabb3{{1e308, 0, 0}, {1.5e308, 1, 1}}), Relation::touching);
  EXPECT_TRUE(intersects(Aabb3{{-1.7e308, 0, 0}, {1.7e308, 1, 1}}, Aabb3{{1.7e308, 1, 1}, {1.7e308, 1, 1}}));
}

// A flat box within another overlaps it, in its face it touches; equal points overlap; an empty box meets nothing.
TEST(Aabb, FlatAndEmptyBoxes) {
  const Aabb3 b{{0, 0, 0}, {2, 2, 2}};
  EXPECT_EQ(relate(b, Aabb3{{1, 1, 1}, {1, 1, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(b, Aabb3{{2, 1, 1}, {2, 1, 1}}), Relation::touching);
  EXPECT_EQ(relate(b, Aabb3{{2, 1, 1}, {1, 2, 2}}), Relation::disjoint);
  const Aabb3 point{{2, 1, 1}, {2, 1, 1}};
  EXPECT_EQ(relate(point, point), Relation::overlapping);
  EXPECT_EQ(relate(Aabb2{{0, 0}, {0, 4}}, Aabb2{{-1, 2}, {1, 2}}), Relation::overlapping);
  EXPECT_TRUE(contains(point, Aabb3{{1, 1, 1}, {0, 0, 0}}));
}

std::vector<Rational3> corners(const Aabb3& b) {
  std::vector<Rational3> all;
  for (const double x : {b.min.x, b.max.x}) {
    for (const double y : {b.min.y, b.max.y}) {
      for (const double z : {b.min.z, b.max.z}) all.push_back(rational(Point3{x, y, z}));
    }
  }
  return all;
}

std::array<Range, 3> exact_box(const std::vector<Rational3>& points) {
  std::array<Range, 3> box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box[axis] = {points[0][axis], points[0][axis]};
    for (const Rational3& p : points) box[axis].add(p[axis]);
  }
  return box;
}

// Either the box is the exact one rounded outward, or a bound of the exact one is beyond all doubles, and is said to
// be.
template <class Make>
bool is_outward(const std::array<Range, 3>& exact, Make make) {
  try {
    const auto [min, max] = make();
    return is_rounded_down(min.x, exact[0].min) && is_rounded_up(max.x, exact[0].max) &&
           is_rounded_down(min.y, exact[1].min) && is_rounded_up(max.y, exact[1].max) &&
           is_rounded_down(min.z, exact[2].min) && is_rounded_up(max.z, exact[2].max);
  } catch (const BeyondDoubles&) {
    return std::ranges::any_of(exact,
                               [](const Range& r) { return is_beyond_doubles(r.min) || is_beyond_doubles(r.max); });
  }
}

// All center + sum of s_i axes_i half_i with s_i = +-1, or corner + subset sums, and a radius around them.
std::array<Range, 3> swept(const std::vector<Rational3>& points, double radius) {
  std::array<Range, 3> box = exact_box(points);
  for (Range& r : box) r = {Rational(r.min - Rational(radius)), Rational(r.max + Rational(radius))};
  return box;
}

template <std::size_t n>
std::vector<Rational3> combinations(const Rational3& from, const std::array<Rational3, n>& by, int least) {
  std::vector<Rational3> all{from};
  for (const Rational3& v : by) {
    std::vector<Rational3> next;
    for (const Rational3& p : all) {
      next.push_back(sum(p, times(least, v)));
      next.push_back(sum(p, v));
    }
    all = next;
  }
  return all;
}

TEST(Aabb, FitsAreTheExactBoxesRoundedOutward) {
  on_shapes(411, 1500, [](Material& m) {
    const auto sphere = m.shape<Sphere3>();
    ASSERT_TRUE(is_outward(swept({rational(sphere.center)}, sphere.radius), [&] { return fit_aabb(sphere); }))
        << m.about(sphere);
    const auto capsule = m.shape<Capsule3>();
    ASSERT_TRUE(is_outward(swept({rational(capsule.a), rational(capsule.b)}, capsule.radius), [&] {
      return fit_aabb(capsule);
    })) << m.about(capsule);
    const auto lozenge = m.shape<Lozenge3>();
    const auto& [e, f] = lozenge.edges;
    ASSERT_TRUE(
        is_outward(swept(combinations<2>(rational(lozenge.corner), {rational(e), rational(f)}, 0), lozenge.radius),
                   [&] { return fit_aabb(lozenge); }))
        << m.about(lozenge);
    const auto obb = m.shape<Obb3>();
    const auto& [u, v, w] = obb.axes;
    ASSERT_TRUE(is_outward(
        exact_box(combinations<3>(rational(obb.center),
                                  {times(Rational(obb.half.x), rational(u)), times(Rational(obb.half.y), rational(v)),
                                   times(Rational(obb.half.z), rational(w))},
                                  -1)),
        [&] { return fit_aabb(obb); }))
        << m.about(obb);
    const auto triangle = m.shape<Triangle3>();
    ASSERT_TRUE(is_outward(exact_box({rational(triangle.a), rational(triangle.b), rational(triangle.c)}), [&] {
      return fit_aabb(triangle);
    })) << m.about(triangle);
  });
}

Pose any_pose(Material& m) { return {{m.direction3(), m.direction3(), m.direction3()}, m.vector3()}; }

TEST(Aabb, ImagesAreTheExactBoxesRoundedOutward) {
  int beyond = 0;
  on_shapes(412, 2000, [&](Material& m) {
    Aabb3 box = m.shape<Aabb3>();
    const Pose pose = any_pose(m);
    if (box.min.x > box.max.x || box.min.y > box.max.y || box.min.z > box.max.z) {
      ASSERT_EQ(transform(box, pose), box);
      return;
    }
    std::vector<Rational3> images;
    for (const Rational3& p : corners(box)) images.push_back(image(p, pose));
    ASSERT_TRUE(is_outward(exact_box(images), [&] {
      try {
        return transform(box, pose);
      } catch (const BeyondDoubles&) {
        ++beyond;
        throw;
      }
    })) << m.about(box, pose);
    std::vector<Point3> points;
    for (std::size_t i = m.below(12) + 1; i-- > 0;) points.push_back(m.point3());
    images.clear();
    for (const Point3& p : points) images.push_back(image(rational(p), pose));
    ASSERT_TRUE(is_outward(exact_box(images), [&] { return fit_aabb(points, pose); })) << m.about(pose);
  });
  EXPECT_GT(beyond, 5);
  EXPECT_EQ(transform(Aabb2{{0, 0}, {2, 1}}, Pose2{{Vector2{0, 1}, {-1, 0}}, {10, 0}}), (Aabb2{{9, 0}, {10, 2}}));
}

TEST(Aabb, CapsReachAsTheirSupportSays) {
  EXPECT_EQ(fit_aabb(SphericalCap3{{{0, 0, 0}, 5}, {{0, 0, 1}, -3}}), (Aabb3{{-4, -4, -5}, {4, 4, -3}}));
  EXPECT_EQ(fit_aabb(SphericalCap3{{{1, 2, 3}, 5}, {{0, 0, 2}, 12}}), (Aabb3{{-4, -3, -2}, {6, 7, 6}}));
  EXPECT_EQ(fit_aabb(SphericalCap3{{{0, 0, 0}, 5}, {{3, 0, 4}, -25}}), (Aabb3{{-3, 0, -4}, {-3, 0, -4}}));
  EXPECT_THROW(static_cast<void>(fit_aabb(SphericalCap3{{{0, 0, 0}, 5}, {{0, 0, 1}, -6}})), InvalidShape);
}

TEST(Aabb, EllipsoidsLieWithin) {
  const Aabb3 b = fit_aabb(Ellipsoid3{{1, 2, 3}, {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {2, 3, 4}});
  EXPECT_EQ(b, (Aabb3{{-1, -1, -1}, {3, 5, 7}}));
  on_shapes(413, 1000, [](Material& m) {
    const auto s = m.shape<Ellipsoid3>();
    Aabb3 box;
    try {
      box = fit_aabb(s);
    } catch (const BeyondDoubles&) {
      return;
    }
    const auto reaches = [&](double bound, double c, double x, double y, double z) {
      const Rational by = abs(Rational(Rational(bound) - Rational(c)));
      const Rational a = Rational(x) * Rational(s.half.x), b2 = Rational(y) * Rational(s.half.y),
                     c2 = Rational(z) * Rational(s.half.z);
      return by * by >= a * a + b2 * b2 + c2 * c2;
    };
    const auto& [u, v, w] = s.axes;
    ASSERT_TRUE(reaches(box.min.x, s.center.x, u.x, v.x, w.x) && reaches(box.max.x, s.center.x, u.x, v.x, w.x) &&
                reaches(box.min.y, s.center.y, u.y, v.y, w.y) && reaches(box.max.z, s.center.z, u.z, v.z, w.z))
        << m.about(s);
  });
}

// On each side the disk at an end reaches r sqrt(1 - x^2 / d^2) beyond the end.
TEST(Aabb, CylindersLieWithin) {
  EXPECT_EQ(fit_aabb(Cylinder3{{0, 0, 0}, {0, 0, 4}, 1}), (Aabb3{{-1, -1, 0}, {1, 1, 4}}));
  EXPECT_EQ(fit_aabb(Cylinder3{{2, 0, 0}, {2, 0, 0}, 1}), (Aabb3{{1, -1, -1}, {3, 1, 1}}));
  int fitted = 0;
  on_shapes(415, 1000, [&](Material& m) {
    const auto s = m.shape<Cylinder3>();
    if (s.a == s.b) return;
    Aabb3 box, of_capsule;
    try {
      box = fit_aabb(s);
      of_capsule = fit_aabb(Capsule3{s.a, s.b, s.radius});
    } catch (const BeyondDoubles&) {
      return;
    }
    ++fitted;
    const Rational3 d = sum(rational(s.b), times(-1, rational(s.a)));
    const auto reaches = [&](double bound, double end, const Rational& along) {
      const Rational by = abs(Rational(Rational(bound) - Rational(end))), r(s.radius);
      return by * by * dot(d, d) >= r * r * (dot(d, d) - along * along);
    };
    ASSERT_TRUE(reaches(box.min.x, std::min(s.a.x, s.b.x), d[0]) && reaches(box.max.y, std::max(s.a.y, s.b.y), d[1]) &&
                reaches(box.max.z, std::max(s.a.z, s.b.z), d[2]))
        << m.about(s, box);
    ASSERT_TRUE(contains(of_capsule, box)) << m.about(s, box);
  });
  EXPECT_GT(fitted, 500);
}

TEST(Aabb, ConesLieWithin) {
  EXPECT_EQ(fit_aabb(Cone3{{0, 0, 4}, {0, 0, 0}, 1}), (Aabb3{{-1, -1, 0}, {1, 1, 4}}));
  EXPECT_EQ(fit_aabb(Cone3{{2, 0, 0}, {2, 0, 0}, 1}), (Aabb3{{1, -1, -1}, {3, 1, 1}}));
  on_shapes(416, 600, [](Material& m) {
    const auto s = m.shape<Cone3>();
    Aabb3 box, of_disk;
    try {
      box = fit_aabb(s);
      of_disk = fit_aabb(Cylinder3{s.base, s.apex, s.radius});
    } catch (const BeyondDoubles&) {
      return;
    }
    // What is above the least disk's bound is above the cone's, where the apex is not beyond it.
    ASSERT_TRUE(contains(of_disk, box)) << m.about(s, box);
    const Aabb3 apex{s.apex, s.apex}, base{s.base, s.base};
    ASSERT_TRUE(contains(box, apex) && contains(box, base)) << m.about(s, box);
    if (s.apex == s.base) return;
    const Rational3 d = sum(rational(s.apex), times(-1, rational(s.base)));
    const auto reaches = [&](double bound, double end, const Rational& along) {
      const Rational by = abs(Rational(Rational(bound) - Rational(end))), r(s.radius);
      return by * by * dot(d, d) >= r * r * (dot(d, d) - along * along);
    };
    ASSERT_TRUE(reaches(box.min.x, s.base.x, d[0]) && reaches(box.max.x, s.base.x, d[0]) &&
                reaches(box.min.y, s.base.y, d[1]) && reaches(box.max.z, s.base.z, d[2]))
        << m.about(s, box);
  });
}

TEST(Aabb, PolygonsAndPolyhedraAreBoxedByTheirVertices) {
  const Polygon2 outer{{{0, 0}, {4, 1}, {2, 5}}}, hole{{{1, 1}, {2, 1}, {2, 2}}};
  EXPECT_EQ(fit_aabb(outer), (Aabb2{{0, 0}, {4, 5}}));
  EXPECT_EQ(fit_aabb(HoledPolygon2{outer, {hole}}), fit_aabb(outer));
  EXPECT_EQ(fit_aabb(Quadrilateral2{{0, 0}, {1, -1}, {2, 0}, {1, 7}}), (Aabb2{{0, -1}, {2, 7}}));
  EXPECT_EQ(fit_aabb(Polygon3{{{0, 0, 1}, {4, 1, 2}, {2, 5, 3}}}), (Aabb3{{0, 0, 1}, {4, 5, 3}}));
  EXPECT_EQ(fit_aabb(Quadrilateral3{{0, 0, 1}, {1, -1, 1}, {2, 0, 1}, {1, 7, 9}}), (Aabb3{{0, -1, 1}, {2, 7, 9}}));
  const std::vector<Point3> corners{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 0, 5}};
  EXPECT_EQ(fit_aabb(convex_polyhedron(TriangleMesh{corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}})),
            (Aabb3{{0, 0, 0}, {3, 4, 5}}));
  EXPECT_EQ(fit_aabb(KDop2{Directions2({{1, 1}, {1, -1}}), {0, -1}, {2, 1}}), (Aabb2{{-0.5, -0.5}, {1.5, 1.5}}));
  EXPECT_EQ(fit_aabb(KDop2{Directions2({{1, 1}, {1, -1}}), {3, -1}, {2, 1}}), (Aabb2{{1, 1}, {-1, -1}}));
  EXPECT_THROW((void)fit_aabb(Polygon2{{{0, 0}, {1, 1}}}), InvalidShape);
  EXPECT_THROW((void)fit_aabb(HoledPolygon2{outer, {Polygon2{{{0, 0}, {1, HUGE_VAL}, {2, 2}}}}}), NonFinite);
  EXPECT_THROW((void)fit_aabb(KDop2{Directions2({{1, 1}}), {0}, {2}}), InvalidShape);
}

TEST(Aabb, MergeAndExpand) {
  on_shapes(414, 1500, [](Material& m) {
    const auto a = m.shape<Aabb3>(), b = m.shape<Aabb3>();
    const Aabb3 both = merge(a, b);
    const auto is_empty = [](const Aabb3& box) { return contains(Aabb3{{1, 1, 1}, {0, 0, 0}}, box); };
    ASSERT_TRUE(both == merge(b, a) || (is_empty(both) && is_empty(merge(b, a)))) << m.about(a, b);
    ASSERT_TRUE(contains(both, a) && contains(both, b)) << m.about(a, b);
    ASSERT_EQ(merge(a, a), a);
    const double margin = m.radius();
    Aabb3 wide;
    try {
      wide = expand(a, margin);
    } catch (const BeyondDoubles&) {
      return;
    }
    ASSERT_TRUE(contains(wide, a)) << m.about(a) << margin;
  });
  EXPECT_EQ(expand(Aabb2{{0, 0}, {1, 3}}, -1), (Aabb2{{1, 1}, {0, 2}}));
  EXPECT_EQ(expand(Aabb3{{0, 0, 0}, {1, 1, 1}}, 0x1p-80).max.x, next_up(1));
}

// A cube whose edges and faces have vertices in their middles: only neighbors across plateaus lead on.
ConvexPolyhedron3 cube_with_flat_vertices() {
  ConvexPolyhedron3 p;
  const auto at = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<std::uint32_t>(9 * x + 3 * y + z);
  };
  std::vector<std::vector<std::uint32_t>> neighbors(27);
  for (std::int64_t x = 0; x < 3; ++x) {
    for (std::int64_t y = 0; y < 3; ++y) {
      for (std::int64_t z = 0; z < 3; ++z) {
        p.mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        const auto on_surface = [](std::int64_t i, std::int64_t j, std::int64_t k) {
          return i >= 0 && j >= 0 && k >= 0 && i < 3 && j < 3 && k < 3 && !(i == 1 && j == 1 && k == 1);
        };
        if (!on_surface(x, y, z)) continue;
        for (const auto& [dx, dy, dz] :
             {std::array{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
          if (on_surface(x + dx, y + dy, z + dz)) neighbors[at(x, y, z)].push_back(at(x + dx, y + dy, z + dz));
        }
      }
    }
  }
  p.first_neighbor = {0};
  for (auto& of_one : neighbors) {
    std::ranges::sort(of_one);
    p.neighbors.insert(p.neighbors.end(), of_one.begin(), of_one.end());
    p.first_neighbor.push_back(static_cast<std::uint32_t>(p.neighbors.size()));
  }
  p.mesh.corners = {at(0, 0, 1), at(0, 1, 1), at(0, 1, 2), at(0, 0, 2)};
  p.mesh.first.push_back(4);
  return p;
}

TEST(ClimbingAabb, IsTheBoxOfAllVerticesAtEveryPose) {
  const ConvexPolyhedron3 cube = cube_with_flat_vertices();
  ClimbingAabb box(cube);
  std::vector<Point3> surface = cube.mesh.vertices;
  surface.erase(surface.begin() + 13);  // the middle
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Entropy entropy(421, i);
    const auto number = [&] { return static_cast<double>(entropy.within(2)) * (i % 3 == 0 ? 0.1 : 1); };
    Pose pose;
    for (Vector3& c : pose.columns) c = {number(), number(), number()};
    pose.translation = {number(), 0.3, 1e17};
    ASSERT_EQ(box(pose), fit_aabb(surface, pose)) << "start 421 index " << i;
  }
}

TEST(Aabb, BadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto said = [](const char* text) { return ThrowsMessage<NonFinite>(HasSubstr(text)); };
  const Aabb3 good{{0, 0, 0}, {1, 1, 1}}, far{{5, 5, 5}, {6, 6, 6}};
  for (const double bad : {nan, inf, -inf}) {
    for (const Aabb3& with :
         {Aabb3{{bad, 0, 0}, {1, 1, 1}}, Aabb3{{0, 0, 0}, {1, 1, bad}}, Aabb3{{0, bad, 0}, {1, 1, 1}}}) {
      for (const Aabb3& other : {good, far}) {
        EXPECT_THROW(static_cast<void>(relate(with, other)), NonFinite);
        EXPECT_THROW(static_cast<void>(relate(other, with)), NonFinite);
        EXPECT_THROW(static_cast<void>(intersects(with, other)), NonFinite);
        EXPECT_THROW(static_cast<void>(intersects(other, with)), NonFinite);
      }
    }
  }
  EXPECT_THAT([&] { static_cast<void>(relate(good, Aabb3{{0, nan, 0}, {1, 1, 1}})); }, said("relate: b.min.y is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(intersects(Aabb2{{0, 0}, {1, inf}}, Aabb2{{5, 5}, {6, 6}}));
      },
      said("intersects: a.max.y is inf"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(relate(AabbCenter3{{0, 0, 0}, {1, 1, nan}}, AabbCenter3{{9, 9, 9}, {1, 1, 1}}));
      },
      said("relate: a.half.z is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(fit_aabb(std::array{Point3{0, 0, 0}, Point3{0, nan, 0}}));
      },
      said("fit_aabb: points[1].y is nan"));
  EXPECT_THAT([] { static_cast<void>(fit_aabb(std::span<const Point3>())); },
              ThrowsMessage<InvalidShape>(HasSubstr("fit_aabb: no points; give at least one")));
  EXPECT_THAT(
      [] {
        static_cast<void>(fit_aabb(Sphere3{{0, 0, 0}, -1}));
      },
      ThrowsMessage<InvalidShape>(HasSubstr("sphere.radius is negative")));
  EXPECT_THAT(
      [] {
        static_cast<void>(fit_aabb(Sphere3{{1e308, 0, 0}, 1e308}));
      },
      ThrowsMessage<BeyondDoubles>(HasSubstr("fit_aabb: max.x is beyond all doubles")));
  EXPECT_THAT([] { static_cast<void>(ClimbingAabb(ConvexPolyhedron3{})); },
              ThrowsMessage<InvalidShape>(HasSubstr("the polyhedron has no faces")));
}

}  // namespace
}  // namespace plumb
