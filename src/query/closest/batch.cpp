#include "plumb/query/closest/batch.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/body/figure_input.hpp"
#include "query/closest/batch_scan.hpp"

namespace plumb {
namespace query::batch {
namespace {

/// Items at a time, whose bounds stay near.
constexpr std::size_t chunk = 1024;

struct Candidate {
  std::size_t item;
  double lower;
};

template <std::size_t numbers, class Batch>
NearestOfMany nearest_of(const Batch& many, const Point3& p, Scan scan) {
  require_figure("nearest", "p", p);
  if (many.size() == 0) throw InvalidShape("nearest: the batch is empty; give one item at least");
  std::vector<Candidate> candidates;
  double least = std::numeric_limits<double>::infinity();
  std::array<double, chunk + most_lanes> lower;
  std::array<std::uint32_t, chunk> which;
  for (std::size_t from = 0; from < many.size(); from += chunk) {
    std::array<const double*, numbers> of;
    for (std::size_t k = 0; k < numbers; ++k) of[k] = many.numbers(k) + from;
    const std::size_t n = std::min(chunk, many.size() - from);
    least = std::min(least, scan(of.data(), n, p, lower.data()));
    const std::size_t count = list_up_to(least, lower.data(), n, which.data());
    for (std::size_t k = 0; k < count; ++k) candidates.push_back({from + which[k], lower[which[k]]});
  }
  std::size_t best = many.size();
  for (const Candidate& c : candidates) {
    if (c.lower > least) continue;
    if (best == many.size() || compare_distance(p, many[c.item], p, many[best]) == Sign::negative) best = c.item;
  }
  return {best, distance(p, many[best])};
}

}  // namespace
}  // namespace query::batch

NearestOfMany nearest(const PointBatch& many, const Point3& p) {
  return query::batch::nearest_of<3>(many, p, query::batch::scan_points);
}
NearestOfMany nearest(const SegmentBatch& many, const Point3& p) {
  return query::batch::nearest_of<6>(many, p, query::batch::scan_segments);
}
NearestOfMany nearest(const TriangleBatch& many, const Point3& p) {
  return query::batch::nearest_of<9>(many, p, query::batch::scan_triangles);
}

}  // namespace plumb
