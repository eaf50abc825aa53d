#include <cstddef>
#include <limits>

#include "query/time_of_impact/quick_corner.hpp"
#include "query/time_of_impact/quick_search.hpp"

namespace plumb::query::quick {
namespace {

using T = Approximate;

/// Are points of both within reach?
bool within_reach(const auto& m, const Parts& of_a, const Parts& of_b, double time) {
  const Vec3<T> d = (m.apart + m.b.at(of_b)) - (m.a.at(of_a) + m.by * T(time));
  return certain_sign(m.reach * m.reach - dot(d, d)) > 0;
}

/// The time at which the point, line or plane of the corner comes within reach.
Pairs time_of(const Corner<Pairs>& c, const Vec3<Pairs>& by, const Pairs& reach) {
  if (c.inside_count == 2) {
    const Vec3<Pairs> n = cross(c.inside[0], c.inside[1]);
    const Pairs gap = dot(c.at, n), way(gap.high < 0 ? -1 : 1);
    return quotient(gap * way - reach * root(dot(n, n)), dot(by, n) * way);
  }
  const bool line = c.inside_count == 1;
  const Vec3<Pairs> d = line ? cross(c.at, c.inside[0]) : c.at, v = line ? cross(by, c.inside[0]) : by;
  const Pairs square = line ? reach * reach * dot(c.inside[0], c.inside[0]) : reach * reach;
  const Pairs from = dot(d, d) - square, half_change = dot(d, v);
  return quotient(from, root(half_change * half_change - dot(v, v) * from) + half_change);
}

template <class N, class A, class B>
Corner<N> corner_of(const Moved<N, A, B>& m, const ExtremeFace& a, const ExtremeFace& b) {
  return Corner<N>(m.apart, m.a, m.b, a, b);
}

template <class A, class B>
Answer first_contact(const Translating<A>& a, const Translating<B>& b, const Moved<T, A, B>& m, const auto& search) {
  ExtremeFace of_a = place_of<typename Moved<T, A, B>::HullA>(search.of_a);
  const ExtremeFace of_b = place_of<typename Moved<T, A, B>::HullB>(search.of_b);
  if (of_a.inside_count + of_b.inside_count > 2) return unsure;
  if (is_ball<A>) of_a.feature = {FeatureKind::face, 0};
  const Moved<Pairs, A, B> precise(a, b);
  const Answer answer =
      at(time_of(corner_of(precise, of_a, of_b), precise.by, precise.reach), of_a.feature, of_b.feature);
  if (answer.told != MotionVerdict::yes) return unsure;
  const double t = answer.contact.time;  // less than an ulp early
  if (!(t >= std::numeric_limits<double>::min() && t < 1)) return unsure;
  Corner<T> then = corner_of(m, of_a, of_b);
  constexpr double ulp = 2;  // of a number that is not subnormal, in units of 2^-53 of it
  then.at = then.at - m.by * T{t, t, ulp};
  const auto nearest = then.nearest();
  return nearest && certain_sign(dot(nearest->direction, m.by)) > 0 ? answer : unsure;
}

}  // namespace

template <ContactWanted asked, Round A, Small B>
requires(!IsBalls<A, B>) Answer contact(const Translating<A>& a, const Translating<B>& b) {
  MotionSearch<A, B> search(a, b);
  const double reach = search.reach;
  if (!(reach > 0)) return unsure;
  constexpr int most_sweeps = 10;
  for (int i = 0;; ++i) {
    const Vec3<double>& d = search.between_them;
    if (dot(d, d) < reach * reach) break;
    if (search.apart_along()) return no;
    if (i == most_sweeps) return unsure;
    search.sweep(true);
  }
  const Moved<T, A, B> m(a, b);
  if (!within_reach(m, search.of_a, search.of_b, search.time)) return unsure;
  if constexpr (asked == ContactWanted::whether) return {MotionVerdict::yes};
  if (!search.find_first()) return {MotionVerdict::starts};
  return first_contact(a, b, m, search);
}
PLUMB_QUICK_PAIR(Sphere3, Segment3)
PLUMB_QUICK_PAIR(Sphere3, Triangle3)
PLUMB_QUICK_PAIR(Sphere3, Aabb3)
PLUMB_QUICK_PAIR(Sphere3, Obb3)
PLUMB_QUICK_PAIR(Sphere3, Capsule3)
PLUMB_QUICK_PAIR(Capsule3, Point3)
PLUMB_QUICK_PAIR(Capsule3, Segment3)
PLUMB_QUICK_PAIR(Capsule3, Triangle3)
PLUMB_QUICK_PAIR(Capsule3, Aabb3)
PLUMB_QUICK_PAIR(Capsule3, Obb3)
PLUMB_QUICK_PAIR(Capsule3, Capsule3)

}  // namespace plumb::query::quick
