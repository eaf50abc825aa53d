// How long do round shapes take against others?  Beside the same test in plain doubles: uniform coordinates, and shapes
// on a small grid, of which many exactly touch.  `hits` is the share of pairs that meet.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bench/rivals/overlap_round_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 4096;

class Source {
 public:
  explicit Source(bool grid) : grid_(grid) {}

  double coordinate() { return grid_ ? static_cast<double>(entropy_.within(8)) : signed_unit_coordinate(entropy_); }
  double size() { return grid_ ? static_cast<double>(1 + entropy_.below(4)) : 0.1 + 0.5 * unit_coordinate(entropy_); }
  Point3 point() { return {coordinate(), coordinate(), coordinate()}; }
  Point3 near(const Point3& p) {
    if (grid_) return point();
    return {p.x + coordinate() / 2, p.y + coordinate() / 2, p.z + coordinate() / 2};
  }
  Vector3 unit() {
    if (grid_) return axis(entropy_.below(3));
    const Point3 p = point();
    const double l = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x / l, p.y / l, p.z / l};
  }

  void draw(Plane3& s) { s = {unit(), coordinate()}; }
  void draw(Halfspace3& s) { s = {unit(), coordinate()}; }
  void draw(Segment3& s) { s.a = point(), s.b = near(s.a); }
  void draw(Ray3& s) { s = {point(), unit()}; }
  void draw(Triangle3& s) { s.a = point(), s.b = near(s.a), s.c = near(s.a); }
  void draw(Aabb3& s) {
    const Point3 p = point(), q = near(p);
    s = {{std::fmin(p.x, q.x), std::fmin(p.y, q.y), std::fmin(p.z, q.z)},
         {std::fmax(p.x, q.x), std::fmax(p.y, q.y), std::fmax(p.z, q.z)}};
  }
  void draw(Obb3& s) {
    s.center = point();
    s.half = {size(), size(), size()};
    const Vector3 u = unit();
    if (grid_) {
      s.axes = {axis(0), axis(1), axis(2)};
      return;
    }
    const Vector3 w = std::fabs(u.x) < 0.6 ? axis(0) : axis(1);
    const double along = u.x * w.x + u.y * w.y + u.z * w.z;
    Vector3 v{w.x - along * u.x, w.y - along * u.y, w.z - along * u.z};
    const double l = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    v = {v.x / l, v.y / l, v.z / l};
    s.axes = {u, v, Vector3{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}};
  }
  void draw(Sphere3& s) { s = {point(), size()}; }
  void draw(Capsule3& s) { s.a = point(), s.b = near(s.a), s.radius = size(); }
  void draw(Cylinder3& s) { s.a = point(), s.b = near(s.a), s.radius = size(); }
  void draw(Cone3& s) { s.apex = point(), s.base = near(s.apex), s.radius = size(); }

 private:
  static Vector3 axis(std::uint64_t k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

  bool grid_;
  Entropy entropy_{55};
};

template <class A, class B, class Meet>
void run(benchmark::State& state, Meet meet) {
  Source source(state.range(0) != 0);
  std::vector<A> a(pairs);
  std::vector<B> b(pairs);
  for (std::size_t i = 0; i < pairs; ++i) source.draw(a[i]), source.draw(b[i]);
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (std::size_t i = 0; i < pairs; ++i) hits += static_cast<std::size_t>(meet(a[i], b[i]));
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits"] = static_cast<double>(hits) / pairs;
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
template <class A, class B>
void exact(benchmark::State& state) {
  run<A, B>(state, [](const A& a, const B& b) { return intersects(a, b); });
}
template <class A, class B>
void in_doubles(benchmark::State& state) {
  run<A, B>(state, [](const A& a, const B& b) { return plain::meet(a, b); });
}

#define PLUMB_PAIR(A, B)                  \
  BENCHMARK(exact<A, B>)->Arg(0)->Arg(1); \
  BENCHMARK(in_doubles<A, B>)->Arg(0)->Arg(1)
PLUMB_PAIR(Plane3, Sphere3);
PLUMB_PAIR(Segment3, Sphere3);
PLUMB_PAIR(Ray3, Sphere3);
PLUMB_PAIR(Triangle3, Sphere3);
PLUMB_PAIR(Aabb3, Sphere3);
PLUMB_PAIR(Obb3, Sphere3);
PLUMB_PAIR(Segment3, Capsule3);
PLUMB_PAIR(Triangle3, Capsule3);
PLUMB_PAIR(Aabb3, Capsule3);
PLUMB_PAIR(Capsule3, Capsule3);
PLUMB_PAIR(Segment3, Cylinder3);
PLUMB_PAIR(Halfspace3, Cone3);
#undef PLUMB_PAIR

}  // namespace
}  // namespace plumb::bench
