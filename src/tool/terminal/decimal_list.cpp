#include "tool/terminal/decimal_list.hpp"

#include <fmt/format.h>

#include "tool/terminal/decimal_range.hpp"

namespace plumb::tool {

DecimalList read_decimals(std::string_view words, std::string_view what) {
  DecimalList list;
  for (std::size_t from = 0;;) {
    const std::size_t to = words.find_first_of(",;", from);
    const Decimal number = read_decimal(words.substr(from, to - from), what);
    list.values.push_back(number.value);
    list.exact = list.exact && number.exact;
    if (to == std::string_view::npos) return list;
    from = to + 1;
  }
}

std::string inexact_remark(std::size_t inexact, std::size_t many, std::string_view things) {
  if (inexact == 0) return {};
  return fmt::format("{} of {} {} are given by decimals that are no doubles; they stand for the nearest ones.\n",
                     inexact, many, things);
}

}  // namespace plumb::tool
