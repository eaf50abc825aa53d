// A tree as it lies in space: cuts through it at some depths, a box a node, and the cost of every depth.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "tool/bvh/command.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

class TreeDrawing {
  static constexpr double kWidth = 960, kEdge = 24, kTop = 84, kGap = 16, kColumns = 4;
  static constexpr double kPanel = (kWidth - 2 * kEdge - (kColumns - 1) * kGap) / kColumns;
  static constexpr double kHeading = 24, kTallest = 280, kFlattest = 40;
  static constexpr double kLeft = 64, kBars = 180, kBottom = 56;
  static constexpr std::array<std::uint32_t, 8> kDepths{1, 2, 3, 4, 5, 6, 8, 10};

 public:
  TreeDrawing(const BoxTree& tree) : nodes_(tree.nodes.view()), depth_(depths_of(tree)), levels_(levels_of(tree)) {
    const BoxNode root = nodes_.empty() ? BoxNode{} : nodes_[0];
    const auto extent = [&](std::size_t axis) { return double(root.max[axis]) - root.min[axis]; };
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (extent(axis) < extent(along_)) along_ = axis;
    }
    if (extent(2) == extent(along_)) along_ = 2;
    right_ = along_ == 0 ? 1 : 0;
    up_ = along_ == 2 ? 1 : 2;
    const double wide = extent(right_), high = extent(up_);
    panel_height_ = wide > 0 ? std::clamp(kPanel * high / wide, kFlattest, kTallest) : kTallest;
    pixels_ = std::min(wide > 0 ? kPanel / wide : 1e300, high > 0 ? panel_height_ / high : 1e300);
    if (!(wide > 0) && !(high > 0)) pixels_ = 1;
    for (const std::uint32_t d : kDepths) {
      if (d < levels_.size()) shown_.push_back(d);
    }
    if (shown_.empty() && !levels_.empty()) shown_.push_back(0);
  }

  std::string draw(const std::string& title, const std::string& counts) {
    const double rows = std::ceil(static_cast<double>(shown_.size()) / kColumns);
    const double bars_top = kTop + rows * (kHeading + panel_height_ + kGap) + 40, height = bars_top + kBars + kBottom;
    put("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
        kWidth, height, escaped(title));
    out_ += chart_style;
    put("<style>\n  .box {{ stroke: #0072b2; fill-opacity: 0.13; }}\n"
        "  .leaf {{ stroke: #d55e00; fill-opacity: 0.3; }}\n</style>\n");
    put("<rect class=\"paper\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", kWidth, height);
    put("<text x=\"24\" y=\"36\" font-size=\"19\" font-weight=\"600\">{}</text>\n", escaped(title));
    constexpr std::string_view axes = "xyz";
    put("<text class=\"muted\" x=\"24\" y=\"58\" font-size=\"13\">{}; the boxes at some depths, {} to the right and {} "
        "up, leaves orange</text>\n",
        counts, axes[right_], axes[up_]);
    for (std::size_t i = 0; i < shown_.size(); ++i) panel(i);
    if (!levels_.empty()) bars(bars_top);
    return out_ + "</svg>\n";
  }

 private:
  template <class... A>
  void put(fmt::format_string<A...> form, A&&... values) {
    fmt::format_to(std::back_inserter(out_), form, std::forward<A>(values)...);
  }

  /// What the tree is at this depth: its nodes, and the leaves above.
  void panel(std::size_t i) {
    const std::uint32_t depth = shown_[i];
    const double left = kEdge + static_cast<double>(i % std::size_t(kColumns)) * (kPanel + kGap);
    const double top = kTop + std::floor(static_cast<double>(i) / kColumns) * (kHeading + panel_height_ + kGap);
    std::string boxes;
    std::uint64_t many = 0;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const BoxNode& node = nodes_[n];
      if (depth_[n] > depth || (depth_[n] < depth && !node.is_leaf())) continue;
      ++many;
      const auto at = [&](float x, std::size_t axis) { return (double(x) - nodes_[0].min[axis]) * pixels_; };
      const double x = at(node.min[right_], right_), wide = at(node.max[right_], right_) - x;
      const double y = at(node.min[up_], up_), high = at(node.max[up_], up_) - y;
      fmt::format_to(std::back_inserter(boxes),
                     "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                     node.is_leaf() ? "leaf s1" : "box s0", left + x, top + kHeading + panel_height_ - y - high, wide,
                     high);
    }
    put("<g id=\"depth-{}\" stroke-width=\"{}\">\n<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" "
        "font-weight=\"600\">depth {}: "
        "{}</text>\n{}</g>\n",
        depth, many <= 100 ? 0.8 : 0.35, left, top + kHeading - 8, depth, plural(many, "box", "boxes"), boxes);
  }

  static double cost(const TreeLevel& level) { return level.nodes_met + 0.5 * level.items_met; }

  void bars(double top) {
    double most = 0;
    for (const TreeLevel& level : levels_) most = std::max(most, cost(level));
    const double bottom = top + kBars, step = round_step(most / 4);
    const auto at = [&](double value) { return bottom - value / most * (kBars - 10); };
    put("<text x=\"24\" y=\"{:.1f}\" font-size=\"13\" font-weight=\"600\">cost by depth: nodes that a line meets on "
        "the "
        "average (blue), and half the triangles in their leaves (orange)</text>\n",
        top - 14);
    for (double value = 0; value <= most; value += step) {
      put("<line class=\"grid\" x1=\"{0:.0f}\" y1=\"{1:.1f}\" x2=\"{2:.0f}\" y2=\"{1:.1f}\"/>\n"
          "<text class=\"muted\" font-size=\"12\" x=\"{3:.0f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
          kLeft, at(value), kWidth - kEdge, kLeft - 10, at(value) + 4.5, value);
    }
    const double each = (kWidth - kEdge - kLeft) / static_cast<double>(levels_.size()),
                 wide = std::min(0.8 * each, 48.0);
    const std::size_t named = levels_.size() <= 32 ? 1 : 4;
    for (std::size_t d = 0; d < levels_.size(); ++d) {
      const TreeLevel& level = levels_[d];
      const double middle = kLeft + each * (static_cast<double>(d) + 0.5), low = at(level.nodes_met);
      put("<g><title>depth {}: {}, {}; meets {:.4g} and {:.4g}</title>\n", d, plural(level.nodes, "node", "nodes"),
          plural(level.leaves, "leaf", "leaves"), level.nodes_met, level.items_met);
      bar("s0", middle - wide / 2, low, wide, bottom - low);
      bar("s1", middle - wide / 2, at(cost(level)), wide, low - at(cost(level)));
      out_ += "</g>\n";
      if (d % named != 0) continue;
      put("<text class=\"muted\" font-size=\"12\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", middle,
          bottom + 20, d);
    }
    put("<line class=\"axis\" x1=\"{0:.0f}\" y1=\"{1:.1f}\" x2=\"{2:.0f}\" y2=\"{1:.1f}\"/>\n"
        "<text x=\"{2:.0f}\" y=\"{3:.1f}\" font-size=\"12.5\" text-anchor=\"end\">depth</text>\n",
        kLeft, bottom, kWidth - kEdge, bottom + 42);
  }

  void bar(std::string_view color, double x, double y, double wide, double high) {
    put("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", color, x, y, wide, high);
  }

  /// 1, 2 or 5 times a power of ten, at least as much.
  static double round_step(double least) {
    const double ten = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor * ten >= least) return factor * ten;
    }
    return 10 * ten;
  }

  std::span<const BoxNode> nodes_;
  std::vector<std::uint32_t> depth_;
  std::vector<TreeLevel> levels_;
  std::size_t along_ = 0, right_ = 0, up_ = 1;
  double panel_height_ = 0, pixels_ = 1;
  std::vector<std::uint32_t> shown_;
  std::string out_;
};

}  // namespace

std::string tree_svg(const std::string& mesh_name, const BoxTree& tree, BvhMethod method) {
  const TreeCost cost = cost_of(tree);
  return TreeDrawing(tree).draw(
      fmt::format("The tree of {}, {}", mesh_name, name_of(method)),
      fmt::format("{}, {}, depth {}, cost {:.2f}", plural(tree.items.size(), "triangle", "triangles"),
                  plural(cost.nodes, "node", "nodes"), cost.depth, cost.total(1, 0.5)));
}

}  // namespace plumb::tool
