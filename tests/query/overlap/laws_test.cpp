// The laws of relate and intersects, for every pair of the table: swapped, renamed, mapped, and bad numbers refused.
#include <cmath>

#include "figure/basic/thrown.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/query/separation/separation.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"

namespace plumb::pair_cases {
namespace {

/// Of all pairs together.
struct Seen {
  int cases = 0, moved = 0, sheared = 0, turned = 0;
  Answers answers;
};

void expect_laws(const PairRow& pair, Seen& seen, std::uint64_t start) {
  shape_cases::on_shapes(start, cases_of_law, [&](Material& m) {
    const AnyPair drawn = pair_of(pair, m);
    const AnyFigure &a = drawn.a, &b = drawn.b;
    const Relation r = relate(pair, a, b);
    const auto name = [&] { return pair.name() + about(m, a, b); };
    ++seen.cases;
    seen.answers.add(r);
    EXPECT_EQ(relate_back(pair, b, a), r) << "swapped: " << name();
    EXPECT_EQ(intersects(pair, a, b), r != Relation::disjoint) << name();
    EXPECT_EQ(intersects_back(pair, b, a), r != Relation::disjoint) << "swapped: " << name();
    const AnyFigure other_a = renamed(m, a);
    EXPECT_EQ(relate(pair, other_a, renamed(m, b)), r) << "renamed: " << name();
    const MapKind kind = map_kind(a.row().kind, b.row().kind, m);
    Map map(m, pair.dimension(), kind, m.below(2) == 0);
    const AnyFigure c = mapped(a, map), d = mapped(b, map);
    if (!map.exact()) return;
    ++seen.moved;
    seen.sheared += kind == MapKind::sheared;
    seen.turned += kind == MapKind::turned;
    EXPECT_EQ(relate(pair, c, d), r) << "mapped: " << name() << " to" << about(m, c, d);
  });
}

template <class All>
void expect_laws_of_all(std::uint64_t start) {
  Seen seen;
  for (const PairRow& pair : pairs_of(All{})) expect_laws(pair, seen, start++);
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

/// What a text calls the figure that is bad, of two in this order.
std::string_view called(const FigureRow& bad, const FigureRow& other, bool first) {
  constexpr std::array<std::string_view, figure_kinds> names{
      "point",       "line",     "ray",           "segment",      "plane",         "plane_of_points",
      "halfspace",   "triangle", "quadrilateral", "polygon",      "holed_polygon", "rectangle",
      "tetrahedron", "sphere",   "aabb",          "obb",          "capsule",       "lozenge",
      "cylinder",    "cone",     "k_dop",         "intersection", "polyhedron",    "cap"};
  if (bad.kind == other.kind) return first ? "a" : "b";
  if (bad.kind == FigureKind::ball && bad.dimension == 2) return "circle";
  return names[static_cast<std::size_t>(bad.kind)];
}

/// A call to be made while it is alive.
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

/// The functions beside those of PairQuestions that take two figures, each asked by its own name.
enum class Other : unsigned char {
  intersection,
  first_hit,
  first_hit_parameter,
  hits,
  moving_first_contact,  // of the first, translating, and the second
  moving_first_contact_time,
  moving_intersects,
  compare_distance,  // from here on not asked of polyhedra, whose numbers were looked at when they were made
  squared_distance_exact,
  closest_point,
  closest_parameters,
};
constexpr std::size_t others = 11;
constexpr std::array<std::string_view, others> names_of_others{
    "intersection",           "first_hit",          "first_hit_parameter", "hits",
    "first_contact",          "first_contact_time", "intersects",          "compare_distance",
    "squared_distance_exact", "closest_point",      "closest_parameters"};
constexpr bool is_moving(Other o) { return o >= Other::moving_first_contact && o <= Other::moving_intersects; }

template <Other O, class A, class B>
void ask_other(const void* first, const void* second) {
  const A& a = *static_cast<const A*>(first);
  const B& b = *static_cast<const B*>(second);
  if constexpr (O == Other::intersection) (void)intersection(a, b);
  if constexpr (O == Other::first_hit) (void)first_hit(a, b);
  if constexpr (O == Other::first_hit_parameter) (void)first_hit_parameter(a, b);
  if constexpr (O == Other::hits) (void)hits(a, b);
  if constexpr (O == Other::moving_first_contact) (void)first_contact(Translating<A>{a, {}}, b);
  if constexpr (O == Other::moving_first_contact_time) (void)first_contact_time(Translating<A>{a, {}}, b);
  if constexpr (O == Other::moving_intersects) (void)intersects(Translating<A>{a, {}}, b);
  if constexpr (O == Other::compare_distance) (void)compare_distance(a, b, 1);
  if constexpr (O == Other::squared_distance_exact) (void)squared_distance_exact(a, b);
  if constexpr (O == Other::closest_point) (void)closest_point(a, b);
  if constexpr (O == Other::closest_parameters) (void)closest_parameters(a, b);
}

using Asked = void (*)(const void*, const void*);
struct OthersOfPair {
  FigureKind a, b;
  std::array<Asked, others> ask;
};
template <class A, class B>
consteval OthersOfPair others_of_pair() {
  OthersOfPair of{figure_kind<A>, figure_kind<B>, {}};
  const auto add = [&of](Other o, Asked ask) { of.ask[static_cast<std::size_t>(o)] = ask; };
  if constexpr (!RelatedPair<A, B>) return of;
  if constexpr (Intersectable<A, B>) add(Other::intersection, &ask_other<Other::intersection, A, B>);
  if constexpr (Hittable<A, B>) {
    add(Other::first_hit, &ask_other<Other::first_hit, A, B>);
    add(Other::first_hit_parameter, &ask_other<Other::first_hit_parameter, A, B>);
  }
  if constexpr (requires(const A& a, const B& b) { hits(a, b); }) add(Other::hits, &ask_other<Other::hits, A, B>);
  if constexpr (MovingPair<A, B>) {
    add(Other::moving_first_contact, &ask_other<Other::moving_first_contact, A, B>);
    add(Other::moving_first_contact_time, &ask_other<Other::moving_first_contact_time, A, B>);
    add(Other::moving_intersects, &ask_other<Other::moving_intersects, A, B>);
  }
  if constexpr (HasDistance<A, B>) add(Other::compare_distance, &ask_other<Other::compare_distance, A, B>);
  if constexpr (requires(const A& a, const B& b) { squared_distance_exact(a, b); })
    add(Other::squared_distance_exact, &ask_other<Other::squared_distance_exact, A, B>);
  if constexpr (requires(const A& a, const B& b) { closest_point(a, b); })
    add(Other::closest_point, &ask_other<Other::closest_point, A, B>);
  if constexpr (requires(const A& a, const B& b) { closest_parameters(a, b); })
    add(Other::closest_parameters, &ask_other<Other::closest_parameters, A, B>);
  return of;
}
template <class A, class... Bs>
constexpr std::array<OthersOfPair, sizeof...(Bs)> others_of_first{others_of_pair<A, Bs>()...};

template <class... Shapes>
const OthersOfPair& others_of(Types<Shapes...>, const FigureRow& a, const FigureRow& b) {
  for (const std::span<const OthersOfPair> first :
       {std::span<const OthersOfPair>(others_of_first<Shapes, Shapes...>)...}) {
    for (const OthersOfPair& of : first) {
      if (of.a == a.kind && of.b == b.kind) return of;
    }
  }
  throw std::logic_error("no such pair");
}

/// By every function that takes the two, one of which is bad; how many there are.
template <class All>
int expect_refused(All all, const PairQuestions& pair, const AnyFigure& a, const AnyFigure& b, std::string_view name,
                   bool first) {
  int asked = 0;
  const auto expect = [&](std::string_view function, std::string_view bad, auto ask) {
    ++asked;
    expect_refusal(function, bad, [&] { (void)ask(a.shape(), b.shape()); });
  };
  const auto expect_others = [&](std::size_t from, std::size_t to) {
    const OthersOfPair& of = others_of(all, a.row(), b.row());
    for (std::size_t i = from; i < to; ++i) {
      if (of.ask[i] == nullptr) continue;
      const bool moving = is_moving(static_cast<Other>(i));
      expect(names_of_others[i], moving ? first ? "a.shape" : "b.shape" : name, of.ask[i]);
    }
  };
  const bool is_sound = name == "polyhedron";  // its numbers were looked at when it was made
  if (!is_sound) {
    expect("relate", name, pair.relate);
    expect("intersects", name, pair.intersects);
  }
  constexpr auto of_distance = static_cast<std::size_t>(Other::compare_distance);
  expect_others(0, of_distance);
  if (is_sound) return asked;
  if (pair.distance != nullptr) {
    expect("distance", name, pair.distance);
    expect("closest_points", name, pair.closest_points);
    expect("exact_distance", name, pair.exact_distance);
  }
  expect_others(of_distance, others);
  return asked;
}

template <class All>
int expect_bad_numbers_refused(All all, const PairRow& pair, std::uint64_t start) {
  int asked = 0;
  shape_cases::on_shapes(start, 2, [&](Material& m) {
    const auto [a, b] = pair_of(pair, m);
    const AnyFigure bad_a = spoiled(m, a), bad_b = spoiled(m, b);
    SCOPED_TRACE(pair.name() + about(m, bad_a, bad_b));
    const FigureRow &of_a = a.row(), &of_b = b.row();
    asked += expect_refused(all, pair.forth, bad_a, b, called(of_a, of_b, true), true);
    asked += expect_refused(all, pair.back, b, bad_a, called(of_a, of_b, false), false);
    asked += expect_refused(all, pair.forth, a, bad_b, called(of_b, of_a, false), false);
    asked += expect_refused(all, pair.back, bad_b, a, called(of_b, of_a, true), true);
  });
  return asked;
}

TEST(OverlapLaws, RefuseBadNumbersInAllPairs) {
  std::uint64_t start = 2001;
  int asked = 0;
  for (const PairRow& pair : pairs_of(Plane{})) asked += expect_bad_numbers_refused(Plane{}, pair, start++);
  for (const PairRow& pair : pairs_of(Space{})) asked += expect_bad_numbers_refused(Space{}, pair, start++);
  std::printf("%d questions refused\n", asked);
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
  return text_of<InvalidShape>([&] { relate(a, b); });
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
  EXPECT_NE(refusal(Sphere3{{0, 0, 0}, -1}, s), "nothing thrown");
  EXPECT_NE(refusal(Capsule3{{0, 0, 0}, {0, 0, 0}, -1}, Polygon3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}), "nothing thrown");
}

}  // namespace
}  // namespace plumb::pair_cases
