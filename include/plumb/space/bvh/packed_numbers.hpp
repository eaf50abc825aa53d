// How few bytes do whole numbers below a limit need?  An array of them, so many bytes each.
//
//   const PackedNumbers corners(std::array{0u, 1u, 70000u});   // three bytes each
//   corners[2]
//
// Laws: (1) numbers[i] is the i-th number given.  (2) Each takes the bytes that the largest needs, 1 to 4; four of each
//       on machines whose high bytes come first.  (3) PackedView reads an array of 32-bit numbers alike.
// Source: RTCD 13.3.2.
// Cost: a load of four bytes and a mask; three bytes behind the last are there to be loaded.  Nothing is searched.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "plumb/space/bvh/kept_array.hpp"

namespace plumb {

struct PackedView {
  const std::byte* bytes = nullptr;
  std::uint32_t width = 1;  // bytes of each

  PackedView() = default;
  PackedView(const std::byte* b, std::uint32_t w) : bytes(b), width(w) {}
  explicit PackedView(std::span<const std::uint32_t> words)
      : bytes(reinterpret_cast<const std::byte*>(words.data())), width(sizeof(std::uint32_t)) {}

  [[nodiscard]] std::uint32_t operator[](std::size_t i) const {
    std::uint32_t word;
    __builtin_memcpy(&word, bytes + i * width, sizeof word);
    return word & (0xffffffffu >> (32 - 8 * width));
  }
};

class PackedNumbers {
 public:
  PackedNumbers() = default;
  explicit PackedNumbers(std::span<const std::uint32_t> numbers);
  /// As they lie in memory: bytes_of(size, width) bytes.
  PackedNumbers(KeptArray<std::byte> bytes, std::size_t size, std::uint32_t width)
      : bytes_(std::move(bytes)), size_(size), width_(width) {}
  /// Those behind the last number among them.
  static constexpr std::uint64_t bytes_of(std::uint64_t size, std::uint32_t width) {
    return size == 0 ? 0 : size * width + sizeof(std::uint32_t) - width;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t width() const { return width_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_.size(); }
  [[nodiscard]] std::span<const std::byte> memory() const { return bytes_.view(); }
  /// Copies what was mapped.
  void own() { (void)bytes_.writable(); }
  [[nodiscard]] PackedView view() const { return {bytes_.data(), width_}; }
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const { return view()[i]; }

 private:
  KeptArray<std::byte> bytes_;
  std::size_t size_ = 0;
  std::uint32_t width_ = 1;
};

}  // namespace plumb
