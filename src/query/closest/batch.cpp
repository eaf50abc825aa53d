// Squares of distances in doubles, in lanes, between bounds; then the few items whose bounds overlap, exactly.
//
// Any t in [0, 1] names a point of a segment, whose distance is no less than the segment's; and a t that is off by e
// makes the square of the distance too large by at most e^2 |d|^2, beside what rounding does.  With s the square of the
// sum of magnitudes of all differences that go in, everything here is off by less than 2^-40 s: some fifty roundings of
// numbers up to s, 2^-47 s, and e^2 |d|^2, where e |d| is below 2^-45 of that sum.
// A triangle's nearest point is on an edge, or its foot on the plane, where that is inside: the face counts below
// everything where it may hold the foot, and above only edges count.
#include "plumb/query/closest/batch.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "certify/batch/instruction_sets.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/body/figure_input.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::query::batch::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

struct Vec3 {
  V x, y, z;
};
HWY_INLINE Vec3 minus(const Vec3& a, const Vec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE V dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE V size(const Vec3& a) { return hn::Add(hn::Add(hn::Abs(a.x), hn::Abs(a.y)), hn::Abs(a.z)); }
HWY_INLINE Vec3 load(const double* const* of, std::size_t corner, std::size_t i) {
  return {hn::LoadU(D(), of[3 * corner] + i), hn::LoadU(D(), of[3 * corner + 1] + i),
          hn::LoadU(D(), of[3 * corner + 2] + i)};
}

/// The square of the distance of w from 0 d ... 1 d.
HWY_INLINE V to_segment(const Vec3& w, const Vec3& d) {
  const V whole = dot(d, d), zero = hn::Zero(D());
  const V t = hn::Div(dot(w, d), whole);
  const V in = hn::IfThenElse(hn::Gt(whole, zero), hn::Min(hn::Max(t, zero), hn::Set(D(), 1)), zero);
  const Vec3 rest{hn::Sub(w.x, hn::Mul(in, d.x)), hn::Sub(w.y, hn::Mul(in, d.y)), hn::Sub(w.z, hn::Mul(in, d.z))};
  return dot(rest, rest);
}

struct Bounds {
  V lower, upper;
};
HWY_INLINE Bounds around(V square, V sum) {
  const V doubt = hn::MulAdd(hn::Mul(sum, sum), hn::Set(D(), 0x1p-40), hn::Set(D(), 0x1p-960));
  return {hn::Sub(square, doubt), hn::Add(square, doubt)};
}

template <int corners>
HWY_INLINE Bounds bounds(const double* const* of, const Vec3& p, std::size_t i) {
  const Vec3 a = load(of, 0, i), ap = minus(p, a);
  if constexpr (corners == 1) {
    return around(dot(ap, ap), size(ap));
  } else if constexpr (corners == 2) {
    const Vec3 ab = minus(load(of, 1, i), a);
    return around(to_segment(ap, ab), hn::Add(size(ap), size(ab)));
  } else {
    const Vec3 b = load(of, 1, i), c = load(of, 2, i), ab = minus(b, a), ac = minus(c, a), bp = minus(p, b);
    const V edges = hn::Min(hn::Min(to_segment(ap, ab), to_segment(ap, ac)), to_segment(bp, minus(c, b)));
    const V sum = hn::Add(hn::Add(size(ap), size(bp)), hn::Add(size(ab), size(ac)));
    Bounds all = around(edges, hn::Add(sum, sum));
    // The sides of the edges on which p projects; off by less than 2^-45 of the fourth power of the sum.
    const Vec3 n = cross(ab, ac);
    const V whole = dot(n, n), height = dot(n, ap);
    const V v = dot(cross(ap, ac), n), w = dot(cross(ab, ap), n), u = hn::Sub(hn::Sub(whole, v), w);
    const V s2 = hn::Mul(sum, sum), s4 = hn::Mul(s2, s2), slack = hn::Mul(s4, hn::Set(D(), 0x1p-45));
    const V least = hn::Min(hn::Min(v, w), u);
    // The bounds below are of sixth powers: elsewhere the edges bound from above, and nothing from below.
    const auto fits = hn::And(hn::Ge(sum, hn::Set(D(), 0x1p-120)), hn::Le(sum, hn::Set(D(), 0x1p120)));
    const auto outside = hn::And(fits, hn::Lt(least, hn::Neg(slack))), inside = hn::And(fits, hn::Gt(least, slack));
    const V low = hn::Max(hn::Zero(D()), hn::Sub(hn::Abs(height), hn::Mul(hn::Mul(s2, sum), hn::Set(D(), 0x1p-45)))),
            high = hn::MulAdd(hn::Mul(s2, sum), hn::Set(D(), 0x1p-45), hn::Abs(height));
    const V wide = hn::Set(D(), 1 + 0x1p-40), narrow = hn::Set(D(), 1 - 0x1p-40);
    const V below = hn::IfThenElseZero(fits, hn::Mul(narrow, hn::Div(hn::Mul(low, low), hn::Add(whole, slack))));
    const V above = hn::Mul(wide, hn::Div(hn::Mul(high, high), hn::Sub(whole, slack)));
    all.lower = hn::IfThenElse(outside, all.lower, hn::Min(all.lower, below));
    all.upper = hn::IfThenElse(inside, hn::Min(all.upper, above), all.upper);
    return all;
  }
}

/// The lower bounds of all; the least upper one.  The arrays are filled up to whole lanes.
template <int corners>
double scan(const double* const* of, std::size_t n, const Point3& point, double* lower) {
  const Vec3 p{hn::Set(D(), point.x), hn::Set(D(), point.y), hn::Set(D(), point.z)};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  V least = hn::Set(D(), infinity);
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t i = 0; i < n; i += lanes) {
    const Bounds b = bounds<corners>(of, p, i);
    // NaN, of what overflows, is no bound.
    hn::StoreU(hn::IfThenElse(hn::Eq(b.lower, b.lower), b.lower, hn::Set(D(), -infinity)), D(), lower + i);
    least = hn::Min(least, hn::IfThenElse(hn::Eq(b.upper, b.upper), b.upper, hn::Set(D(), infinity)));
  }
  return hn::GetLane(hn::MinOfLanes(D(), least));
}

