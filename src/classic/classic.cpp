// The classic C interface: a value of the right sign, from the filter where that is sure and the exact stages
// elsewhere.
#include "plumb/classic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/nearest_value.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb {
namespace {

/// The coordinates of N-dimensional points, one after another.
template <Formula F, class... Points>
Coordinates<F> gathered(const Points*... points) {
  constexpr auto dimension = static_cast<std::size_t>(F::dimension);
  static_assert(sizeof...(points) == static_cast<std::size_t>(F::points));
  Coordinates<F> p;
  double* next = p.data();
  ((next = std::copy_n(points, dimension, next)), ...);
  return p;
}

/// A computed value, and how far off it may be.
struct Estimate {
  double value, error;
};

template <Formula F>
Estimate estimate(const Coordinates<F>& p) {
  if constexpr (filter_is_magnitude<F>) {
    const Filtered r = evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; });
    return {r.value, filter_constant<F>() * r.magnitude};
  } else {
    return {F{}(p), largest_threshold<F>(largest_differences<F>(p))};
  }
}

bool all_finite(std::span<const double> p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

template <Formula F>
double exact(const Coordinates<F>& p) {
  return all_finite(p) ? nearest_value(certify::tape::program<F>(), p) : std::numeric_limits<double>::quiet_NaN();
}

// The sign comes first: it takes tens of nanoseconds, and mostly what the filter leaves open is zero.
template <Formula F>
[[gnu::noinline]] double unsure(const Coordinates<F>& p) {
  if (!all_finite(p)) return std::numeric_limits<double>::quiet_NaN();
  return decide_exactly<F>(p).sign == Sign::zero ? 0 : nearest_value(certify::tape::program<F>(), p);
}

template <Formula F>
double value(const Coordinates<F>& p) {
  const Estimate e = estimate<F>(p);
  // Good to a thousandth; false where something overflowed or is no number.
  if (std::fabs(e.value) > 1024 * e.error && std::fabs(e.value) <= std::numeric_limits<double>::max()) [[likely]] {
    return e.value;
  }
  return unsure<F>(p);
}

}  // namespace
}  // namespace plumb

using namespace plumb;  // NOLINT: the functions below belong to no namespace

void exactinit(void) {}

double orient2d(const double* pa, const double* pb, const double* pc) {
  return value<predicates::Orient2d>(gathered<predicates::Orient2d>(pa, pb, pc));
}
double orient3d(const double* pa, const double* pb, const double* pc, const double* pd) {
  return value<predicates::Orient3d>(gathered<predicates::Orient3d>(pa, pb, pc, pd));
}
double incircle(const double* pa, const double* pb, const double* pc, const double* pd) {
  return value<predicates::InCircle>(gathered<predicates::InCircle>(pa, pb, pc, pd));
}
double insphere(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe) {
  return value<predicates::InSphere>(gathered<predicates::InSphere>(pa, pb, pc, pd, pe));
}

double orient2dexact(const double* pa, const double* pb, const double* pc) {
  return exact<predicates::Orient2d>(gathered<predicates::Orient2d>(pa, pb, pc));
}
double orient3dexact(const double* pa, const double* pb, const double* pc, const double* pd) {
  return exact<predicates::Orient3d>(gathered<predicates::Orient3d>(pa, pb, pc, pd));
}
double incircleexact(const double* pa, const double* pb, const double* pc, const double* pd) {
  return exact<predicates::InCircle>(gathered<predicates::InCircle>(pa, pb, pc, pd));
}
double insphereexact(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe) {
  return exact<predicates::InSphere>(gathered<predicates::InSphere>(pa, pb, pc, pd, pe));
}

double orient2dslow(const double* pa, const double* pb, const double* pc) { return orient2dexact(pa, pb, pc); }
double orient3dslow(const double* pa, const double* pb, const double* pc, const double* pd) {
  return orient3dexact(pa, pb, pc, pd);
}
double incircleslow(const double* pa, const double* pb, const double* pc, const double* pd) {
  return incircleexact(pa, pb, pc, pd);
}
double insphereslow(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe) {
  return insphereexact(pa, pb, pc, pd, pe);
}

double orient2dfast(const double* pa, const double* pb, const double* pc) {
  return predicates::Orient2d{}(gathered<predicates::Orient2d>(pa, pb, pc));
}
double orient3dfast(const double* pa, const double* pb, const double* pc, const double* pd) {
  return predicates::Orient3d{}(gathered<predicates::Orient3d>(pa, pb, pc, pd));
}
double incirclefast(const double* pa, const double* pb, const double* pc, const double* pd) {
  return predicates::InCircle{}(gathered<predicates::InCircle>(pa, pb, pc, pd));
}
double inspherefast(const double* pa, const double* pb, const double* pc, const double* pd, const double* pe) {
  return predicates::InSphere{}(gathered<predicates::InSphere>(pa, pb, pc, pd, pe));
}
