#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdlib>
#include <utility>

#include "plumb/degenerate/shrink.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace plumb {

namespace {

using CoordinateList = std::vector<double>;

// How simple a list of coordinates is: smaller is simpler.  Every accepted step lowers it, so shrinking ends.
struct Measure {
  std::uint64_t weight = 0;                // mantissa bits and exponents; a repeated value weighs next to nothing
  std::vector<std::uint64_t> tie_breaker;  // magnitudes, positive before negative
  friend auto operator<=>(const Measure&, const Measure&) = default;
};

std::uint64_t weight_of(double x) {
  return x == 0 ? 0 : static_cast<std::uint64_t>(mantissa_length(x) + std::abs(highest_exponent(x)));
}

Measure measure(std::span<const double> coordinates) {
  Measure made;
  for (auto x = coordinates.begin(); x != coordinates.end(); ++x) {
    const bool repeated = std::find(coordinates.begin(), x, *x) != x;
    made.weight += repeated ? std::min<std::uint64_t>(weight_of(*x), 1) : weight_of(*x);
    made.tie_breaker.push_back(std::bit_cast<std::uint64_t>(std::fabs(*x)) << 1 | (std::signbit(*x) ? 1 : 0));
  }
  return made;
}

// The mantissa cut to `length` bits, towards zero.
double truncated(double x, int length) {
  const int surplus = mantissa_length(x) - length;
  if (surplus <= 0) return x;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int unused = lowest_exponent(x) - std::max(highest_exponent(x) - 52, -1074);
  return std::bit_cast<double>(bits & (~0ull << (surplus + unused)));
}

// Simpler values for one number, the simplest first.
std::vector<double> simpler(double x) {
  std::vector<double> made = {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, std::fabs(x)};
  if (std::fabs(x) < 0x1p62) made.push_back(std::trunc(x));
  const int exponent = x == 0 ? 0 : highest_exponent(x);
  for (int by = exponent; by != 0; by /= 2) made.push_back(std::ldexp(x, -by));
  const int length = mantissa_length(x);
  for (int keep = 1; keep < length; keep = 2 * keep < length || keep == length - 1 ? 2 * keep : length - 1) {
    const double low = truncated(x, keep);
    made.push_back(low);
    const double high = low + std::ldexp(x > 0 ? 1.0 : -1.0, exponent - keep + 1);
    if (std::isfinite(high)) made.push_back(high);
  }
  return made;
}

class Shrinker {
 public:
  Shrinker(CoordinateList coordinates, const FailsOnCoordinates& still_fails, std::size_t most_calls)
      : current_(std::move(coordinates)),
        best_(measure(current_)),
        still_fails_(still_fails),
        calls_left_(most_calls) {}

  const CoordinateList& current() const { return current_; }
  bool out_of_calls() const { return calls_left_ == 0; }

  bool attempt(const CoordinateList& candidate) {
    Measure of_candidate = measure(candidate);
    if (calls_left_ == 0 || !(of_candidate < best_)) return false;
    --calls_left_;
    if (!still_fails_(candidate)) return false;
    current_ = candidate;
    best_ = std::move(of_candidate);
    return true;
  }

  // The coordinates first, first + stride, ... replaced by what `change` makes of them.
  template <class Change>
  bool attempt_slice(std::size_t first, std::size_t stride, const Change& change) {
    CoordinateList candidate = current_;
    for (std::size_t i = first; i < candidate.size(); i += stride) {
      candidate[i] = change(candidate[i]);
      if (!std::isfinite(candidate[i])) return false;
    }
    return attempt(candidate);
  }

 private:
  CoordinateList current_;
  Measure best_;
  const FailsOnCoordinates& still_fails_;
  std::size_t calls_left_;
};

// Steps that keep what the points are to one another: projection, translation, scaling, reflection.
bool shrink_together(Shrinker& shrinker, std::size_t first, std::size_t stride) {
  bool improved = false;
  const auto each = [&](const auto& change) { improved |= shrinker.attempt_slice(first, stride, change); };
  each([](double) { return 0.0; });
  for (std::size_t i = first; i < shrinker.current().size(); i += stride) {
    const double origin = shrinker.current()[i];
    each([&](double x) { return x - origin; });
  }
  int lowest = 1024, highest = -1075;
  for (std::size_t i = first; i < shrinker.current().size(); i += stride) {
    lowest = std::min(lowest, lowest_exponent(shrinker.current()[i]));
    highest = std::max(highest, highest_exponent(shrinker.current()[i]));
  }
  if (lowest > highest) return improved;
  for (const int exponent : {lowest, highest, (lowest + highest) / 2}) {
    for (int by = exponent; by != 0; by /= 2) each([&](double x) { return std::ldexp(x, -by); });
  }
  each([](double x) { return -x; });
  each([](double x) { return std::fabs(x); });
  each([](double x) { return std::trunc(x); });
  for (const int keep : {1, 2, 4, 8, 16, 24, 32, 44}) each([&](double x) { return truncated(x, keep); });
  return improved;
}

bool shrink_one(Shrinker& shrinker, std::size_t index) {
  bool improved = false;
  const auto with = [&](double x) {
    CoordinateList candidate = shrinker.current();
    const double old = std::exchange(candidate[index], x);
    improved |= shrinker.attempt(candidate);
    // All equals at once, for failures that need them equal.
    for (double& y : candidate) y = y == old ? x : y;
    improved |= shrinker.attempt(candidate);
  };
  for (const double x : simpler(shrinker.current()[index])) with(x);
  const CoordinateList others = shrinker.current();
  for (const double x : others) with(x);
  return improved;
}

// One point becomes another.
bool merge_points(Shrinker& shrinker, std::size_t stride) {
  bool improved = false;
  const auto count = static_cast<std::ptrdiff_t>(shrinker.current().size() / stride);
  const auto step = static_cast<std::ptrdiff_t>(stride);
  for (std::ptrdiff_t to = 0; to < count; ++to) {
    for (std::ptrdiff_t from = 0; from < count; ++from) {
      if (from == to) continue;
      CoordinateList candidate = shrinker.current();
      std::copy_n(candidate.begin() + from * step, step, candidate.begin() + to * step);
      improved |= shrinker.attempt(candidate);
    }
  }
  return improved;
}

}  // namespace

bool is_simpler(std::span<const double> a, std::span<const double> b) { return measure(a) < measure(b); }

std::vector<double> shrink_coordinates(std::vector<double> coordinates, int dimension,
                                       const FailsOnCoordinates& still_fails, std::size_t most_calls) {
  Shrinker shrinker(std::move(coordinates), still_fails, most_calls);
  const auto stride = static_cast<std::size_t>(dimension);
  for (bool improved = true; improved && !shrinker.out_of_calls();) {
    improved = stride > 1 && merge_points(shrinker, stride);
    improved |= shrink_together(shrinker, 0, 1);
    for (std::size_t axis = 0; stride > 1 && axis < stride; ++axis) {
      improved |= shrink_together(shrinker, axis, stride);
    }
    for (std::size_t i = 0; i < shrinker.current().size(); ++i) improved |= shrink_one(shrinker, i);
  }
  return shrinker.current();
}

}  // namespace plumb
