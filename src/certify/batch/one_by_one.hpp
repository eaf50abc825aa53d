// What does a filter say of many cases, where there are no vectors?  The filters of one case, in a loop.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/certify/side.hpp"

namespace plumb::certify::batch::one_by_one {

/// As filter_all of lanes.hpp; `stride` is the step from a coordinate to that of the next case.
template <class Ask>
std::size_t filter_all(Ask ask, std::size_t n, signed char* out, std::uint32_t* unsure) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int sign = ask(i);
    out[i] = static_cast<signed char>(sign);
    unsure[count] = static_cast<std::uint32_t>(i);
    count += sign == 0;
  }
  return count;
}

template <Formula F>
int many(const double* const* at, std::size_t stride, std::size_t i) {
  Coordinates<F> p;
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = at[k][i * stride];
  return filter<F>(p);
}

template <Formula F>
int against(const Side<F>& side, const double* const* at, std::size_t stride, std::size_t i) {
  const double* const* query = at + arity<F> - certify::side::dimension<F>;
  if constexpr (certify::side::dimension<F> == 2) {
    return side.filter({query[0][i * stride], query[1][i * stride]});
  } else {
    return side.filter({query[0][i * stride], query[1][i * stride], query[2][i * stride]});
  }
}

}  // namespace plumb::certify::batch::one_by_one
