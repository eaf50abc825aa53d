// Which questions take a kind of figure as it stands and not under every pose?  By the compiler, against the list below;
// and where they take it, does an AnyFigure at either place answer as the kinds do under the same poses, bit for bit?
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "plumb/figure/basic/polyhedron.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/variant/outcome.hpp"

namespace plumb::pair_cases {
namespace {

using Some = plumb::AnyFigure;

/// Along no axis; of the plane and of space alike.
template <class Shape>
constexpr bool is_of_plane = false;
template <PosedOrNot Shape>
constexpr bool is_of_plane<Shape> = figure_dimension<query::UnposedType<Shape>> == 2;
template <class Shape>
auto way_of(const Shape&) {
  if constexpr (is_of_plane<Shape>) {
    return Vector2{-7, 2};
  } else {
    return Vector3{-7, 2, 0};
  }
}

#define PLUMB_ASKED(Name, text, ...)                                   \
  struct Name {                                                        \
    static constexpr const char* name = text;                          \
    template <class A, class B>                                        \
    static constexpr bool takes = requires(const A& a, const B& b) {   \
      __VA_ARGS__;                                                     \
    };                                                                 \
    template <class A, class B>                                        \
    static std::string told(const A& a, [[maybe_unused]] const B& b) { \
      return outcome([&] { return __VA_ARGS__; });                     \
    }                                                                  \
  };
// Of a figure and a box.
PLUMB_ASKED(AskRelate, "relate", relate(a, b))
PLUMB_ASKED(AskIntersects, "intersects", intersects(a, b))
PLUMB_ASKED(AskContains, "contains", contains(a, b))
PLUMB_ASKED(AskWithin, "contains, the other way round", contains(b, a))
PLUMB_ASKED(AskDistance, "distance", distance(a, b))
PLUMB_ASKED(AskExactDistance, "exact_distance", exact_distance(a, b))
PLUMB_ASKED(AskSquare, "squared_distance_exact", squared_distance_exact(a, b))
PLUMB_ASKED(AskCompare, "compare_distance", compare_distance(a, b, 1.0))
PLUMB_ASKED(AskClosest, "closest_points", closest_points(a, b))
PLUMB_ASKED(AskIntersection, "intersection", intersection(a, b))
PLUMB_ASKED(AskFirstContact, "first_contact", first_contact(Translating{a, way_of(a)}, b))
PLUMB_ASKED(AskContactTime, "first_contact_time", first_contact_time(Translating{a, way_of(a)}, b))
PLUMB_ASKED(AskMeet, "intersects in motion", intersects(Translating{a, way_of(a)}, b))
PLUMB_ASKED(AskSpan, "first_contact_span",
            first_contact_span(Translating{a, way_of(a)}, Translating{b, way_of(b)}).has_value())
PLUMB_ASKED(AskGjk, "gjk", gjk(a, b).closest)
PLUMB_ASKED(AskGjkIntersects, "gjk_intersects", gjk_intersects(a, b))
PLUMB_ASKED(AskGjkDistance, "gjk_distance", gjk_distance(a, b))
PLUMB_ASKED(AskGjkMoving, "gjk_intersects_moving", gjk_intersects_moving(a, Vector3{1, 2, 3}, b))
PLUMB_ASKED(AskGjkApart, "gjk_distance_moving", gjk_distance_moving(a, Vector3{1, 2, 3}, b))
PLUMB_ASKED(AskGjkBounds, "gjk_bounds", gjk_bounds(a, b, {.within = 1e-3}))
PLUMB_ASKED(AskPenetration, "penetration", std::optional<Penetration>(penetration(a, b)))
PLUMB_ASKED(AskExactPenetration, "exact_penetration", exact_penetration(a, b).has_value())
PLUMB_ASKED(AskAlong, "penetration_along", penetration_along(a, b, Vector3{0, 0, 1}).has_value())
PLUMB_ASKED(AskPenetrationBounds, "penetration_bounds", penetration_bounds(a, b, {.within = 1e-3}).upper)
PLUMB_ASKED(AskContact, "contact", contact(a, b, {.margin = 4}))
PLUMB_ASKED(AskExactContact, "exact_contact", exact_contact(a, b, 4).has_value())
// Of a figure and a ray, a point, a polyhedron, a triangle or a segment.
PLUMB_ASKED(AskHit, "first_hit", first_hit(b, a))
PLUMB_ASKED(AskHitParameter, "first_hit_parameter", first_hit_parameter(b, a))
PLUMB_ASKED(AskHits, "hits", hits(b, a))
PLUMB_ASKED(AskPlace, "contains of a point", contains(a, b))
PLUMB_ASKED(AskLocate, "locate", locate(a, b))
PLUMB_ASKED(AskFit, "fit_aabb", fit_aabb(a))
PLUMB_ASKED(AskSupport, "support_point", support_point(a, way_of(a)))
PLUMB_ASKED(AskSupportValue, "support_value", support_value(a, way_of(a), Rounding::up))
PLUMB_ASKED(AskClip, "vclip", vclip(a, b).closest)
PLUMB_ASKED(AskAxis, "separating_axis", separating_axis(a, b).has_value())
PLUMB_ASKED(AskVector, "separating_vector", separating_vector(a, b).disjoint)
PLUMB_ASKED(AskMoving, "first_contact of Moving", first_contact(Moving<A>{a, a}, Moving<B>{b, b}))
#undef PLUMB_ASKED

template <class... Asked>
struct Questions {};
using OfABox =
    Questions<AskRelate, AskIntersects, AskContains, AskWithin, AskDistance, AskExactDistance, AskSquare, AskCompare,
              AskClosest, AskIntersection, AskFirstContact, AskContactTime, AskMeet, AskSpan, AskGjk, AskGjkIntersects,
              AskGjkDistance, AskGjkMoving, AskGjkApart, AskGjkBounds, AskPenetration, AskExactPenetration, AskAlong,
              AskPenetrationBounds, AskContact, AskExactContact>;
using OfARay = Questions<AskHit, AskHitParameter, AskHits>;
using OfAPoint = Questions<AskPlace, AskLocate, AskFit, AskSupport, AskSupportValue>;
using OfAPolyhedron = Questions<AskClip, AskAxis, AskVector>;
using OfMovingCorners = Questions<AskMoving>;

/// What is refused, of these kinds or of all that the question takes, and why that is so.
struct Gap {
  std::string_view what;
  std::set<std::string_view> kinds;
  std::string_view why;
};
const std::array gaps{
    Gap{"support_point under no pose", {}, "the point is none of doubles; gjk_bounds takes it with its rounding"},
    Gap{"first_contact_span under no pose", {}, "first_contact_time is the time itself"},
    Gap{"first_contact_span not of AnyFigure", {}, "first_contact_time is the time itself"},
};

/// What the compiler says of one question and one kind: as it stands, under a matrix, a RigidPose, a chain; an AnyFigure.
struct Taken {
  bool stands, by_matrix, by_turn, by_chain, any;
};
struct Seen {
  std::map<std::string, std::set<std::string_view>> refused_kinds;
  int answers = 0, refused = 0;

