// What does filter A say of 64 cases at once?  A formula's own code over vectors, compiled where it is asked for.
//
// Laws: value and threshold of each case are those that magnitude_filter (certify/detail/filter_stage.hpp) compares: the
// operations are those of the formula's tape, each rounded once whatever the compiler would fuse, and the constant is
// the one derived from it.  Compiled for each width of vectors that a processor may have; who calls chooses.
// Source: RTCD 13.7, docs/batches.md.
// Cost: the formula's operations and about as many again for the magnitudes, in registers.
#pragma once

#include <cstddef>
#include <utility>

#include "plumb/arith/filtered.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb::certify::batch {

/// Cases a block.
inline constexpr std::size_t block = 64;

/// Takes for each coordinate where its values of the block begin.  `value` and `threshold` begin at multiples of 64
/// bytes.
using BlockFilter = void (*)(const double* const* at, double* value, double* threshold);

/// Is the magnitude of a number of the tape that of its value?  Of coordinates, and of sums and differences of two.
template <Formula F>
constexpr bool is_plain_number(std::size_t number) {
  if (number < arity<F>) return true;
  const certify::tape::Instruction in = certify::tape::of<F>.instructions[number - arity<F>];
  return in.operation != '*' && in.left < arity<F> && in.right < arity<F>;
}

}  // namespace plumb::certify::batch

// The product as it is rounded: no compiler sees through this to fuse it with a sum.
#if defined(__x86_64__)
#define PLUMB_KEEP_ROUNDED(vector) __asm__("" : "+v"(vector))
#elif defined(__aarch64__)
#define PLUMB_KEEP_ROUNDED(vector) __asm__("" : "+w"(vector))
#else
#define PLUMB_KEEP_ROUNDED(vector)  // -ffp-contract=off, which the target brings along
#endif

#define PLUMB_LANES any_processor
#define PLUMB_LANES_BYTES 16
#define PLUMB_LANES_TARGET
#include "plumb/certify/detail/block_filter_lanes.hpp"
#undef PLUMB_LANES
#undef PLUMB_LANES_BYTES
#undef PLUMB_LANES_TARGET

#ifdef __x86_64__
#define PLUMB_LANES avx2
#define PLUMB_LANES_BYTES 32
#define PLUMB_LANES_TARGET [[gnu::target("avx2")]]
#include "plumb/certify/detail/block_filter_lanes.hpp"
#undef PLUMB_LANES
#undef PLUMB_LANES_BYTES
#undef PLUMB_LANES_TARGET

#define PLUMB_LANES avx512
#define PLUMB_LANES_BYTES 64
#define PLUMB_LANES_TARGET [[gnu::target("avx512f")]]
#include "plumb/certify/detail/block_filter_lanes.hpp"
#undef PLUMB_LANES
#undef PLUMB_LANES_BYTES
#undef PLUMB_LANES_TARGET
#endif
#undef PLUMB_KEEP_ROUNDED

namespace plumb::certify::batch {

/// A formula's filter for each width of vectors.
struct BlockFilters {
  BlockFilter any_processor, avx2, avx512;
};

template <Formula F>
constexpr BlockFilters block_filters() {
#ifdef __x86_64__
  return {any_processor::filter_block<F>, avx2::filter_block<F>, avx512::filter_block<F>};
#else
  return {any_processor::filter_block<F>, any_processor::filter_block<F>, any_processor::filter_block<F>};
#endif
}

}  // namespace plumb::certify::batch
