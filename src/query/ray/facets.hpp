// Ray cast: when does a line first meet one of several flat faces, convex and of three or four corners?
//
// A facet is given by its corners, seen from the ray's origin, with the numbers of its vertices and edges; corners may
// be equal or on one line: then the facet is the union of its edges.
// A model is facets() of them, facet<T>(line, i).
// Laws: decided in any numbers; where a sign was not certain the answer means nothing.  The feature is that of the
// lowest dimension, then number, that holds the point.
// Source: RTCD 5.3.4 to 5.3.6 (figure 5.24).
#pragma once

#include <array>
#include <cstddef>

#include "query/ray/numbers.hpp"

namespace plumb::query {

template <class T>
struct Facet {
  std::size_t size;                           // 3 or 4
  std::array<Vec3<T>, 4> corners;             // from the origin
  std::array<std::uint32_t, 4> vertex, edge;  // edge i leaves corner i
  std::uint32_t face;

  [[nodiscard]] const Vec3<T>& next(std::size_t i) const { return corners[i + 1 < size ? i + 1 : 0]; }
};

template <class T>
Vec3<T> facet_normal(const Facet<T>& f) {
  return cross(f.corners[1] - f.corners[0], f.corners[f.size - 1] - f.corners[0]);
}

/// Positive when the line from the origin passes the edge from p to q on its left, as line_edge says.
template <class T>
T edge_side(const Vec3<T>& direction, const Vec3<T>& p, const Vec3<T>& q) {
  return dot(direction, cross(q, p));
}

/// How a facet is met: by its plane, by a constraint of its plane, or along an edge.
enum class Meeting : std::uint32_t { plane = 0, side = 4, crossing = 8, from = 12 };
inline std::uint32_t part_of(Meeting m, std::size_t edge) {
  return static_cast<std::uint32_t>(m) + static_cast<std::uint32_t>(edge);
}
inline Meeting meeting_of(const When& when) { return static_cast<Meeting>(when.part & ~3u); }

template <class T>
Time<T> plane_time(const Facet<T>& f, const Vec3<T>& direction) {
  const Vec3<T> n = facet_normal(f);
  return {dot(f.corners[0], n), dot(direction, n)};
}
/// A plane is seen along an axis in which its normal has a part, which has this sign: so it is not seen edge on.
struct SeenPlane {
  std::size_t axis;
  Sign way;
};
/// Takes a part that is certainly not zero; where there is none all are asked, so that the signs tell that they are in doubt.
template <class T>
SeenPlane seen_plane(const Vec3<T>& normal, RaySigns& ask) {
  const std::array<const T*, 3> parts{&normal.x, &normal.y, &normal.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    RaySigns alone;
    if (const Sign way = alone(*parts[axis]); way != Sign::zero && alone.certain()) return {axis, way};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const Sign way = ask(*parts[axis]); way != Sign::zero) return {axis, way};
  }
  return {0, Sign::zero};
}
/// The part of a x b along the axis.
template <class T>
T cross_along(std::size_t axis, const Vec3<T>& a, const Vec3<T>& b) {
  if (axis == 0) return a.y * b.z - a.z * b.y;
  return axis == 1 ? a.z * b.x - a.x * b.z : a.x * b.y - a.y * b.x;
}
/// Inside of edge i, for a line in the facet's plane.  All vectors lie in that plane, so that one part of a cross product
/// has the sign that is asked for, in two fifths of the digits.
template <class T>
Linear<T> side_of(const Facet<T>& f, const SeenPlane& seen, const Vec3<T>& direction, std::size_t i) {
  const Vec3<T> e = f.next(i) - f.corners[i];
  return seen.way == Sign::negative
             ? Linear<T>{cross_along(seen.axis, f.corners[i], e), cross_along(seen.axis, e, direction)}
             : Linear<T>{cross_along(seen.axis, e, f.corners[i]), cross_along(seen.axis, direction, e)};
}
/// Of a line in one plane with the edge from p along e, not parallel to it.
template <class T>
Time<T> crossing_time(const Vec3<T>& p, const Vec3<T>& e, const Vec3<T>& direction) {
  const Vec3<T> x = cross(direction, e);
  return {dot(cross(p, e), x), dot(x, x)};
}
/// Of a point on the line.
template <class T>
Time<T> point_time(const Vec3<T>& p, const Vec3<T>& direction) {
  return {dot(p, direction), dot(direction, direction)};
}

