// The laws of relate and intersects, for every pair of the table: swapped, renamed, mapped, and bad numbers refused.
#include <cmath>
#include <cstring>

#include "figure/basic/thrown.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_moves.hpp"

namespace plumb::pair_cases {
namespace {

/// Of all pairs together.
struct Seen {
  int cases = 0, moved = 0, sheared = 0, turned = 0;
  Answers answers;
};

/// What to say of a case, made only where it fails; a reference that is not a template for each pair.
class About {
 public:
  template <class F>
  About(const F& f) : f_(&f), call_([](const void* g) { return (*static_cast<const F*>(g))(); }) {}
  std::string operator()() const { return call_(f_); }

 private:
  const void* f_;
  std::string (*call_)(const void*);
};

void expect_relation(Relation got, Relation wanted, const char* law, About about) {
  EXPECT_EQ(got, wanted) << law << about();
}

void expect_meeting(bool got, Relation relation, const char* law, About about) {
  EXPECT_EQ(got, relation != Relation::disjoint) << law << about();
}

template <class A, class B>
void expect_laws(Seen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, cases_of_law, [&](Material& m) {
    const auto pair = pair_of<A, B>(m);
    const A& a = pair.first;  // named apart: lambdas of clang 14 take no structured bindings
    const B& b = pair.second;
    const Relation r = relate(a, b);
    const auto name = [&] { return pair_name<A, B>() + m.about(a, b); };
    ++seen.cases;
    seen.answers.add(r);
    expect_relation(relate(b, a), r, "swapped: ", name);
    expect_meeting(intersects(a, b), r, "", name);
    expect_meeting(intersects(b, a), r, "swapped: ", name);
    expect_relation(relate(renamed(m, a), renamed(m, b)), r, "renamed: ", name);
    const MapKind kind = map_kind<A, B>(m);
    Map map(m, figure_dimension<A>, kind, m.below(2) == 0);
    const A c = mapped(a, map);
    const B d = mapped(b, map);
    if (!map.exact()) return;
    ++seen.moved;
    seen.sheared += kind == MapKind::sheared;
    seen.turned += kind == MapKind::turned;
    expect_relation(relate(c, d), r, "mapped: ", [&] { return name() + " to" + m.about(c, d); });
  });
}

template <class All>
void expect_laws_of_all(std::uint64_t start) {
  Seen seen;
  on_pairs(All{}, [&]<class A, class B>(const A*, const B*) { expect_laws<A, B>(seen, start++); });
  std::printf("%d cases, %d mapped, %d of them sheared, %d turned; disjoint %d, touching %d, overlapping %d\n",
              seen.cases, seen.moved, seen.sheared, seen.turned, seen.answers.of(Relation::disjoint),
              seen.answers.of(Relation::touching), seen.answers.of(Relation::overlapping));
  EXPECT_GT(seen.moved * 2, seen.cases);
  EXPECT_GT(seen.sheared * 20, seen.cases);
  EXPECT_GT(seen.turned * 20, seen.cases);
  EXPECT_GT(seen.answers.of(Relation::touching) * 20, seen.cases);
}

TEST(OverlapLaws, HoldForAllPairsOfThePlane) { expect_laws_of_all<Plane>(701); }
TEST(OverlapLaws, HoldForAllPairsOfSpace) { expect_laws_of_all<Space>(1001); }

/// One of its numbers is no longer real.
template <class Shape>
Shape spoiled(Material& m, Shape s) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if constexpr (requires { s.outer; }) {
    s.outer.vertices[m.below(s.outer.vertices.size())].y = nan;
  } else if constexpr (requires { s.vertices; }) {
    s.vertices[m.below(s.vertices.size())].x = nan;
  } else if constexpr (requires { s.directions; }) {
    s.max[m.below(s.max.size())] = nan;
  } else if constexpr (requires { s.halfspaces; }) {
    s.halfspaces.push_back({{}, nan});
  } else if constexpr (requires { s.mesh; }) {
    s.mesh.vertices[s.mesh.corners[m.below(s.mesh.corners.size())]].x = nan;
  } else {
    std::array<double, sizeof(Shape) / sizeof(double)> numbers;
    std::memcpy(numbers.data(), &s, sizeof(Shape));
    numbers[m.below(numbers.size())] = nan;
    std::memcpy(&s, numbers.data(), sizeof(Shape));
  }
  return s;
}

