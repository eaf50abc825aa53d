#include "query/convex/search.hpp"

#include <algorithm>
#include <vector>

#include "figure/support/gjk_simplex.hpp"
#include "query/body/axis_body.hpp"
#include "query/convex/round_vertices.hpp"

namespace plumb::query {
namespace {

using namespace axes;
using arith::Plain;
using VertexList = std::vector<Vertex>;

constexpr int most_search_steps = 48;

/// Of a line or ray, a part that goes beyond all others along an axis: it meets their hull where the whole does.
/// Nothing where doubles do not tell.
std::optional<VertexList> cut_to(const VertexList& others, const AxisBody<Running>& straight) {
  const Vertex &from = straight.points[0], &along = straight.edges[0];
  const std::array parts{&Vertex::x, &Vertex::y, &Vertex::z};
  const auto axis =
      *std::ranges::max_element(parts, {}, [&](Running Vertex::*part) { return magnitude_of((along.*part).value); });
  const double least = Running::size((along.*axis).value);
  double reach = 0;
  for (const Vertex& v : others) reach = std::max(reach, Running::size(((v - from).*axis).upper()) * 2);
  for (const Vertex& v : others) reach = std::max(reach, Running::size(((v - from).*axis).lower()) * 2);
  const double t = (reach + least) / least;
  const Vertex step = along * Running(t);
  VertexList ends{straight.ends[0] == EdgeEnd::both ? from - step : from, from + step};
  const bool forward = (along.*axis).value > 0;
  for (const Vertex& v : others) {
    const Running above = (ends[1] - v).*axis, below = (v - ends[0]).*axis;
    const auto beyond = [forward](const Running& x) { return forward ? x.lower() > 0 : x.upper() < 0; };
    if (!beyond(above) || (straight.ends[0] == EdgeEnd::both && !beyond(below))) return {};
  }
  return ends;
}

/// A polyhedron, climbed from vertex to vertex, or the vertices of a small figure.
struct Hull {
  const ConvexPolyhedron3* solid = nullptr;
  VertexList vertices = {};
  std::uint32_t at = 0;  // the one that was found last

