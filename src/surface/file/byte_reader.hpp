// What numbers do these bytes hold, in either byte order?
//
// Laws: never reads past the end, and says at which byte the end came; float32 widens exactly.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {

/// "1 byte", "2 bytes"
inline std::string bytes_text(std::uint64_t n) { return std::to_string(n) + (n == 1 ? " byte" : " bytes"); }

class ByteReader {
 public:
  ByteReader(std::string_view bytes, std::string_view file, std::size_t at, std::endian order)
      : bytes_(bytes), file_(file), at_(at), swap_(order != std::endian::native) {}

  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }
  [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }

  /// What lies from there on is not looked at.
  void end_at(std::size_t end) { bytes_ = bytes_.substr(0, end); }

  /// Fails when fewer than count * size bytes are left.
  void require(std::uint64_t count, std::uint64_t size, const char* what) const {
    if (size != 0 && count > left() / size)
      fail(MeshFileProblem::truncated, std::string("expected ") + what + ", " + length_text(count, size) +
                                           ", but only " + bytes_text(left()) + (left() == 1 ? " is" : " are") +
                                           " left; the file is cut short: fetch or export it again");
  }

  void skip(std::uint64_t count, std::uint64_t size, const char* what) {
    require(count, size, what);
    at_ += static_cast<std::size_t>(count * size);
  }

  template <class T>
  T read(const char* what) {
    require(1, sizeof(T), what);
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(T));
    if (swap_)
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }

  [[noreturn]] void fail(MeshFileProblem problem, const std::string& text) const {
    fail_at_byte(problem, file_, at_, text);
  }

 private:
  /// "3 times 12 bytes", "118 bytes"
  static std::string length_text(std::uint64_t count, std::uint64_t size) {
    if (count == 1 || size == 1) return bytes_text(count == 1 ? size : count);
    return std::to_string(count) + " times " + bytes_text(size);
  }

  std::string_view bytes_, file_;
  std::size_t at_;
  bool swap_;
};

}  // namespace plumb::surface
