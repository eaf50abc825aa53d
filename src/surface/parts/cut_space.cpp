#include "surface/parts/cut_space.hpp"

#include <algorithm>
#include <numeric>

namespace plumb::surface {
namespace {

using query::operator-, query::operator*;

query::Exact3 exact_place_of(const Point3& p) { return {p.x, p.y, p.z}; }

int first_sign_of(const query::Exact3& v) {
  for (const mpq_class& x : v)
    if (sgn(x) != 0) return sgn(x);
  return 0;
}

}  // namespace

CutSpace::CutSpace(const TriangleMesh& mesh) : planes_at_(mesh.vertices.size()), turned_(mesh.triangles.size()) {
  points_.reserve(2 * mesh.vertices.size());
  for (const Point3& p : mesh.vertices) {
    points_.emplace_back(p);
    number_of_.emplace(points_.back(), static_cast<std::uint32_t>(points_.size() - 1));
  }
  std::vector<PlaneEntry> all;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const query::Exact3 from = exact_place_of(mesh.vertices[a]);
    const query::Exact3 normal = query::primitive(
        query::cross(exact_place_of(mesh.vertices[b]) - from, exact_place_of(mesh.vertices[c]) - from));
    turned_[t] = first_sign_of(normal) < 0 ? 1 : 0;
    const query::Exact3 up = mpq_class(turned_[t] != 0 ? -1 : 1) * normal;
    all.push_back({up, query::dot(up, from), turned_[t] != 0 ? std::array{a, c, b} : std::array{a, b, c}});
  }
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t t) { return std::tie(all[t].normal, all[t].offset); };
  std::ranges::stable_sort(order, [&](std::uint32_t s, std::uint32_t t) { return key(s) < key(t); });
  plane_of_.resize(all.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || key(order[i - 1]) != key(order[i])) planes_.push_back(all[order[i]]);
    plane_of_[order[i]] = static_cast<std::uint32_t>(planes_.size() - 1);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t])
      if (std::ranges::find(planes_at_[v], plane_of_[t]) == planes_at_[v].end()) planes_at_[v].push_back(plane_of_[t]);
  }
}

Sign CutSpace::side(std::uint32_t vertex, std::uint32_t plane) {
  auto& known = planes_at_[vertex];
  if (std::ranges::find(known, plane) != known.end()) return Sign::zero;
  const auto& [a, b, c] = planes_[plane].corners;
  const Sign below = orient3d(points_[a], points_[b], points_[c], points_[vertex]);
  if (below == Sign::zero) known.push_back(plane);
  return -below;
}

int CutSpace::bend(std::uint32_t plane, std::uint32_t other) {
  if (plane == other) return 0;
  if (plane > other) return -bend(other, plane);
  const auto [at, is_new] = bends_.try_emplace(std::uint64_t{plane} << 32 | other);
  if (is_new)
    at->second = static_cast<signed char>(first_sign_of(query::cross(planes_[plane].normal, planes_[other].normal)));
  return at->second;
}

std::array<Point3, 3> CutSpace::given(std::uint32_t plane) const {
  const auto& [a, b, c] = planes_[plane].corners;
  return {given_vertex(a), given_vertex(b), given_vertex(c)};
}

ExactPoint3 CutSpace::crossing(const CutLine& line, std::uint32_t plane) const {
  if (line.of_planes) return ThreePlanePoint3{given(line.first), given(line.second), given(plane)};
  const std::array<Point3, 3> of = given(plane);
  return LinePlanePoint3{given_vertex(line.first), given_vertex(line.second), of[0], of[1], of[2]};
}

std::uint32_t CutSpace::meet(const CutLine& line, std::uint32_t plane) {
  const ExactPoint3 point = crossing(line, plane);
  const auto [at, is_new] = number_of_.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
  if (is_new) {
    points_.push_back(point);
    planes_at_.emplace_back();
  }
  auto& known = planes_at_[at->second];
  const auto add = [&known](std::uint32_t p) {
    if (std::ranges::find(known, p) == known.end()) known.push_back(p);
  };
  add(plane);
  if (line.of_planes) add(line.first), add(line.second);
  return at->second;
}

}  // namespace plumb::surface
