// In which numbers are segments tried?  The usual ones, and the library's rationals, by one name each.
//
// Source: RTCD 11.3.1.
// Cost: none, a list.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "lab/trial/segment_tests.hpp"
#include "lab/trial/vec.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::stability {

template <class T>
trial::Segment<T> converted(const Segment2& s) {
  return {{T(static_cast<T>(s.a.x)), T(static_cast<T>(s.a.y))}, {T(static_cast<T>(s.b.x)), T(static_cast<T>(s.b.y))}};
}

/// The relative epsilon of these segments.
inline double relative_epsilon(std::span<const Segment2> segments) {
  double largest = 0;
  for (const Segment2& s : segments) {
    for (const double x : {s.a.x, s.a.y, s.b.x, s.b.y}) largest = std::max(largest, trial::magnitude(x));
  }
  return trial::customary_epsilon * largest;
}

inline constexpr std::array<std::string_view, 5> float_method_names{"float32", "double", "absolute", "relative",
                                                                    "long-double"};

/// Calls ask(epsilon), an epsilon of the numbers that the method of this name takes; "exact" takes rationals.
template <class Ask>
auto in_numbers_of(std::string_view method, std::span<const Segment2> segments, Ask ask) {
  if (method == "float32") return ask(0.0F);
  if (method == "double") return ask(0.0);
  if (method == "absolute") return ask(trial::customary_epsilon);
  if (method == "relative") return ask(relative_epsilon(segments));
  if (method == "long-double") return ask(0.0L);
  return ask(Rational());
}

}  // namespace plumb::lab::stability
