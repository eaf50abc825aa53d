// The foot of a perpendicular in pairs of doubles, x, y and z in three lanes, with bounds of the errors beside it.
//
// Included once for each target, by the files that Highway compiles for several (query/closest/quick.cpp); there are lanes of
// pairs for AVX2 alone.  u is 2^-53; the names and the bounds are those of docs/closest.md: a line through o along d,
// w = p - o, t = w.d / d.d.  What `To` is says what is wanted: a Point3, a double for the distance, a Closest for both.
#if defined(PLUMB_CLOSEST_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_CLOSEST_LANES
#undef PLUMB_CLOSEST_LANES
#else
#define PLUMB_CLOSEST_LANES
#endif

#include <hwy/highway.h>

#include <cmath>
#include <concepts>
#include <cstddef>

#include "plumb/arith/point.hpp"
#include "plumb/query/closest/result.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::FixedTag<double, 4>;
using V = hn::Vec<D>;
using Two = hn::FixedTag<double, 2>;
using V2 = hn::Vec<Two>;
using hn::Abs, hn::Add, hn::Mul, hn::MulAdd, hn::MulSub, hn::NegMulAdd, hn::Sub;

HWY_INLINE V set(double x) { return hn::Set(D(), x); }
HWY_INLINE V load(const double* three) { return hn::MaskedLoad(hn::FirstN(D(), 3), D(), three); }
HWY_INLINE V load(const Point3& p) { return load(&p.x); }
HWY_INLINE V load(const Vector3& v) { return load(&v.x); }

/// h + l, exactly.
template <class Lanes>
struct PairOf {
  Lanes h, l;
};
using Pair = PairOf<V>;
/// a + b and a - b where numbers are multiplied and added at once: half of these operations wait there for less.
template <class Lanes>
HWY_INLINE Lanes plus(Lanes a, Lanes b) {
  return MulAdd(a, hn::Set(hn::DFromV<Lanes>(), 1.0), b);
}
template <class Lanes>
HWY_INLINE Lanes minus(Lanes a, Lanes b) {
  return MulSub(a, hn::Set(hn::DFromV<Lanes>(), 1.0), b);
}
template <class Lanes>
HWY_INLINE PairOf<Lanes> sum(Lanes a, Lanes b) {
  const Lanes s = Add(a, b), part = Sub(s, a);
  return {s, Add(minus(a, minus(s, part)), minus(b, part))};
}
HWY_INLINE Pair difference(V a, V b) {
  const V s = Sub(a, b), part = Sub(s, a);
  return {s, Sub(minus(a, minus(s, part)), plus(b, part))};
}
HWY_INLINE Pair product(V a, V b) {
  const V p = Mul(a, b);
  return {p, MulSub(a, b, p)};
}

struct Three {
  double x, y, z;
};
struct Four {
  double x, y, z, w;
};
HWY_INLINE double first(V2 v) { return hn::GetLane(v); }
HWY_INLINE double second(V2 v) { return hn::GetLane(hn::Shuffle01(v)); }
HWY_INLINE V2 upper(V v) { return hn::UpperHalf(Two(), v); }
HWY_INLINE Three lanes(V v) { return {first(hn::LowerHalf(v)), second(hn::LowerHalf(v)), first(upper(v))}; }
/// x + y + z; the last lane is zero throughout.
HWY_INLINE double total(V v) {
  const V2 low = hn::LowerHalf(v);
  return hn::GetLane(Add(Add(low, hn::Shuffle01(low)), upper(v)));
}
HWY_INLINE Four totals(V a, V b, V c, V d) {
  const V ab = Add(hn::InterleaveLower(D(), a, b), hn::InterleaveUpper(D(), a, b));
  const V cd = Add(hn::InterleaveLower(D(), c, d), hn::InterleaveUpper(D(), c, d));
  const V2 low = Add(hn::LowerHalf(ab), upper(ab)), high = Add(hn::LowerHalf(cd), upper(cd));
  return {first(low), second(low), first(high), second(high)};
}

/// Two sums of three lanes and what they lack of the exact ones: of the lanes `a` and `b`, and of small ones beside
/// them.  Off by 40 u^2 of the magnitudes of `a` and `b`.
struct Sums {
  V2 value, rest;
};
HWY_INLINE Sums sums(V a, V b, V small_a, V small_b) {
  const V even = hn::InterleaveLower(D(), a, b), odd = hn::InterleaveUpper(D(), a, b);
  const PairOf<V2> xy = sum(hn::LowerHalf(even), hn::LowerHalf(odd)), all = sum(xy.h, upper(even));
  const V less = hn::InterleaveLower(D(), small_a, small_b), more = hn::InterleaveUpper(D(), small_a, small_b);
  const V2 small = Add(Add(hn::LowerHalf(less), hn::LowerHalf(more)), upper(less));
  return {all.h, Add(Add(xy.l, all.l), small)};
}

