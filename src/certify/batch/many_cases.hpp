// What does a filter say of many cases at once?  The filters over Highway's vectors.
//
// A formula is replayed from its tape, which was recorded when it was compiled: the operations are those of the one
// statement in predicates/, each rounded once (Mul, Add and Sub; nothing is fused).  So the constants that are derived
// from the formula hold in every lane, and a lane that is sure has the exact sign (docs/proof.md).
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_MANY_CASES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_MANY_CASES
#undef PLUMB_BATCH_MANY_CASES
#else
#define PLUMB_BATCH_MANY_CASES
#endif

#include <hwy/highway.h>

#include <utility>

#include "certify/batch/lanes.hpp"
#include "certify/batch/replay_plan.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::batch::HWY_NAMESPACE {

// Filter A: the rules of arith/filtered.hpp.  A difference of coordinates is its own magnitude.
template <class F, std::size_t I>
HWY_INLINE void replay_magnitude(V* value, V* magnitude) {
  using Plan = ReplayPlan<F>;
  if constexpr (!Plan::is_difference(I)) {
    constexpr certify::tape::Instruction in = Plan::instruction(I);
    constexpr std::size_t l = in.left - arity<F>, r = in.right - arity<F>;
    constexpr bool plain = Plan::is_difference(l) && Plan::is_difference(r);
    const auto size_of = [&](auto k) HWY_ATTR {
      if constexpr (Plan::is_difference(decltype(k)::value)) {
        return hn::Abs(value[k]);
      } else {
        return magnitude[k];
      }
    };
    using L = std::integral_constant<std::size_t, l>;
    using R = std::integral_constant<std::size_t, r>;
    if constexpr (in.operation == '*') {
      value[I] = hn::Mul(value[l], value[r]);
      if constexpr (plain) {
        magnitude[I] = hn::Add(hn::Abs(value[I]), broadcast(underflow_guard));
      } else {
        magnitude[I] = hn::Add(hn::Mul(size_of(L()), size_of(R())), broadcast(underflow_guard));
      }
    } else {
      value[I] = in.operation == '-' ? hn::Sub(value[l], value[r]) : hn::Add(value[l], value[r]);
      magnitude[I] = hn::Add(size_of(L()), size_of(R()));
    }
  }
}

template <class F, std::size_t I>
HWY_INLINE void replay_value(V* value) {
  using Plan = ReplayPlan<F>;
  if constexpr (!Plan::is_difference(I)) {
    constexpr certify::tape::Instruction in = Plan::instruction(I);
    constexpr std::size_t l = in.left - arity<F>, r = in.right - arity<F>;
    value[I] = in.operation == '*'   ? hn::Mul(value[l], value[r])
               : in.operation == '-' ? hn::Sub(value[l], value[r])
                                     : hn::Add(value[l], value[r]);
  }
}

// Filter B's magnitude: each difference is the largest of its axis; what is alike is computed once.
template <class F, std::size_t I>
HWY_INLINE void replay_largest(const V* largest, V* magnitude) {
  using Plan = ReplayPlan<F>;
  if constexpr (Plan::like[I] == I) {
    if constexpr (Plan::is_difference(I)) {
      magnitude[I] = largest[Plan::axis(I)];
    } else {
      constexpr certify::tape::Instruction in = Plan::instruction(I);
      constexpr std::size_t l = Plan::like[in.left - arity<F>], r = Plan::like[in.right - arity<F>];
      magnitude[I] = in.operation == '*' ? hn::Mul(magnitude[l], magnitude[r]) : hn::Add(magnitude[l], magnitude[r]);
    }
  }
}

template <int N>
HWY_INLINE V power_of(V x) {
  if constexpr (N == 1) {
    return x;
  } else {
    return hn::Mul(x, power_of<N - 1>(x));
  }
}

template <class F, std::size_t... Axis>
HWY_INLINE V product_over(const V* largest, std::index_sequence<Axis...>) {
  V product = power_of<axis_degrees<F>.degree[0]>(largest[0]);
  ((Axis > 0 ? void(product = hn::Mul(product, power_of<axis_degrees<F>.degree[Axis]>(largest[Axis]))) : void()), ...);
  return product;
}

