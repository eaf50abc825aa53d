// Is the exact answer known?  A judge that is a function of the user's may have none, or none of all that is answered.
//
// Source: none; cost: none.
#pragma once

#include <cmath>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

/// Not NaN.  Of triangles it always is: no function judges those.
inline bool is_known(const Kind& kind, const Answer& exact) {
  return kind.form == AnswerForm::triangles || !std::isnan(exact.numbers[0]);
}

/// Of a hit: where on the ray, too.
inline bool knows_parameter(const Answer& exact) { return exact.numbers.size() == 2 && !std::isnan(exact.numbers[1]); }

}  // namespace plumb::degenerate
