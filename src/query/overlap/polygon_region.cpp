#include "query/overlap/polygon_region.hpp"

#include <algorithm>
#include <optional>

#include "query/convex/extreme_chain.hpp"

namespace plumb::query {
namespace {

int turn(const Exact2& a, const Exact2& b, const Exact2& p) { return sgn(cross(b - a, p - a)); }
Exact2 at(const Exact2& p, const mpq_class& t, const Exact2& d) {
  return {mpq_class(p[0] + t * d[0]), mpq_class(p[1] + t * d[1])};
}

/// Calls f(a, b) for all edges until it returns true.
template <class F>
bool any_edge(const Region& region, F f) {
  for (const auto& chain : region.chains) {
    const Exact2* a = &chain.back();
    for (const Exact2& b : chain) {
      if (f(*a, b)) return true;
      a = &b;
    }
  }
  return false;
}

bool apart(const mpq_class& a, const mpq_class& b, const mpq_class& c, const mpq_class& d) {
  return (a < c && a < d && b < c && b < d) || (a > c && a > d && b > c && b > d);
}
bool boxes_apart(const Exact2& a, const Exact2& b, const Exact2& c, const Exact2& d) {
  return apart(a[0], b[0], c[0], d[0]) || apart(a[1], b[1], c[1], d[1]);
}

bool on_edge(const Exact2& a, const Exact2& b, const Exact2& p) {
  return !boxes_apart(a, b, p, p) && turn(a, b, p) == 0;
}

bool edges_meet(const Exact2& a, const Exact2& b, const Exact2& c, const Exact2& d) {
  if (boxes_apart(a, b, c, d)) return false;
  if (a == b) return on_edge(c, d, a);
  if (c == d) return on_edge(a, b, c);
  return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;  // with boxes that meet
}

/// Is the region beside p, on the side that `way` points to?  No edge through p but those on one line, to which `way`
/// is at right angles.
bool is_beside(const Region& region, const Exact2& p, const Exact2& way) {
  bool odd = false;
  any_edge(region, [&](const Exact2& a, const Exact2& b) {
    const Exact2 from = a - p, to = b - p;
    const mpq_class left = cross(way, from), right = cross(way, to);
    if ((sgn(left) < 0) == (sgn(right) < 0)) return false;
    // The line through p meets the edge ahead of p where cross(from, to - from) has the sign of its crossing.
    const int ahead = sgn(cross(from, to)) * sgn(mpq_class(right - left));
    odd ^= ahead > 0;
    return false;
  });
  return odd;
}

/// Where on the line p + t d this edge or its ends along it lie.
void add_crossing(std::vector<mpq_class>& places, const Exact2& p, const Exact2& d, const Exact2& a, const Exact2& b) {
  const mpq_class left = cross(d, a - p), right = cross(d, b - p);
  if (sgn(left) * sgn(right) > 0) return;
  const mpq_class square = dot(d, d);
  if (sgn(left) == 0) places.emplace_back(dot(d, a - p) / square);
  if (sgn(right) == 0) places.emplace_back(dot(d, b - p) / square);
  if (sgn(left) * sgn(right) < 0) {
    const mpq_class s = left / (left - right);
    places.emplace_back(dot(d, at(a, s, b - a) - p) / square);
  }
}

void sort_places(std::vector<mpq_class>& places) {
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

/// Calls f(m) for a point between any two neighboring places until it returns true.
template <class F>
bool any_between(const std::vector<mpq_class>& places, const Exact2& p, const Exact2& d, F f) {
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (f(at(p, mpq_class((places[i - 1] + places[i]) / 2), d))) return true;
  }
  return false;
}

/// Do both lie on one side of some piece of an edge of `of`?
bool overlap_beside(const Region& of, const Region& a, const Region& b) {
  return any_edge(of, [&](const Exact2& p, const Exact2& q) {
    if (p == q) return false;
    const Exact2 d = q - p, left{mpq_class(-d[1]), d[0]}, right{d[1], mpq_class(-d[0])};
    std::vector<mpq_class> places{0, 1};
    for (const Region* region : {&a, &b}) {
      any_edge(*region, [&](const Exact2& c, const Exact2& e) {
        if (!boxes_apart(p, q, c, e)) add_crossing(places, p, d, c, e);
        return false;
      });
    }
    std::erase_if(places, [](const mpq_class& t) { return sgn(t) < 0 || t > 1; });
    sort_places(places);
    return any_between(places, p, d, [&](const Exact2& m) {
      return (is_beside(a, m, left) && is_beside(b, m, left)) || (is_beside(a, m, right) && is_beside(b, m, right));
    });
  });
}

bool holds_a_chain(const Region& a, const Region& b) {
  return std::ranges::any_of(b.chains, [&](const auto& chain) { return locate(a, chain[0]) != Location::outside; });
}

struct ChainBounds {
  Exact2 min, max;
};
ChainBounds box_of(const Region& region) {
  ChainBounds box{region.chains[0][0], region.chains[0][0]};
  any_edge(region, [&](const Exact2&, const Exact2& b) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (b[k] < box.min[k]) box.min[k] = b[k];
      if (b[k] > box.max[k]) box.max[k] = b[k];
    }
    return false;
  });
  return box;
}

}  // namespace

