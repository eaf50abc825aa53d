// How long does it take to find when two figures in straight motion meet?  Beside the same tests in plain doubles, on
// shapes of about the size of the unit cube that start some spread apart; `hits` is the share that meet.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "bench/rivals/translating_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 4096;

class Draw {
 public:
  explicit Draw(std::uint64_t index) : entropy_(41, index) {}

  double in(double size) { return size * signed_unit_coordinate(entropy_); }
  double size() { return 0.1 + unit_coordinate(entropy_); }
  Point3 point(double spread) {
    const double x = in(spread), y = in(spread), z = in(spread);
    return {x, y, z};
  }
  Vector3 vector(double spread) {
    const Point3 p = point(spread);
    return {p.x, p.y, p.z};
  }

  void fill(Sphere3& s) { s = {point(4), size()}; }
  void fill(Plane3& p) { p = {vector(1), in(4)}; }
  void fill(Triangle3& t) {
    const Point3 at = point(2);
    const auto corner = [&] {
      const Point3 p = point(1);
      return Point3{at.x + p.x, at.y + p.y, at.z + p.z};
    };
    t.a = corner(), t.b = corner(), t.c = corner();
  }
  void fill(Aabb3& b) {
    b.min = point(4);
    b.max = {b.min.x + size(), b.min.y + size(), b.min.z + size()};
  }
  /// Corners of a ball of radius 1.
  void fill(ConvexPolyhedron3& p) {
    const Point3 at = point(4);
    std::vector<Point3> corners(20);
    for (Point3& c : corners) {
      const Point3 d = point(1);
      const double scale = 1 / std::hypot(d.x, d.y, d.z);
      c = {at.x + scale * d.x, at.y + scale * d.y, at.z + scale * d.z};
    }
    p = convex_polyhedron(convex_hull(corners), corners);
  }
  void fill(Obb3& b) {
    const double angle = in(3);
    const double c = std::cos(angle), s = std::sin(angle);
    b = {point(4), {Vector3{c, s, 0}, Vector3{-s * s, c * s, c}, Vector3{s * c, -c * c, s}}, {size(), size(), size()}};
  }

 private:
  Entropy entropy_;
};

template <class A, class B, class Meet>
void measure(benchmark::State& state, Meet meet) {
  std::vector<Translating<A>> a(pairs);
  std::vector<B> b(pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    Draw draw(i);
    draw.fill(a[i].shape), draw.fill(b[i]);
    a[i].by = draw.vector(8);
  }
  std::size_t i = 0, hits = 0, asked = 0;
  for (auto _ : state) {
    hits += meet(a[i], b[i]) ? 1 : 0;
    ++asked;
    i = (i + 1) % pairs;
  }
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(asked);
}

template <class A, class B>
void add(const std::string& name) {
  benchmark::RegisterBenchmark((name + "/intersects").c_str(), [](benchmark::State& state) {
    measure<A, B>(state, [](const Translating<A>& a, const B& b) { return intersects(a, b); });
  });
  benchmark::RegisterBenchmark((name + "/first_contact").c_str(), [](benchmark::State& state) {
    measure<A, B>(state, [](const Translating<A>& a, const B& b) { return first_contact(a, b).has_value(); });
  });
}

template <class A, class B, class Plain>
void add(const std::string& name, Plain plain) {
  benchmark::RegisterBenchmark((name + "/plain").c_str(), [=](benchmark::State& state) {
    measure<A, B>(state, [&](const Translating<A>& a, const B& b) { return plain(a.shape, a.by, b) >= 0; });
  });
  add<A, B>(name);
}

const bool added = [] {
  add<Sphere3, Plane3>("sphere_plane", plain_sphere_plane);
  add<Sphere3, Sphere3>("sphere_sphere", plain_sphere_sphere);
  add<Sphere3, Triangle3>("sphere_triangle", plain_sphere_triangle);
  add<Aabb3, Aabb3>("box_box", plain_box_box);
  add<Obb3, Obb3>("oriented_boxes", plain_oriented);
  add<ConvexPolyhedron3, Aabb3>("polyhedron_box");
  return true;
}();

}  // namespace
}  // namespace plumb::bench
