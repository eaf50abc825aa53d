// Which parts of a mesh in motion meet, and in which order of time?  Pairs of nodes down to some hundred parts of the
// work; each part down to its leaves; then all in order.
//
// A scene has the mesh, says which nodes come near, where corners, edges and triangles are during the motion, and when
// two of them meet.
// Law: each pair that meets is told once, on any number of threads.
// Source: RTCD 5.5, 6.3.3.
// Cost: a comparison of boxes for each pair of nodes that may meet, then that of the scene's contacts.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/root.hpp"
#include "plumb/space/moving/motion_contacts.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/box_distance.hpp"

namespace plumb::space {

/// May what is in two boxes come this near?
template <class BoxA, class BoxB>
bool come_near(const BoxA& a, const BoxB& b, double separation) {
  const auto on = [&](double a_min, double a_max, double b_min, double b_max) {
    return step_below(a_min - b_max) <= separation && step_below(b_min - a_max) <= separation;
  };
  if constexpr (std::is_same_v<BoxA, Aabb3>) {
    return on(a.min.x, a.max.x, b.min.x, b.max.x) && on(a.min.y, a.max.y, b.min.y, b.max.y) &&
           on(a.min.z, a.max.z, b.min.z, b.max.z);
  } else {
    const auto axis = [&](std::size_t k) {
      return on(static_cast<double>(a.min[k]), static_cast<double>(a.max[k]), static_cast<double>(b.min[k]),
                static_cast<double>(b.max[k]));
    };
    return axis(0) && axis(1) && axis(2);
  }
}

inline bool comes_first(const MotionContact& x, const MotionContact& y) {
  return std::tuple(x.pair, x.a, x.b) < std::tuple(y.pair, y.a, y.b);
}

/// Both kinds of pairs of a mesh, in parts.
template <class Scene>
class MotionSearch {
 public:
  MotionSearch(const char* function, const Scene& scene, const MotionContactOptions& options)
      : function_(function), scene_(scene), mesh_(scene.mesh()), options_(options) {}

  /// begin(n), then take(part, contact) for each, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(const Begin& begin, const Take& take) const {
    const BoxTree &corners = mesh_.corner_tree, &triangles = mesh_.triangle_tree, &edges = mesh_.edge_tree;
    const std::span<const BoxNode> cs = corners.nodes.view(), ts = triangles.nodes.view(), es = edges.nodes.view();
    const auto corner_near = scene_.nodes_near(corners, triangles, options_.separation);
    const auto edge_near = scene_.nodes_near(edges, edges, options_.separation);
    const auto down = [&](NodePair pair, const auto& next) { replace_pair(cs, ts, descend_larger{}, pair, next); };
    const auto down_own = [&](NodePair pair, const auto& next) { replace_own_pair(es, pair, next); };
    constexpr std::size_t parts_of_motion = 256;
    const auto corner_parts = pair_parts(cs, ts, parts_of_motion, down, corner_near);
    const auto edge_parts = pair_parts(es, es, parts_of_motion, down_own, edge_near);
    const std::size_t n = corner_parts.size();
    begin(n + edge_parts.size());
    for_parts(function_, options_.execution, options_.progress, n + edge_parts.size(), [&](std::size_t part) {
      const auto ask = [&](ContactPair pair, std::uint32_t a, std::uint32_t b) {
        const auto contact = scene_.contact(pair, a, b, options_.separation);
        if (contact) take(part, MotionContact{pair, a, b, *contact});
      };
      if (part < n) {
        const auto visit = [&](const BoxNode& a, const BoxNode& b) { corner_leaves(a, b, ask); };
        descend_from(cs, ts, corner_parts[part], down, corner_near, visit);
      } else {
        const auto visit = [&](const BoxNode& a, const BoxNode& b) { edge_leaves(a, b, ask); };
        descend_from(es, es, edge_parts[part - n], down_own, edge_near, visit);
      }
    });
  }

 private:
  template <class Ask>
  void corner_leaves(const BoxNode& leaf_a, const BoxNode& leaf_b, const Ask& ask) const {
    for (std::uint32_t k = leaf_b.link; k < leaf_b.link + leaf_b.count; ++k) {
      const std::uint32_t b = mesh_.triangle_tree.items[k];
      const Bvh::Corners& t = mesh_.triangles[b];
      const Aabb3 box = scene_.triangle_box(b);
      for (std::uint32_t i = leaf_a.link; i < leaf_a.link + leaf_a.count; ++i) {
        const std::uint32_t corner = mesh_.corner_tree.items[i], a = mesh_.corners[corner];
        if (a == t[0] || a == t[1] || a == t[2]) continue;
        if (come_near(scene_.corner_box(corner), box, options_.separation)) ask(ContactPair::vertex_triangle, a, b);
      }
    }
  }

