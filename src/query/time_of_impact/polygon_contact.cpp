// The earliest of what meets the edges and of the body's vertices, each a ball of its reach, where they first touch the
// plane inside of the polygon.  What comes to the inside with more than a vertex reaches over an edge or has a vertex
// there; what is on both sides of the plane from the start meets edges first.
#include "query/time_of_impact/polygon_contact.hpp"

#include <tuple>

#include "arith/exact_number.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/figure_view.hpp"
#include "query/convex/chains.hpp"
#include "query/convex/exact_map.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/time_of_impact/moving_axes.hpp"

namespace plumb::query {
namespace {

/// at + t slope.
struct LinearInTime {
  mpq_class at, slope;
};
Sign sign_at(const Root& t, const LinearInTime& x) {
  return t.sign_of(std::array{exact_number(x.at), exact_number(x.slope)});
}

/// Is a point of the polygon's plane strictly inside?  By the edges that pass beside it, seen along an axis.
bool is_inside_at(const Root& t, const SpannedChains& chains, const Exact3& normal,
                  const std::array<LinearInTime, 3>& p) {
  const std::size_t along = sgn(normal[0]) != 0   ? 0
                            : sgn(normal[1]) != 0 ? 1
                                                  : 2,
                    x = (along + 1) % 3, y = (along + 2) % 3;
  const auto sign_less = [&](const mpq_class& c, std::size_t k) {  // of c - p
    return sign_at(t, {c - p[k].at, -p[k].slope});
  };
  bool odd = false;
  for (std::size_t i = 0; i < chains.vertices.size(); ++i) {
    const Exact3 &a = chains.vertices[i], &b = chains.vertices[chains.next[i]];
    const Sign a_above = sign_less(a[y], y), b_above = sign_less(b[y], y);
    const mpq_class dx = b[x] - a[x], dy = b[y] - a[y];
    const Sign side = sign_at(t, {dx * (p[y].at - a[y]) - dy * (p[x].at - a[x]), dx * p[y].slope - dy * p[x].slope});
    const auto apart = [](Sign u, Sign v) { return u == v && u != Sign::zero; };
    if (side == Sign::zero && !apart(a_above, b_above) && !apart(sign_less(a[x], x), sign_less(b[x], x))) return false;
    if ((a_above == Sign::positive) == (b_above == Sign::positive)) continue;
    if (side == (b_above == Sign::positive ? Sign::positive : Sign::negative)) odd = !odd;
  }
  return odd;
}

/// Lower ones are told.
auto rank(const FirstMeeting& m) {
  return std::tuple(static_cast<int>(m.of_a.kind) + static_cast<int>(m.of_b.kind), m.of_a.kind, m.of_a.index,
                    m.of_b.kind, m.of_b.index);
}

/// The earliest; of equally early ones that of the lowest features.
class EarliestMeeting {
 public:
  void see(FirstMeeting m) {
    if (best_) {
      const auto order = m.time <=> best_->time;
      if (order > 0 || (order == 0 && !(rank(m) < rank(*best_)))) return;
    }
    best_ = std::move(m);
  }
  [[nodiscard]] std::optional<FirstMeeting> best() && { return std::move(best_); }

 private:
  std::optional<FirstMeeting> best_;
};

/// One end of an edge, by the number that the polygon has for it.
struct ChainEdge {
  Segment3 edge;
  std::uint32_t from, to;