Location locate(const Region& region, const Exact2& p) {
  bool odd = false;
  const bool on_chain = any_edge(region, [&](const Exact2& a, const Exact2& b) {
    if (a[1] > p[1] && b[1] > p[1]) return false;
    if (a[1] < p[1] && b[1] < p[1]) return false;
    if (on_edge(a, b, p)) return true;
    if ((a[1] <= p[1]) != (b[1] <= p[1])) odd ^= (turn(a, b, p) > 0) == (a[1] < b[1]);
    return false;
  });
  return on_chain ? Location::boundary : odd ? Location::inside : Location::outside;
}

std::vector<mpq_class> crossings(const Region& region, const Exact2& p, const Exact2& d) {
  std::vector<mpq_class> places;
  any_edge(region, [&](const Exact2& a, const Exact2& b) {
    add_crossing(places, p, d, a, b);
    return false;
  });
  sort_places(places);
  return places;
}

Relation relate_segment(const Region& region, const Exact2& a, const Exact2& b) {
  if (a == b) return static_cast<Relation>(locate(region, a));
  const Exact2 d = b - a;
  std::vector<mpq_class> places = crossings(region, a, d);
  std::erase_if(places, [](const mpq_class& t) { return sgn(t) < 0 || t > 1; });
  const bool meets_chain = !places.empty();
  places.insert(places.begin(), 0);
  places.emplace_back(1);
  sort_places(places);
  if (any_between(places, a, d, [&](const Exact2& m) { return locate(region, m) == Location::inside; }))
    return Relation::overlapping;
  return meets_chain || locate(region, a) != Location::outside ? Relation::touching : Relation::disjoint;
}

Relation relate(const Region& a, const Region& b) {
  const ChainBounds p = box_of(a), q = box_of(b);
  if (boxes_apart(p.min, p.max, q.min, q.max)) return Relation::disjoint;
  if (overlap_beside(a, a, b) || overlap_beside(b, a, b)) return Relation::overlapping;
  const bool meet = holds_a_chain(a, b) || holds_a_chain(b, a) || any_edge(a, [&](const Exact2& c, const Exact2& d) {
                      return any_edge(b, [&](const Exact2& e, const Exact2& f) { return edges_meet(c, d, e, f); });
                    });
  return meet ? Relation::touching : Relation::disjoint;
}

std::vector<Exact2> convex_hull(std::vector<Exact2> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Exact2> hull;
  for (const std::size_t i : extreme_chain(points.size(), [&](std::size_t a, std::size_t b, std::size_t c) {
         return turn(points[a], points[b], points[c]) > 0;
       }))
    hull.push_back(points[i]);
  return hull;
}

}  // namespace plumb::query
