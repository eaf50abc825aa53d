// Sums and products of numbers that are known to some hundred bits: the text of plumb/arith/ball.hpp, for one double or
// for lanes of them.
//
// It stands in the struct of such numbers, which has high, low, radius and says: Self; Number, with + and -, and of
// magnitude `size`; Truth, from at_most, above and is_zero, of both and of either; chosen(truth, a, b); number(a double);
// two_sum and two_product.  PLUMB_BALL_INLINE is what stands before each function.
// Laws: those of plumb/arith/ball.hpp.
// Source: Dekker 1971.
// Cost: 20 operations a sum, 40 a product, 30 a square.
#ifdef PLUMB_BALL_INLINE  // alone it is nothing

// A sum of what is not negative, after a few roundings: rounded up.
static PLUMB_BALL_INLINE Number widened(const Number& r) { return r * number(1 + 0x1p-48); }

// Where the transforms do not hold, nothing is claimed.
static PLUMB_BALL_INLINE Self known(const Truth& holds, const Number& otherwise, const Number& h, const Number& l,
                                    const Number& r) {
  return {chosen(holds, h, otherwise), chosen(holds, l, number(0)), chosen(holds, r, number(infinity))};
}

friend PLUMB_BALL_INLINE Self operator+(const Self& a, const Self& b) {
  const auto s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
  const auto c = two_sum(s.error, t.value);
  const auto v = two_sum(s.value, c.value);
  const auto w = two_sum(t.error, v.error);
  const auto r = two_sum(v.value, w.value);
  return known(at_most(size(s.value), number(0x1p1022)), s.value, r.value, r.error,
               widened(a.radius + b.radius + size(c.error) + size(w.error)));
}
friend PLUMB_BALL_INLINE Self operator-(const Self& a, const Self& b) {
  return a + Self{negated(b.high), negated(b.low), b.radius};
}

/// x - b, of a number as given: less work, for it has no low part.
friend PLUMB_BALL_INLINE Self difference(const Number& x, const Self& b) {
  const auto s = two_sum(x, negated(b.high)), c = two_sum(s.error, negated(b.low)), v = two_sum(s.value, c.value);
  return known(at_most(size(s.value), number(0x1p1022)), s.value, v.value, v.error, widened(b.radius + size(c.error)));
}

/// a * a: less work, for both of the mixed products are one.
friend PLUMB_BALL_INLINE Self squared(const Self& a) {
  const auto p = two_product(a.high, a.high);
  const Number size_a = size(a.high);
  const Truth handy = both(above(p.value, number(0x1p-960)), above(number(0x1p960), p.value));
  const Number q = a.high * a.low, t = q + q;
  const auto s = two_sum(p.error, t), v = two_sum(p.value, s.value);
  const Truth exact = both(is_zero(a.low), is_zero(a.radius));
  const Number rounded = size(t) * number(0x1p-53) + a.low * a.low + size(s.error);
  const Number inherited = (size_a + size(a.low)) * (a.radius + a.radius) + a.radius * a.radius;
  return known(either(is_zero(a.high), handy), p.value, v.value, v.error,
               chosen(exact, number(0), widened(rounded + inherited) + number(0x1p-1060)));
}

friend PLUMB_BALL_INLINE Self operator*(const Self& a, const Self& b) {
  const auto p = two_product(a.high, b.high);
  const Number most = number(0x1p960), size_a = size(a.high), size_b = size(b.high), size_p = size(p.value);
  const Truth handy = both(above(size_p, number(0x1p-960)), above(most, size_p));
  const Truth holds =
      both(both(above(most, size_a), above(most, size_b)), either(either(is_zero(a.high), is_zero(b.high)), handy));
  const Number q = a.high * b.low, r = a.low * b.high;
  const auto t = two_sum(q, r);
  const auto s = two_sum(p.error, t.value);
  const auto v = two_sum(p.value, s.value);
  const Truth exact = both(both(is_zero(a.low), is_zero(b.low)), both(is_zero(a.radius), is_zero(b.radius)));
  const Number rounded = (size(q) + size(r)) * number(0x1p-53) + size(a.low * b.low) + size(t.error) + size(s.error);
  const Number inherited = (size_a + size(a.low)) * b.radius + (size_b + size(b.low)) * a.radius + a.radius * b.radius;
  return known(holds, p.value, v.value, v.error,
               chosen(exact, number(0), widened(rounded + inherited) + number(0x1p-1060)));
}

#endif
