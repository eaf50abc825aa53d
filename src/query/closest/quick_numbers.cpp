// Each question is compiled twice, for processors that multiply and add at once and for others; both answer the same.
#include "query/closest/quick_numbers.hpp"

#include "arith/twofold.hpp"
#include "certify/fused.hpp"

namespace plumb::query {
namespace {

struct PointsAndDistance {};
struct DistanceAlone {};

template <class T>
[[gnu::always_inline]] inline bool keep(double& out, const T& x) {
  const std::optional<double> nearest = x.nearest();
  if (!nearest) return false;
  out = *nearest;
  return true;
}
template <class T>
[[gnu::always_inline]] inline bool keep(Point2& out, const Vec2<T>& p) {
  return static_cast<int>(keep(out.x, p.x)) & static_cast<int>(keep(out.y, p.y));
}
template <class T>
[[gnu::always_inline]] inline bool keep(Point3& out, const Vec3<T>& p) {
  return static_cast<int>(keep(out.x, p.x)) & static_cast<int>(keep(out.y, p.y)) & static_cast<int>(keep(out.z, p.z));
}

template <class T, class V>
[[gnu::always_inline]] inline bool keep_length(double& out, const V& gap) {
  return keep(out, root(dot(gap, gap)));
}

/// Both strictly inside, and not parallel: in the plane they cross.
template <class Wanted, class T>
[[gnu::always_inline]] inline bool both_inside(const LinearFigure<Vec2<T>, Point2>& p,
                                               const LinearFigure<Vec2<T>, Point2>& q, PairNumbers<Point2>& out) {
  out.distance = 0;
  if constexpr (std::is_same_v<Wanted, DistanceAlone>) return true;
  const auto w = between<T>(p.from, q.from);
  const T s = quotient(cross(w, q.along).z, cross(p.along, q.along).z);
  const bool sure = keep(out.on_a, vector_of<T>(p.from) + p.along * s);
  out.on_b = out.on_a;
  return sure;
}
template <class Wanted, class T>
[[gnu::always_inline]] inline bool both_inside(const LinearFigure<Vec3<T>, Point3>& p,
                                               const LinearFigure<Vec3<T>, Point3>& q, PairNumbers<Point3>& out) {
  const Vec3<T> w = between<T>(p.from, q.from);
  const T a = dot(p.along, p.along), b = dot(p.along, q.along), c = dot(p.along, w);
  const T e = dot(q.along, q.along), f = dot(q.along, w), whole = a * e - b * b;
  const Vec3<T> on_p = p.along * quotient(c * e - b * f, whole), on_q = q.along * quotient(b * c - a * f, whole);
  bool sure = keep_length<T>(out.distance, (w + on_q) - on_p);
  if constexpr (std::is_same_v<Wanted, PointsAndDistance>) {
    sure &= keep(out.on_a, vector_of<T>(p.from) + on_p);
    sure &= keep(out.on_b, vector_of<T>(q.from) + on_q);
  }
  return sure;
}

/// The foot of a point on a line.
template <class Wanted, class T, class Point>
[[gnu::always_inline]] inline bool foot_on(const LinearFigure<VecOf<Point, T>, Point>& l, const Point& from,
                                           Point& foot, double& distance) {
  const auto w = between<T>(l.from, from);
  const auto along = l.along * quotient(dot(w, l.along), dot(l.along, l.along));
  bool sure = keep_length<T>(distance, w - along);
  if constexpr (std::is_same_v<Wanted, PointsAndDistance>) sure &= keep(foot, vector_of<T>(l.from) + along);
  return sure;
}

template <class Wanted, class T, class Point>
[[gnu::always_inline]] inline bool numbers(const Straight<Point>& a, const Straight<Point>& b, SpotsOnLines places,
                                           PairNumbers<Point>& out) {
  const auto p = linear<T>(a), q = linear<T>(b);
  const bool p_inside = places.a == SpotOnLine::inside, q_inside = places.b == SpotOnLine::inside;
  if (p_inside && q_inside) return both_inside<Wanted>(p, q, out);
  const Point &from = p.at(places.a), &to = q.at(places.b);
  if (!p_inside) out.on_a = told(from);
  if (!q_inside) out.on_b = told(to);
  if (p_inside) return foot_on<Wanted, T>(p, to, out.on_a, out.distance);
  if (q_inside) return foot_on<Wanted, T>(q, from, out.on_b, out.distance);
  return keep_length<T>(out.distance, between<T>(from, to));
}

template <class Wanted, class T>
[[gnu::always_inline]] inline bool face_numbers(const Point3& v, const Triangle3& t, PairNumbers<Point3>& out) {
  const Vec3<T> n = cross(between<T>(t.a, t.b), between<T>(t.a, t.c));
  const Vec3<T> down = n * quotient(dot(n, between<T>(v, t.a)), dot(n, n));
  bool sure = keep_length<T>(out.distance, down);
  out.on_a = told(v);
  if constexpr (std::is_same_v<Wanted, PointsAndDistance>) sure &= keep(out.on_b, vector_of<T>(v) + down);
  return sure;
}

template <class T>
[[gnu::always_inline]] inline bool crossing(const Straight<Point3>& s, const Triangle3& t, Point3& out) {
  const LinearFigure<Vec3<T>, Point3> p = linear<T>(s);
  const Vec3<T> n = cross(between<T>(t.a, t.b), between<T>(t.a, t.c));
  return keep(out, vector_of<T>(p.from) + p.along * quotient(dot(n, between<T>(p.from, t.a)), dot(n, p.along)));
}

template <class Wanted, class Point>
PLUMB_WITH_FMA bool with_fma(const Straight<Point>& a, const Straight<Point>& b, SpotsOnLines places,
                             PairNumbers<Point>& out) {
  return numbers<Wanted, Twofold<true>>(a, b, places, out);
}
template <class Wanted, class Point>
PLUMB_WITHOUT bool without(const Straight<Point>& a, const Straight<Point>& b, SpotsOnLines places,
                           PairNumbers<Point>& out) {
  return numbers<Wanted, Twofold<false>>(a, b, places, out);
}
template <class Wanted>
PLUMB_WITH_FMA bool with_fma(const Point3& v, const Triangle3& t, PairNumbers<Point3>& out) {
  return face_numbers<Wanted, Twofold<true>>(v, t, out);
}
template <class Wanted>
PLUMB_WITHOUT bool without(const Point3& v, const Triangle3& t, PairNumbers<Point3>& out) {
  return face_numbers<Wanted, Twofold<false>>(v, t, out);
}
PLUMB_WITH_FMA bool with_fma(const Straight<Point3>& s, const Triangle3& t, Point3& out) {
  return crossing<Twofold<true>>(s, t, out);
}
PLUMB_WITHOUT bool without(const Straight<Point3>& s, const Triangle3& t, Point3& out) {
  return crossing<Twofold<false>>(s, t, out);
}

template <class Wanted, class Point, class... Arguments>
std::optional<PairNumbers<Point>> numbers_of(const Arguments&... arguments) {
  PairNumbers<Point> out{};
  if (has_fma ? with_fma<Wanted>(arguments..., out) : without<Wanted>(arguments..., out)) return out;
  return {};
}
template <class Point, class... Arguments>
std::optional<double> distance_of(const Arguments&... arguments) {
  const auto found = numbers_of<DistanceAlone, Point>(arguments...);
  if (found) return found->distance;
  return {};
}

}  // namespace

std::optional<PairNumbers<Point2>> quick_numbers(const Straight<Point2>& p, const Straight<Point2>& q,
                                                 SpotsOnLines places) {
  return numbers_of<PointsAndDistance, Point2>(p, q, places);
}
std::optional<PairNumbers<Point3>> quick_numbers(const Straight<Point3>& p, const Straight<Point3>& q,
                                                 SpotsOnLines places) {
  return numbers_of<PointsAndDistance, Point3>(p, q, places);
}
std::optional<double> quick_distance(const Straight<Point2>& p, const Straight<Point2>& q, SpotsOnLines places) {
  return distance_of<Point2>(p, q, places);
}
std::optional<double> quick_distance(const Straight<Point3>& p, const Straight<Point3>& q, SpotsOnLines places) {
  return distance_of<Point3>(p, q, places);
}

std::optional<PairNumbers<Point3>> quick_numbers(const Point3& vertex, const Triangle3& face) {
  return numbers_of<PointsAndDistance, Point3>(vertex, face);
}
std::optional<double> quick_distance(const Point3& vertex, const Triangle3& face) {
  return distance_of<Point3>(vertex, face);
}

std::optional<Point3> quick_crossing(const Straight<Point3>& p, const Triangle3& face) {
  Point3 out{};
  if (has_fma ? with_fma(p, face, out) : without(p, face, out)) return out;
  return {};
}

}  // namespace plumb::query
