// How fast are the yes/no tests?  Beside the same tests in plain doubles, and CGAL's do_intersect over Epick.
//
// The classes are those of bench/measure.hpp, aimed at coplanar points, and `mesh`: triangles of a real model against
// those of its copy moved a little, where their boxes meet.
#include <cmath>
#include <memory>

#include "bench/measure.hpp"
#include "bench/rivals/overlap_rival.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/query/overlap/batch.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::bench {
namespace {

/// Shapes from numbers, one after the other.
class Numbers {
 public:
  explicit Numbers(const double* at) : at_(at) {}
  operator double() { return *at_++; }
  operator Point2() { return {*this, *this}; }
  operator Point3() { return {*this, *this, *this}; }
  operator Vector3() { return {*this, *this, *this}; }

  void fill(Segment2& s) { s = {*this, *this}; }
  void fill(Segment3& s) { s = {*this, *this}; }
  void fill(Ray3& s) { s = {*this, *this}; }
  void fill(Triangle2& s) { s = {*this, *this, *this}; }
  void fill(Triangle3& s) { s = {*this, *this, *this}; }
  void fill(Tetrahedron3& s) { s = {*this, *this, *this, *this}; }
  void fill(Plane3& s) { s = {*this, *this}; }
  void fill(Aabb2& s) {
    const std::array<Point2, 2> p{*this, *this};
    s = {{std::min(p[0].x, p[1].x), std::min(p[0].y, p[1].y)}, {std::max(p[0].x, p[1].x), std::max(p[0].y, p[1].y)}};
  }
  void fill(Aabb3& s) { s = fit_aabb(std::array<Point3, 2>{*this, *this}); }
  /// Orthonormal up to rounding, of a size of a fifth of the first point.
  void fill(Obb3& s) {
    const Point3 center = *this, q = *this;
    double n = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z), w = 0.5;
    if (!(n > 0 && n < 1e300)) n = 1;
    const double x = q.x / n * 0.8, y = q.y / n * 0.8, z = q.z / n * 0.8;
    const double k = 1 / std::sqrt(w * w + x * x + y * y + z * z), a = x * k, b = y * k, c = z * k, d = w * k;
    s = {center,
         {Vector3{1 - 2 * (b * b + c * c), 2 * (a * b + c * d), 2 * (a * c - b * d)},
          Vector3{2 * (a * b - c * d), 1 - 2 * (a * a + c * c), 2 * (b * c + a * d)},
          Vector3{2 * (a * c + b * d), 2 * (b * c - a * d), 1 - 2 * (a * a + b * b)}},
         {n * 0.5, n * 0.3, n * 0.4}};
  }

 private:
  const double* at_;
};

template <class A, class B>
Pairs<A, B> pairs_of(const std::string& inputs_name, int dimension) {
  constexpr std::size_t arity = (sizeof(A) + sizeof(B)) / sizeof(double);
  const std::vector<double> all =
      inputs("orient3d", arity + arity % static_cast<std::size_t>(dimension), dimension, inputs_name);
  const std::size_t step = all.size() / cases;
  Pairs<A, B> pairs(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    Numbers numbers(&all[i * step]);
    numbers.fill(pairs[i].first);
    numbers.fill(pairs[i].second);
  }
  return pairs;
}

template <class A, class B>
void add_pairs(const std::string& name, const std::string& inputs_name, Pairs<A, B> given) {
  const auto pairs = std::make_shared<Pairs<A, B>>(std::move(given));
  add(name, inputs_name, "bare", [pairs] {
    long sum = 0;
    for (const auto& [a, b] : *pairs) sum += bare::intersects(a, b);
    return sum;
  });
  add(name, inputs_name, "plumb", [pairs] {
    long sum = 0;
    for (const auto& [a, b] : *pairs) sum += plumb::intersects(a, b);
    return sum;
  });
  if constexpr (requires { epick_run(*pairs); }) add(name, inputs_name, "epick", epick_run(*pairs));
}

template <class A, class B>
void register_pair(const std::string& name, int dimension = 3) {
  for (const std::string& inputs_name : input_classes())
    add_pairs(name, inputs_name, pairs_of<A, B>(inputs_name, dimension));
}

Pairs<Triangle3, Triangle3> mesh_pairs() {
  const TriangleMesh mesh = read_mesh(PLUMB_SOURCE_DIR "/../shared/models/spot.obj");
  std::vector<Triangle3> of, moved;
  std::vector<Aabb3> box_of, box_moved;
  for (const auto& t : mesh.triangles) {
    const auto& v = mesh.vertices;
    const auto move = [](const Point3& p) { return Point3{p.x + 0.013, p.y - 0.007, p.z + 0.019}; };
    of.push_back({v[t[0]], v[t[1]], v[t[2]]});
    moved.push_back({move(v[t[0]]), move(v[t[1]]), move(v[t[2]])});
    box_of.push_back(fit_aabb(of.back()));
    box_moved.push_back(fit_aabb(moved.back()));
  }
  Pairs<Triangle3, Triangle3> pairs;
  for (std::size_t i = 0; pairs.size() < cases; i = (i + 977) % of.size()) {
    for (std::size_t j = 0; j < moved.size() && pairs.size() < cases; ++j) {
      if (plumb::intersects(box_of[i], box_moved[j])) pairs.emplace_back(of[i], moved[j]);
    }
  }
  return pairs;
}