  template <class Ask>
  void edge_leaves(const BoxNode& leaf_a, const BoxNode& leaf_b, const Ask& ask) const {
    for (std::uint32_t i = leaf_a.link; i < leaf_a.link + leaf_a.count; ++i) {
      const std::uint32_t a = mesh_.edge_tree.items[i];
      const auto [p, q] = mesh_.edges[a];
      const Aabb3 box = scene_.edge_box(a);
      for (std::uint32_t k = leaf_a.link == leaf_b.link ? i + 1 : leaf_b.link; k < leaf_b.link + leaf_b.count; ++k) {
        const std::uint32_t b = mesh_.edge_tree.items[k];
        const auto [r, s] = mesh_.edges[b];
        if (p == r || p == s || q == r || q == s) continue;
        if (!come_near(box, scene_.edge_box(b), options_.separation)) continue;
        ask(ContactPair::edge_edge, std::min(a, b), std::max(a, b));
      }
    }
  }

  const char* function_;
  const Scene& scene_;
  const MovingMesh& mesh_;
  const MotionContactOptions& options_;
};

inline void require_separation(const char* function, double separation) {
  require_finite_parts(function, {"options.separation"}, separation);
  if (separation < 0) {
    throw InvalidShape(std::string(function) + ": options.separation is negative; give a distance, zero for contact");
  }
}

template <class Scene>
std::vector<MotionContact> all_contacts(const char* function, const Scene& scene, const MotionContactOptions& options,
                                        std::vector<MotionContact> all) {
  require_separation(function, options.separation);
  std::vector<std::vector<MotionContact>> found;
  MotionSearch(function, scene, options)
      .run([&](std::size_t parts) { found.resize(parts); },
           [&](std::size_t part, const MotionContact& c) { found[part].push_back(c); });
  all.clear();
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end(), comes_first);
  return all;
}

/// By their exact times: those of equal rounded times are asked for.
template <class Scene>
std::vector<MotionContact> all_by_time(const char* function, const Scene& scene, const MotionContactOptions& options,
                                       std::vector<MotionContact> rows) {
  std::vector<MotionContact> all = all_contacts(function, scene, options, std::move(rows));
  const auto time = [](const MotionContact& c) { return c.contact.time; };
  std::ranges::stable_sort(all, {}, time);
  for (auto from = all.begin(); from != all.end();) {
    const auto to = std::find_if(from, all.end(), [&](const MotionContact& c) { return time(c) != time(*from); });
    if (to - from > 1) {
      std::vector<std::pair<Root, MotionContact>> exact;
      for (auto c = from; c != to; ++c) exact.emplace_back(scene.time(*c, options.separation), *c);
      std::stable_sort(exact.begin(), exact.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
      std::transform(exact.begin(), exact.end(), from, [](const auto& x) { return x.second; });
    }
    from = to;
  }
  return all;
}

/// The first in time of those that were offered.
template <class Scene>
class FirstInTime {
 public:
  void offer(const Scene& scene, double separation, const MotionContact& c) {
    if (best_ && c.contact.time > best_->contact.time) return;
    std::optional<Root> exact;
    if (best_ && c.contact.time == best_->contact.time) {
      if (!exact_) exact_ = scene.time(*best_, separation);
      const bool first = comes_first(c, *best_);
      if (!first && *exact_ == Rational(c.contact.time)) return;  // c is no earlier than its time
      exact = scene.time(c, separation);
      const auto order = *exact <=> *exact_;
      if (order > 0 || (order == 0 && !first)) return;
    }
    best_ = c;
    exact_ = exact;
  }
  [[nodiscard]] const std::optional<MotionContact>& best() const { return best_; }

 private:
  std::optional<MotionContact> best_;
  std::optional<Root> exact_;  // where it had to be known
};

template <class Scene>
std::optional<MotionContact> first_in_time(const char* function, const Scene& scene,
                                           const MotionContactOptions& options) {
  require_separation(function, options.separation);
  std::vector<FirstInTime<Scene>> found;
  MotionSearch(function, scene, options)
      .run([&](std::size_t parts) { found.resize(parts); },
           [&](std::size_t part, const MotionContact& c) { found[part].offer(scene, options.separation, c); });
  FirstInTime<Scene> first;
  for (const FirstInTime<Scene>& part : found) {
    if (part.best()) first.offer(scene, options.separation, *part.best());
  }
  return first.best();
}

}  // namespace plumb::space
