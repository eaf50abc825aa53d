// Bullet: its pair detector, as built for doubles, on clouds of points without a margin.
#include "bench/rivals/gjk/rival.hpp"

#ifdef PLUMB_BENCH_BULLET
#include "bench/rivals/bullet_calls.hpp"

namespace plumb::bench {
namespace {

struct Hull {
  bullet::Cloud points;
  btConvexPointCloudShape shape;
  explicit Hull(const std::vector<double>& x) : points(x.data(), x.size() / 3), shape(points.shape()) {}
};

std::shared_ptr<void> make(const std::vector<double>& numbers) { return std::make_shared<Hull>(numbers); }
bool meet(const void* a, const void* b) {
  return bullet::gap(static_cast<const Hull*>(a)->shape, static_cast<const Hull*>(b)->shape) <= 0;
}

}  // namespace

std::vector<GjkRival> gjk_bullet_rival() { return {{"bullet", make, meet}}; }

}  // namespace plumb::bench
#else
std::vector<plumb::bench::GjkRival> plumb::bench::gjk_bullet_rival() { return {}; }
#endif
