// The numbers of two lines, rays or segments whose features are known, to twice the digits of doubles.
//
// With w = b - a and e = w + t e2 - s e1 for lines through a along e1 and through b along e2 the products e.e1 and
// e.e2 are nothing; guesses of s and t leave g1 and g2, and a correction by the same two equations.
#include "query/closest/quick_pairs.hpp"

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/quick_pairs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/closest/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

HWY_INLINE Twofolds along(const LineAt& s) {
  if (s.to != nullptr) return Twofolds::difference(loaded(*s.to), loaded(*s.from));
  return Twofolds::exact(loaded(*s.direction));
}

HWY_INLINE bool put(const Three& a, const Three& b, double distance, Closest& to) {
  put(a, distance, to.on_a);
  return put(b, distance, to);
}
HWY_INLINE bool put(const Three&, const Three&, double distance, double& to) { return to = distance, true; }

/// Of two lines that are not nearly parallel: e1.e1, e1.e2 and e2.e2, w.e1 and w.e2.
template <class To>
HWY_INLINE bool between_lines(const Three& a, const Twofolds& e1, const Three& b, const Twofolds& e2, const Twofolds& w,
                              const Dots& gram, const Dots& c, To& to) {
  const Running a11 = gram.x.plain().running(), a12 = gram.y.plain().running(), a22 = gram.z.plain().running();
  const Running inverse = quotient(Running(1), a11 * a22 - a12 * a12);
  const double s = (c.x.high * a22.value - a12.value * c.y.high) * inverse.value,
               t = (a12.value * c.x.high - a11.value * c.y.high) * inverse.value;
  const Twofolds e = (w - e1 * lanes::of_all(s)) + e2 * lanes::of_all(t);
  const Dots left = apart(sums(e * e1, e * e2, e.squared()));
  const Running g1 = left.x.running(), g2 = left.y.running();
  const Running ds = (g1 * a22 - a12 * g2) * inverse, dt = (a12 * g1 - a11 * g2) * inverse;
  Three on_a = a, on_b = b;
  if constexpr (wants_point<To>) {
    const Twofolds on_e1 = scaled(e1, One::near(s, ds));
    const Twofolds on_e2 = scaled(e2, One::near(t, dt));
    if (!((a + on_e1).told(on_a) && (b + on_e2).told(on_b))) return false;
  }
  // (e + dt e2 - ds e1)^2, which is its product with e.
  double distance = 0;
  return root(left.z + One::near(0, dt * g2 - ds * g1)).told(distance) && put(on_a, on_b, distance, to);
}

/// The foot of a point on a line.
template <class To>
HWY_INLINE bool on_one_line(const Three& from, const Twofolds& d, const Three& point, bool swap, To& to) {
  const Twofolds w = Twofolds::difference(point, from);
  Three q = from;
  double distance = 0;
  if (!foot<To>(from, w, d, squares(w, d), q, distance, by_the_way)) return false;
  return swap ? put(q, point, distance, to) : put(point, q, distance, to);
}

template <class To>
HWY_INLINE bool numbers(const LineAt& p, const LineAt& q, SpotsOnLines places, To& to) {
  const bool inside_p = places.a == SpotOnLine::inside, inside_q = places.b == SpotOnLine::inside;
  const Three a = loaded(inside_p ? *p.from : p.at(places.a)), b = loaded(inside_q ? *q.from : q.at(places.b));
  if (inside_p && inside_q) {
    const Twofolds e1 = along(p), e2 = along(q), w = Twofolds::difference(b, a);
    const Dots gram = squares(e1, e2);
    return between_lines(a, e1, b, e2, w, gram, along(w, e1, e2, gram), to);
  }
  if (inside_p || inside_q) {
    const LineAt& line = inside_p ? p : q;
    return on_one_line(inside_p ? a : b, along(line), inside_p ? b : a, inside_p, to);
  }
  const Twofolds w = Twofolds::difference(b, a);
  double distance = 0;
  return root_of_squares(square(w)).told(distance) && put(a, b, distance, to);
}

