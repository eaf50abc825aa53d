#include "plumb/query/translating_contact.hpp"

#include <algorithm>
#include <tuple>

#include "figure/finite_parts.hpp"
#include "query/flat_set.hpp"
#include "query/meeting_time.hpp"

namespace plumb {
namespace query {
namespace {

struct Motion {
  BodyShape shape;
  const Vector3* by;
};

struct Meeting {
  std::optional<Root> time;  // nothing: never
  Feature a, b;
};

/// Two bodies, and how the first moves, seen from the second.
template <class T>
struct Pair {
  Pair(const Motion& of_a, const Motion& of_b)
      : a(body<T>(of_a.shape)), b(body<T>(of_b.shape)), velocity(vector_of<T>(*of_a.by) - vector_of<T>(*of_b.by)) {}

  [[nodiscard]] auto condition_of(PairIndex pair) const { return condition(a, b, velocity, pair); }
  [[nodiscard]] Feature feature_of_a(PairIndex pair) const {
    if (pair.kind == FeaturePair::edge_vertex || pair.kind == FeaturePair::edge_edge) return a.edges[pair.a].feature;
    return pair.kind == FeaturePair::face_vertex ? a.faces[pair.a].feature : a.vertex_features[pair.a];
  }
  [[nodiscard]] Feature feature_of_b(PairIndex pair) const {
    if (pair.kind == FeaturePair::vertex_edge || pair.kind == FeaturePair::edge_edge) return b.edges[pair.b].feature;
    return pair.kind == FeaturePair::vertex_face ? b.faces[pair.b].feature : b.vertex_features[pair.b];
  }

  Body<T> a, b;
  Vec3<T> velocity;
};

/// Two features that may meet, no earlier than at this time.
struct Candidate {
  PairIndex pair;
  double earliest;
};

/// The pairs of features that may meet, by their earliest times.
std::vector<Candidate> candidates(const Pair<Interval>& pair) {
  const auto& [a, b, velocity] = pair;
  std::vector<Candidate> found;
  const auto ask = [&](FeaturePair kind, std::size_t of_a, std::size_t of_b) {
    for (std::uint32_t i = 0; i < of_a; ++i) {
      for (std::uint32_t j = 0; j < of_b; ++j) {
        const auto c = condition(a, b, velocity, {kind, i, j});
        if (!c) continue;
        if (const double t = earliest(*c); t <= 1) found.push_back({{kind, i, j}, t});
      }
    }
  };
  ask(FeaturePair::vertex_vertex, a.vertices.size(), b.vertices.size());
  ask(FeaturePair::vertex_edge, a.vertices.size(), b.edges.size());
  ask(FeaturePair::edge_vertex, a.edges.size(), b.vertices.size());
  ask(FeaturePair::edge_edge, a.edges.size(), b.edges.size());
  ask(FeaturePair::vertex_face, a.vertices.size(), b.faces.size());
  ask(FeaturePair::face_vertex, a.faces.size(), b.vertices.size());
  std::ranges::stable_sort(found, {}, &Candidate::earliest);
  return found;
}

/// The first time at which two features meet, and which.
Meeting first_of(const std::vector<Candidate>& found, const Pair<BigDyadic>& exact) {
  Meeting best;
  double latest = 1;  // no earlier than the best
  const auto rank = [](const Feature& a, const Feature& b) {
    return std::tuple(static_cast<int>(a.kind) + static_cast<int>(b.kind), a.kind, a.index, b.kind, b.index);
  };
  for (const Candidate& c : found) {
    if (c.earliest > latest) break;
    const auto with = exact.condition_of(c.pair);
    std::optional<Root> time = with ? first_time(*with) : std::nullopt;
    if (!time) continue;
    const Feature a = exact.feature_of_a(c.pair), b = exact.feature_of_b(c.pair);
    if (best.time) {
      const auto order = *time <=> *best.time;
      if (order > 0 || (order == 0 && rank(best.a, best.b) < rank(a, b))) continue;
    }
    latest = time->rounded(Rounding::up);
    best = {std::move(time), a, b};
  }
  return best;
}

/// Does an interval show that the hulls have no common point at time 0?
bool certainly_apart(const Body<Interval>& a, const Body<Interval>& b) {
  const auto one_sided = [](const Body<Interval>& body, const Vec3<Interval>& n, const Interval& offset) {
    const auto side = [&](const Vec3<Interval>& v) { return dot(v, n) - offset; };
    return std::ranges::all_of(body.vertices, [&](const auto& v) { return side(v).lower > 0; }) ||
           std::ranges::all_of(body.vertices, [&](const auto& v) { return side(v).upper < 0; });
  };
  if (a.vertices.empty()) return one_sided(b, a.faces[0].normal, a.faces[0].offset);
  if (b.vertices.empty()) return one_sided(a, b.faces[0].normal, b.faces[0].offset);
  const auto separates = [&](const Vec3<Interval>& n) {
    const auto reach = [&](const Body<Interval>& body) {
      Interval r{Interval::infinity, -Interval::infinity};
      for (const auto& v : body.vertices) {
        const Interval at = dot(v, n);
        r = {std::min(r.lower, at.lower), std::max(r.upper, at.upper)};
      }
      return r;
    };
    const Interval of_a = reach(a), of_b = reach(b);
    return of_a.upper < of_b.lower || of_b.upper < of_a.lower;
  };
  const Interval one(1.0), zero(0.0);
  if (separates({one, zero, zero}) || separates({zero, one, zero}) || separates({zero, zero, one})) return true;
  for (const auto* body : {&a, &b}) {
    for (const auto& f : body->faces) {
      if (separates(f.normal)) return true;
    }
  }
  const auto along = [](const Body<Interval>& body, const Body<Interval>::Edge& e) {
    return body.vertices[e.ends[1]] - body.vertices[e.ends[0]];
  };
  constexpr std::size_t few = 12;  // edges; with more the exact relation costs less
  if (a.edges.size() > few || b.edges.size() > few) return false;
  for (const auto& e : a.edges) {
    for (const auto& f : b.edges) {
      if (separates(cross(along(a, e), along(b, f)))) return true;
    }
  }
  return false;
}

struct HullOf {
  FlatSet operator()(const Sphere3* s) const { return flat_set(s->center); }
  FlatSet operator()(const Capsule3* c) const { return flat_set(Segment3{c->a, c->b}); }
  template <class Flat>
  FlatSet operator()(const Flat* flat) const {
    return flat_set(*flat);
  }
};

bool holds_strictly_at_start(const Condition<BigDyadic>& c) {
  return c.not_positive[0].sign() == Sign::negative &&
         std::ranges::none_of(c.not_negative, [](const auto& linear) { return linear[0].sign() == Sign::negative; });
}

Meeting meeting(std::string_view function, const Motion& a, const Motion& b) {
  require_finite_parts(function, {"a.by", "b.by"}, *a.by, *b.by);
  const bool some_a = check_body(function, "a.shape", a.shape), some_b = check_body(function, "b.shape", b.shape);
  if (!some_a || !some_b) return {};
  const Meeting overlap{Root(Rational(0)), {FeatureKind::interior, 0}, {FeatureKind::interior, 0}};
  const Pair<Interval> quick(a, b);
  const bool swept = quick.a.reach.upper + quick.b.reach.upper > 0;
  if (!certainly_apart(quick.a, quick.b)) {
    const Relation hulls = relate(std::visit(HullOf{}, a.shape), std::visit(HullOf{}, b.shape));
    if (hulls == Relation::overlapping || (hulls == Relation::touching && swept)) return overlap;
  }
  const std::vector<Candidate> found = candidates(quick);
  if (found.empty()) return {};
  const Pair<BigDyadic> exact(a, b);
  for (const Candidate& c : found) {
    if (!swept || c.earliest > 0) continue;
    const auto at_start = exact.condition_of(c.pair);
    if (at_start && holds_strictly_at_start(*at_start)) return overlap;
  }
  return first_of(found, exact);
}

}  // namespace
}  // namespace query

template <class A, class B>
requires MovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  return query::meeting("first_contact_time", {&a.shape, &a.by}, {&b.shape, &b.by}).time;
}

