// What does the filter of one line, plane, circle or sphere say of many points?  Side's filter over Highway's vectors.
//
// The operations are those of Side::filter (certify/side.hpp) in its order, so that its constant holds in every lane.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_AGAINST_ONE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_AGAINST_ONE
#undef PLUMB_BATCH_AGAINST_ONE
#else
#define PLUMB_BATCH_AGAINST_ONE
#endif

#include <hwy/highway.h>

#include <utility>

#include "certify/batch/lanes.hpp"
#include "plumb/certify/side.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::batch::HWY_NAMESPACE {

struct Magnified {
  V value, magnitude;
};

template <class F, class Layout>
struct AgainstOne {
  using Points = Layout;
  static constexpr std::size_t dimension = Side<F>::dimension, variables = Side<F>::variables;
  static constexpr std::size_t coordinates = arity<F>, first_coordinate = coordinates - dimension;

  V pivot[dimension];
  Magnified coefficient[variables];

  HWY_INLINE explicit AgainstOne(const Side<F>& side) {
    double point[dimension];
    for (std::size_t a = 0; a < dimension; ++a) point[a] = side.pivot(a);
    Layout::template repeat<dimension>(point, pivot);
    for (std::size_t v = 0; v < variables; ++v) {
      coefficient[v] = {broadcast(side.coefficient(v)), broadcast(side.magnitude(v))};
    }
  }

  HWY_INLINE Judged operator()(const double* const* at, std::size_t first) const {
    V d[dimension];
    Layout::template load<dimension>(at + first_coordinate, first, d);
    for (std::size_t k = 0; k < dimension; ++k) d[k] = hn::Sub(d[k], pivot[k]);
    Layout::template arrange<dimension>(d);
    Magnified number[dimension + certify::side::form_of<F>.query.size];
    for (std::size_t a = 0; a < dimension; ++a) number[a] = {d[a], hn::Abs(d[a])};
    run(number, std::make_index_sequence<certify::side::form_of<F>.query.size>());
    return sum_of(number, std::make_index_sequence<variables - 1>());
  }

 private:
  template <std::size_t... I>
  static HWY_INLINE void run([[maybe_unused]] Magnified* number, std::index_sequence<I...>) {
    (instruction<I>(number), ...);
  }

  template <std::size_t I>
  static HWY_INLINE void instruction(Magnified* number) {
    constexpr certify::tape::Instruction in = certify::side::form_of<F>.query.instructions[I];
    constexpr bool of_differences = in.left < dimension && in.right < dimension;
    static_assert(in.operation == '+' || (in.operation == '*' && of_differences), "a query takes sums of products");
    const Magnified &l = number[in.left], &r = number[in.right];
    if constexpr (in.operation == '+') {
      number[dimension + I] = {hn::Add(l.value, r.value), hn::Add(l.magnitude, r.magnitude)};
    } else {
      const V product = hn::Mul(l.value, r.value);
      number[dimension + I] = {product, hn::Add(hn::Abs(product), broadcast(underflow_guard))};
    }
  }

  // The magnitude alone may be fused: it rounds once where Side rounds twice, and so is no worse a bound.
  template <std::size_t... W>
  HWY_INLINE Judged sum_of(const Magnified* number, std::index_sequence<W...>) const {
    constexpr const auto& variable = certify::side::form_of<F>.variable;
    V value = hn::Mul(number[variable[0]].value, coefficient[0].value);
    V magnitude =
        hn::MulAdd(number[variable[0]].magnitude, coefficient[0].magnitude, broadcast(certify::side::guards<F>));
    ((value = hn::Add(value, hn::Mul(number[variable[W + 1]].value, coefficient[W + 1].value)),
      magnitude = hn::MulAdd(number[variable[W + 1]].magnitude, coefficient[W + 1].magnitude, magnitude)),
     ...);
    return {value, hn::Mul(broadcast(certify::side::constant<F>), magnitude)};
  }
};

}  // namespace plumb::certify::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
