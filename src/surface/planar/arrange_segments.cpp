#include "plumb/surface/planar/arrange_segments.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/section/intersection2.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "surface/planar/triangulator.hpp"

namespace plumb {
namespace {

using surface::HalfEdge, surface::none, surface::Triangles;
using SegmentPieces = std::vector<std::array<std::uint32_t, 2>>;

void require_segments(std::span<const Segment2> segments) {
  std::vector<Point2> ends;
  ends.reserve(2 * segments.size());
  for (const Segment2& s : segments) ends.insert(ends.end(), {s.a, s.b});
  require_finite_points("arrange_segments", "ends", std::span<const Point2>(ends));
}

// Finds the points of each segment, in order from its end a: the ends, and what it has in common with others.
std::vector<std::vector<ExactPoint2>> points_on(std::span<const Segment2> segments) {
  std::vector<Aabb2> boxes;
  boxes.reserve(segments.size());
  std::vector<std::vector<ExactPoint2>> points(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [a, b] = segments[i];
    boxes.push_back({{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
    points[i] = {a, b};
  }
  for (const BoxPair& pair : overlapping_pairs(std::span<const Aabb2>(boxes))) {
    for (const ExactPoint2& p : intersection(segments[pair.a], segments[pair.b]).vertices) {
      points[pair.a].push_back(p);
      points[pair.b].push_back(p);
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    std::sort(points[i].begin(), points[i].end());
    points[i].erase(std::unique(points[i].begin(), points[i].end()), points[i].end());
    if (compare_xy(segments[i].a, segments[i].b) == Sign::positive) std::reverse(points[i].begin(), points[i].end());
  }
  return points;
}

// Vertices, the ends of segments, and the pieces of all segments, as they go.
SegmentPieces number_points(std::vector<std::vector<ExactPoint2>> points, PlanarArrangement& made) {
  for (const auto& of : points) made.vertices.insert(made.vertices.end(), of.begin(), of.end());
  std::sort(made.vertices.begin(), made.vertices.end());
  made.vertices.erase(std::unique(made.vertices.begin(), made.vertices.end()), made.vertices.end());
  SegmentPieces pieces;
  for (const auto& of : points) {
    std::vector<std::uint32_t> numbers;
    for (const ExactPoint2& p : of)
      numbers.push_back(static_cast<std::uint32_t>(std::lower_bound(made.vertices.begin(), made.vertices.end(), p) -
                                                   made.vertices.begin()));
    made.ends.push_back({numbers.front(), numbers.back()});
    for (std::size_t k = 1; k < numbers.size(); ++k) pieces.push_back({numbers[k - 1], numbers[k]});
  }
  return pieces;
}

void collect_edges(const SegmentPieces& pieces, PlanarArrangement& made) {
  for (const auto& [a, b] : pieces) made.edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(made.edges.begin(), made.edges.end());
  made.edges.erase(std::unique(made.edges.begin(), made.edges.end()), made.edges.end());
  made.weights.assign(made.edges.size(), 0);
  made.sides.assign(made.edges.size(), {0, 0});
}

std::size_t edge_between(const PlanarArrangement& made, std::uint32_t a, std::uint32_t b) {
  const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
  return static_cast<std::size_t>(std::lower_bound(made.edges.begin(), made.edges.end(), edge) - made.edges.begin());
}

// Numbers what hangs together without crossing an edge, from the ghosts on.
std::vector<std::uint32_t> number_faces(const Triangles& t, std::uint32_t& faces) {
  std::vector<std::uint32_t> face(t.end() / 4, none);
  std::vector<HalfEdge> pending;
  const auto spread = [&](HalfEdge from, std::uint32_t number) {
    face[from / 4] = number;
    pending.push_back(from);
    while (!pending.empty()) {
      const HalfEdge first = Triangles::first_of(pending.back());
      pending.pop_back();
      for (HalfEdge e = first; e < first + 3; ++e) {
        const HalfEdge beyond = t.twin(e);
        if (face[beyond / 4] != none || t.is_constrained(e)) continue;
        face[beyond / 4] = number;
        pending.push_back(beyond);
      }
    }
  };
  for (HalfEdge first = 0; first < t.end(); first += 4)
    if (t.is_ghost(first) && face[first / 4] == none) spread(first, 0);
  faces = 1;
  for (HalfEdge first = 0; first < t.end(); first += 4)
    if (face[first / 4] == none) spread(first, faces++);
  return face;
}

bool is_balanced(const PlanarArrangement& made) {
  std::vector<std::int32_t> leaving(made.vertices.size());
  for (const auto& [a, b] : made.ends) {
    ++leaving[a];
    --leaving[b];
  }
  return std::all_of(leaving.begin(), leaving.end(), [](std::int32_t n) { return n == 0; });
}

}  // namespace

PlanarArrangement arrange_segments(std::span<const Segment2> segments) {
  require_segments(segments);
  PlanarArrangement made;
  const SegmentPieces pieces = number_points(points_on(segments), made);
  collect_edges(pieces, made);
  for (const auto& [a, b] : pieces) made.weights[edge_between(made, a, b)] += a < b ? 1 : -1;
  auto triangulator = surface::triangulator_of(std::span<const ExactPoint2>(made.vertices));
  (void)triangulator.constrain(pieces);  // which meet in vertices only
  const Triangles& t = triangulator.triangles();
  const bool balanced = is_balanced(made);
  if (balanced) made.windings = {0};
  if (!t.has_marks()) return made;
  const std::vector<std::uint32_t> face = number_faces(t, made.faces);
  const std::vector<std::int32_t> windings = triangulator.windings();
  if (balanced) made.windings.assign(made.faces, 0);
  for (HalfEdge first = 0; first < t.end(); first += 4) {
    const std::uint32_t number = face[first / 4];
    if (balanced) made.windings[number] = windings[first / 4];
    for (HalfEdge e = first; e < first + 3; ++e) {
      if (!t.is_constrained(e)) continue;
      const std::uint32_t a = triangulator.points().label(t.origin(e)), b = triangulator.points().label(t.target(e));
      made.sides[edge_between(made, a, b)][a < b ? 0 : 1] = number;
    }
    if (t.is_ghost(first)) continue;
    std::array<std::uint32_t, 3> corners{};
    for (HalfEdge k = 0; k < 3; ++k) corners[k] = triangulator.points().label(t.origin(first + k));
    made.triangles.push_back(corners);
    made.face_of.push_back(number);
  }
  return made;
}

}  // namespace plumb
