// Is what comes of any points and segments a constrained Delaunay triangulation, and do faces keep their edges?
#include <cstdint>
#include <iostream>
#include <map>
#include <span>

#include "plumb/degenerate/points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/surface/planar/arrange_segments.hpp"
#include "plumb/surface/planar/convex_pieces.hpp"
#include "surface/planar/cut_ring.hpp"

namespace plumb::fuzz {
namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << what << std::endl;
  std::abort();
}

std::vector<Point2> points_from(Entropy& entropy) {
  if (entropy.coin()) return points2(any_family(entropy), Degeneracy::cocircular, 1 + entropy.below(20), entropy);
  std::vector<Point2> points(1 + entropy.below(30));
  for (Point2& p : points) {
    p.x = static_cast<double>(entropy.within(3));
    p.y = static_cast<double>(entropy.within(3));
  }
  return points;
}

// Every edge is locally Delaunay or covered, and seen alike from both sides.
void check(const std::vector<Point2>& points, const PlanarTriangulation& made) {
  for (std::uint32_t f = 0; f < made.triangles.size(); ++f) {
    const auto& t = made.triangles[f];
    require(orient2d(points[t[0]], points[t[1]], points[t[2]]) == Sign::positive, "a triangle has no area");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t over = made.neighbors[f][k];
      if (over == PlanarTriangulation::none) continue;
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], p = t[(k + 2) % 3];
      const auto& u = made.triangles[over];
      std::size_t j = 0;
      while (j < 3 && !(u[j] == b && u[(j + 1) % 3] == a)) ++j;
      require(j < 3 && made.neighbors[over][j] == f, "neighbors disagree");
      if (made.segments[f][k] != PlanarTriangulation::none) continue;
      const std::uint32_t d = u[(j + 2) % 3];
      const Sign inside = incircle(points[a], points[b], points[p], points[d]);
      require(inside == Sign::negative || (inside == Sign::zero && std::min(a, b) < std::min(p, d)),
              "an edge is not locally Delaunay");
    }
  }
}

// Two triangles fewer than corners, whose edges add up to those of the ring, none turned over.
void check_ring(const std::vector<Point2>& ring) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (ring.size() < 3 || !surface::cut_ring(ring, triangles)) return;
  require(triangles.size() + 2 == ring.size(), "a ring has another number of triangles");
  std::map<std::array<std::uint32_t, 2>, int> edges;
  const auto add = [&](std::uint32_t a, std::uint32_t b, int by) {
    edges[{std::min(a, b), std::max(a, b)}] += a < b ? by : -by;
  };
  Sign turn = Sign::zero;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
    const Sign s = orient2d(ring[t[0]], ring[t[1]], ring[t[2]]);
    require(s == Sign::zero || turn == Sign::zero || s == turn, "triangles of a ring turn differently");
    if (s != Sign::zero) turn = s;
  }
  for (std::uint32_t i = 0; i < ring.size(); ++i) add(i, i + 1 == ring.size() ? 0 : i + 1, -1);
  for (const auto& [edge, count] : edges) require(count == 0, "a ring's edges are not its triangles'");
}

// Euler's formula, part by part, is the faces' own: each edge has faces on both sides, their windings differ by its
// weight.
void check_arrangement(const PlanarArrangement& made) {
  if (made.windings.empty()) return;
  for (std::size_t k = 0; k < made.edges.size(); ++k)
    require(made.windings[made.sides[k][0]] - made.windings[made.sides[k][1]] == made.weights[k], "windings disagree");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const std::vector<Point2> points = fuzz::points_from(entropy);
  std::vector<PlanarSegment> segments(entropy.below(20));
  for (auto& [a, b] : segments) {
    a = static_cast<std::uint32_t>(entropy.below(points.size()));
    b = static_cast<std::uint32_t>(entropy.below(points.size()));
  }
  try {
    fuzz::check(points, delaunay(points, segments));
  } catch (const CrossingSegments&) {
  }
  fuzz::check_ring(points);
  std::vector<Segment2> path;
  for (std::size_t k = 0; k < points.size(); ++k) path.push_back({points[k], points[(k + 1) % points.size()]});
  if (path.size() <= 12) fuzz::check_arrangement(arrange_segments(path));
  return 0;
}