template <class T>
struct Candidate {
  Time<T> time;
  When when;
  std::optional<Feature> feature;  // of the facet, if it was found on the way
};

/// Tells which feature of a facet with an area holds a point of it, where it is known of which edges' lines the point is.
/// A facet of four corners, of which two may be equal, is told of points inside alone.
template <class T>
std::optional<Feature> feature_by_sides(const Facet<T>& f, const std::array<bool, 4>& on) {
  if (!on[0] && !on[1] && !on[2] && (f.size == 3 || !on[3])) return Feature{FeatureKind::face, f.face};
  if (f.size != 3) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    if (on[i] && on[(i + 2) % 3]) return Feature{FeatureKind::vertex, f.vertex[i]};
  }
  return Feature{FeatureKind::edge, f.edge[on[0] ? 0 : on[1] ? 1 : 2]};
}

/// The earliest so far.
template <class T>
struct Earliest {
  std::optional<Candidate<T>> found;

  void add(const Candidate<T>& c, RaySigns& ask) {
    if (!found || compare(c.time, found->time, ask) == Sign::negative) found = c;
  }
  void add(const ShotLine<T>& line, const Time<T>& time, const When& when, RaySigns& ask) {
    if (in_range(line.ray, time, ask)) add({time, when, {}}, ask);
  }
};

/// The edge of facet `index` as a segment, against a line of some direction.
template <class T>
void meet_edge(const ShotLine<T>& line, const Facet<T>& f, std::uint32_t index, std::size_t i, Earliest<T>& earliest,
               RaySigns& ask) {
  const Vec3<T>&p = f.corners[i], &q = f.next(i), &d = line.direction;
  const Vec3<T> e = q - p, x = cross(d, e);
  const auto when = [&](Meeting m, std::size_t edge) { return When{When::At::quotient, index, part_of(m, edge)}; };
  if (!is_zero(x, ask)) {
    if (ask(dot(cross(p, d), e)) != Sign::zero) return;  // not in one plane
    const T along = dot(cross(p, d), x);
    if (ask(along) == Sign::negative || ask(along - dot(x, x)) == Sign::positive) return;
    earliest.add(line, crossing_time(p, e, d), when(Meeting::crossing, i), ask);
    return;
  }
  if (!is_zero(cross(p, d), ask)) return;  // beside
  const Time<T> from = point_time(p, d), to = point_time(q, d);
  const bool forward = compare(from, to, ask) != Sign::positive;
  const Time<T>&least = forward ? from : to, &most = forward ? to : from;
  if (begins(line.ray) && ask(least.numerator) == Sign::negative) {
    if (ask(most.numerator) != Sign::negative) earliest.add(line, time_zero<T>(), When{When::At::zero, index, 0}, ask);
    return;
  }
  earliest.add(line, least, when(Meeting::from, forward ? i : i + 1 < f.size ? i + 1 : 0), ask);
}

