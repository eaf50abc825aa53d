// Where does a ray hit triangles, and is a point in what they bound, by plain rationals?  Of a case's numbers.
//
// A ray in a triangle's plane is clipped to the triangle; another one is asked for the place where it crosses it.  A
// point is inside where a ray that meets no edge crosses an odd number of triangles.
// Laws: exact for all finite doubles; nothing is shared with the library.
// Cost: microseconds a triangle that the bounds do not rule out.
#pragma once

#include "query/ray/oracle.hpp"

namespace plumb::mesh_oracle {

using exact::Coordinates, exact::dot, exact::Rational;

struct Corners {
  std::array<const double*, 3> at;

  [[nodiscard]] ray_oracle::Corners rational() const {
    const auto point = [](const double* p) { return exact::of(Point3{p[0], p[1], p[2]}); };
    return {point(at[0]), point(at[1]), point(at[2])};
  }
};

/// From the count of vertices on.
inline std::vector<Corners> triangles_of(std::span<const double> mesh) {
  std::vector<Corners> all;
  const std::size_t end = 1 + 3 * static_cast<std::size_t>(mesh[0]);
  const auto point = [&](double index) { return &mesh[1 + 3 * static_cast<std::size_t>(index)]; };
  for (std::size_t i = end + 1; i < mesh.size(); i += 3)
    all.push_back({{point(mesh[i]), point(mesh[i + 1]), point(mesh[i + 2])}});
  return all;
}

/// Of a line of the ray's direction d through the origin, and a triangle relative to it: on which side of each edge it
/// passes.
inline std::array<int, 3> sides(const Coordinates& d, const ray_oracle::Corners& t) {
  std::array<int, 3> all{};
  for (std::size_t k = 0; k < 3; ++k) all[k] = sgn(dot(d, ray_oracle::cross(t[k], t[(k + 1) % 3])));
  return all;
}

inline std::optional<Rational> first_hit(std::span<const double> q) {
  const ray_oracle::Path ray(Ray3{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}});
  std::optional<Rational> first;
  for (const Corners& corners : triangles_of(q.subspan(6))) {
    ray_oracle::Corners t = corners.rational();
    const ray_oracle::Corners absolute = t;
    for (Coordinates& c : t) c = exact::difference(c, ray.origin);
    const std::array<int, 3> side = sides(ray.direction, t);
    const bool left = std::ranges::count(side, 1) > 0, right = std::ranges::count(side, -1) > 0;
    if (left && right) continue;
    std::optional<Rational> at;
    if (left || right) {  // it crosses the plane, in the triangle
      const Coordinates n = ray_oracle::cross(exact::difference(t[1], t[0]), exact::difference(t[2], t[0]));
      at = dot(t[0], n) / dot(ray.direction, n);
    } else {
      at = ray_oracle::first(ray, absolute);
    }
    if (at && *at >= 0 && (!first || *at < *first)) first = at;
  }
  return first;
}

inline bool is_in(std::span<const double> q) {
  const std::vector<Corners> all = triangles_of(q.subspan(3));
  const Coordinates p = exact::of(Point3{q[0], q[1], q[2]});
  std::vector<ray_oracle::Corners> relative;
  for (const Corners& corners : all) {
    const auto reaches = [&](std::size_t k) {
      const auto [low, high] = std::minmax({corners.at[0][k], corners.at[1][k], corners.at[2][k]});
      return low <= q[k] && q[k] <= high;
    };
    if (reaches(0) && reaches(1) && reaches(2) && exact::in_hull(corners.rational(), p)) return true;
    relative.push_back(corners.rational());
    for (Coordinates& c : relative.back()) c = exact::difference(c, p);
  }
  for (long attempt = 1;; ++attempt) {
    const Coordinates d{Rational(1000), Rational(17 * attempt), Rational(attempt * attempt + 1)};
    bool inside = false, lucky = true;
    for (const ray_oracle::Corners& t : relative) {
      const Coordinates n = ray_oracle::cross(exact::difference(t[1], t[0]), exact::difference(t[2], t[0]));
      const Rational height = dot(t[0], n), rise = dot(d, n);
      if (height == 0) continue;  // beside the triangle, in its plane
      const std::array<int, 3> side = sides(d, t);
      lucky = lucky && rise != 0 && std::ranges::count(side, 0) == 0;
      if (rise != 0 && side[0] == side[1] && side[1] == side[2] && height / rise > 0) inside = !inside;
    }
    if (lucky) return inside;
  }
}

}  // namespace plumb::mesh_oracle
