// How long do rays take?  Yes or no and the first hit, beside plain doubles and CGAL's Epick on the same rays; one ray
// against many triangles beside one test after the other.
//
// Classes: uniform (rays aimed near to the shape, about half of them hit), float32, grid (small integers, many exactly
// at edges and vertices), edge (53-bit coordinates, aimed at edges and vertices as well as doubles can).
// `ns` is the time of one pair, `hits` the share that hit, `wrong` the share of answers that are not the exact ones.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/rivals/ray_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/hits.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 8192;

enum class Class { uniform, float32, grid, edge };
constexpr std::array<std::pair<Class, const char*>, 4> classes{
    {{Class::uniform, "uniform"}, {Class::float32, "float32"}, {Class::grid, "grid"}, {Class::edge, "edge"}}};

struct Source {
  Class kind;
  Entropy entropy{77};

  double number() {
    if (kind == Class::grid) return static_cast<double>(entropy.within(8));
    const double x = signed_unit_coordinate(entropy);
    return kind == Class::float32 ? static_cast<double>(static_cast<float>(x)) : x;
  }
  Point3 point() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  double part() { return kind == Class::grid ? static_cast<double>(entropy.below(5)) / 4 : unit_coordinate(entropy); }
};

struct Pair {
  Ray3 ray;
  Segment3 segment;
  Triangle3 triangle;
  Sphere3 sphere;
  Aabb3 box;
};

Point3 mixed(const Point3& a, const Point3& b, const Point3& c, double s, double t) {
  return {a.x + s * (b.x - a.x) + t * (c.x - a.x), a.y + s * (b.y - a.y) + t * (c.y - a.y),
          a.z + s * (b.z - a.z) + t * (c.z - a.z)};
}

Pair pair_of(Source& from) {
  Pair p{};
  p.triangle = {from.point(), from.point(), from.point()};
  const Point3 origin = from.point();
  const double s = from.kind == Class::edge ? 0 : 1.4 * from.part(), t = 1.4 * from.part();
  const Point3 target = from.kind == Class::grid ? (from.entropy.coin() ? p.triangle.b : from.point())
                                                 : mixed(p.triangle.a, p.triangle.b, p.triangle.c, s, t);
  p.ray = {origin, {target.x - origin.x, target.y - origin.y, target.z - origin.z}};
  p.segment = {origin, mixed(origin, target, target, 1.5, 0)};
  // About two points; the ray passes the corner of one only where that is asked for.
  const bool at_corner = from.kind == Class::grid || from.kind == Class::edge;
  const Point3 q = from.point(), r = at_corner ? target : from.point();
  p.box = {{std::fmin(q.x, r.x), std::fmin(q.y, r.y), std::fmin(q.z, r.z)},
           {std::fmax(q.x, r.x), std::fmax(q.y, r.y), std::fmax(q.z, r.z)}};
  const Point3 center = from.point();
  p.sphere = {center, at_corner ? std::hypot(center.x - target.x, center.y - target.y, center.z - target.z)
                                : 0.5 * from.part()};
  return p;
}

std::shared_ptr<std::vector<Pair>> pairs_of(Class kind) {
  Source from{kind};
  auto all = std::make_shared<std::vector<Pair>>();
  while (all->size() < pairs) all->push_back(pair_of(from));
  return all;
}

template <class Ask, class Exact>
void add(const std::string& name, std::shared_ptr<std::vector<Pair>> all, Ask ask, Exact exact) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    std::size_t met = 0, wrong = 0;
    for (const Pair& p : *all) wrong += static_cast<std::size_t>(ask(p) != exact(p));
    for (auto _ : state) {
      met = 0;
      for (const Pair& p : *all) met += static_cast<std::size_t>(ask(p));
      benchmark::DoNotOptimize(met);
    }
    state.counters["hits"] = static_cast<double>(met) / pairs;
    state.counters["wrong"] = static_cast<double>(wrong) / pairs;
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

