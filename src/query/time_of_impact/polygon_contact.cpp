// The earliest of what meets the edges and of the body's vertices, each a ball of its reach, where they first touch the
// plane inside of the polygon.  What comes to the inside with more than a vertex reaches over an edge or has a vertex
// there; what is on both sides of the plane from the start meets edges first.  At the start an edge that bounds no inside
// may be across the other figure, where no vertex is and no two edges meet: relate tells that, and then which it is.
#include "query/time_of_impact/polygon_contact.hpp"

#include "arith/exact_number.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/chain_edges.hpp"
#include "query/body/figure_input.hpp"
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

/// Edges and bodies that overlap meet by their features as well: the polygon does not overlap them.
Relation never_inside(const BodyMotion&, const BodyMotion&) { return Relation::touching; }

/// Of a body and a polygon, the earliest; of equally early ones that of the lowest features, of the polygon first where
/// that was given first.
class EarliestMeeting {
 public:
  explicit EarliestMeeting(bool turned) : turned_(turned) {}

  void see(FirstMeeting m) {
    if (best_) {
      const auto order = m.time <=> best_->time;
      if (order > 0 || (order == 0 && !is_lower(m, *best_))) return;
    }
    best_ = std::move(m);
  }
  void see_edge(std::string_view function, const BodyMotion& body, const BodyMotion& edge, const ChainEdge& of) {
    auto m =
        turned_ ? first_meeting(function, edge, body, never_inside) : first_meeting(function, body, edge, never_inside);
    if (!m) return;
    if (turned_) std::swap(m->of_a, m->of_b);
    m->of_b = of.feature(m->of_b);
    see(std::move(*m));
  }
  [[nodiscard]] bool is_at_start() const { return best_ && best_->time == Rational(0); }
  /// With the features in the order of the figures.
  [[nodiscard]] std::optional<FirstMeeting> best() && {
    if (best_ && turned_) std::swap(best_->of_a, best_->of_b);
    return std::move(best_);
  }

 private:
  [[nodiscard]] bool is_lower(const FirstMeeting& m, const FirstMeeting& n) const {
    return turned_ ? rank(m.of_b, m.of_a) < rank(n.of_b, n.of_a) : rank(m.of_a, m.of_b) < rank(n.of_a, n.of_b);
  }

  bool turned_;
  std::optional<FirstMeeting> best_;
};

/// A polygon under its pose, which moves.
struct MovingPolygon {
  MovingPolygon(std::string_view function, const PosedMotion& m)
      : pose(m.figure.pose), by(m.by), figure_(m.figure.figure) {
    with_figure(figure_, [this]<class Shape>(const Shape& s) {
      if constexpr (is_one_of(figure_kind<Shape>, polygon_kinds)) edges = chain_edges(s);
    });
    plane_ = plane_of_points(edges.size(), [this](std::size_t i) -> const Point3& { return edges[i].shape.a; });
    require_planar(function, spoken(figure_), plane_);
    add_hull();
  }
  [[nodiscard]] PosedMotion motion_of(const ChainEdge& e) const { return {{view_of(e.shape), pose}, by}; }
  [[nodiscard]] bool has_inside() const { return pose.stands() ? plane_.dimension == 2 : chains().span.size() == 3; }
  /// In rationals, made when it is asked.
  [[nodiscard]] const SpannedChains& chains() const {
    if (!chains_) {
      chains_ = chains_of(figure_);
      if (!pose.stands()) {
        const ExactMap map = exact_map(pose);
        for (Exact3& v : chains_->vertices) v = image(map, v);
        chains_->span = spanning(chains_->vertices);
      }
    }
    return *chains_;
  }
  /// Of its plane, where it has one.
  [[nodiscard]] Exact3 normal() const {
    const auto& [vertices, next, span] = chains();
    return cross(vertices[span[1]] - vertices[span[0]], vertices[span[2]] - vertices[span[0]]);
  }
  /// Is the ball about the body's vertex on both sides of the plane from the start?  It meets edges first then.
  [[nodiscard]] bool is_surely_across(const MovingBody<Running>& body, std::size_t vertex) const {
    if (hull.faces.empty() || hull.has_weight || body.has_weight) return false;
    const auto& [corners, normal, offset, feature] = hull.faces[0];
    const Running height = dot(normal, body.vertices[vertex]) - offset;
    return (height * height - body.reach * body.reach * dot(normal, normal)).upper() < 0;
  }

  AnyPoseView pose;
  Vector3 by;
  std::vector<ChainEdge> edges;
  MovingBody<Running> hull;  // what has no holes and is convex, by its vertices and one normal

 private:
  void add_hull() {
    for (const ChainEdge& e : edges) {
      const PosedMotion edge = motion_of(e);
      const auto of_edge = moving_body<Running>(edge.figure);
      hull.vertices.push_back(of_edge.vertices[0]);
      hull.weight = of_edge.weight, hull.has_weight = of_edge.has_weight;
    }
    if (plane_.dimension < 2) return;
    const auto& v = hull.vertices;
    const Vec3<Running>& from = v[plane_.span[0]];
    const Vec3<Running> normal = cross(v[plane_.span[1]] - from, v[plane_.span[2]] - from);
    hull.faces.push_back({{}, normal, dot(normal, from), {FeatureKind::face, 0}});
  }

