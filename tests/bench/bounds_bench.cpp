// What does an exact answer about two bounds cost?  Boxes, balls, capsules and k-DOPs, each beside the same test in
// plain doubles as it is commonly written, on pairs of which about half meet; then boxes and balls in batches.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/aabb/box_batch.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t cases = 4096;

class Uniform {
 public:
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(entropy_.bits(53)) * 0x1p-53;
  }
  Point3 point() {
    const double x = (*this)(0, 1), y = (*this)(0, 1), z = (*this)(0, 1);
    return {x, y, z};
  }

 private:
  Entropy entropy_{2026};
};

template <class Shape>
struct Pairs {
  std::vector<Shape> a, b;
};

template <class Shape, class Make>
Pairs<Shape> pairs(Make make) {
  Uniform uniform;
  Pairs<Shape> p;
  for (std::size_t i = 0; i < cases; ++i) p.a.push_back(make(uniform)), p.b.push_back(make(uniform));
  return p;
}

const Pairs<Aabb3>& boxes() {
  static const auto all = pairs<Aabb3>([](Uniform& u) {
    const Point3 p = u.point();
    return Aabb3{p, {p.x + u(0, 1), p.y + u(0, 1), p.z + u(0, 1)}};
  });
  return all;
}
const Pairs<Sphere3>& spheres() {
  static const auto all = pairs<Sphere3>([](Uniform& u) { return Sphere3{u.point(), u(0.1, 0.55)}; });
  return all;
}
const Pairs<Capsule3>& capsules() {
  static const auto all = pairs<Capsule3>([](Uniform& u) { return Capsule3{u.point(), u.point(), u(0.0, 0.25)}; });
  return all;
}
const Pairs<KDop3>& k_dops(int k) {
  static const auto make = [](int of) {
    return pairs<KDop3>([of](Uniform& u) {
      const Point3 p = u.point();
      std::vector<Point3> points;
      for (int i = 0; i < 8; ++i) points.push_back({p.x + u(0, 0.8), p.y + u(0, 0.8), p.z + u(0, 0.8)});
      return fit_k_dop(points, of);
    });
  };
  static const auto of_14 = make(14), of_26 = make(26);
  return k == 14 ? of_14 : of_26;
}

namespace plain {

bool intersects(const Aabb3& a, const Aabb3& b) {
  if (a.max.x < b.min.x || a.min.x > b.max.x) return false;
  if (a.max.y < b.min.y || a.min.y > b.max.y) return false;
  if (a.max.z < b.min.z || a.min.z > b.max.z) return false;
  return true;
}

bool intersects(const Sphere3& a, const Sphere3& b) {
  const double x = a.center.x - b.center.x, y = a.center.y - b.center.y, z = a.center.z - b.center.z;
  const double r = a.radius + b.radius;
  return x * x + y * y + z * z <= r * r;
}

double clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

bool intersects(const Capsule3& a, const Capsule3& b) {
  const Vector3 u{a.b.x - a.a.x, a.b.y - a.a.y, a.b.z - a.a.z}, v{b.b.x - b.a.x, b.b.y - b.a.y, b.b.z - b.a.z};
  const Vector3 w{a.a.x - b.a.x, a.a.y - b.a.y, a.a.z - b.a.z};
  const auto dot = [](const Vector3& p, const Vector3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; };
  const double uu = dot(u, u), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w), uv = dot(u, v);
  const double area = uu * vv - uv * uv;
  double s = area != 0 ? clamped((uv * vw - uw * vv) / area) : 0;
  double t = (uv * s + vw) / vv;
  if (t < 0) {
    t = 0;
    s = clamped(-uw / uu);
  } else if (t > 1) {
    t = 1;
    s = clamped((uv - uw) / uu);
  }
  const Vector3 d{w.x + s * u.x - t * v.x, w.y + s * u.y - t * v.y, w.z + s * u.z - t * v.z};
  const double r = a.radius + b.radius;
  return dot(d, d) <= r * r;
}

bool intersects(const KDop3& a, const KDop3& b) {
  for (std::size_t i = 0; i < a.min.size(); ++i) {
    if (a.min[i] > b.max[i] || a.max[i] < b.min[i]) return false;
  }
  return true;
}

}  // namespace plain

