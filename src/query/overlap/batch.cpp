#include "plumb/query/overlap/batch.hpp"

#include <cstring>

#include "certify/batch/instruction_sets.hpp"
#include "query/overlap/box_gaps.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/shapes3.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/overlap/batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::query::overlap_batch::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

constexpr std::size_t lanes = hn::MaxLanes(D());

struct Vector {
  V x, y, z;
};
Vector operator-(const Vector& a, const Vector& b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
Vector operator+(const Vector& a, const Vector& b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
Vector all(double x, double y, double z) { return {hn::Set(D(), x), hn::Set(D(), y), hn::Set(D(), z)}; }
Vector load(const double* const* at, std::size_t k, std::size_t i) {
  return {hn::LoadU(D(), at[k] + i), hn::LoadU(D(), at[k + 1] + i), hn::LoadU(D(), at[k + 2] + i)};
}
Vector abs(const Vector& a) { return {hn::Abs(a.x), hn::Abs(a.y), hn::Abs(a.z)}; }
Vector max(const Vector& a, const Vector& b) { return {hn::Max(a.x, b.x), hn::Max(a.y, b.y), hn::Max(a.z, b.z)}; }
Vector min(const Vector& a, const Vector& b) { return {hn::Min(a.x, b.x), hn::Min(a.y, b.y), hn::Min(a.z, b.z)}; }
V dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
Vector cross(const Vector& a, const Vector& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}

// Seen from the center of the box, twice as large.
using EdgeGap = query::box_gaps::EdgeBesideBox<query::box_gaps::BesideCenter>;
using NormalGap = query::box_gaps::NormalBesideBox<query::box_gaps::BesideCenter>;

// The bounds of the errors, for numbers of up to so much in each axis; NaN where a product might overflow.
struct Errors {
  Vector planes;
  V space;

  explicit Errors(const Vector& most) {
    constexpr double floor = largest_floor<NormalGap>, slack = 1 + 0x1p-40;
    const V plane = hn::Set(D(), largest_threshold<EdgeGap>({1, 1, 1}) * slack);
    const V of_space = hn::Set(D(), largest_threshold<NormalGap>({1, 1, 1}) * slack);
    const Vector l = most + most + all(floor, floor, floor);
    const V sum = hn::Mul(hn::Add(hn::Add(l.x, l.y), l.z), hn::Set(D(), 64));
    const V cube = hn::Mul(hn::Mul(sum, sum), sum), doubt = hn::Sub(cube, cube);
    const V yz = hn::Mul(l.y, l.z);
    planes = {hn::Add(hn::Mul(plane, yz), doubt), hn::Add(hn::Mul(plane, hn::Mul(l.z, l.x)), doubt),
              hn::Add(hn::Mul(plane, hn::Mul(l.x, l.y)), doubt)};
    space = hn::Add(hn::Mul(of_space, hn::Mul(yz, l.x)), doubt);
  }
};

/// What is told: apart along some axis, or meeting along all.
struct GapMasks {
  M apart, meet;

  void add(V gap, V error) {
    apart = hn::Or(apart, hn::Gt(gap, error));
    meet = hn::And(meet, hn::Lt(gap, hn::Neg(error)));
  }
};

// Along the axes of the box: exact.
GapMasks along_axes(const Vector& low, const Vector& high, const Vector& min_of, const Vector& max_of) {
  const Vector gaps = max(low - max_of, min_of - high);
  const V most = hn::Max(hn::Max(gaps.x, gaps.y), gaps.z);
  return {hn::Gt(most, hn::Zero(D())), hn::Lt(most, hn::Zero(D()))};
}

// Along the three cross products with one edge; a triangle has its normal to add.
Vector gaps_across(const Vector& e, const Vector& p, const Vector& half, const Vector& n, const Vector& size_n) {
  const Vector s = abs(e);
  const Vector reach{hn::Add(hn::Mul(s.y, half.z), hn::Mul(s.z, half.y)),
                     hn::Add(hn::Mul(s.z, half.x), hn::Mul(s.x, half.z)),
                     hn::Add(hn::Mul(s.x, half.y), hn::Mul(s.y, half.x))};
  return abs(cross(e, p) + n) - (size_n + reach);
}

template <class Mask>
unsigned bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(D(), mask, bits);
  return bits[0];
}

// Writes the answers for `lanes` items from i on, and lists those in doubt.
std::size_t put(const GapMasks& told, std::size_t i, std::uint8_t* out, std::uint32_t* unsure, std::size_t count) {
  const unsigned meet = bits_of(told.meet);
  for (std::size_t k = 0; k < lanes; ++k) out[i + k] = static_cast<std::uint8_t>(meet >> k & 1u);
  unsigned open = ~(meet | bits_of(told.apart)) & ((1u << lanes) - 1);
  for (; open != 0; open &= open - 1)
    unsure[count++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(open));
  return count;
}

std::size_t triangles(const Aabb3& box, const double* const* at, std::size_t n, std::uint8_t* out,
                      std::uint32_t* unsure) {
  const auto& [low, high] = box;
  const Vector min_of = all(low.x, low.y, low.z), max_of = all(high.x, high.y, high.z);
  const Vector center = min_of + max_of, half = max_of - min_of, of_box = max(abs(min_of), abs(max_of));
  std::size_t count = 0, i = 0;
  for (; i + lanes <= n; i += lanes) {
    const Vector a = load(at, 0, i), b = load(at, 3, i), c = load(at, 6, i);
    GapMasks told = along_axes(min(min(a, b), c), max(max(a, b), c), min_of, max_of);
    if (hn::AllTrue(D(), told.apart)) {
      std::memset(out + i, 0, lanes);
      continue;
    }
    const Errors error(max(max(abs(a), abs(b)), max(abs(c), of_box)));
    const Vector ab = b - a, bc = c - b, ca = a - c, n_abc = cross(ab, bc), size_n = abs(n_abc);
    const Vector at_a = a + a - center;
    const Vector gaps =
        max(gaps_across(ab, at_a, half, n_abc, size_n), max(gaps_across(bc, b + b - center, half, n_abc, size_n),
                                                            gaps_across(ca, c + c - center, half, n_abc, size_n)));
    told.add(gaps.x, error.planes.x);
    told.add(gaps.y, error.planes.y);
    told.add(gaps.z, error.planes.z);
    told.add(hn::Sub(hn::Abs(dot(n_abc, at_a)), dot(size_n, half)), error.space);
    count = put(told, i, out, unsure, count);
  }
  for (; i < n; ++i) unsure[count++] = static_cast<std::uint32_t>(i);
  return count;
}

std::size_t boxes(const Segment3& s, const double* const* at, std::size_t n, std::uint8_t* out, std::uint32_t* unsure) {
  const Vector a = all(s.a.x, s.a.y, s.a.z), b = all(s.b.x, s.b.y, s.b.z), sum = a + b, d = b - a;
  const Vector low = min(a, b), high = max(a, b), of_segment = max(abs(a), abs(b)), zero = all(0, 0, 0);
  const V none = hn::Set(D(), -std::numeric_limits<double>::infinity());
  const auto parallel = [](double j, double k) { return j == 0 && k == 0; };
  const Difference way = query::difference(s.a, s.b);
  std::size_t count = 0, i = 0;
  for (; i + lanes <= n; i += lanes) {
    const Vector min_of = load(at, 0, i), max_of = load(at, 3, i);
    GapMasks told = along_axes(low, high, min_of, max_of);
    if (hn::AllTrue(D(), told.apart)) {
      std::memset(out + i, 0, lanes);
      continue;
    }
    const Errors error(max(of_segment, max(abs(min_of), abs(max_of))));
    const Vector gaps = gaps_across(d, sum - (min_of + max_of), max_of - min_of, zero, zero);
    told.add(parallel(way.y, way.z) ? none : gaps.x, error.planes.x);
    told.add(parallel(way.z, way.x) ? none : gaps.y, error.planes.y);
    told.add(parallel(way.x, way.y) ? none : gaps.z, error.planes.z);
    const Vector extent = max_of - min_of;  // a box that is empty is left to the scalar test
    const V least = hn::Min(hn::Min(extent.x, extent.y), extent.z);
    told.meet = hn::And(told.meet, hn::Ge(least, hn::Zero(D())));
    count = put(told, i, out, unsure, count);
  }
  for (; i < n; ++i) unsure[count++] = static_cast<std::uint32_t>(i);
  return count;
}

}  // namespace
}  // namespace plumb::query::overlap_batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <string>

