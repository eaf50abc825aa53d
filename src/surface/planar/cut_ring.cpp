#include "surface/planar/cut_ring.hpp"

#include <algorithm>
#include <numeric>

#include "surface/planar/passed_stations.hpp"
#include "surface/planar/ring_edges.hpp"

namespace plumb::surface {
namespace {

// Is each edge of the path one of the triangulation, which no other one covers?
bool is_simple(const Triangulator<GivenPoints>& made, std::uint32_t corners) {
  std::size_t covered = 0;
  const Triangles& t = made.triangles();
  for (HalfEdge first = 0; first < t.end(); first += 4) {
    for (HalfEdge e = first; e < first + 3; ++e) {
      if (t.mark(e).weight <= 0) continue;
      const std::uint32_t i = t.mark(e).constraint, next = i + 1 == corners ? 0 : i + 1;
      if (made.points().label(t.origin(e)) != i || made.points().label(t.target(e)) != next) return false;
      ++covered;
    }
  }
  return covered == corners;
}

// Returns 1 or -1 if the path winds around nothing but once in that way, else 0.
std::int32_t only_winding(const Triangulator<GivenPoints>& made, std::span<const std::int32_t> windings) {
  const Triangles& t = made.triangles();
  std::int32_t only = 0;
  for (HalfEdge first = 0; first < t.end(); first += 4) {
    const std::int32_t w = windings[first / 4];
    if (w == 0 || w == only) continue;
    if (only != 0 || w < -1 || w > 1) return 0;
    only = w;
  }
  return only;
}

struct WoundRing {
  Triangulator<GivenPoints> made;
  std::vector<std::int32_t> windings;
  std::int32_t inside;  // 1 or -1
};

// Nothing where edges cross, or the path winds around nothing, or not once in one way.
std::optional<WoundRing> wind(std::span<const Point2> ring) {
  WoundRing wound{triangulator_of(ring), {}, 0};
  const auto edges = ring_edges(std::array{0U, static_cast<std::uint32_t>(ring.size())});
  if (wound.made.triangles().end() == 0 || wound.made.constrain(edges)) return {};
  wound.windings = wound.made.windings();
  wound.inside = only_winding(wound.made, wound.windings);
  if (wound.inside == 0) return {};
  return wound;
}

}  // namespace

bool cut_ring(std::span<const Point2> ring, std::vector<std::array<std::uint32_t, 3>>& out) {
  const auto corners = static_cast<std::uint32_t>(ring.size());
  const std::optional<WoundRing> wound = wind(ring);
  if (!wound) return false;
  const Triangulator<GivenPoints>& made = wound->made;
  const std::vector<std::int32_t>& windings = wound->windings;
  const std::int32_t inside = wound->inside;
  const Triangles& t = made.triangles();
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (inside > 0)
      out.push_back({a, b, c});
    else
      out.push_back({a, c, b});
  };
  if (is_simple(made, corners)) {
    for (HalfEdge e = 0; e < t.end(); e += 4) {
      if (windings[e / 4] == 0) continue;
      add(made.points().label(t.origin(e)), made.points().label(t.origin(e + 1)), made.points().label(t.origin(e + 2)));
    }
    return true;
  }
  RingStations path(made, corners, inside < 0);
  if (!path.divide(windings, inside)) return false;
  std::vector<StationTriangle> triangles = path.flat();
  for (HalfEdge e = 0; e < t.end(); e += 4)
    if (windings[e / 4] != 0) triangles.push_back({path.station_at(e), path.station_at(e + 1), path.station_at(e + 2)});
  // That the rings of the faces hang together as a tree is a matter of their number, and so of the triangles'.
  if (triangles.size() + 2 != path.stations().size()) return false;
  if (!PassedStations(made.points(), path.stations(), triangles).take_out()) return false;
  if (triangles.size() + 2 != corners) return false;
  // A path that crosses itself at a vertex is noticed here: what was cut anew is not all seen from the edge.
  for (const auto& [a, b, c] : triangles) {
    const auto vertex = [&](std::uint32_t s) { return path.stations()[s].vertex; };
    if (made.points().orient(vertex(a), vertex(b), vertex(c)) == Sign::negative) return false;
  }
  for (const auto& [a, b, c] : triangles)
    add(path.stations()[a].corner, path.stations()[b].corner, path.stations()[c].corner);
  return true;
}

std::optional<Sign> turn_of_simple_ring(std::span<const Point2> ring) {
  const std::optional<WoundRing> wound = wind(ring);
  if (!wound || !is_simple(wound->made, static_cast<std::uint32_t>(ring.size()))) return {};
  return wound->inside > 0 ? Sign::positive : Sign::negative;
}

}  // namespace plumb::surface
