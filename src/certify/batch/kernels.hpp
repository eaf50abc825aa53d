// The filters of one formula for the instruction set at hand, under names that can be chosen at run time.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_KERNELS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_KERNELS
#undef PLUMB_BATCH_KERNELS
#else
#define PLUMB_BATCH_KERNELS
#endif

#include <hwy/highway.h>

#if HWY_TARGET != HWY_SCALAR
#include "certify/batch/against_one.hpp"
#include "certify/batch/many_cases.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::batch::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

struct ArrayOfPoints {
  template <class F>
  static constexpr std::size_t stride = certify::side::dimension<F>;
};

struct ArraysOfCoordinates {
  template <class F>
  static constexpr std::size_t stride = 1;
};

template <class F, class Layout>
std::size_t filter_many(const double* const* at, std::size_t n, signed char* out, std::uint32_t* unsure) {
  const auto ask = [at](std::size_t i) { return one_by_one::many<F>(at, Layout::template stride<F>, i); };
  return one_by_one::filter_all(ask, n, out, unsure);
}

template <class F, class Layout>
std::size_t filter_against(const Side<F>& side, const double* const* at, std::size_t n, signed char* out,
                           std::uint32_t* unsure) {
  const auto ask = [&](std::size_t i) { return one_by_one::against(side, at, Layout::template stride<F>, i); };
  return one_by_one::filter_all(ask, n, out, unsure);
}

#else

template <class F, class Layout>
HWY_INLINE std::size_t filter_many(const double* const* at, std::size_t n, signed char* out, std::uint32_t* unsure) {
  return filter_all(ManyCases<F, Layout>(), at, n, out, unsure);
}

template <class F, class Layout>
HWY_INLINE std::size_t filter_against(const Side<F>& side, const double* const* at, std::size_t n, signed char* out,
                                      std::uint32_t* unsure) {
  return filter_all(AgainstOne<F, Layout>(side), at, n, out, unsure);
}

#endif

namespace {  // each formula has a file of its own

using KernelFormula = predicates::PLUMB_BATCH_FORMULA;

std::size_t many_points(const void*, const double* const* at, std::size_t n, signed char* out, std::uint32_t* unsure) {
  return filter_many<KernelFormula, ArrayOfPoints>(at, n, out, unsure);
}
std::size_t many_coordinates(const void*, const double* const* at, std::size_t n, signed char* out,
                             std::uint32_t* unsure) {
  return filter_many<KernelFormula, ArraysOfCoordinates>(at, n, out, unsure);
}
std::size_t points_against(const void* given, const double* const* at, std::size_t n, signed char* out,
                           std::uint32_t* unsure) {
  return filter_against<KernelFormula, ArrayOfPoints>(*static_cast<const Side<KernelFormula>*>(given), at, n, out,
                                                      unsure);
}
std::size_t coordinates_against(const void* given, const double* const* at, std::size_t n, signed char* out,
                                std::uint32_t* unsure) {
  return filter_against<KernelFormula, ArraysOfCoordinates>(*static_cast<const Side<KernelFormula>*>(given), at, n, out,
                                                            unsure);
}

}  // namespace
}  // namespace plumb::certify::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
