// The last stage: replays a formula's tape over integers of as many limbs as their values have, with exponents.
//
// Nothing is allocated while the limbs of all steps fit the workspace on the stack.  GMP's low-level functions do the
// arithmetic.  A value is held without zero limbs at either end, so coordinates of very different size cost what lies
// between the ends of a value, not what their exponents span.
#include <gmp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include "certify/nearest_value.hpp"
#include "plumb/certify/detail/exact_stages.hpp"

namespace plumb {
namespace {

constexpr int limb_bits = GMP_NUMB_BITS;
static_assert(limb_bits == 64);

/// (negative ? -1 : 1) * limb[0 ... size) * 2^exponent; size 0 is zero.  No limb at either end is zero.
struct Number {
  const mp_limb_t* limb = nullptr;
  mp_size_t size = 0;
  long exponent = 0;
  bool negative = false;
};

/// Memory for one evaluation: from the stack, then from the heap.
class Workspace {
 public:
  Workspace() : next_(stack_), end_(stack_ + std::size(stack_)) {}
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  /// Room for n limbs, of which the caller returns what it does not use.
  mp_limb_t* take(mp_size_t n) {
    if (end_ - next_ < n) {
      const auto size = static_cast<std::size_t>(std::max<mp_size_t>(n, 1 << 16));
      next_ = heap_.emplace_back(new mp_limb_t[size]).get();
      end_ = next_ + size;
    }
    return std::exchange(next_, next_ + n);
  }
  void give_back(const mp_limb_t* from) { next_ -= next_ - from; }

 private:
  mp_limb_t stack_[1536];  // NOLINT: left uninitialized
  mp_limb_t *next_, *end_;
  std::vector<std::unique_ptr<mp_limb_t[]>> heap_;  // NOLINT
};

class Evaluation {
 public:
  /// x, at an exponent that differs from `base` by whole limbs, so that sums of equal degree need no shift.
  Number number(const OddForm& x, int base) {
    if (x.mantissa == 0) return {};
    const int above = x.exponent - base, bit = above & (limb_bits - 1);
    mp_limb_t* limb = work_.take(2);
    const UInt128 m = UInt128{static_cast<std::uint64_t>(std::abs(x.mantissa))} << bit;
    limb[0] = static_cast<mp_limb_t>(m);
    limb[1] = static_cast<mp_limb_t>(m >> limb_bits);
    return trimmed(limb, 2, base + above - bit, x.mantissa < 0);
  }

  Number product(const Number& a, const Number& b) {
    if (a.size == 0 || b.size == 0) return {};
    const mp_size_t size = a.size + b.size;
    mp_limb_t* limb = work_.take(size);
    if (size == 2) {
      const UInt128 m = UInt128{a.limb[0]} * b.limb[0];
      limb[0] = static_cast<mp_limb_t>(m);
      limb[1] = static_cast<mp_limb_t>(m >> limb_bits);
    } else if (a.limb == b.limb) {
      mpn_sqr(limb, a.limb, a.size);
    } else if (a.size >= b.size) {
      mpn_mul(limb, a.limb, a.size, b.limb, b.size);
    } else {
      mpn_mul(limb, b.limb, b.size, a.limb, a.size);
    }
    return trimmed(limb, size, a.exponent + b.exponent, a.negative != b.negative);
  }

  Number sum(Number a, Number b, bool subtract) {
    b.negative = b.negative != subtract;
    if (a.size == 0) return b;
    if (b.size == 0) return a;
    if (a.exponent > b.exponent) std::swap(a, b);
    align(a, b);
    const mp_size_t offset = (b.exponent - a.exponent) / limb_bits;
    const mp_size_t size = std::max(a.size, offset + b.size) + 1;
    mp_limb_t* limb = work_.take(size);
    std::copy_n(a.limb, a.size, limb);
    std::fill(limb + a.size, limb + size, mp_limb_t{0});
    bool negative = a.negative;
    if (a.negative == b.negative) {
      mpn_add(limb + offset, limb + offset, size - offset, b.limb, b.size);
    } else if (mpn_sub(limb + offset, limb + offset, size - offset, b.limb, b.size) != 0) {
      mpn_neg(limb, limb, size);
      negative = b.negative;
    }
    return trimmed(limb, size, a.exponent, negative);
  }

