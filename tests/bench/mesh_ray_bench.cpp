// How long do rays at a mesh take?  One thread, beside Embree's robust scene where it is installed, on the same rays.
//
// Meshes: a closed wavy ring of n triangles.  Rays: `random` from around the mesh to places in its box; `camera` from
// one place through the pixels of an image, in rows; `vertices` at vertices of the mesh, from outside, as segments that
// end there, so that each must hit.  `alone` asks one ray a call.  `degenerate` asks one ray a call as well: through
// vertices, through the middles of edges and along edges of a ring on a grid, and in the plane of a flat plate, across
// its cells and along their edges; the plate is level, tilted, or of rounded coordinates, in whose triangles the ray
// runs nearly or exactly.
// `rays` is rays a second, `missed` the share that hits nothing: at the vertices a leak.  `bytes` is memory for each
// triangle.
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#ifdef PLUMB_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif

namespace plumb::bench {
namespace {

enum class Aim : int { random, camera, vertices };

/// From a to b; at vertices no farther.
struct Shot {
  Point3 a, b;
};

struct Scene {
  TriangleMesh mesh;
  Bvh bvh;
};

const Scene& scene_of(std::int64_t size) {
  static std::vector<std::pair<std::int64_t, Scene>> made;
  for (const auto& [n, scene] : made) {
    if (n == size) return scene;
  }
  Scene scene{meshes::ring(static_cast<std::uint32_t>(size)), {}};
  // In floats, so that all are asked about the same triangles.
  for (Point3& p : scene.mesh.vertices) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = static_cast<double>(static_cast<float>(*x));
  }
  scene.bvh = build_bvh(scene.mesh);
  return made.emplace_back(size, std::move(scene)).second;
}

Point3 in_floats(double x, double y, double z) {
  const auto one = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  return {one(x), one(y), one(z)};
}

std::vector<Shot> shots_of(const TriangleMesh& mesh, Aim aim) {
  constexpr std::int64_t side = 512;
  std::vector<Shot> shots;
  Entropy e(77);
  const auto number = [&] { return signed_unit_coordinate(e); };
  for (std::int64_t i = 0; i < side * side; ++i) {
    const Point3 eye = in_floats(2.5, 1.5, 1.8);
    if (aim == Aim::random) {
      const double x = 3 * number(), y = 3 * number(), z = 3 * number();
      shots.push_back({in_floats(x, y, z), in_floats(1.4 * number(), 1.4 * number(), 0.4 * number())});
    } else if (aim == Aim::camera) {
      const double u = static_cast<double>(i % side) / side - 0.5, v = static_cast<double>(i / side) / side - 0.5;
      shots.push_back({eye, in_floats(1.6 * u - 0.5 * v, -2.6 * u, 2 * v)});
    } else {
      shots.push_back({eye, mesh.vertices[e.below(mesh.vertices.size())]});
    }
  }
  return shots;
}

std::vector<AnyRay> rays_of(const std::vector<Shot>& shots, Aim aim) {
  std::vector<AnyRay> rays;
  for (const auto& [a, b] : shots) {
    if (aim == Aim::vertices) {
      rays.emplace_back(Segment3{a, b});
    } else {
      const Point3 d = in_floats(b.x - a.x, b.y - a.y, b.z - a.z);
      rays.emplace_back(Ray3{a, {d.x, d.y, d.z}});
    }
  }
  return rays;
}

void report(benchmark::State& state, std::size_t rays, std::size_t hit) {
  const auto n = static_cast<double>(rays);
  state.counters["rays"] = benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["missed"] = 1 - static_cast<double>(hit) / n;
}

void first_of_plumb(benchmark::State& state) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  std::vector<std::uint32_t> out(rays.size());
  for (auto _ : state) first_triangle(scene.bvh, rays, out, {.execution = Execution::serial});
  report(state, rays.size(), rays.size() - static_cast<std::size_t>(std::count(out.begin(), out.end(), no_triangle)));
  state.counters["bytes"] =
      static_cast<double>(memory_of(scene.bvh)) / static_cast<double>(scene.mesh.triangles.size());
}

void numbers_of_plumb(benchmark::State& state) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  std::vector<std::optional<NumberedHit>> out(rays.size());
  for (auto _ : state) first_hit(scene.bvh, rays, out, {.execution = Execution::serial});
  report(
      state, rays.size(),
      static_cast<std::size_t>(std::count_if(out.begin(), out.end(), [](const auto& hit) { return hit.has_value(); })));
}

void alone_of_plumb(benchmark::State& state, bool numbers) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  std::size_t hit = 0;
  for (auto _ : state) {
    hit = 0;
    for (const AnyRay& ray : rays)
      hit += numbers ? first_hit(scene.bvh, ray).has_value() : first_triangle(scene.bvh, ray).has_value();
  }
  report(state, rays.size(), hit);
}

enum class Degenerate : int {
  vertices,
  middles,
  edges,
  across_level,
  along_level,
  across_tilted,
  along_tilted,
  rounded
};

