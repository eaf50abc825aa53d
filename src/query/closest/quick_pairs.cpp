// The numbers of two lines, rays or segments whose features are known, in pairs of doubles.
//
// u is 2^-53.  With w = b - a and e = w + t e2 - s e1 for lines through a along e1 and through b along e2 the products
// e.e1 and e.e2 are nothing; doubles s and t near to that leave g1 and g2, found to 120 u^2 of the magnitudes of the
// terms, and a correction by the same two equations.  Of it the determinant is off by 25 u of e1.e1 e2.e2 at most.
#include "query/closest/quick_pairs.hpp"

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/quick_pairs.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>

#include "query/closest/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

HWY_INLINE Pair along(const LineAt& s) {
  if (s.to != nullptr) return difference(load(*s.to), load(*s.from));
  return {load(*s.direction), hn::Zero(D())};
}

HWY_INLINE bool put(V a, V b, double distance, Closest& to) {
  const V q = Add(a, hn::Zero(D()));
  hn::StoreU(hn::LowerHalf(q), Two(), &to.on_a.x);
  to.on_a.z = first(upper(q));
  return put(b, distance, to);
}
HWY_INLINE bool put(V, V, double distance, double& to) { return to = distance, true; }

constexpr double least_square = 0x1p-100, largest_square = 0x1p150;
HWY_INLINE bool fair_square(double x) { return x >= least_square && x <= largest_square; }

/// Of two lines that are not nearly parallel.
template <class To>
HWY_INLINE bool between_lines(V a, Pair e1, V b, Pair e2, To& to) {
  const Pair w = difference(b, a);
  const V both = Mul(e1.h, e2.h);
  const auto [a11, a22, a12, c1] = totals(Mul(e1.h, e1.h), Mul(e2.h, e2.h), both, Mul(e1.h, w.h));
  const auto [c2, size12, none, nothing] = totals(Mul(e2.h, w.h), Abs(both), hn::Zero(D()), hn::Zero(D()));
  const double inverse = 1 / (a11 * a22 - a12 * a12), condition = a11 * a22 * inverse;
  if (!(fair_square(a11) && fair_square(a22) && condition > 0 && condition < 0x1p40)) return false;
  const double s = (c1 * a22 - a12 * c2) * inverse, t = (a12 * c1 - a11 * c2) * inverse;
  const Pair p = product(set(s), e1.h), q = product(set(t), e2.h);
  const V p_low = MulAdd(set(s), e1.l, p.l), q_low = MulAdd(set(t), e2.l, q.l);
  const Pair less = difference(w.h, p.h), e = sum(less.h, q.h);
  const V x = Add(Add(less.l, e.l), Add(w.l, Sub(q_low, p_low)));
  const Pair d1 = product(e.h, e1.h), d2 = product(e.h, e2.h), square = product(e.h, e.h);
  const Sums3 sum = sums(d1.h, d2.h, square.h, MulAdd(x, e1.h, MulAdd(e.h, e1.l, d1.l)),
                         MulAdd(x, e2.h, MulAdd(e.h, e2.l, d2.l)), MulAdd(MulAdd(set(2), e.h, x), x, square.l));
  const auto [g1, g2, none_left] = lanes(Add(sum.value, sum.rest));
  const double f = lanes(sum.value).z, f_rest = lanes(sum.rest).z;
  const double size = total(Add(Abs(w.h), Add(Abs(p.h), Abs(q.h))));
  if (!(size <= 0x1p100)) return false;
  const double off1 = 0x1p-98 * (size * size + a11), off2 = 0x1p-98 * (size * size + a22);
  const double ds = (g1 * a22 - a12 * g2) * inverse, dt = (a12 * g1 - a11 * g2) * inverse;
  const double share = 0x1p-44 * condition, m1 = off1 + share * std::fabs(g1), m2 = off2 + share * std::fabs(g2);
  const double doubt_s = (m1 * a22 + size12 * m2) * inverse, doubt_t = (size12 * m1 + a11 * m2) * inverse;
  V on_a = a, on_b = b;
  double distance = 0;
  if constexpr (wants_point<To>) {
    const double all_s = doubt_s + (0x1p-97 * std::fabs(s) + 0x1p-47 * std::fabs(ds));
    const double all_t = doubt_t + (0x1p-97 * std::fabs(t) + 0x1p-47 * std::fabs(dt));
    if (!(point_on(a, e1, s, ds, all_s, on_a) && point_on(b, e2, t, dt, all_t, on_b))) return false;
  }
  // The correction shortens the square by no more than it and the products together.
  const double shorter =
      (std::fabs(ds) + doubt_s) * (std::fabs(g1) + off1) + (std::fabs(dt) + doubt_t) * (std::fabs(g2) + off2);
  const Parts r = root(f, f_rest, 2 * shorter);
  if (!(fair(f) && round(r.value, r.rest, r.bound + 0x1p-98 * size, distance))) return false;
  return put(on_a, on_b, distance, to);
}

