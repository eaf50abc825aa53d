// Which numbers are "0,0,10"?  Decimals in a row, as points, rays and planes are given.
//
// Laws: (1) a decimal stands for its nearest double, and it is told whether that is it.  (2) Other words throw Error,
// which quotes them.
// Source: none.
// Cost: that of reading the decimals.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

struct DecimalList {
  std::vector<double> values;
  bool exact = true;  // no decimal of it was moved
};

/// Of numbers between commas or semicolons; `what` names the list in errors.
DecimalList read_decimals(std::string_view words, std::string_view what);

/// A line for readers: how many of so many `things` are not quite what was written; nothing where none is.
std::string inexact_remark(std::size_t inexact, std::size_t many, std::string_view things);

}  // namespace plumb::tool