/// For a line of some direction.
template <class T>
void meet_facet(const ShotLine<T>& line, const Facet<T>& f, std::uint32_t index, Earliest<T>& earliest, RaySigns& ask) {
  const Vec3<T> normal = facet_normal(f);
  const Vec3<T>& d = line.direction;
  const T slope = dot(d, normal);
  const Sign way = ask(slope);
  if (way != Sign::zero) {
    bool left = true, right = true;
    std::array<bool, 4> on{};
    for (std::size_t i = 0; i < f.size; ++i) {
      const Sign s = ask(edge_side(d, f.corners[i], f.next(i)));
      left = left && s != Sign::negative;
      right = right && s != Sign::positive;
      on[i] = s == Sign::zero;
    }
    if (!left && !right) return;
    const Time<T> time = with_positive_denominator(dot(f.corners[0], normal), slope, way);
    if (!in_range(line.ray, time, ask)) return;
    const When when{ask(time.numerator) == Sign::zero ? When::At::zero : When::At::quotient, index,
                    part_of(Meeting::plane, 0)};
    earliest.add({time, when, feature_by_sides(f, on)}, ask);
  } else if (is_zero(normal, ask)) {
    for (std::size_t i = 0; i < f.size; ++i) meet_edge(line, f, index, i, earliest, ask);
  } else if (ask(dot(f.corners[0], normal)) == Sign::zero) {
    const SeenPlane seen = seen_plane(normal, ask);
    Remaining<T> left(line.ray);
    std::array<std::optional<Linear<T>>, 4> sides;
    for (std::size_t i = 0; i < f.size; ++i) {
      sides[i] = side_of(f, seen, d, i);
      if (!left.cut(*sides[i], static_cast<std::uint32_t>(i), ask)) return;
    }
    if (left.is_empty(ask)) return;
    const When first = left.first(ask);
    const When when{first.at, index, part_of(Meeting::side, first.index)};
    const bool at_zero = first.at == When::At::zero;
    const Time<T> time = at_zero ? time_zero<T>() : left.lower.time;
    std::array<bool, 4> on{};
    for (std::size_t i = 0; i < f.size; ++i) {
      on[i] = (!at_zero && i == first.index) ||
              ask(at_zero ? sides[i]->constant
                          : sides[i]->constant * time.denominator + sides[i]->slope * time.numerator) == Sign::zero;
    }
    earliest.add({time, when, feature_by_sides(f, on)}, ask);
  }
}

/// Is the point at p / w, seen from the origin, on the segment from a to b?
template <class T>
bool on_segment(const Vec3<T>& p, const T& w, const Vec3<T>& a, const Vec3<T>& b, RaySigns& ask) {
  const Vec3<T> e = b - a, v = p - times(a, w);
  if (!is_zero(cross(v, e), ask)) return false;
  const T square = dot(e, e), along = dot(v, e);
  return ask(square) == Sign::positive && ask(along) != Sign::negative && ask(along - square * w) != Sign::positive;
}

/// Of the features of one facet that hold the point p / w: vertices, then edges, then the face itself.
template <class T>
std::optional<Feature> corner_or_edge(const Facet<T>& f, const Vec3<T>& p, const T& w, RaySigns& ask) {
  std::optional<Feature> found;
  const auto take = [&](FeatureKind kind, std::uint32_t number) {
    if (!found || number < found->index) found = Feature{kind, number};
  };
  for (std::size_t i = 0; i < f.size; ++i) {
    if (is_zero(p - times(f.corners[i], w), ask)) take(FeatureKind::vertex, f.vertex[i]);
  }
  if (found) return found;
  for (std::size_t i = 0; i < f.size; ++i) {
    if (on_segment(p, w, f.corners[i], f.next(i), ask)) take(FeatureKind::edge, f.edge[i]);
  }
  return found;
}

/// Of a ray that is a point: the first feature that holds it.
template <class T, class Model>
std::optional<Decided> hold_point(const ShotLine<T>& line, const Model& model, RaySigns& ask) {
  const Vec3<T> p{T(0.0), T(0.0), T(0.0)};
  std::optional<Decided> best;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(model.facets()); ++i) {
    const Facet<T> f = model.template facet<T>(line, i);
    std::optional<Feature> found = corner_or_edge(f, p, T(1.0), ask);
    const Vec3<T> normal = facet_normal(f);
    if (!found && !is_zero(normal, ask) && ask(dot(f.corners[0], normal)) == Sign::zero) {
      const SeenPlane seen = seen_plane(normal, ask);
      bool inside = true;
      for (std::size_t k = 0; k < f.size; ++k)
        inside = inside && ask(side_of(f, seen, line.direction, k).constant) != Sign::positive;
      if (inside) found = Feature{FeatureKind::face, f.face};
    }
    if (found && (!best || std::pair(found->kind, found->index) < std::pair(best->feature.kind, best->feature.index)))
      best = Decided{{When::At::zero, i, 0}, *found, true, i};
  }
  return best;
}

