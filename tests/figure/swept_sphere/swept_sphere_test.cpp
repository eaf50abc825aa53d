// Capsules, lozenges and cylinders: exact relations against a minimization in rationals, bounds that hold what they are
// made of.
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figure/basic/powers_of_two.hpp"
#include "figure/sphere/bound_oracle.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb {
namespace {

using namespace bound_oracle;
using bound_oracle::Rational;  // there is also plumb::Rational
using shape_cases::Material;
using shape_cases::on_shapes;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

struct ExactCore {
  Rational3 corner;
  std::vector<Rational3> edges;
};

ExactCore exact(const Rational3& p) { return {p, {}}; }
ExactCore exact(const Capsule3& c) { return {rational(c.a), {sum(rational(c.b), times(-1, rational(c.a)))}}; }
ExactCore exact(const Capsule2& c) { return exact(Capsule3{{c.a.x, c.a.y, 0}, {c.b.x, c.b.y, 0}, c.radius}); }
ExactCore exact(const Lozenge3& l) { return {rational(l.corner), {rational(l.edges[0]), rational(l.edges[1])}}; }

// All solutions' free variables, or nothing where the system is singular.
std::optional<std::vector<Rational>> solution(std::vector<std::vector<Rational>> m) {
  const std::size_t n = m.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && m[pivot][k] == 0) ++pivot;
    if (pivot == n) return {};
    std::swap(m[k], m[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || m[i][k] == 0) continue;
      const Rational factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  std::vector<Rational> x;
  for (std::size_t k = 0; k < n; ++k) x.emplace_back(m[k][n] / m[k][k]);
  return x;
}

// The least square of |from + sum of x_i edges_i| for x_i in [0, 1]: on some face of the cube with a unique minimum.
Rational squared_distance(const ExactCore& a, const ExactCore& b) {
  const Rational3 from = sum(a.corner, times(-1, b.corner));
  std::vector<Rational3> edges = a.edges;
  for (const Rational3& e : b.edges) edges.push_back(times(-1, e));
  std::optional<Rational> least;
  std::size_t faces = 1;
  for (std::size_t i = 0; i < edges.size(); ++i) faces *= 3;
  for (std::size_t face = 0; face < faces; ++face) {
    Rational3 at = from;
    std::vector<Rational3> free;
    for (std::size_t i = 0, f = face; i < edges.size(); ++i, f /= 3) {
      if (f % 3 == 1) at = sum(at, edges[i]);
      if (f % 3 == 2) free.push_back(edges[i]);
    }
    std::vector<std::vector<Rational>> system;
    for (const Rational3& e : free) {
      std::vector<Rational> row;
      for (const Rational3& f : free) row.push_back(dot(e, f));
      row.emplace_back(-dot(e, at));
      system.push_back(row);
    }
    const auto x = solution(system);
    if (!x || !std::ranges::all_of(*x, [](const Rational& r) { return r >= 0 && r <= 1; })) continue;
    for (std::size_t i = 0; i < free.size(); ++i) at = sum(at, times((*x)[i], free[i]));
    if (!least || dot(at, at) < *least) least = dot(at, at);
  }
  return *least;
}

// Do two cores meet where all their parameters are strictly between 0 and 1?
bool interiors_meet(const ExactCore& a, const ExactCore& b) {
  const std::size_t n = a.edges.size(), all = n + b.edges.size();
  std::vector<Half> halves;
  for (std::size_t i = 0; i < all; ++i) {
    std::vector<Rational> row(all);
    row[i] = 1;
    halves.push_back({row, 1, true});
    row[i] = -1;
    halves.push_back({row, 0, true});
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Rational> row(all), opposite(all);
    for (std::size_t i = 0; i < all; ++i) {
      row[i] = i < n ? a.edges[i][axis] : Rational(-b.edges[i - n][axis]);
      opposite[i] = -row[i];
    }
    const Rational limit = b.corner[axis] - a.corner[axis];
    halves.push_back({row, limit, false});
    halves.push_back({opposite, -limit, false});
  }
  return have_point(halves, all);
}

template <class Shape>
Relation expected_relation(const Shape& a, const Shape& b) {
  const Rational reach = Rational(a.radius) + Rational(b.radius);
  const int order = cmp(squared_distance(exact(a), exact(b)), reach * reach);
  if (order != 0) return order > 0 ? Relation::disjoint : Relation::overlapping;
  return reach == 0 && interiors_meet(exact(a), exact(b)) ? Relation::overlapping : Relation::touching;
}

template <class Shape>
void relations_are_exact(std::uint64_t start, std::uint64_t cases) {
  std::map<Relation, int> count;
  on_shapes(start, cases, [&](Material& m) {
    const auto a = m.shape<Shape>();
    auto b = m.shape<Shape>();
    if (m.below(4) == 0) b.radius = m.below(2) == 0 ? 0 : b.radius / 2;
    const Relation expected = expected_relation(a, b);
    ++count[expected];
    ASSERT_EQ(relate(a, b), expected) << m.about(a, b);
    ASSERT_EQ(relate(b, a), expected) << m.about(a, b);
    ASSERT_EQ(intersects(a, b), expected != Relation::disjoint) << m.about(a, b);
  });
  EXPECT_GT(count[Relation::disjoint], static_cast<int>(cases / 20));
  EXPECT_GT(count[Relation::touching], static_cast<int>(cases / 100));
  EXPECT_GT(count[Relation::overlapping], static_cast<int>(cases / 20));
}

TEST(Capsule, RelationsAreExact) {
  relations_are_exact<Capsule2>(601, 1000);
  relations_are_exact<Capsule3>(602, 2500);
}

TEST(Capsule, RelationsAreTheSameTimesPowersOfTwo) {
  powers_of_two::expect_same_relation<Capsule3, Capsule3>(604, 300);
}

TEST(Lozenge, RelationsAreExact) { relations_are_exact<Lozenge3>(603, 350); }

// Segments side by side, crossing, end to end, and points; the gap is below the last bit of any square.
TEST(Capsule, RelationsByHand) {
  const Capsule3 x{{-1, 0, 0}, {1, 0, 0}, 0};
  EXPECT_EQ(relate(x, Capsule3{{0, -1, 0}, {0, 1, 0}, 0}), Relation::overlapping);
  EXPECT_EQ(relate(x, Capsule3{{0, 0, 0}, {0, 1, 0}, 0}), Relation::touching);
  EXPECT_EQ(relate(x, Capsule3{{1, 0, 0}, {2, 0, 0}, 0}), Relation::touching);
  EXPECT_EQ(relate(x, Capsule3{{0.5, 0, 0}, {2, 0, 0}, 0}), Relation::overlapping);
  EXPECT_EQ(relate(x, Capsule3{{0.5, 0, 0}, {0.5, 0, 0}, 0}), Relation::overlapping);
  EXPECT_EQ(relate(x, Capsule3{{-3, 3, 4}, {3, 3, 4}, 5}), Relation::touching);
  EXPECT_EQ(relate(x, Capsule3{{-3, 3, 4}, {3, 3, 4}, 5 - 0x1p-50}), Relation::disjoint);
  EXPECT_EQ(relate(Capsule3{x.a, x.b, 0x1p-100}, Capsule3{{-3, 3, 4}, {3, 3, 4}, 5}), Relation::overlapping);
  EXPECT_EQ(relate(Capsule3{{-1e308, 0, 0}, {1e308, 0, 0}, 1e308}, Capsule3{{0, -1e308, 1e308}, {0, 1e308, 1e308}, 0}),
            Relation::touching);
}

template <class Shape>
bool holds_exactly(const Shape& s, const Rational3& p, const Rational& around) {
  const Rational left = Rational(s.radius) - around;
  return left >= 0 && squared_distance(exact(s), exact(p)) <= left * left;
}

template <class Shape>
std::vector<Rational3> exact_vertices(const Shape& s) {
  const ExactCore c = exact(s);
  std::vector<Rational3> all{c.corner};
  for (const Rational3& e : c.edges) {
    for (std::size_t i = all.size(); i-- > 0;) all.push_back(sum(all[i], e));
  }
  return all;
}

std::vector<Point3> any_points(Material& m, std::size_t most) {
  std::vector<Point3> points;
  for (std::size_t i = m.below(most) + 1; i-- > 0;) points.push_back(m.point3());
  return points;
}

// Does it reach all points with this radius?
template <class Shape>
bool reaches(Shape s, double radius, const std::vector<Point3>& points) {
  s.radius = radius;
  return radius >= 0 && std::ranges::all_of(points, [&](const Point3& p) { return holds_exactly(s, rational(p), 0); });
}

TEST(SweptSphere, FitsHoldTheirPointsWithTheLeastRadius) {
  int fitted = 0;
  on_shapes(611, 500, [&](Material& m) {
    const std::vector<Point3> points = any_points(m, 12);
    try {
      const Capsule3 capsule = fit_capsule(points);
      ASSERT_TRUE(reaches(capsule, capsule.radius, points)) << m.about(capsule);
      ASSERT_FALSE(reaches(capsule, next_down(capsule.radius), points)) << m.about(capsule);
      for (const Point3& p : points) ASSERT_TRUE(contains(capsule, p)) << m.about(capsule, p);
      const Cylinder3 cylinder = fit_cylinder(points);
      for (const Point3& p : points) ASSERT_TRUE(contains(cylinder, p)) << m.about(cylinder, p);
      const Lozenge3 lozenge = fit_lozenge(points);
      ASSERT_TRUE(reaches(lozenge, lozenge.radius, points)) << m.about(lozenge);
      ASSERT_FALSE(reaches(lozenge, next_down(lozenge.radius), points)) << m.about(lozenge);
      for (const Point3& p : points) ASSERT_TRUE(contains(lozenge, p)) << m.about(lozenge, p);
      ++fitted;
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(fitted, 400);
}

TEST(SweptSphere, FitsAreTight) {
  std::vector<Point3> rod, plate;
  for (int i = 0; i <= 20; ++i) {
    rod.push_back({0.5 * i, 1.0 * i, -0.25 * i});
    for (int k = 0; k < 12; ++k) {
      const double angle = 0.5235987755982988 * k;
      plate.push_back({1.0 * i, std::cos(angle), std::sin(angle)});
    }
  }
  EXPECT_EQ(fit_capsule(rod).radius, 0);
  EXPECT_EQ(fit_cylinder(rod).radius, 0);
  const Capsule3 tube = fit_capsule(plate);
  EXPECT_NEAR(tube.radius, 1, 1e-12);
  EXPECT_NEAR(std::abs(tube.b.x - tube.a.x), 20, 1e-6);
  EXPECT_NEAR(fit_cylinder(plate).radius, 1, 1e-12);
  const Lozenge3 flat = fit_lozenge(std::array{Point3{0, 0, 0}, Point3{8, 0, 0}, Point3{8, 5, 0}, Point3{0, 5, 0}});
  EXPECT_LT(flat.radius, 1e-14);
  const Point3 p{3, 1e300, 1e-300};
  EXPECT_EQ(fit_capsule(std::array{p, p}), (Capsule3{p, p, 0}));
  EXPECT_EQ(fit_cylinder(std::array{p}), (Cylinder3{p, p, 0}));
  EXPECT_EQ(fit_lozenge(std::array{p}).radius, 0);
  const std::array far{Point3{-1.7e308, 0, 0}, Point3{1.7e308, 0, 0}, Point3{0, 1e308, 0}};
  const Capsule3 large = fit_capsule(far);
  EXPECT_TRUE(std::ranges::all_of(far, [&](const Point3& q) { return contains(large, q); }));
}

template <class Shape>
void moves_hold(std::uint64_t start, std::uint64_t cases) {
  int merged = 0, moved = 0, contained = 0;
  on_shapes(start, cases, [&](Material& m) {
    const auto a = m.shape<Shape>(), b = m.shape<Shape>();
    const auto holds = [](const Shape& outer, const Shape& inner) {
      return std::ranges::all_of(exact_vertices(inner),
                                 [&](const Rational3& v) { return holds_exactly(outer, v, Rational(inner.radius)); });
    };
    ASSERT_EQ(contains(a, b), holds(a, b)) << m.about(a, b);
    ASSERT_TRUE(contains(a, a)) << m.about(a);
    contained += contains(a, b);
    try {
      const Shape both = merge(a, b);
      ASSERT_TRUE(holds(both, a) && holds(both, b)) << m.about(a, b, both);
      if (contains(a, b)) {
        ASSERT_EQ(both, a) << m.about(a, b);
      }
      ++merged;
    } catch (const BeyondDoubles&) {
    }
    const Pose pose{{m.direction3(), m.direction3(), m.direction3()}, m.vector3()};
    try {
      const Shape image_of_a = transform(a, pose);
      for (const Rational3& v : exact_vertices(a)) {
        ASSERT_TRUE(holds_exactly(image_of_a, image(v, pose), 0)) << m.about(a, pose);
        for (const Vector3& c : pose.columns) {
          const Rational3 ahead = sum(image(v, pose), times(Rational(a.radius), rational(c)));
          ASSERT_TRUE(holds_exactly(image_of_a, ahead, 0)) << m.about(a, pose);
        }
      }
      ++moved;
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(merged, static_cast<int>(cases / 2));
  EXPECT_GT(moved, static_cast<int>(cases / 2));
  EXPECT_GT(contained, 5);
}

TEST(SweptSphere, MergedAndMovedOnesHoldWhatTheyAreMadeOf) {
  moves_hold<Capsule3>(621, 500);
  moves_hold<Lozenge3>(622, 250);
}

// In the plane: the same promises, by the rational judge of space.
TEST(SweptSphere, CapsulesOfThePlaneHoldWhatTheyAreMadeOf) {
  int fitted = 0, merged = 0, moved = 0;
  const auto raised = [](const Capsule2& c) { return Capsule3{{c.a.x, c.a.y, 0}, {c.b.x, c.b.y, 0}, c.radius}; };
  on_shapes(623, 400, [&](Material& m) {
    std::vector<Point2> points;
    std::vector<Point3> in_space;
    for (std::size_t i = 0; i <= m.below(12); ++i) {
      points.push_back(m.point2());
      in_space.push_back({points.back().x, points.back().y, 0});
    }
    const auto a = m.shape<Capsule2>(), b = m.shape<Capsule2>();
    const Pose2 pose{{m.vector2(), m.vector2()}, m.vector2()};
    const auto holds = [&](const Capsule2& outer, const Capsule2& inner) {
      return std::ranges::all_of(exact_vertices(raised(inner)), [&](const Rational3& v) {
        return holds_exactly(raised(outer), v, Rational(inner.radius));
      });
    };
    try {
      const Capsule3 around = raised(fit_capsule(points));
      ASSERT_TRUE(reaches(around, around.radius, in_space)) << m.about(around);
      ASSERT_FALSE(reaches(around, next_down(around.radius), in_space)) << m.about(around);
      ++fitted;
      const Capsule2 both = merge(a, b);
      ASSERT_TRUE(holds(both, a) && holds(both, b)) << m.about(a, b, both);
      ++merged;
      const Capsule2 image_of_a = transform(a, pose);
      const Pose in_plane{{Vector3{pose.columns[0].x, pose.columns[0].y, 0},
                           Vector3{pose.columns[1].x, pose.columns[1].y, 0}, Vector3{0, 0, 0}},
                          {pose.translation.x, pose.translation.y, 0}};
      for (const Rational3& v : exact_vertices(raised(a))) {
        for (const Vector3& c : in_plane.columns) {
          const Rational3 ahead = sum(image(v, in_plane), times(Rational(a.radius), rational(c)));
          ASSERT_TRUE(holds_exactly(raised(image_of_a), ahead, 0)) << m.about(a, image_of_a);
        }
      }
      ++moved;
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(fitted, 300);
  EXPECT_GT(merged, 250);
  EXPECT_GT(moved, 200);
  EXPECT_EQ(fit_capsule(std::array{Point2{0, 0}, Point2{3, 1}, Point2{6, 2}}).radius, 0);
  EXPECT_EQ(merge(Capsule2{{0, 0}, {4, 0}, 2}, Capsule2{{1, 1}, {1, 1}, 1}), (Capsule2{{0, 0}, {4, 0}, 2}));
  const Pose2 half{{Vector2{0.5, 0}, Vector2{0, 0.5}}, {1, 1}};  // no stretch by what is upright
  EXPECT_NEAR(transform(Capsule2{{0, 0}, {4, 0}, 2}, half).radius, 1, 1e-15);
  EXPECT_THROW((void)fit_capsule(std::span<const Point2>()), InvalidShape);
  EXPECT_THROW((void)merge(Capsule2{{0, 0}, {1, 0}, -1}, Capsule2{}), InvalidShape);
}

Rational inner(const Rational3& u, const Rational3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// Is the point within the cylinder, or within the ball where its ends are equal?
bool holds_point(const Cylinder3& c, const Rational3& p) {
  const Rational3 w = sum(p, times(-1, rational(c.a))), d = sum(rational(c.b), times(-1, rational(c.a)));
  const Rational along = inner(w, d), square = inner(d, d), r(c.radius);
  if (square == 0) return inner(w, w) <= r * r;
  return along >= 0 && along <= square && inner(w, w) * square - along * along <= r * r * square;
}

/// Points of it near to the rims of both ends: perpendicular vectors by rationals, shortened by doubles and a little.
std::vector<Rational3> rim_points(const Cylinder3& c) {
  std::vector<Rational3> points{rational(c.a), rational(c.b)};
  const Rational3 d = sum(rational(c.b), times(-1, rational(c.a)));
  for (const Rational3& u : {Rational3{1, 0, 0}, Rational3{0, 1, 0}, Rational3{0, 0, 1}, Rational3{1, 2, -3}}) {
    Rational3 v = inner(d, d) == 0 ? u : sum(times(inner(d, d), u), times(-inner(u, d), d));
    const Rational largest = std::max({Rational(abs(v[0])), Rational(abs(v[1])), Rational(abs(v[2]))});
    if (largest == 0) continue;
    v = times(Rational(1 / largest), v);
    const double length = std::sqrt(inner(v, v).get_d());
    for (const int way : {-1, 1}) {
      const Rational by = way * Rational(c.radius) * Rational(1 - 0x1p-40) / Rational(length);
      for (const Point3& end : {c.a, c.b}) points.push_back(sum(rational(end), times(by, v)));
    }
  }
  return points;
}

TEST(SweptSphere, CylindersMergedAndMovedHoldWhatTheyAreMadeOf) {
  int merged = 0, moved = 0, apart = 0, common = 0;
  on_shapes(623, 300, [&](Material& m) {
    const auto a = m.shape<Cylinder3>(), b = m.shape<Cylinder3>();
    const bool meet = std::ranges::any_of(rim_points(a), [&](const Rational3& p) { return holds_point(b, p); });
    const bool may = may_overlap(a, b);
    ASSERT_TRUE(may || !meet) << m.about(a, b);
    ASSERT_EQ(may, may_overlap(b, a)) << m.about(a, b);
    apart += !may, common += meet;
    for (const Rational3& p : rim_points(a)) ASSERT_TRUE(holds_point(a, p)) << m.about(a);
    try {
      const Cylinder3 both = merge(a, b);
      for (const Cylinder3& part : {a, b}) {
        for (const Rational3& p : rim_points(part)) ASSERT_TRUE(holds_point(both, p)) << m.about(a, b, both);
      }
      ++merged;
    } catch (const BeyondDoubles&) {
    }
    const Pose pose{{m.direction3(), m.direction3(), m.direction3()}, m.vector3()};
    try {
      const Cylinder3 image_of_a = transform(a, pose);
      for (const Rational3& p : rim_points(a)) {
        ASSERT_TRUE(holds_point(image_of_a, image(p, pose))) << m.about(a, pose, image_of_a);
      }
      ++moved;
    } catch (const BeyondDoubles&) {
    }
  });
  EXPECT_GT(merged, 200);
  EXPECT_GT(moved, 200);
  EXPECT_GT(apart, 30);
  EXPECT_GT(common, 10);
}

TEST(SweptSphere, CylindersThatMayOverlap) {
  const Cylinder3 c{{0, 0, 0}, {0, 0, 4}, 2};
  EXPECT_TRUE(may_overlap(c, Cylinder3{{0, 0, 4}, {0, 0, 5}, 1}));     // end on end
  EXPECT_FALSE(may_overlap(c, Cylinder3{{0, 0, 4.5}, {0, 0, 5}, 9}));  // their capsules meet
  EXPECT_FALSE(may_overlap(c, Cylinder3{{5, 0, 0}, {5, 0, 4}, 2}));
  EXPECT_TRUE(may_overlap(c, Cylinder3{{4, 0, 0}, {4, 0, 4}, 2}));  // side by side
  EXPECT_TRUE(may_overlap(c, Cylinder3{{0, 0, 0}, {0, 0, 0}, 0}));
}

TEST(SweptSphere, CylindersMovedByHand) {
  const Cylinder3 c{{1, 2, 3}, {1, 2, 9}, 2};
  const Pose turn{{Vector3{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {10, 0, 0}};
  EXPECT_NEAR(volume(transform(c, turn)), volume(c), volume(c) * 1e-14);
  EXPECT_EQ(merge(c, c), c);
  const Cylinder3 rod = merge(Cylinder3{{0, 0, 0}, {1, 0, 0}, 1}, Cylinder3{{5, 0, 0}, {9, 0, 0}, 1});
  EXPECT_NEAR(volume(rod), volume(Cylinder3{{0, 0, 0}, {9, 0, 0}, 1}), 1e-12);
  const Cylinder3 nested = merge(c, Cylinder3{{1, 2, 4}, {1, 2, 5}, 1});
  EXPECT_NEAR(volume(nested), volume(c), volume(c) * 1e-14);
  const Pose shear{{Vector3{1, 0, 0}, {0, 1, 0}, {1, 0, 1}}, {0, 0, 0}};  // the disks stay level, the axis leans
  const Cylinder3 leaning = transform(c, shear);
  EXPECT_NEAR(std::hypot(leaning.b.x - leaning.a.x, leaning.b.z - leaning.a.z), std::sqrt(72) + 4 * std::sqrt(0.5),
              1e-12);
  EXPECT_THAT(
      [] {
        static_cast<void>(merge(Cylinder3{{0, 0, 0}, {1, 0, 0}, -1}, Cylinder3{}));
      },
      ThrowsMessage<InvalidShape>(HasSubstr("merge: a.radius is negative")));
}

// A rotation by a right angle is exact; a merged pair of collinear capsules is one.
TEST(SweptSphere, MovesByHand) {
  const Pose turn{{Vector3{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {10, 0, 0}};
  EXPECT_EQ(transform(Capsule3{{1, 2, 3}, {4, 5, 6}, 2}, turn), (Capsule3{{8, 1, 3}, {5, 4, 6}, 2}));
  const Capsule3 both = merge(Capsule3{{0, 0, 0}, {1, 0, 0}, 1}, Capsule3{{5, 0, 0}, {9, 0, 0}, 1});
  EXPECT_NEAR(both.radius, 1, 1e-12);
  EXPECT_NEAR(volume(both), volume(Capsule3{{0, 0, 0}, {9, 0, 0}, 1}), 1e-9);
}

TEST(SweptSphere, BadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Capsule3 good{{0, 0, 0}, {1, 0, 0}, 1}, far{{0, 50, 0}, {1, 50, 0}, 1};
  const auto number = [](const char* text) { return ThrowsMessage<NonFinite>(HasSubstr(text)); };
  const auto shape = [](const char* text) { return ThrowsMessage<InvalidShape>(HasSubstr(text)); };
  for (const double bad : {nan, inf, -inf}) {
    for (const Capsule3& with : {Capsule3{{bad, 0, 0}, {1, 0, 0}, 1}, Capsule3{{0, 0, 0}, {0, bad, 0}, 1},
                                 Capsule3{{0, 0, 0}, {0, 0, 0}, bad}}) {
      for (const Capsule3& other : {good, far}) {
        EXPECT_THROW(static_cast<void>(relate(with, other)), NonFinite);
        EXPECT_THROW(static_cast<void>(relate(other, with)), NonFinite);
      }
    }
  }
  EXPECT_THAT(
      [&] {
        static_cast<void>(relate(good, Capsule3{{0, nan, 0}, {1, 0, 0}, 1}));
      },
      number("relate: b.a.y is nan"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(intersects(far, Capsule3{{0, 0, 0}, {1, 0, 0}, -1}));
      },
      shape("intersects: b.radius is negative"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(relate(Lozenge3{{0, 0, 0}, {Vector3{1, 0, 0}, {0, 0, inf}}, 1}, Lozenge3{}));
      },
      number("relate: a.edges[1].z is inf"));
  EXPECT_THAT([] { static_cast<void>(fit_lozenge(std::span<const Point3>())); }, shape("fit_lozenge: no points"));
  EXPECT_THAT(
      [&] {
        static_cast<void>(fit_capsule(std::array{Point3{0, 0, nan}}));
      },
      number("fit_capsule: points[0].z is nan"));
}

TEST(SweptSphere, CoresFarThinnerThanTheirRadii) {
  for (const auto& [thin, radius] : {std::pair{1e-308, 1.0}, std::pair{1e-300, 1e10}, std::pair{1e-290, 1e300}}) {
    const Capsule3 a{{0, 0, 0}, {thin, 0, 0}, radius}, b{{0, 0, 0}, {0, thin, 0}, radius};
    const Capsule3 both = merge(a, b);
    EXPECT_GE(both.radius, radius);
    EXPECT_LE(both.radius, radius * (1 + 0x1p-50));
    const Lozenge3 flat = merge(Lozenge3{{0, 0, 0}, {Vector3{thin, 0, 0}, Vector3{0, 0, 0}}, radius},
                                Lozenge3{{0, 0, 0}, {Vector3{0, thin, 0}, Vector3{0, 0, thin}}, radius});
    EXPECT_LE(flat.radius, radius * (1 + 0x1p-50));
  }
}

TEST(SweptSphere, ACylinderFromEndToEndOfTheDoubles) {
  constexpr double most = std::numeric_limits<double>::max();
  const std::array points{Point3{-most, 0, 0}, Point3{most, 0, 0}};
  const Cylinder3 c = fit_cylinder(points);
  for (const Point3& p : points) EXPECT_TRUE(contains(c, p));
  EXPECT_EQ(c.radius, 0);
}

}  // namespace
}  // namespace plumb