/// Zero, or so far from under- and overflow that no product of four of them comes near.
HWY_INLINE bool moderate(V v) {
  const V a = Abs(v);
  return hn::AllTrue(D(), hn::Or(hn::Eq(a, hn::Zero(D())), hn::And(hn::Ge(a, set(0x1p-60)), hn::Le(a, set(0x1p60)))));
}

template <class To>
inline constexpr bool wants_point = !std::same_as<To, double>;
template <class To>
inline constexpr bool wants_distance = !std::same_as<To, Point3>;

HWY_INLINE void name_feature(Closest& to, Feature f) { to.feature_b = f; }
HWY_INLINE void name_feature(Point3&, Feature) {}
HWY_INLINE void name_feature(double&, Feature) {}

/// Never -0.  In one piece, from which whoever reads numbers in pairs need not wait for several.
HWY_INLINE bool put(V point, double distance, Closest& to) {
  static_assert(offsetof(Closest, distance) == offsetof(Closest, on_b) + 3 * sizeof(double));
  const V q = Add(point, hn::Zero(D()));
  const V2 last = hn::InterleaveLower(Two(), upper(q), hn::Set(Two(), distance));
  auto* const at = reinterpret_cast<double*>(reinterpret_cast<char*>(&to) + offsetof(Closest, on_b));
  hn::StoreU(hn::Combine(D(), last, hn::LowerHalf(q)), D(), at);
  return true;
}
HWY_INLINE bool put(V point, double, Point3& to) {
  const V q = Add(point, hn::Zero(D()));
  hn::StoreU(hn::LowerHalf(q), Two(), &to.x);
  to.z = first(upper(q));
  return true;
}
HWY_INLINE bool put(V, double distance, double& to) { return to = distance, true; }

/// Where each has one nearest double.
HWY_INLINE bool round(V h, V rest, V bound, V& to) {
  const V until = Add(h, Add(rest, bound));
  to = Add(h, Sub(rest, bound));
  return hn::AllTrue(D(), hn::Eq(to, until));
}
HWY_INLINE bool round(double h, double rest, double bound, double& to) {
  const double until = h + (rest + bound);
  to = h + (rest - bound);
  return to == until;
}

/// The root of square + rest, of which the rest is a small part: its double, what it lacks, and how much it may lack
/// besides, where they are off by `bound`.
struct Parts {
  double value, rest, bound;
};
HWY_INLINE Parts root(double square, double rest, double bound) {
  const double r = hn::GetLane(hn::Sqrt(hn::Set(hn::FixedTag<double, 1>(), square))), half = 0.5 / r;
  const double lacks = (__builtin_fma(-r, r, square) + rest) * half;
  return {r, lacks, __builtin_fma(__builtin_fma(lacks, lacks, bound), half, r * 0x1p-98)};
}
/// Is it far from under- and overflow?
HWY_INLINE bool fair(double square) { return square >= 0x1p-400 && square <= 0x1p400; }

/// |h + l|, where the lanes are off by `slack` at most.
HWY_INLINE bool length(V h, V l, V slack, double& to) {
  const Pair p = product(h, h);
  const V off = Mul(slack, MulAdd(set(4), Abs(h), slack));
  const Sums s = sums(p.h, hn::Zero(D()), MulAdd(MulAdd(set(2), h, l), l, p.l), hn::Zero(D()));
  const double square = first(s.value);
  const Parts r = root(square, first(s.rest), total(off));
  return fair(square) && round(r.value, r.rest, r.bound, to);
}
/// Likewise, of what is exact.
HWY_INLINE bool length(V h, V l, double& to) {
  const Pair p = product(h, h);
  const auto [x, y, z] = lanes(p.h);
  const double xy = x + y, part = xy - x, all = xy + z, last = all - xy;
  const double lost = ((x - (xy - part)) + (y - part)) + ((xy - (all - last)) + (z - last));
  const Parts r = root(all, lost + total(MulAdd(Add(h, h), l, p.l)), 0);
  return fair(all) && round(r.value, r.rest, r.bound, to);
}

