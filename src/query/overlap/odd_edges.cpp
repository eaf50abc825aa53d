#include "query/overlap/odd_edges.hpp"

#include <algorithm>
#include <array>

#include "plumb/certify/direction.hpp"

namespace plumb::query {
namespace {

double coordinate(const Point3& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

}  // namespace

// Of the edges on one line the ends are in the order of any coordinate that changes along it.
std::vector<Segment3> odd_edges(std::span<const Segment3> edges) {
  std::vector<Segment3> odd;
  std::vector<bool> done(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b] = edges[i];
    if (done[i] || a == b) continue;
    const std::size_t k = a.x != b.x ? 0 : a.y != b.y ? 1 : 2;
    std::vector<std::array<double, 2>> covered;
    std::vector<Point3> ends;
    for (std::size_t j = i; j < edges.size(); ++j) {
      const auto& [p, q] = edges[j];
      if (p == q || !collinear(a, b, p) || !collinear(a, b, q)) continue;
      done[j] = true;
      const double from = coordinate(p, k), to = coordinate(q, k);
      covered.push_back({std::min(from, to), std::max(from, to)});
      ends.push_back(p), ends.push_back(q);
    }
    std::ranges::sort(ends, {}, [k](const Point3& p) { return coordinate(p, k); });
    for (std::size_t j = 0; j + 1 < ends.size(); ++j) {
      const double from = coordinate(ends[j], k), to = coordinate(ends[j + 1], k);
      const auto covers = [&](const auto& c) { return c[0] <= from && to <= c[1]; };
      if (from < to && std::ranges::count_if(covered, covers) % 2 == 1) odd.push_back({ends[j], ends[j + 1]});
    }
  }
  return odd;
}

}  // namespace plumb::query
