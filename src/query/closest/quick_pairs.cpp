// The numbers of two lines, rays or segments whose features are known, to twice the digits of doubles.
//
// With w = b - a and e = w + t e2 - s e1 for lines through a along e1 and through b along e2 the products e.e1 and
// e.e2 are nothing: s and t are quotients by e1.e1 e2.e2 - (e1.e2)^2 (Cramer's rule), and e.e is e.w.
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

// What is asked of segments as given, and of all others by where they lie.
HWY_INLINE const Point3& start_of(const Segment3& s) { return s.a; }
HWY_INLINE const Point3& start_of(const LineAt& s) { return *s.from; }
HWY_INLINE const Point3& at(const Segment3& s, SpotOnLine place) { return place == SpotOnLine::end ? s.b : s.a; }
HWY_INLINE const Point3& at(const LineAt& s, SpotOnLine place) { return s.at(place); }
HWY_INLINE Twofolds along(const Segment3& s) { return Twofolds::difference(loaded(s.b), loaded(s.a)); }
HWY_INLINE Twofolds along(const LineAt& s) {
  if (s.to != nullptr) return Twofolds::difference(loaded(*s.to), loaded(*s.from));
  Twofolds d = Twofolds::exact(loaded(*s.direction));
  d.width = 1;  // as of a difference: what follows is the same code, with constant bounds
  return d;
}

HWY_INLINE bool put(const Three& a, const Three& b, double distance, Closest& to) {
  put(a, distance, to.on_a);
  return put(b, distance, to);
}
HWY_INLINE bool put(const Three&, const Three&, double distance, double& to) { return to = distance, true; }

/// s and t over their common divisor.  The sizes of their terms are, by |u.v| <= |u||v|, no more than
/// 2 |w||e1| e2.e2 and 2 |w||e2| e1.e1, and its own 2 e1.e1 e2.e2.
template <class T>
struct Solution {
  T s, t, whole;

  HWY_INLINE Solution(const T& a11, const T& a12, const T& a22, const T& c1, const T& c2)
      : s((c1 * a22 - a12 * c2).below(most(c1, a22))),
        t((a12 * c1 - a11 * c2).below(most(c2, a11))),
        whole((a11 * a22 - a12 * a12).below(2 * most(a11, a22))) {}

 private:
  static HWY_INLINE double most(const T& a, const T& b) {
    return One::plus_product(2 * One::guard, a.magnitude, b.magnitude);
  }
};

// Two lines that are not nearly parallel.  Not inlined, lest what is found on the way to it be kept in memory.
/// w.n over |n|, for the normal n = e1 x e2 of both, in the order z x y.
template <class Line>
HWY_NOINLINE bool between_lines(const Line& p, const Line& q, double& distance) {
  const Twofolds n = crossed(along(p), along(q)), square = n * n;
  const Twofolds w = Twofolds::difference(loaded(start_of(q)), loaded(start_of(p)));
  const Dots s = apart(sums(square, n * w.turned_back(), square));
  if (!quotient(s.y, root(s.x)).told(distance)) return false;
  return distance = std::fabs(distance), true;
}
template <class Line>
HWY_NOINLINE bool between_lines(const Line& p, const Line& q, Closest& to) {
  const Three a = loaded(start_of(p)), b = loaded(start_of(q));
  const Twofolds e1 = along(p), e2 = along(q), w = Twofolds::difference(b, a);
  const Dots gram = squares(e1, e2), c = along(w, e1, e2, gram);
  const Solution<One> of(gram.x, gram.y, gram.z, c.x, c.y);
  const One s = quotient(of.s, of.whole), t = quotient(of.t, of.whole);
  Three on_a = a, on_b = b;
  if (!((a + scaled(e1, s)).told(on_a) && (b + scaled(e2, t)).told(on_b))) return false;
  double distance = 0;
  // Where they nearly meet fewer digits are lost by the normal.
  if (!root_at_once((c.z + t * c.y) - s * c.x).told(distance) && !between_lines(p, q, distance)) return false;
  return put(on_a, on_b, distance, to);
}

