// Reports about convex hulls of few points in the plane: points that are missing, or should not be there.
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::docs {
namespace {

/// The corners' numbers, counterclockwise, which both methods tell and exact signs prove.
std::string hull(const std::vector<Point2>& points) {
  const Hull2 one = convex_hull(points);
  const HullVerdict verdict = verify_hull(one, points);
  EXPECT_TRUE(verdict) << verdict.flaw;
  EXPECT_EQ(convex_hull(points, {.method = Hull2Method::quickhull}), one);
  return told(one.vertices);
}

/// Points of a single precision, as they are.
std::vector<Point2> widened(std::initializer_list<std::array<float, 2>> points) {
  std::vector<Point2> wide;
  for (const auto& [x, y] : points) wide.push_back({x, y});
  return wide;
}

std::vector<Point2> octagons() {
  std::vector<Point2> points{{0, 0}};
  for (const auto& [r, d] : {std::array{1.0, 0.707}, {2.0, 1.414}, {3.0, 2.121}, {4.0, 2.828}}) {
    for (const Point2 p : {Point2{r, 0}, {d, d}, {0, r}, {-d, d}, {-r, 0}, {-d, -d}, {0, -r}, {d, -d}})
      points.push_back(p);
  }
  return points;
}

constexpr std::array cases{
    Case{"erincatto/box2d#296",
         [] {
           return hull(widened({{-1.70082211F, -1.43221712F},
                                {0.5F, -0.5F},
                                {0.104992867F, 0.97400856F},
                                {-0.658002853F, 0.926608086F},
                                {-0.994554818F, 0.165337861F}}));
         }},
    Case{"brian3kb/graham_scan_js#8",
         [] {
           return hull(
               {{223.25, 30}, {214.66796875, 53.6015625}, {213.79296875, 38.6015625}, {211.41796875, 29.2265625}});
         }},
    Case{"brian3kb/graham_scan_js#11",
         [] {
           return hull({{8.48206, 52.45522},
                        {8.2489553, 52.67141},
                        {8.28255, 52.6787},
                        {8.2718435, 52.7555779},
                        {7.41582, 53.11456},
                        {11.62771, 52.08609}});
         }},
    Case{"georust/geo#905",
         [] {
           return hull({{0, 0}, {1, 1}, {2, 2}});
         }},
    Case{"boostorg/geometry#829",
         [] {
           return hull({{2, 1}, {3, 2}, {4, 3}, {7, 6}});
         }},
    Case{"DesignEngrLab/MIConvexHull#32",
         [] {
           return hull({{260, 600}, {285, 600}, {310, 600}, {335, 600}});
         }},
    Case{"JuliaPolyhedra/Polyhedra.jl#253",
         [] {
           return hull({{-1, -1},
                        {1, -1},
                        {-1, 1},
                        {1, 1},
                        {0.5, 1},
                        {0, -1},
                        {0, 1},
                        {-0.5, -1},
                        {-1.5, 0.25},
                        {0, -0.75},
                        {0, 0.75},
                        {1.5, -0.25}});
         }},
    Case{"JuliaReach/LazySets.jl#892",
         [] {
           return hull({{0.0, -1}, {-0.0, 1}, {0.0, 1}});
         }},
    Case{"igraph/igraph#805", [] { return hull(octagons()); }},
    Case{"dyn4j/dyn4j#83",
         [] {
           return hull({{-14.824543255380023, 15.85178543840377},
                        {-7.137129280540021, 9.172487271304316},
                        {-2.4267381389973397, 5.0798096789437},
                        {3.8090704585325725, -0.3382444381082488},
                        {5.468709158244611, 3.749237201781721},
                        {8.603427044732271, -4.503876374079454},
                        {18.28323008135373, -1.7637916875406638}});
         }},
    Case{"peterstace/simplefeatures#24",
         [] {
           return hull({{0.5326521145582077, 0.5485877685877577},
                        {0.3621088142676205, 0.5659955147732555},
                        {0.3858468357723894, 0.3782674382646396},
                        {0.42894512378502714, 0.46383436182460924},
                        {0.47475298844919056, 0.3891140656169353},
                        {0.5068343483791182, 0.44323186954969124},
                        {0.5704711402594045, 0.572169994958013},
                        {0.3729267858810107, 0.6136299003606884},
                        {0.6483512013657207, 0.6362081037667116},
                        {0.417255810423433, 0.44728479764485624}});
         }},
    Case{"scipy/scipy#14185",
         [] {
           return hull({{0, 1}, {1, 1e4 + 1}, {2, 1e8 + 1}, {2, -1}, {0, -1}});
         }},
    Case{"dimforge/parry#165",
         [] {
           const std::vector<Point3> one{{1, 2, 3}};
           const Hull3 h = convex_hull(one);
           EXPECT_EQ(h.dimension, 0);
           return told(h.vertices);
         }},
};

}  // namespace

std::span<const Case> hull_cases() { return cases; }

}  // namespace plumb::docs
