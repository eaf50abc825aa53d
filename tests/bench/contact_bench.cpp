// How long does a contact of two bodies take, with all its corners?  Ours, exact, cold and with a cache, and Bullet's box
// detector and GJK with the expanding polytope algorithm.
//
// The rows `again` ask the same pair with the cache that it left; the rows `frames/` ask truly the next frame: a cache is kept
// for each pair, and between two of its questions both bodies have moved a little.  Their frames go forth and back, so
// that none is far from the one before.  Bullet asks its detector anew in each frame, as its own scenes do.
//
// Scenes: a crate on a table, turned about the upright axis and so resting exactly, a millimeter above, a millimeter in
// it; the same on a slope, where no axis is exactly parallel to another; the neighbors in towers of four crates that all but
// rest, as in docs/examples/stack; hulls of 32 vertices that overlap barely, or are barely apart.  Frames: towers that
// tremble, a crate that slides down the slope, one that spins on the table and one that spins on the slope, hulls that roll.
// Bullet's boxes tell nothing of what is apart; its hulls tell one point a call.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>

#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/contact/contact.hpp"
#ifdef PLUMB_BENCH_CONTACT_RIVALS
#include "bench/rivals/contact/rival.hpp"
#endif

namespace plumb {
namespace {

/// Turned about the upright axis, then down a slope.
std::array<Vector3, 3> axes(double yaw, double slope) {
  const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(slope), t = std::sin(slope);
  return {Vector3{c * d, c * t, -s}, Vector3{-t, d, 0}, Vector3{s * d, s * t, c}};
}

template <class Shape>
using Pairs = std::vector<std::pair<Shape, Shape>>;

Pairs<Obb3> crates(double slope, double height) {
  Pairs<Obb3> all;
  for (int i = 0; i < 64; ++i) {
    const auto under = axes(0, slope), upon = axes(0.1 * i + 0.05, slope);
    const Vector3 up = under[1];
    const double h = 1 + height;
    all.emplace_back(Obb3{{h * up.x, h * up.y, h * up.z}, upon, {0.5, 0.5, 0.5}}, Obb3{{0, 0, 0}, under, {8, 0.5, 8}});
  }
  return all;
}

/// Sunk into one another by what impulses leave, and tilted by as little; axes of quaternions, rounded.
Pairs<Obb3> tower() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> n;
  const auto tilted = [&] {
    const double x = 1e-5 * n(random), y = 0.2 * n(random), z = 1e-5 * n(random),
                 w = std::sqrt(1 - x * x - y * y - z * z);
    return std::array{Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                      Vector3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                      Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
  };
  Pairs<Obb3> all;
  while (all.size() < 64) {
    Obb3 under{{0, -0.5, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {20, 0.5, 20}};  // the ground
    double top = 0;
    for (int level = 0; level < 4; ++level, top += 1) {
      const double sunk = 2e-4 * std::fabs(n(random)) + 1e-5;
      const Obb3 crate{{0.02 * n(random), top + 0.5 - sunk, 0.02 * n(random)}, tilted(), {0.5, 0.5, 0.5}};
      all.emplace_back(crate, under);
      under = crate, top -= sunk;
    }
  }
  return all;
}

/// Of each frame, in order, the same pairs.
template <class Shape>
using Frames = std::vector<Pairs<Shape>>;
constexpr int frame_count = 32;

/// In each frame every crate has moved by some micrometers and turned by some microradians.
Frames<Obb3> trembling() {
  std::mt19937_64 random(11);
  std::normal_distribution<double> n;
  Frames<Obb3> all{tower()};
  const auto moved = [&](Obb3 o) {
    if (o.half.x > 1) return o;  // the ground
    o.center = {o.center.x + 1e-6 * n(random), o.center.y + 1e-6 * n(random), o.center.z + 1e-6 * n(random)};
    const Vector3 by{1e-6 * n(random), 1e-5 * n(random), 1e-6 * n(random)};
    for (Vector3& v : o.axes) {
      v = {v.x + by.y * v.z - by.z * v.y, v.y + by.z * v.x - by.x * v.z, v.z + by.x * v.y - by.y * v.x};
    }
    return o;
  };
  while (all.size() < frame_count) {
    const Pairs<Obb3>& last = all.back();
    Pairs<Obb3> next;
    for (std::size_t i = 0; i < last.size(); ++i) {  // four levels a tower: each crate stands on the one before
      const Obb3 under = i % 4 == 0 ? last[i].second : next[i - 1].first;
      next.emplace_back(moved(last[i].first), under);
    }
    all.push_back(std::move(next));
  }
  return all;
}

/// A crate that goes on by `step` down the slope and by `turn` about its normal, sunk by what impulses leave.
Frames<Obb3> going(double slope, double step, double turn) {
  Frames<Obb3> all(frame_count);
  for (int frame = 0; frame < frame_count; ++frame) {
    for (int i = 0; i < 16; ++i) {
      const auto under = axes(0, slope), upon = axes(0.1 * i + 0.05 + turn * frame, slope);
      const Vector3 up = under[1], down = under[0];
      const double h = 1 - 1e-4 * (1 + 0.1 * i) - 1e-6 * frame, along = step * frame;
      const Point3 at{h * up.x + along * down.x, h * up.y + along * down.y, h * up.z + along * down.z};
      all[static_cast<std::size_t>(frame)].emplace_back(Obb3{at, upon, {0.5, 0.5, 0.5}},
                                                        Obb3{{0, 0, 0}, under, {8, 0.5, 8}});
    }
  }
  return all;
}

ConvexPolyhedron3 hull_at(double x, std::mt19937_64& random) {
  std::vector<Point3> points;
  std::normal_distribution<double> n;
  while (points.size() < 32) {
    const Vector3 v{n(random), n(random), n(random)};
    const double r = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    points.push_back({x + v.x / r, v.y / r, v.z / r});
  }
  return convex_polyhedron(convex_hull(points), points);
}
Pairs<ConvexPolyhedron3> hulls(double apart) {
  std::mt19937_64 random(5);
  Pairs<ConvexPolyhedron3> all;
  while (all.size() < 64) {
    auto a = hull_at(0, random), b = hull_at(apart, random);
    if (contact(a, b, {.margin = 0.5})) all.emplace_back(std::move(a), std::move(b));
  }
  return all;
}

/// The second of each pair goes on along all three axes.
Frames<ConvexPolyhedron3> rolling(double apart) {
  Frames<ConvexPolyhedron3> all{hulls(apart)};
  all[0].resize(16);
  while (all.size() < frame_count) {
    Pairs<ConvexPolyhedron3> next = all.back();
    for (auto& [a, b] : next) {
      for (Point3& p : b.mesh.vertices) {  // a shear is as good as a turn, and keeps faces planar: these are triangles
        p = {p.x - 1e-4, p.y + 1e-4 * p.z, p.z - 1e-4 * p.y};
      }
    }
    all.push_back(std::move(next));
  }
  return all;
}

template <class Ask>
void run(benchmark::State& state, std::size_t count, Ask ask) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(i));
    i = i + 1 == count ? 0 : i + 1;
  }
}