/// At a point as given.
template <class To>
HWY_INLINE bool at_point(V q, Pair w, To& to) {
  double d = 0;
  if constexpr (wants_distance<To>) {
    if (!length(w.h, w.l, d)) return false;
  }
  return put(q, d, to);
}

/// A line: where it starts, and how much its lanes may be off.  Its direction is exact where the start is not.
struct Exactly {
  V at;
  static constexpr bool exact = true;
};
struct Nearly {
  V at, rest, slack;
  static constexpr bool exact = false;
};

/// Strictly between the ends of a line, 0 < t < 1 where it is exact: `along` and `whole` are w.d and d.d, `size` at
/// least a half of the sum of the magnitudes of |w| |d| and |t d| |d|.
template <class Start, class To>
HWY_INLINE bool on_line(Start o, Pair w, Pair d, double along, double whole, double size, To& to) {
  const double inverse = 1 / whole, t = along * inverse;
  const V way = set(t);
  const Pair p = product(way, d.h);
  const V k = Start::exact ? MulAdd(way, d.l, p.l) : p.l;
  const Pair e = difference(w.h, p.h);
  const V x = Add(e.l, Sub(w.l, k));
  const Pair a = product(e.h, d.h), square = product(e.h, e.h);
  const V small = MulAdd(x, d.h, Start::exact ? MulAdd(e.h, d.l, a.l) : a.l);
  const Sums s = sums(a.h, square.h, small, MulAdd(MulAdd(set(2), e.h, x), x, square.l));
  const double r = first(s.value) + first(s.rest), change = r * inverse;
  V reach = Abs(p.h);
  if constexpr (!Start::exact) {
    reach = MulAdd(o.slack, set(0x1p100), reach);
    size += total(Mul(Mul(o.slack, set(0x1p100)), Abs(d.h)));
  }
  const double doubt = __builtin_fma(size, 0x1p-96, 0x1p-900) * inverse + 0x1p-48 * std::fabs(change);
  bool certain = whole >= 0x1p-200 && whole <= 0x1p210;
  V q = hn::Zero(D());
  double length = 0;
  if constexpr (wants_point<To>) {
    const Pair h = sum(o.at, p.h);
    V rest = Add(h.l, k);
    if constexpr (!Start::exact) rest = Add(rest, o.rest);
    rest = MulAdd(set(change), d.h, rest);
    // What is nothing is so exactly; else underflow has to be paid for.
    const V guard = hn::IfThenZeroElse(hn::Eq(hn::Or(o.at, d.h), hn::Zero(D())), set(0x1p-800));
    const V off = MulAdd(set(doubt), Abs(d.h), guard);
    certain &= round(h.h, rest, MulAdd(set(0x1p-100), Add(Abs(o.at), reach), off), q);
  }
  if constexpr (wants_distance<To>) {
    // Less the part that is along d.
    const double f = second(s.value), rest = second(s.rest) - r * change;
    const Parts root_of = root(f, rest, 4 * std::fabs(r) * doubt);
    const double bound = root_of.bound + 0x1p-99 * total(Add(Abs(w.h), reach));
    certain &= fair(f) && round(root_of.value, root_of.rest, bound, length);
  }
  return certain && put(q, length, to);
}

/// Likewise three sums, in the lanes 0 to 2.
struct Sums3 {
  V value, rest;
};
HWY_INLINE Sums3 sums(V a, V b, V c, V small_a, V small_b, V small_c) {
  const V even = hn::InterleaveLower(D(), a, b), odd = hn::InterleaveUpper(D(), a, b);
  const V even_c = hn::DupEven(c), odd_c = hn::DupOdd(c);
  const Pair xy = sum(hn::ConcatLowerLower(D(), even_c, even), hn::ConcatLowerLower(D(), odd_c, odd));
  const Pair all = sum(xy.h, hn::ConcatUpperUpper(D(), even_c, even));
  const V less = Add(hn::InterleaveLower(D(), small_a, small_b), hn::InterleaveUpper(D(), small_a, small_b));
  const V more = Add(hn::DupEven(small_c), hn::DupOdd(small_c));
  const V small = Add(hn::ConcatLowerLower(D(), more, less), hn::ConcatUpperUpper(D(), more, less));
  return {all.h, Add(Add(xy.l, all.l), small)};
}