/// What a text calls the figure that is bad, of two in this order.
template <class Bad, class Other>
std::string_view called(bool first) {
  constexpr std::array<std::string_view, figure_kinds> names{
      "point",       "line",     "ray",           "segment",      "plane",         "plane_of_points",
      "halfspace",   "triangle", "quadrilateral", "polygon",      "holed_polygon", "rectangle",
      "tetrahedron", "sphere",   "aabb",          "obb",          "capsule",       "lozenge",
      "cylinder",    "cone",     "k_dop",         "intersection", "polyhedron",    "cap"};
  if (figure_kind<Bad> == figure_kind<Other>) return first ? "a" : "b";
  if (std::is_same_v<Bad, Circle2>) return "circle";
  return names[static_cast<std::size_t>(figure_kind<Bad>)];
}

/// A call to be made while it is alive; std::function would take half a minute to compile for all pairs.
class Ask {
 public:
  template <class F>
  Ask(const F& f) : f_(&f), call_([](const void* g) { (*static_cast<const F*>(g))(); }) {}
  void operator()() const { call_(f_); }

 private:
  const void* f_;
  void (*call_)(const void*);
};

void expect_refusal(std::string_view function, std::string_view name, Ask ask) {
  try {
    ask();
    ADD_FAILURE() << function << " answered";
  } catch (const NonFinite& e) {
    const std::string text = e.what(), start = std::string(function).append(": ").append(name);
    EXPECT_TRUE(text.starts_with(start + ".") || text.starts_with(start + " ")) << text << "; wanted " << start;
    EXPECT_NE(text.find("is nan, not a real number"), text.npos) << text;
  }
}

/// By every function that takes the two, one of which is bad.
template <class A, class B>
void expect_refused(const A& a, const B& b, std::string_view name, bool first) {
  const auto expect = [&](std::string_view function, Ask ask) { expect_refusal(function, name, ask); };
  expect("relate", [&] { (void)relate(a, b); });
  expect("intersects", [&] { (void)intersects(a, b); });
  if constexpr (requires {
                  { intersection(a, b) } -> figure::Answer;
                })
    expect("intersection", [&] { (void)intersection(a, b); });
  if constexpr (requires {
                  { first_hit(a, b) } -> figure::Answer;
                }) {
    expect("first_hit", [&] { (void)first_hit(a, b); });
    expect("first_hit_parameter", [&] { (void)first_hit_parameter(a, b); });
  }
  if constexpr (requires { hits(a, b); }) expect("hits", [&] { (void)hits(a, b); });
  if constexpr (MovingPair<A, B>) {
    const Translating<A> moving{a, {}};
    const auto moves = [&](std::string_view function, Ask ask) {
      expect_refusal(function, first ? "a.shape" : "b.shape", ask);
    };
    moves("first_contact", [&] { (void)first_contact(moving, b); });
    moves("first_contact_time", [&] { (void)first_contact_time(moving, b); });
    moves("intersects", [&] { (void)intersects(moving, b); });
  }
  if (name == "polyhedron") return;  // its numbers were looked at when it was made
  if constexpr (HasDistance<A, B>) {
    expect("distance", [&] { (void)distance(a, b); });
    expect("closest_points", [&] { (void)closest_points(a, b); });
    expect("exact_distance", [&] { (void)exact_distance(a, b); });
    expect("compare_distance", [&] { (void)compare_distance(a, b, 1); });
  }
  if constexpr (requires { squared_distance_exact(a, b); })
    expect("squared_distance_exact", [&] { (void)squared_distance_exact(a, b); });
  if constexpr (requires { closest_point(a, b); }) expect("closest_point", [&] { (void)closest_point(a, b); });
  if constexpr (requires { closest_parameters(a, b); })
    expect("closest_parameters", [&] { (void)closest_parameters(a, b); });
}

