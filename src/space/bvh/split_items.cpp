#include "space/bvh/split_items.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "space/bvh/parts.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/triangle_part.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t split_block = 1 << 10;
constexpr std::uint32_t most_more = 255;  // parts of one triangle beside the first

/// How much of a box's area is not its triangle's: a guess, by which parts are handed out and nothing is decided.
float empty_area(const BoxedItem& item, const BoxFrame& frame, const Triangle3& t) {
  const auto in_frame = [&](const Point3& p) {
    return std::array<float, 3>{frame.below(p.x), frame.below(p.y), frame.below(p.z)};
  };
  const std::array<float, 3> a = in_frame(t.a), b = in_frame(t.b), c = in_frame(t.c);
  float shadows = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    shadows += std::abs((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) / 2;
  }
  Extent box;
  box.take(item.low(), item.high());
  return std::max(0.0F, half_area(box) - shadows);
}

/// So many more parts as go by the roots of what is empty: the area of n parts is about an nth, so that each further one
/// then saves the same everywhere.
std::vector<std::uint32_t> handed_out(const std::vector<float>& roots, double budget) {
  const auto more = [](double scale, float root) {
    return static_cast<std::uint32_t>(std::min<double>(most_more, scale * static_cast<double>(root)));
  };
  std::vector<float> some;
  for (const float root : roots) {
    if (root > 0) some.push_back(root);
  }
  double low = 0,
         high = some.empty() ? 0 : most_more / static_cast<double>(*std::min_element(some.begin(), some.end()));
  // Guesses, as every handing out is true: how often to halve, and how much lower to look at once.
  constexpr int most_steps = 48;
  constexpr double lowest_part = 0x1p-40;
  for (int step = 0; step < most_steps && low < high; ++step) {
    // By their exponents first: the scale may be anything.
    const double middle =
        low == 0 || high / low > 4 ? std::max(std::sqrt(low) * std::sqrt(high), high * lowest_part) : (low + high) / 2;
    double sum = 0;
    for (const float root : some) sum += more(middle, root);
    (sum <= budget ? low : high) = middle;
  }
  std::vector<std::uint32_t> parts(roots.size());
  for (std::size_t i = 0; i < roots.size(); ++i) parts[i] = more(low, roots[i]);
  return parts;
}

/// The box of the triangle and those of so many more parts of it, or fewer where none can be halved: always that with
/// the most area.
void cut(const Triangle3& triangle, const BoxFrame& frame, std::uint32_t more, std::vector<FloatBox3>& out) {
  struct Part {
    Aabb3 box;
    float area;  // negative where it is not to be halved again
  };
  const auto part_of = [&](const Aabb3& box) {
    const FloatBox3 b = frame.around(box);
    return Part{box, half_area(BoxNode{b.min, 0, b.max, 0})};
  };
  std::vector<Part> parts{part_of(box_around(triangle.a, triangle.b, triangle.c))};
  for (std::uint32_t tries = 0; parts.size() <= more && tries < 2 * more; ++tries) {
    const auto largest =
        std::max_element(parts.begin(), parts.end(), [](const Part& x, const Part& y) { return x.area < y.area; });
    if (largest->area < 0) break;
    const std::optional<Halves> both = halves(triangle, largest->box);
    if (!both || (!(*both)[0] && !(*both)[1])) {
      largest->area = -1;
      continue;
    }
    const auto& [first, second] = *both;
    *largest = part_of(first ? *first : *second);
    if (first && second) parts.push_back(part_of(*second));
  }
  for (const Part& part : parts) out.push_back(frame.around(part.box));
}

}  // namespace

SplitItems split_items(std::span<const BoxedItem> whole, const BoxFrame& frame, std::span<const Point3> vertices,
                       std::span<const Bvh::Corners> triangles, double share, Execution execution) {
  const std::size_t n = whole.size();
  const auto triangle = [&](std::size_t i) {
    const Bvh::Corners& c = triangles[i];
    return Triangle3{vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  };
  std::vector<float> roots(n);
  for_blocks(execution, n, split_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) roots[i] = std::sqrt(empty_area(whole[i], frame, triangle(i)));
  });
  const std::vector<std::uint32_t> more = handed_out(roots, share * static_cast<double>(n));
  std::vector<SplitItems> blocks(blocks_of(n, split_block));
  for_blocks(execution, n, split_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    std::vector<FloatBox3> parts;
    for (std::size_t i = from; i < to; ++i) {
      parts.assign(1, FloatBox3{whole[i].min, whole[i].max});
      if (more[i] > 0) {
        parts.clear();
        cut(triangle(i), frame, more[i], parts);
      }
      for (const FloatBox3& part : parts) {
        blocks[b].items.push_back({part.min, 0, part.max, 0});
        blocks[b].triangles.push_back(static_cast<std::uint32_t>(i));
      }
    }
  });
  SplitItems all;
  for (const SplitItems& block : blocks) {
    all.items.insert(all.items.end(), block.items.begin(), block.items.end());
    all.triangles.insert(all.triangles.end(), block.triangles.begin(), block.triangles.end());
  }
  for (std::size_t i = 0; i < all.items.size(); ++i) all.items[i].item = static_cast<std::uint32_t>(i);
  return all;
}

void join_parts(Built& built, std::span<const std::uint32_t> triangles) {
  std::uint32_t end = 0;
  for (BoxNode& node : built.nodes) {  // leaves in the order of their slots, so that none is overwritten unread
    if (!node.is_leaf()) continue;
    const auto first = built.items.begin() + node.link;
    std::transform(first, first + node.count, first, [&](std::uint32_t part) { return triangles[part]; });
    std::sort(first, first + node.count);
    const auto last = std::unique(first, first + node.count);
    node.count = static_cast<std::uint32_t>(last - first);
    std::copy(first, last, built.items.begin() + end);
    node.link = std::exchange(end, end + node.count);
  }
  built.items.resize(end);
}

}  // namespace plumb::space
