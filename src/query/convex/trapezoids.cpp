#include "query/convex/trapezoids.hpp"

#include <algorithm>

namespace plumb::query {
namespace {

/// As seen along one axis.
struct SeenPoint {
  mpq_class right, up;
};
struct SeenEdge {
  SeenPoint from, to;  // from left to right, never upright
  [[nodiscard]] mpq_class up_at(const mpq_class& right) const {
    return from.up + (to.up - from.up) * (right - from.right) / (to.right - from.right);
  }
};

struct SeenPlane {
  Exact3 normal;
  mpq_class offset;
  std::size_t axis;

  SeenPlane(const Exact3& n, const Exact3& p)
      : normal(n),
        offset(dot(n, p)),
        axis(sgn(n[2]) != 0   ? 2
             : sgn(n[0]) != 0 ? 0
                              : 1) {}
  [[nodiscard]] SeenPoint seen(const Exact3& p) const { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }
  [[nodiscard]] Exact3 lifted(const mpq_class& right, const mpq_class& up) const {
    const std::size_t r = (axis + 1) % 3, u = (axis + 2) % 3;
    Exact3 p;
    p[r] = right, p[u] = up;
    p[axis] = (offset - normal[r] * right - normal[u] * up) / normal[axis];
    return p;
  }
};

/// Where the edges cross, from left to right.
void add_crossing_place(std::vector<mpq_class>& places, const SeenEdge& e, const SeenEdge& f) {
  const mpq_class least = std::max(e.from.right, f.from.right), most = std::min(e.to.right, f.to.right);
  if (least >= most) return;
  const mpq_class before = e.up_at(least) - f.up_at(least), after = e.up_at(most) - f.up_at(most);
  if (sgn(before) * sgn(after) >= 0) return;
  places.emplace_back(least + (most - least) * before / (before - after));
}

}  // namespace

std::optional<Exact3> normal_of(const ExactChains& chains) {
  const Exact3& from = chains[0][0];
  Exact3 along{0, 0, 0};
  for (const auto& chain : chains) {
    for (const Exact3& p : chain) {
      if (is_zero(along)) {
        along = p - from;
      } else if (Exact3 n = cross(along, p - from); !is_zero(n)) {
        return n;
      }
    }
  }
  return {};
}

std::vector<FlatSet> trapezoids(const ExactChains& chains) {
  const auto normal = normal_of(chains);
  if (!normal) return {};
  const SeenPlane plane(*normal, chains[0][0]);
  std::vector<SeenEdge> edges;
  std::vector<mpq_class> places;
  for (const auto& chain : chains) {
    SeenPoint from = plane.seen(chain.back());
    for (const Exact3& p : chain) {
      const SeenPoint to = plane.seen(p);
      places.push_back(to.right);
      if (from.right != to.right) edges.push_back(from.right < to.right ? SeenEdge{from, to} : SeenEdge{to, from});
      from = to;
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) add_crossing_place(places, edges[i], edges[j]);
  }
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<FlatSet> all;
  for (std::size_t k = 1; k < places.size(); ++k) {
    const mpq_class &left = places[k - 1], &right = places[k];
    std::vector<std::array<mpq_class, 2>> spans;  // of the edges across the slab, at its left and at its right
    for (const SeenEdge& e : edges) {
      if (e.from.right <= left && e.to.right >= right) spans.push_back({e.up_at(left), e.up_at(right)});
    }
    std::ranges::sort(spans);  // edges do not cross here, so that one order is that of both sides
    for (std::size_t i = 0; i + 1 < spans.size(); i += 2) {
      const auto &low = spans[i], &high = spans[i + 1];
      if (low == high) continue;
      all.push_back({{plane.lifted(left, low[0]), plane.lifted(left, high[0]), plane.lifted(right, low[1]),
                      plane.lifted(right, high[1])},
                     {},
                     {}});
    }
  }
  return all;
}

std::vector<FlatSet> edges_of(const ExactChains& chains) {
  std::vector<FlatSet> all;
  for (const auto& chain : chains) {
    const Exact3* from = &chain.back();
    for (const Exact3& p : chain) {
      all.push_back({{*from, p}, {}, {}});
      from = &p;
    }
  }
  return all;
}

std::vector<LinePiece> pieces_on_line(const ExactChains& chains) {
  std::vector<std::pair<Exact3, Exact3>> spans;  // of a chain, which is connected; ordered as coordinates are
  for (const auto& chain : chains) {
    const auto [first, last] = std::ranges::minmax_element(chain);
    spans.emplace_back(*first, *last);
  }
  std::ranges::sort(spans);
  std::vector<std::pair<Exact3, Exact3>> merged;
  for (const auto& span : spans) {
    if (merged.empty() || merged.back().second < span.first) {
      merged.push_back(span);
    } else if (merged.back().second < span.second) {
      merged.back().second = span.second;
    }
  }
  std::vector<LinePiece> pieces;
  for (const auto& [from, to] : merged) pieces.push_back({{{from, to}, {}, {}, {}}, merged.size() == 1 || from != to});
  return pieces;
}

}  // namespace plumb::query
