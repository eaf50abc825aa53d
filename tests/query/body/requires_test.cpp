// Does `requires { relate(a, b); }` hold for the pairs of the table and no others?  Every question of the tables, every
// pair of kinds, of the plane, of space and across; and of what is no figure.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "plumb/plumb.hpp"
#include "query/body/pair_types.hpp"

namespace plumb {
namespace {

using pair_cases::pair_name;
using pair_cases::Types;

/// What a user's generic code would ask, by the words of the question alone.
#define PLUMB_ASKS(Name, ...)                                        \
  struct Name {                                                      \
    template <class A, class B>                                      \
    static constexpr bool holds = requires(const A& a, const B& b) { \
      __VA_ARGS__;                                                   \
    };                                                               \
  };
PLUMB_ASKS(AskRelate, relate(a, b))
PLUMB_ASKS(AskIntersects, intersects(a, b))
PLUMB_ASKS(AskContains, contains(a, b))
PLUMB_ASKS(AskClosestPoints, closest_points(a, b))
PLUMB_ASKS(AskDistance, distance(a, b))
PLUMB_ASKS(AskExactDistance, exact_distance(a, b))
PLUMB_ASKS(AskCompareDistance, compare_distance(a, b, 1.0))
PLUMB_ASKS(AskFirstHit, first_hit(a, b))
PLUMB_ASKS(AskFirstHitParameter, first_hit_parameter(a, b))
PLUMB_ASKS(AskIntersection, intersection(a, b))
PLUMB_ASKS(AskTranslating, first_contact(Translating<A>{a, {}}, Translating<B>{b, {}}))
PLUMB_ASKS(AskTranslatingTime, first_contact_time(Translating<A>{a, {}}, Translating<B>{b, {}}))
PLUMB_ASKS(AskTranslatingMeet, intersects(Translating<A>{a, {}}, Translating<B>{b, {}}))
PLUMB_ASKS(AskTranslatingAtOne, intersects(Translating<A>{a, {}}, b))
PLUMB_ASKS(AskMoving, first_contact(Moving<A>{a, a}, Moving<B>{b, b}))
PLUMB_ASKS(AskMovingMeet, intersects(Moving<A>{a, a}, Moving<B>{b, b}))
PLUMB_ASKS(AskAtRest, first_contact(a, b))
PLUMB_ASKS(AskLocate, locate(a, b))
#undef PLUMB_ASKS

struct Told {
  std::string (*name)();
  FigureKind a, b;
  int dimension;  // 0 across spaces
  bool compiles;
};

template <class Ask, class A, class... Bs>
void add_row(std::vector<Told>& to, Types<Bs...>) {
  constexpr int d = figure_dimension<A>;
  (to.push_back({&pair_name<A, Bs>, figure_kind<A>, figure_kind<Bs>, figure_dimension<Bs> == d ? d : 0,
                 Ask::template holds<A, Bs>}),
   ...);
}
template <class Ask, class... As, class Others>
void add_rows(std::vector<Told>& to, Types<As...>, Others others) {
  (add_row<Ask, As>(to, others), ...);
}

/// `answers` is the table.
template <class Ask, class Answers>
void expect_as_table(const std::string& question, Answers answers) {
  std::vector<Told> told;
  const pair_cases::Plane plane;
  const pair_cases::Space space;
  add_rows<Ask>(told, plane, plane), add_rows<Ask>(told, plane, space);
  add_rows<Ask>(told, space, plane), add_rows<Ask>(told, space, space);
  std::size_t taken = 0;
  for (const Told& t : told) {
    const bool promised = t.dimension != 0 && answers(t.a, t.b, t.dimension);
    EXPECT_EQ(t.compiles, promised) << "requires { " << question << "(a, b); }, " << t.name() << ", dimension "
                                    << t.dimension;
    taken += promised ? 1 : 0;
  }
  EXPECT_TRUE(taken > 0 && taken < told.size()) << question << ": " << taken << " of " << told.size();
}
template <class Ask>
void expect_as_table(const std::string& question, const query::QuestionTable& table) {
  expect_as_table<Ask>(question,
                       [&table](FigureKind a, FigureKind b, int dimension) { return table.answers(a, b, dimension); });
}

bool related(FigureKind a, FigureKind b, int dimension) { return pair_method(a, b, dimension) != PairMethod::absent; }

TEST(Requires, RelateAndIntersectsAreTheirTable) {
  expect_as_table<AskRelate>("relate", related);
  expect_as_table<AskIntersects>("intersects", related);
}
TEST(Requires, ContainsIsItsTable) { expect_as_table<AskContains>("contains", query::contains_pairs); }
TEST(Requires, DistancesAreTheirTable) {
  expect_as_table<AskClosestPoints>("closest_points", query::closest_pairs);
  expect_as_table<AskDistance>("distance", query::closest_pairs);
  expect_as_table<AskExactDistance>("exact_distance", query::closest_pairs);
  expect_as_table<AskCompareDistance>("compare_distance", query::closest_pairs);
}
TEST(Requires, FirstHitIsItsTable) {
  expect_as_table<AskFirstHit>("first_hit", query::hit_pairs);
  expect_as_table<AskFirstHitParameter>("first_hit_parameter", query::hit_pairs);
}
TEST(Requires, IntersectionIsItsTable) { expect_as_table<AskIntersection>("intersection", query::intersection_pairs); }
TEST(Requires, FirstContactIsItsTable) {
  expect_as_table<AskTranslating>("first_contact of Translating", query::translating_pairs);
  expect_as_table<AskTranslatingTime>("first_contact_time of Translating", query::translating_pairs);
  expect_as_table<AskTranslatingMeet>("intersects of Translating", query::translating_pairs);
  expect_as_table<AskTranslatingAtOne>("intersects of Translating and what rests", query::translating_pairs);
  expect_as_table<AskMoving>("first_contact of Moving", query::moving_pairs);
  expect_as_table<AskMovingMeet>("intersects of Moving", query::moving_pairs);
}

/// A point is located in whatever contains it, but in what is no more than a point.
TEST(Requires, LocateTakesAPointLast) {
  expect_as_table<AskLocate>("locate", [](FigureKind a, FigureKind b, int dimension) {
    return b == FigureKind::point && query::contains_pairs.answers(a, b, dimension);
  });
}

struct Foreign {
  Point3 corner;
};
template <class Ask, class... Others>
constexpr bool takes_any_of = ((Ask::template holds<Others, Sphere3> || Ask::template holds<Sphere3, Others> ||
                                Ask::template holds<Others, Others>) ||
                               ...);
template <class... Asks>
constexpr bool takes_no_figures() {
  return !(takes_any_of<Asks, Foreign, int, double, std::string, std::vector<Point3>, TriangleMesh> || ...);
}
template <class... Asks>
constexpr bool takes_index_and_figure = ((Asks::template holds<Bvh, Sphere3> || Asks::template holds<Sphere3, Bvh>) ||
                                         ...);
template <class... Asks>
constexpr bool takes_two_indexes = (Asks::template holds<Bvh, Bvh> || ...);

TEST(Requires, WhatIsNoFigureIsAskedNothing) {
  EXPECT_TRUE((takes_no_figures<AskRelate, AskIntersects, AskContains, AskClosestPoints, AskDistance, AskExactDistance,
                                AskCompareDistance, AskFirstHit, AskFirstHitParameter, AskIntersection, AskAtRest,
                                AskLocate>()));
}
/// Two meshes are asked how far apart they are (space/closest/closest_triangles.hpp), of what is asked of figures.
TEST(Requires, IndexesAreAskedOfTheirDistanceAlone) {
  EXPECT_FALSE((takes_index_and_figure<AskRelate, AskIntersects, AskContains, AskClosestPoints, AskDistance,
                                       AskExactDistance, AskCompareDistance, AskFirstHit, AskFirstHitParameter,
                                       AskIntersection, AskAtRest, AskLocate>));
  EXPECT_FALSE(
      (takes_two_indexes<AskRelate, AskIntersects, AskContains, AskClosestPoints, AskExactDistance, AskCompareDistance,
                         AskFirstHit, AskFirstHitParameter, AskIntersection, AskAtRest, AskLocate>));
  EXPECT_TRUE(takes_two_indexes<AskDistance>);
}

/// What convex bodies are asked has no table of letters: its concept is the table.
template <class A, class B>
constexpr bool has_contact = requires(const A& a, const B& b) {
  contact(a, b);
  exact_contact(a, b);
};
template <class A, class B>
constexpr bool has_penetration = requires(const A& a, const B& b) {
  penetration(a, b);
};
template <class A, class B>
constexpr bool has_gjk = requires(const A& a, const B& b) {
  gjk(a, b);
  gjk_distance(a, b);
  gjk_intersects(a, b);
};

TEST(Requires, ConvexBodiesAreAskedAsTheirConceptsSay) {
  const auto row = []<class A, class... Bs>(const A*, Types<Bs...>) {
    return ((has_gjk<A, Bs> == (ConvexBody3<A> && ConvexBody3<Bs>)) && ...) &&
           ((has_contact<A, Bs> == (ConvexBody3<A> && ConvexBody3<Bs>)) && ...) &&
           ((has_penetration<A, Bs> ==
             ((ConvexBody3<A> && ConvexBody3<Bs>) ||
              (SupportedFigure3<A> && SupportedFigure3<Bs> && (QuadricBody3<A> || QuadricBody3<Bs>)))) &&
            ...);
  };
  const auto rows = [&row]<class... As>(Types<As...> all) {
    std::vector<std::string> wrong;
    ((row(static_cast<const As*>(nullptr), all) ? void() : void(wrong.emplace_back(name_of(figure_kind<As>)))), ...);
    return wrong;
  };
  EXPECT_EQ(rows(pair_cases::Space{}), std::vector<std::string>());
  EXPECT_EQ(rows(pair_cases::Plane{}), std::vector<std::string>());
  EXPECT_TRUE((has_contact<VertexHull3, VertexHull3>)&&(has_contact<Posed<VertexHull3>, Aabb3>)&&(
      has_penetration<VertexHull3, VertexHull3>)&&(has_gjk<VertexHull3, Sphere3>));
  EXPECT_FALSE((has_contact<Foreign, VertexHull3>) || (has_contact<Foreign, Foreign>) || (has_gjk<int, Sphere3>));
}

/// Two cubes of corners that lie on one another: what they have in common is a face.
TEST(Requires, HullsOfCornersHaveAContact) {
  const auto cube = [](double z) {
    std::vector<Point3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({double(i & 1), double((i >> 1) & 1), z + double((i >> 2) & 1)});
    return corners;
  };
  const std::vector<Point3> low = cube(0), high = cube(1), far = cube(3);
  const auto touching = contact(VertexHull3{low}, VertexHull3{high});
  ASSERT_TRUE(touching);
  EXPECT_TRUE(touching->relation == Relation::touching && touching->distance == 0);
  EXPECT_EQ(touching->corners.size(), 4U);
  EXPECT_FALSE(contact(VertexHull3{low}, VertexHull3{far}));
  EXPECT_EQ(contact(VertexHull3{low}, VertexHull3{far}, {.margin = 2})->distance, 2);
}

}  // namespace
}  // namespace plumb
