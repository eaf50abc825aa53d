// What does a triangulation ask of its points?  Signs of points by their numbers, for points as given and exact ones.
//
// Laws: orient and in_circle are the exact signs of orient2d and incircle, order that of compare_xy; label is the
// number by which the user knows the point.  Where four points lie on one circle, `is_lowered` says which pair a
// diagonal joins: that of the lowest label.  It is as if each point's height on the paraboloid were lowered by an
// infinitesimal that is larger than any multiple of those of higher labels: of four points on one circle any three are
// no line, so that the largest infinitesimal alone decides the determinant of the heights.
// Source: Edelsbrunner and Muecke 1990 (perturbation), Guibas and Stolfi 1985 (the paraboloid).
// Cost: that of the signs.
#pragma once

#include <algorithm>
#include <concepts>
#include <vector>

#include "plumb/certify/detail/exact_incircle.hpp"
#include "plumb/predicates.hpp"
#include "surface/planar/triangles.hpp"

namespace plumb::surface {

template <class P>
concept PointSource = requires(const P& points, Vertex v) {
  { points.size() } -> std::convertible_to<std::size_t>;
  { points.orient(v, v, v) } -> std::same_as<Sign>;
  { points.in_circle(v, v, v, v) } -> std::same_as<Sign>;
  { points.order(v, v) } -> std::same_as<Sign>;
  { points.label(v) } -> std::same_as<std::uint32_t>;
};

/// Do p and d have the lowest label of four points on a circle?
template <class Points>
bool is_lowered(const Points& points, Vertex a, Vertex b, Vertex p, Vertex d) {
  return std::min(points.label(p), points.label(d)) < std::min(points.label(a), points.label(b));
}

/// What points of every kind have: their labels.
class Labels {
 public:
  explicit Labels(std::vector<std::uint32_t> labels) : labels_(std::move(labels)) {}
  [[nodiscard]] std::size_t size() const { return labels_.size(); }
  [[nodiscard]] std::uint32_t label(Vertex v) const { return labels_[v]; }
  void relabel(Vertex v, std::uint32_t label) { labels_[v] = label; }

 private:
  std::vector<std::uint32_t> labels_;
};

/// Points whose coordinates are doubles, copied in the order in which they are asked about.
class GivenPoints : public Labels {
 public:
  GivenPoints(std::span<const Point2> points, std::vector<std::uint32_t> order) : Labels(std::move(order)) {
    at_.reserve(size());
    for (Vertex v = 0; v < size(); ++v) at_.push_back(points[label(v)]);
  }

  [[nodiscard]] Sign orient(Vertex a, Vertex b, Vertex c) const { return orient2d(at_[a], at_[b], at_[c]); }
  [[nodiscard]] Sign in_circle(Vertex a, Vertex b, Vertex c, Vertex d) const {
    return incircle(at_[a], at_[b], at_[c], at_[d]);
  }
  [[nodiscard]] Sign order(Vertex a, Vertex b) const {
    const Point2 &p = at_[a], &q = at_[b];
    return p.x != q.x ? (p.x < q.x ? Sign::negative : Sign::positive) : sign_of_number((p.y > q.y) - (p.y < q.y));
  }

 private:
  std::vector<Point2> at_;
};

/// On which lines a point is known to be: a bit for each.
using KnownLines = std::uint64_t;

/// Points that were constructed, by their places in an array that outlives this.
class ExactPoints : public Labels {
 public:
  /// `lines`, of each point or of none, save the signs of points that are on one line.
  ExactPoints(std::span<const ExactPoint2> points, std::vector<std::uint32_t> order,
              std::span<const KnownLines> lines = {})
      : Labels(std::move(order)), points_(points), lines_(lines) {}

  [[nodiscard]] Sign orient(Vertex a, Vertex b, Vertex c) const {
    if (!lines_.empty() && (lines_[label(a)] & lines_[label(b)] & lines_[label(c)]) != 0) return Sign::zero;
    return orient2d(at(a), at(b), at(c));
  }
  [[nodiscard]] Sign in_circle(Vertex a, Vertex b, Vertex c, Vertex d) const {
    return incircle(at(a), at(b), at(c), at(d));
  }
  [[nodiscard]] Sign order(Vertex a, Vertex b) const { return compare_xy(at(a), at(b)); }

 private:
  [[nodiscard]] const ExactPoint2& at(Vertex v) const { return points_[label(v)]; }

  std::span<const ExactPoint2> points_;  // all different, so that no label changes
  std::span<const KnownLines> lines_;
};

}  // namespace plumb::surface
