// libccd: ccdGJKIntersect, which needs no penetration depth.
#include "bench/rivals/gjk/rival.hpp"

#ifdef PLUMB_BENCH_CCD
#include "bench/rivals/ccd_calls.hpp"

namespace plumb::bench {
namespace {

using Hull = libccd::Convex<std::vector<ccd_vec3_t>>;

std::shared_ptr<void> make(const std::vector<double>& numbers) {
  auto hull = std::make_shared<Hull>();
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    ccd_vec3_t v;
    ccdVec3Set(&v, numbers[i], numbers[i + 1], numbers[i + 2]);
    hull->points.push_back(v);
  }
  return hull;
}
bool meet(const void* a, const void* b) {
  return libccd::meet([](const void* p, const void* q, const ccd_t* ccd) { return ccdGJKIntersect(p, q, ccd); },
                      *static_cast<const Hull*>(a), *static_cast<const Hull*>(b));
}

}  // namespace

std::vector<GjkRival> gjk_ccd_rival() { return {{"libccd", make, meet}}; }

}  // namespace plumb::bench
#else
std::vector<plumb::bench::GjkRival> plumb::bench::gjk_ccd_rival() { return {}; }
#endif
