#include "figure/hull/model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "figure/hull/local_points.hpp"

namespace plumb::figure::frame {
namespace {

// Newell's sum over the corners.
Vector3 normal_of(std::span<const std::uint32_t> face, const std::vector<Vector3>& vertices) {
  Vector3 sum{0, 0, 0};
  const Vector3& start = vertices[face[0]];
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum = plus(sum, cross(minus(vertices[face[i]], start), minus(vertices[face[i + 1]], start)));
  }
  return unit(sum);
}

}  // namespace

HullModel::HullModel(const Hull3& hull, std::span<const Point3> points) : corners(hull.corners), first(hull.first) {
  std::vector<Point3> kept;
  kept.reserve(hull.vertices.size());
  for (const std::uint32_t v : hull.vertices) kept.push_back(points[v]);
  vertices = localized(kept);
  for (std::uint32_t& c : corners) {
    c = static_cast<std::uint32_t>(std::ranges::lower_bound(hull.vertices, c) - hull.vertices.begin());
  }
  struct Half {
    std::uint64_t ends;  // the smaller one first
    std::uint32_t face;
    bool upward;
  };
  std::vector<Half> halves;
  halves.reserve(corners.size());
  normals.reserve(hull.face_count());
  for (std::uint32_t f = 0; f + 1 < first.size(); ++f) {
    const auto face = std::span(corners).subspan(first[f], first[f + 1] - first[f]);
    normals.push_back(normal_of(face, vertices));
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint64_t a = face[i], b = face[i + 1 == face.size() ? 0 : i + 1];
      halves.push_back({a < b ? a << 32 | b : b << 32 | a, f, a < b});
    }
  }
  std::ranges::sort(
      halves, [](const Half& a, const Half& b) { return a.ends != b.ends ? a.ends < b.ends : a.upward && !b.upward; });
  first_neighbor.assign(vertices.size() + 1, 0);
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
    const auto from = static_cast<std::uint32_t>(halves[i].ends >> 32);
    const auto to = static_cast<std::uint32_t>(halves[i].ends);
    edges.push_back({from, to, halves[i].face, halves[i + 1].face});
    ++first_neighbor[from + 1];
    ++first_neighbor[to + 1];
  }
  std::partial_sum(first_neighbor.begin(), first_neighbor.end(), first_neighbor.begin());
  neighbors.resize(first_neighbor.back());
  std::vector<std::uint32_t> end(first_neighbor.begin(), first_neighbor.end() - 1);
  for (const Edge& e : edges) {
    neighbors[end[e.from]++] = e.to;
    neighbors[end[e.to]++] = e.from;
  }
}

std::uint32_t HullModel::beyond_plateau(std::uint32_t v, const Vector3& d) const {
  constexpr std::size_t widest = 64;  // a guess of what pays
  const double most = dot(vertices[v], d);
  std::vector<std::uint32_t> plateau{v};
  for (std::size_t at = 0; at < plateau.size(); ++at) {
    const std::uint32_t from = plateau[at];
    for (std::uint32_t i = first_neighbor[from]; i < first_neighbor[from + 1]; ++i) {
      const std::uint32_t next = neighbors[i];
      const double far = dot(vertices[next], d);
      if (far > most) return next;
      if (far > most - level && plateau.size() < widest && std::ranges::find(plateau, next) == plateau.end())
        plateau.push_back(next);
    }
  }
  return v;
}

namespace {

constexpr int cells = 24;  // along each side of a face of the cube of directions

}  // namespace

std::size_t ClimbStarts::cell(const Vector3& d) {
  const double x = std::fabs(d.x), y = std::fabs(d.y), z = std::fabs(d.z);
  std::size_t side = 0;
  double u = d.y, v = d.z, w = d.x;
  if (y > x && y >= z) {
    side = 2, u = d.z, v = d.x, w = d.y;
  } else if (z > x) {
    side = 4, u = d.x, v = d.y, w = d.z;
  }
  if (w < 0) ++side;
  const double scale = cells * 0.5 / (std::fabs(w) > 0 ? std::fabs(w) : 1);
  const auto index = [&](double t) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(t * scale + cells * 0.5), 0, cells - 1));
  };
  return (side * cells + index(u)) * cells + index(v);
}

ClimbStarts::ClimbStarts(const HullModel& model) : model_(model), start_(6 * cells * cells) {
  std::uint32_t last = 0;
  for (std::size_t side = 0; side < 6; ++side) {
    for (int i = 0; i < cells; ++i) {
      for (int k = 0; k < cells; ++k) {
        const int j = i % 2 == 0 ? k : cells - 1 - k;  // to and fro: each is a neighbor of the one before
        const double u = (i + 0.5) / (cells * 0.5) - 1, v = (j + 0.5) / (cells * 0.5) - 1;
        const double w = side % 2 == 0 ? 1 : -1;
        const Vector3 d = side < 2 ? Vector3{w, u, v} : side < 4 ? Vector3{v, w, u} : Vector3{u, v, w};
        last = model.climb(last, d);
        start_[(side * cells + static_cast<std::size_t>(i)) * cells + static_cast<std::size_t>(j)] = last;
      }
    }
  }
}

}  // namespace plumb::figure::frame
