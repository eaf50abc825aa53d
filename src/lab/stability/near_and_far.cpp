// Distances between figures that meet, that are parallel, and that are far from the origin.
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/judged.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/trial/distance_tests.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"

namespace plumb::lab::stability {
namespace {

using DistanceQuestion = std::array<double, 12>;
using DistanceWay = Way<12, double>;

using DistanceCase = Judged<12>;

std::size_t how_many(const Settings& settings) { return settings.quick ? 500 : 20'000; }

/// Of two segments, or a point and a triangle, on integers to two, times 2^-10, so far from the origin.
std::vector<DistanceCase> on_lattice(const trial::Task& task, double from_origin, const Settings& settings) {
  return judged<12>(task, how_many(settings), settings.seed, [from_origin](DistanceQuestion& q, Entropy& entropy) {
    for (double& x : q) x = std::ldexp(static_cast<double>(entropy.within(2)), -10) + from_origin;
  });
}

/// Of a class of inputs that the charts have.
std::vector<DistanceCase> of_class(const trial::Task& task, std::string_view input, const Settings& settings) {
  return judged<12>(task, how_many(settings), settings.seed, filled(task, input));
}

/// -1 where the first is the lesser, 1 where the second is, else 0; what is no number is no lesser one.
int order(double a, double b) { return static_cast<int>(a > b) - static_cast<int>(a < b); }

Findings tried(const std::vector<DistanceWay>& ways, const std::vector<DistanceCase>& cases) {
  return {outcomes_of(ways,
                      [&](const DistanceWay& way) {
                        Count parted{"figures that meet, told to be apart"};
                        Count joined{"figures apart, told to meet"};
                        Count digits{"distances without one right digit"};
                        Count nearer{"pairs of figures of which the nearer was not told"};
                        std::vector<double> told;
                        for (const DistanceCase& c : cases) told.push_back(way.ask(c.question));
                        for (std::size_t i = 0; i < cases.size(); ++i) {
                          const double true_one = cases[i].truth, off = std::fabs(told[i] - true_one);
                          if (true_one == 0) {
                            ++parted.of;
                            if (told[i] != 0) ++parted.failures;
                          } else {
                            ++joined.of, ++digits.of;
                            if (told[i] == 0) ++joined.failures;
                            if (!(off < true_one)) ++digits.failures;
                          }
                          const int nearer_one = i == 0 ? 0 : order(cases[i - 1].truth, true_one);
                          if (nearer_one == 0) continue;
                          ++nearer.of;
                          if (order(told[i - 1], told[i]) != nearer_one) ++nearer.failures;
                        }
                        return std::vector{parted, joined, digits, nearer};
                      }),
          {}};
}

std::vector<DistanceWay> segment_ways() {
  auto ways = float_ways<12, double>(trial::SegmentSegmentDistance{});
  ways.push_back(
      {"exact",
       [](const DistanceQuestion& q) {
         return distance(Segment3{point_at(q.data()), point_at(&q[3])}, Segment3{point_at(&q[6]), point_at(&q[9])});
       },
       true});
  return ways;
}

std::vector<DistanceWay> triangle_ways() {
  auto ways = float_ways<12, double>(trial::PointTriangleDistance{});
  ways.push_back(
      {"exact", [](const DistanceQuestion& q) { return distance(point_at(q.data()), triangle_at(&q[3])); }, true});
  return ways;
}

}  // namespace

Experiment distance_experiment() {
  return {
      "near-and-far", "how far are two figures apart, and which of two is the nearer?", "RTCD 5.1.5, 5.1.9, 11.2.2",
      [](const Settings& settings) {
        std::vector<Scene> scenes;
        for (const bool far : {false, true}) {
          const std::string where = far ? "a hundred thousand units from the origin" : "at the origin";
          const double from_origin = far ? 100'000 : 0;
          scenes.push_back({far ? "far-segments" : "segments", "short segments on a lattice " + where, [=] {
                              return tried(segment_ways(),
                                           on_lattice(trial::segment_segment_distance_task(), from_origin, settings));
                            }});
          scenes.push_back({far ? "far-triangles" : "triangles", "points and triangles on a lattice " + where, [=] {
                              return tried(triangle_ways(),
                                           on_lattice(trial::point_triangle_distance_task(), from_origin, settings));
                            }});
        }
        scenes.push_back({"crossing-segments", "segments in one plane, exactly, that may cross", [=] {
                            return tried(segment_ways(),
                                         of_class(trial::segment_segment_distance_task(), "degenerate_long", settings));
                          }});
        scenes.push_back({"nearly-in-plane", "points and triangles off one plane by ulps", [=] {
                            return tried(triangle_ways(),
                                         of_class(trial::point_triangle_distance_task(), "off_by_ulps", settings));
                          }});
        return scenes;
      }};
}

}  // namespace plumb::lab::stability