/// The products w.w, w.d and d.d and what they lack, off by 2^-100 of w.w + d.d at most; of w.w the first alone where
/// no distance is wanted.
struct Dots {
  double ww, wd, dd, ww_rest, wd_rest, dd_rest;
};
template <class To>
HWY_INLINE Dots dots(Pair w, Pair d) {
  const Pair ww = product(w.h, w.h), wd = product(w.h, d.h), dd = product(d.h, d.h);
  const V small_wd = MulAdd(w.h, d.l, MulAdd(w.l, d.h, wd.l)), small_dd = MulAdd(Add(d.h, d.h), d.l, dd.l);
  if constexpr (wants_distance<To>) {
    const Sums3 s = sums(ww.h, wd.h, dd.h, MulAdd(Add(w.h, w.h), w.l, ww.l), small_wd, small_dd);
    const Three value = lanes(s.value), rest = lanes(s.rest);
    return {value.x, value.y, value.z, rest.x, rest.y, rest.z};
  } else {
    const Sums s = sums(wd.h, dd.h, small_wd, small_dd);
    return {total(ww.h), first(s.value), second(s.value), 0, first(s.rest), second(s.rest)};
  }
}

/// The square of a distance and what it lacks, found to 2^-96 of `size`.
struct Square {
  double value, rest, size;
  /// Of so few digits that another way has to find it.
  [[nodiscard]] bool is_lost() const { return !(value > 0x1p-24 * size); }
};
HWY_INLINE Square square_from_start(const Dots& s) { return {s.ww, s.ww_rest, s.ww}; }
/// |w - d|^2.
HWY_INLINE Square square_from_end(const Dots& s) {
  const double size = s.ww + s.dd, part = size - s.ww, value = size - 2 * s.wd;
  const double lost = ((s.ww - (size - part)) + (s.dd - part)) + ((size - value) - 2 * s.wd);
  return {value, lost + ((s.ww_rest + s.dd_rest) - 2 * s.wd_rest), size};
}

/// The quotient of w.d and d.d, and what it lacks.
struct Parameter {
  double inverse, t, change;
};
HWY_INLINE Parameter parameter(const Dots& s) {
  const double inverse = 1 / s.dd, t = s.wd * inverse;
  const double left = __builtin_fma(-t, s.dd, s.wd) + __builtin_fma(-t, s.dd_rest, s.wd_rest);
  return {inverse, t, left * inverse};
}
/// |w - t d|^2 = w.w - t w.d.
HWY_INLINE Square square_from_line(const Dots& s, const Parameter& at) {
  const double off = at.t * s.wd, error = __builtin_fma(at.t, s.wd, -off), value = s.ww - off;
  const double rest = __builtin_fma(-at.t, s.wd_rest, s.ww_rest) - __builtin_fma(at.change, s.wd, error);
  return {value, ((s.ww - value) - off) + rest, s.ww};
}
/// o + (t + change) d, where the parameter is off by `doubt`, which is no less than 2^-98 |t| and 2^-48 |change|.
HWY_INLINE bool point_on(V o, Pair d, double t, double change, double doubt, V& to) {
  HWY_ALIGN static constexpr double guard[4] = {0x1p-800, 0x1p-800, 0x1p-800, 0};
  const V way = set(t), underflow = hn::Load(D(), guard);
  const Pair p = product(way, d.h), h = sum(o, p.h);
  const V rest = MulAdd(set(change), d.h, Add(h.l, MulAdd(way, d.l, p.l)));
  const V bound = MulAdd(set(doubt), Abs(d.h), MulAdd(set(0x1p-99), Abs(h.h), underflow));
  if (round(h.h, rest, bound, to)) [[likely]]
    return true;
  // What is nothing is so exactly; for the rest underflow had to be paid for.
  return round(h.h, rest, hn::IfThenZeroElse(hn::Eq(hn::Or(o, d.h), hn::Zero(D())), bound), to);
}
HWY_INLINE bool foot(V o, Pair d, const Dots& s, const Parameter& at, V& to) {
  const double doubt = __builtin_fma(__builtin_fma(s.ww, at.inverse, 2), 0x1p-97, 0x1p-48 * std::fabs(at.change));
  return point_on(o, d, at.t, at.change, doubt, to);
}

/// A point, and the distance by its square.
template <class To>
HWY_INLINE bool conclude(V q, const Square& s, To& to) {
  double length = 0;
  if constexpr (wants_distance<To>) {
    const Parts r = root(s.value, s.rest, 0x1p-96 * s.size);
    if (!(fair(s.value) && round(r.value, r.rest, r.bound, length))) return false;
  }
  return put(q, length, to);
}