 private:
  // Makes the exponents differ by whole limbs: b, of the larger exponent, is shifted.
  void align(const Number& a, Number& b) {
    const auto bit = static_cast<unsigned>((b.exponent - a.exponent) % limb_bits);
    if (bit == 0) return;
    mp_limb_t* limb = work_.take(b.size + 1);
    limb[b.size] = mpn_lshift(limb, b.limb, b.size, bit);
    b = trimmed(limb, b.size + 1, b.exponent - static_cast<long>(bit), b.negative);
  }

  Number trimmed(const mp_limb_t* limb, mp_size_t size, long exponent, bool negative) {
    while (size > 0 && limb[size - 1] == 0) --size;
    work_.give_back(limb + size);
    if (size == 0) return {};
    for (; *limb == 0; ++limb, --size) exponent += limb_bits;
    return {limb, size, exponent, negative};
  }

  Workspace work_;
};

/// Runs the tape and returns what `finish` makes of its value, which lives no longer.
template <class Finish>
auto replay(certify::tape::Program program, std::span<const double> coordinates, Finish finish) {
  Evaluation evaluation;
  const std::size_t count = coordinates.size() + program.instructions.size();
  std::array<Number, 128> few;
  std::vector<Number> many(count > few.size() ? count : 0);
  Number* const number = many.empty() ? few.data() : many.data();

  int base = 1 << 16;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const OddForm form = odd_form(coordinates[i]);
    if (form.mantissa != 0) base = std::min(base, form.exponent);
  }
  Number* next = number;
  for (const double x : coordinates) *next++ = evaluation.number(odd_form(x), base);
  for (const certify::tape::Instruction& i : program.instructions) {
    const Number &l = number[i.left], &r = number[i.right];
    *next++ = i.operation == '*' ? evaluation.product(l, r) : evaluation.sum(l, r, i.operation == '-');
  }
  return finish(next[-1]);
}

/// x rounded once, to nearest and even, but never to zero.
double nearest(const Number& x) {
  if (x.size == 0) return 0;
  const mp_limb_t top = x.limb[x.size - 1];
  const int zeros = std::countl_zero(top);
  mp_limb_t head = top << zeros, rest = 0;  // the first 64 bits, and whether there are more
  if (x.size > 1) {
    const mp_limb_t below = x.limb[x.size - 2];
    if (zeros > 0) head |= below >> (limb_bits - zeros);
    rest = (below << zeros) | static_cast<mp_limb_t>(x.size > 2);  // the last limb is not zero
  }
  const long end = x.exponent + x.size * limb_bits - zeros;  // 2^(end - 1) <= |x| < 2^end
  const long kept = std::min(53L, end + 1074);               // bits that a double has there
  double magnitude = std::numeric_limits<double>::denorm_min();
  if (kept > 0) {
    const auto dropped = static_cast<int>(limb_bits - kept);
    const mp_limb_t whole = head >> dropped, half = mp_limb_t{1} << (dropped - 1);
    const mp_limb_t fraction = head & (2 * half - 1);
    const bool up = fraction > half || (fraction == half && (rest != 0 || (whole & 1) != 0));
    const auto exponent = static_cast<int>(std::min(end - kept, 4096L));
    magnitude = std::ldexp(static_cast<double>(whole + (up ? 1 : 0)), exponent);
  }
  return x.negative ? -magnitude : magnitude;
}

}  // namespace

Sign big_integer_sign(certify::tape::Program program, std::span<const double> coordinates) {
  return replay(program, coordinates, [](const Number& x) {
    return static_cast<Sign>(x.size == 0 ? 0 : x.negative ? -1 : 1);
  });
}

double nearest_value(certify::tape::Program program, std::span<const double> coordinates) {
  return replay(program, coordinates, nearest);
}

}  // namespace plumb