template <class T, class Model>
std::optional<Decided> meet_facets(const ShotLine<T>& line, const Model& model, RaySigns& ask) {
  if (has_no_direction(line.ray)) return hold_point<T>(line, model, ask);
  Earliest<T> earliest;
  const auto size = static_cast<std::uint32_t>(model.facets());
  for (std::uint32_t i = 0; i < size; ++i) meet_facet(line, model.template facet<T>(line, i), i, earliest, ask);
  if (!earliest.found) return {};
  const auto& [time, when, feature] = *earliest.found;
  Feature best = feature.value_or(Feature{FeatureKind::face, model.template facet<T>(line, when.index).face});
  if (!feature || size > 1) {
    const Vec3<T> p = times(line.direction, time.numerator);
    for (std::uint32_t i = 0; i < size; ++i) {
      const auto f = corner_or_edge(model.template facet<T>(line, i), p, time.denominator, ask);
      if (f && std::pair(f->kind, f->index) < std::pair(best.kind, best.index)) best = *f;
    }
  }
  return Decided{when, best, true, when.index};
}

template <class T, class Model>
Time<T> facet_time(const ShotLine<T>& line, const Model& model, const When& when, RaySigns& ask) {
  const Facet<T> f = model.template facet<T>(line, when.index);
  const std::size_t i = when.part & 3u;
  const Vec3<T>& d = line.direction;
  switch (meeting_of(when)) {
    case Meeting::plane:
      return plane_time(f, d);
    case Meeting::side: {
      const Linear<T> c = side_of(f, seen_plane(facet_normal(f), ask), d, i);
      return {T(0.0) - c.constant, c.slope};
    }
    case Meeting::crossing:
      return crossing_time(f.corners[i], f.next(i) - f.corners[i], d);
    default:
      return point_time(f.corners[i], d);
  }
}

/// What is left of a model when it says what its facets are.
template <class Derived>
struct FacetModel {
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    return facet_time<T>(line, static_cast<const Derived&>(*this), when, ask);
  }
  template <class T>
  std::optional<PlaneMeeting<T>> plane_meeting(const ShotLine<T>& line, const Decided& decided) const {
    const When& when = decided.when;
    if (when.at != When::At::quotient || meeting_of(when) != Meeting::plane || decided.normal != when.index) return {};
    const Facet<T> f = static_cast<const Derived&>(*this).template facet<T>(line, when.index);
    const Vec3<T> n = facet_normal(f);
    return PlaneMeeting<T>{{dot(f.corners[0], n), dot(line.direction, n)}, n};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    return still_normal(facet_normal(static_cast<const Derived&>(*this).template facet<T>(line, decided.normal)));
  }
};

/// The sign of value, or of the first part of the gradient that is not zero: of a ray that is moved a little along x,
/// far less along y, and less again along z.
template <class T>
Sign perturbed(const T& value, const Vec3<T>& gradient, RaySigns& ask) {
  for (const T* x : {&value, &gradient.x, &gradient.y, &gradient.z}) {
    if (const Sign s = ask(*x); s != Sign::zero) return s;
  }
  return Sign::zero;
}

/// Does the line from the origin, moved so, go through the facet, which its direction is not parallel to?
template <class T>
bool passes_perturbed(const Facet<T>& f, const Vec3<T>& direction, RaySigns& ask) {
  Sign all = Sign::zero;
  for (std::size_t i = 0; i < f.size; ++i) {
    const Vec3<T>&p = f.corners[i], &q = f.next(i);
    const Sign s = perturbed(edge_side(direction, p, q), cross(q - p, direction), ask);
    if (s == Sign::zero || (i > 0 && s != all)) return false;
    all = s;
  }
  return true;
}

}  // namespace plumb::query
