#include "tool/corpus/shard.hpp"

#include <fmt/format.h>

#include <charconv>

#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

std::uint64_t hash_of_text(std::string_view text) {
  std::uint64_t word = 0xcbf29ce484222325;
  for (const char c : text) word = (word ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
  word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
  return word ^ (word >> 31);
}

Shard Shard::parse(const std::string& text) {
  constexpr std::uint32_t most = 1'000'000;
  Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.number);
  const bool parted = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  if (parted) {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    if (second.ec == std::errc() && second.ptr == end && 1 <= shard.number && shard.number <= shard.count &&
        shard.count <= most)
      return shard;
  }
  throw Error(fmt::format(
      "--shard {}: it is no part of a corpus; write I/N with I from 1 to N, and N at most {}, as in '--shard 3/10'",
      printable(text), most));
}

}  // namespace plumb::tool