/// Spanned by two edges, of n by n cells.
TriangleMesh plate(std::uint32_t n, const Vector3& u, const Vector3& v) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j)
      mesh.vertices.push_back({i * u.x + j * v.x, i * u.y + j * v.y, i * u.z + j * v.z});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      mesh.triangles.push_back({a, b, b + 1});
      mesh.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return mesh;
}

struct DegenerateScene {
  TriangleMesh mesh;
  std::vector<AnyRay> rays;
};

DegenerateScene degenerate_scene(Degenerate kind) {
  constexpr std::uint32_t side = 160, rays = 4096;
  Entropy e(78);
  DegenerateScene scene;
  if (kind > Degenerate::edges) {
    const bool level = kind == Degenerate::across_level || kind == Degenerate::along_level;
    const bool along = kind == Degenerate::along_level || kind == Degenerate::along_tilted;
    const auto [u, v] = level                         ? std::pair(Vector3{1, 0, 0}, Vector3{0, 1, 0})
                        : kind == Degenerate::rounded ? std::pair(Vector3{0.1, 0.7, 0.3}, Vector3{-0.9, 0.2, 0.6})
                                                      : std::pair(Vector3{3, 1, -2}, Vector3{-1, 4, 1});
    scene.mesh = plate(side, u, v);
    for (std::uint32_t i = 0; i < rays; ++i) {
      const auto at = -1 - static_cast<double>(e.below(50)), row = static_cast<double>(e.below(side));
      const double x = along ? 1 : 1 + static_cast<double>(e.below(20));
      const double y = along ? 0 : static_cast<double>(e.within(20));
      scene.rays.emplace_back(Ray3{{at * u.x + row * v.x, at * u.y + row * v.y, at * u.z + row * v.z},
                                   {x * u.x + y * v.x, x * u.y + y * v.y, x * u.z + y * v.z}});
    }
    return scene;
  }
  constexpr double unit = 0x1p-29;
  scene.mesh = meshes::ring(side);
  for (Point3& p : scene.mesh.vertices) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = 2 * unit * std::round(*x / (2 * unit));
  }
  for (std::uint32_t i = 0; i < rays; ++i) {
    const auto& t = scene.mesh.triangles[e.below(scene.mesh.triangles.size())];
    const Point3 &p = scene.mesh.vertices[t[0]], &q = scene.mesh.vertices[t[1]];
    Vector3 d{q.x - p.x, q.y - p.y, q.z - p.z};
    Point3 at = p;
    if (kind == Degenerate::middles) at = {p.x + d.x / 2, p.y + d.y / 2, p.z + d.z / 2};
    if (kind != Degenerate::edges) {
      for (double* x : {&d.x, &d.y, &d.z}) *x = unit * static_cast<double>(e.within(5));
      if (d == Vector3{0, 0, 0}) d.x = unit;
    }
    double t0 = 1;  // the ray is at the target exactly there
    while (t0 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 8) t0 *= 2;
    scene.rays.emplace_back(Ray3{{at.x - t0 * d.x, at.y - t0 * d.y, at.z - t0 * d.z}, d});
  }
  return scene;
}

void degenerate(benchmark::State& state) {
  const DegenerateScene scene = degenerate_scene(static_cast<Degenerate>(state.range(0)));
  const Bvh bvh = build_bvh(scene.mesh);
  std::size_t hit = 0;
  for (auto _ : state) {
    hit = 0;
    for (const AnyRay& ray : scene.rays) hit += first_hit(bvh, ray).has_value();
  }
  report(state, scene.rays.size(), hit);
}

void any_of_plumb(benchmark::State& state) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  std::vector<std::uint8_t> out(rays.size());
  for (auto _ : state) any_hit(scene.bvh, rays, out, {.execution = Execution::serial});
  report(state, rays.size(), static_cast<std::size_t>(std::count(out.begin(), out.end(), 1)));
}

// The mesh under a turn, and the rays turned with it; `together` at once, else each alone.
void first_of_posed(benchmark::State& state, bool together) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const double c = 0.8, s = 0.6;
  const auto turned = [&](double x, double y) { return std::pair{c * x - s * y, s * x + c * y}; };
  const PosedMesh mesh{scene.bvh, {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, {0.5, 0.25, 0}}};
  std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  for (AnyRay& r : rays) {
    std::tie(r.direction.x, r.direction.y) = turned(r.direction.x, r.direction.y);
    for (Point3* p : {&r.origin, &r.end}) {
      std::tie(p->x, p->y) = turned(p->x, p->y);
      p->x += 0.5, p->y += 0.25;
    }
  }
  std::vector<std::uint32_t> out(rays.size());
  for (auto _ : state) {
    if (together) {
      first_triangle(mesh, rays, out, {.execution = Execution::serial});
    } else {
      for (std::size_t i = 0; i < rays.size(); ++i) out[i] = first_triangle(mesh, rays[i]).value_or(no_triangle);
    }
  }
  report(state, rays.size(), rays.size() - static_cast<std::size_t>(std::count(out.begin(), out.end(), no_triangle)));
}

