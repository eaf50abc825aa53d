// Lozenges: points near to a parallelogram.
//
// Space is divided by which part of the parallelogram is nearest: its inside, an edge or a corner, nine zones that
// planes bound.  In each the square of the distance is a quadratic along the line: to the plane, to an edge's line or to
// a corner; together they are convex and without a step.  So the line comes within reach at the lesser root of the
// quadratic of a zone that it is in just before, or the ray begins within reach.  What a zone says otherwise, that the
// line is within reach where it enters the zone, is no first time.
// With n = e x f, the plane's quadratic is (n . d)^2 t^2 + 2 (n . w) (n . d) t + (n . w)^2 - r^2 |n|^2.
// Of parallel edges the parallelogram is a segment, with the zones of a capsule, or a point.
#include <algorithm>
#include <vector>

#include "query/ray/answers.hpp"
#include "query/ray/round_parts.hpp"

namespace plumb::query {
namespace {

/// Numbers of zones are those of the faces: the plane's are 0 and 1, its two sides.
constexpr std::uint32_t lozenge_edges = 2, lozenge_corners = 6, lozenge_zones = 10;
/// Those of a capsule: the side is 0.
constexpr std::uint32_t capsule_ends = 1, capsule_zones = 3;

struct LozengeModel {
  const Lozenge3& lozenge;
  int dimension = 2;
  bool opposite = false;  // of a segment: do the edges run against one another?

  template <class T>
  [[nodiscard]] Vec3<T> edge(std::size_t i) const {
    return vector_of<T>(lozenge.edges[i]);
  }
  /// From the corner at the upper ends of these edges to the origin.
  template <class T>
  Vec3<T> from_corner(const ShotLine<T>& line, std::uint32_t ends) const {
    Vec3<T> w = line.origin_from(lozenge.corner);
    if ((ends & 1u) != 0) w = w - edge<T>(0);
    if ((ends & 2u) != 0) w = w - edge<T>(1);
    return w;
  }
  [[nodiscard]] std::uint32_t zones() const {
    return dimension == 2 ? lozenge_zones : dimension == 1 ? capsule_zones : 1;
  }
  /// The ends of a segment, and the way from the first to the second.
  [[nodiscard]] std::uint32_t end_of_segment(bool second) const { return opposite ? (second ? 1 : 2) : second ? 3 : 0; }
  template <class T>
  [[nodiscard]] Vec3<T> segment() const {
    return opposite ? edge<T>(0) - edge<T>(1) : edge<T>(0) + edge<T>(1);
  }
  [[nodiscard]] std::uint32_t corner_of(std::uint32_t zone) const {
    if (dimension == 2) return zone - lozenge_corners;
    return dimension == 0 ? 0 : end_of_segment(zone > capsule_ends);
  }
  [[nodiscard]] bool is_corner(std::uint32_t zone) const {
    return dimension == 2 ? zone >= lozenge_corners : dimension == 0 || zone >= capsule_ends;
  }
  [[nodiscard]] bool is_plane(std::uint32_t zone) const { return dimension == 2 && zone < lozenge_edges; }
  template <class T>
  [[nodiscard]] Vec3<T> plane_normal() const {
    return cross(edge<T>(0), edge<T>(1));
  }
  /// Of an edge or a segment: from its line to the origin, and along it.
  template <class T>
  std::pair<Vec3<T>, Vec3<T>> tube(const ShotLine<T>& line, std::uint32_t zone) const {
    if (dimension == 1) return {from_corner(line, end_of_segment(false)), segment<T>()};
    const std::uint32_t axis = (zone - lozenge_edges) / 2, end = (zone - lozenge_edges) % 2;
    return {from_corner(line, end << (1 - axis)), edge<T>(axis)};
  }

