// A guess in doubles, which holds no bound.
#include "query/penetration/guessed_surface.hpp"

#include <algorithm>
#include <cmath>

#include "query/penetration/furthest.hpp"

namespace plumb::query::parting {
namespace {

constexpr std::uint32_t nowhere = ~0U;
constexpr double nearly = 0x1p-40;       // a guess: what is no further beyond a plane lies in it
constexpr double as_near = 1 + 0x1p-20;  // a guess: what is as near may be a tie

}  // namespace

GuessedSurface::GuessedSurface(const Difference& d, const std::array<Ends, 4>& start) : of_(d) {
  points_.reserve(64), facets_.reserve(160), seen_.reserve(64), horizon_.reserve(64);
  for (const Ends& e : start) take(e, d.at<double>(e));
  const arith::Plain& p = points_[0].at;
  if (dot(cross(points_[1].at - p, points_[2].at - p), points_[3].at - p) > 0) std::swap(points_[0], points_[1]);
  make(0, 1, 2), make(0, 3, 1), make(1, 3, 2), make(2, 3, 0);
  facets_[0].across = {1, 2, 3};
  facets_[1].across = {3, 2, 0};
  facets_[2].across = {1, 3, 0};
  facets_[3].across = {2, 1, 0};
  run();
}

void GuessedSurface::take(const Ends& e, const arith::Plain& at) {
  points_.push_back({e, at, nowhere});
  size_ = std::max({size_, std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
}

void GuessedSurface::make(std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  const arith::Plain &at = points_[p].at, n = cross(points_[q].at - at, points_[r].at - at);
  const double offset = dot(n, at), distance = offset / std::sqrt(dot(n, n));
  const double doubt = (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z)) * size_ * nearly;
  facets_.push_back({{p, q, r}, {}, n, offset, doubt, distance, true, !(std::fabs(distance) < HUGE_VAL)});
}

bool GuessedSurface::has(const Ends& e) const {
  return std::ranges::any_of(points_, [&](const Point& p) { return p.ends[0] == e[0] && p.ends[1] == e[1]; });
}

void GuessedSurface::run() {
  double best = HUGE_VAL;
  while (is_sound_) {
    std::uint32_t least = nowhere;
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      if (!facets_[f].is_there || facets_[f].is_done) continue;
      if (least == nowhere || facets_[f].distance < facets_[least].distance) least = f;
    }
    if (least == nowhere) return;
    Facet& f = facets_[least];
    if (f.distance > best * as_near + nearly * std::fabs(best)) return;
    const Ends& from = points_[f.corner[0]].ends;
    const Ends e{guessed_furthest(of_.a, f.normal, from[0]), guessed_furthest(of_.b, f.normal * -1, from[1])};
    const arith::Plain at = of_.at<double>(e);
    if (!sees(at, f) || has(e)) {
      f.is_done = true;
      best = std::min(best, f.distance);
    } else {
      grow(e, at, least);
    }
  }
}

void GuessedSurface::grow(const Ends& ends, const arith::Plain& at, std::uint32_t beyond) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  take(ends, at);
  seen_.assign(1, beyond), horizon_.clear();
  facets_[beyond].is_there = false;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const std::array<std::uint32_t, 3> across = facets_[seen_[i]].across;
    for (const std::uint32_t g : across) {
      if (!facets_[g].is_there || !sees(at, facets_[g])) continue;
      facets_[g].is_there = false;
      seen_.push_back(g);
    }
  }
  for (const std::uint32_t f : seen_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = facets_[f].across[k];
      if (facets_[g].is_there) horizon_.push_back({facets_[f].corner[k], facets_[f].corner[(k + 1) % 3], g, nowhere});
    }
  }
  for (Edge& e : horizon_) {
    if (points_[e.from].starts != nowhere) is_sound_ = false;  // not one ring
    e.made = static_cast<std::uint32_t>(facets_.size());
    points_[e.from].starts = e.made;
    make(e.from, e.to, point);
    facets_[e.made].across[0] = e.outer;
    Facet& outer = facets_[e.outer];
    for (std::size_t k = 0; k < 3; ++k) {
      if (outer.corner[k] == e.to && outer.corner[(k + 1) % 3] == e.from) outer.across[k] = e.made;
    }
  }
  for (const Edge& e : horizon_) {  // around the new point
    const std::uint32_t next = points_[e.to].starts;
    if (next == nowhere) {
      is_sound_ = false;
      return;
    }
    facets_[e.made].across[1] = next;
    facets_[next].across[2] = e.made;
  }
  for (const Edge& e : horizon_) points_[e.from].starts = nowhere;
}

}  // namespace plumb::query::parting