template <class A, class B>
void expect_bad_numbers_refused(std::uint64_t start) {
  shape_cases::on_shapes(start, 2, [&](Material& m) {
    const auto [a, b] = pair_of<A, B>(m);
    const A bad_a = spoiled(m, a);
    const B bad_b = spoiled(m, b);
    SCOPED_TRACE((pair_name<A, B>() + m.about(bad_a, bad_b)));
    expect_refused(bad_a, b, called<A, B>(true), true);
    expect_refused(b, bad_a, called<A, B>(false), false);
    expect_refused(a, bad_b, called<B, A>(false), false);
    expect_refused(bad_b, a, called<B, A>(true), true);
  });
}

TEST(OverlapLaws, RefuseBadNumbersInAllPairs) {
  std::uint64_t start = 2001;
  const auto check = [&]<class A, class B>(const A*, const B*) { expect_bad_numbers_refused<A, B>(start++); };
  on_pairs(Plane{}, check);
  on_pairs(Space{}, check);
}

TEST(OverlapLaws, NameWhatWasAskedOfTwoPairs) {
  const Point3 good{0, 0, 0}, bad{0, std::nan(""), 0};
  const Sphere3 inverted{{0, 0, 0}, -1};
  expect_refusal("compare_distance", "b", [&] { (void)compare_distance(good, bad, good, good); });
  expect_refusal("compare_distance, second pair", "a", [&] { (void)compare_distance(good, good, bad, good); });
  EXPECT_TRUE(text_of<InvalidShape>([&] {
                (void)compare_distance(good, good, good, inverted);
              }).starts_with("compare_distance, second pair: sphere.radius is negative"));
  const Polygon3 bent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}};
  const auto asked_of_bent = [&](const auto& round) {
    EXPECT_TRUE(text_of<InvalidShape>([&] { (void)intersects(bent, round); }).starts_with("intersects: the polygon"));
    EXPECT_TRUE(text_of<InvalidShape>([&] { (void)relate(bent, round); }).starts_with("relate: the polygon"));
  };
  asked_of_bent(Sphere3{{0, 0, 0}, 0});
  asked_of_bent(Sphere3{{0, 0, 0}, 1});
  asked_of_bent(Capsule3{{0, 0, 0}, {1, 0, 0}, 0});
  asked_of_bent(Lozenge3{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}, 0});
}

template <class A, class B>
std::string refusal(const A& a, const B& b) {
  try {
    relate(a, b);
  } catch (const InvalidShape& e) {
    return e.what();
  }
  return "answered";
}

TEST(OverlapLaws, RefuseWhatIsNoShape) {
  const Segment3 s{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(refusal(Polygon3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}}, s),
            "relate: the polygon is not planar: its vertex 3 is off the plane of the vertices 0, 1 and 2; triangulate "
            "it");
  EXPECT_EQ(refusal(s, Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}),
            "relate: the quadrilateral is not planar: its vertex 3 is off the plane of the vertices 0, 1 and 2; "
            "triangulate it");
  EXPECT_EQ(refusal(HoledPolygon2{{{{0, 0}, {1, 0}, {0, 1}}}, {{{{0, 0}}}}}, Point2{0, 0}),
            "relate: holed_polygon.holes[0].vertices has 1 vertex; a polygon has three at least");
  EXPECT_EQ(refusal(ConvexPolyhedron3{}, s), "relate: polyhedron has no faces; make it by convex_polyhedron");
  EXPECT_EQ(refusal(KDop3{k_dop_directions(6), {0, 0, 0}, {1, 1}}, s),
            "relate: k_dop has 3 entries in min and 2 in max for 3 directions; give one for each");
  EXPECT_NE(refusal(Sphere3{{0, 0, 0}, -1}, s), "answered");
  EXPECT_NE(refusal(Capsule3{{0, 0, 0}, {0, 0, 0}, -1}, Polygon3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}), "answered");
}

}  // namespace
}  // namespace plumb::pair_cases
