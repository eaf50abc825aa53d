// How long does a nearest point take, and how far off is it?  Beside plain doubles, Eigen and CGAL's Epick, on general
// and nearly degenerate input, and on general input far from the origin.  `ns` is for one question, `worst` and `mean`
// are errors of coordinates and distances in ulps against the exact numbers rounded once, `off` the share of answers
// with an error of more than 4.
#include <benchmark/benchmark.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/rivals/closest_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "plumb/query/closest/batch.hpp"
#include "plumb/query/closest/closest.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t cases = 4096;

Point3 cube_point(Entropy& e) {
  return {signed_unit_coordinate(e), signed_unit_coordinate(e), signed_unit_coordinate(e)};
}
Point3 mixed(const Point3& a, const Point3& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}
Point3 nudged(const Point3& p, Entropy& e) {
  return {moved_by_ulps(p.x, e.within(4)), moved_by_ulps(p.y, e.within(4)), moved_by_ulps(p.z, e.within(4))};
}

template <class Shape>
struct Case {
  Shape shape;
  Point3 p;
};

/// Axes at right angles, of length one, as far as doubles go.
std::array<Vector3, 3> axes(Entropy& entropy) {
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) x = signed_unit_coordinate(entropy), square += x * x;
  for (double& x : q) x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  return {Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          Vector3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

enum class Input { general, near, far };
constexpr const char* input_names[] = {"general", "near", "far"};

/// A million times as far from the origin as it is large.
Point3 away(const Point3& p) { return {p.x + 0x1.8p20, p.y - 0x1.2p20, p.z + 0x1.5p20}; }
void move_away(Segment3& s) { s = {away(s.a), away(s.b)}; }
void move_away(Triangle3& t) { t = {away(t.a), away(t.b), away(t.c)}; }
void move_away(Aabb3& box) { box = {away(box.min), away(box.max)}; }
void move_away(Obb3& box) { box.center = away(box.center); }

void fill(Case<Segment3>& c, bool near, Entropy& e) {
  c.shape = {cube_point(e), cube_point(e)};
  c.p = near ? nudged(mixed(c.shape.a, c.shape.b, 1.25 * unit_coordinate(e)), e) : cube_point(e);
}
void fill(Case<Triangle3>& c, bool near, Entropy& e) {
  auto& [a, b, t] = c.shape;
  a = cube_point(e), b = cube_point(e), t = cube_point(e);
  if (near) t = nudged(mixed(a, b, 1.25 * unit_coordinate(e)), e);  // a sliver
  c.p = near && e.coin() ? nudged(mixed(mixed(a, b, unit_coordinate(e)), t, unit_coordinate(e)), e) : cube_point(e);
}
void fill(Case<Aabb3>& c, bool near, Entropy& e) {
  const Point3 a = cube_point(e), b = cube_point(e);
  c.shape = {{std::fmin(a.x, b.x), std::fmin(a.y, b.y), std::fmin(a.z, b.z)},
             {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)}};
  c.p = near ? nudged(mixed(a, b, 1.25 * unit_coordinate(e)), e) : cube_point(e);
  if (near) c.p.x = moved_by_ulps(c.shape.max.x, e.within(4));
}
void fill(Case<Obb3>& c, bool near, Entropy& e) {
  const auto half = [&] { return 0.1 + 0.4 * unit_coordinate(e); };
  c.shape = {cube_point(e), axes(e), {half(), half(), half()}};
  const Point3 center = c.shape.center;
  const std::array<Vector3, 3> axis = c.shape.axes;
  const Vector3 h = c.shape.half;
  c.p = cube_point(e);
  if (!near) return;
  const double t = 2 * unit_coordinate(e) - 1;  // by an edge
  const auto at = [&](double o, double u, double v, double w) { return o + h.x * t * u + h.y * v + h.z * w; };
  c.p = nudged({at(center.x, axis[0].x, axis[1].x, axis[2].x), at(center.y, axis[0].y, axis[1].y, axis[2].y),
                at(center.z, axis[0].z, axis[1].z, axis[2].z)},
               e);
}

template <class Shape>
std::vector<Case<Shape>> inputs(Input input) {
  std::vector<Case<Shape>> all(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(51, i);
    fill(all[i], input == Input::near, entropy);
    if (input != Input::far) continue;
    move_away(all[i].shape);
    all[i].p = away(all[i].p);
  }
  return all;
}

const Point3& point_of(const NearestFound& n) { return n.point; }
const Point3& point_of(const Closest& c) { return c.on_b; }

