// Rays at trees of solids: boxes against brute force over rationals, every kind of leaf against the tree asked at points of
// the ray that doubles hold, and the shapes that modelers make.
#include "plumb/query/ray/csg.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/basic/rounded_points.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using testing::HasSubstr;
using testing::ThrowsMessage;

double whole(Material& m, std::size_t most) {
  return static_cast<double>(m.below(2 * most + 1)) - static_cast<double>(most);
}
Point3 whole_point(Material& m, std::size_t most) {
  const double x = whole(m, most), y = whole(m, most), z = whole(m, most);
  return {x, y, z};
}
Vector3 whole_vector(Material& m, std::size_t most) {
  const Point3 p = whole_point(m, most);
  return {p.x, p.y, p.z};
}

Csg3 random_leaf(Material& m) {
  const Point3 p = whole_point(m, 3), q = whole_point(m, 3);
  const double r = 1 + static_cast<double>(m.below(2));
  const Vector3 v = whole_vector(m, 2);
  switch (m.below(13)) {
    case 0:
      return csg(Sphere3{p, r});
    case 1:
      return csg(Capsule3{p, q, r});
    case 2:
      return csg(Cylinder3{p, q, r});
    case 3:
      return csg(Cone3{p, q, r});
    case 4:
      return csg(Halfspace3{v, whole(m, 3)});
    case 5:
      return csg(Slab3{v, whole(m, 2), whole(m, 2) + 2});
    case 6:
      return csg(Tetrahedron3{p, q, whole_point(m, 3), whole_point(m, 3)});
    case 7:
      return csg(Obb3{p, {{{1, 1, 0}, {-1, 1, 0}, {0, 1, 2}}}, {1, whole(m, 2), 1}});
    case 8:
      return csg(Ellipsoid3{p, {{{1, 0, 0}, {0, 1, 1}, {0, -1, 1}}}, {2, 1, r}});
    case 9:
      return csg(AabbCenter3{p, {r, whole(m, 2), 1}});
    case 10:
      return csg(KDop3{k_dop_directions(8), {-2, -1, -3, -2}, {whole(m, 3), 2, 1, 4}});
    case 11:
      return csg(Lozenge3{p, {Vector3{2, 0, 0}, Vector3{0, 1, 1}}, r});
    default:
      return csg(Aabb3{{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                       {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}});
  }
}

Csg3 random_tree(Material& m, std::size_t depth) {
  if (depth == 0 || m.below(5) == 0) return random_leaf(m);
  const Csg3 a = random_tree(m, depth - 1);
  switch (m.below(5)) {
    case 0:
      return a & random_tree(m, depth - 1);
    case 1:
      return a | random_tree(m, depth - 1);
    case 2:
      return ~a;
    default:
      return a - random_tree(m, depth - 1);
  }
}

/// Is the first t at most where the tree is found to hold the ray, and the tree without all before?
template <class Ray, class At>
void expect_first(const Ray& ray, const Csg3& tree, const At& at, double last, const std::string& about, int& found,
                  int& inside) {
  const auto hit = first_hit(ray, tree);
  const auto t = first_hit_parameter(ray, tree);
  ASSERT_EQ(hit.has_value(), t.has_value()) << about;
  EXPECT_EQ(hits(ray, tree), t.has_value()) << about;
  found += t ? 1 : 0;
  for (double x = 0; x <= last; x += 0.125) {
    if (!tree.contains(at(x))) {
      EXPECT_FALSE(t && *t == RayParameter{Rational(x)}) << about << x;
      continue;
    }
    ASSERT_TRUE(t) << about << x;
    EXPECT_TRUE((*t <=> RayParameter{Rational(x)}) <= 0) << about << x;
    break;
  }
  if (!t) return;
  EXPECT_EQ(hit->hit.t, t->rounded()) << about;
  // Where doubles hold the point, the tree holds it, and the leaf has it on its boundary.
  const double rounded = t->rounded();
  const bool in_doubles =
      RayParameter{Rational(rounded)} == *t && std::abs(rounded) < 64 && rounded * 1024 == std::floor(rounded * 1024);
  if (in_doubles) {
    EXPECT_TRUE(tree.contains(at(rounded))) << about << rounded;
  }
  if (hit->leaf == tree.leaf_count()) {
    EXPECT_EQ(rounded, 0) << about;
    EXPECT_EQ(tree.locate(at(0)), Location::inside) << about;
    ++inside;
    return;
  }
  const auto& leaf = tree.leaf(hit->leaf);
  if (in_doubles) {
    EXPECT_EQ(leaf.locate(leaf.shape.get(), at(rounded)), Location::boundary) << about << rounded;
  }
}

TEST(CsgRay, EveryLeafAsTheTreeSays) {
  int found = 0, inside = 0, cases = 0;
  shape_cases::on_shapes(5901, battery::sanitized ? 80 : 800, [&](Material& m) {
    const Csg3 tree = random_tree(m, 3);
    const Point3 o = whole_point(m, 5);
    const Vector3 d = whole_vector(m, 2);
    ++cases;
    const std::string about = m.about(o, d);
    expect_first(
        Ray3{o, d}, tree,
        [&](double t) {
          return Point3{o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
        },
        8, about, found, inside);
    const Point3 b = whole_point(m, 5);
    expect_first(
        Segment3{o, b}, tree,
        [&](double t) {
          return Point3{o.x + t * (b.x - o.x), o.y + t * (b.y - o.y), o.z + t * (b.z - o.z)};
        },
        1, about, found, inside);
  });
  EXPECT_GT(found * 3, cases);
  EXPECT_GT(inside * 20, cases);
}

// What is cut away has an inside, or is flat and takes nothing away.
TEST(CsgRay, FromInsideOfWhatIsCutAway) {
  const Csg3 box = csg(Aabb3{{-9, -9, -9}, {9, 9, 9}});
  const auto k_dop = [](double most) { return csg(KDop3{k_dop_directions(8), {-2, -1, -3, -2}, {most, 2, 1, 4}}); };
  const Ray3 ray{{0, 0, -1}, {2, 2, 0}};
  for (const double most : {0.0, 1.0, 3.0}) {
    const Csg3 rest = box - k_dop(most);
    const auto t = first_hit_parameter(ray, rest);
    ASSERT_TRUE(t) << most;
    EXPECT_EQ(t->sign(), Sign::positive) << most;
    EXPECT_FALSE(rest.contains({0, 0, -1})) << most;
  }
  const auto flat = first_hit_parameter(ray, box - k_dop(-1));
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->sign(), Sign::zero);
}

/// Boxes alone: what the closed set holds can only change where the ray passes a whole coordinate.
TEST(CsgRay, BoxesAsBruteForce) {
  int found = 0, cases = 0;
  shape_cases::on_shapes(5902, battery::sanitized ? 100 : 1000, [&](Material& m) {
    const auto box = [&] {
      const Point3 p = whole_point(m, 2), q = whole_point(m, 2);
      return csg(Aabb3{{std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                       {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}});
    };
    Csg3 tree = box();
    for (std::size_t i = m.below(5); i > 0; --i) {
      const Csg3 other = m.below(3) == 0 ? box() - box() : box();
      tree = m.below(3) == 0 ? (tree & other) : m.below(2) == 0 ? (tree | other) : (tree - other);
      if (m.below(6) == 0) tree = ~tree;
    }
    const Point3 o = whole_point(m, 3);
    const Vector3 d = whole_vector(m, 2);  // so that it passes whole coordinates at halves
    std::optional<double> first;
    for (double t = 0; t <= 8 && !first; t += 0.25) {
      if (tree.contains({o.x + t * d.x, o.y + t * d.y, o.z + t * d.z})) first = t;
    }
    ++cases, found += first ? 1 : 0;
    const auto t = first_hit_parameter(Ray3{o, d}, tree);
    const std::string about = m.about(o, d);
    ASSERT_EQ(t.has_value(), first.has_value()) << about;
    if (!t) return;
    EXPECT_TRUE(*t == RayParameter{Rational(*first)}) << about << *first;
  });
  EXPECT_GT(cases, 50);
  EXPECT_GT(found * 5, cases);
}

TEST(CsgRay, ShapesThatModelersMake) {
  const Csg3 tube = csg(Cylinder3{{0, 0, 0}, {0, 0, 4}, 2}) - csg(Cylinder3{{0, 0, -1}, {0, 0, 5}, 1});
  // From within the bore outward: the wall is entered where the bore is left, and the normal points into the bore.
  EXPECT_EQ(first_hit(Ray3{{0, 0, 2}, {1, 0, 0}}, tube),
            (CsgHit{{1, {1, 0, 2}, {FeatureKind::face, 0}, {-1, 0, 0}}, 1}));
  EXPECT_EQ(first_hit(Segment3{{0, 0, 2}, {4, 0, 2}}, tube),
            (CsgHit{{0.25, {1, 0, 2}, {FeatureKind::face, 0}, {-1, 0, 0}}, 1}));
  EXPECT_EQ(first_hit(Ray3{{9, 0, 2}, {-1, 0, 0}}, tube),
            (CsgHit{{7, {2, 0, 2}, {FeatureKind::face, 0}, {2, 0, 0}}, 0}));
  EXPECT_FALSE(first_hit(Ray3{{0, 0, -9}, {0, 0, 1}}, tube));         // through the bore
  EXPECT_EQ(first_hit(Ray3{{1, 0, -9}, {0, 0, 1}}, tube)->hit.t, 9);  // along its wall
  EXPECT_EQ(first_hit(Ray3{{1.5, 0, 2}, {0, 0, 1}}, tube),
            (CsgHit{{0, {1.5, 0, 2}, {FeatureKind::interior, 0}, {0, 0, 0}}, 2}));
  EXPECT_EQ(first_hit(Ray3{{1, 0, 2}, {-1, 0, 0}}, tube),
            (CsgHit{{0, {1, 0, 2}, {FeatureKind::face, 0}, {-1, 0, 0}}, 1}));
  // A ball with a ball taken away that ends a root away: t is the greater root, exactly.
  const Csg3 shell = csg(Sphere3{{0, 0, 0}, 3}) - csg(Sphere3{{0, 0, 0}, 2});
  const auto t = first_hit_parameter(Ray3{{1, 1, 1}, {1, 0, 0}}, shell);
  EXPECT_TRUE(*t == (RayParameter{Rational(-1.0), Rational(2.0), true}));
  EXPECT_FALSE(hits(Segment3{{1, 1, 1}, {1.4, 1, 1}}, shell));
  EXPECT_TRUE(hits(Segment3{{1, 1, 1}, {1.5, 1, 1}}, shell));
  // a - a is the boundary of a; a complement begins at once.
  const Csg3 box = csg(Aabb3{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(first_hit(Ray3{{0.5, 0.5, 0.5}, {2, 0, 0}}, box - box)->hit.t, 0.25);
  EXPECT_EQ(first_hit(Ray3{{0.5, 0.5, 0.5}, {2, 0, 0}}, ~box)->hit.point, (Point3{1, 0.5, 0.5}));
  EXPECT_EQ(first_hit(Ray3{{5, 5, 5}, {2, 0, 0}}, ~box)->leaf, 1u);
  EXPECT_FALSE(first_hit(Ray3{{0.5, 0.5, 0.5}, {0, 0, 0}}, ~box));
}

TEST(CsgRay, WhatIsNotAnsweredSaysSo) {
  const Csg3 tree = csg(Sphere3{{0, 0, 0}, 3}) - csg(Plane3{{0, 0, 1}, 0});
  EXPECT_THAT(
      [&] {
        (void)first_hit(Ray3{{0, 0, 0}, {1, 0, 0}}, tree);
      },
      ThrowsMessage<InvalidShape>(HasSubstr("first_hit: leaf 1 of the tree is none")));
  EXPECT_THAT(
      [&] {
        (void)hits(Segment3{{0, 0, 0}, {1, NAN, 0}}, tree);
      },
      ThrowsMessage<NonFinite>(HasSubstr("hits: segment.b.y is nan")));
}

}  // namespace
}  // namespace plumb
