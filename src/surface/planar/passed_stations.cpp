#include "surface/planar/passed_stations.hpp"

#include <algorithm>
#include <unordered_map>

namespace plumb::surface {

PassedStations::PassedStations(const GivenPoints& points, const std::vector<Station>& stations,
                               std::vector<StationTriangle>& triangles)
    : points_(points), stations_(stations), triangles_(triangles), about_(stations.size()), dead_(triangles.size()) {
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) note(i);
}

void PassedStations::note(std::uint32_t triangle) {
  for (const std::uint32_t s : triangles_[triangle])
    if (stations_[s].corner == none) about_[s].push_back(triangle);
}

void PassedStations::add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  triangles_.push_back({a, b, c});
  dead_.push_back(false);
  note(static_cast<std::uint32_t>(triangles_.size() - 1));
}

// Lists the stations around one, counterclockwise: from the one that the path reaches next to the one before.
std::vector<std::uint32_t> PassedStations::chain_about(std::uint32_t passed) {
  std::unordered_map<std::uint32_t, std::uint32_t> over;
  std::unordered_map<std::uint32_t, int> reached;
  for (const std::uint32_t i : about_[passed]) {
    if (dead_[i]) continue;
    dead_[i] = true;
    const StationTriangle& t = triangles_[i];
    const std::size_t k = t[0] == passed ? 0 : t[1] == passed ? 1 : 2;
    over[t[(k + 1) % 3]] = t[(k + 2) % 3];
    ++reached[t[(k + 2) % 3]];
  }
  std::vector<std::uint32_t> chain;
  for (const auto& [from, to] : over)
    if (reached.find(from) == reached.end()) chain.push_back(from);
  if (chain.size() != 1) return {};
  while (chain.size() <= over.size()) {
    const auto to = over.find(chain.back());
    if (to == over.end()) return {};
    chain.push_back(to->second);
  }
  return chain;
}

bool PassedStations::take_out(std::uint32_t passed) {
  const std::vector<std::uint32_t> chain = chain_about(passed);
  if (chain.size() < 2) return false;
  const auto vertex = [&](std::uint32_t s) { return stations_[s].vertex; };
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t now : chain) {
    while (kept.size() > 1) {
      const std::uint32_t before = kept[kept.size() - 2], tip = kept.back();
      if (points_.orient(vertex(before), vertex(tip), vertex(now)) != Sign::positive) break;
      add(before, tip, now);
      kept.pop_back();
    }
    kept.push_back(now);
  }
  for (std::size_t k = 1; k + 1 < kept.size(); ++k) add(kept[0], kept[k], kept[k + 1]);  // on the edge, without area
  return true;
}

bool PassedStations::take_out() {
  for (std::uint32_t s = 0; s < stations_.size(); ++s)
    if (stations_[s].corner == none && !take_out(s)) return false;
  std::size_t alive = 0;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    if (!dead_[i]) triangles_[alive++] = triangles_[i];
  triangles_.resize(alive);
  return true;
}

}  // namespace plumb::surface