  [[nodiscard]] Feature feature(const Feature& of_edge) const {
    if (of_edge.kind != FeatureKind::vertex) return {FeatureKind::edge, from};
    return {FeatureKind::vertex, of_edge.index == 0 ? from : to};
  }
};

/// A polygon under its pose, which moves.
struct MovingPolygon {
  MovingPolygon(std::string_view function, const PosedMotion& m) : pose(m.figure.in_space), by(m.by) {
    static_cast<void>(exact_chains(function, m.figure.figure));  // throws where it is not planar
    chains = chains_of(m.figure.figure);
    with_figure(m.figure.figure, [this](const auto& s) {
      if constexpr (requires { s.outer; }) {
        add_edges(s.outer.vertices);
        for (const auto& hole : s.holes) add_edges(hole.vertices);
      } else if constexpr (requires { s.vertices[0].z; }) {
        add_edges(s.vertices);
      } else if constexpr (requires { s.a.z, s.b, s.c, s.d; }) {
        add_edges(std::array{s.a, s.b, s.c, s.d});
      }
    });
    add_hull();
    if (pose == nullptr) return;
    const ExactMap map = exact_map(*pose);
    for (Exact3& v : chains.vertices) v = image(map, v);
    chains.span = spanning(chains.vertices);
  }
  [[nodiscard]] PosedMotion motion_of(const ChainEdge& e) const { return {{view_of(e.edge), pose}, by}; }

  const Pose* pose;
  const Vector3* by;
  SpannedChains chains;
  std::vector<ChainEdge> edges;
  MovingBody<Running> hull;  // what has no holes and is convex, by its vertices and one normal

 private:
  void add_hull() {
    for (const ChainEdge& e : edges) {
      const PosedMotion edge = motion_of(e);
      hull.vertices.push_back(moving_body<Running>(&edge.figure).vertices[0]);
    }
    if (chains.span.size() < 3 || hull.vertices.size() != chains.vertices.size()) return;
    const auto& v = hull.vertices;
    const Vec3<Running>& from = v[chains.span[0]];
    const Vec3<Running> normal = cross(v[chains.span[1]] - from, v[chains.span[2]] - from);
    hull.faces.push_back({{}, normal, dot(normal, from), {FeatureKind::face, 0}});
  }
  template <class Points>
  void add_edges(const Points& points) {
    if constexpr (std::is_same_v<typename Points::value_type, Point3>) {
      const auto first = static_cast<std::uint32_t>(edges.size()), n = static_cast<std::uint32_t>(points.size());
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = i + 1 == n ? 0 : i + 1;
        edges.push_back({{points[i], points[j]}, first + i, first + j});
      }
    }
  }
};

Exact3 exactly(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Where the ball about a vertex first touches the plane, if that is inside.
void see_face(EarliestMeeting& earliest, const Exact3& center, const Feature& feature, const mpq_class& reach,
              const Exact3& by, const SpannedChains& chains) {
  const Exact3& from = chains.vertices[chains.span[0]];
  const Exact3 normal = cross(chains.vertices[chains.span[1]] - from, chains.vertices[chains.span[2]] - from);
  const mpq_class square = dot(normal, normal), height = dot(normal, center - from), rise = dot(normal, by);
  const mpq_class rest = height * height - reach * reach * square;
  if (sgn(rest) < 0) return;  // across the plane from the start: it meets edges first
  std::array<LinearInTime, 3> foot;
  for (std::size_t k = 0; k < 3; ++k) {
    foot[k] = {center[k] - normal[k] * height / square, by[k] - normal[k] * rise / square};
  }
  const auto look = [&](const Root& t) {
    if (is_inside_at(t, chains, normal, foot)) earliest.see({t, feature, {FeatureKind::face, 0}});
  };
  if (sgn(rest) == 0) return look(Root(0));
  if (sgn(rise) == 0 || sgn(rise) == sgn(height)) return;
  if (sgn(reach) == 0) {
    const mpq_class time = -height / rise;
    if (time <= 1) look(Root(exact_number(time)));
    return;
  }
  const std::array quadratic{exact_number(rest), exact_number(2 * height * rise), exact_number(rise * rise)};
  const auto times = real_roots(quadratic, Rational(0.0), Rational(1.0));
  if (!times.empty()) look(times.front());
}

/// Edges and bodies that overlap meet by their features as well: the polygon does not overlap them.
Relation never_inside(const BodyShape&, const BodyShape&) { return Relation::touching; }

/// While what is around the polygon may meet the body.
TimeWindow window_of(const MovingBody<Running>& body, const Vector3& by, const MovingPolygon& polygon) {
  return time_window(body, polygon.hull, vector_of<Running>(by) - vector_of<Running>(*polygon.by));
}

template <class Shape>
concept IsRound = std::same_as<Shape, Sphere3> || std::same_as<Shape, Capsule3> || std::same_as<Shape, Lozenge3>;
template <class Shape>
concept IsPolygon =
    std::same_as<Shape, Quadrilateral3> || std::same_as<Shape, Polygon3> || std::same_as<Shape, HoledPolygon3>;

/// At the start; where there is no pose, in doubles as long as they tell.
Relation start_relation(std::string_view function, const PosedView& a, const PosedView& b) {
  if (a.in_space != nullptr || b.in_space != nullptr) return relate_posed(function, a, b);
  if (!is_one_of(a.figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge}))
    return relate_polygon(function, a.figure, b.figure);
  return with_figure(a.figure, [&]<class Round>(const Round& round) {
    if constexpr (IsRound<Round>) {
      return with_figure(b.figure, [&]<class Polygon>(const Polygon& polygon) {
        if constexpr (IsPolygon<Polygon>) {
          return relate(round, polygon);
        } else {
          return relate_posed(function, a, b);
        }
      });
    } else {
      return relate_posed(function, a, b);
    }
  });
}

/// Of a polygon that does not overlap the body at the start.
std::optional<FirstMeeting> body_with_polygon(std::string_view function, const PosedMotion& body,
                                              const MovingPolygon& polygon) {
  if (window_of(moving_body<Running>(&body.figure), *body.by, polygon).empty()) return {};
  EarliestMeeting earliest;
  for (const ChainEdge& e : polygon.edges) {
    const PosedMotion edge = polygon.motion_of(e);
    auto m = first_meeting(function, {&body.figure, body.by}, {&edge.figure, edge.by}, never_inside);
    if (m) earliest.see({std::move(m->time), m->of_a, e.feature(m->of_b)});
  }
  if (polygon.chains.span.size() == 3) {
    const auto exact = moving_body<BigDyadic>(&body.figure);
    const Exact3 by = exactly(*body.by) - exactly(*polygon.by);
    for (std::size_t i = 0; i < exact.vertices.size(); ++i) {
      const auto& [x, y, z] = exact.vertices[i];
      see_face(earliest, {gmp_number(x), gmp_number(y), gmp_number(z)}, exact.vertex_features[i],
               gmp_number(exact.reach), by, polygon.chains);
    }
  }
  return std::move(earliest).best();
}

std::optional<FirstMeeting> swapped(std::optional<FirstMeeting> m) {
  if (m) std::swap(m->of_a, m->of_b);
  return m;
}

}  // namespace

