#include "plumb/figure/aabb/box_batch.hpp"

#include <cstring>

#include "certify/batch/instruction_sets.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/aabb/box_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::box_batch::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

constexpr auto byte_table = [] {
  std::array<std::uint32_t, 16> table{};
  for (std::uint32_t bits = 0; bits < 16; ++bits) {
    for (std::uint32_t i = 0; i < 4; ++i) table[bits] |= (bits >> i & 1u) << (8 * i);
  }
  return table;
}();

// N bits to N bytes.
template <std::size_t N>
void put(unsigned bits, std::uint8_t* out) {
  if constexpr (N <= 4) {
    std::memcpy(out, &byte_table[bits & 15u], N);
  } else {
    put<4>(bits, out);
    put<N - 4>(bits >> 4, out + 4);
  }
}

template <class Mask>
unsigned bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}

// Number k of item i: of the arrays a[k], or of one item, for which a[k] is that of all.
template <bool one>
V load(const double* const* a, std::size_t k, std::size_t i) {
  if constexpr (one) {
    return hn::Set(D(), *a[k]);
  } else {
    return hn::LoadU(D(), a[k] + i);
  }
}

template <bool one>
void boxes(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  const auto meet = [&](std::size_t i) {
    const auto reaches = [&](std::size_t k) {
      const V from = hn::Max(load<one>(a, k, i), load<false>(b, k, i));
      const V to = hn::Min(load<one>(a, k + 3, i), load<false>(b, k + 3, i));
      return hn::Le(from, to);
    };
    return bits_of(hn::And(hn::And(reaches(0), reaches(1)), reaches(2)));
  };
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes) put<lanes>(meet(i), out + i);
  for (; i < n; ++i) {
    bool meets = true;
    const std::size_t at = one ? 0 : i;
    for (std::size_t k = 0; k < 3; ++k) {
      const double from = a[k][at] > b[k][i] ? a[k][at] : b[k][i],
                   to = a[k + 3][at] < b[k + 3][i] ? a[k + 3][at] : b[k + 3][i];
      meets &= from <= to;
    }
    out[i] = meets;
  }
}

// As figure::sphere::gap, operation by operation.
using Apart = decltype(figure::sphere::square_of_distance(Point3{}, Point3{}));
using Reach = decltype(figure::sphere::square_of_reach(0, 0));
constexpr double doubtful_part = arith::squares::doubtful_part<Apart::error, Reach::error>;
constexpr double doubtful_guard = arith::squares::doubtful_guard<Apart::error, Reach::error>;

// The number of pairs in doubt, which are listed.
template <bool one>
std::size_t spheres(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out,
                    std::uint32_t* unsure) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  std::size_t count = 0, i = 0;
  for (; i + lanes <= n; i += lanes) {
    const V x = hn::Sub(load<one>(a, 0, i), load<false>(b, 0, i)),
            y = hn::Sub(load<one>(a, 1, i), load<false>(b, 1, i));
    const V z = hn::Sub(load<one>(a, 2, i), load<false>(b, 2, i)),
            r = hn::Add(load<one>(a, 3, i), load<false>(b, 3, i));
    const V distance = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z)), reach = hn::Mul(r, r);
    const V value = hn::Sub(distance, reach);
    const V doubt =
        hn::Add(hn::Mul(hn::Set(D(), doubtful_part), hn::Add(distance, reach)), hn::Set(D(), doubtful_guard));
    put<lanes>(bits_of(hn::Lt(value, hn::Zero(D()))), out + i);
    unsigned open = ~bits_of(hn::Gt(hn::Abs(value), doubt)) & ((1u << lanes) - 1);
    for (; open != 0; open &= open - 1)
      unsure[count++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(open));
  }
  for (; i < n; ++i) unsure[count++] = static_cast<std::uint32_t>(i);
  return count;
}

void many_boxes(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out) {
  boxes<false>(a, b, n, out);
}
void one_box(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out) {
  boxes<true>(a, b, n, out);
}
std::size_t many_spheres(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out,
                         std::uint32_t* unsure) {
  return spheres<false>(a, b, n, out, unsure);
}
std::size_t one_sphere(const double* const* a, const double* const* b, std::size_t n, std::uint8_t* out,
                       std::uint32_t* unsure) {
  return spheres<true>(a, b, n, out, unsure);
}

}  // namespace
}  // namespace plumb::figure::box_batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <string>