double points(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return scan<1>(of, n, p, lower);
}
double segments(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return scan<2>(of, n, p, lower);
}
double triangles(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return scan<3>(of, n, p, lower);
}

}  // namespace
}  // namespace plumb::query::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb {
namespace query {
namespace batch {
HWY_EXPORT(points);
HWY_EXPORT(segments);
HWY_EXPORT(triangles);
}  // namespace batch

namespace {

constexpr std::size_t most_lanes = 8;

template <class Batch, std::size_t numbers, class Scan>
NearestOfMany nearest_of(const Batch& many, const Point3& p, Scan scan) {
  require_figure("nearest", "p", p);
  if (many.size() == 0) throw InvalidShape("nearest: the batch is empty; give one item at least");
  std::array<const double*, numbers> of{};
  for (std::size_t k = 0; k < numbers; ++k) of[k] = many.numbers(k);
  std::vector<double> lower(many.size() + most_lanes);
  const double least = scan(of.data(), many.size(), p, lower.data());
  std::size_t best = many.size();
  for (std::size_t i = 0; i < many.size(); ++i) {
    if (lower[i] > least) continue;
    if (best == many.size() || compare_distance(p, many[i], p, many[best]) == Sign::negative) best = i;
  }
  return {best, distance(p, many[best])};
}

}  // namespace

}  // namespace query

NearestOfMany nearest(const PointBatch& many, const Point3& p) {
  return query::nearest_of<PointBatch, 3>(many, p, PLUMB_DISPATCH(query::batch::points));
}
NearestOfMany nearest(const SegmentBatch& many, const Point3& p) {
  return query::nearest_of<SegmentBatch, 6>(many, p, PLUMB_DISPATCH(query::batch::segments));
}
NearestOfMany nearest(const TriangleBatch& many, const Point3& p) {
  return query::nearest_of<TriangleBatch, 9>(many, p, PLUMB_DISPATCH(query::batch::triangles));
}

}  // namespace plumb
#endif
