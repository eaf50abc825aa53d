#include <algorithm>

#include "degenerate/body_drawing.hpp"

namespace plumb::degenerate {

namespace {

/// A corner of a hole: so many eighths of the way to a vertex, and to the next one.
struct Eighths {
  Int first, second;
};
using Hole = std::array<Eighths, 3>;

constexpr Hole inner{{{1, 1}, {5, 1}, {1, 5}}};
constexpr Hole at_vertex{{{8, 0}, {4, 2}, {4, 1}}}, at_edge{{{4, 4}, {1, 2}, {2, 1}}};
constexpr Hole along_edge{{{6, 2}, {2, 6}, {2, 2}}};
constexpr Hole beside_inner{{{5, 1}, {6, 0}, {6, 1}}};
constexpr Hole within_inner{{{2, 2}, {3, 2}, {2, 3}}}, at_vertex_within_inner{{{1, 1}, {3, 2}, {2, 3}}};

/// What may be cut out of the triangle of the origin and two neighbors of a star.
std::vector<Hole> any_holes(Entropy& entropy) {
  switch (entropy.below(8)) {
    case 1:
      return {at_vertex};
    case 2:
      return {at_edge};
    case 3:
      return {along_edge};
    case 4:
      return {inner, beside_inner};
    case 5:
      return {inner, within_inner};
    case 6:
      return {inner, at_vertex_within_inner};
    case 7:
      return {};
    default:
      return {inner};
  }
}

/// Simple, as it is a star about the origin: in a plane whose second axis may lie or lean.
class Star {
 public:
  explicit Star(const Drawing& draw)
      : draw_(draw), second_(draw.order.feature == 2 && draw.order.dimension == 3 ? 1 : 2) {
    if (draw.order.kind == ShapeKind::holed_polygon) unit_ = Drawing::fraction;
  }

  Body made() {
    const BodyOrder& order = draw_.order;
    Entropy& entropy = draw_.entropy;
    const bool quadrilateral = order.kind == ShapeKind::quadrilateral;
    const std::size_t count = quadrilateral ? 4 : 3 + entropy.below(6);
    choose(count);
    const auto part = [](const Flat& v) { return v == Flat{} ? 0 : v[1] > 0 || (v[1] == 0 && v[0] > 0) ? 1 : 2; };
    // On one ray nearer points come first, on the last one last: a chain that runs back would cross nothing either.
    std::stable_sort(star_.begin(), star_.end(), [&](const Flat& a, const Flat& b) {
      if (part(a) != part(b)) return part(a) < part(b);
      return a[0] * b[1] - a[1] * b[0] > 0;
    });
    lean_ = order.upright ? 0 : entropy.within(3);
    rise_ = order.upright ? 1 : 1 + static_cast<Int>(entropy.below(3));
    Body body{order.kind, {}};
    auto& p = body.points;
    for (const Flat& v : star_) p.push_back(lifted(v));
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(entropy.below(count)), p.end());
    if (entropy.coin()) std::reverse(p.begin(), p.end());
    if (order.kind == ShapeKind::holed_polygon) {
      body.parts = {count};
      cut_holes(body);
    }
    return body;
  }

 private:
  void choose(std::size_t count) {
    const BodyOrder& order = draw_.order;
    const Int size = Drawing::fraction * order.shared;
    const bool shared = order.shared != 0;
    if (order.feature == 2 && shared) {
      star_ = {{size, size}, {-size, size}, {-size, -size}, {size, -size}};
    } else if (order.feature == 2) {
      const auto [right, over] = draw_.corners(second_);
      star_ = {scaled(right), scaled(over)};
      star_.push_back({-star_[0][0] - star_[1][0], -star_[0][1] - star_[1][1]});
    } else if (order.feature == 1) {
      star_ = {{shared ? size : unit_ * draw_.length(0), 0}, {shared ? -size : -unit_ * draw_.length(0), 0}};
    } else {
      star_ = {{0, 0}};
    }
    while (star_.size() < count) {
      const Flat next{draw_.somewhere(0), order.feature == 2 ? draw_.somewhere(second_) : draw_.length(second_)};
      star_.push_back(order.feature == 2 && next == Flat{} ? star_[0] : scaled(next));
    }
  }
  [[nodiscard]] Flat scaled(const Flat& v) const { return {unit_ * v[0], unit_ * v[1]}; }

  [[nodiscard]] Int3 lifted(const Flat& v) const {
    if (second_ == 1) return {v[0], v[1], 0};
    if (draw_.order.dimension == 2) return {v[0], 0, v[1]};
    return {v[0], lean_ * v[1], rise_ * v[1]};
  }

  void cut_holes(Body& body) {
    for (std::size_t i = 0; i < star_.size(); ++i) {
      const Flat a = star_[i], b = star_[(i + 1) % star_.size()];
      if (a[0] * b[1] - a[1] * b[0] <= 0) continue;
      for (const Hole& hole : any_holes(draw_.entropy)) {
        body.parts.push_back(hole.size());
        for (const auto& [first, second] : hole) {
          body.points.push_back(lifted({(first * a[0] + second * b[0]) / 8, (first * a[1] + second * b[1]) / 8}));
        }
      }
    }
  }

  const Drawing& draw_;
  std::size_t second_;
  Int unit_ = 1, lean_ = 0, rise_ = 1;
  std::vector<Flat> star_;
};

}  // namespace

Body chain_body(const Drawing& draw) { return Star(draw).made(); }

}  // namespace plumb::degenerate
