// The world of doubles, or of lanes of them: numbers whose sizes and errors are part of their type, and their signs.
//
// One text for several kinds of lanes: certify/certainly.hpp includes it for one double, src/certify/three_axes.hpp for a
// vector of space, once for each set of instructions.  It stands in the namespace of the lanes V, which has: + - *, size,
// larger, smaller, plus_product, minus_product (fused or not), above, of_all, any, all, Truth, turned, total.
// Laws: those of arith/track.hpp.  A scale is the sum of its leaves' magnitudes, and so NaN where one of them is; or the
// largest, where arith/track.hpp says so.
// Source: docs/proof.md, "Tracked errors".
// Cost: that of the plain operations, and a magnitude and a sum for each leaf.
#ifdef PLUMB_FLOATS_TEXT  // alone it is nothing
#undef PLUMB_FLOATS_TEXT

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
  return Tracked<V, A>{of_all(0) - a.value};
}
template <class V, Track A>
[[gnu::always_inline]] constexpr auto magnitude(const Tracked<V, A>& a) {
  return Tracked<V, A>{size(a.value)};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto larger(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::either(A, B)>{larger(a.value, b.value)};
}
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto smaller(const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::either(A, B)>{smaller(a.value, b.value)};
}
/// One of two, by what was judged.
template <class V, Track A, Track B>
[[gnu::always_inline]] constexpr auto select(bool first, const Tracked<V, A>& a, const Tracked<V, B>& b) {
  return Tracked<V, derive::either(A, B)>{first ? a.value : b.value};
}
/// A difference of which nothing but the sign is asked, which is exact.
template <class V>
struct Ordered {
  V value;

  [[gnu::always_inline]] friend constexpr Ordered larger(const Ordered& a, const Ordered& b) {
    return {larger(a.value, b.value)};
  }
};

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
template <class V, int highest, plumb::Scales of = plumb::Scales(), class Listener = plumb::NoBoundListener>
class Floats {
 public:
  static constexpr plumb::WorldKind kind = plumb::WorldKind::floats;
  using Number = V;

  [[gnu::always_inline]] constexpr Floats()
      : scales_{of_all(floor), of_all(floor), of_all(floor), of_all(floor)},
        weights_{of_all(0), of_all(0), of_all(0), of_all(0)} {}

  [[gnu::always_inline]] constexpr Given<V> given(const auto& x) const { return {loaded(x)}; }

  /// A leaf of this scale: b - a of numbers as given; their sum; one by itself.
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto difference(const Given<V>& b, const Given<V>& a) {
    return leaf<scale, derive::difference(scale, start)>(b.value - a.value);
  }
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto sum(const Given<V>& a, const Given<V>& b) {
    return leaf<scale, derive::difference(scale, start)>(a.value + b.value);
  }
  template <std::size_t scale = 0>
  [[gnu::always_inline]] constexpr auto number(const Given<V>& a) {
    return leaf<scale, derive::given(scale, start)>(a.value);
  }
  /// A number by itself of which scale 0 has the product with scale `over`: of its power, over that scale's.
  template <std::size_t over>
  [[gnu::always_inline]] constexpr auto weight(const Given<V>& a) {
    static_assert(over != 0 && (of.weights >> over & 1) != 0 && !start.is_of_axes(0));
    weights_[over] = has_weight_[over] ? weights_[over] + size(a.value) : size(a.value);
    has_weight_[over] = true;
    return Tracked<V, derive::weight(0, over, start)>{a.value};
  }
  /// b - a, which is no larger than two leaves of this scale together, so that it need not be added to it.
  template <std::size_t scale = 0, Track A, Track B>
  [[gnu::always_inline]] constexpr auto difference_within(const Given<V>& b, const Given<V>& a, const Tracked<V, A>&,
                                                          const Tracked<V, B>&) const {
    static_assert(A == derive::difference(scale, start) && B == A && (of.maxima >> scale & 1) == 0);
    return Tracked<V, derive::within(scale, start)>{b.value - a.value};
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
    } else {
      if constexpr (T.others == 0) {
        return of_all(derive::threshold(T)) * all_powers<T.powers>();
      } else {
        constexpr std::size_t first = derive::next_part(T.others, 0);
        return of_all(derive::threshold(T)) *
               plus_product(all_powers<T.powers>(), part<T.others, first>(), all_powers<T.others, first + 1>());
      }
    }
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth positive(const Tracked<V, T>& x) const {
    return above(x.value, doubt<T>());
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth negative(const Tracked<V, T>& x) const {
    return above(of_all(0) - doubt<T>(), x.value);
  }
  /// What is exactly zero; nothing of what is not known exactly.
  template <Track T>
  [[gnu::always_inline]] constexpr Truth zero(const Tracked<V, T>& x) const {
    if constexpr (T.root == 0) {
      return is_zero(x.value);
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
  [[gnu::always_inline]] constexpr Truth is_real(const Tracked<V, T>& x) const {
    return above(of_all(__builtin_huge_val()), x.value);
  }
  template <Track T>
  [[gnu::always_inline]] constexpr Truth not_negative(const Tracked<V, T>& x) const {
    static_assert(T.root == 0, "of what is known exactly");
    return above(x.value, of_all(-0x1p-1074));
  }

  /// The scale, with what weighs in it; no leaf of it so far is larger.
  template <std::size_t s>
  [[gnu::always_inline]] constexpr V scale() const {
    if constexpr (start.is_of_axes(s)) {
      return scales_[s];
    } else if constexpr (s == 0 && of.weights != 0) {
      return in_all<0>() + of_all(total(all_weights<1>()));
    } else {
      return in_all<s>();
    }
  }
  /// May the answer be believed?  Not where a sign was unsure, a number none, or a scale too large.
  [[gnu::always_inline]] constexpr bool certain() const {
    if constexpr (of.each_axis == 0) {
      return !unsure_ && x_of(sum_of_scales<0>()) < 1 / floor && (!required_.is_some() || all(required_.truth()));
    } else {
      const Truth in_range = above(of_all(1 / floor), sum_of_scales<0>());
      return !unsure_ && all(required_.is_some() ? required_.truth() & in_range : in_range);
    }
  }

 private:
  static constexpr plumb::Track start{0, 0, 0, 0, 0, highest, of.each_axis};
  static constexpr double floor = derive::floor_of(highest);

  template <std::size_t scale, Track T>
  [[gnu::always_inline]] constexpr Tracked<V, T> leaf(const V& x) {
    static_assert(scale < of.count);
    if constexpr ((of.maxima >> scale & 1) != 0) {
      scales_[scale] = larger(size(x), scales_[scale]);
    } else {
      scales_[scale] = scales_[scale] + size(x);
    }
    return {x};
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
      return scale<s>();
    } else {
      return scale<s>() + sum_of_scales<s + 1>();
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
  template <std::size_t s, std::size_t k>
  [[gnu::always_inline]] constexpr V of_axis() const {
    if constexpr (k == 0) {
      return scale<s>();
    } else if constexpr (k == 1) {
      return turned(scale<s>());
    } else {
      return turned_back(scale<s>());
    }
  }
  /// The product of the scales in these powers, from that of number `at` on, 3 s + k.
  template <std::uint64_t powers, std::size_t at = 0>
  [[gnu::always_inline]] constexpr V all_powers() const {
    constexpr std::size_t next = derive::next_part(powers, at), end = 3 * plumb::Track::scales;
    static_assert(next < end, "a number without a scale");
    if constexpr (derive::next_part(powers, next + 1) == end) {
      return part<powers, next>();
    } else {
      return part<powers, next>() * all_powers<powers, next + 1>();
    }
  }
  template <std::uint64_t powers, std::size_t at>
  [[gnu::always_inline]] constexpr V part() const {
    return raised<Track::power_in(powers, at / 3, at % 3)>(of_axis<at / 3, at % 3>());
  }

  std::array<V, plumb::Track::scales> scales_, weights_;
  std::array<bool, plumb::Track::scales> has_weight_{};
  Merged required_;
  bool unsure_ = false;
};

/// The gaps of two convex sets along axes, lane by lane: apart along one, below zero along all, or level along some.
template <class World>
class Gaps {
 public:
  [[gnu::always_inline]] constexpr explicit Gaps(World& world) : world_(world) {}

  /// Along an axis; with parts along that which they make, where they are not all exactly zero.
  [[gnu::always_inline]] constexpr void heed(const auto& gap, const auto&... parts) {
    const Truth below = world_.negative(gap);
    apart_.either(world_.positive(gap));
    if constexpr (sizeof...(parts) == 0) {
      below_.both(below);
      settled_.both(below | world_.zero(gap));
    } else {
      const Truth none = (world_.zero(parts) & ...);
      below_.both(below | none);
      settled_.both(below | none);
    }
  }
  /// Of what goes on that way for ever: where the way is up the first gap counts, where it is down the second, else both.
  [[gnu::always_inline]] constexpr void heed_ahead(const auto& way, const auto& up, const auto& down) {
    const Truth is_up = world_.positive(way), is_down = world_.negative(way);
    const Truth below_up = world_.negative(up), below_down = world_.negative(down);
    const Truth below = ((below_up & is_up) | (below_down & is_down)) | (below_up & below_down);
    apart_.either((world_.positive(up) & is_up) | (world_.positive(down) & is_down));
    below_.both(below), settled_.both(below);
  }
  /// Doubles pass over no axis whose parts are computed, and so need nothing of those that are left.
  [[gnu::always_inline]] constexpr void need(const auto&) {}
  /// Along what may be no axis: only a gap tells.
  [[gnu::always_inline]] constexpr void heed_above(const auto& gap) { apart_.either(world_.positive(gap)); }
  [[gnu::always_inline]] constexpr bool is_apart() const { return any(apart_.truth()); }

  /// For sets of which touching is told where a gap is zero, if they have an inside.
  template <class Answer>
  [[gnu::always_inline]] constexpr Answer relation(const auto& have_inside) {
    const int apart = any(apart_.truth()), below = all(below_.truth());
    if ((apart | below) != 0) [[likely]]
      return static_cast<Answer>(below - apart);
    if (!all(settled_.truth()) || !all(world_.positive(have_inside))) world_.leave_open();
    return static_cast<Answer>(0);
  }

 private:
  World& world_;
  Merged apart_, below_, settled_;
};

/// The answer of the first of these worlds that is certain; of the last one in any case.
template <class First, class... Rest, class Recorder, class Statement, class... Input>
[[gnu::always_inline]] constexpr auto ask_worlds(Recorder&& recorder, const Statement& statement,
                                                 const Input&... input) {
  First world;
  auto answer = statement(world, input...);
  if constexpr (sizeof...(Rest) != 0) {
    if (!world.certain()) [[unlikely]]
      return ask_worlds<Rest...>(recorder, statement, input...);
  }
  recorder.answered(First::kind);
  return answer;
}

/// The answer of the first of these worlds that is certain, if one is.
template <class First, class... Rest, class Recorder, class Statement, class... Input>
[[gnu::always_inline]] constexpr auto told_by_worlds(Recorder&& recorder, const Statement& statement,
                                                     const Input&... input) {
  First world;
  const auto answer = statement(world, input...);
  if (world.certain()) [[likely]] {
    recorder.answered(First::kind);
    return std::optional(answer);
  }
  if constexpr (sizeof...(Rest) != 0) {
    return told_by_worlds<Rest...>(recorder, statement, input...);
  } else {
    return std::optional<std::remove_cv_t<decltype(answer)>>();
  }
}

#endif
