// The arrangement of segments: where do they cross, and into how many faces do they cut the plane?
//
// Crossings are exact points: a crossing of three segments is one vertex and not three that rounding keeps apart.
// Euler's formula proves the count: it comes out a whole number of faces for every part only if no vertex is missed.
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <plumb/surface.hpp>
#include <vector>

using plumb::PlanarArrangement, plumb::Point2, plumb::Segment2;

namespace {

// What hangs together.
std::size_t count_parts(const PlanarArrangement& made) {
  std::vector<std::size_t> root(made.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::size_t parts = made.vertices.size();
  for (const auto& [a, b] : made.edges) {
    const std::size_t ra = find(a), rb = find(b);
    if (ra == rb) continue;
    root[ra] = rb;
    --parts;
  }
  return parts;
}

// What a program sees that rounds its crossings, each pair's on its own.
std::size_t count_rounded_vertices(const std::vector<Segment2>& segments) {
  const auto cross = [](const Segment2& s, const Segment2& t, Point2& p) {
    const double dx = s.b.x - s.a.x, dy = s.b.y - s.a.y, ex = t.b.x - t.a.x, ey = t.b.y - t.a.y, d = dx * ey - dy * ex;
    const double u = ((t.a.x - s.a.x) * ey - (t.a.y - s.a.y) * ex) / d;
    const double v = ((t.a.x - s.a.x) * dy - (t.a.y - s.a.y) * dx) / d;
    p = {s.a.x + u * dx, s.a.y + u * dy};
    return d != 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1;
  };
  std::vector<std::pair<double, double>> rounded;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Point2& p : {segments[i].a, segments[i].b}) rounded.emplace_back(p.x, p.y);
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      if (Point2 p; cross(segments[i], segments[k], p)) rounded.emplace_back(p.x, p.y);
    }
  }
  std::sort(rounded.begin(), rounded.end());
  rounded.erase(std::unique(rounded.begin(), rounded.end()), rounded.end());
  return rounded.size();
}

void show(const char* name, const std::vector<Segment2>& segments) {
  const PlanarArrangement made = plumb::arrange_segments(segments);
  const std::size_t parts = count_parts(made);
  std::printf("%s: %zu segments, %zu vertices (rounded: %zu), %zu edges, %zu parts, %u faces\n", name, segments.size(),
              made.vertices.size(), count_rounded_vertices(segments), made.edges.size(), parts, made.faces);
  if (made.faces != made.edges.size() + parts + 1 - made.vertices.size()) std::printf("Euler disagrees\n");
}

}  // namespace

int main() {
  // Three lines through (1/3, 1/3), where no double lies.
  show("a star", {{{0, 0}, {1, 1}}, {{0, 1}, {0.5, 0}}, {{1, 0}, {0, 0.5}}});

  // From every point of one side of a square to every point of the other: on whole numbers many pass through one point,
  // on tenths, which are no doubles, fewer do.
  for (const double step : {1.0, 0.1}) {
    std::vector<Segment2> fan;
    for (int i = 0; i <= 10; ++i) {
      for (int k = 0; k <= 10; ++k) fan.push_back({{0, step * i}, {10 * step, step * k}});
    }
    show(step == 1 ? "a fan of whole numbers" : "a fan of tenths", fan);
  }

  show("overlaps", {{{0, 0}, {4, 4}}, {{1, 1}, {6, 6}}, {{2, 2}, {3, 3}}, {{0, 4}, {4, 0}}, {{5, 5}, {5, 5}}});
}
