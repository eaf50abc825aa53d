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

#include "plumb/surface/file/decimal.hpp"

namespace plumb::tool {

struct Decimal {
  std::string text;  // as it was given, or the sum
  double value;      // the nearest double
  bool exact;        // which it equals
};

/// `what` names the number in errors.
Decimal read_decimal(std::string_view text, std::string_view what);

/// Throws Error for what is no number.
[[noreturn]] void refuse_decimal(DecimalReader::Outcome outcome, std::string_view text, std::string_view what);

/// One of many; what() is asked for errors alone.
template <class What>
double read_decimal(DecimalReader& reader, std::string_view text, const What& what) {
  double value = 0;
  const DecimalReader::Outcome outcome = reader.read(text, value);
  if (outcome != DecimalReader::Outcome::number) refuse_decimal(outcome, text, what());
  return value;
}

std::vector<Decimal> decimal_range(std::string_view start, std::string_view stop, std::string_view step,
                                   std::string_view what, std::size_t most);

}  // namespace plumb::tool
