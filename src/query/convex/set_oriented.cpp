// Oriented boxes, and hulls of points that no doubles hold, as what bounds them: by integers.
#include <algorithm>

#include "plumb/certify/direction.hpp"
#include "query/body/boundary.hpp"
#include "query/convex/bound_value.hpp"
#include "query/convex/extreme_chain.hpp"
#include "query/convex/set_parts.hpp"

namespace plumb::query::meeting {
namespace {

using Numbers3 = Vec<BigDyadic, 3>;

Numbers3 cross(const Numbers3& a, const Numbers3& b) {
  return {det2(a[1], a[2], b[1], b[2]), det2(a[2], a[0], b[2], b[0]), det2(a[0], a[1], b[0], b[1])};
}
BigDyadic dot(const Numbers3& a, const Numbers3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Numbers3 operator-(const Numbers3& a, const Numbers3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
bool is_zero(const Numbers3& a) {
  return a[0].sign() == Sign::zero && a[1].sign() == Sign::zero && a[2].sign() == Sign::zero;
}
Sign compare(const Numbers3& a, const Numbers3& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const Sign s = (a[axis] - b[axis]).sign(); s != Sign::zero) return s;
  }
  return Sign::zero;
}
Numbers3 unit(std::size_t axis) {
  Numbers3 e{BigDyadic(0.0), BigDyadic(0.0), BigDyadic(0.0)};
  e[axis] = BigDyadic(1.0);
  return e;
}

/// side * gradient . (x - on) <= 0.
Bound<3> bound_at(const Numbers3& gradient, const Numbers3& on, int side) {
  Bound<3> bound{Bound<3>::Kind::given, side};
  bound.given = std::make_shared<const Given<3>>(Given<3>{gradient, dot(gradient, on)});
  return bound;
}

template <std::size_t N, class Box>
std::vector<Vec<BigDyadic, N>> corners_of(const Box& box) {
  std::vector<Vec<BigDyadic, N>> corners;
  for_each_corner<BigDyadic>(box, [&](const arith::Vec<BigDyadic>& p) {
    if constexpr (N == 2) {
      corners.push_back({p.x, p.y});
    } else {
      corners.push_back({p.x, p.y, p.z});
    }
  });
  return corners;
}

using Numbers2 = Vec<BigDyadic, 2>;

BigDyadic dot(const Numbers2& a, const Numbers2& b) { return a[0] * b[0] + a[1] * b[1]; }
Numbers2 operator-(const Numbers2& a, const Numbers2& b) { return {a[0] - b[0], a[1] - b[1]}; }
Sign compare(const Numbers2& a, const Numbers2& b) {
  const Sign s = (a[0] - b[0]).sign();
  return s == Sign::zero ? (a[1] - b[1]).sign() : s;
}
/// To the right.
Numbers2 across(const Numbers2& d) { return {d[1], BigDyadic() - d[0]}; }

/// side * gradient . (x - on) <= 0.
Bound<2> bound_at(const Numbers2& gradient, const Numbers2& on, int side) {
  Bound<2> bound{Bound<2>::Kind::given, side};
  bound.given = std::make_shared<const Given<2>>(Given<2>{gradient, dot(gradient, on)});
  return bound;
}

}  // namespace

ConvexSet<2> convex_set(const Obb2& box) {
  std::vector<Numbers2> corners = corners_of<2>(box);
  std::swap(corners[2], corners[3]);  // once around
  const Numbers2 d = corners[1] - corners[0], e = corners[3] - corners[0];
  const Sign turn = det2(d[0], d[1], e[0], e[1]).sign();
  ConvexSet<2> set;
  if (turn != Sign::zero) {
    set.dimension = 2;
    set.first_side = 0;
    for (int i = 0; i < 4; ++i) {
      const Numbers2 &from = corners[static_cast<std::size_t>(i)], &to = corners[static_cast<std::size_t>((i + 1) % 4)];
      set.edges.push_back({.from = i, .to = (i + 1) % 4});
      set.bounds.push_back(bound_at(across(to - from), from, static_cast<int>(turn)));
    }
    set.exact_vertices = std::move(corners);
    return set;
  }
  const auto [low, high] = std::minmax_element(
      corners.begin(), corners.end(), [](const auto& a, const auto& b) { return compare(a, b) == Sign::negative; });
  const Numbers2 first = *low, last = *high, along = last - first;
  const bool is_point = compare(first, last) == Sign::zero;
  set.dimension = is_point ? 0 : 1;
  set.exact_vertices = {first, last};
  set.edges = {{.from = 0, .to = is_point ? 0 : 1}};
  if (is_point) {
    const BigDyadic one(1.0), none(0.0);
    set.bounds = {bound_at({one, none}, first, 0), bound_at({none, one}, first, 0)};
  } else {
    set.bounds = {bound_at(across(along), first, 0), bound_at(along, first, -1), bound_at(along, last, 1)};
  }
  return set;
}

ConvexSet<3> convex_set(const Rectangle3& rectangle) { return flat_set(corners_of<3>(rectangle)); }

ConvexSet<3> flat_set(std::vector<Vec<BigDyadic, 3>> corners) {
  std::sort(corners.begin(), corners.end(),
            [](const Numbers3& a, const Numbers3& b) { return compare(a, b) == Sign::negative; });
  const auto equal = [](const Numbers3& a, const Numbers3& b) { return compare(a, b) == Sign::zero; };
  corners.erase(std::unique(corners.begin(), corners.end(), equal), corners.end());
  const Numbers3 &first = corners.front(), &last = corners.back();
  ConvexSet<3> set;
  Numbers3 normal = unit(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal = cross(last - first, corners[i] - first);
    if (!is_zero(normal)) break;
  }
  if (corners.size() < 3 || is_zero(normal)) {
    set.dimension = corners.size() == 1 ? 0 : 1;
    set.exact_vertices = {first, last};
    set.edges = {{.from = 0, .to = corners.size() == 1 ? 0 : 1}};
    const Numbers3 d = last - first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      set.bounds.push_back(bound_at(set.dimension == 0 ? unit(axis) : cross(d, unit(axis)), first, 0));
    }
    if (set.dimension == 1) {
      set.bounds.push_back(bound_at(d, first, -1));
      set.bounds.push_back(bound_at(d, last, 1));
    }
    return set;
  }
  set.dimension = 2;
  set.look = normal[2].sign() != Sign::zero ? 2 : normal[0].sign() != Sign::zero ? 0 : 1;
  set.bounds.push_back(bound_at(normal, first, 0));
  const Seen look = looks[static_cast<std::size_t>(set.look)];
  const std::size_t right = look.right, up = look.up;
  const auto left_of = [&](std::size_t i, std::size_t j, std::size_t k) {
    const Numbers3 &a = corners[i], &b = corners[j], &c = corners[k];
    return det2(b[right] - a[right], b[up] - a[up], c[right] - a[right], c[up] - a[up]).sign() == Sign::positive;
  };
  std::vector<Numbers3> chain;
  for (const std::size_t i : extreme_chain(corners.size(), left_of)) chain.push_back(corners[i]);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Numbers3 &a = chain[i], &b = chain[(i + 1) % chain.size()];
    Numbers3 outward{BigDyadic(0.0), BigDyadic(0.0), BigDyadic(0.0)};
    outward[right] = b[up] - a[up];
    outward[up] = a[right] - b[right];
    set.bounds.push_back(bound_at(outward, a, 1));
    set.edges.push_back({.from = static_cast<int>(i), .to = static_cast<int>((i + 1) % chain.size())});
  }
  set.exact_vertices = std::move(chain);
  return set;
}

ConvexSet<3> convex_set(const Obb3& box) {
  std::vector<Numbers3> corners = corners_of<3>(box);
  const std::array reach{corners[1] - corners[0], corners[2] - corners[0], corners[4] - corners[0]};
  const Sign turn = dot(reach[0], cross(reach[1], reach[2])).sign();
  if (turn == Sign::zero) return flat_set(std::move(corners));
  ConvexSet<3> set;
  set.dimension = 3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Numbers3 normal = cross(reach[(axis + 1) % 3], reach[(axis + 2) % 3]);
    set.bounds.push_back(bound_at(normal, corners[0], -static_cast<int>(turn)));
    set.bounds.push_back(bound_at(normal, corners[7], static_cast<int>(turn)));
    for (int k = 0; k < 8; ++k) {
      if ((k & 1 << axis) == 0) set.edges.push_back({.from = k, .to = k | 1 << axis});
    }
  }
  set.exact_vertices = std::move(corners);
  return set;
}

}  // namespace plumb::query::meeting
