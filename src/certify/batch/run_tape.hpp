// What does filter A say of many cases, for a formula that is known by its tape alone?  Over Highway's vectors.
//
// The operations are those of the tape, each rounded once, and the magnitudes those of arith/filtered.hpp: so the
// constant that was derived from the formula holds in every lane.  An instruction is done for a block of cases at once.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_RUN_TAPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_RUN_TAPE
#undef PLUMB_BATCH_RUN_TAPE
#else
#define PLUMB_BATCH_RUN_TAPE
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <vector>

#include "certify/batch/tape_plan.hpp"

#if HWY_TARGET != HWY_SCALAR
#include "certify/batch/lanes.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::batch::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
inline constexpr std::size_t lanes = 1;
HWY_INLINE V broadcast(double x) { return hn::Set(D(), x); }
#endif
static_assert(block % lanes == 0);

/// A number of the tape for a block of cases; of plain ones the magnitude is not stored.
struct Operand {
  const double* value;
  const double* magnitude;
};

template <bool Plain>
HWY_INLINE V magnitude_at(const Operand& x, std::size_t i, V value) {
  if constexpr (Plain) {
    return hn::Abs(value);
  } else {
    return hn::LoadU(D(), x.magnitude + i);
  }
}

template <char Operation, bool LeftPlain, bool RightPlain>
HWY_INLINE void step(const Operand& l, const Operand& r, double* HWY_RESTRICT value, double* HWY_RESTRICT magnitude) {
  for (std::size_t i = 0; i < block; i += lanes) {
    const V a = hn::LoadU(D(), l.value + i), b = hn::LoadU(D(), r.value + i);
    const V ma = magnitude_at<LeftPlain>(l, i, a), mb = magnitude_at<RightPlain>(r, i, b);
    if constexpr (Operation == '*') {
      hn::Store(hn::Mul(a, b), D(), value + i);
      hn::Store(hn::Add(hn::Mul(ma, mb), broadcast(underflow_guard)), D(), magnitude + i);
    } else {
      hn::Store(Operation == '+' ? hn::Add(a, b) : hn::Sub(a, b), D(), value + i);
      hn::Store(hn::Add(ma, mb), D(), magnitude + i);
    }
  }
}

template <char Operation>
HWY_INLINE void plain_step(const Operand& l, const Operand& r, double* HWY_RESTRICT value) {
  for (std::size_t i = 0; i < block; i += lanes) {
    const V a = hn::LoadU(D(), l.value + i), b = hn::LoadU(D(), r.value + i);
    hn::Store(Operation == '+' ? hn::Add(a, b) : hn::Sub(a, b), D(), value + i);
  }
}

/// The numbers of a block.
class Block {
 public:
  explicit Block(const TapePlan& plan)
      : plan_(plan),
        memory_(hwy::AllocateAligned<double>((plan.arity() + 2 * plan.slots()) * block)),
        operands_(plan.arity() + plan.slots()) {
    for (std::size_t k = 0; k < plan.arity(); ++k) operands_[k] = {own(k), nullptr};
    for (std::size_t s = 0; s < plan.slots(); ++s) operands_[plan.arity() + s] = {slot(s), slot(s) + block};
  }

  /// Coordinates that are the same for all cases.
  void repeat(const double* const* at) {
    for (std::size_t k = 0; k < plan_.arity(); ++k) {
      if (plan_.stride(k) == 0) std::fill_n(own(k), block, *at[k]);
    }
  }

  /// Coordinates of `block` cases from number `first` on.
  HWY_INLINE void load(const double* const* at, std::size_t first) {
    for (std::size_t k = 0; k < plan_.arity(); k += plan_.beside(k)) {
      const std::size_t stride = plan_.stride(k);
      const double* from = at[k] + first * stride;
      if (stride == 1) {
        operands_[k].value = from;
      } else if (plan_.beside(k) == 2) {
        for (std::size_t i = 0; i < block; i += lanes) {
          V x, y;
          hn::LoadInterleaved2(D(), from + 2 * i, x, y);
          hn::Store(x, D(), own(k) + i);
          hn::Store(y, D(), own(k + 1) + i);
        }
      } else if (plan_.beside(k) == 3) {
        for (std::size_t i = 0; i < block; i += lanes) {
          V x, y, z;
          hn::LoadInterleaved3(D(), from + 3 * i, x, y, z);
          hn::Store(x, D(), own(k) + i);
          hn::Store(y, D(), own(k + 1) + i);
          hn::Store(z, D(), own(k + 2) + i);
        }
      } else if (stride != 0) {
        for (std::size_t i = 0; i < block; ++i) own(k)[i] = from[i * stride];
      }
    }
  }