/// Of one mesh, with a corner or an edge in common.
Pairs<Triangle3, Triangle3> neighbor_pairs() {
  const TriangleMesh mesh = read_mesh(PLUMB_SOURCE_DIR "/../shared/models/spot.obj");
  const auto triangle = [&](const auto& t) {
    return Triangle3{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
  };
  Pairs<Triangle3, Triangle3> pairs;
  for (std::size_t i = 0; pairs.size() < cases; i = (i + 977) % mesh.triangles.size()) {
    for (std::size_t j = 0; j < mesh.triangles.size() && pairs.size() < cases; ++j) {
      const auto &s = mesh.triangles[i], &t = mesh.triangles[j];
      const auto shared = std::ranges::count_if(s, [&](auto v) { return std::ranges::find(t, v) != t.end(); });
      if (shared == 1 || shared == 2) pairs.emplace_back(triangle(s), triangle(t));
    }
  }
  return pairs;
}

/// One against many: one by one, and in lanes.
void register_batches(const std::string& inputs_name) {
  struct Many {
    Aabb3 box;
    Segment3 segment;
    std::vector<Triangle3> triangles;
    std::vector<Aabb3> boxes;
    std::vector<std::uint8_t> out;
  };
  const auto all = std::make_shared<Many>();
  all->box = {{0.25, 0.25, 0.25}, {0.75, 0.625, 0.5}};
  all->segment = {{0.125, 0.25, 0.25}, {0.75, 0.625, 0.875}};
  for (const auto& [t, b] : pairs_of<Triangle3, Aabb3>(inputs_name, 3)) {
    all->triangles.push_back(t);
    all->boxes.push_back(b);
  }
  all->out.resize(cases);
  const auto count = [all] { return static_cast<long>(std::count(all->out.begin(), all->out.end(), 1)); };
  add("box-triangles", inputs_name, "one-by-one", [all, count] {
    for (std::size_t i = 0; i < cases; ++i) all->out[i] = plumb::intersects(all->triangles[i], all->box);
    return count();
  });
  add("box-triangles", inputs_name, "lanes", [all, count, batch = TriangleBatch(all->triangles)] {
    plumb::intersects(all->box, batch, all->out);
    return count();
  });
  add("segment-boxes", inputs_name, "one-by-one", [all, count] {
    for (std::size_t i = 0; i < cases; ++i) all->out[i] = plumb::intersects(all->segment, all->boxes[i]);
    return count();
  });
  add("segment-boxes", inputs_name, "lanes", [all, count, batch = BoxBatch(all->boxes)] {
    plumb::intersects(all->segment, batch, all->out);
    return count();
  });
}

[[maybe_unused]] const bool registered = [] {
  register_pair<Triangle3, Triangle3>("triangle-triangle");
  const auto of_mesh = mesh_pairs();
  add_pairs("triangle-triangle", "mesh", of_mesh);
  add_pairs("triangle-triangle", "neighbors", neighbor_pairs());
  register_pair<Segment3, Triangle3>("segment-triangle");
  Pairs<Segment3, Triangle3> edges;
  Pairs<Triangle3, Aabb3> boxes;
  for (const auto& [a, b] : of_mesh) {
    edges.emplace_back(Segment3{a.a, a.b}, b);
    boxes.emplace_back(a, fit_aabb(b));
  }
  add_pairs("segment-triangle", "mesh", edges);
  register_pair<Triangle3, Aabb3>("triangle-box");
  add_pairs("triangle-box", "mesh", boxes);
  register_pair<Ray3, Triangle3>("ray-triangle");
  register_pair<Segment3, Aabb3>("segment-box");
  register_pair<Ray3, Aabb3>("ray-box");
  register_pair<Triangle3, Obb3>("triangle-obb");
  register_pair<Segment3, Obb3>("segment-obb");
  register_pair<Aabb3, Aabb3>("box-box");
  register_pair<Aabb3, Obb3>("box-obb");
  register_pair<Plane3, Aabb3>("plane-box");
  register_pair<Plane3, Triangle3>("plane-triangle");
  register_pair<Triangle3, Tetrahedron3>("triangle-tetrahedron");
  register_pair<Tetrahedron3, Tetrahedron3>("tetrahedron-tetrahedron");
  register_pair<Segment2, Segment2>("segment2-segment2", 2);
  register_pair<Segment2, Triangle2>("segment2-triangle2", 2);
  register_pair<Triangle2, Triangle2>("triangle2-triangle2", 2);
  register_pair<Triangle2, Aabb2>("triangle2-box2", 2);
  register_batches("uniform");
  register_batches("float32");
  return true;
}();

}  // namespace
}  // namespace plumb::bench
