// Does plain floating point prove the sign of a formula with absolute values?  F::gap(p, absolute) is that formula, F
// itself one with these resolved.
//
// Laws: those of certify/detail/filter_stage.hpp.  | |v| - |V| | <= |v - V|, so the magnitude still bounds the error.
// Source: docs/proof.md.
// Cost: that of filter A.
#pragma once

#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb {

template <Formula F>
constexpr int gap_filter(const Coordinates<F>& p) {
  const Filtered r = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return F::gap(std::array{Filtered::Input{p[I]}...}, [](const Filtered& product) {
      return Filtered{magnitude_of(product.value), product.magnitude};
    });
  }
  (std::make_index_sequence<arity<F>>{});
  return beyond(r.value, filter_constant<F>() * r.magnitude);
}

}  // namespace plumb