void add_class(Class kind, const std::string& name) {
  const auto all = pairs_of(kind);
  const auto triangle = [](const Pair& p) { return hits(p.ray, p.triangle); };
  const auto segment = [](const Pair& p) { return hits(p.segment, p.triangle); };
  const auto sphere = [](const Pair& p) { return hits(p.ray, p.sphere); };
  const auto box = [](const Pair& p) { return hits(p.ray, p.box); };
  add("ray_triangle/" + name + "/exact", all, triangle, triangle);
  add(
      "ray_triangle/" + name + "/plain", all, [](const Pair& p) { return plain_hits(p.ray, p.triangle); }, triangle);
  add(
      "ray_triangle/" + name + "/cgal", all, [](const Pair& p) { return cgal_hits(p.ray, p.triangle); }, triangle);
  add("segment_triangle/" + name + "/exact", all, segment, segment);
  add(
      "segment_triangle/" + name + "/plain", all, [](const Pair& p) { return plain_hits(p.segment, p.triangle); },
      segment);
  add(
      "segment_triangle/" + name + "/cgal", all, [](const Pair& p) { return cgal_hits(p.segment, p.triangle); },
      segment);
  add("ray_sphere/" + name + "/exact", all, sphere, sphere);
  add(
      "ray_sphere/" + name + "/plain", all, [](const Pair& p) { return plain_hits(p.ray, p.sphere); }, sphere);
  add("ray_box/" + name + "/exact", all, box, box);
  add(
      "ray_box/" + name + "/plain", all, [](const Pair& p) { return plain_hits(p.ray, p.box); }, box);
  add(
      "ray_box/" + name + "/cgal", all, [](const Pair& p) { return cgal_hits(p.ray, p.box); }, box);
  add(
      "first_hit_triangle/" + name + "/exact", all,
      [](const Pair& p) { return first_hit(p.ray, p.triangle).has_value(); }, triangle);
  add(
      "first_hit_sphere/" + name + "/exact", all, [](const Pair& p) { return first_hit(p.ray, p.sphere).has_value(); },
      sphere);
  add(
      "first_hit_box/" + name + "/exact", all, [](const Pair& p) { return first_hit(p.ray, p.box).has_value(); }, box);
}

/// One ray against many small triangles; of `share` in a thousand near to the ray.
struct Scene {
  std::vector<Triangle3> triangles;
  std::vector<Ray3> rays;
};
Scene scene_of(std::size_t n) {
  Source from{Class::uniform};
  Scene s;
  while (s.triangles.size() < n) {
    const Point3 a = from.point();
    const auto near = [&] { return 0.1 * from.number(); };
    s.triangles.push_back({a, {a.x + near(), a.y + near(), a.z + near()}, {a.x + near(), a.y + near(), a.z + near()}});
  }
  for (int i = 0; i < 32; ++i) {
    const Point3 o = from.point(), t = from.point();
    s.rays.push_back({o, {t.x - o.x, t.y - o.y, t.z - o.z}});
  }
  return s;
}

template <class Ask>
void many(benchmark::State& state, Ask ask) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const Scene s = scene_of(n);
  const TriangleBatch batch(s.triangles);
  std::size_t found = 0;
  for (auto _ : state) {
    found = 0;
    for (const Ray3& ray : s.rays) found += ask(ray, s.triangles, batch);
    benchmark::DoNotOptimize(found);
  }
  state.counters["found"] = static_cast<double>(found) / static_cast<double>(s.rays.size());
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(n * s.rays.size()) * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
void many_batch(benchmark::State& state) {
  many(state, [](const Ray3& ray, std::span<const Triangle3>, const TriangleBatch& batch) {
    return all_hits(ray, batch).size();
  });
}
void many_one_by_one(benchmark::State& state) {
  many(state, [](const Ray3& ray, std::span<const Triangle3> triangles, const TriangleBatch&) {
    std::size_t sum = 0;
    for (const Triangle3& t : triangles) sum += static_cast<std::size_t>(hits(ray, t));
    return sum;
  });
}
void first_batch(benchmark::State& state) {
  many(state, [](const Ray3& ray, std::span<const Triangle3>, const TriangleBatch& batch) {
    return static_cast<std::size_t>(first_hit(ray, batch).has_value());
  });
}
void first_plain(benchmark::State& state) {
  many(state, [](const Ray3& ray, std::span<const Triangle3> triangles, const TriangleBatch&) {
    return static_cast<std::size_t>(plain_first_hit(ray, triangles).has_value());
  });
}
BENCHMARK(many_batch)->Arg(1000)->Arg(100000);
BENCHMARK(many_one_by_one)->Arg(1000)->Arg(100000);
BENCHMARK(first_batch)->Arg(1000)->Arg(100000);
BENCHMARK(first_plain)->Arg(1000)->Arg(100000);

[[maybe_unused]] const bool registered = [] {
  for (const auto& [kind, name] : classes) add_class(kind, name);
  return true;
}();

}  // namespace
}  // namespace plumb::bench
