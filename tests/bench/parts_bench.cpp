// How long does convex decomposition take, beside CGAL's on the same solid in the same run?
//
// cubes: 4 by 4 by 4 cubes apart from one another.  joined: the same with bars between neighbors.  cavities: a box with 64
// cavities.  The names are kind/library; `parts` are how many came out.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/convex_decomposition_3.h>
#include <benchmark/benchmark.h>

#include <set>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/surface/parts/convex_parts.hpp"

namespace plumb::bench {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Epeck>;
using Polyhedron = CGAL::Polyhedron_3<Epeck>;

struct Build : CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
  const TriangleMesh& mesh;
  explicit Build(const TriangleMesh& m) : mesh(m) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(mesh.vertices.size(), mesh.triangles.size());
    for (const Point3& p : mesh.vertices) builder.add_vertex({p.x, p.y, p.z});
    for (const auto& t : mesh.triangles) builder.add_facet(t.begin(), t.end());
    builder.end_surface();
  }
};

std::size_t cgal_parts(const TriangleMesh& mesh) {
  Polyhedron polyhedron;
  Build build(mesh);
  polyhedron.delegate(build);
  Nef nef(polyhedron);
  CGAL::convex_decomposition_3(nef);
  std::size_t parts = 0;
  auto volume = nef.volumes_begin();
  for (++volume; volume != nef.volumes_end(); ++volume) parts += volume->mark() ? 1 : 0;
  return parts;
}

void add(const std::string& name, const TriangleMesh& mesh, bool rival = true) {
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), [mesh](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = convex_parts(mesh).parts.size();
    state.counters["parts"] = static_cast<double>(n);
  })->Unit(benchmark::kMillisecond);
  if (!rival) return;  // made of several shells at once, its polyhedron has no cavities
  benchmark::RegisterBenchmark((name + "/cgal").c_str(), [mesh](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = cgal_parts(mesh);
    state.counters["parts"] = static_cast<double>(n);
  })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  TriangleMesh cubes;
  std::set<solids::Cell> joined;
  for (int i = 0; i < 343; ++i) {
    const solids::Cell c{i % 7, i / 7 % 7, i / 49};
    const int odd = c[0] % 2 + c[1] % 2 + c[2] % 2;
    if (odd < 2) joined.insert(c);
    const Point3 low{double(c[0]), double(c[1]), double(c[2])};
    if (odd == 0) solids::append(cubes, solids::box(low, {low.x + 1, low.y + 1, low.z + 1}));
  }
  TriangleMesh cavities = solids::box({-1, -1, -1}, {8, 8, 8});
  solids::append(cavities, cubes, true);
  add("cubes", cubes);
  add("joined", solids::voxels(joined));
  add("cavities", cavities, false);
  return true;
}();

}  // namespace
}  // namespace plumb::bench
