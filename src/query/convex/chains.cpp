#include "query/convex/chains.hpp"

namespace plumb::query {
namespace {

Exact3 exact_place(const Point2& p) { return {p.x, p.y, 0}; }
Exact3 exact_place(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Points>
void add_chain(SpannedChains& to, const Points& points) {
  const std::size_t first = to.vertices.size();
  for (const auto& p : points) {
    to.vertices.push_back(exact_place(p));
    to.next.push_back(to.vertices.size());
  }
  to.next.back() = first;
}

}  // namespace

std::vector<std::size_t> spanning(const std::vector<Exact3>& all) {
  std::vector<std::size_t> span{0};
  for (std::size_t i = 1; i < all.size() && span.size() < 3; ++i) {
    const Exact3 way = all[i] - all[0];
    if (is_zero(way) || (span.size() == 2 && is_zero(cross(way, all[span[1]] - all[0])))) continue;
    span.push_back(i);
  }
  return span;
}

SpannedChains chains_of(const FigureView& polygon) {
  SpannedChains chains;
  with_figure(polygon, [&](const auto& s) {
    if constexpr (requires { s.outer; }) {
      add_chain(chains, s.outer.vertices);
      for (const auto& hole : s.holes) add_chain(chains, hole.vertices);
    } else if constexpr (requires { s.vertices; }) {
      add_chain(chains, s.vertices);
    } else if constexpr (figure_kind<std::remove_cvref_t<decltype(s)>> == FigureKind::quadrilateral) {
      add_chain(chains, std::array{s.a, s.b, s.c, s.d});
    }
  });
  chains.span = spanning(chains.vertices);
  return chains;
}

bool holds_inside(const SpannedChains& chains, const Exact3& p) {
  const auto& [vertices, next, span] = chains;
  const Exact3 way = vertices[span[1]] - vertices[span[0]];
  const Exact3 normal = cross(way, vertices[span[2]] - vertices[span[0]]);
  bool odd = false;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Exact3 a = vertices[i] - p, b = vertices[next[i]] - p;
    const Exact3 turn = cross(a, b);
    if (is_zero(turn) && sgn(dot(a, b)) <= 0) return false;  // on the edge
    const bool from_below = sgn(dot(a, way)) < 0, to_below = sgn(dot(b, way)) < 0;
    if (from_below == to_below) continue;
    if (sgn(dot(turn, normal)) == (from_below ? 1 : -1)) odd = !odd;
  }
  return odd;
}

}  // namespace plumb::query
