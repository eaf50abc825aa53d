// How long does the distance of two solids take?  Ours, exact, and a plain search in doubles, which proves nothing.
//
// Classes: far and near apart, with parallel faces, touching, overlapping, one within the other.
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/separation/separation.hpp"
#include "query/separation/corner_search.hpp"

namespace plumb {
namespace {

enum class Class { apart, parallel, touching, overlapping, within };
constexpr std::array<const char*, 5> class_names{"apart", "parallel", "touching", "overlapping", "within"};

class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  Point3 point(const Point3& center, double size) {
    return {center.x + (*this)(-size, size), center.y + (*this)(-size, size), center.z + (*this)(-size, size)};
  }

 private:
  std::mt19937_64 random_;
};

/// How far the second is to the right of the first, both of size 1 about their centers, in this class; on a lattice of 2^-10
/// where faces are to be parallel.
struct Place {
  Point3 center;
  double size;
};
Place second_place(Class c, Numbers& n) {
  if (c == Class::within) return {{0, 0, 0}, 0.05};
  if (c == Class::overlapping) return {{0.3, n(-0.2, 0.2), n(-0.2, 0.2)}, 1};
  if (c == Class::apart) return {{n(2.5, 4), n(-1, 1), n(-1, 1)}, 1};
  return {{c == Class::touching ? 2.0 : 3.0, std::floor(n(-512, 512)) * 0x1p-10, std::floor(n(-512, 512)) * 0x1p-10},
          1};
}
bool on_lattice(Class c) { return c == Class::parallel || c == Class::touching; }

Tetrahedron3 make(const Tetrahedron3*, const Place& p, Class c, Numbers& n, bool second) {
  if (on_lattice(c)) {  // a face at right angles to the axis x, toward the other
    const double s = second ? -1 : 1;
    const auto at = [&](double x, double y, double z) {
      return Point3{p.center.x + s * x, p.center.y + y, p.center.z + z};
    };
    return {at(1, -1, -1), at(1, 1, -0.5), at(1, -0.25, 1), at(-0.5, 0, 0)};
  }
  if (c == Class::within && !second) return {{-3, -3, -3}, {9, -3, -3}, {-3, 9, -3}, {-3, -3, 9}};
  return {n.point(p.center, p.size), n.point(p.center, p.size), n.point(p.center, p.size), n.point(p.center, p.size)};
}
Aabb3 make(const Aabb3*, const Place& p, Class c, Numbers& n, bool) {
  const auto half = [&] { return on_lattice(c) ? 1.0 : p.size * n(0.7, 1); };
  const double x = half(), y = half(), z = half();
  return {{p.center.x - x, p.center.y - y, p.center.z - z}, {p.center.x + x, p.center.y + y, p.center.z + z}};
}
Obb3 make(const Obb3*, const Place& p, Class c, Numbers& n, bool) {
  if (on_lattice(c))
    return {p.center, {Vector3{1, 0, 0}, Vector3{0, 0.75, 0.625}, Vector3{0, -0.625, 0.75}}, {1, 1, 1}};
  const double a = n(0, 6), b = n(0, 6);
  const Vector3 u{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)}, v{-std::sin(a), std::cos(a), 0};
  const Vector3 w{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  return {p.center, {u, v, w}, {p.size * 0.57, p.size * 0.5, p.size * 0.4}};
}
Capsule3 make(const Capsule3*, const Place& p, Class c, Numbers& n, bool) {
  if (on_lattice(c)) return {{p.center.x, p.center.y, -0.5}, {p.center.x, p.center.y, 0.5}, 1};
  return {n.point(p.center, p.size / 2), n.point(p.center, p.size / 2), p.size / 2};
}
ConvexPolyhedron3 make(const ConvexPolyhedron3*, const Place& p, Class c, Numbers& n, bool second) {
  std::vector<Point3> points;
  const double size = c == Class::within && !second ? 3 : p.size;
  for (int i = 0; i < 200; ++i) {
    const Point3 q = n.point({0, 0, 0}, 1);
    const double r = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z) / size;
    points.push_back({p.center.x + q.x / r, p.center.y + q.y / r, p.center.z + q.z / r});
  }
  if (on_lattice(c)) {
    const double x = p.center.x + (second ? -1 : 1), y = p.center.y, z = p.center.z;
    for (const auto& [dy, dz] :
         {std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(-0.5, 0.5), std::pair(0.5, 0.5)})
      points.push_back({x, y + dy, z + dz});
    for (Point3& q : points) q.x = second ? std::max(q.x, x) : std::min(q.x, x);
  }
  return convex_polyhedron(convex_hull(points), points);
}

template <class A, class B>
struct Cases {
  std::vector<A> a;
  std::vector<B> b;
  explicit Cases(Class c) {
    Numbers n(17);
    for (int i = 0; i < 256; ++i) {
      a.push_back(make(static_cast<const A*>(nullptr), {{0, 0, 0}, 1}, c, n, false));
      b.push_back(make(static_cast<const B*>(nullptr), second_place(c, n), c, n, true));
    }
  }
};

template <class A, class B, class Ask>
void run(benchmark::State& state, Class c, Ask ask) {
  const Cases<A, B> cases(c);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(cases.a[i], cases.b[i]));
    i = (i + 1) % cases.a.size();
  }
}

template <class A, class B>
void add(const std::string& pair) {
  for (std::size_t k = 0; k < class_names.size(); ++k) {
    const auto c = static_cast<Class>(k);
    const auto named = [&](const char* what) { return pair + "/" + class_names[k] + "/" + what; };
    benchmark::RegisterBenchmark(named("distance").c_str(), [c](benchmark::State& s) {
      run<A, B>(s, c, [](const A& a, const B& b) { return distance(a, b); });
    });
    benchmark::RegisterBenchmark(named("closest_points").c_str(), [c](benchmark::State& s) {
      run<A, B>(s, c, [](const A& a, const B& b) { return closest_points(a, b); });
    });
    benchmark::RegisterBenchmark(named("exact").c_str(), [c](benchmark::State& s) {
      run<A, B>(s, c, [](const A& a, const B& b) { return exact_distance(a, b); });
    });
    benchmark::RegisterBenchmark(named("plain").c_str(), [c](benchmark::State& s) {
      run<A, B>(s, c, [](const A& a, const B& b) {
        return query::guessed_nearest(*query::CoreCorners::of(query::view_of(a)),
                                      *query::CoreCorners::of(query::view_of(b)));
      });
    });
  }
}

const bool added = [] {
  add<Tetrahedron3, Tetrahedron3>("tetrahedra");
  add<Aabb3, Aabb3>("boxes");
  add<Aabb3, Obb3>("box_obb");
  add<Obb3, Obb3>("obbs");
  add<Capsule3, Capsule3>("capsules");
  add<ConvexPolyhedron3, ConvexPolyhedron3>("polyhedra200");
  return true;
}();

}  // namespace
}  // namespace plumb
