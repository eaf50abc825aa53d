#include "plumb/figure/basic/equal_points.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "figure/basic/lists_by_number.hpp"

namespace plumb {
namespace {

/// Which bucket?  A guess that equal points share and few others do; -0 is 0 here.
std::uint32_t bucket_of(const Point3& p, std::size_t buckets) {
  std::uint64_t mixed = 0;
  for (const double x : {p.x, p.y, p.z}) {
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::uint32_t>((mixed * 0x9e3779b97f4a7c15U >> 32) * buckets >> 32);
}

}  // namespace

std::vector<std::uint32_t> first_equal(std::span<const Point3> points) {
  // A bucket is sorted, so that there are no bad inputs.
  const std::size_t buckets = std::min<std::size_t>(points.size() + 1, std::size_t{1} << 31);
  std::vector<std::uint32_t> bucket(points.size()), first(points.size()), here;
  for (std::size_t i = 0; i < points.size(); ++i) bucket[i] = bucket_of(points[i], buckets);
  const figure::ListsByNumber lists(bucket, buckets);
  for (std::size_t b = 0; b < buckets; ++b) {
    here.assign(lists[b].begin(), lists[b].end());
    std::ranges::sort(here, [&](std::uint32_t l, std::uint32_t r) {
      const Point3 &p = points[l], &q = points[r];
      return std::tie(p.x, p.y, p.z, l) < std::tie(q.x, q.y, q.z, r);
    });
    for (std::size_t i = 0; i < here.size(); ++i) {
      const bool repeats = i > 0 && points[here[i]] == points[here[i - 1]];
      first[here[i]] = repeats ? first[here[i - 1]] : here[i];
    }
  }
  return first;
}

}  // namespace plumb
