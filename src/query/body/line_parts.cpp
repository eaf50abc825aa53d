#include "query/body/line_parts.hpp"

#include <bit>

#include "certify/case_line.hpp"

namespace plumb::query {

std::string LineParts::written(std::span<const std::uint64_t> kept) {
  std::string line;
  while (!kept.empty()) {
    const auto kind = static_cast<Kind>(kept[0] & 3);
    const std::uint64_t count = kept[0] >> 2;
    kept = kept.subspan(1);
    if (kind == Kind::count) {
      line.append(" ").append(std::to_string(count));
      continue;
    }
    const bool are_numbers = kind == Kind::numbers;
    const std::uint64_t whole = are_numbers ? count : (count + 7) / 8;
    if (whole > kept.size()) return line;
    if (are_numbers) {
      for (const std::uint64_t x : kept.first(whole)) {
        line += ' ';
        append_hexadecimal(line, std::bit_cast<double>(x));
      }
    } else {
      if (kind == Kind::word) line += ' ';
      const std::size_t at = line.size();
      line.resize(at + count);
      if (count != 0) std::memcpy(line.data() + at, kept.data(), count);
    }
    kept = kept.subspan(whole);
  }
  return line;
}

}  // namespace plumb::query