  template <class T>
  std::vector<Linear<T>> zone(const ShotLine<T>& line, std::uint32_t i) const {
    std::vector<Linear<T>> z;
    const Vec3<T>& d = line.direction;
    const T zero(0.0);
    // 0 <= (w + t d) . a, and its opposite.
    const auto from = [&](const Vec3<T>& w, const Vec3<T>& a) { z.push_back({zero - dot(w, a), zero - dot(d, a)}); };
    const auto to = [&](const Vec3<T>& w, const Vec3<T>& a) { z.push_back({dot(w, a), dot(d, a)}); };
    if (dimension == 0) return z;
    if (dimension == 1) {
      const Vec3<T> e = segment<T>(), first = from_corner(line, end_of_segment(false)),
                    second = from_corner(line, end_of_segment(true));
      if (i == 0) from(first, e), to(second, e);
      if (i == 1) to(first, e);
      if (i == 2) from(second, e);
      return z;
    }
    const auto edge_walls = [&](std::uint32_t axis, bool upper) {  // inside of the edge along this axis
      const Vec3<T> n = plane_normal<T>(), inward = axis == 0 ? cross(n, edge<T>(0)) : cross(edge<T>(1), n);
      return std::pair(from_corner(line, upper ? 3u : 0u), inward);
    };
    if (is_plane(i)) {
      for (const std::uint32_t axis : {0u, 1u}) {
        const auto [low, inward] = edge_walls(axis, false);
        from(low, inward), to(edge_walls(axis, true).first, inward);
      }
    } else if (is_corner(i)) {
      const std::uint32_t ends = corner_of(i);
      const Vec3<T> w = from_corner(line, ends);
      for (const std::uint32_t axis : {0u, 1u}) {
        if ((ends >> axis & 1u) != 0) {
          from(w, edge<T>(axis));
        } else {
          to(w, edge<T>(axis));
        }
      }
    } else {
      const std::uint32_t axis = (i - lozenge_edges) / 2, end = (i - lozenge_edges) % 2, across = end << (1 - axis);
      const Vec3<T> e = edge<T>(axis);
      from(from_corner(line, across), e), to(from_corner(line, across | 1u << axis), e);
      const auto [w, inward] = edge_walls(axis, end == 1);
      if (end == 1) {
        from(w, inward);
      } else {
        to(w, inward);
      }
    }
    return z;
  }
  template <class T>
  Linear<T> height(const ShotLine<T>& line) const {
    const Vec3<T> n = plane_normal<T>();
    return {dot(line.origin_from(lozenge.corner), n), dot(line.direction, n)};
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line, const When& when) const {
    const std::uint32_t zone = when.index;
    if (is_corner(zone)) return ball_quadratic(from_corner(line, corner_of(zone)), line.direction, lozenge.radius);
    if (!is_plane(zone)) {
      const auto [w, e] = tube(line, zone);
      return tube_quadratic(w, line.direction, e, lozenge.radius);
    }
    const auto [at, speed] = height(line);
    const T r(lozenge.radius), reach = r * r * length2(plane_normal<T>()), square = speed * speed;
    return {square, at * speed, at * at - reach, square * reach};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    const std::uint32_t zone = decided.normal;
    if (is_corner(zone)) return from_center(from_corner(line, corner_of(zone)), line.direction);
    if (is_plane(zone)) return still_normal(times(plane_normal<T>(), T(zone == 1 ? -1.0 : 1.0)));
    const auto [w, e] = tube(line, zone);
    return from_axis(w, line.direction, e);
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const;
};

template <class T>
std::optional<Decided> LozengeModel::decide(const ShotLine<T>& line, RaySigns& ask) const {
  const AnyRay& ray = line.ray;
  std::vector<std::uint32_t> entered;  // within reach, from a zone before
  for (std::uint32_t i = 0; i < zones(); ++i) {
    if (dimension == 2 && i == 1) continue;  // the other side of the plane
    Remaining<T> left(ray);
    bool some = true;
    std::uint32_t wall = 0;
    for (const Linear<T>& c : zone(line, i)) some = some && left.cut(c, wall++, ask);
    if (!some) continue;
    const Quadratic<T> q = quadratic(line, When{When::At::root, i, 0});
    const std::optional<When> when = enter(q, left, i, ask);
    if (!when) continue;
    if (when->at == When::At::quotient) {
      entered.push_back(i);
      continue;
    }
    const bool begins_in = when->at == When::At::zero;
    if (begins_in && !begins(ray) && !has_no_direction(ray)) continue;  // of a line that is in reach for ever: none
    if (begins_in && ask(q.constant) == Sign::negative) return Decided{{}, {FeatureKind::interior, 0}, false, 0};
    std::uint32_t face = i;  // or the first whose zone holds the point as well
    const auto holds = [&](const Linear<T>& c) { return sign_at(c, *when, time_zero<T>(), &q, ask) != Sign::positive; };
    for (const std::uint32_t before : entered) {
      if (face == i && !begins_in && std::ranges::all_of(zone(line, before), holds)) face = before;
    }
    if (is_plane(face) && sign_at(height(line), *when, time_zero<T>(), &q, ask) == Sign::negative) face = 1;
    return Decided{*when, {FeatureKind::face, face}, true, face};
  }
  return {};
}

LozengeModel lozenge_model(const Lozenge3& lozenge) {
  LozengeModel model{lozenge};
  return certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) {
    LozengeModel m = model;
    const Vec3<T> e = m.edge<T>(0), f = m.edge<T>(1);
    if (!is_zero(cross(e, f), ask)) return m;
    m.dimension = is_zero(e, ask) && is_zero(f, ask) ? 0 : 1;
    m.opposite = ask(dot(e, f)) == Sign::negative;
    return m;
  });
}

}  // namespace

template <class F>
auto with_model(const Lozenge3& lozenge, const RayQuestion&, const F& f) {
  return f(lozenge_model(lozenge));
}

template struct RayAnswers<Lozenge3>;

template std::optional<SeenHit> seen_hit(const SeenLine&, const Lozenge3&);

}  // namespace plumb::query
