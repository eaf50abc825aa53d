// Figures of the plane meet as those of space in z = 0, which rounds nothing: a convex one as a whole, a polygon edge
// by edge, for what does not overlap it at the start meets its boundary first, or is a vertex inside that bounds nothing.
#include "plumb/query/time_of_impact/flat_contact.hpp"

#include <cmath>
#include <tuple>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/in_space.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "query/body/chain_edges.hpp"
#include "query/body/figure_input.hpp"
#include "query/time_of_impact/body_meeting.hpp"

namespace plumb {
namespace query {
namespace {

/// A figure of space in z = 0.
template <class Shape>
struct FlatPiece {
  Shape shape;
};

/// Upper ends are those of the magnitudes.
Obb3 lifted(const Obb2& b) {
  return {in_space(b.center),
          {in_space(b.axes[0]), in_space(b.axes[1]), {0, 0, 1}},
          {std::fabs(b.half.x), std::fabs(b.half.y), 0}};
}
template <class Shape>
auto lifted(const Shape& s) {
  return in_space(s);
}

template <class Shape>
inline constexpr bool is_chain = std::is_same_v<Shape, Polygon2> || std::is_same_v<Shape, HoledPolygon2>;

template <class Shape>
auto pieces_of(const Shape& s) {
  if constexpr (is_chain<Shape>) {
    return chain_edges(s);
  } else {
    return std::array{FlatPiece<decltype(lifted(s))>{lifted(s)}};
  }
}

/// Edge 4 axis + y + 2 z, or + x + 2 z, of a box in space is edge 2 axis + y, or + x.
template <class Shape, class Piece>
Feature feature_in_plane(const Piece& piece, const Feature& f) {
  if (f.kind == FeatureKind::interior) return f;
  if constexpr (is_chain<Shape>) {
    return piece.feature(f);
  } else if constexpr (std::is_same_v<Shape, Circle2>) {
    return {FeatureKind::edge, 0};
  } else if constexpr (std::is_same_v<Shape, Aabb2> || std::is_same_v<Shape, Obb2>) {
    if (f.kind == FeatureKind::edge) return {f.kind, 2 * (f.index / 4) + (f.index & 1u)};
    return {f.kind, f.kind == FeatureKind::face ? 0 : f.index & 3u};
  } else {
    return f;
  }
}

auto contact_rank(const Contact& c) {
  const int dimensions = static_cast<int>(c.feature_a.kind) + static_cast<int>(c.feature_b.kind);
  return std::tuple(dimensions, c.feature_a.kind, c.feature_a.index, c.feature_b.index);
}

/// Pieces that overlap meet by their features as well, where the polygon only touches.
Relation never_overlapping(const PosedView&, const PosedView&) { return Relation::touching; }

/// The lowest features that meet of two pieces that overlap at the start.
template <class P, class Q>
Contact lowest_at_start(const P& p, const Q& q) {
  constexpr Vector3 at_rest{0, 0, 0};
  const auto m =
      first_meeting("first_contact", {posed_view(p), &at_rest}, {posed_view(q), &at_rest}, never_overlapping);
  return {0, m->of_a, m->of_b};
}

/// Calls see(vertex) for those of a's that are inside of b.
template <class A, class B, class See>
void see_vertices_inside(const A& a, const B& b, See see) {
  if constexpr (is_chain<A> && is_chain<B>) {
    for (const ChainEdge& e : chain_edges(a)) {
      if (locate(b, Point2{e.shape.a.x, e.shape.a.y}) == Location::inside) see(Feature{FeatureKind::vertex, e.from});
    }
  }
}

template <class A, class B>
void require_moving(std::string_view function, const Translating<A>& a, const Translating<B>& b) {
  require_finite_parts(function, std::array<std::string_view, 2>{"a.by", "b.by"}, a.by, b.by);
  require_figure(function, "a.shape", a.shape);
  require_figure(function, "b.shape", b.shape);
}

template <class A, class B>
Relation at_start(const A& a, const B& b) {
  if constexpr (is_chain<A> || is_chain<B>) {
    return relate(a, b);
  } else {
    return Relation::disjoint;  // not asked: who takes a convex figure as a whole sees to it
  }
}

/// Calls f with all pairs of pieces, moving, until it returns true.
template <class A, class B, class F>
bool any_pieces(const Translating<A>& a, const Translating<B>& b, const F& f) {
  const Vector3 by_a = in_space(a.by), by_b = in_space(b.by);
  const auto others = pieces_of(b.shape);
  for (const auto& p : pieces_of(a.shape)) {
    for (const auto& q : others) {
      if (f(p, q, Translating<decltype(p.shape)>{p.shape, by_a}, Translating<decltype(q.shape)>{q.shape, by_b}))
        return true;
    }
  }
  return false;
}

/// Tells the features of what touches at the start: those of the pieces that meet then, else vertices inside.
template <class A, class B, class Named>
std::optional<Contact> lowest_touching(const Translating<A>& a, const Translating<B>& b, const Named& named) {
  std::optional<Contact> lowest;
  const auto see = [&lowest](const Contact& c) {
    if (!lowest || contact_rank(c) < contact_rank(*lowest)) lowest = c;
  };
  any_pieces(a, b, [&](const auto& p, const auto& q, const auto& moving, const auto& other) {
    if (relate(p.shape, q.shape) != Relation::disjoint) see(named(p, q, *first_contact(moving, other)));
    return false;
  });
  const Feature face{FeatureKind::face, 0};
  see_vertices_inside(a.shape, b.shape, [&](const Feature& vertex) { see({0, vertex, face}); });
  see_vertices_inside(b.shape, a.shape, [&](const Feature& vertex) { see({0, face, vertex}); });
  return lowest;
}

}  // namespace
}  // namespace query

template <MovesInPlane A, MovesInPlane B>
std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  query::require_moving("first_contact", a, b);
  const Relation start = query::at_start(a.shape, b.shape);
  if (start == Relation::overlapping) return Contact{0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}};
  const auto named = [](const auto& p, const auto& q, const Contact& c) {
    const auto in_plane = [&](const Contact& x) {
      return Contact{x.time, query::feature_in_plane<A>(p, x.feature_a), query::feature_in_plane<B>(q, x.feature_b)};
    };
    if constexpr (query::is_chain<A> || query::is_chain<B>) {
      if (c.feature_a.kind == FeatureKind::interior) return in_plane(query::lowest_at_start(p.shape, q.shape));
    }
    return in_plane(c);
  };
  std::optional<Contact> first;
  if constexpr (query::is_chain<A> || query::is_chain<B>) {
    if (start == Relation::touching) return query::lowest_touching(a, b, named);
  }
  std::size_t equal = 0;  // when rounded down
  query::any_pieces(a, b, [&](const auto& p, const auto& q, const auto& moving, const auto& other) {
    const auto contact = first_contact(moving, other);
    if (!contact || (first && contact->time > first->time)) return false;
    equal = first && contact->time == first->time ? equal + 1 : 1;
    first = named(p, q, *contact);
    return false;
  });
  if (equal < 2) return first;
  // Which of them is first, and which features are lowest of those that meet at once?
  const double least = first->time;
  std::optional<Root> time;
  query::any_pieces(a, b, [&](const auto& p, const auto& q, const auto& moving, const auto& other) {
    const auto contact = first_contact(moving, other);
    if (!contact || contact->time > least) return false;
    const Contact found = named(p, q, *contact);
    Root exact = *first_contact_time(moving, other);
    if (!time || exact < *time || (exact == *time && query::contact_rank(found) < query::contact_rank(*first)))
      time = std::move(exact), first = found;
    return false;
  });
  return first;
}

