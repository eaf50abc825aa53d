// How long do closest points take, and how far off are plain doubles?  Segments, lines and triangles beside plain
// doubles, Eigen and CGAL's kernel of doubles.  `ns` a pair; `ulps`: the median, the mean and the worst error of the
// distance.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/rivals/closest_pairs_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "plumb/query/closest/closest.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs = 1024;

/// 0: anywhere in a cube; 1: almost parallel, off by 2^-30 of the length; 2: exactly parallel on a grid; 3: integers of
/// ten bits; 4: far apart; 5: as 0, a million times as far from the origin.
constexpr int kinds = 6;

Point3 anywhere(Entropy& e, double size) {
  const auto at = [&] { return size * signed_unit_coordinate(e); };
  return {at(), at(), at()};
}
Point3 on_grid(Entropy& e, int bits) {
  const auto at = [&] { return grid_coordinate(e, bits); };
  return {at(), at(), at()};
}
Point3 sum(const Point3& p, const Point3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Point3 difference(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

/// Points in fours or sixes, of which the second segment, or triangle, has the edge of the first.
std::vector<Point3> points(int kind, std::size_t each, Entropy& e) {
  std::vector<Point3> p;
  for (std::size_t i = 0; i < each; ++i) {
    p.push_back(kind == 2 || kind == 3 ? on_grid(e, 10) : anywhere(e, 1));
  }
  const std::size_t half = each / 2;
  if (kind == 1) p[half + 1] = sum(p[half], sum(difference(p[1], p[0]), anywhere(e, 0x1p-30)));
  if (kind == 2) p[half + 1] = sum(p[half], difference(p[1], p[0]));
  if (kind == 5) {
    for (Point3& x : p) x = sum(x, {0x1.8p20, -0x1.2p20, 0x1.5p20});
  }
  if (kind == 4) {
    for (std::size_t i = half; i < each; ++i) p[i] = sum(p[i], {5, 3, 1});
  }
  return p;
}

template <class Shape>
struct Pair {
  Shape a, b;
};

std::vector<Pair<Segment3>> segment_pairs(int kind) {
  std::vector<Pair<Segment3>> all;
  Entropy e(1, static_cast<std::uint64_t>(kind));
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto p = points(kind, 4, e);
    all.push_back({{p[0], p[1]}, {p[2], p[3]}});
  }
  return all;
}
std::vector<Pair<Segment2>> flat_segment_pairs(int kind) {
  std::vector<Pair<Segment2>> all;
  for (const auto& [a, b] : segment_pairs(kind)) {
    const auto flat = [](const Point3& p) { return Point2{p.x, p.y}; };
    all.push_back({{flat(a.a), flat(a.b)}, {flat(b.a), flat(b.b)}});
  }
  return all;
}
std::vector<Pair<Line3>> line_pairs(int kind) {
  std::vector<Pair<Line3>> all;
  for (const auto& [a, b] : segment_pairs(kind)) {
    const auto line = [](const Segment3& s) {
      const Point3 d = difference(s.b, s.a);
      return Line3{s.a, {d.x, d.y, d.z}};
    };
    all.push_back({line(a), line(b)});
  }
  return all;
}
std::vector<Pair<Triangle3>> triangle_pairs(int kind) {
  std::vector<Pair<Triangle3>> all;
  Entropy e(2, static_cast<std::uint64_t>(kind));
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto p = points(kind, 6, e);
    all.push_back({{p[0], p[1], p[2]}, {p[3], p[4], p[5]}});
  }
  return all;
}

/// How many doubles lie between each answer and the nearest double to the true one, where that is not zero.
template <class All, class Distance>
void count_ulps(benchmark::State& state, const All& all, Distance distance_of) {
  std::vector<double> off;
  for (const auto& [a, b] : all) {
    const double truth = distance(a, b), x = distance_of(a, b);
    if (truth == 0) continue;
    off.push_back(std::isnan(x) ? 0x1p63 : std::fabs(static_cast<double>(place_of(truth) - place_of(x))));
  }
  if (off.empty()) return;
  std::sort(off.begin(), off.end());
  double mean = 0;
  for (const double x : off) mean += std::fmin(x, 0x1p53) / static_cast<double>(off.size());
  state.counters["ulps_median"] = off[off.size() / 2];
  state.counters["ulps_mean"] = mean;
  state.counters["ulps_worst"] = off.back();
}

