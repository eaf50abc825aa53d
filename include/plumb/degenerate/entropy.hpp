// Which choice comes next?  One stream of choices, from which every generator of hard inputs makes its case.
//
// The stream is a numbered pseudo-random case, the bytes of a fuzzer, or a list of choices to replay or shrink.
// Laws: (1) the same source gives the same choices on every compiler and machine (no std:: distributions);
// (2) replaying the recorded choices of a case makes the same case; (3) a smaller choice means a simpler case, and an
// exhausted stream answers 0, so cutting the stream short also makes a simple case.
// Source: Blackman and Vigna, "Scrambled linear pseudorandom number generators" (xoshiro256**, filled by splitmix64);
// shrinking on choices instead of values is Hypothesis' idea.
// Cost: about 1 ns a choice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

class Entropy {
 public:
  /// Pseudo-random choices: case number `index` of the run that `start` names.
  explicit Entropy(std::uint64_t start, std::uint64_t index = 0);

  /// Choices read from a fuzzer's bytes, each from as few bytes as it needs; the bytes must outlive the stream.
  static Entropy from_bytes(std::span<const std::uint8_t> bytes);

  /// Choices as recorded; one too large for its question is reduced modulo its range.  They must outlive the stream.
  static Entropy from_choices(std::span<const std::uint64_t> choices);

  /// Appends every choice from here on to `choices` (nullptr: stop).
  void record_into(std::vector<std::uint64_t>* choices) { record_ = choices; }

  /// An integer in [0, n), for n >= 1; n == 1 is no choice and reads nothing.  Bias below n / 2^64.
  std::uint64_t below(std::uint64_t n) {
    if (n <= 1) return 0;
    return made(source_ == Source::generator ? high_product(generate(), n) : read(n - 1));
  }

  /// An integer of `count` bits, for count in [0, 64].
  std::uint64_t bits(int count) {
    if (count <= 0) return 0;
    return made(source_ == Source::generator ? generate() >> (64 - count) : read(~0ull >> (64 - count)));
  }

  bool coin() { return bits(1) != 0; }

  /// An integer in [-most, most], for most in [0, 2^62]; choices 0, 1, 2, 3, 4 mean 0, 1, -1, 2, -2.
  std::int64_t within(std::int64_t most) {
    const std::uint64_t choice = below(2 * static_cast<std::uint64_t>(most) + 1);
    const auto magnitude = static_cast<std::int64_t>((choice + 1) / 2);
    return choice % 2 == 0 ? -magnitude : magnitude;
  }

  /// Whether a list of bytes or choices has been read to its end; a generator has none.
  [[nodiscard]] bool exhausted() const;

 private:
  enum class Source : unsigned char { generator, bytes, choices };
  Entropy() = default;

  static std::uint64_t high_product(std::uint64_t a, std::uint64_t b) {
    __extension__ using Wide = unsigned __int128;
    return static_cast<std::uint64_t>((static_cast<Wide>(a) * b) >> 64);
  }
  std::uint64_t made(std::uint64_t choice) {
    if (record_ != nullptr) record_->push_back(choice);
    return choice;
  }
  std::uint64_t generate() {
    const auto turned = [](std::uint64_t x, int by) { return (x << by) | (x >> (64 - by)); };
    const std::uint64_t result = turned(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = turned(state_[3], 45);
    return result;
  }
  std::uint64_t read(std::uint64_t largest);

  Source source_ = Source::generator;
  std::array<std::uint64_t, 4> state_{};
  std::span<const std::uint8_t> bytes_;
  std::span<const std::uint64_t> choices_;
  std::vector<std::uint64_t>* record_ = nullptr;
};

}  // namespace plumb
