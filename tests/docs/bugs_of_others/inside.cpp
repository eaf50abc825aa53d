// Reports about points in polygons: on edges, at corners, and level with corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/containment/polygon_location.hpp"

namespace plumb::docs {
namespace {

/// Where the points lie, which does not depend on how the polygon is turned or where its list begins.
std::string all(const Polygon2& polygon, const std::vector<Point2>& points) {
  std::string places;
  for (const Point2& p : points) {
    const Location location = locate(polygon, p);
    Polygon2 other = polygon;
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      std::rotate(other.vertices.begin(), other.vertices.begin() + 1, other.vertices.end());
      EXPECT_EQ(locate(other, p), location);
    }
    std::reverse(other.vertices.begin(), other.vertices.end());
    EXPECT_EQ(locate(other, p), location);
    places += (places.empty() ? "" : ", ") + told(location);
  }
  return places;
}

constexpr std::array cases{
    Case{"rowanwins/point-in-polygon-hao#24",
         [] {
           return all({{{0, 0}, {3, -1}, {4, 1}, {1, 2}}}, {{2, 0}, {1, 1}}) + "; " +
                  all({{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}}, {{0, 0}});
         }},
    Case{"apache/druid#4552",
         [] {
           return all({{{1, 1}, {4, 4}, {7, 1}}}, {{1, 1}, {4, 1}});
         }},
    Case{"rapidsai/cuspatial#744",
         [] {
           return all({{{-1, -1}, {0, -1}, {0, 1}, {-1, 1}}}, {{0, 0}}) + "; " +
                  all({{{0, -1}, {1, -1}, {1, 1}, {0, 1}}}, {{0, 0}});
         }},
    Case{"godotengine/godot#81042",
         [] {
           std::set<std::string> answers;
           for (double i = 1; i < 100; ++i) answers.insert(all({{{-i, -i}, {i, -i}, {i, i}, {-i, i}}}, {{-i, 0}}));
           return answers.size() == 1 ? *answers.begin() + ", 99 times" : "several answers";
         }},
    Case{"d3/d3-polygon#30",
         [] {
           const std::vector<Point2> square{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
           return all({square}, square);
         }},
    Case{"Turfjs/turf-inside#11",
         [] {
           const Point2 ul{-79.4586181640625, 39.53793974517629};
           const double x = ul.x + 0.03, y = ul.y + 0.03;  // both rounded, as the report adds them
           const Point2 ur{x, ul.y}, ll{ul.x, y}, lr{x, y};
           const double level = ul.y * 0.5 + ll.y * 0.5, along = ul.x * 0.5 + ur.x * 0.5;
           return all({{ul, ur, lr, ll}}, {ul, ur, ll, lr, {ul.x, level}, {ur.x, level}, {along, ul.y}, {along, ll.y}});
         }},
};

}  // namespace

std::span<const Case> inside_cases() { return cases; }

}  // namespace plumb::docs
