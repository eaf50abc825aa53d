#include "space/bvh/nested_spheres.hpp"

#include <cmath>
#include <numeric>

#include "plumb/figure/sphere/sphere.hpp"

namespace plumb::space {
namespace {

constexpr int center_steps = 24;

/// How far a ball reaches from a point; a guess.
double rough_reach(const Point3& from, const Sphere3& ball) {
  return std::hypot(ball.center.x - from.x, ball.center.y - from.y, ball.center.z - from.z) + ball.radius;
}

Point3 guessed_center(std::span<const Sphere3> balls) {
  Point3 at{0, 0, 0};
  const auto n = static_cast<double>(balls.size());
  for (const Sphere3& b : balls) at = {at.x + b.center.x / n, at.y + b.center.y / n, at.z + b.center.z / n};
  Point3 best = at;
  double least = HUGE_VAL;
  for (int step = 1; step <= center_steps; ++step) {
    const Sphere3* far = &balls[0];
    double most = -1;
    for (const Sphere3& b : balls) {
      const double r = rough_reach(at, b);
      if (r > most) most = r, far = &b;
    }
    if (most < least) least = most, best = at;
    const double part = 1.0 / (step + 1);
    const auto toward = [&](double from, double to) { return from + part * (to - from); };
    at = {toward(at.x, far->center.x), toward(at.y, far->center.y), toward(at.z, far->center.z)};
  }
  const auto is_real = [](double x) { return x - x == 0; };
  return is_real(best.x) && is_real(best.y) && is_real(best.z) ? best : balls[0].center;
}

double reach_of_all(const Point3& center, std::span<const Sphere3> balls) {
  double radius = 0;
  for (const Sphere3& b : balls) radius = std::max(radius, figure::sphere::reach(center, b));
  return figure::within_doubles(radius, "build_sphere_tree", "radius");
}

}  // namespace

Sphere3 sphere_around(std::span<const Sphere3> balls) {
  const Sphere3& largest = *std::ranges::max_element(balls, {}, &Sphere3::radius);
  if (std::ranges::all_of(balls, [&](const Sphere3& b) { return contains(largest, b); })) return largest;
  const Point3 center = guessed_center(balls);
  return {center, reach_of_all(center, balls)};
}

SphereTree nested_levels(const std::vector<std::vector<std::uint32_t>>& children, std::span<const Sphere3> last) {
  SphereTree tree;
  if (last.empty()) return tree;
  tree.begin_of_level.push_back(0);
  for (const auto& level : children) {
    tree.begin_of_level.push_back(tree.begin_of_level.back() + static_cast<std::uint32_t>(level.size()));
  }
  tree.begin_of_level.push_back(tree.begin_of_level.back() + static_cast<std::uint32_t>(last.size()));
  tree.nodes.resize(tree.begin_of_level.back());
  for (std::size_t k = 0; k < children.size(); ++k) {
    std::uint32_t next = tree.begin_of_level[k + 1];
    for (std::size_t i = 0; i < children[k].size(); ++i) {
      SphereNode& node = tree.nodes[tree.begin_of_level[k] + i];
      node.first_child = next;
      node.children = children[k][i];
      next += node.children;
    }
  }
  const std::size_t inner = tree.nodes.size() - last.size();
  for (std::size_t i = 0; i < last.size(); ++i) tree.nodes[inner + i] = {last[i], 0, 0};
  std::vector<Sphere3> below;
  for (std::size_t i = inner; i-- > 0;) {
    SphereNode& node = tree.nodes[i];
    below.clear();
    for (std::uint32_t c = 0; c < node.children; ++c) below.push_back(tree.nodes[node.first_child + c].sphere);
    node.sphere = sphere_around(below);
  }
  return tree;
}

void nest(SphereTree& tree) {
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    SphereNode& node = tree.nodes[i];
    for (std::uint32_t c = 0; c < node.children; ++c) {
      const double r = figure::sphere::reach(node.sphere.center, tree.nodes[node.first_child + c].sphere);
      node.sphere.radius = figure::within_doubles(std::max(node.sphere.radius, r), "transform", "radius");
    }
  }
}

}  // namespace plumb::space
