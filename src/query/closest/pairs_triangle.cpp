// Triangles against lines, rays, segments and triangles.
#include "figure/basic/in_space.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "query/body/figure_input.hpp"
#include "query/closest/quick_numbers.hpp"
#include "query/closest/quick_pairs.hpp"
#include "query/closest/straight_guess.hpp"
#include "query/closest/straight_search.hpp"

namespace plumb {
namespace {

using namespace query;

template <class T, class A, class B>
std::optional<Found<T>> found_over(const A& a, const B& b, const Shortlist& list) {
  CertainSigns ask;
  const StraightBody<T> p = body_of<T>(a, ask), q = body_of<T>(b, ask);
  const auto found = FeatureSearch<T>(p, q, list, ask).run();
  if (ask.certain()) return found;
  return {};
}

const Triangle3& in_one_form(const Triangle3& t) { return t; }
Straight<Point3> in_one_form(const Line3& s) { return straight(s); }
Straight<Point3> in_one_form(const Ray3& s) { return straight(s); }
Straight<Point3> in_one_form(const Segment3& s) { return straight(s); }

/// The edge or vertex of this number as a line, and the place on it.
struct OnLine {
  Straight<Point3> line;
  SpotOnLine place;
};
OnLine on_line(const Straight<Point3>& s, Feature f) {
  if (f.kind == FeatureKind::edge) return {s, SpotOnLine::inside};
  return {s, f.index == 0 ? SpotOnLine::start : SpotOnLine::end};
}
OnLine on_line(const Triangle3& t, Feature f) {
  const std::array corner{t.a, t.b, t.c};
  return {straight(Segment3{corner[f.index], corner[(f.index + 1) % 3]}),
          f.kind == FeatureKind::edge ? SpotOnLine::inside : SpotOnLine::start};
}

const Triangle3* triangle_of(const Straight<Point3>&) { return nullptr; }
const Triangle3* triangle_of(const Triangle3& t) { return &t; }

PairNumbers<Point3> turned(const PairNumbers<Point3>& n) { return {n.on_b, n.on_a, n.distance}; }

/// Of a feature that is not the face, with the face of a triangle.
std::optional<PairNumbers<Point3>> numbers_on_face(const OnLine& from, const Triangle3& face) {
  if (from.place != SpotOnLine::inside) return quick_numbers(from.line.at(from.place), face);
  const auto crossing = quick_crossing(from.line, face);
  if (!crossing) return {};
  return PairNumbers<Point3>{*crossing, *crossing, 0};
}

template <class A, class B>
std::optional<PairNumbers<Point3>> numbers_of(const A& a, const B& b, const FeaturePair& f) {
  if (f.b == the_face) return numbers_on_face(on_line(a, f.a), *triangle_of(b));
  if (f.a == the_face) {
    const auto numbers = numbers_on_face(on_line(b, f.b), *triangle_of(a));
    if (!numbers) return {};
    return turned(*numbers);
  }
  const OnLine p = on_line(a, f.a), q = on_line(b, f.b);
  return quick_numbers(p.line, q.line, {p.place, q.place});
}

void turn(Closest& c) { c = swapped(c); }
void turn(double&) {}
void name_vertex(const Point3& v, Closest& c) { c.on_a = told(v); }
void name_vertex(const Point3&, double&) {}

LineAt line_at(const Straight<Point3>& s, Feature) {
  LineAt line(s.from, s.to);
  if (!s.ends) line.to = nullptr, line.direction = &s.direction;
  return line;
}
LineAt line_at(const Triangle3& t, Feature f) {
  const std::array corner{&t.a, &t.b, &t.c};
  return {*corner[f.index], *corner[(f.index + 1) % 3]};
}
SpotOnLine place_at(const Straight<Point3>&, Feature f) {
  if (f.kind == FeatureKind::edge) return SpotOnLine::inside;
  return f.index == 0 ? SpotOnLine::start : SpotOnLine::end;
}
SpotOnLine place_at(const Triangle3&, Feature f) {
  return f.kind == FeatureKind::edge ? SpotOnLine::inside : SpotOnLine::start;
}

/// In lanes: all but the points of an edge that crosses a face.
template <class A, class B, class To>
bool told_quickly(const A& a, const B& b, const FeaturePair& f, To& to) {
  const bool turned = f.a == the_face;
  if (!turned && f.b != the_face)
    return quickly(line_at(a, f.a), line_at(b, f.b), {place_at(a, f.a), place_at(b, f.b)}, to);
  const OnLine from = turned ? on_line(b, f.b) : on_line(a, f.a);
  if (from.place == SpotOnLine::inside) return false;
  const Point3& v = from.line.at(from.place);
  if (!quickly(v, turned ? *triangle_of(a) : *triangle_of(b), to)) return false;
  name_vertex(v, to);
  if (turned) turn(to);
  return true;
}

template <class A, class B>
std::optional<double> distance_between(const A& a, const B& b, const FeaturePair& f) {
  if (f.a == the_face || f.b == the_face) {
    const OnLine from = f.b == the_face ? on_line(a, f.a) : on_line(b, f.b);
    if (from.place == SpotOnLine::inside) return 0.0;
    const Triangle3& face = f.b == the_face ? *triangle_of(b) : *triangle_of(a);
    return quick_distance(from.line.at(from.place), face);
  }
  const OnLine p = on_line(a, f.a), q = on_line(b, f.b);
  return quick_distance(p.line, q.line, {p.place, q.place});
}

/// The distance against a number, in doubles.
template <class A, class B>
std::optional<Sign> comparison_of(const A& a, const B& b, double than) {
  const auto f = certain_features(a, b);
  if (!f) return {};
  const auto square = [&]() -> ClosePair<Approximate, Point3> {
    if (f->a != the_face && f->b != the_face) {
      const OnLine p = on_line(a, f->a), q = on_line(b, f->b);
      return close_pair<Approximate>(linear<Approximate>(p.line), linear<Approximate>(q.line), {p.place, q.place});
    }
    const OnLine from = f->b == the_face ? on_line(a, f->a) : on_line(b, f->b);
    const Triangle3& face = f->b == the_face ? *triangle_of(b) : *triangle_of(a);
    return vertex_face_pair(from.line.at(from.place), face_of<Approximate>(face));
  };
  const bool cross =
      (f->a == the_face && f->b.kind == FeatureKind::edge) || (f->b == the_face && f->a.kind == FeatureKind::edge);
  if (cross || than < 0) return than < 0 ? Sign::positive : than > 0 ? Sign::negative : Sign::zero;
  CertainSigns ask;
  const auto pair = square();
  const Sign s = ask(pair.square - Approximate(than) * Approximate(than) * pair.square_whole);
  if (!ask.certain()) return {};
  return s;
}

/// All pairs of features, over pairs of doubles and over integers.
template <class A, class B>
[[gnu::noinline]] Closest closest_of_all(const A& a, const B& b) {
  const Shortlist list = shortlist(a, b);
  if (const auto quick = found_over<Ball>(a, b, list)) {
    const auto p = nearest_point(quick->pair.a), q = nearest_point(quick->pair.b);
    const auto d = nearest_distance(quick->pair);
    if (p && q && d) return {*p, *q, *d, quick->a, quick->b};
  }
  const Found<BigDyadic> f = *found_over<BigDyadic>(a, b, list);
  return {nearest_point(f.pair.a), nearest_point(f.pair.b), nearest_distance(f.pair), f.a, f.b};
}

template <class A, class B>
Closest closest_of(const A& a, const B& b) {
  const auto& p = in_one_form(a);
  const auto& q = in_one_form(b);
  if (const auto features = certain_features(p, q)) {
    Closest to;
    if (told_quickly(p, q, *features, to)) [[likely]] {
      to.feature_a = features->a, to.feature_b = features->b;
      return to;
    }
    if (const auto n = numbers_of(p, q, *features)) return {n->on_a, n->on_b, n->distance, features->a, features->b};
  }
  require_figures("closest_points", a, b);
  return closest_of_all(p, q);
}

template <class A, class B>
[[gnu::noinline]] double distance_of_all(const A& a, const B& b) {
  const Shortlist list = shortlist(a, b);
  if (const auto quick = found_over<Ball>(a, b, list)) {
    if (const auto d = nearest_distance(quick->pair)) return *d;
  }
  return nearest_distance(found_over<BigDyadic>(a, b, list)->pair);
}

template <class A, class B>
double distance_of(const A& a, const B& b, Question question) {
  const auto& p = in_one_form(a);
  const auto& q = in_one_form(b);
  if (const auto features = certain_features(p, q)) {
    double to;
    if (told_quickly(p, q, *features, to)) [[likely]]
      return to;
    if (const auto d = distance_between(p, q, *features)) return *d;
  }
  require_figures(question, a, b);
  return distance_of_all(p, q);
}

template <class A, class B>
Rational square_exactly(const A& a, const B& b, Question question) {
  require_figures(question, a, b);
  const auto& p = in_one_form(a);
  const auto& q = in_one_form(b);
  return square_of(found_over<BigDyadic>(p, q, shortlist(p, q))->pair);
}

}  // namespace

template <class A, class B>
requires StraightPair3<A, B> Closest closest_points(const A& a, const B& b) { return closest_of(a, b); }
template <class A, class B>
requires StraightPair2<A, B> Closest2 closest_points(const A& a, const B& b) {
  const Closest c = closest_of(in_space(a), in_space(b));
  return {{c.on_a.x, c.on_a.y}, {c.on_b.x, c.on_b.y}, c.distance, c.feature_a, c.feature_b};
}

template <class A, class B>
requires query::StraightPair<A, B>
double query::distance_as(Question question, const A& a, const B& b) {
  if constexpr (is_in_space<A>) {
    return distance_of(a, b, question);
  } else {
    return distance_of(in_space(a), in_space(b), question);
  }
}

template <class A, class B>
requires query::StraightPair<A, B> Rational query::squared_distance_as(Question question, const A& a, const B& b) {
  if constexpr (is_in_space<A>) {
    return square_exactly(a, b, question);
  } else {
    return square_exactly(in_space(a), in_space(b), question);
  }
}

namespace query {

template <class A, class B>
requires StraightPair<A, B> std::optional<Sign> quick_comparison(const A& a, const B& b, double than) {
  if constexpr (is_in_space<A>) {
    return comparison_of(in_one_form(a), in_one_form(b), than);
  } else {
    return quick_comparison(in_space(a), in_space(b), than);
  }
}

}  // namespace query

#define PLUMB_TRIANGLE_PAIR(Result, A, B)                                     \
  template Result closest_points(const A&, const B&);                         \
  template double query::distance_as(Question, const A&, const B&);           \
  template Rational query::squared_distance_as(Question, const A&, const B&); \
  template std::optional<Sign> query::quick_comparison(const A&, const B&, double);
PLUMB_TRIANGLE_PAIR(Closest2, Line2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Ray2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Segment2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest2, Triangle2, Triangle2)
PLUMB_TRIANGLE_PAIR(Closest, Line3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Ray3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Segment3, Triangle3)
PLUMB_TRIANGLE_PAIR(Closest, Triangle3, Triangle3)
#undef PLUMB_TRIANGLE_PAIR

}  // namespace plumb
