#include "surface/planar/ring_stations.hpp"

namespace plumb::surface {

RingStations::RingStations(const Triangulator<GivenPoints>& made, std::uint32_t corners, bool backward)
    : made_(made), triangles_(made.triangles()), leaving_(made.points().size(), none), degree_(made.points().size()) {
  for (HalfEdge first = 0; first < triangles_.end(); first += 4) {
    for (HalfEdge e = first; e < first + 3; ++e) {
      if (triangles_.origin(e) == infinite) continue;
      leaving_[triangles_.origin(e)] = e;
      ++degree_[triangles_.origin(e)];
    }
  }
  const auto at = [&](std::uint32_t k) { return backward ? corners - 1 - k : k; };
  for (std::uint32_t k = 0; k < corners; ++k) add_edge(at(k), at(k + 1 == corners ? 0 : k + 1));
  const auto n = static_cast<std::uint32_t>(stations_.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    link(k, k + 1 == n ? 0 : k + 1);
    stations_[stations_[k].next].in = stations_[k].out;
  }
  gone_.assign(n, false);
}

void RingStations::link(std::uint32_t k, std::uint32_t n) {
  stations_[k].next = n;
  stations_[n].previous = k;
}

// Adds the stations from corner `from` on, before corner `to`.
void RingStations::add_edge(std::uint32_t from, std::uint32_t to) {
  const Vertex a = made_.vertex(from), b = made_.vertex(to);
  const auto add = [&](Vertex v, HalfEdge out) {
    stations_.push_back({v, v == a ? from : none, none, out, none, none});
  };
  if (a == b) return add(a, none);
  if (degree_[a] <= degree_[b]) {
    for (Vertex v = a; v != b; v = triangles_.target(stations_.back().out)) add(v, toward(v, b));
    return;
  }
  const std::size_t first = stations_.size();
  for (Vertex v = b; v != a; v = stations_.back().vertex) {
    const HalfEdge back = toward(v, a);
    add(triangles_.target(back), triangles_.twin(back));
  }
  std::reverse(stations_.begin() + static_cast<std::ptrdiff_t>(first), stations_.end());
}

HalfEdge RingStations::toward(Vertex a, Vertex b) const {
  const HalfEdge start = leaving_[a];
  HalfEdge e = start;
  do {
    if (triangles_.target(e) == b) return e;
    e = triangles_.turned(e);
  } while (e != start);
  const Sign way = made_.points().order(a, b);
  while (true) {
    const Vertex u = triangles_.target(e);
    if (u != infinite && triangles_.is_constrained(e) && made_.points().order(a, u) == way &&
        made_.points().orient(a, b, u) == Sign::zero)
      return e;
    e = triangles_.turned(e);
  }
}

// Cuts off stations from which the path goes back as it came, through the outside, or does not move at all.
void RingStations::cut_folds(std::span<const std::int32_t> windings, std::int32_t inside) {
  std::vector<std::uint32_t> pending(stations_.size());
  for (std::uint32_t k = 0; k < pending.size(); ++k) pending[k] = k;
  std::size_t left = stations_.size();
  while (!pending.empty()) {
    const std::uint32_t k = pending.back();
    pending.pop_back();
    if (gone_[k] || left <= 3) continue;
    const std::uint32_t p = stations_[k].previous, n = stations_[k].next;
    const HalfEdge in = stations_[k].in, out = stations_[k].out;
    const bool stays = in == none;  // the station before is at the same vertex
    if (!stays && (out == none || triangles_.twin(in) != out || windings[out / 4] == inside)) continue;
    gone_[k] = true;
    --left;
    flat_.push_back({p, k, n});
    link(p, n);
    stations_[p].out = stays ? out : none;
    stations_[n].in = stays ? out : none;
    pending.push_back(p);
    pending.push_back(n);
  }
}

bool RingStations::collect_sectors(std::span<const std::int32_t> windings, std::int32_t inside) {
  std::vector<std::uint32_t> comes_in(triangles_.end(), none);
  for (std::uint32_t k = 0; k < stations_.size(); ++k) {
    if (gone_[k]) continue;
    const HalfEdge in = stations_[k].in;
    if (in == none || comes_in[in] != none || windings[in / 4] != inside) return false;
    comes_in[in] = k;
  }
  sector_.assign(triangles_.end(), none);
  closing_.assign(stations_.size(), none);
  for (std::uint32_t k = 0; k < stations_.size(); ++k) {
    if (gone_[k]) continue;
    HalfEdge e = stations_[k].out;
    do {
      sector_[e] = k;
      e = triangles_.turned(e);
    } while (comes_in[triangles_.twin(e)] == none);
    closing_[k] = comes_in[triangles_.twin(e)];
  }
  return true;
}

// Stations k1, k2, ... of which each closes the sector of the one before become corners of a ring each.
void RingStations::divide_pinches() {
  for (std::uint32_t k = 0; k < stations_.size(); ++k) {
    if (gone_[k] || closing_[k] == k || closing_[k] == none) continue;
    std::vector<std::uint32_t> pinched;
    for (std::uint32_t s = k; closing_[s] != none;) {
      pinched.push_back(s);
      s = std::exchange(closing_[s], none);
    }
    std::vector<std::uint32_t> last;
    for (const std::uint32_t s : pinched) last.push_back(stations_[s].previous);
    for (std::size_t j = 0; j < pinched.size(); ++j) {
      const std::size_t after = j + 1 == pinched.size() ? 0 : j + 1;
      flat_.push_back({last[after], pinched[after], pinched[j]});
      link(last[after], pinched[j]);
      if (j >= 1 && after != 0) flat_.push_back({pinched[0], pinched[j], pinched[after]});
    }
  }
}

bool RingStations::divide(std::span<const std::int32_t> windings, std::int32_t inside) {
  cut_folds(windings, inside);
  if (!collect_sectors(windings, inside)) return false;
  divide_pinches();
  return true;
}

}  // namespace plumb::surface
