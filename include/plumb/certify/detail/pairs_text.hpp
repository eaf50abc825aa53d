// Twice as many digits: a number is the sum of two doubles, or of two of each lane, without a bound of its own.
//
// One text for several kinds of lanes, before certify/detail/floats_text.hpp, which derives the bounds.  It stands in the
// namespace of the lanes V, which has: + - *, product_error (what a product lost), plus_product, above, of_all, chosen.
// Laws: a sum of two of V is exact; the rest is off as arith/track.hpp says.  The sum of both, rounded, has its sign.
// Source: Dekker 1971, without normalizing; docs/proof.md, "Tracked errors".
// Cost: 8 operations a sum; 4 a product where a product and a sum are fused, else 22.
#ifdef PLUMB_PAIRS_TEXT  // alone it is nothing
#undef PLUMB_PAIRS_TEXT

template <class V>
struct Pair {
  V high, low;
};

template <class V>
[[gnu::always_inline]] constexpr V rounded(const V& x) {
  return x;
}
template <class V>
[[gnu::always_inline]] constexpr V rounded(const Pair<V>& x) {
  return x.high + x.low;
}
template <class V>
[[gnu::always_inline]] constexpr V main_part(const V& x) {
  return x;
}
template <class V>
[[gnu::always_inline]] constexpr V main_part(const Pair<V>& x) {
  return x.high;
}
template <class V>
[[gnu::always_inline]] constexpr V opposite(const V& x) {
  return of_all(0) - x;
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> opposite(const Pair<V>& x) {
  return {of_all(0) - x.high, of_all(0) - x.low};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> sum_of_two(const V& a, const V& b) {
  const V s = a + b, b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> difference_of_two(const V& a, const V& b) {
  const V s = a - b, b_part = a - s;
  return {s, (a - (s + b_part)) + (b_part - b)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> operator+(const Pair<V>& a, const Pair<V>& b) {
  const Pair<V> s = sum_of_two(a.high, b.high);
  return {s.high, s.low + (a.low + b.low)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> operator-(const Pair<V>& a, const Pair<V>& b) {
  const Pair<V> s = difference_of_two(a.high, b.high);
  return {s.high, s.low + (a.low - b.low)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> operator*(const Pair<V>& a, const Pair<V>& b) {
  const V p = a.high * b.high;
  return {p, plus_product(plus_product(product_error(a.high, b.high, p), a.high, b.low), a.low, b.high)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> plus_product(const Pair<V>& sum, const Pair<V>& a, const Pair<V>& b) {
  return sum + a * b;
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> minus_product(const Pair<V>& sum, const Pair<V>& a, const Pair<V>& b) {
  return sum - a * b;
}
template <class T, class V>
[[gnu::always_inline]] constexpr Pair<V> chosen(const T& first, const Pair<V>& a, const Pair<V>& b) {
  return {chosen(first, a.high, b.high), chosen(first, a.low, b.low)};
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> size(const Pair<V>& x) {
  return chosen(above(of_all(0), rounded(x)), opposite(x), x);
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> larger(const Pair<V>& a, const Pair<V>& b) {
  return chosen(above(rounded(a - b), of_all(0)), a, b);
}
template <class V>
[[gnu::always_inline]] constexpr Pair<V> smaller(const Pair<V>& a, const Pair<V>& b) {
  return chosen(above(rounded(a - b), of_all(0)), b, a);
}

#endif
