// How did a method do?  Counts of right and wrong answers, its time, and its worst case.
//
// Laws: the exact method is the judge; wrong = opposite + zeros_missed + zeros_invented; unsure is not wrong.
// Merging is commutative but for equal worst cases, where the decision of smaller number wins: the thread count changes
// no count and no case.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/certify/decision.hpp"
#include "tool/check/command.hpp"
#include "tool/mesh/decisions.hpp"

namespace plumb::tool {

/// A wrong sign: how far the claimed value is from the exact one, in units of the formula's magnitude.
struct WorstCase {
  double badness = -1;  // negative: none
  std::uint64_t number = 0;
  Kind kind{};
  double claimed = 0;
  std::string case_line;  // with the exact sign

  /// Is (badness, number) worse than this case?
  [[nodiscard]] bool yields_to(double other_badness, Kind other_kind, std::uint64_t other_number) const {
    if (other_badness != badness) return other_badness > badness;
    return other_kind != kind ? other_kind < kind : other_number < number;
  }
};

struct Tally {
  std::uint64_t taken = 0, opposite = 0, zeros_missed = 0, zeros_invented = 0, unsure = 0;
  double nanoseconds = 0;  // all decisions together, at the median speed of their blocks
  WorstCase worst;

  [[nodiscard]] std::uint64_t wrong() const { return opposite + zeros_missed + zeros_invented; }
  [[nodiscard]] double wrong_share() const {
    return taken == 0 ? 0 : static_cast<double>(wrong()) / static_cast<double>(taken);
  }
  [[nodiscard]] double ns_per_decision() const { return taken == 0 ? 0 : nanoseconds / static_cast<double>(taken); }

  Tally& operator+=(const Tally& other) {
    taken += other.taken;
    opposite += other.opposite;
    zeros_missed += other.zeros_missed;
    zeros_invented += other.zeros_invented;
    unsure += other.unsure;
    nanoseconds += other.nanoseconds;
    if (worst.yields_to(other.worst.badness, other.worst.kind, other.worst.number)) worst = other.worst;
    return *this;
  }
};

/// The exact methods on all decisions of a set, the others on these or a sample; the exact method's stages; how many
/// exact signs were taken again in rationals.
struct Comparison {
  std::array<Tally, method_count> method;
  StageCounts stages;
  double judge_nanoseconds = 0;  // what the exact method took for what the inexact ones were asked
  std::uint64_t verified = 0, refuted = 0;

  [[nodiscard]] std::uint64_t taken() const { return method[exact_method].taken; }
  /// Of how many of them the inexact methods were asked.
  [[nodiscard]] std::uint64_t sampled() const { return method[method_number("double")].taken; }

  Comparison& operator+=(const Comparison& other) {
    for (std::size_t m = 0; m < method_count; ++m) method[m] += other.method[m];
    stages += other.stages;
    judge_nanoseconds += other.judge_nanoseconds;
    verified += other.verified;
    refuted += other.refuted;
    return *this;
  }
};

}  // namespace plumb::tool
