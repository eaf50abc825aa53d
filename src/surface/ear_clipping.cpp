#include "surface/ear_clipping.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"

namespace plumb::surface {

EarClipping::EarClipping(std::span<const Point2> points, Sign turn)
    : points_(points),
      turn_(turn),
      previous_(points.size()),
      next_(points.size()),
      by_x_(points.size()),
      clipped_(points.size()),
      convex_(points.size()),
      left_(points.size()) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    previous_[i] = i == 0 ? n - 1 : i - 1;
    next_[i] = i + 1 == n ? 0 : i + 1;
  }
  for (std::uint32_t i = 0; i < n; ++i) note_turn(i);
  for (std::uint32_t i = 0; i < n; ++i) by_x_[i] = {points[i], i};
  std::sort(by_x_.begin(), by_x_.end(), [](const Obstacle& l, const Obstacle& r) { return l.at.x < r.at.x; });
}

bool EarClipping::turns(const Point2& a, const Point2& b, const Point2& c) const { return orient2d(a, b, c) == turn_; }

void EarClipping::note_turn(std::uint32_t i) {
  convex_[i] = turns(points_[previous_[i]], points_[i], points_[next_[i]]);
}

// Do the edges at u, which lies on a corner of the ear, run into the ear?
bool EarClipping::edges_enter(std::uint32_t u, const Point2& corner, const Point2& from, const Point2& to) const {
  const auto inside = [&](const Point2& p) { return turns(corner, from, p) && turns(corner, p, to); };
  return inside(points_[previous_[u]]) || inside(points_[next_[u]]);
}

bool EarClipping::blocks(std::uint32_t u, std::uint32_t i, Ears ears) const {
  const std::uint32_t p = previous_[i], n = next_[i];
  if (clipped_[u] || convex_[u] || u == i || u == p || u == n) return false;
  const Point2 &a = points_[p], &b = points_[i], &c = points_[n], &x = points_[u];
  if (x == a) return edges_enter(u, a, b, c);
  if (x == b) return edges_enter(u, b, c, a);
  if (x == c) return edges_enter(u, c, a, b);
  const auto in = [&](const Point2& from, const Point2& to) {
    const Sign side = orient2d(from, to, x);
    return side == turn_ || (side == Sign::zero && ears == Ears::empty_closed);
  };
  return in(c, a) && in(a, b) && in(b, c);
}

bool EarClipping::is_ear(std::uint32_t i, Ears ears) const {
  const Point2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
  const Sign turn = orient2d(a, b, c);
  if (ears == Ears::flat) return turn == Sign::zero;
  if (turn != turn_) return false;
  const double left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
  const double low = std::min({a.y, b.y, c.y}), high = std::max({a.y, b.y, c.y});
  auto u = std::lower_bound(by_x_.begin(), by_x_.end(), left, [](const Obstacle& o, double x) { return o.at.x < x; });
  for (; u != by_x_.end() && u->at.x <= right; ++u)
    if (low <= u->at.y && u->at.y <= high && blocks(u->corner, i, ears)) return false;
  return true;
}

void EarClipping::clip(std::uint32_t i, Corners corners, std::vector<TriangleMesh::Triangle>& out) {
  const std::uint32_t p = previous_[i], n = next_[i];
  out.push_back({corners[p], corners[i], corners[n]});
  next_[p] = n;
  previous_[n] = p;
  clipped_[i] = true;
  --left_;
  for (const std::uint32_t neighbor : {p, n}) {
    note_turn(neighbor);
    candidates_.push_back(neighbor);
  }
  if (++idle_ > by_x_.size() / 2) {
    std::erase_if(by_x_, [&](const Obstacle& o) { return clipped_[o.corner] || convex_[o.corner]; });
    idle_ = 0;
  }
}

// Does the path turn back at i on itself, or stand still?  Such an ear covers nothing and leads nowhere.
bool EarClipping::folds_back(std::uint32_t i) const {
  const Point2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
  if (a == b || b == c || a == c) return true;
  const bool between = std::min(a.x, c.x) <= b.x && b.x <= std::max(a.x, c.x) &&  //
                       std::min(a.y, c.y) <= b.y && b.y <= std::max(a.y, c.y);
  return !between && orient2d(a, b, c) == Sign::zero;
}

// At i, and at the neighbors that this brings together.
void EarClipping::clip_folds(std::uint32_t i, Corners corners, std::vector<TriangleMesh::Triangle>& out) {
  while (left_ > 3 && folds_back(i)) {
    const std::uint32_t p = previous_[i], n = next_[i];
    clip(i, corners, out);
    i = folds_back(p) ? p : n;
  }
}

// All there are, and those that this makes.
bool EarClipping::clip_all(Ears ears, Corners corners, std::vector<TriangleMesh::Triangle>& out) {
  const std::size_t before = left_;
  while (!candidates_.empty() && left_ > 3) {
    const std::uint32_t i = candidates_.front();
    candidates_.pop_front();
    if (clipped_[i] || !is_ear(i, ears)) continue;
    const std::uint32_t p = previous_[i], n = next_[i];
    clip(i, corners, out);
    has_area_ = has_area_ || ears != Ears::flat;
    clip_folds(p, corners, out);
    if (!clipped_[n]) clip_folds(n, corners, out);
  }
  return left_ < before;
}

bool EarClipping::run(Corners corners, std::vector<TriangleMesh::Triangle>& out) {
  const std::size_t before = out.size();
  const auto refill = [&] {
    candidates_.clear();
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (!clipped_[i]) candidates_.push_back(i);
    return true;
  };
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!clipped_[i]) clip_folds(i, corners, out);
  refill();
  clip_all(Ears::empty_closed, corners, out);
  while (left_ > 3 &&
         ((refill() && clip_all(Ears::flat, corners, out)) || (refill() && clip_all(Ears::empty_open, corners, out)))) {
    refill();
    clip_all(Ears::empty_closed, corners, out);
  }
  std::uint32_t i = 0;
  while (clipped_[i]) ++i;
  const std::uint32_t p = previous_[i], n = next_[i];
  const Sign last = orient2d(points_[p], points_[i], points_[n]);
  has_area_ = has_area_ || last == turn_;
  if (left_ > 3 || last == -turn_ || !has_area_) {
    out.resize(before);
    return false;
  }
  out.push_back({corners[p], corners[i], corners[n]});
  return true;
}

}  // namespace plumb::surface
