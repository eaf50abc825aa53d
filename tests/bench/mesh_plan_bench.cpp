// What does a plan save on real meshes?  The bare formula, decide and the kernel of the mesh's lattice, on signs that mesh
// software asks for around edges: as given, in floats, and with a vertex so far off that no bound of the lattice tells
// anything.  `bench_mesh_plan --benchmark_format=json | python3 tests/bench/report/table.py` prints the table of docs/plans.md.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "bench/measure.hpp"
#include "plumb/certify/kernel.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb::bench {
namespace {

/// The ends of an edge, the corners opposite it, and one of a later edge.
using Around = std::array<std::uint32_t, 5>;

std::vector<Around> around_edges(const TriangleMesh& mesh) {
  const auto edges = interior_edges(find_edges(mesh));
  std::vector<Around> all;
  for (std::size_t i = 0; i < cases && !edges.empty(); ++i) {
    const std::size_t k = i * edges.size() / cases;
    const auto& e = edges[k];
    std::size_t later = k;
    std::uint32_t other = 0;
    do {
      later = (later + 1) % edges.size();
      other = edges[later].c;
    } while ((other == e.a || other == e.b || other == e.c || other == e.d) && later != k);
    all.push_back({e.a, e.b, e.c, e.d, other});
  }
  return all;
}

/// Coordinates of a formula's points; in the plane, seen along an axis that changes from edge to edge.
template <Formula F>
Coordinates<F> asked(const std::vector<Point3>& vertices, const Around& around, std::size_t axis) {
  constexpr auto dimension = static_cast<std::size_t>(F::dimension);
  Coordinates<F> p{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(F::points); ++k) {
    const Point3& v = vertices[around[k]];
    const std::array<double, 3> x{v.x, v.y, v.z};
    for (std::size_t c = 0; c < dimension; ++c) p[k * dimension + c] = x[dimension == 3 ? c : (axis + 1 + c) % 3];
  }
  return p;
}

template <Formula F>
void register_signs(const std::string& name, const std::vector<Point3>& vertices, const std::vector<Around>& around,
                    const Kernel& kernel) {
  constexpr auto dimension = static_cast<std::size_t>(F::dimension), count = static_cast<std::size_t>(F::points);
  using Taken = std::array<LatticePoint<dimension>, count>;
  const auto sets = std::make_shared<std::vector<Coordinates<F>>>();
  const auto all = std::make_shared<std::vector<Taken>>();
  for (std::size_t i = 0; i < around.size(); ++i) {
    sets->push_back(asked<F>(vertices, around[i], i));
    Taken& t = all->emplace_back();
    for (std::size_t k = 0; k < count; ++k) {
      std::array<double, dimension> x{};
      std::copy_n(&sets->back()[k * dimension], dimension, x.begin());
      t[k] = kernel.point(x);
    }
  }
  const auto each = [&](const char* method, auto take) {
    add(F::name, name, method, [sets, take] {
      benchmark::ClobberMemory();
      long sum = 0;
      for (const Coordinates<F>& p : *sets) sum += static_cast<long>(take(p));
      return sum;
    });
  };
  each("bare", [](const Coordinates<F>& p) { return sign_of_number(F{}(p)); });
  each("decide", [](const Coordinates<F>& p) { return decide<F>(p); });
  add(F::name, name, "plan", [all, kernel] {
    benchmark::ClobberMemory();
    return kernel.with<F>([&](const auto& sign) {
      long sum = 0;
      for (const Taken& p : *all) sum += static_cast<long>(std::apply(sign, p));
      return sum;
    });
  });
  add(F::name, name, "plan-chosen-each-time", [all, kernel] {
    benchmark::ClobberMemory();
    long sum = 0;
    for (const Taken& p : *all)
      sum += static_cast<long>(std::apply([&](const auto&... point) { return kernel.sign<F>(point...); }, p));
    return sum;
  });
}

void register_scene(const std::string& name, const std::vector<Point3>& vertices, const std::vector<Around>& around,
                    const std::vector<double>& beside = {}) {
  std::vector<double> coordinates = beside;
  for (const Point3& p : vertices) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  const Kernel kernel(plan(lattice_of(coordinates)));
  register_classics([&]<Formula F>(F) { register_signs<F>(name, vertices, around, kernel); });
}

[[maybe_unused]] const bool registered = [] {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SOURCE_DIR "/../shared") / "models";
  if (!std::filesystem::exists(folder)) return false;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".obj" || entry.path().extension() == ".ply") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const auto& file : files) {
    const TriangleMesh mesh = read_mesh(file.string());
    const std::vector<Around> around = around_edges(mesh);
    if (around.empty()) continue;
    std::vector<Point3> vertices = mesh.vertices;
    const std::string name = file.stem().string();
    register_scene(name, vertices, around);
    double largest = 0;
    for (const Point3& p : vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    register_scene(name + "-outlier", vertices, around, {std::ldexp(largest, 40)});
    for (Point3& p : vertices) p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    register_scene(name + "-float32", vertices, around);
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench
