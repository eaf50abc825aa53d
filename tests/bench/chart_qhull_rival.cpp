#include <algorithm>
#include <cstdint>

#include "bench/chart_rival.hpp"
#include "bench/qhull_calls.hpp"

namespace plumb::bench {
namespace {

/// The corners as a set of bits, of equal points the first.
template <int Dimension, std::size_t N>
double corners(const std::array<double, N>& q) {
  std::uint32_t found = 0;
  const bool done = with_qhull(Dimension, q.data(), N / Dimension, "qhull ", [&](const qhT& state) {
    for (const vertexT* v = state.vertex_list; v != nullptr && v->next != nullptr; v = v->next) {
      std::size_t first = 0;
      while (!std::equal(v->point, v->point + Dimension, &q[first * Dimension])) ++first;
      found |= std::uint32_t{1} << first;
    }
  });
  return done ? found : tool::trial::unsure;
}

}  // namespace

void add_qhull(Rivals& all) {
  join<32>(
      all, "hull-2d", "qhull", "Qhull's qh_new_qhull, its default options",
      [](const std::array<double, 32>& q) { return q; }, corners<2, 32>);
}

}  // namespace plumb::bench