// Other pairs in every round, so that no branch predictor learns the answers.
template <class Shape, class Test>
void run(benchmark::State& state, const Pairs<Shape>& p, Test test) {
  long met = 0;
  std::size_t shift = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < cases; ++i) met += test(p.a[i], p.b[(i + shift) % cases]);
    shift += 1447;
    benchmark::DoNotOptimize(met);
  }
  const auto items = state.iterations() * static_cast<std::int64_t>(cases);
  state.SetItemsProcessed(items);
  state.counters["meet"] = static_cast<double>(met) / static_cast<double>(items);
}

constexpr auto plainly = [](const auto& a, const auto& b) { return plain::intersects(a, b); };
constexpr auto exactly = [](const auto& a, const auto& b) { return intersects(a, b); };
constexpr auto related = [](const auto& a, const auto& b) { return relate(a, b) != Relation::disjoint; };
constexpr auto by_intervals = [](const auto& a, const auto& b) { return intervals_overlap(a, b); };

void box_plain(benchmark::State& state) { run(state, boxes(), plainly); }
void box_intersects(benchmark::State& state) { run(state, boxes(), exactly); }
void box_relate(benchmark::State& state) { run(state, boxes(), related); }
void sphere_plain(benchmark::State& state) { run(state, spheres(), plainly); }
void sphere_intersects(benchmark::State& state) { run(state, spheres(), exactly); }
void capsule_plain(benchmark::State& state) { run(state, capsules(), plainly); }
void capsule_intersects(benchmark::State& state) { run(state, capsules(), exactly); }
void k_dop_plain(benchmark::State& state) { run(state, k_dops(static_cast<int>(state.range(0))), plainly); }
void k_dop_intervals(benchmark::State& state) { run(state, k_dops(static_cast<int>(state.range(0))), by_intervals); }
void k_dop_intersects(benchmark::State& state) { run(state, k_dops(static_cast<int>(state.range(0))), exactly); }
BENCHMARK(box_plain);
BENCHMARK(box_intersects);
BENCHMARK(box_relate);
BENCHMARK(sphere_plain);
BENCHMARK(sphere_intersects);
BENCHMARK(capsule_plain);
BENCHMARK(capsule_intersects);
BENCHMARK(k_dop_plain)->Arg(14)->Arg(26);
BENCHMARK(k_dop_intervals)->Arg(14)->Arg(26);
BENCHMARK(k_dop_intersects)->Arg(14)->Arg(26);

template <class Ask>
void run_batch(benchmark::State& state, Ask ask) {
  std::vector<std::uint8_t> out(cases);
  for (auto _ : state) {
    ask(out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases));
}

void box_batch(benchmark::State& state) {
  const BoxBatch a(boxes().a), b(boxes().b);
  run_batch(state, [&](std::span<std::uint8_t> out) { intersects(a, b, out); });
}
void box_batch_one(benchmark::State& state) {
  const BoxBatch b(boxes().b);
  run_batch(state, [&](std::span<std::uint8_t> out) { intersects(boxes().a[0], b, out); });
}
void sphere_batch(benchmark::State& state) {
  const SphereBatch a(spheres().a), b(spheres().b);
  run_batch(state, [&](std::span<std::uint8_t> out) { intersects(a, b, out); });
}
void sphere_batch_one(benchmark::State& state) {
  const SphereBatch b(spheres().b);
  run_batch(state, [&](std::span<std::uint8_t> out) { intersects(spheres().a[0], b, out); });
}
void four_boxes(benchmark::State& state) {
  std::vector<FourBoxes> a, b;
  for (std::size_t i = 0; i < cases; i += 4) {
    const auto four = [i](const std::vector<Aabb3>& all) {
      return FourBoxes({all[i], all[i + 1], all[i + 2], all[i + 3]});
    };
    a.push_back(four(boxes().a)), b.push_back(four(boxes().b));
  }
  for (auto _ : state) {
    unsigned met = 0;
    for (std::size_t i = 0; i < a.size(); ++i) met += intersects(a[i], b[i]);
    benchmark::DoNotOptimize(met);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases));
}
BENCHMARK(box_batch);
BENCHMARK(box_batch_one);
BENCHMARK(four_boxes);
BENCHMARK(sphere_batch);
BENCHMARK(sphere_batch_one);

}  // namespace
}  // namespace plumb::bench
