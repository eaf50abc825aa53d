// Which points are the corners of their hull, as it is commonly computed in floating point?  Andrew's chains in the
// plane, in space one point after the other.
//
// An answer is a set of bits, one a point; of equal points the first stands for all.
// Laws: none for numbers that round: they are on trial, and decide nothing of ours.  In numbers that do not the answer
// is right for all points, flat and repeated ones included.  Determinants within the epsilon count as zero.
// Source: RTCD 3.9.1; Kallay 1981 (beneath and beyond).
// Cost: some n^2 operations for so few points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

inline constexpr std::size_t hull_points = 16, hull3_points = 12;

/// The least number first, of points in the order of their coordinates, none of them twice.  By insertion, as the
/// standard's sort does with so few, but compiled without what it keeps for many.
template <class Point>
std::vector<std::size_t> in_order(const Point* points, std::size_t count) {
  const auto before = [&](std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < points[i].size(); ++k) {
      if (points[i][k] != points[j][k]) return points[i][k] < points[j][k];
    }
    return i < j;
  };
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t at = i;
    for (; at > 0 && before(i, order[at - 1]); --at) order[at] = order[at - 1];
    order[at] = i;
  }
  const auto same = [&](std::size_t i, std::size_t j) { return points[i] == points[j]; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  return order;
}

template <class T, std::size_t N>
std::uint32_t corners_in_plane(const std::array<std::array<T, 2>, N>& p, const std::vector<std::size_t>& order,
                               const T& epsilon) {
  std::uint32_t corners = 0;
  std::vector<std::size_t> chain;
  const auto add = [&](std::size_t i) {
    const auto turns_left = [&] {
      const std::array<T, 2>&a = p[chain[chain.size() - 2]], &b = p[chain.back()], &c = p[i];
      return T((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) > epsilon;
    };
    while (chain.size() >= 2 && !turns_left()) chain.pop_back();
    chain.push_back(i);
  };
  const auto take = [&] {
    for (const std::size_t i : chain) corners |= std::uint32_t{1} << i;
    chain.clear();
  };
  std::for_each(order.begin(), order.end(), add);
  take();
  std::for_each(order.rbegin(), order.rend(), add);
  take();
  return corners;
}

struct HullInPlane {
  template <class T>
  double operator()(const std::array<T, 2 * hull_points>& q, T epsilon) const {
    std::array<std::array<T, 2>, hull_points> p;
    for (std::size_t i = 0; i < hull_points; ++i) p[i] = {q[2 * i], q[2 * i + 1]};
    return corners_in_plane(p, in_order(p.data(), hull_points), epsilon);
  }
};

struct HullInSpace {
  template <class T>
  double operator()(const std::array<T, 3 * hull3_points>& q, T epsilon) const {
    std::array<std::array<T, 3>, hull3_points> p;
    for (std::size_t i = 0; i < hull3_points; ++i) p[i] = {q[3 * i], q[3 * i + 1], q[3 * i + 2]};
    const std::vector<std::size_t> order = in_order(p.data(), hull3_points);
    const auto at = [&](std::size_t i) { return vec(q, i); };
    const auto differs = [&](const T& x) { return magnitude(x) > epsilon; };

    // A point, another, a third beside their line, a fourth beside their plane, in the order given.
    const std::size_t a = order.front(), b = order[order.size() > 1];
    std::size_t c = a, d = a, next = 2;
    Vec<T> n{};
    for (; next < order.size() && c == a; ++next) {
      n = cross(at(b) - at(a), at(order[next]) - at(a));
      if (differs(n.x) || differs(n.y) || differs(n.z)) c = order[next];
    }
    if (c == a) return (std::uint32_t{1} << a) | (std::uint32_t{1} << order.back());
    for (; next < order.size() && d == a; ++next) {
      if (differs(dot(n, at(order[next]) - at(a)))) d = order[next];
    }
    if (d == a) return corners_in_plane(seen_along(n, p), order, epsilon);

    std::vector<Face> faces{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
    if (dot(n, at(d) - at(a)) > 0) {
      for (Face& f : faces) std::swap(f[1], f[2]);
    }
    for (const std::size_t i : order) {
      if (i != a && i != b && i != c && i != d) add(i, faces, at, epsilon);
    }
    return corners_of(faces, at, differs);
  }

 private:
  using Face = std::array<std::size_t, 3>;  // counterclockwise seen from outside

  /// Without the coordinate along which the normal is longest.
  template <class T>
  static std::array<std::array<T, 2>, hull3_points> seen_along(const Vec<T>& n,
                                                               const std::array<std::array<T, 3>, hull3_points>& p) {
    const T x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
    const std::size_t along = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    std::array<std::array<T, 2>, hull3_points> flat;
    for (std::size_t i = 0; i < hull3_points; ++i) flat[i] = {p[i][along == 0 ? 1 : 0], p[i][along == 2 ? 1 : 2]};
    return flat;
  }

  template <class At>
  static auto normal(const Face& f, const At& at) {
    return cross(at(f[1]) - at(f[0]), at(f[2]) - at(f[0]));
  }

  /// The faces that the point sees give way to those that join it to their rim.
  template <class At, class T>
  static void add(std::size_t point, std::vector<Face>& faces, const At& at, const T& epsilon) {
    std::array<std::array<bool, hull3_points>, hull3_points> seen{};  // the edges of such faces
    const auto sees = [&](const Face& f) {
      if (!(dot(normal(f, at), at(point) - at(f[0])) > epsilon)) return false;
      for (std::size_t k = 0; k < 3; ++k) seen[f[k]][f[(k + 1) % 3]] = true;
      return true;
    };
    std::erase_if(faces, sees);
    for (std::size_t i = 0; i < hull3_points; ++i) {
      for (std::size_t j = 0; j < hull3_points; ++j) {
        if (seen[i][j] && !seen[j][i]) faces.push_back({i, j, point});
      }
    }
  }

  /// Those whose faces lie in three planes that meet nowhere else; within a flat side or an edge they do not.
  template <class At, class Differs>
  static std::uint32_t corners_of(const std::vector<Face>& faces, const At& at, const Differs& differs) {
    std::uint32_t corners = 0;
    for (std::size_t i = 0; i < hull3_points; ++i) {
      std::vector<decltype(at(0))> normals;
      for (const Face& f : faces) {
        if (std::ranges::find(f, i) != f.end()) normals.push_back(normal(f, at));
      }
      if (normals.empty()) continue;
      decltype(at(0)) line{};
      std::size_t next = 1;
      for (bool found = false; next < normals.size() && !found; ++next) {
        line = cross(normals[0], normals[next]);
        found = differs(line.x) || differs(line.y) || differs(line.z);
      }
      const bool corner = std::any_of(normals.begin() + static_cast<std::ptrdiff_t>(next), normals.end(),
                                      [&](const auto& n) { return differs(dot(n, line)); });
      if (corner) corners |= std::uint32_t{1} << i;
    }
    return corners;
  }
};

}  // namespace plumb::lab::trial
