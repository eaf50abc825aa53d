#include "ear_clipping.hpp"

#include <algorithm>
#include <numeric>

#include "plumb/predicates.hpp"

namespace plumb::surface {

EarClipping::EarClipping(std::span<const Point2> points, Sign turn)
    : points_(points),
      turn_(turn),
      previous_(points.size()),
      next_(points.size()),
      by_x_(points.size()),
      clipped_(points.size()),
      left_(points.size()) {
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    previous_[i] = i == 0 ? n - 1 : i - 1;
    next_[i] = i + 1 == n ? 0 : i + 1;
  }
  std::iota(by_x_.begin(), by_x_.end(), 0U);
  std::sort(by_x_.begin(), by_x_.end(), [&](std::uint32_t l, std::uint32_t r) { return points_[l].x < points_[r].x; });
}

bool EarClipping::turns(const Point2& a, const Point2& b, const Point2& c) const { return orient2d(a, b, c) == turn_; }

// Do the edges at u, which lies on a corner of the ear, run into the ear?
bool EarClipping::edges_enter(std::uint32_t u, const Point2& corner, const Point2& from, const Point2& to) const {
  const auto inside = [&](const Point2& p) { return turns(corner, from, p) && turns(corner, p, to); };
  return inside(points_[previous_[u]]) || inside(points_[next_[u]]);
}

bool EarClipping::blocks(std::uint32_t u, std::uint32_t i, Ears ears) const {
  const std::uint32_t p = previous_[i], n = next_[i];
  if (clipped_[u] || u == i || u == p || u == n) return false;
  const Point2 &a = points_[p], &b = points_[i], &c = points_[n], &x = points_[u];
  if (x.y < std::min({a.y, b.y, c.y}) || x.y > std::max({a.y, b.y, c.y})) return false;
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
  const double low = std::min({a.x, b.x, c.x}), high = std::max({a.x, b.x, c.x});
  auto u = std::lower_bound(by_x_.begin(), by_x_.end(), low,
                            [&](std::uint32_t corner, double x) { return points_[corner].x < x; });
  for (; u != by_x_.end() && points_[*u].x <= high; ++u)
    if (blocks(*u, i, ears)) return false;
  return true;
}

void EarClipping::clip(std::uint32_t i, Corners corners, std::vector<Triangle>& out) {
  const std::uint32_t p = previous_[i], n = next_[i];
  out.push_back({corners[p], corners[i], corners[n]});
  next_[p] = n;
  previous_[n] = p;
  clipped_[i] = true;
  at_ = next_[n];  // not the neighbor: going around keeps the triangles small
  if (--left_ < by_x_.size() / 2) std::erase_if(by_x_, [&](std::uint32_t u) { return clipped_[u]; });
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
void EarClipping::clip_folds(std::uint32_t i, Corners corners, std::vector<Triangle>& out) {
  while (left_ > 3 && folds_back(i)) {
    const std::uint32_t p = previous_[i], n = next_[i];
    clip(i, corners, out);
    i = folds_back(p) ? p : n;
  }
}

bool EarClipping::clip_next(Ears ears, Corners corners, std::vector<Triangle>& out) {
  for (std::size_t tries = left_; tries > 0; --tries, at_ = next_[at_])
    if (is_ear(at_, ears)) {
      const std::uint32_t p = previous_[at_], n = next_[at_];
      clip(at_, corners, out);
      has_area_ = has_area_ || ears != Ears::flat;
      clip_folds(p, corners, out);
      if (!clipped_[n]) clip_folds(n, corners, out);
      return true;
    }
  return false;
}

bool EarClipping::run(Corners corners, std::vector<Triangle>& out) {
  const std::size_t before = out.size();
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    if (!clipped_[i]) clip_folds(i, corners, out);
  while (left_ > 3)
    if (!clip_next(Ears::empty_closed, corners, out) && !clip_next(Ears::flat, corners, out) &&
        !clip_next(Ears::empty_open, corners, out))
      break;
  const std::uint32_t p = previous_[at_], n = next_[at_];
  const Sign last = orient2d(points_[p], points_[at_], points_[n]);
  has_area_ = has_area_ || last == turn_;
  if (left_ > 3 || last == -turn_ || !has_area_) {
    out.resize(before);
    return false;
  }
  out.push_back({corners[p], corners[at_], corners[n]});
  return true;
}

}  // namespace plumb::surface
