#include <algorithm>
#include <cmath>

#include "bench/rivals/chart_rival.hpp"
#include "bench/rivals/qhull_calls.hpp"

namespace plumb::bench {
namespace {

/// The corners as a set of bits, of equal points the first.
template <int Dimension, std::size_t N>
double corners(const std::array<double, N>& q) {
  // Where products of differences overflow, its hulls in space may crash.
  const auto huge = [](double x) { return std::fabs(x) >= 0x1p510; };
  if (Dimension == 3 && std::ranges::any_of(q, huge)) return lab::trial::unsure;
  std::uint32_t found = 0;
  const bool done = with_qhull(Dimension, q.data(), N / Dimension, "qhull ", [&](const qhT& state) {
    for (const vertexT* v = state.vertex_list; v != nullptr && v->next != nullptr; v = v->next)
      found |= bit_of<Dimension>(q, v->point);
  });
  return done ? found : lab::trial::unsure;
}

}  // namespace

void add_qhull(Rivals& all) {
  const char* const about = "Qhull's qh_new_qhull, its default options";
  join<32>(all, "hull-2d", "qhull", about, corners<2, 32>);
  join<36>(all, "hull-3d", "qhull", about, corners<3, 36>);
}

}  // namespace plumb::bench
