#include "query/convex/chains.hpp"

#include "query/body/boundary.hpp"

namespace plumb::query {
namespace {

/// Hears of the boundary.
struct Chains {
  SpannedChains& to;
  void corner(const arith::Vec<mpq_class>& p) { to.vertices.push_back({p.x, p.y, p.z}); }
  void edge(std::uint32_t, std::uint32_t end, std::uint32_t) { to.next.push_back(end); }
  void face(std::span<const std::uint32_t>, std::uint32_t) {}
};

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
  with_figure(polygon, [&]<class Shape>(const Shape& s) {
    Chains told{chains};
    if constexpr (is_one_of(figure_kind<Shape>, polygon_kinds)) tell_boundary<mpq_class>(s, told);
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
