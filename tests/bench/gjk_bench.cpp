// What does GJK cost beside libccd, FCL and Bullet?  Hulls of 8, 32, 128 and 1000 vertices at uniform positions, of which half
// meet; in motion with a warm cache; and where they touch or are one ulp apart.  Names are gjk/work/vertices/method; `wrong`
// counts the answers that are not those of exact numbers.  `over_generic` is the time of a pair that touches over that of one
// at a uniform position by the same question, in the same run; its goal is 3 at most, and 5 of those one ulp apart.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "bench/rivals/gjk/rival.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/separation/separation.hpp"

namespace plumb::bench {
namespace {

/// Points of a sphere of radius 1 about the center: each is a vertex of their hull.
ConvexPolyhedron3 ball_of(std::size_t vertices, const Point3& center, Entropy& entropy) {
  std::vector<Point3> points;
  while (points.size() < vertices) {
    const double x = signed_unit_coordinate(entropy), y = signed_unit_coordinate(entropy),
                 z = signed_unit_coordinate(entropy), square = x * x + y * y + z * z;
    if (square > 1 || square < 0.01) continue;
    const double r = 1 / std::sqrt(square);
    points.push_back({center.x + x * r, center.y + y * r, center.z + z * r});
  }
  return convex_polyhedron(convex_hull(points), points);
}

struct Scene {
  std::vector<ConvexPolyhedron3> a, b;
  std::vector<bool> meet;
};

/// The second within reach of the first, so far away that about half of the pairs meet.
Scene uniform(std::size_t vertices) {
  const std::size_t pairs = vertices > 500 ? 64 : 512;
  Scene s;
  Entropy entropy(71);
  const double spread = vertices < 16 ? 1.35 : 1.75;
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto at = [&] { return spread * signed_unit_coordinate(entropy); };
    s.a.push_back(ball_of(vertices, {0, 0, 0}, entropy));
    s.b.push_back(ball_of(vertices, {at(), at(), at()}, entropy));
    s.meet.push_back(distance(s.a.back(), s.b.back()) == 0);
  }
  return s;
}

const Scene& scene(std::size_t vertices) {
  static std::vector<std::pair<std::size_t, std::unique_ptr<Scene>>> known;
  for (const auto& [n, s] : known) {
    if (n == vertices) return *s;
  }
  known.emplace_back(vertices, std::make_unique<Scene>(uniform(vertices)));
  return *known.back().second;
}

void count(benchmark::State& state, std::size_t pairs) {
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(pairs) * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Meet>
void add_intersects(std::size_t vertices, const std::string& method, Meet meet) {
  const std::string name = "gjk/intersects/" + std::to_string(vertices) + "/" + method;
  benchmark::RegisterBenchmark(name.c_str(), [vertices, meet](benchmark::State& state) {
    const Scene& s = scene(vertices);
    const auto asked = meet(s);
    std::size_t wrong = 0, hits = 0;
    for (std::size_t i = 0; i < s.a.size(); ++i) wrong += asked(i) != s.meet[i], hits += s.meet[i];
    for (auto _ : state) {
      for (std::size_t i = 0; i < s.a.size(); ++i) benchmark::DoNotOptimize(asked(i));
    }
    count(state, s.a.size());
    state.counters["wrong"] = static_cast<double>(wrong);
    state.counters["meet"] = static_cast<double>(hits) / static_cast<double>(s.a.size());
  });
}

std::vector<std::vector<double>> numbers_of(const std::vector<ConvexPolyhedron3>& all) {
  std::vector<std::vector<double>> numbers;
  for (const ConvexPolyhedron3& p : all) {
    numbers.emplace_back();
    for (const Point3& v : p.mesh.vertices) numbers.back().insert(numbers.back().end(), {v.x, v.y, v.z});
  }
  return numbers;
}

void add_rival(std::size_t vertices, const std::string& name, const GjkRival& rival) {
  add_intersects(vertices, name, [rival](const Scene& s) {
    using Held = std::vector<std::shared_ptr<void>>;
    auto a = std::make_shared<Held>(), b = std::make_shared<Held>();
    for (const auto& numbers : numbers_of(s.a)) a->push_back(rival.make(numbers));
    for (const auto& numbers : numbers_of(s.b)) b->push_back(rival.make(numbers));
    return [rival, a, b](std::size_t i) { return rival.meet((*a)[i].get(), (*b)[i].get()); };
  });
}

/// All vertices apart from those of pairs that meet.
void add_apart(std::size_t vertices, const std::string& method,
               double (*ask)(const ConvexPolyhedron3&, const ConvexPolyhedron3&)) {
  const std::string name = "gjk/" + method + "/" + std::to_string(vertices);
  benchmark::RegisterBenchmark(name.c_str(), [vertices, ask](benchmark::State& state) {
    const Scene& s = scene(vertices);
    std::vector<std::size_t> apart;
    for (std::size_t i = 0; i < s.a.size(); ++i) {
      if (!s.meet[i]) apart.push_back(i);
    }
    for (auto _ : state) {
      for (const std::size_t i : apart) benchmark::DoNotOptimize(ask(s.a[i], s.b[i]));
    }
    count(state, apart.size());
  });
}

enum class Motion : unsigned char { slow, quick, jumps };

/// Frames of one body that turns about an axis and moves past another, which are made before.
struct Film {
  ConvexPolyhedron3 a;
  std::vector<ConvexPolyhedron3> frames;
};
Film film(std::size_t vertices, Motion motion) {
  Entropy entropy(72);
  Film f{ball_of(vertices, {0, 0, 0}, entropy), {}};
  const ConvexPolyhedron3 b = ball_of(vertices, {0, 0, 0}, entropy);
  const std::size_t frames = vertices > 500 ? 200 : 400;
  for (std::size_t i = 0; i < frames; ++i) {
    const double step = motion == Motion::slow ? 0.002 : 0.05;
    const double t = motion == Motion::jumps ? 40 * signed_unit_coordinate(entropy) : step * static_cast<double>(i);
    const double c = std::cos(t), s = std::sin(t), x = 2 + 0.5 * std::sin(0.7 * t), y = 0.4 * std::cos(0.3 * t);
    ConvexPolyhedron3 moved = b;
    for (Point3& p : moved.mesh.vertices) p = {c * p.x - s * p.y + x, s * p.x + c * p.y + y, p.z};
    f.frames.push_back(std::move(moved));
  }
  return f;
}

void add_film(std::size_t vertices, const std::string& motion_name, Motion motion, bool is_warm) {
  const std::string name = "gjk/motion_" + motion_name + "/" + std::to_string(vertices) + (is_warm ? "/warm" : "/cold");
  benchmark::RegisterBenchmark(name.c_str(), [vertices, motion, is_warm](benchmark::State& state) {
    const Film f = film(vertices, motion);
    std::size_t meet = 0;
    for (auto _ : state) {
      GjkCache cache;
      meet = 0;
      for (const ConvexPolyhedron3& frame : f.frames) {
        meet += gjk_intersects(f.a, frame, is_warm ? GjkOptions{.cache = &cache} : GjkOptions{});
      }
      benchmark::DoNotOptimize(meet);
    }
    count(state, f.frames.size());
    state.counters["meet"] = static_cast<double>(meet) / static_cast<double>(f.frames.size());
  });
}

/// Exactly touching: the second has a corner of the first for one of its own, or ends in the middle of its edge or face.
enum class Touch : unsigned char { vertex, edge, face, cubes };
/// `apart`: along the face's normal, or the cubes' axis.
Scene touching(std::size_t vertices, Touch touch, double apart) {
  Scene s;
  Entropy entropy(73);
  for (std::size_t i = 0; i < 128; ++i) {
    // Multiples of 2^-20, so that middles are doubles as well.
    const auto short_ball = [&] {
      for (;;) {
        std::vector<Point3> points;
        for (const Point3& p : ball_of(vertices, {0, 0, 0}, entropy).mesh.vertices) {
          const auto cut = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
          points.push_back({cut(p.x), cut(p.y), cut(p.z)});
        }
        const Hull3 hull = convex_hull(points);
        if (hull.dimension == 3) return convex_polyhedron(hull, points);
      }
    };
    if (touch == Touch::cubes) {
      const auto cube = [](double x, double off) {
        std::vector<Point3> points;
        for (const double u : {x, x + 1}) {
          for (const double v : {0.0, 1.0}) {
            for (const double w : {0.0, 1.0}) points.push_back({u + off, v + x / 4, w + x / 8});
          }
        }
        return convex_polyhedron(convex_hull(points), points);
      };
      s.a.push_back(cube(0, 0)), s.b.push_back(cube(1, apart)), s.meet.push_back(apart == 0);
      continue;
    }
    const ConvexPolyhedron3 a = short_ball();
    const auto& m = a.mesh;
    const std::uint32_t f = static_cast<std::uint32_t>(entropy.below(m.first.size() - 1));
    const Point3 p = m.vertices[m.corners[m.first[f]]], q = m.vertices[m.corners[m.first[f] + 1]],
                 r = m.vertices[m.corners[m.first[f] + 2]];
    const Point3 on = touch == Touch::vertex ? p
                      : touch == Touch::edge
                          ? Point3{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2}
                          : Point3{(p.x + q.x + 2 * r.x) / 4, (p.y + q.y + 2 * r.y) / 4, (p.z + q.z + 2 * r.z) / 4};
    // The body turned round about the point.
    const Vector3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
    const Vector3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double off = apart / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    std::vector<Point3> turned;
    for (const Point3& w : m.vertices)
      turned.push_back({2 * on.x - w.x + n.x * off, 2 * on.y - w.y + n.y * off, 2 * on.z - w.z + n.z * off});
    s.a.push_back(a), s.b.push_back(convex_polyhedron(convex_hull(turned), turned));
    s.meet.push_back(distance(s.a.back(), s.b.back()) == 0);
  }
  return s;
}
using Ask = double (*)(const ConvexPolyhedron3&, const ConvexPolyhedron3&);
/// The least of some rounds over all pairs.
double seconds_of_pair(const Scene& s, Ask ask) {
  double least = 1;
  for (int round = 0; round < 20; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < s.a.size(); ++i) benchmark::DoNotOptimize(ask(s.a[i], s.b[i]));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  return least / static_cast<double>(s.a.size());
}

void add_touching(std::size_t vertices, const std::string& touch_name, Touch touch, double apart,
                  const std::string& method, Ask ask) {
  const std::string where = apart == 0 ? "gjk/touching_" : "gjk/one_ulp_apart_";
  const std::string name = where + touch_name + "/" + std::to_string(vertices) + "/" + method;
  benchmark::RegisterBenchmark(name.c_str(), [vertices, touch, apart, ask](benchmark::State& state) {
    const Scene s = touching(vertices, touch, apart);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < s.a.size(); ++i) wrong += gjk_intersects(s.a[i], s.b[i]) != s.meet[i];
    for (auto _ : state) {
      for (std::size_t i = 0; i < s.a.size(); ++i) benchmark::DoNotOptimize(ask(s.a[i], s.b[i]));
    }
    count(state, s.a.size());
    state.counters["wrong"] = static_cast<double>(wrong);
    state.counters["over_generic"] = seconds_of_pair(s, ask) / seconds_of_pair(scene(vertices), ask);
  });
}
void add_touching(std::size_t vertices, const std::string& touch_name, Touch touch) {
  using Solid = ConvexPolyhedron3;
  for (const double apart : {0.0, 0x1p-51}) {
    const auto add = [&](const char* method, Ask ask) {
      add_touching(vertices, touch_name, touch, apart, method, ask);
    };
    add("gjk_intersects", [](const Solid& a, const Solid& b) { return gjk_intersects(a, b) ? 1.0 : 0.0; });
    add("intersects", [](const Solid& a, const Solid& b) { return intersects(a, b) ? 1.0 : 0.0; });
    add("relate", [](const Solid& a, const Solid& b) { return static_cast<double>(relate(a, b)); });
    add("distance", [](const Solid& a, const Solid& b) { return distance(a, b); });
    add("gjk", [](const Solid& a, const Solid& b) { return gjk(a, b).closest.distance; });
    add("gjk_points", [](const Solid& a, const Solid& b) {
      return gjk(VertexHull3{a.mesh.vertices}, VertexHull3{b.mesh.vertices}).closest.distance;
    });
  }
}

[[maybe_unused]] const bool registered = [] {
  for (const std::size_t n : std::array<std::size_t, 4>{8, 32, 128, 1000}) {
    add_intersects(n, "plumb",
                   [](const Scene& s) { return [&s](std::size_t i) { return gjk_intersects(s.a[i], s.b[i]); }; });
    add_intersects(n, "plumb_points", [](const Scene& s) {
      return [&s](std::size_t i) {
        return gjk_intersects(VertexHull3{s.a[i].mesh.vertices}, VertexHull3{s.b[i].mesh.vertices});
      };
    });
    add_intersects(n, "intersects",
                   [](const Scene& s) { return [&s](std::size_t i) { return intersects(s.a[i], s.b[i]); }; });
    for (const GjkRival& rival : gjk_rivals()) add_rival(n, rival.name, rival);
    add_apart(n, "distance", [](const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) { return gjk_distance(a, b); });
    add_apart(n, "closest",
              [](const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) { return gjk(a, b).closest.distance; });
    for (const bool is_warm : {false, true}) {
      add_film(n, "slow", Motion::slow, is_warm);
      add_film(n, "quick", Motion::quick, is_warm);
      add_film(n, "jumps", Motion::jumps, is_warm);
    }
  }
  for (const std::size_t n : std::array<std::size_t, 2>{8, 32}) {
    add_touching(n, "vertex", Touch::vertex);
    add_touching(n, "edge", Touch::edge);
    add_touching(n, "face", Touch::face);
  }
  add_touching(8, "cubes", Touch::cubes);
  return true;
}();

}  // namespace
}  // namespace plumb::bench
