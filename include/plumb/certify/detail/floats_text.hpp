// The world of doubles, or of lanes of them: numbers whose sizes and errors are part of their type, and their signs.
//
// One text for several kinds of lanes: certify/certainly.hpp includes it for one double, src/certify/three_axes.hpp for a
// vector of space, once for each set of instructions.  It stands in the namespace of the lanes V, which has: + - *, size,
// larger, smaller, plus_product, minus_product (fused or not), above, of_all, any, all, both, Truth, turned, total; of pairs
// what certify/detail/pairs_text.hpp asks for, and lowest_bit, least.
// Laws: those of arith/track.hpp.  A scale is the sum of its leaves' magnitudes, and so NaN where one of them is; or the
// largest, or the root of the sum of their squares, where arith/track.hpp says so.
// Source: docs/proof.md, "Tracked errors".
// Cost: that of the plain operations, and a magnitude and a sum for each leaf.
#ifdef PLUMB_FLOATS_TEXT  // alone it is nothing
#undef PLUMB_FLOATS_TEXT

#define PLUMB_TRACKED_TEXT
#include "plumb/certify/detail/tracked_text.hpp"

/// What holds in all lanes of some, or in any of them; of none so far nothing is computed.
class Merged {
 public:
  [[gnu::always_inline]] constexpr void both(const Truth& t) { truth_ = is_some_ ? t & truth_ : t, is_some_ = true; }
  [[gnu::always_inline]] constexpr void either(const Truth& t) { truth_ = is_some_ ? t | truth_ : t, is_some_ = true; }
  [[gnu::always_inline]] constexpr const Truth& truth() const { return truth_; }
  [[gnu::always_inline]] constexpr bool is_some() const { return is_some_; }

 private:
  Truth truth_{};
  bool is_some_ = false;
};

template <class World>
class Gaps;

/// No number of a statement is of a higher power of its scales than `highest`: the higher, the nearer to 1 they must
/// be.  The listener is told the track of each number that is judged.
template <class V, int highest, plumb::Scales of = plumb::Scales(), class Listener = plumb::NoBoundListener,
          plumb::Precision precision = plumb::Precision::doubles>
class Floats {
 public:
  static constexpr bool of_pairs = precision == plumb::Precision::pairs;
  static constexpr bool on_lattice = precision != plumb::Precision::doubles;
  static constexpr plumb::WorldKind kind = of_pairs     ? plumb::WorldKind::pairs
                                           : on_lattice ? plumb::WorldKind::integers
                                                        : plumb::WorldKind::floats;
  using Number = std::conditional_t<of_pairs, Pair<V>, V>;

  [[gnu::always_inline]] constexpr Floats()
      : scales_{of_all(first_of(0)), of_all(first_of(1)), of_all(first_of(2)), of_all(first_of(3))},
        weights_{of_all(0), of_all(0), of_all(0), of_all(0)} {
    if constexpr (on_lattice) {
      const V none = of_all(__builtin_huge_val());
      units_ = {none, none, none, none}, weight_units_ = units_;
    }
  }

  [[gnu::always_inline]] constexpr Given<V> given(const auto&... x) const { return {loaded(x...)}; }

