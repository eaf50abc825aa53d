// What does filter A say of many cases, for a formula whose filter of a block (certify/detail/block_filter.hpp) who asks has
// compiled?  The coordinates of a block go to arrays of their own where they have none, and signs come out.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BATCH_RUN_BLOCKS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BATCH_RUN_BLOCKS
#undef PLUMB_BATCH_RUN_BLOCKS
#else
#define PLUMB_BATCH_RUN_BLOCKS
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <memory>
#include <new>

#include "certify/batch/cases.hpp"

#if HWY_TARGET != HWY_SCALAR
#include "certify/batch/lanes.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::batch::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
inline constexpr std::size_t lanes = 1;
HWY_INLINE V broadcast(double x) { return hn::Set(D(), x); }
#endif
static_assert(block % lanes == 0);

constexpr BlockFilter filter_of(const BlockFilters& all) {
#if HWY_TARGET == HWY_AVX3
  return all.avx512;
#elif HWY_TARGET == HWY_AVX2
  return all.avx2;
#else
  return all.any_processor;
#endif
}

/// Where a block's coordinates are, and what its filter says.
class Block {
 public:
  explicit Block(const BatchFormula& asked, std::span<const Column> columns)
      : columns_(columns),
        filter_(filter_of(asked.filters)),
        memory_(new (alignment) double[(columns.size() + 2) * block]) {
    for (std::size_t k = 0; k < columns_.size(); ++k) from_[k] = own(k);
  }

  /// Coordinates that are the same for all cases.
  void repeat(const double* const* at) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].stride == 0) std::fill_n(own(k), block, *at[k]);
    }
  }

  /// Coordinates of `block` cases from number `first` on.
  HWY_INLINE void load(const double* const* at, std::size_t first) {
    for (std::size_t k = 0; k < columns_.size(); k += beside(k)) {
      const std::size_t stride = columns_[k].stride;
      const double* from = at[k] + first * stride;
      if (stride == 1) {
        from_[k] = from;
      } else if (beside(k) == 2) {
        for (std::size_t i = 0; i < block; i += lanes) {
          V x, y;
          hn::LoadInterleaved2(D(), from + 2 * i, x, y);
          hn::Store(x, D(), own(k) + i);
          hn::Store(y, D(), own(k + 1) + i);
        }
      } else if (beside(k) == 3) {
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
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const std::size_t stride = columns_[k].stride;
      if (stride == 0) continue;
      from_[k] = own(k);
      for (std::size_t i = 0; i < block; ++i) own(k)[i] = i < n ? at[k][(first + i) * stride] : 0.0;
    }
  }

  void run() { filter_(from_.data(), values(), thresholds()); }

  /// Writes the signs of the first n cases, and appends to the list the numbers of those that are unsure, the first of
  /// them being number `first`; returns the list's end.
  HWY_INLINE std::uint32_t* judge(std::size_t first, std::size_t n, signed char* out, std::uint32_t* list) const {
    signed char signs[block];
    for (std::size_t i = 0; i < block; i += lanes) {
      const V value = hn::Load(D(), values() + i), threshold = hn::Load(D(), thresholds() + i);
#if HWY_TARGET == HWY_SCALAR
      signs[i] = static_cast<signed char>(beyond(hn::GetLane(value), hn::GetLane(threshold)));
      if (i < n && signs[i] == 0) *list++ = static_cast<std::uint32_t>(first + i);
#else
      const unsigned unsure = store_signs<ArraysOfCoordinates, 1>({value, threshold}, signs + i);
      if (HWY_UNLIKELY(unsure != 0))
        list = list_cases<ArraysOfCoordinates, 1>(unsure, first + i, first, first + n, list);
#endif
    }
    std::copy_n(signs, n, out + first);
    return list;
  }

 private:
  static constexpr std::align_val_t alignment{128};  // two cache lines, as processors fetch them
  struct Freed {
    void operator()(double* memory) const { ::operator delete[](memory, alignment); }
  };

  double* own(std::size_t coordinate) { return memory_.get() + coordinate * block; }
  [[nodiscard]] double* values() const { return memory_.get() + columns_.size() * block; }
  [[nodiscard]] double* thresholds() const { return values() + block; }
  /// How many coordinates from this one on lie beside one another, item after item: 2 or 3; otherwise 1.
  [[nodiscard]] std::size_t beside(std::size_t coordinate) const {
    const Column& c = columns_[coordinate];
    return !c.apart && (c.stride == 2 || c.stride == 3) ? c.stride : 1;
  }

  std::span<const Column> columns_;
  BlockFilter filter_;
  std::unique_ptr<double[], Freed> memory_;
  std::array<const double*, most_coordinates> from_;
};

std::size_t run_blocks(const void* given, const double* const* at, std::size_t n, signed char* out,
                       std::uint32_t* unsure) {
  const auto& [asked, columns] = *static_cast<const AskedColumns*>(given);
  Block cases(*asked, columns);
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
}  // namespace plumb::certify::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // for this instruction set