#ifdef PLUMB_BENCH_EMBREE
RTCScene embree_scene(const TriangleMesh& mesh) {
  static RTCDevice const device = rtcNewDevice("threads=1");
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    vertices[3 * i] = static_cast<float>(mesh.vertices[i].x);
    vertices[3 * i + 1] = static_cast<float>(mesh.vertices[i].y);
    vertices[3 * i + 2] = static_cast<float>(mesh.vertices[i].z);
  }
  auto* const corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
  for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i) corners[i] = mesh.triangles[i / 3][i % 3];
  rtcCommitGeometry(geometry);
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

std::vector<RTCRayHit> embree_rays(const std::vector<AnyRay>& rays) {
  std::vector<RTCRayHit> given;
  for (const AnyRay& r : rays) {
    RTCRayHit one{};
    const auto difference = [&](double a, double b) { return static_cast<float>(b) - static_cast<float>(a); };
    const bool segment = r.kind == AnyRay::Kind::segment;
    one.ray.org_x = static_cast<float>(r.origin.x);
    one.ray.org_y = static_cast<float>(r.origin.y);
    one.ray.org_z = static_cast<float>(r.origin.z);
    one.ray.dir_x = segment ? difference(r.origin.x, r.end.x) : static_cast<float>(r.direction.x);
    one.ray.dir_y = segment ? difference(r.origin.y, r.end.y) : static_cast<float>(r.direction.y);
    one.ray.dir_z = segment ? difference(r.origin.z, r.end.z) : static_cast<float>(r.direction.z);
    one.ray.tfar = std::numeric_limits<float>::infinity();  // behind the vertex it may still hit: no leak then
    one.ray.mask = ~0U;
    one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    given.push_back(one);
  }
  return given;
}

void first_of_embree(benchmark::State& state) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  RTCScene embree = embree_scene(scene.mesh);
  const std::vector<RTCRayHit> given = embree_rays(rays);
  std::size_t hit = 0;
  for (auto _ : state) {
    hit = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const RTCRayHit& ray : given) {
      RTCRayHit one = ray;
      rtcIntersect1(embree, &context, &one);
      hit += one.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
  }
  report(state, rays.size(), hit);
  rtcReleaseScene(embree);
}

/// Sixteen at once, said to be coherent where they are.
void first_of_embree_packets(benchmark::State& state) {
  const Scene& scene = scene_of(state.range(0));
  const auto aim = static_cast<Aim>(state.range(1));
  const std::vector<AnyRay> rays = rays_of(shots_of(scene.mesh, aim), aim);
  RTCScene embree = embree_scene(scene.mesh);
  const std::vector<RTCRayHit> given = embree_rays(rays);
  std::vector<RTCRayHit16> packets(given.size() / 16);
  for (std::size_t i = 0; i < 16 * packets.size(); ++i) {
    RTCRayHit16& p = packets[i / 16];
    const std::size_t k = i % 16;
    const RTCRay& r = given[i].ray;
    p.ray.org_x[k] = r.org_x, p.ray.org_y[k] = r.org_y, p.ray.org_z[k] = r.org_z;
    p.ray.dir_x[k] = r.dir_x, p.ray.dir_y[k] = r.dir_y, p.ray.dir_z[k] = r.dir_z;
    p.ray.tnear[k] = 0, p.ray.tfar[k] = r.tfar, p.ray.time[k] = 0, p.ray.mask[k] = r.mask, p.ray.flags[k] = 0;
    p.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  }
  alignas(64) int valid[16];
  std::fill(valid, valid + 16, -1);
  std::size_t hit = 0;
  for (auto _ : state) {
    hit = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (aim == Aim::camera) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (const RTCRayHit16& packet : packets) {
      RTCRayHit16 one = packet;
      rtcIntersect16(valid, embree, &context, &one);
      for (const unsigned id : one.hit.geomID) hit += id != RTC_INVALID_GEOMETRY_ID;
    }
  }
  report(state, rays.size(), hit);
  rtcReleaseScene(embree);
}
#endif

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"side", "aim"})->Unit(benchmark::kMillisecond);
  for (const std::int64_t side : {50, 160, 500}) {  // 4 side^2 triangles
    for (const std::int64_t aim : {0, 1, 2}) b->Args({side, aim});
  }
}

BENCHMARK(first_of_plumb)->Apply(sizes);
BENCHMARK(numbers_of_plumb)->Apply(sizes);
BENCHMARK(any_of_plumb)->Apply(sizes);
BENCHMARK_CAPTURE(alone_of_plumb, triangle, false)->Apply(sizes);
BENCHMARK_CAPTURE(alone_of_plumb, hit, true)->Apply(sizes);
BENCHMARK(degenerate)->ArgName("kind")->DenseRange(0, 7)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(first_of_posed, together, true)->Apply(sizes);
BENCHMARK_CAPTURE(first_of_posed, alone, false)->Apply(sizes);
#ifdef PLUMB_BENCH_EMBREE
BENCHMARK(first_of_embree)->Apply(sizes);
BENCHMARK(first_of_embree_packets)->Apply(sizes);
#endif

}  // namespace
}  // namespace plumb::bench
