// A line of text that is not written out yet: words as they are, and numbers as doubles, whose digits are made when the line is
// read.
//
// Laws: the text is the same whenever it is made; numbers are hexadecimal, each behind a blank.
// Source: none.
// Cost: to keep a line that of copying its numbers, to write it out a hundred times that.  Nothing is searched.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::query {

class LineParts {
 public:
  LineParts() { all_.reserve(96); }

  /// Takes it as it stands.
  void text(std::string_view t) { take(Kind::text, t.data(), t.size(), t.size()); }
  /// Behind a blank.
  void word(std::string_view t) { take(Kind::word, t.data(), t.size(), t.size()); }
  /// A whole number, behind a blank.
  void count(std::uint64_t n) { all_.push_back(n << 2 | static_cast<std::uint64_t>(Kind::count)); }
  void number(double x) { take(Kind::numbers, &x, 1, sizeof x); }
  void numbers(std::span<const double> x) { take(Kind::numbers, x.data(), x.size(), x.size_bytes()); }
  /// A shape that is nothing but doubles.
  template <class Shape>
  void numbers_of(const Shape& s) {
    static_assert(std::is_trivially_copyable_v<Shape> && sizeof(Shape) % sizeof(double) == 0);
    take(Kind::numbers, &s, sizeof(Shape) / sizeof(double), sizeof(Shape));
  }

  [[nodiscard]] std::span<const std::uint64_t> kept() const { return all_; }
  /// The text of what was kept; of what is none as much as can be read.
  [[nodiscard]] static std::string written(std::span<const std::uint64_t> kept);

 private:
  enum class Kind : std::uint64_t { numbers, text, word, count };

  /// How many there are and of what kind, and then their bytes, filled up to a whole number of eight.
  void take(Kind kind, const void* from, std::size_t count, std::size_t bytes) {
    const std::size_t at = all_.size();
    all_.resize(at + 1 + (bytes + 7) / 8);
    all_[at] = static_cast<std::uint64_t>(count) << 2 | static_cast<std::uint64_t>(kind);
    if (bytes != 0) std::memcpy(all_.data() + at + 1, from, bytes);
  }

  std::vector<std::uint64_t> all_;
};

}  // namespace plumb::query
