// How are meshes commonly asked by a tree in floating point?  The tree that ours is, with boxes, slabs, distances and
// triangle tests as they are commonly written.
//
// Laws: none; they are on trial, and decide nothing of ours.  Boxes are those of the rounded vertices, nothing is
// rounded outward.  What an epsilon means is the triangle tests' affair (triangle_tests.hpp, distance_tests.hpp).
// Source: RTCD 5.3.3, 5.3.6, 6.3, 5.1.5, 5.1.9; Moller and Trumbore 1997, Moller 1997.
// Cost: the descent, one call for each node and triangle.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "lab/trial/distance_tests.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::trial {

template <class T>
class PlainTree {
 public:
  PlainTree(const TriangleMesh& mesh, T epsilon) : epsilon_(epsilon) {
    const Bvh bvh = build_bvh(mesh);
    const auto in_numbers = [](const Point3& p) { return Vec<T>{T(p.x), T(p.y), T(p.z)}; };
    for (std::size_t slot = 0; slot < bvh.tree.items.size(); ++slot) {
      const Triangle3 t = bvh.triangle(slot);
      triangles_.push_back({in_numbers(t.a), in_numbers(t.b), in_numbers(t.c)});
      items_.push_back(bvh.tree.items[slot]);
    }
    for (const BoxNode& n : bvh.tree.nodes.view()) nodes_.push_back({{}, {}, n.link, n.count});
    for (std::size_t i = nodes_.size(); i-- > 0;) {  // children come behind their parents
      Node& node = nodes_[i];
      node.min = {most, most, most}, node.max = {-most, -most, -most};
      for (std::uint32_t slot = node.link; slot < node.link + node.count; ++slot) {
        for (const Vec<T>& p : triangles_[slot]) widen(node, p, p);
      }
      if (node.count != 0) continue;
      for (const std::size_t child : {i + 1, i + node.link}) widen(node, nodes_[child].min, nodes_[child].max);
    }
  }

  /// The number of the first triangle hit, -1 where there is none; of equal parameters whichever comes first.
  [[nodiscard]] double first(const Vec<T>& o, const Vec<T>& d) const {
    double number = -1;
    T limit = most;
    const Vec<T> inverse{1 / d.x, 1 / d.y, 1 / d.z};
    nearer_first(
        limit, [&](const Node& n) { return entered(o, inverse, n); },
        [&](std::uint32_t slot) {
          const T t = parameter(o, d, triangles_[slot]);
          if (t >= -epsilon_ && t < limit) limit = t, number = items_[slot];
        });
    return number;
  }

  [[nodiscard]] double nearest(const Vec<T>& p) const {
    double number = -1;
    T limit = most;
    nearer_first(
        limit, [&](const Node& n) { return square_to(p, n); },
        [&](std::uint32_t slot) {
          const auto& [a, b, c] = triangles_[slot];
          const T far = T(PointTriangleDistance{}(joined<4>({p, a, b, c}), epsilon_));
          if (far * far < limit) limit = far * far, number = items_[slot];
        });
    return number;
  }

  [[nodiscard]] Pairs pairs_with(const PlainTree& other) const {
    Pairs pairs;
    both(
        other, [&](const Node& a, const Node& b) { return overlap(a, b); },
        [&](std::uint32_t s, std::uint32_t t) {
          if (meet(triangles_[s], other.triangles_[t])) pairs.push_back({items_[s], other.items_[t]});
        });
    return pairs;
  }

  [[nodiscard]] double distance_to(const PlainTree& other) const {
    T least = most;
    both(
        other, [&](const Node& a, const Node& b) { return square_between(a, b) < least * least; },
        [&](std::uint32_t s, std::uint32_t t) { least = std::min(least, apart(triangles_[s], other.triangles_[t])); });
    return static_cast<double>(least);
  }

 private:
  using Corners = std::array<Vec<T>, 3>;
  struct Node {
    Vec<T> min, max;
    std::uint32_t link, count;  // as of BoxNode
  };
  static constexpr T most = std::numeric_limits<T>::max();

  static void widen(Node& node, const Vec<T>& low, const Vec<T>& high) {
    node.min = {std::min(node.min.x, low.x), std::min(node.min.y, low.y), std::min(node.min.z, low.z)};
    node.max = {std::max(node.max.x, high.x), std::max(node.max.y, high.y), std::max(node.max.z, high.z)};
  }
  template <std::size_t N>
  static std::array<T, 3 * N> joined(const std::array<Vec<T>, N>& points) {
    std::array<T, 3 * N> q;
    for (std::size_t i = 0; i < N; ++i) q[3 * i] = points[i].x, q[3 * i + 1] = points[i].y, q[3 * i + 2] = points[i].z;
    return q;
  }