  /// A leaf of this scale: b - a of numbers as given; their sum; one by itself.
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto difference(const Given<V>& b, const Given<V>& a) {
    note_units<scale>(b, a);
    return leaf<scale, derive::difference(scale, start)>(plain_difference(b.value, a.value));
  }
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto sum(const Given<V>& a, const Given<V>& b) {
    note_units<scale>(b, a);
    return leaf<scale, derive::difference(scale, start)>(plain_sum(a.value, b.value));
  }
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto number(const Given<V>& a) {
    note_units<scale>(a);
    return leaf<scale, derive::given(scale, start)>(as_number(a.value));
  }
  /// A number by itself of which scale 0 has the product with scale `over`: of its power, over that scale's.
  template <std::size_t over>
  [[gnu::always_inline]] constexpr auto weight(const Given<V>& a) {
    static_assert(over != 0 && (of.weights >> over & 1) != 0 && !start.is_of_axes(0));
    weights_[over] = has_weight_[over] ? weights_[over] + size(a.value) : size(a.value);
    has_weight_[over] = true;
    if constexpr (on_lattice) weight_units_[over] = smaller(weight_units_[over], lowest_bit(a.value));
    return Tracked<Number, derive::weight(0, over, start)>{as_number(a.value)};
  }
  /// A number in [0, 1] of no scale, which a guess may be: below, and where it is no number, it is 0, above 1.
  [[gnu::always_inline]] constexpr auto portion(const auto& t) const {
    static_assert(!on_lattice, "it is a multiple of nothing that is known");
    const V x = loaded(t);
    return Tracked<Number, derive::portion(start)>{smaller(chosen(above(x, of_all(0)), x, of_all(0)), of_all(1))};
  }
  /// b - a, one for each k of 1, 2 and 3, of which scale 0 has the product with both of these scales that are not k: the
  /// latest, so that there may be others after what was judged.
  template <std::size_t k>
  [[gnu::always_inline]] constexpr auto crosswise(const auto& b, const auto& a) {
    static_assert(of.crosswise && of.weights == 0 && of.each_axis == 0 && k >= 1 && k <= 3 && !on_lattice);
    const V x = loaded(b) - loaded(a);
    weights_[k] = size(x);
    return Tracked<Number, derive::crosswise(0, k % 3 + 1, (k + 1) % 3 + 1, start)>{x};
  }
  /// The sum of all three times what the scales are that each is multiplied by.
  template <Track X, Track Y, Track Z, Track A, Track B, Track C>
  [[gnu::always_inline]] constexpr auto sum_crosswise(const Tracked<Number, X>& x, const Tracked<Number, A>& a,
                                                      const Tracked<Number, Y>& y, const Tracked<Number, B>& b,
                                                      const Tracked<Number, Z>& z, const Tracked<Number, C>& c) const {
    static_assert(X == derive::crosswise(0, 2, 3, start) && Y == derive::crosswise(0, 3, 1, start) &&
                  Z == derive::crosswise(0, 1, 2, start));
    constexpr Track all = derive::sum_crosswise(X, A);
    static_assert(all == derive::sum_crosswise(Y, B) && all == derive::sum_crosswise(Z, C));
    return Tracked<Number, all>{plus_product(plus_product(x.value * a.value, y.value, b.value), z.value, c.value)};
  }
  /// No leaf of this scale exceeds this in magnitude: said before there are any, of lanes in all of them.
  template <std::size_t scale>
  [[gnu::always_inline]] constexpr void bound(const V& most) {
    static_assert((of.known >> scale & 1) != 0);
    scales_[scale] = scales_[scale] + most;
  }
  /// b - a, which is no larger than two leaves of this scale together, so that it need not be added to it.
  template <std::size_t scale = 0, Track A, Track B>
  [[gnu::always_inline]] constexpr auto difference_within(const Given<V>& b, const Given<V>& a,
                                                          const Tracked<Number, A>&, const Tracked<Number, B>&) const {
    static_assert(A == derive::difference(scale, start) && B == A);
    constexpr Track::Fixed scales = (of.maxima >> scale & 1) != 0 ? 2 : 1;
    return Tracked<Number, derive::within(scale, start, scales)>{plain_difference(b.value, a.value)};
  }
  /// The same leaves of what is given outright.
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto difference(const auto& b, const auto& a) {
    return difference<scale>(given(b), given(a));
  }
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto number(const auto& a) {
    return number<scale>(given(a));
  }
  /// Below zero where this is so.
  [[gnu::always_inline]] constexpr Ordered<V> unless(const Truth& is_so, const Ordered<V>& x) const {
    return {chosen(is_so, of_all(-1), x.value)};
  }
  [[gnu::always_inline]] constexpr Ordered<V> order(const Given<V>& b, const Given<V>& a) const {
    return {b.value - a.value};
  }