template <class A, class B>
requires MovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  const query::Meeting m = query::meeting("first_contact", {&a.shape, &a.by}, {&b.shape, &b.by});
  if (!m.time) return {};
  return Contact{m.time->rounded(Rounding::down), m.a, m.b};
}

template <class A, class B>
requires MovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::meeting("intersects", {&a.shape, &a.by}, {&b.shape, &b.by}).time.has_value();
}

#define PLUMB_MOVING_PAIR(A, B)                                                                  \
  template std::optional<Root> first_contact_time(const Translating<A>&, const Translating<B>&); \
  template std::optional<Contact> first_contact(const Translating<A>&, const Translating<B>&);   \
  template bool intersects(const Translating<A>&, const Translating<B>&);
#define PLUMB_MOVING_PAIRS(A)             \
  PLUMB_MOVING_PAIR(A, Point3)            \
  PLUMB_MOVING_PAIR(A, Segment3)          \
  PLUMB_MOVING_PAIR(A, Triangle3)         \
  PLUMB_MOVING_PAIR(A, Aabb3)             \
  PLUMB_MOVING_PAIR(A, Obb3)              \
  PLUMB_MOVING_PAIR(A, ConvexPolyhedron3) \
  PLUMB_MOVING_PAIR(A, Sphere3)           \
  PLUMB_MOVING_PAIR(A, Capsule3)          \
  PLUMB_MOVING_PAIR(A, Plane3)
PLUMB_MOVING_PAIRS(Point3)
PLUMB_MOVING_PAIRS(Segment3)
PLUMB_MOVING_PAIRS(Triangle3)
PLUMB_MOVING_PAIRS(Aabb3)
PLUMB_MOVING_PAIRS(Obb3)
PLUMB_MOVING_PAIRS(ConvexPolyhedron3)
PLUMB_MOVING_PAIRS(Sphere3)
PLUMB_MOVING_PAIRS(Capsule3)
PLUMB_MOVING_PAIR(Plane3, Point3)
PLUMB_MOVING_PAIR(Plane3, Segment3)
PLUMB_MOVING_PAIR(Plane3, Triangle3)
PLUMB_MOVING_PAIR(Plane3, Aabb3)
PLUMB_MOVING_PAIR(Plane3, Obb3)
PLUMB_MOVING_PAIR(Plane3, ConvexPolyhedron3)
PLUMB_MOVING_PAIR(Plane3, Sphere3)
PLUMB_MOVING_PAIR(Plane3, Capsule3)
#undef PLUMB_MOVING_PAIRS
#undef PLUMB_MOVING_PAIR

}  // namespace plumb