  static T entered(const Vec<T>& o, const Vec<T>& inverse, const Node& n) {
    T in = 0, out = most;
    const auto clip = [&](T low, T high, T from, T rate) {
      const T a = (low - from) * rate, b = (high - from) * rate;
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    };
    clip(n.min.x, n.max.x, o.x, inverse.x);
    clip(n.min.y, n.max.y, o.y, inverse.y);
    clip(n.min.z, n.max.z, o.z, inverse.z);
    return in <= out ? in : std::numeric_limits<T>::infinity();
  }
  static T square_to(const Vec<T>& p, const Node& n) {
    const auto gap = [](T x, T low, T high) { return x < low ? low - x : x > high ? x - high : T(0); };
    const Vec<T> d{gap(p.x, n.min.x, n.max.x), gap(p.y, n.min.y, n.max.y), gap(p.z, n.min.z, n.max.z)};
    return dot(d, d);
  }
  static T square_between(const Node& a, const Node& b) {
    const auto gap = [](T low_a, T high_a, T low_b, T high_b) {
      return high_a < low_b ? low_b - high_a : high_b < low_a ? low_a - high_b : T(0);
    };
    const Vec<T> d{gap(a.min.x, a.max.x, b.min.x, b.max.x), gap(a.min.y, a.max.y, b.min.y, b.max.y),
                   gap(a.min.z, a.max.z, b.min.z, b.max.z)};
    return dot(d, d);
  }
  [[nodiscard]] bool overlap(const Node& a, const Node& b) const {
    return a.min.x <= b.max.x + epsilon_ && b.min.x <= a.max.x + epsilon_ && a.min.y <= b.max.y + epsilon_ &&
           b.min.y <= a.max.y + epsilon_ && a.min.z <= b.max.z + epsilon_ && b.min.z <= a.max.z + epsilon_;
  }

  /// Where the ray meets the triangle; infinite where it does not.
  [[nodiscard]] T parameter(const Vec<T>& o, const Vec<T>& d, const Corners& t) const {
    constexpr T missed = std::numeric_limits<T>::infinity();
    const Vec<T> e = t[1] - t[0], f = t[2] - t[0], p = cross(d, f);
    const T det = dot(e, p);
    if (magnitude(det) <= epsilon_) return missed;
    const T inverse = 1 / det;
    const Vec<T> s = o - t[0];
    const T u = dot(s, p) * inverse;
    if (u < -epsilon_ || u > 1 + epsilon_) return missed;
    const Vec<T> r = cross(s, e);
    const T v = dot(d, r) * inverse;
    if (v < -epsilon_ || u + v > 1 + epsilon_) return missed;
    return dot(f, r) * inverse;
  }
  [[nodiscard]] bool meet(const Corners& a, const Corners& b) const {
    return TriangleAgainstTriangle{}(joined<6>({a[0], a[1], a[2], b[0], b[1], b[2]}), epsilon_);
  }
  [[nodiscard]] T apart(const Corners& a, const Corners& b) const {
    if (meet(a, b)) return 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < 3; ++i) {
      least = std::min(least, PointTriangleDistance{}(joined<4>({a[i], b[0], b[1], b[2]}), epsilon_));
      least = std::min(least, PointTriangleDistance{}(joined<4>({b[i], a[0], a[1], a[2]}), epsilon_));
      for (std::size_t k = 0; k < 3; ++k) {
        least = std::min(least,
                         SegmentSegmentDistance{}(joined<4>({a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]}), epsilon_));
      }
    }
    return T(least);
  }

  template <class Bound, class Visit>
  void nearer_first(const T& limit, const Bound& bound, const Visit& visit) const {
    std::array<std::pair<T, std::uint32_t>, most_tree_depth + 1> later;
    std::size_t waiting = 0;
    if (!nodes_.empty()) later[waiting++] = {bound(nodes_[0]), 0};
    while (waiting > 0) {
      const auto [key, i] = later[--waiting];
      if (key > limit) continue;
      const Node& node = nodes_[i];
      for (std::uint32_t slot = node.link; slot < node.link + node.count; ++slot) visit(slot);
      if (node.count != 0) continue;
      std::pair near{bound(nodes_[i + 1]), i + 1}, far{bound(nodes_[i + node.link]), i + node.link};
      if (far.first < near.first) std::swap(near, far);
      if (!(far.first > limit)) later[waiting++] = far;
      if (!(near.first > limit)) later[waiting++] = near;
    }
  }

  /// Pairs of nodes, the larger descended.
  template <class Meets, class Visit>
  void both(const PlainTree& other, const Meets& meets, const Visit& visit) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> later;
    if (!nodes_.empty() && !other.nodes_.empty()) later.emplace_back(0, 0);
    while (!later.empty()) {
      const auto [i, k] = later.back();
      later.pop_back();
      const Node &a = nodes_[i], &b = other.nodes_[k];
      if (!meets(a, b)) continue;
      if (a.count != 0 && b.count != 0) {
        for (std::uint32_t s = a.link; s < a.link + a.count; ++s) {
          for (std::uint32_t t = b.link; t < b.link + b.count; ++t) visit(s, t);
        }
        continue;
      }
      std::array<std::pair<std::uint32_t, std::uint32_t>, 2> next{{{i + 1, k}, {i + a.link, k}}};
      const Vec<T> u = a.max - a.min, v = b.max - b.min;
      if (a.count != 0 || (b.count == 0 && dot(u, u) < dot(v, v))) next = {{{i, k + 1}, {i, k + b.link}}};
      const auto between = [&](std::size_t n) {
        return square_between(nodes_[next[n].first], other.nodes_[next[n].second]);
      };
      if (between(0) < between(1)) std::swap(next[0], next[1]);  // the nearer is looked at first
      later.insert(later.end(), next.begin(), next.end());
    }
  }

  T epsilon_;
  std::vector<Node> nodes_;
  std::vector<Corners> triangles_;  // one a slot
  std::vector<std::uint32_t> items_;
};

}  // namespace plumb::lab::trial