template <class Shape>
void add(const std::string& name, const std::function<Pairs<Shape>()>& make, double margin) {
  const auto pairs = std::make_shared<std::optional<Pairs<Shape>>>();
  const auto made = [=]() -> const Pairs<Shape>& { return *pairs ? **pairs : pairs->emplace(make()); };
  const ContactManifoldOptions options{.margin = margin};
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), [=](benchmark::State& s) {
    run(s, made().size(), [&](std::size_t i) { return contact(made()[i].first, made()[i].second, options); });
  });
  benchmark::RegisterBenchmark((name + "/again").c_str(), [=](benchmark::State& s) {
    std::vector<ContactCache> caches(made().size());
    run(s, made().size(),
        [&](std::size_t i) { return contact(made()[i].first, made()[i].second, options, &caches[i]); });
  });
#ifdef PLUMB_BENCH_CONTACT_RIVALS
  benchmark::RegisterBenchmark((name + "/bullet").c_str(), [=](benchmark::State& s) {
    std::vector<bench::AskContact> ask;
    for (const auto& [a, b] : made()) ask.push_back(bench::bullet_contact(a, b));
    run(s, ask.size(), [&](std::size_t i) { return ask[i](); });
  });
#endif
}

/// Forth and back.
std::size_t frame_at(std::size_t step) {
  const std::size_t way = frame_count - 1, place = step % (2 * way);
  return place < way ? place : 2 * way - place;
}