  /// What a number of this track must exceed for its sign to be certain.
  template <Track T>
  [[gnu::always_inline]] constexpr V doubt() const {
    Listener::judged(T);
    if constexpr (T.root == 0) {
      return of_all(0);
    } else if constexpr (!on_lattice) {
      return error<T>();
    } else {
      return chosen(is_exact<T>(), of_all(0), error<T>());
    }
  }
  /// As much as a number of this track may be off.
  template <Track T>
  [[gnu::always_inline]] constexpr V reach() const {
    return of_all(derive::reach(T) * slack) * all_scales<T>();
  }
  /// Doubles that are no more, and no less, than the exact number.
  template <Track T>
  [[gnu::always_inline]] constexpr V lower(const Tracked<Number, T>& x) const requires(!of_pairs) {
    return minus_product(x.value, of_all(derive::margin(T) * slack), all_scales<T>());
  }
  template <Track T>
  [[gnu::always_inline]] constexpr V upper(const Tracked<Number, T>& x) const requires(!of_pairs) {
    return plus_product(x.value, of_all(derive::margin(T) * slack), all_scales<T>());
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth positive(const Tracked<Number, T>& x) const {
    if constexpr (by_square<T>()) {
      return both(above(x.value, of_all(0)), is_large(x));
    } else {
      return above(rounded(x.value), doubt<T>());
    }
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth negative(const Tracked<Number, T>& x) const {
    if constexpr (by_square<T>()) {
      return both(above(of_all(0), x.value), is_large(x));
    } else {
      return above(of_all(0) - doubt<T>(), rounded(x.value));
    }
  }
  /// What is exactly zero; nothing of what is not known exactly.
  template <Track T>
  [[gnu::always_inline]] constexpr Truth zero(const Tracked<Number, T>& x) const {
    if constexpr (T.root == 0) {
      return is_zero(rounded(x.value));
    } else if constexpr (on_lattice) {
      return both(is_exact<T>(), is_zero(rounded(x.value)));
    } else {
      return above(of_all(0), of_all(0));
    }
  }
  [[gnu::always_inline]] constexpr Truth positive(const Ordered<V>& x) const { return above(x.value, of_all(0)); }
  [[gnu::always_inline]] constexpr Truth negative(const Ordered<V>& x) const { return above(of_all(0), x.value); }
  [[gnu::always_inline]] constexpr Truth zero(const Ordered<V>& x) const { return is_zero(x.value); }

  /// The sign of one number; where it is not certain the world says so at the end, and its answer is void.
  [[gnu::always_inline]] constexpr plumb::Sign sign(const auto& x) {
    const int s = static_cast<int>(positive(x)) - static_cast<int>(negative(x));
    unsure_ = unsure_ || (s == 0 && !zero(x));
    return static_cast<plumb::Sign>(s);
  }
  [[gnu::always_inline]] constexpr plumb::Sign compare(const auto& x, const auto& y) { return sign(x - y); }
  /// Of lanes: is it so in any, in all?
  [[gnu::always_inline]] static constexpr bool is_any(const Truth& t) { return any(t); }
  [[gnu::always_inline]] static constexpr bool is_all(const Truth& t) { return all(t); }
  [[gnu::always_inline]] constexpr auto gaps() { return Gaps<Floats>(*this); }
  /// For statements that judge lanes themselves.
  [[gnu::always_inline]] constexpr void leave_open() { unsure_ = true; }
  /// Without this, or NaN in the place of a number, there is no answer.
  [[gnu::always_inline]] constexpr void require(const Truth& t) { required_.both(t); }
  /// Below infinity, and a number.
  template <Track T>
  [[gnu::always_inline]] constexpr Truth is_real(const Tracked<Number, T>& x) const {
    return above(of_all(__builtin_huge_val()), rounded(x.value));
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth not_negative(const Tracked<Number, T>& x) const {
    static_assert(T.root == 0, "of what is known exactly");
    return above(rounded(x.value), of_all(-0x1p-1074));
  }

  /// The scale, with what weighs in it; no leaf of it so far is larger.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V scale() const {
    static_assert(!is_square(s), "its square is known");
    if constexpr (start.is_of_axes(s)) {
      return scales_[s];
    } else if constexpr (s == 0 && of.weights != 0) {
      return in_all<0>() + of_all(total(all_weights<1>()));
    } else if constexpr (s == 0 && of.crosswise) {
      const V x = scale<1>(), y = scale<2>(), z = scale<3>();
      return plus_product(plus_product(plus_product(in_all<0>(), weights_[1], y * z), weights_[2], z * x), weights_[3],
                          x * y);
    } else {
      return in_all<s>();
    }
  }
  /// Its square, where it is the root of a sum of squares.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V square_of_scale() const requires(!on_lattice && (of.squares >> s & 1) != 0) {
    return of_all(total(scales_[s])) + of_all(floor * floor);
  }
  /// A power of two of which all leaves of this scale are multiples; infinity, where all are zero.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V unit() const {
    static_assert(on_lattice);
    if constexpr (start.is_of_axes(s)) {
      return units_[s];
    } else if constexpr (s == 0 && of.weights != 0) {
      return of_all(least(smaller(units_[0], unit_of_weights<1>())));
    } else {
      return of_all(least(units_[s]));
    }
  }
  /// Lane by lane: is no number none, and no scale too large?
  [[gnu::always_inline]] constexpr Truth in_range() const { return above(of_all(limit), sum_of_scales<0>()); }
  /// May the answer be believed?  Not where a sign was unsure, a number none, or a scale too large.
  [[gnu::always_inline]] constexpr bool certain() const {
    if constexpr (of.each_axis == 0) {
      return !unsure_ && x_of(sum_of_scales<0>()) < limit && (!required_.is_some() || all(required_.truth()));
    } else {
      return !unsure_ && all(required_.is_some() ? required_.truth() & in_range() : in_range());
    }
  }

