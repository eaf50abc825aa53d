// Which models of a corpus are this run's?  One of N parts of them, which no run has to tell another.
//
// Laws: (1) the part of a model depends on its path below the corpus alone, and on N: not on what else lies there, on
// the machine or on the order of names in a folder, so that models that come or go move no other.  (2) Every model is in
// exactly one part.
// Source: FNV-1a, and the finalizer of splitmix64 (Steele, Lea and Flood 2014).
// Cost: the length of the path.  Nothing is searched.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumb::tool {

/// The same number on every machine.
std::uint64_t hash_of_text(std::string_view text);

struct Shard {
  std::uint32_t number = 1, count = 1;  // from 1 to count

  /// "3/10"; throws Error.
  static Shard parse(const std::string& text);
  [[nodiscard]] bool holds(std::string_view path) const { return hash_of_text(path) % count == number - 1; }
  [[nodiscard]] std::string text() const { return std::to_string(number) + "/" + std::to_string(count); }
};

}  // namespace plumb::tool
