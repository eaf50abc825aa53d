// How is a double written for people?  The shortest decimal that reads back as the same double.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace plumb::degenerate {

std::string decimal(double x);

/// One after the other, as `write` writes each.
template <class Write>
std::string joined(std::span<const double> numbers, std::string_view between, const Write& write) {
  std::string text;
  for (const double x : numbers) text.append(text.empty() ? "" : between).append(write(x));
  return text;
}

}  // namespace plumb::degenerate