  void note(const char* question, FigureKind kind, const Taken& taken) {
    const auto add = [&](bool is_gap, const char* what) {
      if (is_gap) refused_kinds[std::string(question) + what].insert(name_of(kind));
    };
    add(taken.stands && !taken.by_turn && !taken.by_matrix, " under no pose");
    add(taken.by_turn != taken.by_matrix || taken.by_turn != taken.by_chain, " not under every pose");
    add((taken.stands || taken.by_turn) && !taken.any, " not of AnyFigure");
  }
  void expect(const std::string& any, const std::optional<std::string>& of_kinds, const std::string& about) {
    if (of_kinds) {
      ++answers, refused += any.find(": ") != std::string::npos;
      EXPECT_EQ(any, *of_kinds) << about;
    } else {
      EXPECT_TRUE(any.starts_with("Unsupported")) << about << ": " << any;
    }
  }
};

template <class Ask, class A, class B>
void expect_as_kinds(const A& a, const B& b, const RigidPose& turn, Seen& seen) {
  constexpr bool is_flat = figure_dimension<A> == 2;
  using Rigid = std::conditional_t<is_flat, RigidPose2, RigidPose>;
  constexpr Taken taken{Ask::template takes<A, B>,
                        Ask::template takes<Posed<A, std::conditional_t<is_flat, Pose2, Pose>>, B>,
                        Ask::template takes<Posed<A, Rigid>, B>,
                        Ask::template takes<Posed<A, std::conditional_t<is_flat, RigidChain2, RigidChain>>, B>,
                        Ask::template takes<Some, B>};
  seen.note(Ask::name, figure_kind<A>, taken);
  if constexpr (taken.any) {
    Posed<A, Rigid> posed{a, {}};
    if constexpr (is_flat) {
      posed.pose = flat_of(turn);
    } else {
      posed.pose = turn;
    }
    const Some some_a = posed, some_b = b;
    const std::string any = Ask::told(some_a, b),
                      about = Ask::name + (": " + to_string(some_a) + "; ") + to_string(some_b);
    std::optional<std::string> of_kinds;
    if constexpr (taken.by_turn) of_kinds = Ask::told(posed, b);
    seen.expect(any, of_kinds, about);
    if constexpr (Ask::template takes<Some, Some>) seen.expect(any, Ask::told(some_a, some_b), about);
  }
}
template <class... Asked, class A, class B>
void expect_each(Questions<Asked...>, const A& a, const B& b, const RigidPose& turn, Seen& seen) {
  (expect_as_kinds<Asked>(a, b, turn, seen), ...);
}

template <class A>
void expect_of_kind(Material& m, Seen& seen) {
  const RigidPose turn = rigid_pose(m);
  const A a = figure<A>(m);
  if constexpr (figure_dimension<A> == 2) {
    expect_each(OfABox(), a, near_figure<Aabb2>(m), turn, seen);
    expect_each(OfARay(), a, near_figure<Ray2>(m), turn, seen);
    expect_each(OfAPoint(), a, near_figure<Point2>(m), turn, seen);
  } else {
    expect_each(OfABox(), a, near_figure<Aabb3>(m), turn, seen);
    expect_each(OfARay(), a, near_figure<Ray3>(m), turn, seen);
    expect_each(OfAPoint(), a, near_figure<Point3>(m), turn, seen);
    expect_each(OfAPolyhedron(), a, near_figure<ConvexPolyhedron3>(m), turn, seen);
    expect_each(OfMovingCorners(), a, near_figure<Triangle3>(m), turn, seen);
    expect_each(OfMovingCorners(), a, near_figure<Segment3>(m), turn, seen);
  }
}
template <class... Shapes>
void expect_of_kinds(Types<Shapes...>, Seen& seen, std::uint64_t start) {
  (shape_cases::on_shapes(start++, 6, [&](Material& m) { expect_of_kind<Shapes>(m, seen); }), ...);
}

TEST(AnyFigure, AnswersAsPosedKinds) {
  Seen seen;
  expect_of_kinds(Plane{}, seen, 23'000);
  expect_of_kinds(Space{}, seen, 23'100);
  std::printf("%d answers, %d of them errors\n", seen.answers, seen.refused);
  EXPECT_GT(seen.answers, 8000);
  for (const auto& [what, kinds] : seen.refused_kinds) {
    for (const std::string_view kind : kinds) {
      EXPECT_TRUE(std::ranges::any_of(gaps,
                                      [&, &what = what](const Gap& gap) {
                                        return gap.what == what && (gap.kinds.empty() || gap.kinds.contains(kind));
                                      }))
          << what << ": " << kind << " is no gap of the list: close it, or say why it is one";
    }
  }
  for (const Gap& gap : gaps) {
    const auto& kinds = seen.refused_kinds[std::string(gap.what)];
    EXPECT_FALSE(kinds.empty()) << gap.what << " is a gap no longer: " << gap.why;
    for (const std::string_view kind : gap.kinds)
      EXPECT_TRUE(kinds.contains(kind)) << gap.what << ": " << kind << " is a gap no longer: " << gap.why;
  }
}

}  // namespace
}  // namespace plumb::pair_cases