  FigureView figure_;
  PlaneOfPoints plane_;
  mutable std::optional<SpannedChains> chains_;
};

Exact3 exactly(const Vector3& v) { return {v.x, v.y, v.z}; }
Exact3 exactly(const Vec3<BigDyadic>& v) { return {gmp_number(v.x), gmp_number(v.y), gmp_number(v.z)}; }

mpq_class over_weight(const BigDyadic& x, const MovingBody<BigDyadic>& body) {
  return body.has_weight ? mpq_class(gmp_number(x) / gmp_number(body.weight)) : gmp_number(x);
}
Exact3 exact_vertex(const MovingBody<BigDyadic>& body, std::size_t i) {
  const Vec3<BigDyadic>& v = body.vertices[i];
  return {over_weight(v.x, body), over_weight(v.y, body), over_weight(v.z, body)};
}

/// Where the ball about a vertex first touches the plane, if that is inside.
void see_face(EarliestMeeting& earliest, const Exact3& center, const Feature& feature, const mpq_class& reach,
              const Exact3& by, const MovingPolygon& polygon) {
  const SpannedChains& chains = polygon.chains();
  const Exact3 &from = chains.vertices[chains.span[0]], normal = polygon.normal();
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

/// While what is around the polygon may meet the body.
TimeWindow window_of(MovingBody<Running> body, const Vector3& by, const MovingPolygon& polygon) {
  MovingBody<Running> hull = polygon.hull;
  const Vec3<Running> velocity = vector_of<Running>(by) - vector_of<Running>(polygon.by);
  const Vec3<Running> seen = bring_to_one_weight(body, hull, velocity);
  return time_window(body, hull, seen);
}

template <class Shape>
concept IsRound = std::same_as<Shape, Sphere3> || std::same_as<Shape, Capsule3> || std::same_as<Shape, Lozenge3>;
template <class Shape>
concept IsPolygon =
    std::same_as<Shape, Quadrilateral3> || std::same_as<Shape, Polygon3> || std::same_as<Shape, HoledPolygon3>;

/// At the start; where there is no pose, in doubles as long as they tell.
Relation start_relation(std::string_view function, const PosedView& a, const PosedView& b) {
  if (!a.pose.stands() || !b.pose.stands()) return relate_posed(function, a, b);
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
void see_body(EarliestMeeting& earliest, std::string_view function, const PosedMotion& body,
              const MovingPolygon& polygon) {
  const auto near = moving_body<Running>(body.figure);
  if (window_of(near, body.by, polygon).empty()) return;
  for (const ChainEdge& e : polygon.edges) {
    const PosedMotion edge = polygon.motion_of(e);
    earliest.see_edge(function, {body.figure, &body.by}, {edge.figure, &edge.by}, e);
  }
  if (!polygon.has_inside()) return;
  std::optional<MovingBody<BigDyadic>> exact;
  for (std::size_t i = 0; i < near.vertices.size(); ++i) {
    if (polygon.is_surely_across(near, i)) continue;
    if (!exact) exact = moving_body<BigDyadic>(body.figure);
    see_face(earliest, exact_vertex(*exact, i), near.vertex_features[i], over_weight(exact->reach, *exact),
             exactly(body.by) - exactly(polygon.by), polygon);
  }
}

/// Finds where an edge goes from one side of a plane to the other.
std::optional<Exact3> crossing(const ChainEdge& edge, const SpannedChains& of, const Exact3& normal,
                               const mpq_class& offset) {
  const Exact3 &from = of.vertices[edge.from], &to = of.vertices[edge.to];
  const mpq_class above = dot(normal, from) - offset, below = dot(normal, to) - offset;
  if (sgn(above) * sgn(below) >= 0) return {};
  return from + mpq_class(above / (above - below)) * (to - from);
}

/// Is a point of a face's plane in the face?
bool face_holds(const MovingBody<BigDyadic>& body, const MovingBody<BigDyadic>::Face& face, const Exact3& p) {
  const Exact3 normal = exactly(face.normal);
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Exact3 from = exact_vertex(body, face.corners[i]),
                 to = exact_vertex(body, face.corners[(i + 1) % face.corners.size()]);
    if (sgn(dot(cross(normal, to - from), p - from)) < 0) return false;
  }
  return true;
}

/// What meets at the start where neither vertices nor two edges do.  An edge beside which the polygon has its inside
/// overlaps what it goes through; one that bounds no inside goes through a face, or stays inside.
void see_pierced(EarliestMeeting& earliest, std::string_view function, const PosedMotion& of_body,
                 const MovingPolygon& polygon) {
  const auto body = moving_body<BigDyadic>(of_body.figure);
  for (const auto& face : body.faces) {
    const Exact3 normal = exactly(face.normal);
    for (const ChainEdge& e : polygon.edges) {
      const auto at = crossing(e, polygon.chains(), normal, over_weight(face.offset, body));
      if (at && face_holds(body, face, *at)) earliest.see({Root(0), face.feature, e.whole});
    }
  }
  for (const ChainEdge& e : polygon.edges) {
    const PosedView corner{view_of(e.shape.a), polygon.pose};
    if (relate_posed(function, of_body.figure, corner) == Relation::overlapping)
      earliest.see({Root(0), {FeatureKind::interior, 0}, {FeatureKind::vertex, e.from}});
  }
}
/// Calls see(edge) for each that goes through the other's inside.
template <class See>
void see_pierced(const MovingPolygon& edges, const MovingPolygon& inside, See see) {
  if (!inside.has_inside()) return;
  const Exact3 normal = inside.normal();
  const mpq_class offset = dot(normal, inside.chains().vertices[0]);
  for (const ChainEdge& e : edges.edges) {
    const auto at = crossing(e, edges.chains(), normal, offset);
    if (at && holds_inside(inside.chains(), *at)) see(e);
  }
}

/// Two in motion, the second a polygon.
class PolygonPair {
 public:
  PolygonPair(std::string_view function, const PosedMotion& a, const PosedMotion& b, bool turned)
      : function_(function), a_(a), second_(function, b), turned_(turned) {
    if (is_polygon(a.figure.figure)) {
      first_.emplace(function, a);
    } else if (!check_body(function, "the body", a.figure)) {
      return;
    }
    const TimeWindow window = window_of(first_ ? first_->hull : moving_body<Running>(a.figure), a.by, second_);
    may_meet_ = !window.empty();
    if (may_meet_ && !(window.from > 0)) start_ = start_relation(function, a.figure, b.figure);
  }

  [[nodiscard]] std::optional<Root> time() const {
    if (start_ != Relation::disjoint) return Root(0);
    auto m = by_features().best();
    return m ? std::optional(std::move(m->time)) : std::nullopt;
  }
  [[nodiscard]] std::optional<FirstMeeting> first() const {
    const Feature inside{FeatureKind::interior, 0};
    if (start_ == Relation::overlapping) return FirstMeeting{Root(0), inside, inside};
    EarliestMeeting earliest = by_features();
    if (start_ == Relation::touching && !earliest.is_at_start()) {
      const Feature face{FeatureKind::face, 0};
      if (!first_) {
        see_pierced(earliest, function_, a_, second_);
      } else {
        see_pierced(*first_, second_, [&](const ChainEdge& e) { earliest.see({Root(0), e.whole, face}); });
        see_pierced(second_, *first_, [&](const ChainEdge& e) { earliest.see({Root(0), face, e.whole}); });
      }
    }
    return std::move(earliest).best();
  }

 private:
  /// By vertices, edges, and vertices in a face.
  [[nodiscard]] EarliestMeeting by_features() const {
    EarliestMeeting earliest(turned_);
    if (!may_meet_) return earliest;
    if (!first_) {
      see_body(earliest, function_, a_, second_);
      return earliest;
    }
    for (const ChainEdge& e : first_->edges) {
      EarliestMeeting of_edge(false);
      see_body(of_edge, function_, first_->motion_of(e), second_);
      if (auto m = std::move(of_edge).best()) earliest.see({std::move(m->time), e.feature(m->of_a), m->of_b});
    }
    for (const ChainEdge& e : second_.edges) {
      EarliestMeeting of_edge(true);
      see_body(of_edge, function_, second_.motion_of(e), *first_);
      if (auto m = std::move(of_edge).best()) earliest.see({std::move(m->time), m->of_a, e.feature(m->of_b)});
    }
    return earliest;
  }

  std::string_view function_;
  const PosedMotion& a_;
  MovingPolygon second_;
  std::optional<MovingPolygon> first_;  // of two polygons
  bool turned_;                         // the polygon was given first
  bool may_meet_ = false;
  Relation start_ = Relation::disjoint;
};

/// Calls f with the pair, the polygon second.
template <class F>
auto with_pair(std::string_view function, const PosedMotion& a, const PosedMotion& b, F f) {
  require_finite_parts(function, {"a.by", "b.by"}, a.by, b.by);
  const bool turned = !is_polygon(b.figure.figure);
  return f(turned ? PolygonPair(function, b, a, true) : PolygonPair(function, a, b, false));
}

}  // namespace

std::optional<Root> polygon_meeting_time(std::string_view function, const PosedMotion& a, const PosedMotion& b) {
  return with_pair(function, a, b, [](const PolygonPair& pair) { return pair.time(); });
}

std::optional<FirstMeeting> polygon_meeting(std::string_view function, const PosedMotion& a, const PosedMotion& b) {
  return with_pair(function, a, b, [](const PolygonPair& pair) { return pair.first(); });
}

}  // namespace plumb::query