double ulps_off(double x, double exact) {
  if (x == exact) return 0;
  const double ulp = std::nextafter(std::fabs(exact), std::numeric_limits<double>::infinity()) - std::fabs(exact);
  return std::fabs(x - exact) / ulp;
}

template <class Shape, class Method>
void add(const std::string& name, Input input, Method method) {
  const std::string whole = name + "/" + input_names[static_cast<std::size_t>(input)] + "/" + Method::name;
  benchmark::RegisterBenchmark(whole.c_str(), [input, method](benchmark::State& state) {
    const auto all = inputs<Shape>(input);
    for (auto _ : state) {
      double sum = 0;
      for (const auto& c : all) {
        const auto n = method(c.shape, c.p);
        sum += point_of(n).x + point_of(n).y + point_of(n).z + n.distance;
      }
      benchmark::DoNotOptimize(sum);
    }
    double worst = 0, sum = 0, off = 0;
    for (const auto& c : all) {
      const auto n = method(c.shape, c.p);
      const Point3 q = point_of(n);
      const Closest exact = closest_points(c.p, c.shape);
      const double most = std::fmax(std::fmax(ulps_off(q.x, exact.on_b.x), ulps_off(q.y, exact.on_b.y)),
                                    std::fmax(ulps_off(q.z, exact.on_b.z), ulps_off(n.distance, exact.distance)));
      worst = std::fmax(worst, most);
      sum += std::fmin(most, 0x1p53);
      off += most > 4 ? 1 : 0;
    }
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * cases * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.counters["worst"] = worst;
    state.counters["mean"] = sum / cases;
    state.counters["off"] = off / cases;
  });
}

struct Exact {
  static constexpr const char* name = "plumb";
  Closest operator()(const auto& shape, const Point3& p) const { return closest_points(p, shape); }
};
struct Plain {
  static constexpr const char* name = "plain";
  NearestFound operator()(const auto& shape, const Point3& p) const { return nearest_in_doubles(shape, p); }
};
struct ByEigen {
  static constexpr const char* name = "eigen";
  NearestFound operator()(const auto& shape, const Point3& p) const { return nearest_by_eigen(shape, p); }
};
struct ByCgal {
  static constexpr const char* name = "cgal_epick";
  NearestFound operator()(const auto& shape, const Point3& p) const { return nearest_by_cgal(shape, p); }
};

template <class Shape, class... Methods>
void add_all(const std::string& name) {
  for (const Input input : {Input::general, Input::near, Input::far}) (add<Shape>(name, input, Methods{}), ...);
}

/// One point against many: `ns` is for one item.
template <class Batch, class Shape>
void add_many(const std::string& name) {
  const auto run = [&](const std::string& method, auto find) {
    benchmark::RegisterBenchmark((name + "/" + method).c_str(), [find](benchmark::State& state) {
      std::vector<Shape> items;
      for (const auto& c : inputs<Shape>(Input::general)) items.push_back(c.shape);
      const Batch batch(items);
      for (auto _ : state) {
        std::size_t found = find(items, batch, Point3{0.25, 2.5, -0.125});
        benchmark::DoNotOptimize(found);
      }
      state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * cases * 1e-9,
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    });
  };
  const auto one_by_one = [](const auto& items, const Point3& p, const auto& distance_of) {
    std::size_t best = 0;
    double least = distance_of(items[0], p);
    for (std::size_t i = 1; i < items.size(); ++i) {
      const double d = distance_of(items[i], p);
      if (d < least) least = d, best = i;
    }
    return best;
  };
  run("batch", [](const auto&, const Batch& batch, const Point3& p) { return nearest(batch, p).index; });
  run("plumb", [one_by_one](const auto& items, const Batch&, const Point3& p) {
    return one_by_one(items, p, [](const Shape& s, const Point3& q) { return distance(s, q); });
  });
  run("plain", [one_by_one](const auto& items, const Batch&, const Point3& p) {
    return one_by_one(items, p, [](const Shape& s, const Point3& q) { return nearest_in_doubles(s, q).distance; });
  });
}

const bool added = [] {
  add_many<SegmentBatch, Segment3>("many_segments");
  add_many<TriangleBatch, Triangle3>("many_triangles");
  add_all<Segment3, Exact, Plain, ByEigen, ByCgal>("point_segment");
  add_all<Triangle3, Exact, Plain, ByEigen, ByCgal>("point_triangle");
  add_all<Aabb3, Exact, Plain, ByEigen>("point_box");
  add_all<Obb3, Exact, Plain, ByEigen>("point_obb");
  return true;
}();

}  // namespace
}  // namespace plumb::bench