std::optional<FirstMeeting> polygon_meeting(std::string_view function, const PosedMotion& a, const PosedMotion& b) {
  require_finite_parts(function, {"a.by", "b.by"}, *a.by, *b.by);
  if (!is_polygon(b.figure.figure)) return swapped(polygon_meeting(function, b, a));
  const MovingPolygon second(function, b);
  const bool both = is_polygon(a.figure.figure);
  std::optional<MovingPolygon> first;
  if (both) first.emplace(function, a);
  if (!both && !check_body(function, "the body", &a.figure)) return {};
  const TimeWindow window = window_of(both ? first->hull : moving_body<Running>(&a.figure), *a.by, second);
  if (window.empty()) return {};
  if (!(window.from > 0) && start_relation(function, a.figure, b.figure) == Relation::overlapping) {
    const Feature inside{FeatureKind::interior, 0};
    return FirstMeeting{Root(0), inside, inside};
  }
  if (!both) return body_with_polygon(function, a, second);
  EarliestMeeting earliest;
  for (const ChainEdge& e : first->edges) {
    auto m = body_with_polygon(function, first->motion_of(e), second);
    if (m) earliest.see({std::move(m->time), e.feature(m->of_a), m->of_b});
  }
  for (const ChainEdge& e : second.edges) {
    auto m = body_with_polygon(function, second.motion_of(e), *first);
    if (m) earliest.see({std::move(m->time), m->of_b, e.feature(m->of_a)});
  }
  return std::move(earliest).best();
}

}  // namespace plumb::query
