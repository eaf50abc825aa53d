// How long do nearest neighbors take, and how often are they wrong?  The k-d tree of points on one thread, beside those
// of nanoflann and CGAL where they are there.
//
// Items a second are queries, or points that a tree is built of; `wrong`: how many of 1,000 queries that are nearly as
// far from many points (points on a sphere, asked from near its center) are answered by a point that is not the nearest.
#include <benchmark/benchmark.h>

#include <cmath>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#ifdef PLUMB_BENCH_NEAREST
#include "bench/rivals/nearest/rival.hpp"
#endif

namespace plumb::bench {
namespace {

constexpr std::size_t queries_at_once = 100'000;

Point3 anywhere(Entropy& e) {
  const auto at = [&] { return static_cast<double>(e.bits(53)) * 0x1p-53; };
  return {at(), at(), at()};
}
std::vector<Point3> uniform(std::size_t n, std::uint64_t start) {
  std::vector<Point3> points;
  Entropy e(start, n);
  for (std::size_t i = 0; i < n; ++i) points.push_back(anywhere(e));
  return points;
}
std::vector<Point3> on_sphere(std::size_t n) {
  std::vector<Point3> points;
  Entropy e(11, n);
  while (points.size() < n) {
    const Point3 p = anywhere(e), q{p.x - 0.5, p.y - 0.5, p.z - 0.5};
    const double r = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
    if (r > 0.01) points.push_back({q.x / r, q.y / r, q.z / r});
  }
  return points;
}

class Plumb {
 public:
  explicit Plumb(const std::vector<Point3>& points) : tree_(build_kd_tree(points, {.execution = Execution::serial})) {}
  void nearest(const std::vector<Point3>& queries, std::size_t k, std::vector<std::uint32_t>& out) {
    found_.resize(queries.size() * k);
    if (k == 1) {
      plumb::nearest(tree_, queries, found_, Execution::serial);
    } else {
      plumb::nearest(tree_, queries, k, found_, Execution::serial);
    }
    for (std::size_t i = 0; i < found_.size(); ++i) out[i] = found_[i].index;
  }
  [[nodiscard]] std::size_t within(const std::vector<Point3>& queries, double radius) const {
    return plumb::within(tree_, queries, radius, Execution::serial).numbers.size();
  }

 private:
  KdTree3 tree_;
  std::vector<NearestPoint> found_;
};
/// The same, query by query.
class PlumbOneByOne {
 public:
  explicit PlumbOneByOne(const std::vector<Point3>& points)
      : tree_(build_kd_tree(points, {.execution = Execution::serial})) {}
  void nearest(const std::vector<Point3>& queries, std::size_t k, std::vector<std::uint32_t>& out) const {
    auto to = out.begin();
    for (const Point3& p : queries) {
      if (k == 1) {
        *to++ = plumb::nearest(tree_, p).index;
      } else {
        for (const NearestPoint& n : plumb::nearest(tree_, p, k)) *to++ = n.index;
      }
    }
  }
  [[nodiscard]] std::size_t within(const std::vector<Point3>& queries, double radius) const {
    std::size_t found = 0;
    for (const Point3& p : queries) found += plumb::within(tree_, p, radius).size();
    return found;
  }

 private:
  KdTree3 tree_;
};
#ifdef PLUMB_BENCH_NEAREST
template <class Tree>
class Rival {
 public:
  explicit Rival(const std::vector<Point3>& points) : tree_(points) {}
  void nearest(const std::vector<Point3>& queries, std::size_t k, std::vector<std::uint32_t>& out) const {
    for (std::size_t i = 0; i < queries.size(); ++i) tree_.nearest(queries[i], k, out.data() + k * i);
  }
  [[nodiscard]] std::size_t within(const std::vector<Point3>& queries, double radius) const {
    std::vector<std::uint32_t> found;
    for (const Point3& p : queries) (void)tree_.within(p, radius, found);
    return found.size();
  }

 private:
  Tree tree_;
};
using Nanoflann = Rival<NanoflannTree>;
using Cgal = Rival<CgalTree>;
#endif

template <class Method>
double wrong_answers() {
  constexpr std::size_t n = 1000;
  const std::vector<Point3> points = on_sphere(n);
  std::vector<Point3> queries;
  Entropy e(12, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 p = anywhere(e);
    queries.push_back({(p.x - 0.5) * 0x1p-52, (p.y - 0.5) * 0x1p-52, (p.z - 0.5) * 0x1p-52});
  }
  std::vector<std::uint32_t> out(n);
  Method(points).nearest(queries, 1, out);
  double wrong = 0;
  for (std::size_t i = 0; i < n; ++i) {
    bool is_nearest = true;
    for (const Point3& q : points)
      is_nearest = is_nearest && compare_distance(queries[i], q, points[out[i]]) != Sign::negative;
    wrong += is_nearest ? 0 : 1;
  }
  return wrong;
}

template <class Method>
void build(benchmark::State& state) {
  const std::vector<Point3> points = uniform(static_cast<std::size_t>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(Method(points));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
template <class Method>
void nearest_k(benchmark::State& state) {
  Method method(uniform(static_cast<std::size_t>(state.range(0)), 1));
  const std::vector<Point3> queries = uniform(queries_at_once, 2);
  const auto k = static_cast<std::size_t>(state.range(1));
  std::vector<std::uint32_t> out(k * queries.size());
  for (auto _ : state) method.nearest(queries, k, out);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
  if (k == 1) state.counters["wrong"] = wrong_answers<Method>();
}
/// Eight points on average.
template <class Method>
void in_radius(benchmark::State& state) {
  const Method method(uniform(static_cast<std::size_t>(state.range(0)), 1));
  const std::vector<Point3> queries = uniform(queries_at_once, 2);
  const double radius = std::cbrt(8 * 3 / (4 * 3.141592653589793 * static_cast<double>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(method.within(queries, radius));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(queries.size()));
}

#define PLUMB_NEAREST_BENCH(Method)                                                      \
  BENCHMARK(build<Method>)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond); \
  BENCHMARK(nearest_k<Method>)                                                           \
      ->Args({100'000, 1})                                                               \
      ->Args({100'000, 8})                                                               \
      ->Args({1'000'000, 1})                                                             \
      ->Unit(benchmark::kMillisecond);                                                   \
  BENCHMARK(in_radius<Method>)->Arg(100'000)->Unit(benchmark::kMillisecond)
PLUMB_NEAREST_BENCH(Plumb);
PLUMB_NEAREST_BENCH(PlumbOneByOne);
#ifdef PLUMB_BENCH_NEAREST
PLUMB_NEAREST_BENCH(Nanoflann);
PLUMB_NEAREST_BENCH(Cgal);
#endif
#undef PLUMB_NEAREST_BENCH

}  // namespace
}  // namespace plumb::bench