 private:
  static constexpr plumb::Track start{0, 0, 0, 0, 0, highest, of.each_axis, 0, of_pairs};
  static constexpr double floor = derive::floor_of(highest, of_pairs);

  /// Of which scales are squares summed up?  Where they are, odd powers are judged by squares, and what their sums are
  /// rounded is paid for: of some thousand leaves.
  static constexpr unsigned squares = on_lattice ? 0 : of.squares;
  static_assert(squares == 0 || (highest > 1 && of.weights == 0 && of.each_axis == 0 && !of.crosswise &&
                                 (of.squares & of.maxima) == 0));
  static constexpr bool all_squares = squares + 1 == 1U << of.count;
  static constexpr double slack = squares == 0 ? 1 : 1 + 0x1p-39;
  static constexpr double limit = all_squares ? 1 / floor / floor : 1 / floor;
  static constexpr bool is_square(std::size_t s) { return (squares >> s & 1) != 0; }
  static constexpr double first_of(std::size_t s) { return is_square(s) ? 0 : floor; }
  template <Track T>
  static constexpr bool by_square() {
    if constexpr (squares != 0 && T.root != 0) {
      for (std::size_t s = 0; s < of.count; ++s) {
        if (is_square(s) && T.power(s, 0) % 2 != 0) return true;
      }
    }
    return false;
  }
  /// Beyond its bound on either side: its square beyond the bound's.
  template <Track T>
  [[gnu::always_inline]] constexpr Truth is_large(const Tracked<Number, T>& x) const {
    Listener::judged(T);
    static_assert(T.others == 0 && 2 * T.total_power() <= highest);
    const V in_bounds = x.value * of_all((1 - 0x1p-39) / (derive::threshold(T) * slack));
    return above(in_bounds * in_bounds, all_powers<false, T.powers, 0, 2>());
  }

