#include "plumb/space/bvh/packed_numbers.hpp"

#include <algorithm>

namespace plumb {

PackedNumbers::PackedNumbers(std::span<const std::uint32_t> numbers) : size_(numbers.size()) {
  if (numbers.empty()) return;
  std::uint32_t all = 0;
  for (const std::uint32_t n : numbers) all |= n;
  width_ = std::max(1u, static_cast<std::uint32_t>(std::bit_width(all) + 7) / 8);
  if constexpr (std::endian::native != std::endian::little) width_ = sizeof(std::uint32_t);
  std::vector<std::byte> bytes(bytes_of(numbers.size(), width_));
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(bytes.data() + i * width_, &numbers[i], width_);
  bytes_ = std::move(bytes);
}

}  // namespace plumb
