// Which numbers are start, start + step, ... up to stop?  As decimals, exactly: 0:1:0.1 has eleven.
//
// Laws: (1) sums are those of the decimals, not of doubles; stop is among them where a sum reaches it.  (2) A text that
// is no decimal, a step that is not positive and more numbers than allowed throw Error, which says how to mend it.
// Source: none.
// Cost: big integers, some 100 ns a number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

struct Decimal {
  std::string text;  // as it was given, or the sum
  double value;      // the nearest double
  bool exact;        // which it equals
};

/// `what` names the number in errors.
Decimal read_decimal(std::string_view text, std::string_view what);

std::vector<Decimal> decimal_range(std::string_view start, std::string_view stop, std::string_view step,
                                   std::string_view what, std::size_t most);

}  // namespace plumb::tool
