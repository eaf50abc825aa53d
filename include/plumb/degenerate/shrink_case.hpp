// What is the simplest case of a kind that still fails?  Shrinking that knows what the numbers are.
//
// Points of arguments that may have any number are dropped, axes turn to those of the coordinates, points merge,
// coordinates lose bits and are translated and scaled toward small integers.
// Laws: (1) the result is a case without a flaw that still fails, if the case given is; (2) it is never less simple:
// fewer points first, then simpler axes, then simpler coordinates (degenerate/shrink.hpp).  (3) Figures keep their
// dimension: a triangle that has an area keeps one, so that failures of proper figures do not become those of
// degenerate ones.  (4) `still_fails` is called at most `most_calls` times, always in the same order.
// Source: degenerate/shrink.hpp.
// Cost: most_calls calls at the worst, usually some hundreds.
#pragma once

#include "plumb/degenerate/kind.hpp"
#include "plumb/degenerate/shrink.hpp"

namespace plumb::degenerate {

Numbers shrink_case(const Kind& kind, Numbers numbers, const FailsOnCoordinates& still_fails,
                    std::size_t most_calls = 20'000);

}  // namespace plumb::degenerate