  [[nodiscard]] Vertex vertex(std::size_t i) const {
    return solid != nullptr ? query::vertex(solid->mesh.vertices[i]) : vertices[i];
  }
};

Hull hull_of(const ConvexPolyhedron3& solid) { return {&solid, {}, solid.mesh.corners[0]}; }

/// Nothing for figures that go on in two directions.
std::optional<Hull> hull_of(const FlatView& v, const ConvexPolyhedron3& other) {
  return with_shape(v, [&](const auto& s) -> std::optional<Hull> {
    using Shape = std::remove_cvref_t<decltype(s)>;
    if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
      return hull_of(s);
    } else if constexpr (has_body<Shape>) {
      const auto body = axis_body_of<Running>(s, {0, 0, 0});
      if (body.edge_count > 0 && body.ends[0] != EdgeEnd::none) {
        if (body.edge_count > 1) return {};
        auto part = cut_to(query::vertices(other), body);
        return part ? std::optional(Hull{nullptr, std::move(*part)}) : std::nullopt;
      }
      return Hull{nullptr, {body.points.begin(), body.points.begin() + static_cast<std::ptrdiff_t>(body.point_count)}};
    } else {
      return {};
    }
  });
}

/// A vertex that no other one is seen beyond, along way times the direction.
Vertex farthest(Hull& hull, const Plain& along, double way) {
  const Plain n = along * way;
  if (hull.solid == nullptr) {
    for (std::uint32_t i = 0; i < hull.vertices.size(); ++i) {
      if (arith::dot(plain(hull.vertices[i]), n) > arith::dot(plain(hull.vertices[hull.at]), n)) hull.at = i;
    }
    return hull.vertices[hull.at];
  }
  const std::vector<Point3>& points = hull.solid->mesh.vertices;
  const auto reach = [&](std::uint32_t i) { return points[i].x * n.x + points[i].y * n.y + points[i].z * n.z; };
  double most = reach(hull.at);
  for (bool better = true; better;) {  // ends, for `most` grows with each vertex
    better = false;
    for (const std::uint32_t i : hull.solid->neighbors_of(hull.at)) {
      const double r = reach(i);
      if (r > most) most = r, hull.at = i, better = true;
    }
  }
  return vertex(points[hull.at]);
}

/// Nothing of the polyhedron is below these: some vertices that doubles do not tell from one another along n, all of
/// whose other neighbors are above.  From the first of them a way down to the lowest vertex cannot leave them.
constexpr std::size_t most_level = 16;
struct Level {
  std::array<std::uint32_t, most_level> vertices;
  std::size_t count = 0;
};
std::optional<Level> lowest_of(const ConvexPolyhedron3& solid, std::uint32_t from, const Vertex& n) {
  const auto vertex = [&](std::uint32_t i) { return query::vertex(solid.mesh.vertices[i]); };
  const Vertex lowest = vertex(from);
  Level level{{from}, 1};
  for (std::size_t k = 0; k < level.count; ++k) {
    for (const std::uint32_t i : solid.neighbors_of(level.vertices[k])) {
      if (arith::dot(vertex(i) - lowest, n).lower() > 0) continue;
      const auto end = level.vertices.begin() + static_cast<std::ptrdiff_t>(level.count);
      if (std::find(level.vertices.begin(), end, i) != end) continue;
      if (level.count == most_level) return {};
      level.vertices[level.count++] = i;
    }
  }
  return level;
}

/// A number that nothing of the hull is below along n; infinite or NaN where doubles do not tell.
double least_along(const Hull& hull, const Vertex& n) {
  double least = std::numeric_limits<double>::infinity(), widths = 0;
  const auto look = [&](const Vertex& v) {
    const Running at = arith::dot(v, n);
    widths += at.upper() - at.lower();
    least = std::min(least, at.lower());
  };
  if (hull.solid == nullptr) {
    for (const Vertex& v : hull.vertices) look(v);
  } else if (const auto level = lowest_of(*hull.solid, hull.at, n)) {
    for (std::size_t k = 0; k < level->count; ++k) look(hull.vertex(level->vertices[k]));
  } else {
    for (const Point3& p : hull.solid->mesh.vertices) look(vertex(p));
  }
  return least + (widths - widths);
}

/// Are all of a strictly farther along than all of b?  Both have been asked for their farthest vertices that way.
bool proves_apart(const Hull& a, const Hull& b, const Plain& along) {
  const Vertex n = arith::vec<Running>(along);
  const Vertex back = arith::vec<Running>(along * -1);
  const Running gap = Running(least_along(a, n)) + Running(least_along(b, back));
  return gap.lower() > 0 && gap.value < std::numeric_limits<double>::infinity();
}

/// Of differences of vertices.
using VertexSimplex = figure::gjk::Simplex<Vertex>;

/// Is the origin strictly inside of the tetrahedron?
bool proves_overlap(const std::array<Vertex, 4>& s) {
  return figure::gjk::is_around_origin([&](std::size_t i, std::size_t j, std::size_t k) {
    const auto sign = arith::dot(s[i], arith::cross(s[j], s[k])).sign();
    return sign.certain() ? sign.value() : Sign::zero;
  });
}

bool same(const Plain& a, const Plain& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

std::optional<Relation> relate_hulls(Hull& a, Hull& b) {
  constexpr double nothing = 0x1p-90;  // a guess: of the square of a length that is lost in the differences' roundings
  const Vertex first = a.vertex(a.at) - b.vertex(b.at);
  VertexSimplex simplex({first, plain(first)});
  Plain at = plain(first);
  double largest = arith::dot(at, at), square = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_search_steps; ++step) {
    const Vertex next = farthest(a, at, -1) - farthest(b, at, 1);
    const Plain reached = plain(next);
    if (arith::dot(reached, at) > 0 && proves_apart(a, b, at)) return Relation::disjoint;
    largest = std::max(largest, arith::dot(reached, reached));
    const auto& c = simplex.corners();
    if (std::ranges::any_of(c, [&](const VertexSimplex::Corner& corner) { return same(corner.at, reached); }))
      return {};
    if (c.size() == 3 && proves_overlap({c[0].ends, c[1].ends, c[2].ends, next})) return Relation::overlapping;
    simplex.add({next, reached});
    if (simplex.is_full()) return {};
    at = simplex.nearest();
    const double last = std::exchange(square, arith::dot(at, at));
    if (!(square < last) || square < largest * nothing) return {};
  }
  return {};
}

}  // namespace

std::optional<Relation> relate_by_search(const FlatView& a, const FlatView& b) {
  const bool a_first = a.kind == FigureKind::convex_polyhedron;
  const auto& solid = *static_cast<const ConvexPolyhedron3*>((a_first ? a : b).shape);
  Hull first = hull_of(solid);
  auto second = hull_of(a_first ? b : a, solid);
  if (!second) return {};
  return relate_hulls(first, *second);
}

}  // namespace plumb::query
