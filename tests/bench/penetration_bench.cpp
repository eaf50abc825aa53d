// How long does the penetration of two convex bodies take?  Ours, exact, and the expanding polytopes of FCL and Bullet
// in doubles, with how many of their answers are wrong: off by more than a millionth, or none.
//
// Classes: hulls of 8, 32 and 128 vertices and oriented boxes, all of which overlap: anywhere, deep in one another,
// barely; boxes that are aligned; and degenerate pairs (degenerate/...), whose goal is five times what hulls of 8 or
// oriented boxes take anywhere: a body with itself, cubes on a lattice, a point in a hull, what touches, what is flat.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/penetration/penetration.hpp"
#ifdef PLUMB_BENCH_PENETRATION_RIVALS
#include "bench/rivals/penetration/rival.hpp"
#endif

namespace plumb {
namespace {

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  /// Of length 1.
  Vector3 direction() {
    std::normal_distribution<double> n;
    const Vector3 v{n(random_), n(random_), n(random_)};
    const double r = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return {v.x / r, v.y / r, v.z / r};
  }

 private:
  std::mt19937_64 random_;
};

/// How far apart the middles of two of size 1 are.
enum class Class { anywhere, deep, shallow };
constexpr std::array<const char*, 3> class_names{"anywhere", "deep", "shallow"};
double distance_in(Class c, Numbers& n) {
  return c == Class::anywhere ? n(0.2, 1.4) : c == Class::deep ? n(0, 0.2) : n(1.5, 1.8);
}

ConvexPolyhedron3 hull_of(std::size_t vertices, const Vector3& at, Numbers& n) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vector3 d = n.direction();
    points.push_back({at.x + d.x, at.y + d.y, at.z + d.z});
  }
  return convex_polyhedron(convex_hull(points), points);
}
Obb3 box_of(bool aligned, const Vector3& at, Numbers& n) {
  const Point3 center{at.x, at.y, at.z};
  if (aligned) return {center, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {0.5, 0.5, 0.5}};
  const Vector3 u = n.direction(), d = n.direction();
  const Vector3 v{u.y * d.z - u.z * d.y, u.z * d.x - u.x * d.z, u.x * d.y - u.y * d.x};
  const double r = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const Vector3 s{v.x / r, v.y / r, v.z / r};
  const Vector3 w{u.y * s.z - u.z * s.y, u.z * s.x - u.x * s.z, u.x * s.y - u.y * s.x};
  return {center, {u, s, w}, {n(0.4, 0.8), n(0.4, 0.8), n(0.4, 0.8)}};
}

template <class Shape>
struct Pairs {
  std::vector<std::pair<Shape, Shape>> all;
  std::vector<double> depth;

  template <class Make>
  Pairs(Class c, bool on_lattice, Make make) {
    Numbers n(29);
    while (all.size() < 256) {
      Vector3 by = n.direction();
      const double far = distance_in(c, n);
      by = {by.x * far, by.y * far, by.z * far};
      if (on_lattice) by = {std::round(by.x * 16) / 16, std::round(by.y * 16) / 16, std::round(by.z * 16) / 16};
      auto a = make(Vector3{0, 0, 0}, n);
      auto b = make(by, n);
      const auto p = penetration(a, b);
      if (!p || p->depth == 0) continue;
      depth.push_back(p->depth);
      all.emplace_back(std::move(a), std::move(b));
    }
  }
};

template <class Ask>
void run(benchmark::State& state, std::size_t count, Ask ask) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(i));
    i = i + 1 == count ? 0 : i + 1;
  }
}

template <class Shape, class Make>
void add(const std::string& name, Class c, bool on_lattice, Make make) {
  const auto pairs = [made = std::make_shared<std::optional<Pairs<Shape>>>(), c, on_lattice, make]() -> Pairs<Shape>& {
    if (!*made) made->emplace(c, on_lattice, make);  // not of classes that are not asked for
    return **made;
  };
  const auto named = [&](const char* what) {
    return name + "/" + class_names[static_cast<std::size_t>(c)] + "/" + what;
  };
  benchmark::RegisterBenchmark(named("plumb").c_str(), [pairs](benchmark::State& s) {
    const auto& all = pairs().all;
    run(s, all.size(), [&](std::size_t i) { return penetration(all[i].first, all[i].second); });
  });
  benchmark::RegisterBenchmark(named("exact").c_str(), [pairs](benchmark::State& s) {
    run(s, pairs().all.size(),
        [&](std::size_t i) { return exact_penetration(pairs().all[i].first, pairs().all[i].second)->is_unique; });
  });
#ifdef PLUMB_BENCH_PENETRATION_RIVALS
  const auto add_rival = [&](const char* rival, auto depth_of) {
    benchmark::RegisterBenchmark(named(rival).c_str(), [pairs, depth_of](benchmark::State& s) {
      std::vector<bench::AskDepth> ask;
      int wrong = 0;
      for (std::size_t i = 0; i < pairs().all.size(); ++i) {
        ask.push_back(depth_of(pairs().all[i].first, pairs().all[i].second));
        wrong += std::fabs(ask[i]() - pairs().depth[i]) <= 1e-6 * pairs().depth[i] ? 0 : 1;
      }
      s.counters["wrong of 256"] = wrong;
      run(s, ask.size(), [&](std::size_t i) { return ask[i](); });
    });
  };
  add_rival("fcl", [](const Shape& a, const Shape& b) { return bench::fcl_depth(a, b); });
  add_rival("bullet", [](const Shape& a, const Shape& b) { return bench::bullet_depth(a, b); });
#endif
}

