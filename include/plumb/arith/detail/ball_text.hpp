// Sums and products of numbers that are known to some hundred bits: the text of plumb/arith/ball.hpp, for one double or
// for lanes of them.
//
// It stands in the struct of such numbers, which has high, low, radius and says: Self; Number, with + and -, and of
// magnitude `size`; Truth, from at_most, above and is_zero, of both and of either; chosen(truth, a, b); number(a double);
// two_sum and two_product.  PLUMB_BALL_INLINE is what stands before each function.
// Laws: those of plumb/arith/ball.hpp.
// Source: Dekker 1971.
// Cost: 20 operations a sum, 40 a product.
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
