// What are the cosine and the sine of half of an angle?  Between which doubles, whatever its size.
//
// Laws: both intervals hold the exact numbers; up to 2^-45 wide for angles below 64 and 2^-50 wide above.
// Source: the series of both, whose terms for arguments up to 1 alternate and become smaller, so that what is left out
// is less than the last term; and the double angle's formula, without pi.
// Cost: some 1 us for angles below 64, up to a few milliseconds above.
#pragma once

#include "plumb/arith/interval.hpp"

namespace plumb::figure {

struct CosineSine {
  Interval cosine, sine;
};
CosineSine cosine_and_sine_of_half(double angle);

}  // namespace plumb::figure