/// The threshold of filter B, as largest_threshold computes it for one case.
template <class F, std::size_t... I>
HWY_INLINE V threshold_over(const V* largest, std::index_sequence<I...>) {
  if constexpr (axis_degrees<F>.equal_terms) {
    constexpr double of_units = largest_threshold<F>(per_axis<F>([](std::size_t) { return 1.0; }));
    return hn::Mul(broadcast(of_units), product_over<F>(largest, std::make_index_sequence<ReplayPlan<F>::dimension>()));
  } else {
    V magnitude[ReplayPlan<F>::size];
    [[maybe_unused]] const bool in_turn[]{(replay_largest<F, I>(largest, magnitude), true)...};
    return hn::Mul(broadcast(filter_constant<F>()), magnitude[ReplayPlan<F>::like[sizeof...(I) - 1]]);
  }
}

template <class F>
inline constexpr bool batch_by_magnitude = degree<F>() < 3;

// The larger one of m >= 0 and |x|; anything where x is NaN, for the value is NaN then.
HWY_INLINE V larger_magnitude(V m, V x) {
#if HWY_TARGET == HWY_AVX3
  return V{_mm512_range_pd(m.raw, x.raw, 0b1011)};  // one instruction, for which Highway has no name: a tenth faster
#else
  return hn::Max(m, hn::Abs(x));
#endif
}

// Difference number K of the formula, before and after its axes are told apart.
template <class F, class Layout, std::size_t K>
HWY_INLINE void subtract(const V* raw, V* value, V* largest) {
  using Plan = ReplayPlan<F>;
  constexpr std::size_t dimension = Plan::dimension;
  constexpr auto pair = Plan::differences[K];
  V difference[dimension];
  for (std::size_t k = 0; k < dimension; ++k) {
    difference[k] = hn::Sub(raw[pair.left * dimension + k], raw[pair.right * dimension + k]);
  }
  Layout::template arrange<dimension>(difference);
  for (std::size_t a = 0; a < dimension; ++a) {
    value[pair.instruction[a]] = difference[a];
    if constexpr (!batch_by_magnitude<F>) largest[a] = larger_magnitude(largest[a], difference[a]);
  }
}

/// `raw`: the coordinates of the cases as they lie in memory, `dimension` vectors a point.
template <class F, class Layout, std::size_t... K, std::size_t... I>
HWY_INLINE Judged judge(const V* raw, std::index_sequence<K...>, std::index_sequence<I...>) {
  using Plan = ReplayPlan<F>;
  V value[Plan::size], magnitude[Plan::size];
  V largest[Plan::dimension];
  for (V& x : largest) x = broadcast(largest_floor<F>);
  (subtract<F, Layout, K>(raw, value, largest), ...);
  constexpr std::size_t last = Plan::size - 1;
  if constexpr (batch_by_magnitude<F>) {
    [[maybe_unused]] const bool in_turn[]{(replay_magnitude<F, I>(value, magnitude), true)...};
    return {value[last], hn::Mul(broadcast(filter_constant<F>()), magnitude[last])};
  } else {
    [[maybe_unused]] const bool in_turn[]{(replay_value<F, I>(value), true)...};
    const V threshold = threshold_over<F>(largest, std::index_sequence<I...>());
    return {value[last], hn::Add(threshold, hn::Sub(value[last], value[last]))};
  }
}

/// Judges cases whose points all differ, a vector at a time.
template <class F, class Layout>
struct ManyCases {
  using Points = Layout;
  static constexpr std::size_t dimension = ReplayPlan<F>::dimension, first_coordinate = 0, coordinates = arity<F>;

  HWY_INLINE Judged operator()(const double* const* at, std::size_t first) const {
    using Plan = ReplayPlan<F>;
    V raw[arity<F>];
    for (std::size_t k = 0; k < arity<F>; k += dimension) Layout::template load<dimension>(at + k, first, raw + k);
    return judge<F, Layout>(raw, std::make_index_sequence<Plan::count>(), std::make_index_sequence<Plan::size>());
  }
};

}  // namespace plumb::certify::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