  /// Coordinates of fewer cases, beside zeros.
  void load_few(const double* const* at, std::size_t first, std::size_t n) {
    for (std::size_t k = 0; k < plan_.arity(); ++k) {
      const std::size_t stride = plan_.stride(k);
      if (stride == 0) continue;
      operands_[k].value = own(k);
      for (std::size_t i = 0; i < block; ++i) own(k)[i] = i < n ? at[k][(first + i) * stride] : 0.0;
    }
  }

  HWY_INLINE void run() {
    using enum StepKind;
    for (const TapeStep& s : plan_.steps()) {
      const Operand &l = operands_[s.left], &r = operands_[s.right];
      double* const value = slot(s.to - plan_.arity());
      double* const magnitude = value + block;
      switch (s.kind) {
        case plain_sum:
          plain_step<'+'>(l, r, value);
          break;
        case plain_difference:
          plain_step<'-'>(l, r, value);
          break;
        case sum_of_plains:
          step<'+', true, true>(l, r, value, magnitude);
          break;
        case sum_of_plain_and_any:
          step<'+', true, false>(l, r, value, magnitude);
          break;
        case sum:
          step<'+', false, false>(l, r, value, magnitude);
          break;
        case difference_of_plains:
          step<'-', true, true>(l, r, value, magnitude);
          break;
        case difference_of_plain_and_any:
          step<'-', true, false>(l, r, value, magnitude);
          break;
        case difference_of_any_and_plain:
          step<'-', false, true>(l, r, value, magnitude);
          break;
        case difference:
          step<'-', false, false>(l, r, value, magnitude);
          break;
        case product_of_plains:
          step<'*', true, true>(l, r, value, magnitude);
          break;
        case product_of_plain_and_any:
          step<'*', true, false>(l, r, value, magnitude);
          break;
        case product:
          step<'*', false, false>(l, r, value, magnitude);
          break;
      }
    }
  }

  /// Writes the signs of the first n cases, and appends to the list the numbers of those that are unsure, the first of
  /// them being number `first`; returns the list's end.
  HWY_INLINE std::uint32_t* judge(std::size_t first, std::size_t n, signed char* out, std::uint32_t* list) const {
    const double* const value = operands_[plan_.result()].value;
    const double* const magnitude = plan_.result_is_plain() ? nullptr : operands_[plan_.result()].magnitude;
    const V constant = broadcast(plan_.constant());
    signed char signs[block];
    for (std::size_t i = 0; i < block; i += lanes) {
      const V v = hn::Load(D(), value + i);
      const V m = magnitude == nullptr ? hn::Abs(v) : hn::Load(D(), magnitude + i);
      const V threshold = hn::Mul(constant, m);
#if HWY_TARGET == HWY_SCALAR
      signs[i] = static_cast<signed char>(beyond(hn::GetLane(v), hn::GetLane(threshold)));
      if (i < n && signs[i] == 0) *list++ = static_cast<std::uint32_t>(first + i);
#else
      const unsigned unsure = store_signs<ArraysOfCoordinates, 1>({v, threshold}, signs + i);
      if (HWY_UNLIKELY(unsure != 0))
        list = list_cases<ArraysOfCoordinates, 1>(unsure, first + i, first, first + n, list);
#endif
    }
    std::copy_n(signs, n, out + first);
    return list;
  }

 private:
  double* own(std::size_t coordinate) { return memory_.get() + coordinate * block; }
  double* slot(std::size_t s) { return memory_.get() + (plan_.arity() + 2 * s) * block; }

  const TapePlan& plan_;
  hwy::AlignedFreeUniquePtr<double[]> memory_;
  std::vector<Operand> operands_;
};

std::size_t run_tape(const void* plan, const double* const* at, std::size_t n, signed char* out,
                     std::uint32_t* unsure) {
  Block cases(*static_cast<const TapePlan*>(plan));
  cases.repeat(at);
  std::uint32_t* next = unsure;
  for (std::size_t first = 0; first < n; first += block) {
    const std::size_t count = std::min(block, n - first);
    if (count == block) {
      cases.load(at, first);
    } else {
      cases.load_few(at, first, count);
    }
    cases.run();
    next = cases.judge(first, count, out, next);
  }
  return static_cast<std::size_t>(next - unsure);
}

}  // namespace
}  // namespace plumb::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