#include "certify/batch/chosen_target.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb {
namespace figure::box_batch {
namespace {

PLUMB_EXPORT(many_boxes);
PLUMB_EXPORT(one_box);
PLUMB_EXPORT(many_spheres);
PLUMB_EXPORT(one_sphere);

constexpr std::size_t chunk = 1024;

void require_length(std::size_t n, std::size_t of_b, std::string_view b, std::size_t of_out) {
  const auto refuse = [&](std::string_view name, std::size_t length) {
    throw UnequalLengths(std::string("intersects: ")
                             .append(name)
                             .append(" has ")
                             .append(std::to_string(length))
                             .append(" items, not ")
                             .append(std::to_string(n)));
  };
  if (of_b != n) refuse(b, of_b);
  if (of_out != n) refuse("out", of_out);
}

template <std::size_t n, class Batch>
std::array<const double*, n> numbers(const Batch& batch, std::size_t from = 0) {
  std::array<const double*, n> at{};
  for (std::size_t k = 0; k < n; ++k) at[k] = batch.numbers(k) + from;
  return at;
}

template <class Ask, class Exactly>
void in_chunks(std::size_t n, Ask ask, Exactly exactly) {
  std::array<std::uint32_t, chunk> unsure;
  for (std::size_t from = 0; from < n; from += chunk) {
    const std::size_t count = ask(from, n - from < chunk ? n - from : chunk, unsure.data());
    for (std::size_t u = 0; u < count; ++u) exactly(from + unsure[u]);
  }
}

}  // namespace
}  // namespace figure::box_batch

FourBoxes::FourBoxes(const std::array<Aabb3, 4>& boxes) : min_{}, max_{} {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [min, max] = boxes[i];
    if (!figure::is_sound(boxes[i]))
      figure::refuse("FourBoxes", std::string("boxes[").append(std::to_string(i)).append("]"), boxes[i]);
    min_[0][i] = min.x, min_[1][i] = min.y, min_[2][i] = min.z;
    max_[0][i] = max.x, max_[1][i] = max.y, max_[2][i] = max.z;
  }
}

BoxBatch::BoxBatch(std::span<const Aabb3> boxes) {
  for (auto& numbers : of_) numbers.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::array all{boxes[i].min.x, boxes[i].min.y, boxes[i].min.z,
                         boxes[i].max.x, boxes[i].max.y, boxes[i].max.z};
    double zero = 0;
    for (std::size_t k = 0; k < 6; ++k) of_[k].push_back(all[k]), zero += all[k] - all[k];
    if (zero == 0) continue;
    figure::refuse("BoxBatch", std::string("boxes[").append(std::to_string(i)).append("]"), boxes[i]);
  }
}

SphereBatch::SphereBatch(std::span<const Sphere3> spheres) {
  for (auto& numbers : of_) numbers.reserve(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& [center, radius] = spheres[i];
    const std::array all{center.x, center.y, center.z, radius};
    double zero = 0;
    for (std::size_t k = 0; k < 4; ++k) of_[k].push_back(all[k]), zero += all[k] - all[k];
    if (zero == 0 && radius >= 0) continue;
    figure::refuse("SphereBatch", std::string("spheres[").append(std::to_string(i)).append("]"), spheres[i]);
  }
}

void intersects(const BoxBatch& a, const BoxBatch& b, std::span<std::uint8_t> out) {
  figure::box_batch::require_length(a.size(), b.size(), "b", out.size());
  const auto at_a = figure::box_batch::numbers<6>(a), at_b = figure::box_batch::numbers<6>(b);
  PLUMB_DISPATCH(figure::box_batch::many_boxes)(at_a.data(), at_b.data(), out.size(), out.data());
}

void intersects(const Aabb3& one, const BoxBatch& many, std::span<std::uint8_t> out) {
  figure::box_batch::require_length(many.size(), many.size(), "many", out.size());
  figure::require_sound("intersects", "one", one);
  const auto at = figure::box_batch::numbers<6>(many);
  const std::array<const double*, 6> of_one{&one.min.x, &one.min.y, &one.min.z, &one.max.x, &one.max.y, &one.max.z};
  PLUMB_DISPATCH(figure::box_batch::one_box)(of_one.data(), at.data(), out.size(), out.data());
}

void intersects(const SphereBatch& a, const SphereBatch& b, std::span<std::uint8_t> out) {
  figure::box_batch::require_length(a.size(), b.size(), "b", out.size());
  figure::box_batch::in_chunks(
      out.size(),
      [&](std::size_t from, std::size_t n, std::uint32_t* unsure) {
        const auto at_a = figure::box_batch::numbers<4>(a, from), at_b = figure::box_batch::numbers<4>(b, from);
        return PLUMB_DISPATCH(figure::box_batch::many_spheres)(at_a.data(), at_b.data(), n, out.data() + from, unsure);
      },
      [&](std::size_t i) { out[i] = intersects(a[i], b[i]); });
}

void intersects(const Sphere3& one, const SphereBatch& many, std::span<std::uint8_t> out) {
  figure::box_batch::require_length(many.size(), many.size(), "many", out.size());
  figure::require_sound("intersects", "one", one);
  const std::array<const double*, 4> of_one{&one.center.x, &one.center.y, &one.center.z, &one.radius};
  figure::box_batch::in_chunks(
      out.size(),
      [&](std::size_t from, std::size_t n, std::uint32_t* unsure) {
        const auto at = figure::box_batch::numbers<4>(many, from);
        return PLUMB_DISPATCH(figure::box_batch::one_sphere)(of_one.data(), at.data(), n, out.data() + from, unsure);
      },
      [&](std::size_t i) { out[i] = intersects(one, many[i]); });
}

}  // namespace plumb
#endif
