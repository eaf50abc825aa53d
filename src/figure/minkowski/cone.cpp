#include "figure/minkowski/cone.hpp"

#include <algorithm>

#include "figure/minkowski/edges.hpp"

namespace plumb::figure::minkowski {
namespace {

/// The triple product of three edges.
struct EdgesTriple {
  static constexpr std::string_view name = "minkowski_sum";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return predicates::det3(p[3] - p[0], p[4] - p[1], p[5] - p[2],    //
                            p[9] - p[6], p[10] - p[7], p[11] - p[8],  //
                            p[15] - p[12], p[16] - p[13], p[17] - p[14]);
  }
};

Sign triple(const Edge& a, const Edge& b, const Edge& c) {
  return sign_of(EdgesTriple{}, a.from, a.to, b.from, b.to, c.from, c.to);
}

// In the planes xy, yz, zx.
using Axis = double Point3::*;
constexpr std::array<std::array<Axis, 2>, 3> planes{
    {{&Point3::x, &Point3::y}, {&Point3::y, &Point3::z}, {&Point3::z, &Point3::x}}};

Sign cross(const Edge& a, const Edge& b, const std::array<Axis, 2>& plane) {
  const auto in = [&](const Point3& p) { return Point2{p.*plane[0], p.*plane[1]}; };
  return sign_of(EdgesTurn{}, in(a.from), in(a.to), in(b.from), in(b.to));
}

bool parallel(const Edge& a, const Edge& b) {
  return std::ranges::all_of(planes, [&](const auto& plane) { return cross(a, b, plane) == Sign::zero; });
}

/// Of edges in one half plane, whose boundary is the edge `base`: is b farther from it than a?  Zero for parallel ones.
Sign farther(const Edge& base, const Edge& a, const Edge& b) {
  for (const auto& plane : planes) {
    if (const Sign s = cross(base, b, plane); s != Sign::zero) return s * cross(a, b, plane);
  }
  return Sign::zero;
}

bool is_vertical(const Edge& e) { return e.from.x == e.to.x && e.from.y == e.to.y; }

/// Of ascending edges one that is extreme: the first clockwise, seen from above; of those in one vertical plane the
/// least steep.
std::size_t any_extreme(const std::vector<Edge>& edges) {
  std::size_t best = 0;
  const auto better = [](const Edge& a, const Edge& b) {
    if (is_vertical(a) || is_vertical(b)) return !is_vertical(a) && is_vertical(b);
    if (const Sign s = cross(a, b, planes[0]); s != Sign::zero) return s == Sign::positive;
    // The rise of both over the axis along which their plane extends, which ascends or, for y, does where x stays.
    const bool along_x = a.from.x != a.to.x;
    return along_x ? cross(a, b, planes[2]) == Sign::negative : cross(a, b, planes[1]) == Sign::positive;
  };
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (better(edges[i], edges[best])) best = i;
  }
  return best;
}

void merge(Edge& into, const Edge& parallel_one) {
  if (parallel_one.to_a) into.to_a = parallel_one.to_a;
  if (parallel_one.to_b) into.to_b = parallel_one.to_b;
}

}  // namespace

Cone cone(const std::vector<Edge>& edges, std::optional<std::size_t> extreme) {
  if (edges.empty()) return {};
  Edge first = edges[extreme ? *extreme : any_extreme(edges)];
  const Edge base = first;
  std::vector<Edge> others;
  for (const Edge& e : edges) {
    if (parallel(base, e)) {
      merge(first, e);
    } else {
      others.push_back(e);
    }
  }
  std::ranges::sort(others, [&](const Edge& a, const Edge& b) { return triple(base, a, b) == Sign::positive; });
  Cone chain{first};
  for (std::size_t i = 0; i < others.size();) {
    // Of those in one half plane beside the first edge the farthest counts.
    Edge far = others[i];
    for (++i; i < others.size() && triple(base, far, others[i]) == Sign::zero; ++i) {
      const Sign s = farther(base, far, others[i]);
      if (s == Sign::positive) far = others[i];
      if (s == Sign::zero) merge(far, others[i]);
    }
    while (chain.size() >= 2 && triple(chain[chain.size() - 2], chain.back(), far) != Sign::positive) chain.pop_back();
    chain.push_back(far);
  }
  return chain;
}

bool turns_left(const Edge& a, const Edge& b) {
  for (const auto& plane : planes) {
    if (const Sign s = cross(a, b, plane); s != Sign::zero) return s == Sign::positive;
  }
  return false;
}

}  // namespace plumb::figure::minkowski
