// Which side?  The answer type of every predicate, and the type of an answer that may be missing.
//
// Laws: -(-s) == s; a sign times a sign follows the rule of signs.  Unsure<T> converts to nothing: a stage that could
// not decide can be mistaken neither for zero nor for a sign.
#pragma once

#include <optional>

#include "plumb/predicates/standard.hpp"

namespace plumb {

enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign s, Sign t) { return static_cast<Sign>(static_cast<int>(s) * static_cast<int>(t)); }

/// Sign of a number whose comparisons with zero are exact (an integer, a rational, a double).
template <class T>
constexpr Sign sign_of_number(const T& x) {
  return static_cast<Sign>((x > 0) - (x < 0));
}

/// '+', '0' or '-': how case lines and reports write a sign.
constexpr char to_char(Sign s) { return s == Sign::positive ? '+' : s == Sign::negative ? '-' : '0'; }

/// An answer that a stage may be unable to give.
template <class T>
class Unsure {
 public:
  constexpr Unsure() = default;  // NOLINT: the undecided answer
  constexpr explicit Unsure(T answer) : answer_(answer) {}
  [[nodiscard]] constexpr bool certain() const { return answer_.has_value(); }
  /// The answer; only when certain().
  [[nodiscard]] constexpr T value() const { return *answer_; }
  friend constexpr bool operator==(const Unsure&, const Unsure&) = default;

 private:
  std::optional<T> answer_;
};

template <class T>
Unsure(T) -> Unsure<T>;

}  // namespace plumb
