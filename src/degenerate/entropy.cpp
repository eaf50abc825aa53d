#include "plumb/degenerate/entropy.hpp"

#include <bit>

#include "arith/splitmix.hpp"

namespace plumb {

Entropy::Entropy(std::uint64_t start, std::uint64_t index) {
  // Two rounds, so that neighboring runs and neighboring cases share no states.
  std::uint64_t mixed = start;
  mixed = splitmix64(mixed) ^ index;
  mixed = splitmix64(mixed);
  for (std::uint64_t& word : state_) word = splitmix64(mixed);
}

Entropy Entropy::from_bytes(std::span<const std::uint8_t> bytes) {
  Entropy entropy;
  entropy.source_ = Source::bytes;
  entropy.bytes_ = bytes;
  return entropy;
}

Entropy Entropy::from_choices(std::span<const std::uint64_t> choices) {
  Entropy entropy;
  entropy.source_ = Source::choices;
  entropy.choices_ = choices;
  return entropy;
}

bool Entropy::exhausted() const {
  return source_ == Source::bytes ? bytes_.empty() : source_ == Source::choices && choices_.empty();
}

std::uint64_t Entropy::read(std::uint64_t largest) {
  if (source_ == Source::choices) {
    if (choices_.empty()) return 0;
    const std::uint64_t choice = choices_.front();
    choices_ = choices_.subspan(1);
    return choice <= largest ? choice : choice % (largest + 1);
  }
  std::uint64_t value = 0;
  for (int shift = 0; shift < static_cast<int>(std::bit_width(largest)) && !bytes_.empty(); shift += 8) {
    value |= static_cast<std::uint64_t>(bytes_.front()) << shift;
    bytes_ = bytes_.subspan(1);
  }
  return largest == ~0ull ? value : value % (largest + 1);
}

}  // namespace plumb
