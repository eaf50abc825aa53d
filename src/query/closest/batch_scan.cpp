#include "query/closest/batch_scan.hpp"

#include <limits>

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/batch_scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/many_lanes.hpp"
#include "query/closest/distance_bounds.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::batch::HWY_NAMESPACE {
namespace {

namespace lanes = certify::many_lanes::HWY_NAMESPACE;
namespace statement = distance_bounds::HWY_NAMESPACE;
using lanes::Many, lanes::Truth, lanes::above, lanes::of_all;
using statement::DistanceBounds, statement::Way;
using World = lanes::Floats<Many, DistanceBounds::highest, DistanceBounds::scales>;

constexpr std::size_t count_of_lanes = lanes::hn::MaxLanes(lanes::Lanes());
constexpr double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE Way<Many> load(const double* const* of, std::size_t corner, std::size_t i) {
  const auto one = [&](std::size_t k)
                       HWY_ATTR { return Many{lanes::hn::LoadU(lanes::Lanes(), of[3 * corner + k] + i)}; };
  return {one(0), one(1), one(2)};
}

// Guesses: plain values of portions, which the bounds take as given.
HWY_INLINE Many quotient(const Many& a, const Many& b) { return {lanes::hn::Div(a.v, b.v)}; }
template <class A, class B>
HWY_INLINE Many dot(const Way<A>& a, const Way<B>& b) {
  return DistanceBounds::dot(a, b).value;
}
HWY_INLINE Many opposite_dot(const auto& a, const auto& b) { return of_all(0) - dot(a, b); }

/// On q + t d: where it is guessed to be nearest to the origin; and how much less than that of q the square is there.
struct GuessedFoot {
  Many t, gain;
};
HWY_INLINE GuessedFoot guessed_foot(const Many& minus_qd, const Many& dd) {
  const Many t = quotient(minus_qd, dd);
  const Many in = smaller(chosen(above(t, of_all(0)), t, of_all(0)), of_all(1));
  return {in, in * minus_product(minus_qd + minus_qd, in, dd)};
}

/// The point a + s (ab + t bc) of a triangle.
struct GuessedPoint {
  Many s, t;
};
/// By the ways to corners and along edges.
HWY_INLINE GuessedPoint guessed_point(const auto& qa, const auto& qb, const auto& ab, const auto& bc, const auto& ac) {
  const Many zero = of_all(0), one = of_all(1), to_b = opposite_dot(qa, ab), to_c = opposite_dot(qa, ac),
             bb = dot(ab, ab), cc = dot(ac, ac);
  const GuessedFoot on_ab = guessed_foot(to_b, bb), on_ac = guessed_foot(to_c, cc),
                    on_bc = guessed_foot(opposite_dot(qb, bc), dot(bc, bc));
  const Truth ac_first = above(on_ac.gain, on_ab.gain);
  const Truth bc_first = above(on_bc.gain + ((to_b + to_b) - bb), larger(on_ac.gain, on_ab.gain));
  const Many s = chosen(bc_first, one, chosen(ac_first, on_ac.t, on_ab.t));
  const Many t = chosen(bc_first, on_bc.t, chosen(ac_first, one, zero));
  // The face, unless the triangle is so thin that an edge is as near.
  constexpr double thin_guess = 0x1p-34;
  const Many across = dot(ab, ac), squares = bb * cc, whole = minus_product(squares, across, across);
  const Many of_b = minus_product(to_b * cc, across, to_c), of_c = minus_product(to_c * bb, across, to_b),
             both = of_b + of_c;
  const Truth inside =
      above(of_b, zero) & above(of_c, zero) & above(whole, both) & above(whole, squares * of_all(thin_guess));
  return {chosen(inside, quotient(both, whole), s), chosen(inside, quotient(of_c, both), t)};
}

/// Doubles that bound the square, where the world is sure of them.
struct Told {
  Many lower, upper;
};
template <class L, class U>
HWY_INLINE Told told(const World& w, const statement::Between<L, U>& b) {
  const Truth sure = w.in_range();
  return {chosen(sure, w.lower(b.lower), of_all(-infinity)), chosen(sure, w.upper(b.upper), of_all(infinity))};
}

template <int corners>
HWY_INLINE Told bounds(const double* const* of, const Way<Many>& p, std::size_t i) {
  using S = DistanceBounds;
  World w;
  const Way<Many> a = load(of, 0, i);
  const auto qa = S::way(w, p, a);
  if constexpr (corners == 1) {
    return told(w, S::between(qa));
  } else if constexpr (corners == 2) {
    const Way<Many> b = load(of, 1, i);
    const auto qb = S::way(w, p, b);
    const auto ab = S::edge(w, a, b, qa, qb);
    const auto r = S::along(qa, ab, w.portion(quotient(opposite_dot(qa, ab), dot(ab, ab))));
    return told(w, S::between(r, S::dot(r, r), qa, qb));
  } else {
    const Way<Many> b = load(of, 1, i), c = load(of, 2, i);
    const auto qb = S::way(w, p, b), qc = S::way(w, p, c);
    const auto ab = S::edge(w, a, b, qa, qb), bc = S::edge(w, b, c, qb, qc), ac = S::edge(w, a, c, qa, qc);
    const GuessedPoint g = guessed_point(qa, qb, ab, bc, ac);
    const auto r = S::along(qa, S::along(ab, bc, w.portion(g.t)), w.portion(g.s));
    return told(w, S::between(r, S::dot(r, r), qa, qb, qc));
  }
}

template <int corners>
double scan(const double* const* of, std::size_t n, const Point3& point, double* lower) {
  const Way<Many> p{of_all(point.x), of_all(point.y), of_all(point.z)};
  Many least = of_all(infinity);
  for (std::size_t i = 0; i < n; i += count_of_lanes) {
    const Told b = bounds<corners>(of, p, i);
    lanes::hn::StoreU(b.lower.v, lanes::Lanes(), lower + i);
    least = smaller(b.upper, least);
  }
  return lanes::hn::GetLane(lanes::hn::MinOfLanes(lanes::Lanes(), least.v));
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

std::size_t list(double most, const double* lower, std::size_t n, std::uint32_t* which) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; i += count_of_lanes) {
    const Truth may_be = at_most(Many{lanes::hn::LoadU(lanes::Lanes(), lower + i)}, of_all(most));
    if (!any(may_be)) continue;
    for (std::size_t k = i; k < n && k < i + count_of_lanes; ++k) {
      if (lower[k] <= most) which[count++] = static_cast<std::uint32_t>(k);
    }
  }
  return count;
}

}  // namespace
}  // namespace plumb::query::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::query::batch {
namespace {

PLUMB_EXPORT(points);
PLUMB_EXPORT(segments);
PLUMB_EXPORT(triangles);
PLUMB_EXPORT(list);

}  // namespace

double scan_points(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return PLUMB_DISPATCH(points)(of, n, p, lower);
}
double scan_segments(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return PLUMB_DISPATCH(segments)(of, n, p, lower);
}
double scan_triangles(const double* const* of, std::size_t n, const Point3& p, double* lower) {
  return PLUMB_DISPATCH(triangles)(of, n, p, lower);
}
std::size_t list_up_to(double most, const double* lower, std::size_t n, std::uint32_t* which) {
  return PLUMB_DISPATCH(list)(most, lower, n, which);
}

}  // namespace plumb::query::batch
#endif
