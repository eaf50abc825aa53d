// Sums and products of two doubles a number, with the size of the terms: the text of arith/twofold.hpp, for one
// double or for lanes of them.
//
// It stands in the struct of such numbers, which has high, low, magnitude, of type Number, with + - *, and error,
// width, of type double, and says: Self; number(a double); size; plus_product(c, a, b), fused or not; two_sum and
// product, what they give and what they lost; Truth, from equal.  PLUMB_TWOFOLD_INLINE is what stands before each
// function.
// Laws: those of arith/twofold.hpp.
// Source: docs/proof.md, "Twofold".
// Cost: 10 operations a sum, 7 or 22 a product; those on magnitudes nobody asks for are not compiled.
#ifdef PLUMB_TWOFOLD_INLINE  // alone it is nothing

static constexpr double slack = 0x1p-10, guard = 0x1p-960, unit = 0x1p-53;
static constexpr double larger(double a, double b) { return a > b ? a : b; }

/// a - b of two coordinates as given: exact.
static PLUMB_TWOFOLD_INLINE Self difference(const Number& a, const Number& b) {
  const auto d = two_sum(a, negated(b));
  return {d.value, d.error, size(d.value), 0, 1};
}

friend PLUMB_TWOFOLD_INLINE Self operator+(const Self& a, const Self& b) {
  const auto s = two_sum(a.high, b.high);
  const double w = larger(a.width, b.width);
  return {s.value, s.error + (a.low + b.low), a.magnitude + b.magnitude, larger(a.error, b.error) + (2 * w + 1 + slack),
          w + (1 + slack)};
}
/// Of a number as given, which has no low part to add.
friend PLUMB_TWOFOLD_INLINE Self operator+(const Number& a, const Self& b) {
  const auto s = two_sum(a, b.high);
  return {s.value, s.error + b.low, size(a) + b.magnitude, b.error + (2 * b.width + 1 + slack), b.width + (1 + slack)};
}
PLUMB_TWOFOLD_INLINE Self operator-() const { return {negated(high), negated(low), magnitude, error, width}; }
friend PLUMB_TWOFOLD_INLINE Self operator-(const Self& a, const Self& b) { return a + -b; }
friend PLUMB_TWOFOLD_INLINE Self operator*(const Self& a, const Self& b) {
  const auto p = product(a.high, b.high);
  const double w = a.width + b.width;
  return {p.value, plus_product(plus_product(p.error, a.low, b.high), a.high, b.low),
          plus_product(number(guard), a.magnitude, b.magnitude),
          a.error + b.error + a.width * b.width + 4 * w + (1 + slack), w + (1 + slack)};
}
friend PLUMB_TWOFOLD_INLINE Self operator*(const Self& a, const Number& b) {
  const auto p = product(a.high, b);
  return {p.value, plus_product(p.error, a.low, b), plus_product(number(guard), a.magnitude, size(b)),
          a.error + 4 * a.width + (1 + slack), a.width + (1 + slack)};
}

/// The square of what is much smaller than its terms: the error grows with the value, not with the terms' squares.
[[nodiscard]] PLUMB_TWOFOLD_INLINE Self squared() const {
  const auto x = two_sum(high, low);
  const auto p = product(x.value, x.value);
  const Number most = plus_product(size(x.value), magnitude, number((width + 2) * unit));
  return {p.value, plus_product(p.error, x.value + x.value, x.error), plus_product(number(guard), magnitude, most),
          (2 * error + 7) * (1 + 8 * slack), 3 + slack};
}

/// The same where more is known of the terms' size: m is at least the magnitude, but for parts of 2^-11.
[[nodiscard]] PLUMB_TWOFOLD_INLINE Self below(const Number& m) const {
  return {high, low, m, error * (1 + slack), width * (1 + slack)};
}

/// The bound of the error as a number; infinite or NaN where nothing is known.
[[nodiscard]] PLUMB_TWOFOLD_INLINE Number reach() const { return number(error * (1 + slack) * 0x1p-106) * magnitude; }

/// The double nearest to the exact value, where all that is within the bound rounds to one (Ziv's test).  The width and
/// one more pay for rounding low -+ reach, and subnormal bounds.
[[nodiscard]] PLUMB_TWOFOLD_INLINE Truth told(Number& to) const {
  const Number most = number((error + width + 1) * (1 + 2 * slack) * 0x1p-106) * magnitude;
  to = high + (low - most);
  return equal(to, high + (low + most));
}

#endif
