// How long does a frame of a world take?  Ten thousand cubes in stacks of ten, each resting on the one below, all of
// which are moved: pairs alone, and pairs with contacts, exact, on one thread; and Bullet's collision world, which keeps
// its manifolds from frame to frame.
//
// Scenes: `upright`, where no cube is turned; `turned`, each by its own angle about the upright axis; `resting`: each
// cube is moved to where it is.  `one_moves`: of all of them one cube alone.  `many`: a hundred thousand cubes strewn in
// space, of which one in a hundred moves; rays among them.  `stones`: two hundred meshes that move, with the proxies that a
// plan takes, and without.  Bullet and FCL have the stacks, and what is strewn.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/world.hpp"
#ifdef PLUMB_BENCH_WORLD_RIVALS
#include "bench/rivals/world/rival.hpp"
#endif

namespace plumb {
namespace {

constexpr std::size_t stacks = 1000, high = 10;

/// Of cube k of stack i: where it stands in a frame, and the tangent of half its angle.
std::array<double, 4> place(std::size_t i, std::size_t k, std::size_t frame, bool is_turned) {
  const double turn = is_turned ? static_cast<double>((k * 7 + i) % 8) * 0.125 : 0;
  return {static_cast<double>(i % 32) * 1.8 + static_cast<double>(frame % 16) * 0.01, static_cast<double>(i / 32) * 1.8,
          static_cast<double>(k), turn};
}
RigidPose pose_at(const std::array<double, 4>& at) { return {{1, 0, 0, at[3]}, {at[0], at[1], at[2]}}; }

enum class Moves { all, none };

void frames(benchmark::State& state, bool has_contacts, bool is_turned, Moves moves = Moves::all) {
  CollisionWorld world({.contacts = has_contacts, .execution = Execution::serial});
  std::vector<BodyHandle> cubes;
  for (std::size_t n = 0; n < stacks * high; ++n) {
    cubes.push_back(
        world.add(Posed{Aabb3{{-0.5, -0.5, 0}, {0.5, 0.5, 1}}, pose_at(place(n / high, n % high, 0, is_turned))},
                  {.user_id = n}));
  }
  world.commit();
  std::size_t frame = 0, corners = 0;
  for (auto _ : state) {
    frame += moves == Moves::all ? 1 : 0;
    for (std::size_t n = 0; n < cubes.size(); ++n) {
      world.move(cubes[n], pose_at(place(n / high, n % high, frame, is_turned)));
    }
    benchmark::DoNotOptimize(world.commit());
  }
  if (has_contacts) {
    for (const WorldContact& c : world.contacts()) corners += c.manifold.corners.size();
  }
  state.counters["pairs"] = static_cast<double>(world.pairs().size());
  state.counters["corners"] = static_cast<double>(corners);
}
BENCHMARK_CAPTURE(frames, pairs / upright, false, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, contacts / upright, true, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, pairs / turned, false, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, contacts / turned, true, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, contacts / turned / resting, true, true, Moves::none)->Unit(benchmark::kMillisecond);

void one_moves(benchmark::State& state) {
  CollisionWorld world({.contacts = true, .execution = Execution::serial});
  std::vector<BodyHandle> cubes;
  for (std::size_t n = 0; n < stacks * high; ++n) {
    cubes.push_back(world.add(
        Posed{Aabb3{{-0.5, -0.5, 0}, {0.5, 0.5, 1}}, pose_at(place(n / high, n % high, 0, false))}, {.user_id = n}));
  }
  world.commit();
  std::size_t frame = 0;
  for (auto _ : state) {
    world.move(cubes[5], pose_at(place(0, 5, ++frame, false)));
    benchmark::DoNotOptimize(world.commit());
  }
}
BENCHMARK(one_moves)->Unit(benchmark::kMillisecond);

/// A hundred thousand cubes, strewn.
struct Strewn {
  CollisionWorld world{{.execution = Execution::serial}};
  Entropy entropy{4900};
  std::vector<BodyHandle> cubes;
  std::vector<Vector3> places;

