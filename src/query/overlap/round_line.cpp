// Capsules and lozenges against lines and rays.
#include <algorithm>
#include <cmath>

#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_vertices.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

using arith::Plain;

/// corner + s[k] edges[k], and origin + t direction with t >= 0 for a ray.
template <std::size_t N>
struct Guess {
  std::array<double, N> s{};
  double t = 0;
};

/// Nearly nearest points: each number in turn, the others held; t is always the best for s.
template <std::size_t N>
Guess<N> guess(const Plain& corner, const std::array<Plain, N>& edges, const Plain& origin, const Plain& direction,
               bool is_ray) {
  constexpr int most_rounds = N == 1 ? 1 : 24;
  constexpr double settled_on_edge = 0x1p-30;  // a guess, of an edge: what it is of is proved
  const double square = arith::dot(direction, direction);
  const Plain from = corner - origin;
  Guess<N> g;
  const auto foot = [&](const Plain& w) {
    const double t = arith::dot(w, direction) / square;
    return is_ray && !(t > 0) ? 0 : t;
  };
  const auto off_line = [&](const Plain& w) { return w - direction * (arith::dot(w, direction) / square); };
  const auto at = [&] {
    Plain w = from;
    for (std::size_t k = 0; k < N; ++k) w = w + edges[k] * g.s[k];
    return w;
  };
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (std::size_t k = 0; k < N; ++k) {
      const Plain rest = at() - edges[k] * g.s[k];
      const Plain e = off_line(edges[k]), w = off_line(rest);
      const double length = arith::dot(e, e);
      double next = length > 0 ? std::clamp(-arith::dot(e, w) / length, 0.0, 1.0) : 0;
      if (is_ray && foot(rest + edges[k] * next) == 0) {  // nearest to the origin, then
        const double whole = arith::dot(edges[k], edges[k]);
        next = whole > 0 ? std::clamp(-arith::dot(edges[k], rest) / whole, 0.0, 1.0) : 0;
      }
      change = std::fmax(change, std::fabs(next - g.s[k]));
      g.s[k] = next;
    }
    if (change < settled_on_edge) break;
  }
  g.t = foot(at());
  return g;
}

/// Are all vertices beyond the origin along n, by more than the radius times |n|?
bool all_beyond(std::span<const Vertex> vertices, const Vertex& origin, const Vertex& n, Running radius) {
  const Running square = radius * radius * arith::dot(n, n);
  for (const Vertex& v : vertices) {
    const Running along = arith::dot(n, v - origin);
    if (!(along.lower() > 0)) return false;
    const Unsure<Sign> s = (along * along - square).sign();
    if (!s.certain() || s.value() != Sign::positive) return false;
  }
  return true;
}

/// The core is all sums of the corner and parts of the edges.
template <class Round, std::size_t N>
std::optional<Sign> line_gap(const Round& round, const Point3& corner, const std::array<Vertex, N>& edges,
                             const Point3& origin, const Vector3& direction, bool is_ray) {
  std::array<Plain, N> e;
  for (std::size_t k = 0; k < N; ++k) e[k] = plain(edges[k]);
  const Guess<N> g =
      guess(arith::vec<double>(corner), e, arith::vec<double>(origin), arith::vec<double>(direction), is_ray);
  const Vertex d = vertex(direction), o = vertex(origin), c = vertex(corner);
  Vertex way = c - o - d * Running(g.t);
  for (std::size_t k = 0; k < N; ++k) way = way + edges[k] * Running(g.s[k]);
  const Running r(round.radius);
  const Unsure<Sign> near = (arith::dot(way, way) - r * r).sign();
  if (!near.certain() || near.value() == Sign::zero) return {};
  if (near.value() == Sign::negative) return near.value();
  const auto vertices = query::vertices(round);
  const Plain w = plain(way);
  if (is_ray && g.t == 0) {
    const Vertex n = arith::vec<Running>(w);
    return arith::dot(n, d).upper() <= 0 && all_beyond(vertices, o, n, r) ? std::optional(Sign::positive)
                                                                          : std::nullopt;
  }
  const Vertex n = arith::cross(
      d, arith::vec<Running>(arith::cross(w, arith::vec<double>(direction))));  // at right angles to the line
  return all_beyond(vertices, o, n, r) ? std::optional(Sign::positive) : std::nullopt;
}

template <class Line, class Round>
std::optional<Sign> quick_line(const Line& line, const Round& s) {
  constexpr bool is_ray = std::is_same_v<Line, Ray3>;
  const auto& [start, direction] = line;
  if constexpr (std::is_same_v<Round, Capsule3>) {
    return line_gap(s, s.a, std::array{vertex(s.b) - vertex(s.a)}, start, direction, is_ray);
  } else {
    return line_gap(s, s.corner, std::array{vertex(s.edges[0]), vertex(s.edges[1])}, start, direction, is_ray);
  }
}

template <class Line, class Round>
Relation relate_line_round(const Line& line, const Round& round, Question question) {
  if (is_sound(line) && is_sound(round)) [[likely]] {
    if (const auto gap = quick_line(line, round)) [[likely]]
      return static_cast<Relation>(-*gap);
  }
  require_figures(question, line, round);
  return relate_swept(core_of(round), round.radius, flat_set(line));
}

}  // namespace

PLUMB_PAIR_ANSWERS_TO(Capsule3, relate_line_round, Line3, Ray3)
PLUMB_PAIR_ANSWERS_TO(Lozenge3, relate_line_round, Line3, Ray3)

}  // namespace query
}  // namespace plumb
