// A guess in doubles, which holds no bound.
#include "query/penetration/guessed_surface.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::query::parting {
namespace {

using arith::Plain, arith::cross, arith::dot;

constexpr std::uint32_t nowhere = ~0U;
constexpr double level_within = 0x1p-40;  // a guess: what is no further beyond a plane lies in it
constexpr double as_near = 1 + 0x1p-19;   // a guess: what is as near may be a tie; of squares
constexpr double least_volume = 0x1p-30;  // a guess: what has no more volume than that has none

Plain plain_of(const std::array<GuessedSurface::Number, 3>& p) { return {p[0].value, p[1].value, p[2].value}; }
Plain normal_of(const GuessedSurface::Facet& f) {
  const auto& n = f.plane.normal;
  return {n[0].value, n[1].value, n[2].value};
}
bool sees(const Plain& at, const GuessedSurface::Facet& f) {
  return dot(normal_of(f), at) - f.plane.height.value > f.doubt;
}

/// The next corner of a triangle.
constexpr std::size_t after(std::size_t k) { return k == 2 ? 0 : k + 1; }

}  // namespace

GuessedSurface::GuessedSurface(const Difference& d) {
  is_sound_ = a_.set(d.a) && b_.set(d.b);
  points_.reserve(48), facets_.reserve(96), rank_.reserve(96);
  free_.reserve(64), seen_.reserve(64), horizon_.reserve(64);
}

void GuessedSurface::grow_from_far() {
  if (!is_sound_) return;
  constexpr std::array<Plain, 4> ways{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  for (const Plain& n : ways) {
    const Ends e = farthest(n, {0, 0});
    take(e);
    is_sound_ = is_sound_ && !(dot(n, plain_of(points_.back().at)) < 0);  // else they are apart
  }
  const Plain p = plain_of(points_[0].at);
  const auto way = [&](std::size_t i) { return plain_of(points_[i].at) - p; };
  const double volume = dot(cross(way(1), way(2)), way(3));
  is_sound_ = is_sound_ && std::fabs(volume) > size_ * size_ * size_ * least_volume;
  if (is_sound_) begin();
}

void GuessedSurface::grow_from(const std::array<Ends, 4>& start) {
  if (!is_sound_) return;
  for (const Ends& e : start) take(e);
  begin();
}

void GuessedSurface::begin() {
  const Plain p = plain_of(points_[0].at);
  const auto way = [&](std::size_t i) { return plain_of(points_[i].at) - p; };
  if (dot(cross(way(1), way(2)), way(3)) > 0) std::swap(points_[0], points_[1]);
  constexpr std::array<Corners, 4> corners{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  constexpr std::array<Corners, 4> twins{{{6, 10, 14}, {13, 8, 0}, {5, 12, 1}, {9, 4, 2}}};
  for (std::size_t i = 0; i < 4; ++i) {
    facets_[make(corners[i][0], corners[i][1], corners[i][2])].twin = twins[i];
  }
  run();
}

bool GuessedSurface::is_closed() const {
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    const Facet& of = facets_[f];
    for (std::uint32_t k = 0; k < 3 && of.is_there; ++k) {
      const std::uint32_t other = of.twin[k] >> 2, m = of.twin[k] & 3;
      const Facet& g = facets_[other];
      if (!g.is_there || g.twin[m] != (f << 2 | k)) return false;
      if (g.corner[m] != of.corner[after(k)] || g.corner[after(m)] != of.corner[k]) return false;
    }
  }
  return true;
}

void GuessedSurface::take(const Ends& e) {
  const Plain p = a_.at(e[0]), q = b_.at(e[1]);
  points_.push_back(
      {e, {world_.difference(p.x, q.x), world_.difference(p.y, q.y), world_.difference(p.z, q.z)}, nowhere});
  const Plain at = plain_of(points_.back().at);
  size_ = std::max({size_, std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
}

std::uint32_t GuessedSurface::make(std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  auto f = static_cast<std::uint32_t>(facets_.size());
  if (free_.empty()) {
    facets_.emplace_back(), rank_.push_back(0);
  } else {
    f = free_.back();
    free_.pop_back();
  }
  Facet& facet = facets_[f];
  facet.corner = {p, q, r}, facet.is_there = true;
  facet.plane = TrianglePlane<Number>(points_[p].at, points_[q].at, points_[r].at);
  const Plain n = normal_of(facet);
  facet.doubt = (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z)) * size_ * level_within;
  const double h = facet.plane.height.value, rank = h * std::fabs(h) / facet.plane.square.value;
  rank_[f] = std::fabs(rank) < HUGE_VAL ? rank : HUGE_VAL;
  return f;
}

void GuessedSurface::remove(std::uint32_t f) {
  facets_[f].is_there = false;
  rank_[f] = HUGE_VAL;
  seen_.push_back(f);
}

bool GuessedSurface::has(const Ends& e) const {
  return std::ranges::any_of(points_, [&](const Point& p) { return p.ends[0] == e[0] && p.ends[1] == e[1]; });
}

std::uint32_t GuessedSurface::nearest() const {
  std::uint32_t least = 0;
  double of_least = rank_[0];
  for (std::uint32_t f = 1; f < rank_.size(); ++f) {
    const bool is_less = rank_[f] < of_least;
    of_least = is_less ? rank_[f] : of_least;
    least = is_less ? f : least;
  }
  return least;
}

void GuessedSurface::run() {
  best_ = HUGE_VAL;
  while (is_sound_) {
    const std::uint32_t least = nearest();
    const double rank = rank_[least], none = size_ * level_within * (size_ * level_within);
    if (rank == HUGE_VAL || rank > std::max(best_ * as_near, none)) return;
    const Facet& f = facets_[least];
    const Ends e = farthest(normal_of(f), points_[f.corner[0]].ends);
    const Plain at = plain(e);
    if (!sees(at, f) || has(e)) {
      rank_[least] = HUGE_VAL;
      best_ = std::min(best_, rank);
      is_sound_ = rank >= -none;  // else they are apart
    } else {
      grow(e, at, least);
    }
  }
}

void GuessedSurface::grow(const Ends& ends, const Plain& at, std::uint32_t beyond) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  take(ends);
  seen_.clear(), horizon_.clear();
  remove(beyond);
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Corners corner = facets_[seen_[i]].corner, twin = facets_[seen_[i]].twin;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = twin[k] >> 2;
      if (!facets_[g].is_there) continue;
      if (sees(at, facets_[g])) {
        remove(g);
      } else {
        horizon_.push_back({corner[k], corner[after(k)], twin[k], nowhere});
      }
    }
  }
  free_.insert(free_.end(), seen_.begin(), seen_.end());
  for (Edge& e : horizon_) {
    if (points_[e.from].starts != nowhere) is_sound_ = false;  // not one ring
    e.made = make(e.from, e.to, point);
    points_[e.from].starts = e.made;
    facets_[e.made].twin[0] = e.outer;
    facets_[e.outer >> 2].twin[e.outer & 3] = e.made << 2;
  }
  for (const Edge& e : horizon_) {  // around the new point
    const std::uint32_t next = points_[e.to].starts;
    if (next == nowhere) {
      is_sound_ = false;
      return;
    }
    facets_[e.made].twin[1] = next << 2 | 2;
    facets_[next].twin[2] = e.made << 2 | 1;
  }
  for (const Edge& e : horizon_) points_[e.from].starts = nowhere;
}

}  // namespace plumb::query::parting
