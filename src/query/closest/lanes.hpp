// The foot of a perpendicular in two doubles a number, x, y and z in three lanes, whose errors are bounded as they
// are computed.
//
// Included once for each target, by the files that Highway compiles for several (query/closest/quick.cpp); there are
// lanes for AVX2 alone.  A line through o along d, w = p - o, t = w.d / d.d.  What `To` is says what is wanted: a
// Point3, a double for the distance, a Closest for both.
// Laws: those of arith/twofold.hpp; false says nothing.
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

#include "certify/three_twofolds.hpp"
#include "plumb/query/closest/result.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using lanes::Three, lanes::Twofolds, lanes::Dots, lanes::loaded;
using One = Twofolds::One;

template <class To>
inline constexpr bool wants_point = !std::same_as<To, double>;
template <class To>
inline constexpr bool wants_distance = !std::same_as<To, Point3>;

HWY_INLINE void name_feature(Closest& to, Feature f) { to.feature_b = f; }
HWY_INLINE void name_feature(Point3&, Feature) {}
HWY_INLINE void name_feature(double&, Feature) {}

/// Never -0.
HWY_INLINE __m256d without_sign_of_zero(const Three& q) { return _mm256_add_pd(q.v, _mm256_setzero_pd()); }
/// In one piece, from which whoever reads numbers in pairs need not wait for several.
HWY_INLINE bool put(const Three& point, double distance, Closest& to) {
  static_assert(offsetof(Closest, distance) == offsetof(Closest, on_b) + 3 * sizeof(double));
  const __m256d q = without_sign_of_zero(point), d = _mm256_broadcast_sd(&distance);
  auto* const at = reinterpret_cast<double*>(reinterpret_cast<char*>(&to) + offsetof(Closest, on_b));
  _mm256_storeu_pd(at, _mm256_blend_pd(q, d, 0b1000));
  return true;
}
HWY_INLINE bool put(const Three& point, double, Point3& to) {
  const __m256d q = without_sign_of_zero(point);
  _mm_storeu_pd(&to.x, _mm256_castpd256_pd128(q));
  to.z = _mm_cvtsd_f64(_mm256_extractf128_pd(q, 1));
  return true;
}
HWY_INLINE bool put(const Three&, double distance, double& to) { return to = distance, true; }

/// At a corner as given.
template <class To>
HWY_INLINE bool at_corner(const Three& corner, const Three& p, To& to) {
  double distance = 0;
  if constexpr (wants_distance<To>) {
    if (!root_of_squares(square(Twofolds::difference(p, corner))).told(distance)) return false;
  }
  return put(corner, distance, to);
}

/// |w - along|, where p may be near to the line: fewer digits are lost by the way to it.
HWY_INLINE bool length(const Twofolds& w, const Twofolds& along, double& distance) {
  return root(total((w - along).squared())).told(distance);
}
HWY_INLINE bool length_to(const Twofolds& w, const Twofolds& d, double& distance) {
  const Dots s = squares(w, d);
  return length(w, scaled(d, quotient_by_squares(s.y, s.z)), distance);
}
/// The distance of p from the line through a and b.  Out of line it is told by what is given, so that the quick way
/// keeps nothing in memory for it.
[[gnu::cold]] HWY_NOINLINE bool length_to(const Point3& a, const Point3& b, const Point3& p, double& distance) {
  const Three from = loaded(a);
  return length_to(Twofolds::difference(loaded(p), from), Twofolds::difference(loaded(b), from), distance);
}

/// The foot strictly between the ends of a line through `start`, or through that and `offset`, and how far it is: by
/// w, d, and w.w, w.d and d.d; near to the line by `closer(w, along, distance)`.
template <class To>
HWY_INLINE bool foot(const Three& start, const Twofolds& w, const Twofolds& d, const Dots& s, Three& q,
                     double& distance, const auto& closer, const auto&... offset) {
  const One t = quotient_by_squares(s.y, s.z);
  const Twofolds along = scaled(d, t);
  if (wants_point<To> && !(start + (offset + ... + along)).told(q)) return false;
  return !wants_distance<To> || root_at_once(s.x - t * s.y).told(distance) || closer(w, along, distance);
}
constexpr auto by_the_way = [](const Twofolds& w, const Twofolds& along, double& distance)
                                HWY_ATTR { return length(w, along, distance); };
/// Between a and b.
template <class To>
HWY_INLINE bool on_edge(const Point3& a, const Point3& b, const Point3& p, const Twofolds& w, const Twofolds& d,
                        const Dots& s, To& to) {
  const auto closer = [&](const Twofolds&, const Twofolds&, double& distance) { return length_to(a, b, p, distance); };
  Three q = loaded(a);
  double distance = 0;
  return foot<To>(q, w, d, s, q, distance, closer) && put(q, distance, to);
}

/// Above a plane: p less t n, for the normal n = ab x ac and t = n.ap / n.n.
template <class To>
HWY_INLINE bool on_face(const Three& p, const Twofolds& ab, const Twofolds& ac, const Twofolds& ap, To& to) {
  // The lanes of n are in the order z x y, and so are those of the point.
  const Twofolds n = crossed(ab, ac), square = n * n;
  const Dots s = apart(sums(n * ap.turned_back(), square, square));
  const One t = quotient_at_once(s.x, s.y);
  Three q = lanes::of_all(0);
  if constexpr (wants_point<To>) {
    if (!(turned_back(p) + -scaled(n, t)).told(q)) return false;
    q = turned(q);
  }
  double distance = 0;
  if constexpr (wants_distance<To>) {
    if (!(t * root_at_once(s.y)).told(distance)) return false;
  }
  return put(q, std::fabs(distance), to);
}

#endif

}  // namespace
}  // namespace plumb::query::quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