template <MovesInPlane A, MovesInPlane B>
std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  query::require_moving("first_contact_time", a, b);
  if (query::at_start(a.shape, b.shape) != Relation::disjoint) return Root(0);
  std::optional<Root> first;
  query::any_pieces(a, b, [&](const auto&, const auto&, const auto& moving, const auto& other) {
    auto time = first_contact_time(moving, other);
    if (time && (!first || *time < *first)) first = std::move(time);
    return false;
  });
  return first;
}

template <MovesInPlane A, MovesInPlane B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  query::require_moving("intersects", a, b);
  return query::at_start(a.shape, b.shape) != Relation::disjoint ||
         query::any_pieces(a, b, [](const auto&, const auto&, const auto& moving, const auto& other) {
           return intersects(moving, other);
         });
}

#define PLUMB_FLAT_PAIR(A, B)                                                                    \
  template std::optional<Contact> first_contact(const Translating<A>&, const Translating<B>&);   \
  template std::optional<Root> first_contact_time(const Translating<A>&, const Translating<B>&); \
  template bool intersects(const Translating<A>&, const Translating<B>&);
#define PLUMB_FLAT_PAIRS(A)     \
  PLUMB_FLAT_PAIR(A, Point2)    \
  PLUMB_FLAT_PAIR(A, Segment2)  \
  PLUMB_FLAT_PAIR(A, Triangle2) \
  PLUMB_FLAT_PAIR(A, Aabb2)     \
  PLUMB_FLAT_PAIR(A, Obb2)      \
  PLUMB_FLAT_PAIR(A, Circle2)   \
  PLUMB_FLAT_PAIR(A, Capsule2)  \
  PLUMB_FLAT_PAIR(A, Polygon2)  \
  PLUMB_FLAT_PAIR(A, HoledPolygon2)
PLUMB_FLAT_PAIRS(Point2)
PLUMB_FLAT_PAIRS(Segment2)
PLUMB_FLAT_PAIRS(Triangle2)
PLUMB_FLAT_PAIRS(Aabb2)
PLUMB_FLAT_PAIRS(Obb2)
PLUMB_FLAT_PAIRS(Circle2)
PLUMB_FLAT_PAIRS(Capsule2)
PLUMB_FLAT_PAIRS(Polygon2)
PLUMB_FLAT_PAIRS(HoledPolygon2)
#undef PLUMB_FLAT_PAIRS
#undef PLUMB_FLAT_PAIR

}  // namespace plumb
