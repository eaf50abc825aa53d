// Balls, capsules and lozenges against quadrilaterals and polygons, with holes or without.
#include "arith/certain.hpp"
#include "arith/running_error.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/chain_edges.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/overlap/odd_edges.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb {
namespace query {
namespace {

template <class T>
using Vec = arith::Vec<T>;

/// Around a parallelogram: each is joined to the next, the last to the first.
template <class T, class Round>
std::vector<Vec<T>> core_points(const Round& round) {
  std::vector<Vec<T>> points;
  for_each_corner<T>(round, [&](const Vec<T>& p) { points.push_back(p); });
  if (points.size() == 4) std::swap(points[2], points[3]);
  return points;
}

/// The inside of the region of edges in the plane of three points, against what is near to some points and to the
/// segments from each to the next.  What lies nearest to an edge is the edge's; of a parallelogram the inside is
/// nearest only where its corners are as near, or where edges of one of both cross the other.
template <class T>
class Inside {
 public:
  Inside(std::span<const Segment3> edges, const Point3& a, const Point3& b, const Point3& c)
      : edges_(edges), from_(arith::vec<T>(a)), up_(arith::vec<T>(b) - from_) {
    normal_ = arith::cross(up_, arith::vec<T>(c) - from_);
  }

  /// Nothing where a sign is not certain.
  template <class Round>
  std::optional<Relation> relation(const Round& round) {
    const std::vector<Vec<T>> points = core_points<T>(round);
    const T radius = T(round.radius), reach = radius * radius * arith::dot(normal_, normal_);
    Relation all = Relation::disjoint;
    std::vector<T> heights;
    for (const Vec<T>& p : points) {
      heights.push_back(arith::dot(normal_, p - from_));
      const Sign gap = ask_(heights.back() * heights.back() - reach);
      if (gap == Sign::positive || !holds(p, T(1.0))) continue;
      all = std::max(all, gap == Sign::negative ? Relation::overlapping : Relation::touching);
    }
    for (std::size_t i = 0; i < points.size() && all != Relation::overlapping; ++i) {
      const std::size_t j = (i + 1) % points.size();
      const Sign s = ask_(heights[i]), e = ask_(heights[j]);
      if (s * e == Sign::negative) {  // the plane is met at points[i] + (points[j] - points[i]) part / whole
        const T zero = T(0.0), fall = heights[i] - heights[j];
        const bool falls = s == Sign::positive;
        const T whole = falls ? fall : zero - fall, part = falls ? heights[i] : zero - heights[i];
        if (holds(points[i] * whole + (points[j] - points[i]) * part, whole)) all = Relation::overlapping;
      }
    }
    if (!ask_.certain()) return {};
    return all;
  }

 private:
  /// Is p / scale, seen along the normal, in the region?  If it is on an edge, then whether what is next to it on one
  /// side is: edges are counted that cross the line upward from p where they are strictly to one side of it.
  bool holds(const Vec<T>& p, const T& scale) {
    bool odd = false;
    for (const Segment3& edge : edges_) {
      const Vec<T> a = arith::vec<T>(edge.a) * scale - p, b = arith::vec<T>(edge.b) * scale - p;
      const bool from_below = ask_(arith::dot(a, up_)) == Sign::negative;
      const bool to_below = ask_(arith::dot(b, up_)) == Sign::negative;
      if (from_below == to_below) continue;
      const Sign side = ask_(arith::dot(normal_, arith::cross(a, b)));
      odd ^= side == (from_below ? Sign::positive : Sign::negative);
    }
    return odd;
  }

  std::span<const Segment3> edges_;
  Vec<T> from_, up_, normal_;
  CertainSigns ask_;
};

template <class Polygon>
std::vector<Segment3> edges_of(const Polygon& polygon) {
  std::vector<Segment3> edges;
  for (const ChainEdge& e : chain_edges(polygon)) edges.push_back(e.shape);
  return edges;
}

/// The plane of the chains, with three corners that span it.
PlaneOfPoints plane_of(const std::vector<Segment3>& edges, std::string_view function, std::string_view name) {
  const PlaneOfPoints plane = plane_of_points(edges.size(), [&](std::size_t i) -> const Point3& { return edges[i].a; });
  require_planar(function, name, plane);
  return plane;
}

template <class Round>
Relation relate_inside(std::span<const Segment3> edges, const std::array<Point3, 3>& span, const Round& round) {
  if (const auto r = Inside<Running>(edges, span[0], span[1], span[2]).relation(round)) return *r;
  return *Inside<BigDyadic>(edges, span[0], span[1], span[2]).relation(round);
}

/// Does no other edge cover a part of this one?
bool is_alone(std::span<const Segment3> edges, std::size_t i) {
  const auto& [a, b] = edges[i];
  for (std::size_t j = 0; j < edges.size(); ++j) {
    const auto& [p, q] = edges[j];
    if (j != i && p != q && collinear(a, b, p) && collinear(a, b, q) &&
        relate(flat_set(edges[i]), flat_set(edges[j])) == Relation::overlapping)
      return false;
  }
  return true;
}

template <class Round>
Relation relate_edges(const std::vector<Segment3>& edges, const Round& round, std::string_view function,
                      std::string_view name) {
  const PlaneOfPoints plane = plane_of(edges, function, name);
  const std::array<Point3, 3> span{edges[plane.span[0]].a, edges[plane.span[1]].a, edges[plane.span[2]].a};
  Relation all = Relation::disjoint;
  if (plane.dimension == 2) {
    all = relate_inside(edges, span, round);
    if (all == Relation::overlapping) return all;
  }
  bool covered = false;  // is near to an edge that others cover too?
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Segment3& edge = edges[i];
    const Relation r = relate(edge, round);
    all = std::max(all, std::min(r, Relation::touching));
    if (r != Relation::overlapping) continue;
    // On a line the edges are the inside, and a place is its own.
    if (plane.dimension < 2 && (plane.dimension == 0 || edge.a != edge.b)) return Relation::overlapping;
    if (edge.a == edge.b || plane.dimension < 2) continue;
    if (is_alone(edges, i)) return Relation::overlapping;
    covered = true;
  }
  if (!covered) return all;
  const std::vector<Segment3> odd = odd_edges(edges);
  if (relate_inside(odd, span, round) == Relation::overlapping) return Relation::overlapping;
  for (const Segment3& edge : odd) {
    if (relate(edge, round) == Relation::overlapping) return Relation::overlapping;
  }
  return all;
}

template <class Polygon, class Round>
Relation relate_round_polygon(const Polygon& a, const Round& b, Question question) {
  require_figures(question, a, b);
  if (b.radius == 0) return relate_convex(name_of(question), view_of(a), core_of(b));
  return relate_edges(edges_of(a), b, name_of(question), spoken(view_of(a)));
}

}  // namespace

PLUMB_PAIR_ANSWERS_TO(Sphere3, relate_round_polygon, Quadrilateral3, Polygon3, HoledPolygon3)
PLUMB_PAIR_ANSWERS_TO(Capsule3, relate_round_polygon, Quadrilateral3, Polygon3, HoledPolygon3)
PLUMB_PAIR_ANSWERS_TO(Lozenge3, relate_round_polygon, Quadrilateral3, Polygon3, HoledPolygon3)

}  // namespace query
}  // namespace plumb
