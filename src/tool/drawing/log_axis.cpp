#include "tool/drawing/log_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumb::tool {

LogAxis::LogAxis(double low, double high, Ends ends, double from, double to)
    : low_(std::log10(low)), high_(std::log10(high)), from_(from), to_(to) {
  if (ends == Ends::whole_decades) {
    low_ = std::floor(low_);
    high_ = std::max(std::ceil(high_), low_ + 1);
    return;
  }
  const double missing = std::max(0.0, 1 - (high_ - low_)) / 2;  // one decade at least
  low_ -= missing;
  high_ += missing;
  const double room = (high_ - low_) / 14;
  low_ -= room;
  high_ += room;
}

double LogAxis::at(double value) const { return at_log(std::log10(value)); }

std::vector<Tick> LogAxis::ticks() const {
  const double decades = high_ - low_;
  const double pixels = std::abs(to_ - from_) / decades;
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 12)));  // decades between labels
  const bool label_all = decades < 2 || pixels > 200;                       // 1, 2, 5 within a decade as well
  const bool fine = pixels > 90;                                            // closer lines are a haze
  std::vector<Tick> ticks;
  for (int power = static_cast<int>(std::floor(low_)); power <= static_cast<int>(std::ceil(high_)); ++power) {
    for (int mantissa = 1; mantissa < (fine ? 10 : 2); ++mantissa) {
      const double log = power + std::log10(mantissa);
      if (log < low_ || log > high_ || (power % step != 0 && step > 2)) continue;
      const bool labeled = mantissa == 1 ? power % step == 0 : label_all && (mantissa == 2 || mantissa == 5);
      ticks.push_back({at_log(log), mantissa, power, labeled});
    }
  }
  return ticks;
}

std::string tick_text(const Tick& tick, const std::vector<Tick>& axis) {
  const bool plain = std::all_of(axis.begin(), axis.end(),
                                 [](const Tick& t) { return !t.labeled || (t.power >= -3 && t.power <= 4); });
  if (plain && tick.power < 0) return fmt::format("{:.{}f}", tick.mantissa * std::pow(10.0, tick.power), -tick.power);
  if (plain || (tick.power == 0 && tick.mantissa < 10))
    return fmt::format("{:.0f}", tick.mantissa * std::pow(10.0, tick.power));
  const std::string factor = tick.mantissa == 1 ? "" : fmt::format("{}·", tick.mantissa);
  return fmt::format("{}10<tspan dy=\"-5\" font-size=\"9\">{}{}</tspan>", factor, tick.power < 0 ? "−" : "",
                     std::abs(tick.power));
}

}  // namespace plumb::tool
