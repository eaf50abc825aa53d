// Bottom-up: of all pairs always that of the least box, or, faster, all pairs each of which is the other's nearest among
// its neighbors along a curve through space.
//
// A pair's size is the half area of its box.  Pairs of equal size are ordered too, so that there is always one that both
// its parts prefer; by their places' exclusive or, so that of many equal items half are merged at once.
#include <limits>
#include <numeric>
#include <tuple>

#include "space/bvh/pair_tree.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

float size_of(Extent a, const Extent& b) {
  a.take(b);
  return half_area(a);
}

Extent box_of(const BoxedItem& item) {
  Extent box;
  box.take(item.low(), item.high());
  return box;
}

struct Cluster {
  std::uint32_t number;
  Extent box;
};

/// The best partner that is known, by its place.
struct Partner {
  float size = std::numeric_limits<float>::infinity();
  std::uint32_t place = 0;
};

// Is the pair (i, k) before what i has?
bool improves(float size, std::uint32_t i, std::uint32_t k, const Partner& now) {
  return std::tuple(size, i ^ k, std::min(i, k)) < std::tuple(now.size, i ^ now.place, std::min(i, now.place));
}

Partner nearest(std::span<const Cluster> clusters, std::uint32_t i, std::uint32_t from, std::uint32_t to) {
  Partner best;
  best.place = std::numeric_limits<std::uint32_t>::max();
  for (std::uint32_t k = from; k < to; ++k) {
    if (k == i) continue;
    const float size = size_of(clusters[i].box, clusters[k].box);
    if (improves(size, i, k, best)) best = {size, k};
  }
  return best;
}

}  // namespace

// Meister and Bittner 2018.
Built build_agglomerative(const std::vector<BoxedItem>& items, const BvhOptions& options) {
  constexpr std::uint32_t radius = 12;
  constexpr std::size_t block_size = 1 << 10;
  PairTree tree{items, {}};
  tree.pairs.reserve(items.size());
  std::vector<Cluster> clusters;
  for (const std::uint32_t i : morton_order(options.execution, items)) clusters.push_back({i, box_of(items[i])});
  std::vector<std::uint32_t> partner(items.size());
  while (clusters.size() > 1) {
    const auto n = static_cast<std::uint32_t>(clusters.size());
    for_blocks(options.execution, n, block_size, [&](std::size_t, std::size_t from, std::size_t to) {
      for (auto i = static_cast<std::uint32_t>(from); i < to; ++i)
        partner[i] = nearest(clusters, i, i - std::min(i, radius), std::min(n, i + radius + 1)).place;
    });
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const bool mutual = partner[partner[i]] == i;
      if (mutual && partner[i] < i) continue;
      Cluster now = clusters[i];
      if (mutual) {
        const Cluster& other = clusters[partner[i]];
        tree.pairs.push_back({now.number, other.number});
        now.number = tree.root();
        now.box.take(other.box);
      }
      clusters[kept++] = now;
    }
    clusters.resize(kept);
  }
  return lay_out(tree, options);
}

Built build_of_nearest_pairs(const std::vector<BoxedItem>& items, const BvhOptions& options) {
  PairTree tree{items, {}};
  std::vector<Cluster> clusters;
  for (std::uint32_t i = 0; i < items.size(); ++i) clusters.push_back({i, box_of(items[i])});
  const auto count = [&] { return static_cast<std::uint32_t>(clusters.size()); };
  std::vector<Partner> partner(items.size());
  for_blocks(options.execution, clusters.size(), 64, [&](std::size_t, std::size_t from, std::size_t to) {
    for (auto i = static_cast<std::uint32_t>(from); i < to; ++i) partner[i] = nearest(clusters, i, 0, count());
  });
  while (count() > 1) {
    std::uint32_t a = 0;
    for (std::uint32_t i = 1; i < count(); ++i) {
      if (partner[i].size < partner[a].size) a = i;
    }
    const std::uint32_t b = partner[a].place, last = count() - 1;
    tree.pairs.push_back({clusters[a].number, clusters[b].number});
    clusters[a].number = tree.root();
    clusters[a].box.take(clusters[b].box);
    clusters[b] = clusters[last];  // the last takes the place of what is gone
    partner[b] = partner[last];
    clusters.pop_back();
    partner.pop_back();
    const std::uint32_t merged = a == last ? b : a;
    for (std::uint32_t i = 0; i < count(); ++i) {
      Partner& p = partner[i];
      if (i == merged || p.place == a || p.place == b) {
        p = nearest(clusters, i, 0, count());
        continue;
      }
      if (p.place == last) p.place = b;
      const float size = size_of(clusters[i].box, clusters[merged].box);
      if (improves(size, i, merged, p)) p = {size, merged};
    }
  }
  return lay_out(tree, options);
}

}  // namespace plumb::space