/// The foot of a point on a line.
template <class To>
HWY_INLINE bool on_one_line(V from, Pair d, V point, bool swap, To& to) {
  const Pair w = difference(point, from);
  const Dots s = dots<Closest>(w, d);
  if (!(s.dd >= 0x1p-200 && s.dd <= 0x1p300 && s.ww <= 0x1p200)) return false;
  const Parameter at = parameter(s);
  const Square square = square_from_line(s, at);
  double distance = 0;
  V q = from;
  const Parts r = root(square.value, square.rest, 0x1p-96 * square.size);
  if (square.is_lost() || !(fair(square.value) && round(r.value, r.rest, r.bound, distance))) return false;
  if constexpr (wants_point<To>) {
    const double doubt =
        __builtin_fma(__builtin_fma(s.ww, at.inverse, 2 + std::fabs(at.t)), 0x1p-96, 0x1p-48 * std::fabs(at.change));
    if (!point_on(from, d, at.t, at.change, doubt, q)) return false;
  }
  return swap ? put(q, point, distance, to) : put(point, q, distance, to);
}

template <class To>
HWY_INLINE bool numbers(const LineAt& p, const LineAt& q, SpotsOnLines places, To& to) {
  const bool inside_p = places.a == SpotOnLine::inside, inside_q = places.b == SpotOnLine::inside;
  const V a = load(inside_p ? *p.from : p.at(places.a)), b = load(inside_q ? *q.from : q.at(places.b));
  if (inside_p && inside_q) return between_lines(a, along(p), b, along(q), to);
  if (inside_p || inside_q) {
    const LineAt& line = inside_p ? p : q;
    return on_one_line(inside_p ? a : b, along(line), inside_p ? b : a, inside_p, to);
  }
  const Pair w = difference(b, a);
  double distance = 0;
  return length(w.h, w.l, distance) && put(a, b, distance, to);
}

constexpr double guard = 0x1p-800;

/// Of x / whole, both off by their bounds; `given` where that is not certain.
HWY_INLINE SpotOnLine place_of(double x, double bound, double whole, double whole_bound) {
  const double less = whole - x, either = bound + whole_bound;
  if (x < -bound) return SpotOnLine::start;
  if (less < -either) return SpotOnLine::end;
  return x > bound && less > either ? SpotOnLine::inside : SpotOnLine::given;
}

HWY_INLINE void name_features(Closest& to, SpotsOnLines places) {
  const auto feature = [](SpotOnLine p) -> Feature {
    return {p == SpotOnLine::inside ? FeatureKind::edge : FeatureKind::vertex, p == SpotOnLine::end ? 1u : 0u};
  };
  to.feature_a = feature(places.a), to.feature_b = feature(places.b);
}
HWY_INLINE void name_features(double&, SpotsOnLines) {}

/// The signs of closest_places (linear_pair.hpp) by six products; their errors are some 12 u of the bounds' terms.
template <class To>
HWY_INLINE bool numbers(const Segment3& p, const Segment3& q, To& to) {
  const V a = load(p.a), b = load(q.a), e1 = Sub(load(p.b), a), e2 = Sub(load(q.b), b), w = Sub(b, a);
  const Four first_four = totals(Mul(e1, e1), Mul(e2, e2), Mul(e1, e2), Mul(e1, w));
  const double a11 = first_four.x, a22 = first_four.y, a12 = first_four.z, c1 = first_four.w;
  const double c2 = total(Mul(e2, w)), ww = total(Mul(w, w));
  if (!(fair_square(a11) && fair_square(a22) && ww <= largest_square)) return false;
  const double unsure = __builtin_fma(0x1p-47, a11 + a22 + ww, guard);
  const double unsure_whole = 0x1p-47 * a11 * a22, whole = a11 * a22 - a12 * a12;
  const auto on_p = [&](SpotOnLine end_of_q) {
    return place_of(end_of_q == SpotOnLine::end ? c1 + a12 : c1, unsure, a11, unsure);
  };
  const auto on_q = [&](SpotOnLine end_of_p) {
    return place_of(end_of_p == SpotOnLine::end ? a12 - c2 : -c2, unsure, a22, unsure);
  };
  if (!(whole > unsure_whole)) return false;
  SpotsOnLines places{place_of(c1 * a22 - a12 * c2, 0x1p-47 * a22 * (a11 + ww), whole, unsure_whole),
                      SpotOnLine::given};
  if (places.a == SpotOnLine::inside) {
    places.b = place_of(a12 * c1 - a11 * c2, 0x1p-47 * a11 * (a22 + ww), whole, unsure_whole);
    if (places.b != SpotOnLine::inside && places.b != SpotOnLine::given) places.a = on_p(places.b);
  } else if (places.a != SpotOnLine::given) {
    places.b = on_q(places.a);
    if (places.b != SpotOnLine::inside && places.b != SpotOnLine::given) places.a = on_p(places.b);
  }
  if (places.a == SpotOnLine::given || places.b == SpotOnLine::given) return false;
  name_features(to, places);
  return numbers(LineAt(p), LineAt(q), places, to);
}

template <class To>
HWY_INLINE bool numbers(const Point3& v, const Triangle3& t, To& to) {
  const V a = load(t.a), p = load(v);
  const Pair ab = difference(load(t.b), a), ac = difference(load(t.c), a), ap = difference(p, a);
  return moderate(ab.h) && moderate(ac.h) && moderate(ap.h) && on_face(p, ab, ac, ap, hn::Zero(D()), to);
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
