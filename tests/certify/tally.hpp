// Who decided, and which signs were there?  Counts that show that the cases of a test were worth trying.
#pragma once

#include <array>
#include <cstdint>
#include <iomanip>
#include <ostream>

#include "certify/battery.hpp"

namespace plumb::battery {

struct Tally {
  StageCounts by;
  std::array<std::uint64_t, 3> sign{};

  void add(const Decision& d) {
    by.decided(d.stage);
    ++sign[place_of_sign(d.sign)];
  }
  [[nodiscard]] double decided(Stage s) const { return share_of(by.of(s)); }
  [[nodiscard]] double share(Sign s) const { return share_of(sign[place_of_sign(s)]); }

  friend std::ostream& operator<<(std::ostream& out, const Tally& t) {
    out << std::fixed << std::setprecision(3);
    for (const Stage s : stages) out << ' ' << to_string(s) << ' ' << 100 * t.decided(s) << '%';
    for (const Sign s : {Sign::negative, Sign::zero, Sign::positive}) {
      out << ' ' << to_char(s) << ' ' << 100 * t.share(s) << '%';
    }
    return out;
  }

 private:
  static std::size_t place_of_sign(Sign s) { return static_cast<std::size_t>(static_cast<int>(s) + 1); }
  [[nodiscard]] double share_of(std::uint64_t n) const {
    return static_cast<double>(n) / static_cast<double>(by.total());
  }
};

}  // namespace plumb::battery
