#include "plumb/query/overlap/batch.hpp"

#include <cstring>

#include "certify/batch/instruction_sets.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/shapes3.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/overlap/batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/many_lanes.hpp"
#include "query/overlap/beside_box.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::overlap_batch::HWY_NAMESPACE {
namespace {

namespace lanes = certify::many_lanes::HWY_NAMESPACE;
namespace statements = beside_box::HWY_NAMESPACE;
using lanes::Many, lanes::Truth, lanes::above, lanes::of_all;
using Place = statements::Place<Many>;

constexpr std::size_t count_of_lanes = lanes::hn::MaxLanes(lanes::Lanes());

HWY_INLINE Place in_all(const Point3& p) { return {of_all(p.x), of_all(p.y), of_all(p.z)}; }
HWY_INLINE Place load(const double* const* at, std::size_t k, std::size_t i) {
  const auto one = [&](std::size_t axis) HWY_ATTR { return Many{lanes::hn::LoadU(lanes::Lanes(), at[k + axis] + i)}; };
  return {one(0), one(1), one(2)};
}
HWY_INLINE Place lower(const Place& a, const Place& b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z)};
}
HWY_INLINE Place upper(const Place& a, const Place& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z)};
}

/// What is told: apart along some axis, or meeting along all.
struct GapMasks {
  Truth apart, meet;

  template <class W, class Gap>
  HWY_INLINE void operator()(const W& w, const Gap& gap) {
    apart = apart | w.positive(gap);
    meet = meet & w.negative(gap);
  }
};

// Along the axes of the box: exact.
HWY_INLINE GapMasks along_axes(const Place& low, const Place& high, const Place& min, const Place& max) {
  const auto gap = [](const Many& l, const Many& h, const Many& from, const Many& to)
                       HWY_ATTR { return larger(l - to, from - h); };
  const Many most = larger(larger(gap(low.x, high.x, min.x, max.x), gap(low.y, high.y, min.y, max.y)),
                           gap(low.z, high.z, min.z, max.z));
  return {above(most, of_all(0)), above(of_all(0), most)};
}

// Writes the answers for all lanes of item i on, and lists those in doubt.
std::size_t put(unsigned apart, unsigned meet, std::size_t i, std::uint8_t* out, std::uint32_t* unsure,
                std::size_t count) {
  for (std::size_t k = 0; k < count_of_lanes; ++k) out[i + k] = static_cast<std::uint8_t>(meet >> k & 1u);
  unsigned open = ~(meet | apart) & ((1u << count_of_lanes) - 1);
  for (; open != 0; open &= open - 1)
    unsure[count++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(open));
  return count;
}

std::size_t triangles(const Aabb3& box, const double* const* at, std::size_t n, std::uint8_t* out,
                      std::uint32_t* unsure) {
  using Statement = statements::TriangleBesideBox;
  const Place min = in_all(box.min), max = in_all(box.max);
  std::size_t count = 0, i = 0;
  for (; i + count_of_lanes <= n; i += count_of_lanes) {
    const Place a = load(at, 0, i), b = load(at, 3, i), c = load(at, 6, i);
    const GapMasks given = along_axes(lower(lower(a, b), c), upper(upper(a, b), c), min, max);
    if (lanes::all(given.apart)) {
      std::memset(out + i, 0, count_of_lanes);
      continue;
    }
    GapMasks told = given;
    lanes::Floats<Many, Statement::highest, Statement::scales> world;
    Statement{}(world, a, b, c, min, max, told);
    const Truth in_range = world.in_range();
    count = put(lanes::bits_of(given.apart | (told.apart & in_range)), lanes::bits_of(told.meet & in_range), i, out,
                unsure, count);
  }
  for (; i < n; ++i) unsure[count++] = static_cast<std::uint32_t>(i);
  return count;
}

std::size_t boxes(const Segment3& s, const double* const* at, std::size_t n, std::uint8_t* out, std::uint32_t* unsure) {
  using Statement = statements::SegmentBesideBox;
  const Place a = in_all(s.a), b = in_all(s.b), low = lower(a, b), high = upper(a, b);
  const Difference way = query::difference(s.a, s.b);
  const bool across[3] = {way.y != 0 || way.z != 0, way.z != 0 || way.x != 0, way.x != 0 || way.y != 0};
  std::size_t count = 0, i = 0;
  for (; i + count_of_lanes <= n; i += count_of_lanes) {
    const Place min = load(at, 0, i), max = load(at, 3, i);
    const GapMasks given = along_axes(low, high, min, max);
    if (lanes::all(given.apart)) {
      std::memset(out + i, 0, count_of_lanes);
      continue;
    }
    GapMasks told = given;
    lanes::Floats<Many, Statement::highest, Statement::scales> world;
    Statement{}(world, a, b, min, max, across, told);
    const Truth in_range = world.in_range();
    // A box that is empty is left to the scalar test.
    const Truth is_box = at_most(min.x, max.x) & at_most(min.y, max.y) & at_most(min.z, max.z);
    count = put(lanes::bits_of(given.apart | (told.apart & in_range)), lanes::bits_of(told.meet & in_range & is_box), i,
                out, unsure, count);
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

PLUMB_EXPORT(triangles);
PLUMB_EXPORT(boxes);

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
