// What do a front and last answers save on a moving scene?  One thread; beside the same queries without a memory.
//
// Scene: a wavy ring passes another of its kind in 64 small steps, posed or with its vertices moved and the tree
// refitted (which is not counted).  An iteration is the whole passage.  `s_frame` is the time of a query, `nodes` how
// many boxes or pairs of boxes of nodes it looks at, `triangles` how many triangles or pairs; both a frame.
// `bytes` is what a front keeps at the end.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <string>

#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"
#include "space/closest/closest_pair_search.hpp"
#include "space/closest/nearest_search.hpp"
#include "space/closest/posed_nearest_search.hpp"

namespace plumb::bench {
namespace {

constexpr int frames = 64;

struct Scene {
  TriangleMesh mesh;
  Bvh still;
  std::vector<Bvh> moving;  // one a frame
  std::vector<Pose> poses;
};

/// Meshes of 4 n^2 triangles, moved by so much at first and in all.
Scene scene(std::uint32_t n, Vector3 from, Vector3 by) {
  Scene s{meshes::ring(n), {}, {}, {}};
  s.still = build_bvh(s.mesh);
  Bvh bvh = s.still;
  std::vector<Point3> at = s.mesh.vertices;
  for (int i = 0; i < frames; ++i) {
    const double part = static_cast<double>(i) / frames;
    const Vector3 v{from.x + part * by.x, from.y + part * by.y, from.z + part * by.z};
    for (std::size_t k = 0; k < at.size(); ++k) {
      const Point3& p = s.mesh.vertices[k];
      at[k] = {p.x + v.x, p.y + v.y, p.z + v.z};
    }
    refit(bvh, at);
    s.moving.push_back(bvh);
    s.poses.push_back({identity_pose.columns, v});
  }
  return s;
}

double seconds_of_this_thread() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Work {
  std::size_t nodes = 0, triangles = 0, answers = 0, bytes = 0;
};

/// passage() begins a passage: what is called of each frame.
void add(const std::string& name, std::function<std::function<void(int, Work&)>()> passage) {
  benchmark::RegisterBenchmark(("coherence/" + name).c_str(),
                               [passage](benchmark::State& state) {
                                 Work work;
                                 for (auto _ : state) {
                                   work = {};
                                   auto frame = passage();
                                   double time = 0;
                                   for (int i = 0; i < frames; ++i) {
                                     const double start = seconds_of_this_thread();
                                     frame(i, work);
                                     time += seconds_of_this_thread() - start;
                                   }
                                   state.SetIterationTime(time);
                                 }
                                 const auto each = [&](std::size_t n) { return static_cast<double>(n) / frames; };
                                 state.counters["s_frame"] =
                                     benchmark::Counter(static_cast<double>(state.iterations()) * frames,
                                                        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
                                 state.counters["answers"] = each(work.answers);
                                 if (work.nodes > 0) state.counters["nodes"] = each(work.nodes);
                                 if (work.bytes > 0) state.counters["bytes"] = static_cast<double>(work.bytes);
                                 if (work.triangles > 0) state.counters["triangles"] = each(work.triangles);
                               })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

std::size_t compared(const Bvh& a, const Bvh& b) {
  std::size_t n = 0;
  descend_pairs(
      a.tree, b.tree, descend_larger{},
      [&](const BoxNode& p, const BoxNode& q) {
        ++n;
        return p.min[0] <= q.max[0] && q.min[0] <= p.max[0] && p.min[1] <= q.max[1] && q.min[1] <= p.max[1] &&
               p.min[2] <= q.max[2] && q.min[2] <= p.max[2];
      },
      [](const BoxNode&, const BoxNode&) {});
  return n;
}

const PairOptions serial{.execution = Execution::serial};

void add_pairs(const std::string& name, const std::shared_ptr<Scene>& s) {
  add("pairs/refitted/" + name + "/descent",
      [=] { return [=](int i, Work& w) { w.answers += intersecting_pairs(s->moving[i], s->still, serial).size(); }; });
  add("pairs/refitted/" + name + "/front", [=] {
    return [=, front = std::make_shared<PairFront>()](int i, Work& w) {
      w.answers += front->intersecting_pairs(s->moving[i], s->still, serial).size();
      w.nodes += front->work().comparisons;
      w.bytes = front->memory();
    };
  });
  add("pairs/refitted/" + name + "/front_forgotten", [=] {
    return [=, front = std::make_shared<PairFront>()](int i, Work& w) {
      front->forget();
      w.answers += front->intersecting_pairs(s->moving[i], s->still, serial).size();
      w.nodes += front->work().comparisons;
    };
  });
  add("pairs/compared_by_descent/" + name,
      [=] { return [=](int i, Work& w) { w.nodes += compared(s->moving[i], s->still); }; });
  add("pairs/posed/" + name + "/descent", [=] {
    return [=](int i, Work& w) { w.answers += intersecting_pairs({s->still, s->poses[i]}, s->still, serial).size(); };
  });
  add("pairs/posed/" + name + "/front", [=] {
    return [=, front = std::make_shared<PairFront>()](int i, Work& w) {
      w.answers += front->intersecting_pairs({s->still, s->poses[i]}, s->still, serial).size();
      w.nodes += front->work().comparisons;
      w.bytes = front->memory();
    };
  });
  add("any/refitted/" + name + "/search", [=] {
    return [=](int i, Work& w) { w.answers += any_intersecting_pair(s->moving[i], s->still, serial) ? 1 : 0; };
  });
  add("any/refitted/" + name + "/last", [=] {
    return [=, last = std::make_shared<LastPair>()](int i, Work& w) {
      w.answers += any_intersecting_pair(s->moving[i], s->still, *last, serial) ? 1 : 0;
    };
  });
  add("any/posed/" + name + "/search", [=] {
    return [=](int i, Work& w) {
      w.answers += any_intersecting_pair({s->still, s->poses[i]}, s->still, serial) ? 1 : 0;
    };
  });
  add("any/posed/" + name + "/last", [=] {
    return [=, last = std::make_shared<LastPair>()](int i, Work& w) {
      w.answers += any_intersecting_pair({s->still, s->poses[i]}, s->still, *last, serial) ? 1 : 0;
    };
  });
}

/// With a guess or without one.
template <class Search>
void guessed(const std::string& name, const Search& search) {
  add(name + "/search", [=] {
    return [=](int i, Work& w) {
      LastPair none;
      search(i, none, w);
    };
  });
  add(name + "/last",
      [=] { return [=, last = std::make_shared<LastPair>()](int i, Work& w) { search(i, *last, w); }; });
}

void add_distances(const std::shared_ptr<Scene>& apart, const std::shared_ptr<Scene>& small) {
  using space::Counted;
  guessed("closest_triangles/refitted", [=](int i, LastPair& last, Work& w) {
    space::StandingSource a(apart->moving[i]), b(apart->still);
    space::ClosestSearch search(a, b, {}, Counted{&w.nodes, &w.triangles});
    search.guess(last.slot_a, last.slot_b);
    const auto found = *search.run();
    last = {found.slot_a, found.slot_b};
  });
  guessed("closest_triangles/posed", [=](int i, LastPair& last, Work& w) {
    const PosedMesh mesh_a{small->still, small->poses[i]}, mesh_b{small->still};
    space::PosedSource a(mesh_a), b(mesh_b);
    space::ClosestSearch search(a, b, {}, Counted{&w.nodes, &w.triangles});
    search.guess(last.slot_a, last.slot_b);
    const auto found = *search.run();
    last = {found.slot_a, found.slot_b};
  });
  guessed("closest_on_mesh/refitted", [=](int i, LastPair& last, Work& w) {
    const Point3 p{0.1, 0.2, 0.3};
    space::Nearest<Counted> search(apart->moving[i], 1, {&w.nodes, &w.triangles});
    last.slot_a = search.of(p, last.slot_a)[0].slot;
  });
  guessed("closest_on_mesh/posed", [=](int i, LastPair& last, Work& w) {
    const Point3 p{0.1, 0.2, 0.3};
    last.slot_a = space::nearest_posed(PosedMesh(apart->still, apart->poses[i]), p, 1, last.slot_a,
                                       Counted{&w.nodes, &w.triangles})[0]
                      .slot;
  });
}

/// Each with a memory of its own, or with none; 1000 at a time.
void add_rays(const std::shared_ptr<Scene>& s) {
  const auto ray = [](int i, std::size_t k) {
    return Ray3{{-9, -1 + 0.002 * static_cast<double>(k) + 0.0001 * i, 0.2}, {1, 0, 0.001}};
  };
  constexpr std::size_t rays = 1000;
  using Memory = std::vector<LastTriangle>;
  add("hits/1000_rays/search", [=] {
    return [=](int i, Work& w) {
      for (std::size_t k = 0; k < rays; ++k) w.answers += any_hit(s->moving[i], ray(i, k)) ? 1 : 0;
    };
  });
  add("hits/1000_rays/last", [=] {
    return [=, last = std::make_shared<Memory>(rays)](int i, Work& w) {
      for (std::size_t k = 0; k < rays; ++k) w.answers += any_hit(s->moving[i], ray(i, k), (*last)[k]) ? 1 : 0;
    };
  });
}

/// Boxes of some triangles' size side by side, which overlap; the mesh goes by.
void add_swarm(const std::shared_ptr<Scene>& s, double size, std::size_t across) {
  std::vector<Aabb3> all;
  for (std::size_t i = 0; i < across * across; ++i) {
    const double x = 0.5 + 0.5 * size * static_cast<double>(i % across),
                 y = 0.5 * size * static_cast<double>(i / across);
    all.push_back({{x, y, 0.2}, {x + size, y + size, 0.4}});
  }
  const auto boxes = std::make_shared<std::vector<Aabb3>>(all);
  const auto asked = [=] { return std::span<const Aabb3>(*boxes); };
  const std::string name = "boxes/" + std::to_string(across * across);
  const RangeOptions one_thread{.execution = Execution::serial};
  const auto counted = [](const std::vector<std::vector<std::uint32_t>>& found) {
    std::size_t n = 0;
    for (const auto& f : found) n += f.size();
    return n;
  };
  add(name + "/each",
      [=] { return [=](int i, Work& w) { w.answers += counted(meeting(s->moving[i], asked(), one_thread)); }; });
  add(name + "/grouped", [=] {
    return [=](int i, Work& w) { w.answers += counted(grouped_meeting(s->moving[i], asked(), one_thread)); };
  });
  add(name + "/any_retested", [=] {
    return [=](int i, Work& w) {
      std::vector<std::uint32_t> any;
      for (const auto& f : grouped_meeting(s->moving[i], asked(), one_thread))
        any.insert(any.end(), f.begin(), f.end());
      std::ranges::sort(any);
      any.erase(std::unique(any.begin(), any.end()), any.end());
      w.answers += any.size();
    };
  });
  add(name + "/any_stamped", [=] {
    return [=, seen = std::make_shared<VisitStamps>()](int i, Work& w) {
      w.answers += meeting_any(s->moving[i], asked(), *seen).size();
    };
  });
}

const bool added = [] {
  for (const std::uint32_t n : {50u, 158u}) {
    const std::string size = std::to_string(4 * n * n);
    // Through one another; and a graze, where few triangles meet.
    add_pairs("through/" + size, std::make_shared<Scene>(scene(n, {0.75, 0.25, 0}, {0.25, 0, 0})));
    add_pairs("graze/" + size, std::make_shared<Scene>(scene(n, {2.875, 0.25, 0}, {-0.125, 0, 0})));
  }
  const auto apart = std::make_shared<Scene>(scene(158, {3.25, 0.25, 0}, {0.25, 0, 0.125}));
  add_rays(apart);
  const auto through = std::make_shared<Scene>(scene(158, {0, 0, 0}, {0.25, 0, 0.125}));
  add_swarm(through, 0.02, 32);
  add_swarm(through, 0.1, 16);
  add_distances(apart, std::make_shared<Scene>(scene(50, {3.25, 0.25, 0}, {0.25, 0, 0.125})));
  return true;
}();

}  // namespace
}  // namespace plumb::bench
