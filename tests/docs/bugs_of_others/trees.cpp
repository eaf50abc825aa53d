// Reports about k-d trees: a nearest point that is not, and points that are all alike.
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/space/kd_tree/figure_range.hpp"
#include "plumb/space/kd_tree/figure_tree.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"

namespace plumb::docs {
namespace {

constexpr std::array cases{
    Case{"Vectorized/Python-KD-Tree#9",
         [] {
           const KdTree2 tree = build_kd_tree(std::vector<Point2>{{7, 3}, {5, 3}, {2, 3}});
           std::string all;
           for (const NearestPoint& n : nearest(tree, {5, 3}, 2))
             all += (all.empty() ? "" : ", ") + ("point " + std::to_string(n.index)) + " at " + told(n.distance);
           return all;
         }},
    Case{"artem-ogre/CDT#200",
         [] {
           const KdTree2 tree =
               build_kd_tree(std::vector<Point2>{{168.67, -122.39}, {-25.12, 109.06}, {161.07, 86.2}, {178.36, 40.75}});
           const NearestPoint n = nearest(tree, {153.63, -30.09});
           return "point " + std::to_string(n.index) + " at " + told(n.distance);
         }},
    Case{"jlblancoc/nanoflann#70",
         [] {
           const KdTree3 tree = build_kd_tree(std::vector<Point3>{{-0.299154, 3.8883, -2.39116}});
           return std::to_string(within(tree, {-0.296186, 3.89975, -2.40087}, 0.0156892).size()) + " within";
         }},
    Case{"flann-lib/flann#159",
         [] {
           std::vector<Point3> corners;
           for (int i = 0; i < 8; ++i) corners.push_back({(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5});
           const KdTree3 tree = build_kd_tree(corners);
           return std::to_string(within(tree, {100, 100, 100}, 200).size()) + " within";
         }},
    Case{"stevengj/GeometryPrimitives.jl#21",
         [] {
           std::vector<Aabb2> boxes;
           for (const double x : {0.0, 0.0, 0.0, 0.0, 2.0, 3.0, 4.0}) boxes.push_back({{x - 1, -1}, {x + 1, 1}});
           const FigureTree<Aabb2> tree = build_figure_tree(boxes);
           return told(in_box(tree, {{0, 0}, {0, 0}})) + " at (0, 0), " + told(in_box(tree, {{3, 0}, {3, 0}})) +
                  " at (3, 0)";
         }},
    Case{"scipy/scipy#5564",
         [] {
           std::vector<Point2> points(200'000, {1, 0});
           std::fill(points.begin() + 100'000, points.end(), Point2{2, 0});
           const KdTree2 tree = build_kd_tree(points);
           const NearestPoint n = nearest(tree, {1.75, 0});
           EXPECT_EQ(nearest(tree, {1.25, 0}).index, 0u);
           return "point " + std::to_string(n.index) + " at " + told(n.distance) + ", " +
                  std::to_string(within(tree, {1.75, 0}, 0.25).size()) + " as near";
         }},
};

}  // namespace

std::span<const Case> tree_cases() { return cases; }

}  // namespace plumb::docs