  [[gnu::always_inline]] static constexpr Number as_number(const V& x) {
    if constexpr (of_pairs) {
      return {x, of_all(0)};
    } else {
      return x;
    }
  }
  [[gnu::always_inline]] static constexpr Number plain_sum(const V& a, const V& b) {
    if constexpr (of_pairs) {
      return sum_of_two(a, b);
    } else {
      return a + b;
    }
  }
  [[gnu::always_inline]] static constexpr Number plain_difference(const V& a, const V& b) {
    if constexpr (of_pairs) {
      return difference_of_two(a, b);
    } else {
      return a - b;
    }
  }
  template <std::size_t scale>
  [[gnu::always_inline]] constexpr void note_units(const auto&... leaves) {
    if constexpr (on_lattice) ((units_[scale] = smaller(units_[scale], lowest_bit(leaves.value))), ...);
  }
  template <std::size_t scale, Track T>
  [[gnu::always_inline]] constexpr Tracked<Number, T> leaf(const Number& x) {
    static_assert(scale < of.count);
    if constexpr ((of.known >> scale & 1) != 0) {
      static_assert((of.maxima >> scale & 1) != 0 && !on_lattice);
    } else if constexpr ((of.maxima >> scale & 1) != 0) {
      scales_[scale] = larger(size(main_part(x)), scales_[scale]);
    } else if constexpr (is_square(scale)) {  // as the statement sums them up, which need not be done twice
      scales_[scale] = has_leaf_[scale] ? scales_[scale] + x * x : x * x;
      has_leaf_[scale] = true;
    } else {
      scales_[scale] = scales_[scale] + size(main_part(x));
    }
    return {x};
  }
  template <Track T>
  [[gnu::always_inline]] constexpr V error() const {
    return of_all(derive::threshold(T) * slack) * all_scales<T>();
  }
  /// M.
  template <Track T>
  [[gnu::always_inline]] constexpr V all_scales() const {
    if constexpr (T.others == 0) {
      return all_powers<false, T.powers>();
    } else {
      constexpr std::size_t first = derive::next_part(T.others, 0);
      return plus_product(all_powers<false, T.powers>(), part<false, T.others, first>(),
                          all_powers<false, T.others, first + 1>());
    }
  }
  /// A number and what is computed of it are multiples of one power of two: equal, where they differ by less.
  template <Track T>
  [[gnu::always_inline]] constexpr Truth is_exact() const {
    if constexpr (T.others == 0) {
      return above(all_powers<true, T.powers>(), error<T>());
    } else {
      return above(smaller(all_powers<true, T.powers>(), all_powers<true, T.others>()), error<T>());
    }
  }
  template <std::size_t over>
  [[gnu::always_inline]] constexpr V unit_of_weights() const {
    if constexpr ((of.weights >> over) == 0) {
      return of_all(__builtin_huge_val());
    } else if constexpr ((of.weights >> over & 1) == 0) {
      return unit_of_weights<over + 1>();
    } else {
      return smaller(unit_of_weights<over + 1>(), unit<over>() * weight_units_[over]);
    }
  }
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V in_all() const {
    if constexpr ((of.maxima >> s & 1) != 0) {
      return of_all(largest(scales_[s]));
    } else {
      return of_all(total(scales_[s]));
    }
  }
  /// The weights from scale `over` on, each times its scale.
  template <std::size_t over>
  [[gnu::always_inline]] constexpr V all_weights() const {
    if constexpr ((of.weights >> (over + 1)) == 0) {
      return scale<over>() * weights_[over];
    } else if constexpr ((of.weights >> over & 1) == 0) {
      return all_weights<over + 1>();
    } else {
      return plus_product(all_weights<over + 1>(), scale<over>(), weights_[over]);
    }
  }
  /// Of this scale and those after it.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V sum_of_scales() const {
    if constexpr (s + 1 == of.count) {
      return in_sum<s>();
    } else {
      return in_sum<s>() + sum_of_scales<s + 1>();
    }
  }
  /// What is in the sum of all scales.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V in_sum() const {
    if constexpr (!is_square(s)) {
      return scale<s>();
    } else if constexpr (all_squares) {
      return square_of_scale<s>();
    } else {
      return square_of_scale<s>() * of_all(floor);
    }
  }

  template <int power>
  [[gnu::always_inline]] static constexpr V raised(const V& x) {
    static_assert(power > 0, "a number is judged whose power of a scale is below zero");
    if constexpr (power == 1) {
      return x;
    } else if constexpr (power % 2 == 0) {
      return raised<power / 2>(x) * raised<power / 2>(x);
    } else {
      return raised<power - 1>(x) * x;
    }
  }
  template <bool of_units, std::size_t s>
  [[gnu::always_inline]] constexpr V scale_or_unit() const {
    if constexpr (of_units) {
      return unit<s>();
    } else {
      return scale<s>();
    }
  }
  template <bool of_units, std::size_t s, std::size_t k>
  [[gnu::always_inline]] constexpr V of_axis() const {
    if constexpr (k == 0) {
      return scale_or_unit<of_units, s>();
    } else if constexpr (k == 1) {
      return turned(scale_or_unit<of_units, s>());
    } else {
      return turned_back(scale_or_unit<of_units, s>());
    }
  }
  /// The product of the scales in these powers, or of their units, from that of number `at` on, 3 s + k; raised to
  /// another power.
  template <bool of_units, std::uint64_t powers, std::size_t at = 0, int more = 1>
  [[gnu::always_inline]] constexpr V all_powers() const {
    constexpr std::size_t next = derive::next_part(powers, at), end = 3 * plumb::Track::scales;
    static_assert(next < end, "a number without a scale");
    if constexpr (derive::next_part(powers, next + 1) == end) {
      return part<of_units, powers, next, more>();
    } else {
      return part<of_units, powers, next, more>() * all_powers<of_units, powers, next + 1, more>();
    }
  }
  template <bool of_units, std::uint64_t powers, std::size_t at, int more = 1>
  [[gnu::always_inline]] constexpr V part() const {
    constexpr int power = more * Track::power_in(powers, at / 3, at % 3);
    if constexpr (is_square(at / 3)) {
      static_assert(power % 2 == 0, "an odd power of a scale whose square is known");
      return raised<power / 2>(square_of_scale<at / 3>());
    } else {
      return raised<power>(of_axis<of_units, at / 3, at % 3>());
    }
  }

  struct Nothing {};
  std::array<V, plumb::Track::scales> scales_, weights_;
  [[no_unique_address]] std::conditional_t<on_lattice, std::array<V, plumb::Track::scales>, Nothing> units_,
      weight_units_;
  std::array<bool, plumb::Track::scales> has_weight_{}, has_leaf_{};
  Merged required_;
  bool unsure_ = false;
};

#define PLUMB_GAPS_TEXT
#include "plumb/certify/detail/gaps_text.hpp"

#endif
