#include "surface/solid/soundness.hpp"

#include <algorithm>
#include <numeric>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "surface/solid/facet_list.hpp"

namespace plumb::surface {
namespace {

std::int32_t times_used(const FacePool& pool, std::uint32_t face) {
  std::int32_t times = 0;
  for (const FacetSource& use : pool.uses_of(face)) times += use.opposite ? -1 : 1;
  return times;
}

/// Are faces of area alone closed?  No where one without area was between them.
bool is_closed_by_faces(const FacePool& pool) {
  struct Run {
    std::uint32_t from, to;
    std::int32_t flow;
  };
  std::vector<Run> runs;
  for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
    const std::int32_t times = times_used(pool, f);
    const auto& [a, b, c] = pool.mesh.triangles[f];  // ascending
    runs.insert(runs.end(), {{a, b, times}, {b, c, times}, {a, c, -times}});
  }
  std::ranges::sort(runs, [](const Run& l, const Run& r) { return std::pair(l.from, l.to) < std::pair(r.from, r.to); });
  std::int32_t flow = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    flow += runs[i].flow;
    const bool is_last = i + 1 == runs.size() || runs[i + 1].from != runs[i].from || runs[i + 1].to != runs[i].to;
    if (is_last && flow != 0) return false;
  }
  return true;
}

/// Takes faces that meet in shared vertices and edges only.
bool is_wound_once(const FacePool& pool, const Bvh& bvh) {
  PointTable table(pool.mesh.vertices);
  PlaneClasses classes;
  classes.whole.resize(pool.mesh.triangles.size());
  std::iota(classes.whole.begin(), classes.whole.end(), 0U);
  const FacetList list = divide_planes(pool, table, classes);
  const std::vector<std::int32_t> windings = windings_of_sets(pool, bvh, list, table, join_sides(list, table));
  return std::ranges::all_of(windings, [](std::int32_t w) { return w == 0 || w == 1; });
}

}  // namespace

Soundness::Soundness(const TriangleMesh& mesh) {
  const FacePool pool = pool_faces({&mesh, 1});
  plain = pool.mesh;
  bool is_simple = is_closed_by_faces(pool);
  for (std::uint32_t f = 0; f < plain.triangles.size(); ++f) {
    const std::int32_t times = times_used(pool, f);
    is_simple = is_simple && (times == 1 || times == -1);
    if (times < 0) std::swap(plain.triangles[f][1], plain.triangles[f][2]);
    const auto uses = pool.uses_of(f);
    const auto at = std::ranges::find(uses, times < 0, &FacetSource::opposite);
    triangle.push_back(at->face.triangle);
  }
  const Bvh bvh = build_bvh(pool.mesh, {.method = BvhMethod::linear});  // which is asked once
  for (const TrianglePair& p : intersecting_pairs(bvh)) meeting.push_back({p.a, p.b});
  sound = is_simple && meeting.empty() && is_wound_once(pool, bvh);
}

}  // namespace plumb::surface