template <class Shape>
void add_frames(const std::string& name, const std::function<Frames<Shape>()>& make, double margin) {
  const auto frames = std::make_shared<std::optional<Frames<Shape>>>();
  const auto made = [=]() -> const Frames<Shape>& { return *frames ? **frames : frames->emplace(make()); };
  const ContactManifoldOptions options{.margin = margin};
  const auto add_row = [&](const char* row, const auto& ask) {
    benchmark::RegisterBenchmark((name + row).c_str(), [=](benchmark::State& s) {
      const Frames<Shape>& all = made();
      std::vector<ContactCache> caches(all[0].size());
      std::size_t step = 0, i = 0;
      for (auto _ : s) {
        const auto& [a, b] = all[frame_at(step)][i];
        benchmark::DoNotOptimize(ask(a, b, caches[i]));
        if (++i == caches.size()) i = 0, ++step;
      }
    });
  };
  add_row("/plumb", [=](const Shape& a, const Shape& b, ContactCache&) { return contact(a, b, options); });
  add_row("/cache", [=](const Shape& a, const Shape& b, ContactCache& c) { return contact(a, b, options, &c); });
#ifdef PLUMB_BENCH_CONTACT_RIVALS
  benchmark::RegisterBenchmark((name + "/bullet").c_str(), [=](benchmark::State& s) {
    std::vector<bench::AskContact> ask;
    for (const auto& pairs : made()) {
      for (const auto& [a, b] : pairs) ask.push_back(bench::bullet_contact(a, b));
    }
    run(s, ask.size(), [&](std::size_t i) { return ask[i](); });
  });
#endif
}

const bool added = [] {
  for (const double slope : {0.0, 0.3}) {
    const std::string on = slope == 0 ? "boxes_on_table/" : "boxes_on_slope/";
    for (const double height : {1e-3, 0.0, -1e-3}) {
      const std::string name = on + (height > 0 ? "apart" : height == 0 ? "resting" : "overlapping");
      const auto make = [=] { return crates(slope, height); };
      add<Obb3>(name, make, 0.01);
    }
  }
  add<Obb3>("stack", tower, 0.02);
  const auto near = [] { return hulls(1.95); };
  const auto deep = [] { return hulls(1.6); };
  add<ConvexPolyhedron3>("hulls32/apart", near, 0.5);
  add<ConvexPolyhedron3>("hulls32/overlapping", deep, 0.5);
  add_frames<Obb3>("frames/tower_trembles", trembling, 0.02);
  add_frames<Obb3>(
      "frames/box_slides_on_slope", [] { return going(0.3, 1e-3, 0); }, 0.02);
  add_frames<Obb3>(
      "frames/box_spins_on_table", [] { return going(0, 0, 0.01); }, 0.02);
  add_frames<Obb3>(
      "frames/box_spins_on_slope", [] { return going(0.3, 0, 0.01); }, 0.02);
  add_frames<ConvexPolyhedron3>(
      "frames/hulls32_roll_apart", [] { return rolling(1.95); }, 0.5);
  add_frames<ConvexPolyhedron3>(
      "frames/hulls32_roll_overlapping", [] { return rolling(1.6); }, 0.5);
  return true;
}();

}  // namespace
}  // namespace plumb
