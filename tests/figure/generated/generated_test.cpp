// Are generated shapes and pairs what their forms and positions say?  In rationals for every kind, and by locate and
// relate for the structs.
#include "plumb/figure/generated/generated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "figure/generated/extent.hpp"
#include "plumb/figure/aabb/box_forms.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/parity.hpp"

namespace {

using namespace plumb;
using namespace plumb::degenerate;
using plumb_test::Rational3;
using plumb_test::Reach;
using plumb_test::Reaching;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t cases = 400;
#else
constexpr std::uint64_t cases = 4;
#endif
constexpr std::uint64_t run = 7101;

std::string replay(ShapeKind a, ShapeKind b, int dimension, Position position, std::uint64_t index) {
  return std::string("Entropy(")
      .append(std::to_string(run))
      .append(", ")
      .append(std::to_string(index))
      .append("): ")
      .append(name_of(a))
      .append(" and ")
      .append(name_of(b))
      .append(" of ")
      .append(std::to_string(dimension))
      .append("D, ")
      .append(name_of(position));
}

bool touches(Position position) { return position <= Position::shared_face; }

Rational3 rational(const std::array<double, 3>& x) { return {x[0], x[1], x[2]}; }
Rational3 negated(const Rational3& x) { return {-x[0], -x[1], -x[2]}; }

Reach reach(ShapeKind kind, int dimension, const std::vector<double>& numbers, const Rational3& normal,
            const Rational3& through) {
  return Reaching(kind, dimension, numbers, normal, plumb_test::dot(normal, through)).found();
}

/// A box in each of its forms is the same set.
void expect_forms(const std::vector<double>& numbers) {
  const auto box = shape_from<Aabb3>(numbers);
  ASSERT_EQ(to_aabb(shape_from<AabbWidths3>(numbers)), box);
  ASSERT_EQ(to_aabb(shape_from<AabbCenter3>(numbers)), box);
}

template <class Visit>
void for_each_pair(const Visit& visit) {
  for (const int dimension : {2, 3}) {
    for (const ShapeKindInfo& a : shape_kinds) {
      for (const ShapeKindInfo& b : shape_kinds) {
        for (const PositionInfo& p : positions) {
          if (has_position(a.kind, b.kind, dimension, p.position)) visit(a.kind, b.kind, dimension, p.position);
        }
      }
    }
  }
}

template <class... S>
struct Shapes {};
using Shapes2 = Shapes<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2, Polygon2, HoledPolygon2,
                       Circle2, Aabb2, Obb2, Capsule2, KDop2, HalfspaceIntersection2>;
using Shapes3 = Shapes<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3,
                       Polygon3, HoledPolygon3, Rectangle3, Tetrahedron3, Sphere3, Aabb3, Obb3, Capsule3, Lozenge3,
                       Cylinder3, Cone3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3, TriangleMesh>;
/// That relate does not take.
using Others = Shapes<Slab2, Slab3, Ellipsoid3>;

using Numbers = std::vector<double>;
template <class Shape>
using PointOf = std::conditional_t<generated_dimension<Shape> == 2, Point2, Point3>;

/// Whether the shape of these numbers has the point; a hull without volume is taken at its word.
template <class S>
bool holds(const Numbers& numbers, std::span<const double> p) {
  using Point = PointOf<S>;
  const auto point = shape_from<Point>(p.first(sizeof(Point) / sizeof(double)));
  if constexpr (std::is_same_v<S, Point>) {
    return shape_from<S>(numbers) == point;
  } else if constexpr (std::is_same_v<S, ConvexPolyhedron3>) {
    try {
      return locate(shape_from<S>(numbers), point) != Location::outside;
    } catch (const InvalidShape&) {
      return true;
    }
  } else {
    return locate(shape_from<S>(numbers), point) != Location::outside;
  }
}
using Holds = bool (*)(const Numbers&, std::span<const double>);
/// Of points of the plane, which no struct has, nothing is asked.
Holds holder(ShapeKind kind, int dimension) {
  using KindAndDimension = std::pair<ShapeKind, int>;
  static const auto all = [] {
    std::map<KindAndDimension, Holds> made;
    const auto add = [&]<class... S>(Shapes<S...>) {
      (made.emplace(KindAndDimension(generated_kind<S>, generated_dimension<S>), holds<S>), ...);
    };
    add(Shapes2{});
    add(Shapes3{});
    add(Others{});
    made.emplace(KindAndDimension(ShapeKind::points, 2), [](const Numbers&, std::span<const double>) { return true; });
    return made;
  }();
  return all.at({kind, dimension});
}

/// Axes of boxes and rectangles are not zero, and they and the edges of lozenges perpendicular, to the last bit.
void expect_perpendicular(ShapeKind kind, int dimension, const Numbers& numbers) {
  std::size_t axes = 0;
  if (kind == ShapeKind::obb) axes = static_cast<std::size_t>(dimension);
  if (kind == ShapeKind::rectangle || kind == ShapeKind::lozenge) axes = 2;
  const Reaching shape(kind, dimension, numbers, {}, 0);
  for (std::size_t i = 1; i <= axes; ++i) {
    for (std::size_t j = 1; j < i; ++j) ASSERT_EQ(plumb_test::dot(shape.at(i), shape.at(j)), 0) << name_of(kind);
    if (kind != ShapeKind::lozenge) {
      ASSERT_NE(plumb_test::dot(shape.at(i), shape.at(i)), 0) << name_of(kind);
    }
  }
}

TEST(GeneratedPairs, LieOnTheirSidesOfThePlane) {
  std::map<Position, int> seen;
  std::uint64_t index = 0;
  for_each_pair([&](ShapeKind a, ShapeKind b, int dimension, Position position) {
    for (std::uint64_t i = 0; i < cases; ++i, ++index) {
      Entropy entropy(run, index);
      const ShapePair pair = shape_pair(a, b, dimension, position, Nearness::exactly, entropy);
      SCOPED_TRACE(replay(a, b, dimension, position, index));
      expect_perpendicular(a, dimension, pair.a);
      expect_perpendicular(b, dimension, pair.b);
      if (dimension == 3 && a == ShapeKind::aabb) expect_forms(pair.a);
      if (touches(position) || position == Position::concentric) {
        ASSERT_TRUE(holder(a, dimension)(pair.a, pair.contact));
        ASSERT_TRUE(holder(b, dimension)(pair.b, pair.contact));
      }
      const bool has_plane = touches(position) || position == Position::parallel || position == Position::coplanar ||
                             position == Position::perpendicular;
      if (!has_plane) continue;
      const Rational3 normal = rational(pair.normal), contact = rational(pair.contact);
      ASSERT_NE(plumb_test::dot(normal, normal), 0);
      const Reach below = reach(a, dimension, pair.a, normal, contact);
      const Reach above = reach(b, dimension, pair.b, negated(normal), contact);
      ++seen[position];
      if (position == Position::coplanar) {
        ASSERT_TRUE(reach(a, dimension, pair.a, negated(normal), contact).within);
      } else {
        ASSERT_TRUE(below.within);
      }
      ASSERT_TRUE(above.within);
      if (position == Position::parallel) {
        ASSERT_TRUE(above.leaves);
      }
    }
  });
  EXPECT_EQ(seen.size(), 12u);
}

TEST(GeneratedPairs, AreRepeatedByTheirChoicesAndFinite) {
  std::uint64_t index = 0;
  for_each_pair([&](ShapeKind a, ShapeKind b, int dimension, Position position) {
    for (const Nearness nearness : {Nearness::exactly, Nearness::nearly}) {
      ++index;
      std::vector<std::uint64_t> choices;
      Entropy entropy(run + 1, index);
      entropy.record_into(&choices);
      const ShapePair pair = shape_pair(a, b, dimension, position, nearness, entropy);
      Entropy again = Entropy::from_choices(choices);
      const ShapePair same = shape_pair(a, b, dimension, position, nearness, again);
      ASSERT_EQ(pair.a, same.a);
      ASSERT_EQ(pair.b, same.b);
      for (const double x : pair.a) ASSERT_TRUE(std::isfinite(x));
      for (const double x : pair.b) ASSERT_TRUE(std::isfinite(x));
      const std::size_t size = shape_size(a, dimension);
      if (size != 0) {
        ASSERT_EQ(pair.a.size(), size) << name_of(a);
      }
      Entropy nothing = Entropy::from_choices({});
      for (const double x : shape_pair(a, b, dimension, position, nearness, nothing).a) {
        ASSERT_LE(std::fabs(x), nearness == Nearness::exactly ? 1000 : 0x1p54);
      }
    }
  });
}

/// Of relations by position.
using Tally = std::map<Position, std::array<int, 3>>;

/// Whether the mesh bounds a convex solid, after its triangles were turned to the outside.
bool turn_convex(TriangleMesh& mesh) {
  if (is_convex(mesh)) return true;
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  return is_convex(mesh);
}

/// What of a shape is related: of a mesh the polyhedron, with faces in one plane.
template <class Shape>
using AsRelated = std::conditional_t<std::is_same_v<Shape, TriangleMesh>, ConvexPolyhedron3, Shape>;

/// Nothing for points of one plane, which are no polyhedron, and meshes that are not convex.
using Relating = std::optional<Relation> (*)(const ShapePair&);
template <class A, class B>
std::optional<Relation> relation_of(const ShapePair& pair) {
  try {
    if constexpr (std::is_same_v<A, TriangleMesh>) {
      auto mesh = shape_from<TriangleMesh>(pair.a);
      if (!turn_convex(mesh)) return {};
      return relate(convex_polyhedron(mesh), shape_from<B>(pair.b));
    } else {
      const auto [a, b] = pair_from<A, B>(pair);
      return relate(a, b);
    }
  } catch (const InvalidShape&) {
    if (generated_kind<A> == ShapeKind::points || generated_kind<B> == ShapeKind::points) return {};
    throw;
  }
}

void related(ShapeKind a, ShapeKind b, int dimension, Relating relation_of_pair, Tally& tally) {
  for (const PositionInfo& info : positions) {
    const Position position = info.position;
    if (!has_position(a, b, dimension, position)) continue;
    for (std::uint64_t index = 0; index < cases; ++index) {
      SCOPED_TRACE(replay(a, b, dimension, position, index));
      Entropy entropy(run + 2, index);
      const ShapePair pair = shape_pair(a, b, dimension, position, Nearness::exactly, entropy);
      const std::optional<Relation> told = relation_of_pair(pair);
      if (!told) continue;
      const Relation relation = *told;
      ++tally[position][static_cast<std::size_t>(static_cast<int>(relation) + 1)];
      const Rational3 normal = rational(pair.normal), contact = rational(pair.contact);
      if (touches(position)) {
        ASSERT_NE(relation, Relation::disjoint);
        const bool leaves = reach(a, dimension, pair.a, normal, contact).leaves ||
                            reach(b, dimension, pair.b, negated(normal), contact).leaves;
        if (leaves) {
          ASSERT_EQ(relation, Relation::touching);
        }
      }
      if (position == Position::contained) {
        for (const auto corner : plumb_test::points_of(b, static_cast<std::size_t>(dimension), pair.b)) {
          ASSERT_TRUE(holder(a, dimension)(pair.a, corner));
        }
      }
      if (position == Position::parallel) {
        ASSERT_EQ(relation, Relation::disjoint);
      }
      if (position == Position::concentric || position == Position::contained || position == Position::equal ||
          position == Position::reversed) {
        ASSERT_EQ(relation, Relation::overlapping);
      }
    }
  }
}

template <class... A>
void all_related(Shapes<A...>) {
  Tally tally;
  const auto with_each = [&]<class First>(const First*) {
    const auto one = [&]<class Other>(const Other*) {
      if constexpr (RelatedPair<AsRelated<First>, Other>) {
        related(generated_kind<First>, generated_kind<Other>, generated_dimension<First>, relation_of<First, Other>,
                tally);
      }
    };
    (one(static_cast<const A*>(nullptr)), ...);
  };
  (with_each(static_cast<const A*>(nullptr)), ...);
  const int dimension = std::max({generated_dimension<A>...});
  EXPECT_EQ(tally.size(), dimension == 2 ? 11u : positions.size());
  int touching = 0, overlapping = 0;
  for (const auto& [position, counts] : tally) {
    touching += counts[1];
    overlapping += counts[2];
    std::printf("%dD %-18s disjoint %6d touching %6d overlapping %6d\n", dimension, name_of(position).data(), counts[0],
                counts[1], counts[2]);
  }
  EXPECT_GT(touching, overlapping / 4);
  EXPECT_GT(overlapping, touching / 4);
}

TEST(GeneratedPairs, OfThePlaneAreRelatedAsTheyAreCalled) { all_related(Shapes2{}); }
TEST(GeneratedPairs, OfSpaceAreRelatedAsTheyAreCalled) { all_related(Shapes3{}); }

/// How many dimensions these points span.
int spanned(const Reaching& shape, std::size_t count) {
  const auto from_first = [&](std::size_t i) {
    Rational3 d = shape.at(i);
    for (std::size_t axis = 0; axis < 3; ++axis) d[axis] -= shape.at(0)[axis];
    return d;
  };
  const auto cross = [](const Rational3& a, const Rational3& b) {
    return Rational3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  int most = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const Rational3 u = from_first(i);
    if (plumb_test::dot(u, u) != 0) most = std::max(most, 1);
    for (std::size_t j = 1; j < i; ++j) {
      const Rational3 n = cross(u, from_first(j));
      if (plumb_test::dot(n, n) != 0) most = std::max(most, 2);
      for (std::size_t k = 1; k < j; ++k) {
        if (plumb_test::dot(n, from_first(k)) != 0) return 3;
      }
    }
  }
  return most;
}

void expect_kind(ShapeKind kind, int dimension, Form form, const Numbers& x) {
  if (kind == ShapeKind::mesh) {
    EXPECT_TRUE(is_oriented_closed(shape_from<TriangleMesh>(x)));
  }
  if (dimension == 3 && kind == ShapeKind::polygon) {
    EXPECT_TRUE(is_planar(shape_from<Polygon3>(x)));
  }
  if (dimension == 3 && kind == ShapeKind::quadrilateral) {
    EXPECT_TRUE(is_planar(shape_from<Quadrilateral3>(x)));
  }
  if (form == Form::empty) {
    const auto bounds = [&]<class Set>(const Set& set) { EXPECT_EQ(relate(set, set), Relation::disjoint); };
    if (kind == ShapeKind::halfspaces) {
      dimension == 2 ? bounds(shape_from<HalfspaceIntersection2>(x)) : bounds(shape_from<HalfspaceIntersection3>(x));
    }
    if (kind == ShapeKind::k_dop) {
      EXPECT_TRUE(dimension == 2 ? is_empty(shape_from<KDop2>(x)) : is_empty(shape_from<KDop3>(x)));
    }
    if (kind == ShapeKind::slab) {
      EXPECT_LT(x.back(), x[x.size() - 2]);
    }
    if (kind == ShapeKind::aabb) {
      EXPECT_GT(x[0], x[static_cast<std::size_t>(dimension)]);
    }
    return;
  }
  // Of points alone the form is what they span.
  const int most = form == Form::speck      ? 0
                   : form == Form::straight ? 1
                   : form == Form::flat     ? dimension - 1
                                            : dimension;
  if (kind == ShapeKind::segment || kind == ShapeKind::triangle || kind == ShapeKind::quadrilateral ||
      kind == ShapeKind::polygon || kind == ShapeKind::tetrahedron || kind == ShapeKind::points) {
    EXPECT_LE(spanned(Reaching(kind, dimension, x, {}, 0), x.size() / static_cast<std::size_t>(dimension)), most);
  }
}

TEST(GeneratedShapes, AreOfTheirKindAndForm) {
  std::uint64_t index = 0;
  int many = 0, convex = 0, dented = 0;
  for (const ShapeKindInfo& info : shape_kinds) {
    for (const int dimension : {2, 3}) {
      for (const FormInfo& form : forms) {
        for (std::uint64_t i = 0; i < 2 * cases; ++i) {
          Entropy entropy(run + 3, ++index);
          const Numbers x = shape(info.kind, dimension, form.form, entropy);
          SCOPED_TRACE(std::string(info.name).append(" ").append(form.name).append(" ").append(std::to_string(index)));
          const bool is_there =
              is_kind_of(info.kind, dimension) && (form.form != Form::empty || can_be_empty(info.kind));
          ASSERT_EQ(x.empty(), !is_there);
          if (!is_there) continue;
          for (const double each : x) ASSERT_TRUE(std::isfinite(each));
          expect_perpendicular(info.kind, dimension, x);
          expect_kind(info.kind, dimension, form.form, x);
          if (info.kind == ShapeKind::mesh && form.form < Form::flat) {
            auto mesh = shape_from<TriangleMesh>(x);
            ++(turn_convex(mesh) ? convex : dented);
          }
          // The row is one of the kind: no exception.
          many += holder(info.kind, dimension)(x, std::array<double, 3>{}) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(many, 100);
  EXPECT_GT(convex, 5);
  EXPECT_GT(dented, 5);
}

TEST(GeneratedShapes, RefuseRowsOfOtherKinds) {
  EXPECT_THROW(shape_from<Obb3>(Numbers(14)), InvalidShape);
  EXPECT_THROW(shape_from<Polygon3>(Numbers(4)), InvalidShape);
  EXPECT_THROW(shape_from<HoledPolygon2>(Numbers{2, 3, 0, 0, 1, 0, 0, 1}), InvalidShape);
  EXPECT_THROW(shape_from<HoledPolygon2>(Numbers{1, 1e300, 0, 0}), InvalidShape);
  EXPECT_THROW(shape_from<HoledPolygon2>(Numbers{1, 0.5, 0, 0}), InvalidShape);
  EXPECT_THROW(shape_from<HalfspaceIntersection3>(Numbers(5)), InvalidShape);
  EXPECT_THROW(shape_from<TriangleMesh>(Numbers{1, 0, 0, 0, 0, 0, 1}), InvalidShape);
  EXPECT_THROW(shape_from<TriangleMesh>(Numbers{-1, 0, 0, 0}), InvalidShape);
  EXPECT_NO_THROW(shape_from<TriangleMesh>(Numbers{1, 0, 0, 0, 0, 0, 0}));
}

}  // namespace
