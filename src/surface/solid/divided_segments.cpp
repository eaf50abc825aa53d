#include "surface/solid/divided_segments.hpp"

#include <algorithm>

#include "certify/exact_coordinates.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::surface {
namespace {

bool boxes_meet(const Aabb2& a, const Aabb2& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

class SegmentDivider {
 public:
  SegmentDivider(SeenPoints& points, std::span<const SegmentEnds> segments) : points_(points), segments_(segments) {
    for (const SegmentEnds& s : segments) along_.push_back({s[0], s[1]});
  }

  void meet(std::uint32_t i, std::uint32_t k) {
    const SegmentEnds s = segments_[i], t = segments_[k];
    if (s[0] == t[0] && s[1] == t[1]) return;
    const Sign c = side(s, t[0]), d = side(s, t[1]);
    if (c == d && c != Sign::zero) return;
    const Sign a = side(t, s[0]), b = side(t, s[1]);
    if (c == Sign::zero) add_between(i, t[0]);
    if (d == Sign::zero) add_between(i, t[1]);
    if (a == Sign::zero) add_between(k, s[0]);
    if (b == Sign::zero) add_between(k, s[1]);
    if (a * b == Sign::negative && c * d == Sign::negative) {
      const std::uint32_t crossing = points_.add_crossing(s, t);
      along_[i].push_back(crossing);
      along_[k].push_back(crossing);
    }
  }

  std::vector<std::vector<std::uint32_t>> sorted() {
    const auto before = [&](std::uint32_t l, std::uint32_t r) {
      return compare_xy(points_.seen(l), points_.seen(r)) == Sign::negative;
    };
    for (std::size_t i = 0; i < along_.size(); ++i) {
      auto& along = along_[i];
      if (along.size() > 2) std::ranges::sort(along, before);
      along.erase(std::unique(along.begin(), along.end()), along.end());
      if (along.front() != segments_[i][0]) std::ranges::reverse(along);
    }
    return std::move(along_);
  }

 private:
  [[nodiscard]] Sign side(const SegmentEnds& s, std::uint32_t p) const {
    if (s[0] == s[1] || p == s[0] || p == s[1] || points_.is_noted_on(p, s)) return Sign::zero;
    return orient2d(points_.seen(s[0]), points_.seen(s[1]), points_.seen(p));
  }
  /// The point is on the line of the segment.
  void add_between(std::uint32_t i, std::uint32_t p) {
    const auto& [a, b] = segments_[i];
    if (a == b || p == a || p == b) return;
    const Sign from = compare_xy(points_.seen(a), points_.seen(p)), to = compare_xy(points_.seen(p), points_.seen(b));
    if (from == to) along_[i].push_back(p);
  }

  SeenPoints& points_;
  std::span<const SegmentEnds> segments_;
  std::vector<std::vector<std::uint32_t>> along_;
};

}  // namespace

std::uint32_t SeenPoints::add(std::uint32_t number_in_table) {
  const auto [at, is_new] = known_.try_emplace(number_in_table, static_cast<std::uint32_t>(seen_.size()));
  if (is_new) {
    numbers_.push_back(number_in_table);
    seen_.push_back(view_.seen(table_.points().at(number_in_table)));
  }
  return at->second;
}

// With weights: of all sums of multiples of a and b, the one that is on the line cd.
std::uint32_t SeenPoints::add_crossing(const SegmentEnds& ab, const SegmentEnds& cd) {
  using Place = certify::meeting::Weighted<BigDyadic, 3>;
  const auto place = [this](std::uint32_t i) { return certify::meeting::coordinates_in<BigDyadic>(point(i)); };
  const Place a = place(ab[0]), b = place(ab[1]), c = place(cd[0]), d = place(cd[1]);
  const auto axes = view_.seen_axes();
  const auto minor = [](const BigDyadic& p, const BigDyadic& q, const BigDyadic& r, const BigDyadic& s) {
    return p * s - q * r;
  };
  // The line through c and d: x, y and weight times these are 0 in sum.
  const BigDyadic &cx = c.at[axes[0]], &cy = c.at[axes[1]], &dx = d.at[axes[0]], &dy = d.at[axes[1]];
  const std::array<BigDyadic, 3> line{minor(cy, c.weight, dy, d.weight), minor(c.weight, cx, d.weight, dx),
                                      minor(cx, cy, dx, dy)};
  const auto height = [&](const Place& p) {
    return line[0] * p.at[axes[0]] + line[1] * p.at[axes[1]] + line[2] * p.weight;
  };
  const BigDyadic of_a = height(a), of_b = height(b);
  const Place crossing{
      {minor(a.at[0], b.at[0], of_a, of_b), minor(a.at[1], b.at[1], of_a, of_b), minor(a.at[2], b.at[2], of_a, of_b)},
      minor(a.weight, b.weight, of_a, of_b)};
  return add(table_.number_of(certify::meeting::rational(crossing)));
}

std::vector<std::vector<std::uint32_t>> points_along(SeenPoints& points, std::span<const SegmentEnds> segments) {
  // The nearest doubles of a point that two segments share are in both boxes: rounding keeps order.
  std::vector<Aabb2> boxes;
  boxes.reserve(segments.size());
  for (const auto& [i, k] : segments) {
    const Point2 a = approximate(points.seen(i)), b = approximate(points.seen(k));
    boxes.push_back({{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}});
  }
  SegmentDivider divider(points, segments);
  const auto count = static_cast<std::uint32_t>(segments.size());
  if (count <= 24) {
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t k = i + 1; k < count; ++k)
        if (boxes_meet(boxes[i], boxes[k])) divider.meet(i, k);
  } else {
    for (const BoxPair& pair : overlapping_pairs(std::span<const Aabb2>(boxes))) divider.meet(pair.a, pair.b);
  }
  return divider.sorted();
}

}  // namespace plumb::surface
