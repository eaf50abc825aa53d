// Are generated pairs of shapes what their positions say?  In rationals for every kind, and by relate for the structs.
#include "plumb/figure/generated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "figure/generated_extent.hpp"
#include "plumb/query/overlap.hpp"

namespace {

using namespace plumb;
using namespace plumb::degenerate;
using plumb_test::Rational3;
using plumb_test::Reach;
using plumb_test::Reaching;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t cases = 400;
#else
constexpr std::uint64_t cases = 12;
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

TEST(GeneratedPairs, LieOnTheirSidesOfThePlane) {
  std::map<Position, int> seen;
  std::uint64_t index = 0;
  for_each_pair([&](ShapeKind a, ShapeKind b, int dimension, Position position) {
    for (std::uint64_t i = 0; i < cases; ++i, ++index) {
      Entropy entropy(run, index);
      const ShapePair pair = shape_pair(a, b, dimension, position, Nearness::exactly, entropy);
      SCOPED_TRACE(replay(a, b, dimension, position, index));
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
  std::map<Nearness, int> zero_contacts;
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

template <class... S>
struct Shapes {};
using Shapes2 = Shapes<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Polygon2, Aabb2, Obb2, Circle2, Capsule2>;
using Shapes3 = Shapes<Point3, Line3, Ray3, Segment3, Plane3, Halfspace3, Triangle3, Polygon3, Rectangle3, Tetrahedron3,
                       Aabb3, Obb3, Sphere3, Capsule3, Lozenge3, Cylinder3, Cone3, ConvexPolyhedron3>;

/// The points that a shape is the hull of; of round shapes and boxes none.
template <class Point>
std::vector<Point> corners_of(ShapeKind kind, std::span<const double> x) {
  const bool made_of_points = kind == ShapeKind::point || kind == ShapeKind::segment || kind == ShapeKind::triangle ||
                              kind == ShapeKind::polygon || kind == ShapeKind::tetrahedron || kind == ShapeKind::points;
  std::vector<Point> corners;
  constexpr std::size_t stride = sizeof(Point) / sizeof(double);
  for (std::size_t i = 0; made_of_points && i + stride <= x.size(); i += stride) {
    corners.push_back(shape_from<Point>(x.subspan(i, stride)));
  }
  return corners;
}

/// Of relations by position.
using Tally = std::map<Position, std::array<int, 3>>;

template <class A, class B>
void related(Tally& tally) {
  constexpr ShapeKind a = generated_kind<A>, b = generated_kind<B>;
  constexpr int dimension = generated_dimension<A>;
  for (const PositionInfo& info : positions) {
    const Position position = info.position;
    if (!has_position<A, B>(position)) continue;
    for (std::uint64_t index = 0; index < cases; ++index) {
      SCOPED_TRACE(replay(a, b, dimension, position, index));
      Entropy entropy(run + 2, index);
      const ShapePair pair = shape_pair(a, b, dimension, position, Nearness::exactly, entropy);
      Relation relation{};
      if constexpr (std::is_same_v<A, ConvexPolyhedron3> || std::is_same_v<B, ConvexPolyhedron3>) {
        try {
          const auto [first, second] = pair_from<A, B>(pair);
          relation = relate(first, second);
        } catch (const InvalidShape&) {
          continue;  // points of one plane
        }
      } else {
        const auto [first, second] = pair_from<A, B>(pair);
        relation = relate(first, second);
      }
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
      using Point = std::conditional_t<dimension == 2, Point2, Point3>;
      if (position == Position::contained) {
        for (const Point& corner : corners_of<Point>(b, pair.b)) {
          ASSERT_NE(relate(corner, shape_from<A>(pair.a)), Relation::disjoint);
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

template <class A, class... B>
void related_to_each(Tally& tally, Shapes<B...>) {
  const auto one = [&]<class Other>(const Other*) {
    if constexpr (RelatedPair<A, Other>) related<A, Other>(tally);
  };
  (one(static_cast<const B*>(nullptr)), ...);
}

template <class... A>
void all_related(Shapes<A...> all) {
  Tally tally;
  (related_to_each<A>(tally, all), ...);
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

}  // namespace
