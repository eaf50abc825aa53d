// Hulls that are flat, and points of a plane as triangles.
#include <tuple>

#include "figure/basic/plane_of_points.hpp"
#include "figure/hull/hull3_faces.hpp"

namespace plumb::figure::hull3 {

void sweep(std::span<const figure::hull2::Indexed> points, bool flipped, FaceList& faces) {
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    return figure::hull2::turn(points[a], points[b], points[c]);
  };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (flipped) std::swap(b, c);
    faces.triangle(points[a].index, points[b].index, points[c].index);
  };
  // The boundary of what has been swept, counterclockwise.
  std::vector<std::size_t> next(points.size()), before(points.size());
  const auto link = [&](std::size_t a, std::size_t b) {
    next[a] = b;
    before[b] = a;
  };
  std::size_t p = 2;
  while (turn(0, 1, p) == Sign::zero) ++p;
  const bool left = turn(0, 1, p) == Sign::positive;
  for (std::size_t i = 0; i + 1 < p; ++i) {
    left ? add(i, i + 1, p) : add(i + 1, i, p);
    left ? link(i, i + 1) : link(i + 1, i);
  }
  left ? link(p - 1, p) : link(p, p - 1);
  left ? link(p, 0) : link(0, p);
  for (++p; p < points.size(); ++p) {
    std::size_t from = p - 1, to = p - 1;
    for (; turn(to, next[to], p) == Sign::negative; to = next[to]) add(to, p, next[to]);
    for (; turn(before[from], from, p) == Sign::negative; from = before[from]) add(before[from], p, from);
    link(from, p);
    link(p, to);
  }
}

namespace {

/// On one line: from end to end.  The smallest index of equal points comes first.
std::vector<std::uint32_t> on_line(std::span<const Point3> points, bool all) {
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, points[i].z, i); };
  if (all) {
    std::ranges::sort(order, {}, key);
    const auto same = [&](std::uint32_t i, std::uint32_t j) { return points[i] == points[j]; };
    order.erase(std::unique(order.begin(), order.end(), same), order.end());
  } else {
    const auto place = [&](std::uint32_t i) { return std::tuple(points[i].x, points[i].y, points[i].z); };
    const auto last = std::ranges::max_element(order, {}, place);  // the first of the largest
    order = {*std::ranges::min_element(order, {}, key), *last};
  }
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  return order;
}

}  // namespace

Hull3 flat_hull(std::span<const Point3> points, int dimension, const std::array<Point3, 3>& span,
                const HullOptions& options) {
  Hull3 hull;
  hull.dimension = dimension;
  if (dimension < 2) {
    if (dimension >= 0) hull.vertices = on_line(points, options.all_boundary_points);
    return hull;
  }
  const Look look = look_at_plane(span[0], span[1], span[2]);
  std::vector<Point2> seen;
  seen.reserve(points.size());
  for (const Point3& p : points) seen.push_back(projected(look, p));
  FaceList faces;
  const auto polygon = [&](bool all) {
    return convex_hull(std::span<const Point2>(seen), {.all_boundary_points = all}).vertices;
  };
  if (!options.all_boundary_points) {
    hull.vertices = polygon(false);
    options.triangulate ? faces.fan(hull.vertices) : faces.polygon(hull.vertices);
  } else {
    std::vector<figure::hull2::Indexed> all;
    for (std::uint32_t i = 0; i < seen.size(); ++i) all.push_back({seen[i], i});
    figure::hull2::sort_distinct(all);
    options.triangulate ? sweep(all, false, faces) : faces.polygon(polygon(true));
    for (const figure::hull2::Indexed& p : all) hull.vertices.push_back(p.index);
  }
  std::ranges::sort(hull.vertices);
  faces.move_to(hull);
  return hull;
}

}  // namespace plumb::figure::hull3
