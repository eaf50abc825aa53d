// Lines, rays and segments against one another: places by signs over doubles, then over pairs of doubles, then over
// integers; the numbers of the one pair of places likewise.
#include "arith/twofold.hpp"
#include "certify/carried_errors.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "query/body/figure_input.hpp"
#include "query/closest/linear_pair.hpp"
#include "query/closest/quick_numbers.hpp"
#include "query/closest/quick_pairs.hpp"

namespace plumb {
namespace {

using namespace query;

template <class T, class A, class B>
[[gnu::always_inline]] inline std::optional<SpotsOnLines> places_over(const A& a, const B& b) {
  CertainSigns ask;
  const SpotsOnLines places = closest_places<T>(linear<T>(a), linear<T>(b), ask);
  if (ask.certain()) return places;
  return {};
}

template <class Point>
[[gnu::noinline]] SpotsOnLines places_exactly(const Straight<Point>& a, const Straight<Point>& b) {
  return certainly<SignWorlds<Twofold<false>, Ball, BigDyadic>>(
      [&]<class T>(Carrying<T>& ask) { return closest_places<T>(linear<T>(a), linear<T>(b), ask); });
}

/// Where they cross no point of theirs is looked at, which may be none.
template <class A, class B>
inline constexpr bool are_lines_of_plane = std::is_same_v<A, Line2>&& std::is_same_v<B, Line2>;

template <class A, class B>
[[gnu::flatten]] SpotsOnLines places_of(const A& a, const B& b, std::string_view function) {
  if constexpr (are_lines_of_plane<A, B>) require_figures(function, a, b);
  if (const auto places = places_over<Approximate>(a, b)) [[likely]]
    return *places;
  require_figures(function, a, b);
  return places_exactly(straight(a), straight(b));
}

template <class T, class Point>
ClosePair<T, Point> pair_over(const Straight<Point>& a, const Straight<Point>& b, SpotsOnLines places) {
  return close_pair<T>(linear<T>(a), linear<T>(b), places);
}

/// What two doubles a number leave in doubt.
template <class Point>
[[gnu::noinline]] PairNumbers<Point> numbers_exactly(const Straight<Point>& a, const Straight<Point>& b,
                                                     SpotsOnLines places) {
  const auto quick = pair_over<Ball>(a, b, places);
  const auto p = nearest_point(quick.a), q = nearest_point(quick.b);
  const auto d = nearest_distance(quick);
  if (p && q && d) return {*p, *q, *d};
  const auto exact = pair_over<BigDyadic>(a, b, places);
  return {p ? *p : nearest_point(exact.a), q ? *q : nearest_point(exact.b), d ? *d : nearest_distance(exact)};
}
template <class Point>
[[gnu::noinline]] double distance_exactly(const Straight<Point>& a, const Straight<Point>& b, SpotsOnLines places) {
  if (const auto d = nearest_distance(pair_over<Ball>(a, b, places))) return *d;
  return nearest_distance(pair_over<BigDyadic>(a, b, places));
}

Feature feature(SpotOnLine place) {
  if (place == SpotOnLine::start) return {FeatureKind::vertex, 0};
  if (place == SpotOnLine::end) return {FeatureKind::vertex, 1};
  return {FeatureKind::edge, 0};
}

void name_lines(Closest& to) { to.feature_a = to.feature_b = feature(SpotOnLine::inside); }
void name_lines(double&) {}

/// In lanes, where they find the places too; those of lines are the insides, unless they are parallel.
bool told_at_once(const Segment3& a, const Segment3& b, auto& to) { return quickly(a, b, to); }
bool told_at_once(const Line3& a, const Line3& b, auto& to) {
  name_lines(to);
  return quickly(LineAt(a), LineAt(b), {SpotOnLine::inside, SpotOnLine::inside}, to);
}
template <class A, class B>
bool told_at_once(const A&, const B&, auto&) {
  return false;
}

template <class A, class B>
auto closest_of(const A& a, const B& b) {
  using Result = std::conditional_t<is_in_space<A>, Closest, Closest2>;
  constexpr std::string_view name = "closest_points";
  Result to;
  if (told_at_once(a, b, to)) [[likely]]
    return to;
  const SpotsOnLines places = places_of(a, b, name);
  to.feature_a = feature(places.a), to.feature_b = feature(places.b);
  if constexpr (is_in_space<A>) {
    if (quickly(LineAt(a), LineAt(b), places, to)) [[likely]]
      return to;
  }
  auto numbers = quick_numbers(straight(a), straight(b), places);
  if (!numbers) {
    require_figures(name, a, b);
    numbers = numbers_exactly(straight(a), straight(b), places);
  }
  to.on_a = numbers->on_a, to.on_b = numbers->on_b, to.distance = numbers->distance;
  return to;
}

std::optional<double> parameter(SpotOnLine place, const Ball& numerator, const Ball& whole) {
  if (place == SpotOnLine::inside) return quotient(numerator, whole).nearest();
  return place == SpotOnLine::end ? 1.0 : 0.0;
}

}  // namespace

template <class A, class B>
requires StraightPair2<A, B> Closest2 closest_points(const A& a, const B& b) { return closest_of(a, b); }
template <class A, class B>
requires StraightPair3<A, B> Closest closest_points(const A& a, const B& b) { return closest_of(a, b); }

template <class A, class B>
requires query::StraightPair<A, B>
double query::distance_as(Question question, const A& a, const B& b) {
  [[maybe_unused]] double quick;
  if (told_at_once(a, b, quick)) [[likely]]
    return quick;
  const SpotsOnLines places = places_of(a, b, name_of(question));
  if constexpr (is_in_space<A>) {
    if (quickly(LineAt(a), LineAt(b), places, quick)) [[likely]]
      return quick;
  }
  if (const auto d = quick_distance(straight(a), straight(b), places)) [[likely]]
    return *d;
  require_figures(question, a, b);
  return distance_exactly(straight(a), straight(b), places);
}

template <class A, class B>
requires query::StraightPair<A, B> Rational query::squared_distance_as(Question question, const A& a, const B& b) {
  require_figures(question, a, b);
  return square_of(pair_over<BigDyadic>(straight(a), straight(b), places_of(a, b, name_of(question))));
}

template <class A, class B>
requires LinearPair<A, B> std::array<double, 2> closest_parameters(const A& a, const B& b) {
  constexpr std::string_view name = "closest_parameters";
  require_figures(name, a, b);
  const SpotsOnLines places = places_of(a, b, name);
  const auto quick = pair_over<Ball>(straight(a), straight(b), places);
  const auto s = parameter(places.a, quick.a.numerator, quick.a.whole);
  const auto t = parameter(places.b, quick.b.numerator, quick.b.whole);
  if (s && t) return {*s, *t};
  const auto exact = pair_over<BigDyadic>(straight(a), straight(b), places);
  return {s ? *s : rounded_quotient(Rounding::nearest, exact.a.numerator, exact.a.whole),
          t ? *t : rounded_quotient(Rounding::nearest, exact.b.numerator, exact.b.whole)};
}

namespace query {

template <class A, class B>
requires StraightPair<A, B>
[[gnu::flatten]] std::optional<Sign> quick_comparison(const A& a, const B& b, double than) {
  if constexpr (are_lines_of_plane<A, B>) {
    if (!is_sound(a) || !is_sound(b)) return {};
  }
  CertainSigns ask;
  const auto p = linear<Approximate>(straight(a)), q = linear<Approximate>(straight(b));
  const auto pair = close_pair<Approximate>(p, q, closest_places<Approximate>(p, q, ask));
  const Approximate square = Approximate(than) * Approximate(than);
  const Sign s = ask(pair.square - square * pair.square_whole);
  if (!ask.certain()) return {};
  return than < 0 ? Sign::positive : s;
}

}  // namespace query

#define PLUMB_LINEAR_PAIR(Result, A, B)                                       \
  template Result closest_points(const A&, const B&);                         \
  template double query::distance_as(Question, const A&, const B&);           \
  template Rational query::squared_distance_as(Question, const A&, const B&); \
  template std::array<double, 2> closest_parameters(const A&, const B&);      \
  template std::optional<Sign> query::quick_comparison(const A&, const B&, double);
PLUMB_LINEAR_PAIR(Closest2, Line2, Line2)
PLUMB_LINEAR_PAIR(Closest2, Line2, Ray2)
PLUMB_LINEAR_PAIR(Closest2, Line2, Segment2)
PLUMB_LINEAR_PAIR(Closest2, Ray2, Ray2)
PLUMB_LINEAR_PAIR(Closest2, Ray2, Segment2)
PLUMB_LINEAR_PAIR(Closest2, Segment2, Segment2)
PLUMB_LINEAR_PAIR(Closest, Line3, Line3)
PLUMB_LINEAR_PAIR(Closest, Line3, Ray3)
PLUMB_LINEAR_PAIR(Closest, Line3, Segment3)
PLUMB_LINEAR_PAIR(Closest, Ray3, Ray3)
PLUMB_LINEAR_PAIR(Closest, Ray3, Segment3)
PLUMB_LINEAR_PAIR(Closest, Segment3, Segment3)
#undef PLUMB_LINEAR_PAIR

}  // namespace plumb
