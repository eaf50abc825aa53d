// How is filter A run over vectors of PLUMB_LANES_BYTES?  Included by certify/detail/block_filter.hpp, for each width once.
//
// GCC's and Clang's vectors, unrolled from the tape: loops of doubles the two turn into vectors for some formulas and
// not for others.  All functions are of the namespace PLUMB_LANES and compiled for its processors; hence no #pragma
// once.  No vector is passed by value, which would depend on the caller's processor.
#ifdef PLUMB_LANES

namespace plumb::certify::batch::PLUMB_LANES {

using Vector [[gnu::vector_size(PLUMB_LANES_BYTES)]] = double;
using Bits [[gnu::vector_size(PLUMB_LANES_BYTES)]] = long long;
using InMemory [[gnu::vector_size(PLUMB_LANES_BYTES), gnu::aligned(alignof(double)), gnu::may_alias]] = double;
inline constexpr std::size_t lanes = PLUMB_LANES_BYTES / sizeof(double);
static_assert(block % lanes == 0);

PLUMB_LANES_TARGET [[gnu::always_inline]] inline void set_magnitude(const Vector& x, Vector& to) {
  to = reinterpret_cast<Vector>(reinterpret_cast<Bits>(x) & 0x7fff'ffff'ffff'ffffll);
}
PLUMB_LANES_TARGET [[gnu::always_inline]] inline void multiply(const Vector& a, const Vector& b, Vector& to) {
  Vector product = a * b;
  PLUMB_KEEP_ROUNDED(product);
  to = product;
}

/// Number `arity + I` of the tape, with its magnitude where it is not the value's own (arith/filtered.hpp).
template <Formula F, std::size_t I>
PLUMB_LANES_TARGET [[gnu::always_inline]] inline void step(Vector* value, Vector* magnitude) {
  constexpr certify::tape::Instruction in = certify::tape::of<F>.instructions[I];
  constexpr std::size_t l = in.left, r = in.right, to = arity<F> + I;
  constexpr bool of_plain = is_plain_number<F>(l) && is_plain_number<F>(r);
  if constexpr (!is_plain_number<F>(to) && !(of_plain && in.operation == '*')) {
    if constexpr (is_plain_number<F>(l)) set_magnitude(value[l], magnitude[l]);
    if constexpr (is_plain_number<F>(r)) set_magnitude(value[r], magnitude[r]);
  }
  if constexpr (in.operation == '*') {
    multiply(value[l], value[r], value[to]);
    if constexpr (of_plain) {
      set_magnitude(value[to], magnitude[to]);
    } else {
      multiply(magnitude[l], magnitude[r], magnitude[to]);
    }
    magnitude[to] += underflow_guard;
  } else {
    value[to] = in.operation == '-' ? value[l] - value[r] : value[l] + value[r];
    if constexpr (!is_plain_number<F>(to)) magnitude[to] = magnitude[l] + magnitude[r];
  }
}

template <Formula F, std::size_t... K, std::size_t... I>
PLUMB_LANES_TARGET [[gnu::always_inline]] inline void filter_vectors(const double* const* at, double* value_to,
                                                                     double* threshold_to, std::index_sequence<K...>,
                                                                     std::index_sequence<I...>) {
  constexpr std::size_t last = arity<F> + sizeof...(I) - 1;
  const double* const from[]{at[K]...};
  for (std::size_t i = 0; i < block; i += lanes) {
    Vector value[last + 1], magnitude[last + 1];
    [[maybe_unused]] const bool loaded[]{((value[K] = *reinterpret_cast<const InMemory*>(from[K] + i)), true)...};
    [[maybe_unused]] const bool in_turn[]{(step<F, I>(value, magnitude), true)...};
    if constexpr (is_plain_number<F>(last)) set_magnitude(value[last], magnitude[last]);
    *reinterpret_cast<InMemory*>(value_to + i) = value[last];
    *reinterpret_cast<InMemory*>(threshold_to + i) = magnitude[last] * filter_constant<F>();
  }
}

template <Formula F>
PLUMB_LANES_TARGET [[gnu::noinline]] void filter_block(const double* const* at, double* value, double* threshold) {
  filter_vectors<F>(at, value, threshold, std::make_index_sequence<arity<F>>(),
                    std::make_index_sequence<certify::tape::of<F>.size>());
}

}  // namespace plumb::certify::batch::PLUMB_LANES

#endif
