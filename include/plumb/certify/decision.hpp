// What was decided, and who decided it?  A sign with the stage that proved it, and counts of stages.
//
// Law: the sign never depends on the stage; the stage depends on the coordinates alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "plumb/arith/sign.hpp"

namespace plumb {

/// In the order of the chain.
enum class Stage : std::uint8_t { filter, integer, structural_zero, long_double, wide_integer, interval, big_integer };

inline constexpr std::array<std::string_view, 7> stage_names{
    "filter", "integer", "structural-zero", "long-double", "wide-integer", "interval", "big-integer"};

constexpr std::string_view to_string(Stage s) { return stage_names[static_cast<std::size_t>(s)]; }

struct Decision {
  Sign sign;
  Stage stage;
  friend bool operator==(const Decision&, const Decision&) = default;
};

/// Recorder policy: is told every decision, and where it was taken.  This one does nothing and costs nothing.
struct NoRecorder {
  static constexpr void decided(Stage) {}
};

/// Recorder policy that counts stages; not synchronized: one for each thread, added up at the end.
struct StageCounts {
  std::array<std::uint64_t, stage_names.size()> count{};

  constexpr void decided(Stage s) { ++count[static_cast<std::size_t>(s)]; }
  [[nodiscard]] constexpr std::uint64_t of(Stage s) const { return count[static_cast<std::size_t>(s)]; }
  [[nodiscard]] constexpr std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t c : count) sum += c;
    return sum;
  }
  constexpr StageCounts& operator+=(const StageCounts& other) {
    for (std::size_t i = 0; i < count.size(); ++i) count[i] += other.count[i];
    return *this;
  }
};

}  // namespace plumb