/// Ours alone; of pairs that are made one by one.
template <class Make>
void add_degenerate(const std::string& name, Make make) {
  benchmark::RegisterBenchmark(("degenerate/" + name + "/plumb").c_str(), [make](benchmark::State& s) {
    Numbers n(31);
    std::vector<decltype(make(n))> all;
    while (all.size() < 64) all.push_back(make(n));
    run(s, all.size(), [&](std::size_t i) { return penetration(all[i].first, all[i].second); });
  });
}

ConvexPolyhedron3 cube_at(const Point3& at) {
  std::vector<Point3> corners;
  for (unsigned i = 0; i < 8; ++i) corners.push_back({at.x + (i & 1), at.y + (i >> 1 & 1), at.z + (i >> 2 & 1)});
  return convex_polyhedron(convex_hull(corners), corners);
}
/// Its first three corners.
Triangle3 part_of_face(const ConvexPolyhedron3& p) {
  const auto corner = [&](std::size_t i) { return p.mesh.vertices[p.mesh.corners[i]]; };
  return {corner(0), corner(1), corner(2)};
}

void add_degenerate_pairs() {
  for (const std::size_t vertices : {8, 32}) {
    const std::string of = "hull" + std::to_string(vertices);
    const auto hull = [=](Numbers& n) { return hull_of(vertices, {0, 0, 0}, n); };
    add_degenerate(of + "_itself", [=](Numbers& n) {
      const ConvexPolyhedron3 p = hull(n);
      return std::pair(p, p);
    });
    add_degenerate(of + "_point_inside", [=](Numbers& n) {
      return std::pair(Point3{n(-0.2, 0.2), n(-0.2, 0.2), n(-0.2, 0.2)}, hull(n));
    });
    add_degenerate(of + "_touched_at_vertex", [=](Numbers& n) {
      const ConvexPolyhedron3 p = hull(n);
      return std::pair(p.mesh.vertices[0], p);
    });
    add_degenerate(of + "_touched_at_face", [=](Numbers& n) {
      const ConvexPolyhedron3 p = hull(n);
      return std::pair(part_of_face(p), p);
    });
  }
  add_degenerate("cubes_on_lattice", [](Numbers& n) {
    const auto step = [&] { return std::round(n(-2, 2)) / 2; };
    return std::pair(cube_at({0, 0, 0}), cube_at({step(), step(), step()}));
  });
  add_degenerate("box_itself", [](Numbers& n) {
    const Obb3 b = box_of(false, {0, 0, 0}, n);
    return std::pair(b, b);
  });
  add_degenerate("aabbs_on_lattice", [](Numbers& n) {
    const auto step = [&] { return std::round(n(-8, 8)) / 8; };
    const Point3 p{step(), step(), step()};
    return std::pair(Aabb3{{0, 0, 0}, {1, 1, 1}}, Aabb3{p, {p.x + 1, p.y + 1, p.z + 1}});
  });
  add_degenerate("triangles_in_one_plane", [](Numbers& n) {
    const auto point = [&] { return Point3{n(-1, 1), n(-1, 1), 0}; };
    return std::pair(Triangle3{point(), point(), {0, 0, 0}}, Triangle3{point(), point(), {0, 0, 0}});
  });
}

const bool added = [] {
  add_degenerate_pairs();
  for (const Class c : {Class::anywhere, Class::deep, Class::shallow}) {
    for (const std::size_t vertices : {8, 32, 128}) {
      add<ConvexPolyhedron3>("hulls" + std::to_string(vertices), c, false,
                             [=](const Vector3& at, Numbers& n) { return hull_of(vertices, at, n); });
    }
    add<Obb3>("boxes", c, false, [](const Vector3& at, Numbers& n) { return box_of(false, at, n); });
  }
  add<Obb3>("boxes_aligned", Class::deep, true, [](const Vector3& at, Numbers& n) { return box_of(true, at, n); });
  return true;
}();

}  // namespace
}  // namespace plumb