#include "certify/batch/chosen_target.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/figure_input.hpp"

namespace plumb {
namespace query::overlap_batch {
namespace {

HWY_EXPORT(triangles);
HWY_EXPORT(boxes);

constexpr std::size_t chunk = 1024;

void require_length(std::size_t n, std::size_t of_out) {
  if (n == of_out) return;
  throw UnequalLengths(std::string("intersects: out has ")
                           .append(std::to_string(of_out))
                           .append(" items, many has ")
                           .append(std::to_string(n)));
}

template <std::size_t n, class One, class Batch, class Ask>
void in_chunks(const One& one, const Batch& many, std::span<std::uint8_t> out, Ask ask) {
  std::array<std::uint32_t, chunk> unsure;
  for (std::size_t from = 0; from < out.size(); from += chunk) {
    std::array<const double*, n> at{};
    for (std::size_t k = 0; k < n; ++k) at[k] = many.numbers(k) + from;
    const std::size_t count = ask(at.data(), std::min(chunk, out.size() - from), out.data() + from, unsure.data());
    for (std::size_t u = 0; u < count; ++u) {
      const std::size_t i = from + unsure[u];
      if constexpr (n == 9) {
        out[i] = plumb::relate(many[i], one) != Relation::disjoint;
      } else {
        const auto number = [&](std::size_t k) { return many.numbers(k)[i]; };
        const Aabb3 box{{number(0), number(1), number(2)}, {number(3), number(4), number(5)}};
        out[i] = relate(one, box) != Relation::disjoint;
      }
    }
  }
}

}  // namespace
}  // namespace query::overlap_batch

void intersects(const Aabb3& one, const TriangleBatch& many, std::span<std::uint8_t> out) {
  query::overlap_batch::require_length(many.size(), out.size());
  query::require_figure("intersects", "one", one);
  if (is_empty(one)) {
    std::memset(out.data(), 0, out.size());
    return;
  }
  query::overlap_batch::in_chunks<9>(
      one, many, out, [&](const double* const* at, std::size_t n, std::uint8_t* to, std::uint32_t* unsure) {
        return PLUMB_DISPATCH(query::overlap_batch::triangles)(one, at, n, to, unsure);
      });
}

void intersects(const Segment3& one, const BoxBatch& many, std::span<std::uint8_t> out) {
  query::overlap_batch::require_length(many.size(), out.size());
  query::require_figure("intersects", "one", one);
  query::overlap_batch::in_chunks<6>(
      one, many, out, [&](const double* const* at, std::size_t n, std::uint8_t* to, std::uint32_t* unsure) {
        return PLUMB_DISPATCH(query::overlap_batch::boxes)(one, at, n, to, unsure);
      });
}

}  // namespace plumb
#endif