/// The distance of a point near to a line, by what is given, as that of lanes.hpp.
template <class Line>
[[gnu::cold]] HWY_NOINLINE bool length_to(const Line& line, const Point3& p, double& distance) {
  return length_to(Twofolds::difference(loaded(p), loaded(start_of(line))), along(line), distance);
}

/// The foot of a point on a line.
template <class Line, class To>
HWY_INLINE bool on_one_line(const Line& line, const Point3& p, bool swap, To& to) {
  const auto closer = [&](const Twofolds&, const Twofolds&, double& distance) { return length_to(line, p, distance); };
  const Three from = loaded(start_of(line)), point = loaded(p);
  const Twofolds w = Twofolds::difference(point, from), d = along(line);
  Three q = from;
  double distance = 0;
  if (!foot<To>(from, w, d, squares(w, d), q, distance, closer)) return false;
  return swap ? put(q, point, distance, to) : put(point, q, distance, to);
}

template <class Line, class To>
HWY_INLINE bool numbers(const Line& p, const Line& q, SpotsOnLines places, To& to) {
  const bool inside_p = places.a == SpotOnLine::inside, inside_q = places.b == SpotOnLine::inside;
  if (inside_p && inside_q) return between_lines(p, q, to);
  if (inside_p || inside_q)
    return on_one_line(inside_p ? p : q, inside_p ? at(q, places.b) : at(p, places.a), inside_p, to);
  const Three a = loaded(at(p, places.a)), b = loaded(at(q, places.b));
  double distance = 0;
  return root_of_squares(square(Twofolds::difference(b, a))).told(distance) && put(a, b, distance, to);
}

HWY_INLINE void name_features(Closest& to, SpotsOnLines places) {
  const auto feature = [](SpotOnLine p) -> Feature {
    return {p == SpotOnLine::inside ? FeatureKind::edge : FeatureKind::vertex, p == SpotOnLine::end ? 1u : 0u};
  };
  to.feature_a = feature(places.a), to.feature_b = feature(places.b);
}
HWY_INLINE void name_features(double&, SpotsOnLines) {}

/// Where part / whole lies on a segment; `given` where doubles leave a doubt.
HWY_INLINE SpotOnLine place_of(const Approximate& part, const Approximate& whole) {
  const Approximate rest = whole - part;
  if (part.certainly_negative()) return SpotOnLine::start;
  if (rest.certainly_negative()) return SpotOnLine::end;
  return part.certainly_positive() && rest.certainly_positive() ? SpotOnLine::inside : SpotOnLine::given;
}
HWY_INLINE bool is_end(SpotOnLine place) { return place == SpotOnLine::start || place == SpotOnLine::end; }

/// As closest_places (linear_pair.hpp), by the products of e1, e2 and w.  Segments that may be parallel are never
/// certain.
HWY_INLINE SpotsOnLines places_by(const Dots& gram, const Dots& c) {
  const Approximate a11 = gram.x.plain(), a12 = gram.y.plain(), a22 = gram.z.plain(), c1 = c.x.plain(),
                    c2 = c.y.plain();
  const Solution<Approximate> of(a11, a12, a22, c1, c2);
  if (!of.whole.certainly_positive()) return {SpotOnLine::given, SpotOnLine::given};
  SpotsOnLines places{place_of(of.s, of.whole), SpotOnLine::given};
  if (places.a == SpotOnLine::inside) {
    places.b = place_of(of.t, of.whole);
  } else if (places.a != SpotOnLine::given) {
    places.b = place_of(places.a == SpotOnLine::end ? a12 - c2 : -c2, a22);
  }
  if (is_end(places.b)) places.a = place_of(places.b == SpotOnLine::end ? c1 + a12 : c1, a11);
  return places;
}

template <class To>
HWY_INLINE bool numbers(const Segment3& p, const Segment3& q, To& to) {
  const Three a = loaded(p.a), b = loaded(q.a);
  const Twofolds e1 = Twofolds::difference(loaded(p.b), a), e2 = Twofolds::difference(loaded(q.b), b);
  const Dots gram = squares(e1, e2);
  const SpotsOnLines places = places_by(gram, along(Twofolds::difference(b, a), e1, e2, gram));
  if (places.a == SpotOnLine::given || places.b == SpotOnLine::given) return false;
  name_features(to, places);
  return numbers(p, q, places, to);
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
