// Where on a logarithmic axis does a value lie, and which ticks does the axis carry?
//
// Laws: (1) a larger value lies strictly nearer to the axis's far end (until the doubles for pixels run out); (2) every
// value that the axis was made for lies on it, at every magnitude; (3) two to thirteen ticks are labeled.
// Source: none.
// Cost: one logarithm a value.
#pragma once

#include <string>
#include <vector>

namespace plumb::tool {

struct Tick {
  double at;            // pixels
  int mantissa, power;  // value = mantissa * 10^power
  bool labeled;
};

class LogAxis {
 public:
  enum class Ends { whole_decades, padded };

  /// An axis over [low, high] (both positive and finite), drawn from pixel `from` to pixel `to`.
  LogAxis(double low, double high, Ends ends, double from, double to);

  [[nodiscard]] double at(double value) const;
  [[nodiscard]] std::vector<Tick> ticks() const;

 private:
  [[nodiscard]] double at_log(double log) const { return from_ + (log - low_) / (high_ - low_) * (to_ - from_); }

  double low_, high_;  // decimal logarithms of the ends
  double from_, to_;
};

/// A tick's label as SVG text: 0.01 where every labeled tick of the axis stays that short, a power of ten elsewhere.
std::string tick_text(const Tick& tick, const std::vector<Tick>& axis);

}  // namespace plumb::tool