  Strewn() {
    for (std::size_t n = 0; n < 100000; ++n) {
      places.push_back(place());
      cubes.push_back(world.add(Posed{Aabb3{{0, 0, 0}, {1, 1, 1}}, RigidPose{{}, places[n]}}, {.user_id = n}));
    }
    world.commit();
  }
  Vector3 place() {
    const auto side = [&] { return static_cast<double>(entropy.within(100000)) / 1000; };
    return {side(), side(), side()};
  }
};

void many_of_which_few_move(benchmark::State& state) {
  Strewn strewn;
  for (auto _ : state) {
    for (std::size_t n = 0; n < strewn.cubes.size() / 100; ++n) {
      const std::size_t k = strewn.entropy.below(strewn.cubes.size());
      strewn.places[k].x += 0.05;
      strewn.world.move(strewn.cubes[k], RigidPose{{}, strewn.places[k]});
    }
    benchmark::DoNotOptimize(strewn.world.commit());
  }
  state.counters["pairs"] = static_cast<double>(strewn.world.pairs().size());
}
BENCHMARK(many_of_which_few_move)->Unit(benchmark::kMillisecond);

void rays_among_many(benchmark::State& state) {
  Strewn strewn;
  std::size_t hit = 0, asked = 0;
  for (auto _ : state) {
    const Vector3 from = strewn.place(), along = strewn.place();
    hit += strewn.world.first_hit(Ray3{{from.x, from.y, from.z}, along}) ? 1 : 0, ++asked;
  }
  state.counters["hit"] = static_cast<double>(hit) / static_cast<double>(asked);
}
BENCHMARK(rays_among_many)->Unit(benchmark::kMicrosecond);

/// A stone: the hull of points on a ball, as a mesh.
SharedMesh stone(Entropy& e) {
  std::vector<Point3> points;
  while (points.size() < 60) {
    const auto side = [&] { return static_cast<double>(e.within(1000)) / 1000; };
    const Vector3 v{side(), side(), side()};
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    if (length > 0.1) points.push_back({v.x / length, v.y / length, v.z / length});
  }
  const Hull3 hull = convex_hull(points, {.triangulate = true});
  TriangleMesh mesh{points, {}};
  for (std::size_t f = 0; f < hull.face_count(); ++f)
    mesh.triangles.push_back({hull.face(f)[0], hull.face(f)[1], hull.face(f)[2]});
  return SharedMesh(mesh);
}

/// Two hundred stones that turn and move a little in each frame, with the proxies that a plan takes, and without.
void stones(benchmark::State& state, bool is_planned) {
  Entropy e(4901);
  CollisionWorld world({.execution = Execution::serial});
  std::vector<SharedMesh> kinds;
  for (int k = 0; k < 8; ++k) kinds.push_back(stone(e));
  std::vector<BodyHandle> handles;
  std::vector<RigidPose> poses;
  const auto number = [&](int most) { return static_cast<double>(e.within(most * 1000)) / 1000; };
  for (std::size_t n = 0; n < 200; ++n) {
    poses.push_back({{4, std::floor(number(4)), std::floor(number(4)), 1}, {number(5), number(5), number(5)}});
    handles.push_back(world.add(AnyBody(kinds[n % kinds.size()], poses[n]), {.user_id = n}));
  }
  if (is_planned) {
    const WorldPlan scene = plan(world);
    adopt(world, scene);
    state.counters["without"] = static_cast<double>(scene.questions_without);
    state.counters["with"] = static_cast<double>(scene.questions_with);
  }
  world.commit();
  for (auto _ : state) {
    for (std::size_t n = 0; n < handles.size(); ++n) {
      poses[n].translation.x += 0x1p-10;
      world.move(handles[n], poses[n]);
    }
    benchmark::DoNotOptimize(world.commit());
  }
  state.counters["pairs"] = static_cast<double>(world.pairs().size());
}
BENCHMARK_CAPTURE(stones, as they are, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stones, as planned, true)->Unit(benchmark::kMillisecond);

#ifdef PLUMB_BENCH_WORLD_RIVALS
void bullet(benchmark::State& state, bool is_turned) {
  rivals::BulletCubes cubes(stacks * high);
  std::size_t frame = 0, points = 0;
  for (auto _ : state) {
    ++frame;
    for (std::size_t n = 0; n < stacks * high; ++n) cubes.place(n, place(n / high, n % high, frame, is_turned));
    points = cubes.detect();
  }
  state.counters["corners"] = static_cast<double>(points);
}
BENCHMARK_CAPTURE(bullet, upright, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bullet, turned, true)->Unit(benchmark::kMillisecond);

/// The cubes that are strewn, where the library of a rival has them: its own stand on the middle of their faces.
template <class Cubes>
struct StrewnElsewhere {
  Cubes cubes{100000};
  Entropy entropy{4900};
  std::vector<Vector3> places;

  StrewnElsewhere() {
    for (std::size_t n = 0; n < 100000; ++n) {
      places.push_back(place());
      put(n);
    }
    (void)cubes.detect();
  }
  Vector3 place() {
    const auto side = [&] { return static_cast<double>(entropy.within(100000)) / 1000; };
    return {side(), side(), side()};
  }
  void put(std::size_t n) { cubes.place(n, {places[n].x + 0.5, places[n].y + 0.5, places[n].z, 0}); }
};

template <class Cubes>
void many_elsewhere(benchmark::State& state) {
  StrewnElsewhere<Cubes> strewn;
  std::size_t found = 0;
  for (auto _ : state) {
    for (std::size_t n = 0; n < strewn.places.size() / 100; ++n) {
      const std::size_t k = strewn.entropy.below(strewn.places.size());
      strewn.places[k].x += 0.05;
      strewn.put(k);
    }
    found = strewn.cubes.detect();
  }
  state.counters["found"] = static_cast<double>(found);
}
BENCHMARK_TEMPLATE(many_elsewhere, rivals::BulletCubes)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(many_elsewhere, rivals::FclCubes)->Unit(benchmark::kMillisecond);

void rays_in_bullet(benchmark::State& state) {
  StrewnElsewhere<rivals::BulletCubes> strewn;
  std::size_t hit = 0, asked = 0;
  for (auto _ : state) {
    const Vector3 from = strewn.place(), along = strewn.place();
    const double far = 400 / std::hypot(along.x, along.y, along.z);  // beyond all of them
    const std::array<double, 3> to{from.x + far * along.x, from.y + far * along.y, from.z + far * along.z};
    hit += strewn.cubes.is_met({from.x, from.y, from.z}, to) ? 1 : 0, ++asked;
  }
  state.counters["hit"] = static_cast<double>(hit) / static_cast<double>(asked);
}
BENCHMARK(rays_in_bullet)->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
}  // namespace plumb