template <class All, class Take>
void run(benchmark::State& state, const All& all, Take take) {
  for (auto _ : state) {
    for (const auto& [a, b] : all) benchmark::DoNotOptimize(take(a, b));
  }
  state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                            benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

int kind_of(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

#define PLUMB_METHOD(name, inputs, ...)                                                   \
  void name(benchmark::State& state) { run(state, inputs(kind_of(state)), __VA_ARGS__); } \
  BENCHMARK(name)->DenseRange(0, kinds - 1)
#define PLUMB_RIVAL(name, inputs, distance_of, ...) \
  void name(benchmark::State& state) {              \
    const auto all = inputs(kind_of(state));        \
    count_ulps(state, all, distance_of);            \
    run(state, all, __VA_ARGS__);                   \
  }                                                 \
  BENCHMARK(name)->DenseRange(0, kinds - 1)

constexpr auto closest = [](const auto& a, const auto& b) { return closest_points(a, b); };
constexpr auto length = [](const auto& a, const auto& b) { return distance(a, b); };
constexpr auto nearer_than_half = [](const auto& a, const auto& b) { return compare_distance(a, b, 0.5); };
constexpr auto plain_segments = [](const auto& a, const auto& b) { return segments_in_doubles(a, b); };
constexpr auto plain_segments_length = [](const auto& a, const auto& b) {
  return std::sqrt(segments_in_doubles(a, b).square);
};
constexpr auto plain_lines = [](const auto& a, const auto& b) { return lines_in_doubles(a, b); };
constexpr auto plain_lines_length = [](const auto& a, const auto& b) {
  return std::sqrt(lines_in_doubles(a, b).square);
};
constexpr auto plain_triangles = [](const auto& a, const auto& b) { return triangles_in_doubles(a, b); };
constexpr auto plain_triangles_length = [](const auto& a, const auto& b) {
  return std::sqrt(triangles_in_doubles(a, b).square);
};
constexpr auto with_side = [](const auto& a, const auto& b) { return closest_points(Segment3{a.a, a.b}, b); };
constexpr auto plain_with_side = [](const auto& a, const auto& b) {
  return segment_triangle_in_doubles(Segment3{a.a, a.b}, b);
};

PLUMB_METHOD(segments, segment_pairs, closest);
PLUMB_METHOD(segments_distance, segment_pairs, length);
PLUMB_METHOD(segments_compare, segment_pairs, nearer_than_half);
PLUMB_RIVAL(segments_plain, segment_pairs, plain_segments_length, plain_segments);
PLUMB_RIVAL(segments_eigen, segment_pairs, segments_in_eigen, segments_in_eigen);
PLUMB_RIVAL(segments_cgal, segment_pairs, segments_in_cgal, segments_in_cgal);

PLUMB_METHOD(flat_segments, flat_segment_pairs, closest);
PLUMB_METHOD(flat_segments_compare, flat_segment_pairs, nearer_than_half);
PLUMB_RIVAL(flat_segments_plain, flat_segment_pairs, plain_segments_length, plain_segments);

PLUMB_METHOD(lines, line_pairs, closest);
PLUMB_RIVAL(lines_plain, line_pairs, plain_lines_length, plain_lines);
PLUMB_RIVAL(lines_cgal, line_pairs, lines_in_cgal, lines_in_cgal);

PLUMB_METHOD(segment_triangle, triangle_pairs, with_side);
PLUMB_METHOD(segment_triangle_plain, triangle_pairs, plain_with_side);

PLUMB_METHOD(triangles, triangle_pairs, closest);
PLUMB_METHOD(triangles_distance, triangle_pairs, length);
PLUMB_METHOD(triangles_compare, triangle_pairs, nearer_than_half);
PLUMB_RIVAL(triangles_plain, triangle_pairs, plain_triangles_length, plain_triangles);
PLUMB_RIVAL(triangles_cgal, triangle_pairs, triangles_in_cgal, triangles_in_cgal);

}  // namespace
}  // namespace plumb::bench