HWY_INLINE void name_features(Closest& to, SpotsOnLines places) {
  const auto feature = [](SpotOnLine p) -> Feature {
    return {p == SpotOnLine::inside ? FeatureKind::edge : FeatureKind::vertex, p == SpotOnLine::end ? 1u : 0u};
  };
  to.feature_a = feature(places.a), to.feature_b = feature(places.b);
}
HWY_INLINE void name_features(double&, SpotsOnLines) {}

struct BothEnds {
  bool starts = true, ends = true;
};
/// As closest_places (linear_pair.hpp), by the products of e1, e2 and w.  Segments that may be parallel are never
/// certain.
HWY_INLINE SpotsOnLines places_by(const Dots& gram, const Dots& c, CertainSigns& ask) {
  const Approximate a11 = gram.x.plain(), a12 = gram.y.plain(), a22 = gram.z.plain(), c1 = c.x.plain(),
                    c2 = c.y.plain();
  const auto place = [&ask](const Approximate& part, const Approximate& of) {
    return place_on(BothEnds(), part, of, ask);
  };
  const auto on_p = [&](SpotOnLine q) { return place(q == SpotOnLine::end ? c1 + a12 : c1, a11); };
  const Approximate whole = a11 * a22 - a12 * a12;
  static_cast<void>(ask(whole));
  SpotsOnLines places{place(c1 * a22 - a12 * c2, whole), SpotOnLine::inside};
  if (places.a == SpotOnLine::inside) {
    places.b = place(a12 * c1 - a11 * c2, whole);
  } else {
    places.b = place(places.a == SpotOnLine::end ? a12 - c2 : Approximate(0) - c2, a22);
  }
  if (places.b != SpotOnLine::inside) places.a = on_p(places.b);
  return places;
}

template <class To>
HWY_INLINE bool numbers(const Segment3& p, const Segment3& q, To& to) {
  const Three a = loaded(p.a), b = loaded(q.a);
  const Twofolds e1 = Twofolds::difference(loaded(p.b), a), e2 = Twofolds::difference(loaded(q.b), b),
                 w = Twofolds::difference(b, a);
  const Dots gram = squares(e1, e2), c = along(w, e1, e2, gram);
  CertainSigns ask;
  const SpotsOnLines places = places_by(gram, c, ask);
  if (!ask.certain()) return false;
  name_features(to, places);
  if (places.a == SpotOnLine::inside && places.b == SpotOnLine::inside)
    return between_lines(a, e1, b, e2, w, gram, c, to);
  return numbers(LineAt(p), LineAt(q), places, to);
}

template <class To>
HWY_INLINE bool numbers(const Point3& v, const Triangle3& t, To& to) {
  const Three a = loaded(t.a), p = loaded(v);
  return on_face(p, Twofolds::difference(loaded(t.b), a), Twofolds::difference(loaded(t.c), a),
                 Twofolds::difference(p, a), to);
}

#endif

template <class... Arguments>
bool numbers_of(Arguments&... arguments) {
#if HWY_TARGET == HWY_AVX2
  return numbers(arguments...);
#else
  return (static_cast<void>(arguments), ...), false;
#endif
}

}  // namespace
}  // namespace plumb::query::quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query {

template <class To>
bool quickly(const LineAt& p, const LineAt& q, SpotsOnLines places, To& to) {
  return PLUMB_BY_LANES(quick, numbers_of(p, q, places, to));
}
template <class To>
bool quickly(const Point3& vertex, const Triangle3& face, To& to) {
  return PLUMB_BY_LANES(quick, numbers_of(vertex, face, to));
}
template <class To>
bool quickly(const Segment3& p, const Segment3& q, To& to) {
  return PLUMB_BY_LANES(quick, numbers_of(p, q, to));
}

template bool quickly(const LineAt&, const LineAt&, SpotsOnLines, Closest&);
template bool quickly(const LineAt&, const LineAt&, SpotsOnLines, double&);
template bool quickly(const Segment3&, const Segment3&, Closest&);
template bool quickly(const Segment3&, const Segment3&, double&);
template bool quickly(const Point3&, const Triangle3&, Closest&);
template bool quickly(const Point3&, const Triangle3&, double&);

}  // namespace plumb::query
#endif