/// Strictly between the ends of ab, by the way to the line: where little of the square is left.
template <class To>
HWY_NOINLINE bool near_line(const Point3& a, const Point3& b, const Point3& p, To& to) {
  const V from = load(a), q = load(p);
  const Pair d = difference(load(b), from), w = difference(q, from);
  const Dots s = dots<To>(w, d);
  return on_line(Exactly{from}, w, d, s.wd, s.dd, s.ww + s.dd, to);
}

/// Strictly between the ends of ab, of which w and d are the ways from a to p and b.
template <class To>
HWY_INLINE bool between_ends(const Point3& a, const Point3& b, const Point3& p, V from, Pair d, const Dots& s, To& to) {
  const Parameter at = parameter(s);
  Square square{};
  if constexpr (wants_distance<To>) {
    square = square_from_line(s, at);
    if (square.is_lost()) [[unlikely]]
      return near_line(a, b, p, to);
  }
  V q = from;
  if (!(s.dd >= 0x1p-200 && s.ww <= 0x1p200) || (wants_point<To> && !foot(from, d, s, at, q))) return false;
  return conclude(q, square, to);
}

/// A corner as given, at the end of a way of which little is left.
template <class To>
HWY_NOINLINE bool near_corner(const Point3& corner, const Point3& p, To& to) {
  const V at = load(corner);
  return at_point(at, difference(load(p), at), to);
}

/// y z x of x y z.
HWY_INLINE V turned(V v) {
  HWY_ALIGN static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(D(), order));
}
HWY_INLINE V back(V v) {
  HWY_ALIGN static constexpr std::int64_t order[4] = {2, 0, 1, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(D(), order));
}

/// Above a plane: p less t n, for the normal n = ab x ac and t = n.ap / n.n, where ap is off by `slack` at most.
template <class To>
HWY_INLINE bool on_face(V p, Pair ab, Pair ac, Pair ap, V slack, To& to) {
  // The lanes of n are in the order z x y, and so are those of the point.
  const V other = turned(ac.h), own = turned(ab.h);
  const Pair left = product(ab.h, other), right = product(own, ac.h), m = difference(left.h, right.h);
  const V cross = MulAdd(ab.h, turned(ac.l), Mul(ab.l, other)), back_cross = MulAdd(own, ac.l, Mul(turned(ab.l), ac.h));
  const V low = Add(Add(m.l, Sub(left.l, right.l)), Sub(cross, back_cross));
  const V high = Add(m.h, low);
  const Pair n{high, Add(Sub(m.h, high), low)};
  const V size = Add(Abs(left.h), Abs(right.h));  // n is off by 32 u^2 of it
  const Pair w{back(ap.h), back(ap.l)};
  const Pair up = product(n.h, w.h), square = product(n.h, n.h);
  const Sums s = sums(up.h, square.h, Add(up.l, MulAdd(n.h, w.l, Mul(n.l, w.h))), MulAdd(Add(n.h, n.h), n.l, square.l));
  const double g = first(s.value), whole = second(s.value), g_rest = first(s.rest), whole_rest = second(s.rest);
  const double inverse = 1 / whole, t = g * inverse, away = std::fabs(t);
  if (!(away >= 0x1p-300)) return false;
  const double change = (__builtin_fma(-t, whole, g) + (g_rest - t * whole_rest)) * inverse;
  const V reach = MulAdd(back(slack), set(0x1p100), Abs(w.h));
  const Four bounds = totals(Mul(size, reach), Mul(size, Abs(n.h)), hn::Zero(D()), hn::Zero(D()));
  const double doubt = 0x1p-97 * inverse * (bounds.x + away * bounds.y) + 0x1p-48 * std::fabs(change);
  bool certain = true;
  V q = hn::Zero(D());
  double length = 0;
  if constexpr (wants_point<To>) {
    const V way = set(t), at = back(p);
    const Pair down = product(way, n.h), h = difference(at, down.h);
    const V rest = Sub(h.l, MulAdd(set(change), n.h, MulAdd(way, n.l, down.l)));
    const V magnitude = MulAdd(set(away), size, Add(Abs(at), Abs(down.h)));
    const V bound = MulAdd(set(0x1p-100), magnitude, Mul(set(doubt), Abs(n.h)));
    certain = round(h.h, rest, bound, q);
    q = turned(q);
  }
  if constexpr (wants_distance<To>) {
    const Parts r = root(whole, whole_rest, 0);
    const double d = away * r.value, error = __builtin_fma(away, r.value, -d), more = t < 0 ? -change : change;
    certain &= round(d, error + (away * r.rest + more * r.value), 2 * doubt * r.value, length);
  }
  return certain && put(q, length, to);
}

#endif

}  // namespace
}  // namespace plumb::query::quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
