// In which order do corners stand, which of them are extreme, and how is each named?
//
// A corner is a vertex of one set, or where an edge of one crosses a bound of the other.  A coordinate that is known as
// a double (of a vertex, of a bound across an axis) is compared as one: computed ones could not tell that two are
// equal.
// Laws: orders and turns are those of the exact points, or nothing is certain.
// Cost: 10 to 40 operations a comparison.
#pragma once

#include <cmath>
#include <limits>

#include "query/convex/extreme_chain.hpp"
#include "query/section/clip.hpp"

namespace plumb::query::meeting {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Where a corner comes from: vertex `index` of a set, or its edge `index` crossing the other set's bound.
struct Origin {
  bool of_b;
  int index;
  int bound;  // infinity for a vertex
  friend bool operator==(const Origin&, const Origin&) = default;
};

template <class T, std::size_t N>
struct Corner {
  Weighted<T, N> at;
  std::array<double, N> known;
  Origin origin;
};

template <class T, std::size_t N>
Weighted<T, N> vertex_place(const ConvexSet<N>& set, int vertex) {
  const auto v = static_cast<std::size_t>(vertex);
  if constexpr (std::is_same_v<T, BigDyadic>) {
    if (set.is_exact()) return {set.exact_vertices[v], T(1.0)};
  }
  return {made<T, N>(set.vertices[v]), T(1.0)};
}

template <class T, std::size_t N>
Corner<T, N> vertex_corner(const ConvexSet<N>& set, int vertex, bool of_b) {
  Corner<T, N> c{vertex_place<T, N>(set, vertex), {}, {of_b, vertex, infinity}};
  c.known.fill(unknown);
  for (std::size_t axis = 0; axis < N && !set.is_exact(); ++axis)
    c.known[axis] = part(set.vertices[static_cast<std::size_t>(vertex)], axis);
  return c;
}

/// Where edge number `edge` of the set crosses a bound of the other.  An end of a set on a line is its vertex: what
/// crosses there and not at the line itself runs along the line.
template <class T, std::size_t N>
Corner<T, N> crossing_corner(const ConvexSet<N>& set, std::size_t edge, const ConvexSet<N>& other, const End<T>& end,
                             bool of_b) {
  const Edge<N>& e = set.edges[edge];
  const Bound<N>& b = other.bounds[static_cast<std::size_t>(end.index)];
  if (b.vertex != infinity) return vertex_corner<T, N>(other, b.vertex, !of_b);
  const Vec<T, N> d = along<T, N>(set, e);
  Corner<T, N> c{e.is_bounded() ? vertex_place<T, N>(set, e.from) : Weighted<T, N>{made<T, N>(e.point), T(1.0)},
                 {},
                 {of_b, static_cast<int>(edge), end.index}};
  for (std::size_t axis = 0; axis < N; ++axis) c.at.at[axis] = c.at.at[axis] * end.whole + d[axis] * end.part;
  c.at.weight = end.whole;
  for (std::size_t axis = 0; axis < N; ++axis) {
    const bool across = !set.is_exact() && direction_sign(set, e, axis) == 0;
    const double from =
        across ? part(e.is_bounded() ? set.vertices[static_cast<std::size_t>(e.from)] : e.point, axis) : 0;
    c.known[axis] = across ? from : unknown;
  }
  if (b.kind == Bound<N>::Kind::axis) c.known[b.axis] = b.offset;
  return c;
}

template <class T, std::size_t N>
Sign compare_on_axis(const Corner<T, N>& a, const Corner<T, N>& b, std::size_t axis, CertainSigns& ask) {
  const double x = a.known[axis], y = b.known[axis];
  const bool knows_x = x == x, knows_y = y == y;
  if (knows_x && knows_y) return static_cast<Sign>(static_cast<int>(x > y) - static_cast<int>(x < y));
  if (knows_x) return ask(T(x) * b.at.weight - b.at.at[axis]);
  if (knows_y) return ask(a.at.at[axis] - T(y) * a.at.weight);
  return ask(a.at.at[axis] * b.at.weight - b.at.at[axis] * a.at.weight);
}

template <class T, std::size_t N>
Sign compare(const Corner<T, N>& a, const Corner<T, N>& b, CertainSigns& ask) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const Sign s = compare_on_axis(a, b, axis, ask);
    if (s != Sign::zero || !ask.certain()) return s;
  }
  return Sign::zero;
}

/// Positive when a, b, c turn counterclockwise, as seen.
template <class T, std::size_t N>
Sign turn(const Corner<T, N>& a, const Corner<T, N>& b, const Corner<T, N>& c, Seen look, CertainSigns& ask) {
  const auto [r, u] = look;
  bool known = true;
  for (const Corner<T, N>* p : {&a, &b, &c}) known = known && p->known[r] == p->known[r] && p->known[u] == p->known[u];
  if (known) {
    return orient2d(Point2{a.known[r], a.known[u]}, Point2{b.known[r], b.known[u]}, Point2{c.known[r], c.known[u]});
  }
  const auto &p = a.at, &q = b.at, &s = c.at;
  const Vec<T, 2> d{q.at[r] * p.weight - p.at[r] * q.weight, q.at[u] * p.weight - p.at[u] * q.weight};
  const Vec<T, 2> e{s.at[r] * p.weight - p.at[r] * s.weight, s.at[u] * p.weight - p.at[u] * s.weight};
  return ask(det2(d[0], d[1], e[0], e[1]));
}

/// Where a corner stands among ascending ones, and whether one of them is it.
struct Place {
  std::size_t index;
  bool taken;
};
template <class T, std::size_t N>
Place place_of(const Corner<T, N>& c, const std::vector<Corner<T, N>>& sorted, CertainSigns& ask) {
  std::size_t low = 0, high = sorted.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    const Sign s = compare(c, sorted[middle], ask);
    if (s == Sign::zero || !ask.certain()) return {middle, true};
    (s == Sign::positive ? low : high) = s == Sign::positive ? middle + 1 : middle;
  }
  return {low, false};
}

/// Ascending, equal ones once.
template <class T, std::size_t N>
void sort_corners(std::vector<Corner<T, N>>& corners, CertainSigns& ask) {
  std::vector<Corner<T, N>> sorted;
  sorted.reserve(corners.size());
  for (Corner<T, N>& c : corners) {
    const Place place = place_of(c, sorted, ask);
    if (!ask.certain()) return;
    if (!place.taken) sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(place.index), std::move(c));
  }
  corners = std::move(sorted);
}

/// Of ascending corners at(0) ... at(count - 1) the extreme ones, as seen.
template <class At>
std::vector<std::size_t> extreme_chain(std::size_t count, const At& at, Seen look, CertainSigns& ask) {
  return query::extreme_chain(count, [&](std::size_t i, std::size_t j, std::size_t k) {
    return turn(at(i), at(j), at(k), look, ask) == Sign::positive;
  });
}

template <class T, std::size_t N>
std::vector<Corner<T, N>> extreme(const std::vector<Corner<T, N>>& corners, Seen look, CertainSigns& ask) {
  const auto at = [&](std::size_t i) -> const Corner<T, N>& { return corners[i]; };
  std::vector<Corner<T, N>> hull;
  for (const std::size_t i : extreme_chain(corners.size(), at, look, ask)) hull.push_back(corners[i]);
  return hull;
}

}  // namespace plumb::query::meeting
