#include "bench/rivals/ccd_calls.hpp"
#include "bench/rivals/chart_rival.hpp"

namespace plumb::bench {
namespace {

using namespace libccd;

template <std::size_t N, class Make>
void add_pair(Rivals& all, const char* task, const char* name, const char* about, Function* function, Make make) {
  using Pair = std::invoke_result_t<Make, const std::array<double, N>&>;
  join<N>(all, task, name, about, make, [function](const Pair& q) { return meet(function, q.first, q.second); });
}

}  // namespace

void add_ccd(Rivals& all) {
  const char *const gjk = "libccd's ccdGJKIntersect, at most 100 rounds", *const mpr = "libccd's ccdMPRIntersect";
  add_pair<15>(all, "segment-triangle", "libccd-gjk", gjk, ccdGJKIntersect, [](const std::array<double, 15>& q) {
    return std::pair{corners<2>(&q[0]), corners<3>(&q[6])};
  });
  add_pair<18>(all, "triangle-triangle", "libccd-gjk", gjk, ccdGJKIntersect, [](const std::array<double, 18>& q) {
    return std::pair{corners<3>(&q[0]), corners<3>(&q[9])};
  });
  const auto hulls = [](const std::array<double, 48>& q) { return std::pair{corners<8>(&q[0]), corners<8>(&q[24])}; };
  add_pair<48>(all, "convex-convex", "libccd-gjk", gjk, ccdGJKIntersect, hulls);
  // Not of segments and triangles: of sets without a volume it may never come back.
  const auto boxes = [](const std::array<double, 30>& q) { return std::pair{box(&q[0]), box(&q[15])}; };
  add_pair<30>(all, "obb-obb", "libccd-gjk", gjk, ccdGJKIntersect, boxes);
  add_pair<30>(all, "obb-obb", "libccd-mpr", mpr, ccdMPRIntersect, boxes);
}

}  // namespace plumb::bench
