// What is computed with in the world of doubles: numbers whose sizes and errors are part of their type.
//
// The beginning of certify/detail/floats_text.hpp, which includes it in the namespace of the lanes.
// Laws: those of arith/track.hpp.
// Source: docs/proof.md, "Tracked errors".
// Cost: that of the plain operations.
#ifdef PLUMB_TRACKED_TEXT  // alone it is nothing
#undef PLUMB_TRACKED_TEXT

/// A number as given.  Only a world makes numbers to compute with of it.
template <class V>
struct Given {
  V value;

  [[gnu::always_inline]] friend constexpr Given larger(const Given& a, const Given& b) {
    return {larger(a.value, b.value)};
  }
  [[gnu::always_inline]] friend constexpr Given smaller(const Given& a, const Given& b) {
    return {smaller(a.value, b.value)};
  }
};

template <class V, plumb::Track T>
struct Tracked {
  static constexpr plumb::Track track = T;
  V value;
};

namespace derive = plumb::arith::track;

template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto operator+(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::sum(A, B)>{a.value + b.value};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto operator-(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::sum(A, B)>{a.value - b.value};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto operator*(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::product(A, B)>{a.value * b.value};
}
/// sum + a b and sum - a b, rounded once or twice.
template <class V, Track S, Track A, Track B>
[[gnu::always_inline]] constexpr auto plus_product(const Tracked<V, S>& sum, const Tracked<V, A>& a,
                                                   const Tracked<V, B>& b) {
  return Tracked<V, derive::sum(S, derive::product(A, B))>{plus_product(sum.value, a.value, b.value)};
}
template <class V, Track S, Track A, Track B>
[[gnu::always_inline]] constexpr auto minus_product(const Tracked<V, S>& sum, const Tracked<V, A>& a,
                                                    const Tracked<V, B>& b) {
  return Tracked<V, derive::sum(S, derive::product(A, B))>{minus_product(sum.value, a.value, b.value)};
}
template <class V, Track A>
[[gnu::always_inline]] constexpr auto twice(const Tracked<V, A>& a) {
  return Tracked<V, derive::twice(A)>{a.value + a.value};
}
template <class V, Track A>
[[gnu::always_inline]] constexpr auto negated(const Tracked<V, A>& a) {
  return Tracked<V, A>{opposite(a.value)};
}
/// a, or else its opposite, lane by lane.
template <class V, Track A>
[[gnu::always_inline]] constexpr auto negated_unless(const Truth& is_so, const Tracked<V, A>& a) {
  return Tracked<V, A>{chosen(is_so, a.value, of_all(0) - a.value)};
}
/// a - b, on purpose of numbers of different scales.
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto difference_of_unlike(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::sum_of_unlike(A, B)>{a.value - b.value};
}
template <class V, Track A>
[[gnu::always_inline]] constexpr auto magnitude(const Tracked<V, A>& a) {
  return Tracked<V, A>{size(a.value)};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto larger(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::extreme(A, B)>{larger(a.value, b.value)};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto smaller(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::extreme(A, B)>{smaller(a.value, b.value)};
}
/// (1 - t) a + t b, for t in [0, 1].
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto between(const Tracked<V, A>& a, const Tracked<V, B>& b, const V& t) {
  return Tracked<V, derive::between(A, B)>{(of_all(1) - t) * a.value + t * b.value};
}
/// One of two, by what was judged.
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto select(bool first, const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::either(A, B)>{first ? a.value : b.value};
}
/// Lane by lane.
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto chosen(const Truth& first, const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::either(A, B)>{chosen(first, a.value, b.value)};
}
/// A difference of which nothing but the sign is asked, which is exact.
template <class V>
struct Ordered {
  V value;

  [[gnu::always_inline]] friend constexpr Ordered larger(const Ordered& a, const Ordered& b) {
    return {larger(a.value, b.value)};
  }
};

#endif
