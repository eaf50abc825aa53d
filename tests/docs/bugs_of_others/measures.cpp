// Reports about smallest enclosing circles and spheres, centroids, and convexity.
#include "plumb/figure/measures/measures.hpp"

#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb::docs {
namespace {

/// What the exact ball's own points say: none is outside.
template <class Point>
std::string smallest(const std::vector<Point>& points) {
  const auto least = [&] {
    if constexpr (std::same_as<Point, Point2>)
      return minimum_circle(points);
    else
      return minimum_sphere(points);
  }();
  for (const Point& p : points) EXPECT_NE(locate(least.exact, p), Location::outside);
  const auto& [center, radius] = [&] {
    if constexpr (std::same_as<Point, Point2>)
      return least.circle;
    else
      return least.sphere;
  }();
  return told(center) + ", radius " + told(radius);
}

/// By the sums of the textbook, in rationals, and rounded once at the end.
Point2 centroid_in_rationals(const Polygon2& polygon) {
  Rational area, x, y;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const auto& p = polygon.vertices[i];
    const auto& q = polygon.vertices[(i + 1) % polygon.vertices.size()];
    const Rational part = Rational(p.x) * Rational(q.y) - Rational(q.x) * Rational(p.y);
    area = area + part;
    x = x + (Rational(p.x) + Rational(q.x)) * part;
    y = y + (Rational(p.y) + Rational(q.y)) * part;
  }
  return {(x / (Rational(3) * area)).rounded(), (y / (Rational(3) * area)).rounded()};
}

std::string middle(const Polygon2& polygon) {
  EXPECT_EQ(centroid(polygon), centroid_in_rationals(polygon));
  return told(centroid(polygon));
}

std::string volume_or_refusal(const TriangleMesh& mesh) {
  try {
    return told(volume(mesh));
  } catch (const InvalidShape&) {
    return "refused";
  }
}

constexpr std::array cases{
    Case{"opencv/opencv#6438",
         [] {
           return smallest<Point2>({{0, 0}, {0.5, 0.01}, {1, 0}});
         }},
    Case{"marmakoide/miniball#4",
         [] {
           return smallest<Point3>({{-6, -4, 5}, {0, -2, 0}, {-2, -6, -1}});
         }},
    Case{"SlimDX/slimdx#256",
         [] {
           return smallest<Point3>({{1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {-1, 0, 0}});
         }},
    Case{"HarryStevens/geometric#55",
         [] {
           return middle(Polygon2{{{491161.5531691139, 5551832.619240159},
                                   {491160.31112895225, 5551829.8884276515},
                                   {491158.1264789461, 5551830.882059781},
                                   {491159.36851910775, 5551833.612872289}}});
         }},
    Case{"cleder/pygeoif#380",
         [] {
           const double o = 1e10;
           return middle(Polygon2{{{o, o}, {o + 10, o}, {o + 10, o + 10}, {o, o + 10}}});
         }},
    Case{"martinResearch/DEODR#243",
         [] {
           TriangleMesh open{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}};
           const std::string where_it_stands = volume_or_refusal(open);
           for (Point3& v : open.vertices) v.x += 7;
           EXPECT_EQ(volume_or_refusal(open), where_it_stands);
           return where_it_stands;
         }},
    Case{"isl-org/Open3D#3027",
         [] {
           return volume_or_refusal(
               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 3, 0}}});
         }},
    Case{"georust/geo#1394",
         [] {
           const Polygon2 star{{{0, 0}, {10, 0}, {7, -1}, {4, 5}, {6, 5}, {3, -1}}};
           const PolygonConvexity shape = convexity(star);
           EXPECT_EQ(is_convex(star), shape.is_convex());
           return std::string(shape.is_convex() ? "convex" : "not convex") + ", " + std::to_string(shape.turns) +
                  " turns";
         }},
};

}  // namespace

std::span<const Case> measure_cases() { return cases; }

}  // namespace plumb::docs
