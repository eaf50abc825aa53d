// Do trees of shapes, and shapes of polynomials, hold what they say they hold?
#include "plumb/figure/containment/csg.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <optional>

#include "figure/basic/shape_cases.hpp"
#include "figure/containment/exact_locations.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/implicit_function.hpp"

namespace plumb {
namespace {

constexpr Location outside = Location::outside, boundary = Location::boundary, inside = Location::inside;

/// A tree of boxes with integer corners, and how it was made.
template <class Box>
struct Made {
  enum Kind { leaf, unite, intersect, subtract, complement } kind;
  Box box;
  std::vector<Made> parts;
};

Aabb2 draw_box(Entropy& e, const Aabb2&) {
  const auto c = [&] { return static_cast<double>(e.within(2)); };
  Aabb2 b{{c(), c()}, {c(), c()}};
  if (e.below(8) != 0 && b.min.x > b.max.x) std::swap(b.min.x, b.max.x);
  if (e.below(8) != 0 && b.min.y > b.max.y) std::swap(b.min.y, b.max.y);
  return b;
}
Aabb3 draw_box(Entropy& e, const Aabb3&) {
  const auto c = [&] { return static_cast<double>(e.within(1)); };
  Aabb3 b{{c(), c(), c()}, {c(), c(), c()}};
  if (b.min.x > b.max.x) std::swap(b.min.x, b.max.x);
  if (b.min.y > b.max.y) std::swap(b.min.y, b.max.y);
  if (e.below(8) != 0 && b.min.z > b.max.z) std::swap(b.min.z, b.max.z);
  return b;
}

template <class Box>
Made<Box> draw_tree(Entropy& e, int depth) {
  using Tree = Made<Box>;
  if (depth == 0 || e.below(4) == 0) return {Tree::leaf, draw_box(e, Box{}), {}};
  Tree made{static_cast<typename Tree::Kind>(1 + e.below(4)), {}, {}};
  made.parts.push_back(draw_tree<Box>(e, depth - 1));
  if (made.kind != Tree::complement) made.parts.push_back(draw_tree<Box>(e, depth - 1));
  return made;
}

template <class Box>
auto csg_of(const Made<Box>& made) -> decltype(csg(made.box)) {
  switch (made.kind) {
    case Made<Box>::unite:
      return csg_of(made.parts[0]) | csg_of(made.parts[1]);
    case Made<Box>::intersect:
      return csg_of(made.parts[0]) & csg_of(made.parts[1]);
    case Made<Box>::subtract:
      return csg_of(made.parts[0]) - csg_of(made.parts[1]);
    case Made<Box>::complement:
      return ~csg_of(made.parts[0]);
    default:
      return csg(made.box);
  }
}

/// In the closed set, or, `complemented`, in that of the complement: the definition, node by node.  The closure of the
/// complement of a box is all that is not strictly within.
template <class Box, class Point>
bool member(const Made<Box>& made, const Point& p, bool complemented) {
  const auto part = [&](std::size_t i, bool c) { return member(made.parts[i], p, c); };
  switch (made.kind) {
    case Made<Box>::unite:
      return complemented ? part(0, true) && part(1, true) : part(0, false) || part(1, false);
    case Made<Box>::intersect:
      return complemented ? part(0, true) || part(1, true) : part(0, false) && part(1, false);
    case Made<Box>::subtract:
      return complemented ? part(0, true) || part(1, false) : part(0, false) && part(1, true);
    case Made<Box>::complement:
      return part(0, !complemented);
    default:
      return complemented ? exact::locate(made.box, p) != inside : exact::locate(made.box, p) != outside;
  }
}

/// All points a little off p, in every direction that tells faces of integer boxes apart, p included.
template <class Visit>
void around(const Point2& p, const Visit& visit) {
  for (const double x : {-0.25, 0.0, 0.25}) {
    for (const double y : {-0.25, 0.0, 0.25}) visit(Point2{p.x + x, p.y + y}, x != 0 && y != 0);
  }
}
template <class Visit>
void around(const Point3& p, const Visit& visit) {
  for (const double z : {-0.25, 0.0, 0.25}) {
    around(Point2{p.x, p.y}, [&](const Point2& q, bool generic) {
      visit(Point3{q.x, q.y, p.z + z}, generic && z != 0);
    });
  }
}

/// Near a multiple of one half, the set of integer boxes is a cone: what is a little off it tells where it lies.
template <class Box, class Point>
std::array<Location, 2> brute_force(const Made<Box>& made, const Point& p) {
  bool all = true, all_generic = true, any_generic = false;
  around(p, [&](const Point& q, bool generic) {
    const bool in = member(made, q, false);
    all = all && in;
    all_generic = all_generic && (in || !generic);
    any_generic = any_generic || (in && generic);
  });
  const Location closed = all ? inside : member(made, p, false) ? boundary : outside;
  return {closed, all_generic ? inside : any_generic ? boundary : outside};
}

template <class Box, class Point, class Draw>
void hold_against_brute_force(std::uint64_t start, std::uint64_t cases, Draw draw) {
  std::uint64_t told = 0, told_regularized = 0, asked = 0;
  std::array<std::uint64_t, 3> count{}, count_regularized{};
  const auto slot = [](Location where) { return static_cast<std::size_t>(static_cast<int>(where) + 1); };
  for (std::uint64_t i = 0; i < cases * shape_cases::more; ++i) {
    Entropy e(start, i);
    const auto made = draw_tree<Box>(e, 3);
    const auto tree = csg_of(made);
    for (int probe = 0; probe < 4; ++probe) {
      const Point p = draw(e);
      const auto [closed, regularized] = brute_force(made, p);
      const std::string place = "start " + std::to_string(start) + " index " + std::to_string(i);
      EXPECT_EQ(contains(tree, p), closed != outside) << place;
      EXPECT_EQ(contains(~tree, p), member(made, p, true)) << place;
      const auto where = locate(tree, p), solid = locate_regularized(tree, p);
      if (where) {
        EXPECT_EQ(*where, closed) << place;
      } else {
        EXPECT_TRUE(contains(tree, p)) << place;
      }
      EXPECT_EQ(locate_regularized(~tree, p).has_value(), solid.has_value()) << place;
      if (solid) {
        EXPECT_EQ(*solid, regularized) << place;
      }
      ++asked;
      told += where.has_value() ? 1 : 0;
      told_regularized += solid.has_value() ? 1 : 0;
      ++count[slot(closed)];
      ++count_regularized[slot(regularized)];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(count[i], asked / 20) << i;
    EXPECT_GT(count_regularized[i], asked / 50) << i;
  }
  EXPECT_GT(told, asked * 3 / 4);
  EXPECT_GT(told_regularized, asked / 2);
  EXPECT_LT(told, asked);
}

TEST(Csg, TreesOfRectanglesAgainstTheirNeighborhoods) {
  hold_against_brute_force<Aabb2, Point2>(51, 3000, [](Entropy& e) {
    const double x = static_cast<double>(e.within(5)) / 2, y = static_cast<double>(e.within(5)) / 2;
    return Point2{x, y};
  });
}

TEST(Csg, TreesOfBoxesAgainstTheirNeighborhoods) {
  hold_against_brute_force<Aabb3, Point3>(52, 600, [](Entropy& e) {
    const auto c = [&e] { return static_cast<double>(e.within(2)) / 2; };
    return Point3{c(), c(), c()};
  });
}

TEST(Csg, SaysWhatTheLeavesDoNotTell) {
  const Csg3 left = csg(Aabb3{{0, 0, 0}, {1, 1, 1}}), right = csg(Aabb3{{1, 0, 0}, {2, 1, 1}});
  const Point3 between{1, 0.5, 0.5}, rim{1, 0, 0.5};
  EXPECT_EQ(locate(left | right, between), std::nullopt) << "inside, which the leaves do not tell";
  EXPECT_EQ(locate(left | right, rim), std::nullopt) << "on the boundary, with the same leaves' locations";
  EXPECT_TRUE(contains(left | right, between));
  EXPECT_EQ(locate(left & right, between), boundary) << "closed sets that touch";
  EXPECT_EQ(locate_regularized(left & right, between), std::nullopt);
  EXPECT_EQ(locate(left | right, {0.5, 0.5, 0.5}), inside);
  EXPECT_EQ(locate(left - left, {0.5, 0.5, 0.5}), outside);
  EXPECT_EQ(locate(left - left, {0, 0.5, 0.5}), boundary) << "a - a is the boundary of a";
  const Csg3 plate = csg(Aabb3{{0, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(locate(plate, {0.5, 0.5, 0}), boundary);
  EXPECT_EQ(locate(~plate, {0.5, 0.5, 0}), std::nullopt);
  EXPECT_TRUE(contains(~plate, {0.5, 0.5, 0}));
  EXPECT_EQ(locate_regularized(plate | left, {0.5, 0.5, 0.5}), inside);
}

TEST(Csg, AnyShapeIsALeaf) {
  const Csg3 nut = (csg(Cylinder3{{0, 0, 0}, {0, 0, 2}, 5}) & csg(Sphere3{{0, 0, 0}, 6})) -
                   csg(Cylinder3{{0, 0, -1}, {0, 0, 3}, 2}) -
                   csg(Obb3{{5, 0, 1}, {{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}, {1, 1, 1}});
  EXPECT_EQ(nut.leaf_count(), 4u);
  EXPECT_EQ(locate(nut, {0, 3, 1}), inside);
  EXPECT_EQ(locate(nut, {0, 2, 1}), boundary);
  EXPECT_EQ(locate(nut, {0, 0, 1}), outside);
  EXPECT_EQ(locate(nut, {3, 0, 1}), boundary) << "the corner of the oriented box";
  EXPECT_EQ(locate(nut, {0, 5, 1}), boundary);
  const auto paraboloid = csg(implicit_shape3([](auto x, auto y, auto z) { return x * x + y * y - z; }));
  EXPECT_EQ(locate(paraboloid & csg(Halfspace3{{0, 0, 1}, 4}), {0, 0, 1}), inside);
  EXPECT_EQ(locate(paraboloid & csg(Halfspace3{{0, 0, 1}, 4}), {2, 0, 4}), boundary);
  EXPECT_EQ(locate(csg(Circle2{{0, 0}, 5}) - csg(Circle2{{0, 0}, 3}), {4, 1}), inside);
}

TEST(Csg, DeepTreesAndWrongLeaves) {
  Csg2 stairs = csg(Aabb2{{0, 0}, {1, 1}});
  for (int i = 1; i < 20000; ++i) stairs = std::move(stairs) | csg(Aabb2{{2.0 * i, 0}, {2.0 * i + 1, 1}});
  EXPECT_EQ(locate(stairs, {39998.5, 0.5}), inside);
  EXPECT_EQ(locate(~stairs, {39997.5, 0.5}), inside);
  EXPECT_THROW(csg(Sphere3{{0, 0, 0}, -1}), InvalidShape);
  EXPECT_THROW(csg(Circle2{{0, 0}, std::numeric_limits<double>::quiet_NaN()}), NonFinite);
  EXPECT_THROW(static_cast<void>(locate(stairs, {0, std::numeric_limits<double>::infinity()})), NonFinite);
}

TEST(Csg, RegularLeavesAreSeenToBeSo) {
  EXPECT_TRUE(is_regular(Aabb3{{0, 0, 1}, {1, 1, 0}})) << "empty";
  EXPECT_FALSE(is_regular(Aabb3{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_FALSE(is_regular(Segment3{}));
  EXPECT_FALSE(is_regular(Tetrahedron3{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_TRUE(is_regular(Slab3{{0, 0, 0}, 1, 1}));
  EXPECT_FALSE(is_regular(Slab3{{0, 0, 1}, 1, 1}));
  // A leaf that holds a point strictly is the closure of its interior: all shapes here are convex.
  const auto agree = []<class Shape>(Shape) {
    shape_cases::on_shapes(53, 400, [](shape_cases::Material& m) {
      const auto shape = m.shape<Shape>();
      for (int i = 0; i < 4; ++i) {
        const Point3 p = m.probe3();
        EXPECT_TRUE(exact::locate(shape, p) != inside || is_regular(shape)) << m.about(shape, p);
      }
    });
  };
  agree(Plane3{}), agree(Halfspace3{}), agree(Slab3{}), agree(Tetrahedron3{}), agree(Sphere3{}), agree(Capsule3{});
  agree(Lozenge3{}), agree(Cylinder3{}), agree(Cone3{}), agree(Ellipsoid3{}), agree(Aabb3{}), agree(AabbWidths3{});
  agree(AabbCenter3{}), agree(Obb3{});
}

TEST(ImplicitFunction, TheSignOfThePolynomialTells) {
  const auto torus = implicit_shape3(
      [](auto x, auto y, auto z, auto major, auto minor) {
        const auto s = x * x + y * y + z * z + major * major - minor * minor;
        const auto d = major + major;
        return s * s - (x * x + y * y) * (d * d);
      },
      3, 1);
  EXPECT_EQ(locate(torus, {4, 0, 0}), boundary);
  EXPECT_EQ(locate(torus, {0, 3, -1}), boundary);
  EXPECT_EQ(locate(torus, {3, 0, 0.5}), inside);
  EXPECT_EQ(locate(torus, {0, 0, 0}), outside);
  EXPECT_EQ(locate(torus, {4, 0x1p-1074, 0}), outside);
  EXPECT_TRUE(contains(torus, {0x1.fffffffffffffp+1, 0, 0}));
  EXPECT_FALSE(contains(torus, {0x1.0000000000001p+2, 0, 0}));
  const auto parabola = implicit_shape2([](auto x, auto y) { return x * x - y; });
  EXPECT_EQ(locate(parabola, {0x1p+500, 0x1p+1000}), boundary);
  EXPECT_EQ(locate(parabola, {0x1p-600, 0}), outside) << "x x is below all doubles, not zero";
  auto broken = torus;
  broken.parameters[1] = std::numeric_limits<double>::quiet_NaN();
  try {
    static_cast<void>(contains(broken, {0, 0, 0}));
    ADD_FAILURE() << "nothing is refused";
  } catch (const NonFinite& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("contains: parameters[1] is nan"));
  }
}

/// Spheres and ellipsoids are implicit functions as well.
TEST(ImplicitFunction, AgreesWithTheShapesItSays) {
  shape_cases::on_shapes(54, 2000, [](shape_cases::Material& m) {
    const auto sphere = m.shape<Sphere3>();
    const Point3 p = m.probe3();
    const auto same =
        implicit_shape3([](auto x, auto y, auto z, auto a, auto b, auto c,
                           auto r) { return (x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c) - r * r; },
                        sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius);
    EXPECT_EQ(locate(same, p), locate(sphere, p)) << m.about(sphere, p);
  });
}

}  // namespace
}  // namespace plumb
