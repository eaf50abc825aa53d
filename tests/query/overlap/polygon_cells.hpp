// What convex cells is a polygon made of?  Trapezoids and walls inside, its edges apart, in rationals.
//
// The chains are cut by a vertical line through every vertex and every crossing.  Between two neighboring lines the
// edges are in order, and every other gap that an odd number of edges lies below is inside; on a line the gaps beside
// such trapezoids are inside as well.  Chains on one line leave the union of their edges, whose inside is that of the
// set on the line.
// Laws: exact; cells are relatively open, and each inner point is in one.
// Cost: cubic.
#pragma once

#include <set>

#include "query/overlap/rational_relation.hpp"

namespace plumb::oracle {

using RationalChains = std::vector<std::vector<RationalPoint>>;

template <class Polygon>
RationalChains chains_of(const Polygon& s) {
  RationalChains chains;
  const auto add = [&](const auto& vertices) {
    chains.emplace_back();
    for (const auto& p : vertices) chains.back().push_back(rational(p));
  };
  if constexpr (requires { s.outer; }) {
    add(s.outer.vertices);
    for (const auto& hole : s.holes) add(hole.vertices);
  } else if constexpr (requires { s.vertices; }) {
    add(s.vertices);
  } else {
    add(std::array{s.a, s.b, s.c, s.d});
  }
  return chains;
}

struct PolygonCells {
  std::vector<Spanned> inner, boundary;
};

namespace polygon_detail {

using Edge = std::array<RationalPoint, 2>;

inline RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalPoint blend(const RationalPoint& a, const RationalPoint& b, const mpq_class& t) {
  RationalPoint p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] + t * (b[k] - a[k]);
  return p;
}
inline RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline bool is_zero(const RationalPoint& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

inline PolygonCells on_line(const std::vector<Edge>& edges, const RationalPoint& from, const RationalPoint& way) {
  std::size_t k = 0;
  while (way[k] == 0) ++k;
  const auto place = [&](const RationalPoint& p) { return mpq_class((p[k] - from[k]) / way[k]); };
  const auto at = [&](const mpq_class& t) {
    RationalPoint p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = from[i] + t * way[i];
    return p;
  };
  std::set<mpq_class> places;
  for (const auto& [a, b] : edges) places.insert({place(a), place(b)});
  const auto covered = [&](const mpq_class& t) {
    return std::ranges::any_of(edges, [&](const Edge& e) {
      const mpq_class a = place(e[0]), b = place(e[1]);
      return std::min(a, b) <= t && t <= std::max(a, b);
    });
  };
  PolygonCells cells;
  bool before = false;
  for (auto t = places.begin(); t != places.end(); ++t) {
    const auto next = std::next(t);
    const bool after = next != places.end() && covered((*t + *next) / 2);
    (before && after ? cells.inner : cells.boundary).push_back({{at(*t)}, {}});
    if (after) cells.inner.push_back({{at(*t), at(*next)}, {}});
    before = after;
  }
  return cells;
}

/// x and y of the plane's points are two coordinates in which it is not a line.
inline PolygonCells in_plane(const std::vector<Edge>& edges, std::size_t x, std::size_t y) {
  PolygonCells cells;
  for (const auto& [a, b] : edges) cells.boundary.push_back({{a, b}, {}});
  std::set<mpq_class> lines;
  for (const auto& [a, b] : edges) {
    lines.insert({a[x], b[x]});
    for (const auto& [c, d] : edges) {
      const mpq_class ux = b[x] - a[x], uy = b[y] - a[y], vx = d[x] - c[x], vy = d[y] - c[y];
      const mpq_class turn = ux * vy - uy * vx;
      if (turn == 0) continue;
      const mpq_class s = ((c[x] - a[x]) * vy - (c[y] - a[y]) * vx) / turn;
      const mpq_class t = ((c[x] - a[x]) * uy - (c[y] - a[y]) * ux) / turn;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) lines.insert(a[x] + s * ux);
    }
  }
  const auto on = [&](const Edge& e, const mpq_class& at) {
    return blend(e[0], e[1], (at - e[0][x]) / (e[1][x] - e[0][x]));
  };
  // The gaps beside a line that are inside: from the lower end to the upper one.
  const auto gaps = [&](const mpq_class& left, const mpq_class& right, const mpq_class& line) {
    const mpq_class middle = (left + right) / 2;
    std::vector<std::pair<mpq_class, Edge>> across;
    for (const Edge& e : edges) {
      if (std::min(e[0][x], e[1][x]) < middle && middle < std::max(e[0][x], e[1][x]))
        across.emplace_back(on(e, middle)[y], e);
    }
    std::ranges::sort(across, {}, [](const auto& c) { return c.first; });
    std::vector<Edge> inside;
    for (std::size_t i = 0; i + 1 < across.size(); i += 2) {
      if (across[i].first != across[i + 1].first)
        inside.push_back({on(across[i].second, line), on(across[i + 1].second, line)});
    }
    return inside;
  };
  for (auto line = lines.begin(); line != lines.end(); ++line) {
    std::vector<Edge> beside;
    if (line != lines.begin()) beside = gaps(*std::prev(line), *line, *line);
    if (const auto next = std::next(line); next != lines.end()) {
      const auto here = gaps(*line, *next, *line), there = gaps(*line, *next, *next);
      for (std::size_t i = 0; i < here.size(); ++i)
        cells.inner.push_back({{here[i][0], here[i][1], there[i][0], there[i][1]}, {}});
      beside.insert(beside.end(), here.begin(), here.end());
    }
    // Walls: between what the chains have on the line.
    std::set<mpq_class> stops;
    for (const Edge& e : edges) {
      if (e[0][x] == *line) stops.insert(e[0][y]);
      if (e[1][x] == *line) stops.insert(e[1][y]);
      if (e[0][x] != e[1][x] && std::min(e[0][x], e[1][x]) <= *line && *line <= std::max(e[0][x], e[1][x]))
        stops.insert(on(e, *line)[y]);
    }
    for (auto stop = stops.begin(); stop != stops.end() && std::next(stop) != stops.end(); ++stop) {
      const mpq_class middle = (*stop + *std::next(stop)) / 2;
      const bool on_chain = std::ranges::any_of(edges, [&](const Edge& e) {
        return e[0][x] == *line && e[1][x] == *line && std::min(e[0][y], e[1][y]) <= middle &&
               middle <= std::max(e[0][y], e[1][y]);
      });
      const auto gap =
          std::ranges::find_if(beside, [&](const Edge& g) { return g[0][y] < middle && middle < g[1][y]; });
      if (on_chain || gap == beside.end()) continue;
      const auto& [low, high] = *gap;
      const mpq_class height = high[y] - low[y];
      cells.inner.push_back(
          {{blend(low, high, (*stop - low[y]) / height), blend(low, high, (*std::next(stop) - low[y]) / height)}, {}});
    }
  }
  return cells;
}

}  // namespace polygon_detail

inline PolygonCells polygon_cells(const RationalChains& chains) {
  using namespace polygon_detail;
  std::vector<Edge> edges;
  for (const auto& chain : chains) {
    for (std::size_t i = 0; i < chain.size(); ++i) edges.push_back({chain[i], chain[(i + 1) % chain.size()]});
  }
  const RationalPoint from = edges[0][0];
  RationalPoint way{0, 0, 0}, normal{0, 0, 0};
  for (const auto& [a, b] : edges) {
    if (is_zero(way)) way = minus(a, from);
    if (is_zero(normal)) normal = cross(way, minus(a, from));
  }
  if (is_zero(way)) return {{{{from}, {}}}, {}};
  if (is_zero(normal)) return on_line(edges, from, way);
  const std::size_t dropped = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
  return in_plane(edges, (dropped + 1) % 3, (dropped + 2) % 3);
}

}  // namespace plumb::oracle
