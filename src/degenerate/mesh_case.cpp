#include "degenerate/mesh_case.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace plumb::degenerate {

MeshCase mesh_of(const Field& points, const Field& triangles, std::span<const double> numbers) {
  MeshCase mesh;
  for (std::size_t i = points.first; i < points.first + points.size(); i += 3) {
    mesh.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  for (std::size_t i = triangles.first; i < triangles.first + triangles.size(); i += 3) {
    std::array<std::size_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = static_cast<std::size_t>(numbers[i + k]);
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

Numbers with_mesh(std::span<const double> numbers, const Field& points, const Field& triangles, const MeshCase& mesh) {
  const std::span<const double> before = numbers.first(points.first - 1);
  const std::span<const double> after = numbers.subspan(triangles.first + triangles.size());
  Numbers changed(before.begin(), before.end());
  changed.push_back(static_cast<double>(mesh.points.size()));
  for (const auto& p : mesh.points) changed.insert(changed.end(), p.begin(), p.end());
  changed.push_back(static_cast<double>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (const std::size_t i : t) changed.push_back(static_cast<double>(i));
  }
  changed.insert(changed.end(), after.begin(), after.end());
  return changed;
}

std::vector<std::size_t> places_of(const MeshCase& mesh) {
  std::vector<std::size_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return mesh.points[i]; });
  std::vector<std::size_t> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && mesh.points[order[i]] == mesh.points[order[i - 1]];
    places[order[i]] = again ? places[order[i - 1]] : order[i];
  }
  return places;
}

std::vector<OpenEdge> open_edges(const MeshCase& mesh) {
  const std::vector<std::size_t> places = places_of(mesh);
  std::vector<OpenEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = places[t[k]], to = places[t[(k + 1) % 3]];
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  }
  const auto ends = [](const OpenEdge& e) { return std::pair(e.from, e.to); };
  std::ranges::sort(edges, {}, ends);
  std::vector<OpenEdge> open;
  for (std::size_t i = 0; i < edges.size();) {
    OpenEdge sum = edges[i];
    for (++i; i < edges.size() && ends(edges[i]) == ends(sum); ++i) sum.times += edges[i].times;
    if (sum.times < 0) sum = {sum.to, sum.from, -sum.times};
    if (sum.times != 0) open.push_back(sum);
  }
  return open;
}

bool is_closed(const MeshCase& mesh) { return open_edges(mesh).empty(); }

std::vector<std::array<std::size_t, 3>> odd_triangles(const MeshCase& mesh) {
  const std::vector<std::size_t> places = places_of(mesh);
  std::map<std::array<std::size_t, 3>, std::array<std::size_t, 3>> odd;  // by places, ascending
  for (const auto& t : mesh.triangles) {
    std::array<std::size_t, 3> p{places[t[0]], places[t[1]], places[t[2]]};
    std::ranges::sort(p);
    if (p[0] == p[1] || p[1] == p[2]) continue;
    if (const auto [at, fresh] = odd.try_emplace(p, t); !fresh) odd.erase(at);
  }
  std::vector<std::array<std::size_t, 3>> left;
  for (const auto& [p, t] : odd) left.push_back(t);
  return left;
}

}  // namespace plumb::degenerate
