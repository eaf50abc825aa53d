#include "plumb/space/kd_tree/split_tree.hpp"

#include <string>
#include <utility>

#include "certify/batch/all_threads.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/figure_input.hpp"
#include "space/kd_tree/kept_figures.hpp"
#include "space/kd_tree/split_plane.hpp"
#include "space/octree/box_sides.hpp"

namespace plumb {
namespace space::kd {
namespace {

constexpr std::uint32_t most_split_depth = 60;

/// A subtree, whose links count from its own first node, leaf and place.
struct SplitPiece {
  std::vector<SplitNode> nodes;
  std::vector<std::uint32_t> first = {0}, items;

  void add(const SplitPiece& other) {
    const auto node = static_cast<std::uint32_t>(nodes.size()), leaf = static_cast<std::uint32_t>(first.size() - 1),
               item = static_cast<std::uint32_t>(items.size());
    for (SplitNode n : other.nodes) {
      n.link += n.is_leaf() ? leaf : node;
      nodes.push_back(n);
    }
    for (std::size_t i = 1; i < other.first.size(); ++i) first.push_back(item + other.first[i]);
    items.insert(items.end(), other.items.begin(), other.items.end());
  }
};

template <class Figure>
class SplitBuilder {
 public:
  static constexpr std::size_t d = SplitTree<Figure>::dimension;
  using Cell = SplitCell<d>;

  SplitBuilder(std::span<const Figure> figures, std::span<const Cell> ends, const Cell& all,
               const SplitTreeOptions& options)
      : figures_(figures), ends_(ends), chooser_(all), options_(options) {}

  /// The subtree of a cell, clipped by the box of all figures; `budget` is how many places it may have in leaves.
  void build(SplitPiece& out, const std::vector<std::uint32_t>& items, const Cell& cell, std::uint32_t depth,
             std::size_t budget) const {
    const std::size_t at = out.nodes.size();
    out.nodes.push_back({0, SplitNode::leaf_axis, static_cast<std::uint32_t>(out.first.size() - 1)});
    const auto plane =
        depth < options_.most_depth && items.size() > options_.most_in_leaf
            ? chooser_.best(
                  cell, items.size(), [&](std::size_t i, std::size_t a) { return ends_[items[i]].low[a]; },
                  [&](std::size_t i, std::size_t a) { return ends_[items[i]].high[a]; })
            : std::nullopt;
    if (!plane || plane->lower + plane->upper > budget) {
      out.items.insert(out.items.end(), items.begin(), items.end());
      out.first.push_back(static_cast<std::uint32_t>(out.items.size()));
      return;
    }
    Cell below = cell, above = cell;
    below.high[plane->axis] = above.low[plane->axis] = plane->plane;
    std::vector<std::uint32_t> lower, upper;
    lower.reserve(plane->lower), upper.reserve(plane->upper);
    divide(items, *plane, below, above, lower, upper);
    // What is left of the budget goes where there are more.
    const std::size_t both = lower.size() + upper.size(), rest = budget - both;
    const auto share = static_cast<std::size_t>(static_cast<double>(rest) * static_cast<double>(lower.size()) /
                                                static_cast<double>(std::max<std::size_t>(both, 1)));
    const std::size_t for_lower = lower.size() + std::min(share, rest), for_upper = budget - for_lower;
    out.nodes[at] = {plane->plane, plane->axis, 0};
    constexpr std::size_t worth_a_task = 4096;
    if (options_.execution == Execution::parallel && items.size() > worth_a_task) {
      SplitPiece piece;
      certify::batch::for_each_part(Execution::parallel, 2, [&](std::size_t half) {
        half == 0 ? build(out, lower, below, depth + 1, for_lower) : build(piece, upper, above, depth + 1, for_upper);
      });
      out.nodes[at].link = static_cast<std::uint32_t>(out.nodes.size());
      out.add(piece);
    } else {
      build(out, lower, below, depth + 1, for_lower);
      out.nodes[at].link = static_cast<std::uint32_t>(out.nodes.size());
      build(out, upper, above, depth + 1, for_upper);
    }
  }

 private:
  /// A box that lies across the plane has points in both halves; another figure is asked.
  void divide(const std::vector<std::uint32_t>& items, const SplitPlane& plane, const Cell& below, const Cell& above,
              std::vector<std::uint32_t>& lower, std::vector<std::uint32_t>& upper) const {
    const auto lower_box = box_between(below.low, below.high), upper_box = box_between(above.low, above.high);
    for (const std::uint32_t i : items) {
      bool in_lower = ends_[i].low[plane.axis] < plane.plane, in_upper = ends_[i].high[plane.axis] >= plane.plane;
      if constexpr (!std::is_same_v<Figure, typename SplitTree<Figure>::Box>) {
        if (in_lower && in_upper) {
          in_lower = intersects(figures_[i], lower_box);
          in_upper = intersects(figures_[i], upper_box);
        }
      }
      if (in_lower) lower.push_back(i);
      if (in_upper) upper.push_back(i);
    }
  }

  std::span<const Figure> figures_;
  std::span<const Cell> ends_;
  PlaneChooser<d> chooser_;
  const SplitTreeOptions& options_;
};

void check_split_options(const SplitTreeOptions& options) {
  const auto refuse = [](const char* name, const std::string& is, const std::string& must) {
    throw InvalidShape(std::string("build_split_tree: options.") + name + " is " + is + ", but it must " + must);
  };
  if (options.most_in_leaf < 1) refuse("most_in_leaf", "0", "be at least 1");
  if (options.most_depth > most_split_depth)
    refuse("most_depth", std::to_string(options.most_depth), "be at most " + std::to_string(most_split_depth));
  if (!(options.most_references >= 1 && options.most_references <= 1000))
    refuse("most_references", std::to_string(options.most_references), "lie from 1 to 1000");
}

template <std::size_t d>
SplitCell<d> ends_of(const Aabb3& box) {
  const auto low = coordinates(box.min), high = coordinates(box.max);
  SplitCell<d> cell;
  for (std::size_t a = 0; a < d; ++a) cell.low[a] = low[a], cell.high[a] = high[a];
  return cell;
}

}  // namespace
}  // namespace space::kd

template <KeptFigure Figure>
SplitTree<Figure> build_split_tree(std::span<const Figure> figures, const SplitTreeOptions& options) {
  using namespace space::kd;
  constexpr std::size_t d = SplitTree<Figure>::dimension, most_figures = std::size_t{1} << 31;
  check_split_options(options);
  if (figures.size() > most_figures)
    throw InvalidShape("build_split_tree: " + std::to_string(figures.size()) +
                       " figures, but 2^31 at most are numbered");
  const auto boxes = checked_boxes_of("build_split_tree", figures, options.execution);
  SplitTree<Figure> tree;
  tree.figures.assign(figures.begin(), figures.end());
  if (figures.empty()) return tree;
  std::vector<SplitCell<d>> ends;
  std::vector<std::uint32_t> items;
  SplitCell<d> all = ends_of<d>(boxes[0]);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    ends.push_back(ends_of<d>(boxes[i])), items.push_back(static_cast<std::uint32_t>(i));
    for (std::size_t a = 0; a < d; ++a) {
      all.low[a] = std::min(all.low[a], ends[i].low[a]), all.high[a] = std::max(all.high[a], ends[i].high[a]);
    }
  }
  const double budget = std::min(options.most_references * static_cast<double>(items.size()), 0x1p32 - 1);
  SplitPiece piece;
  SplitBuilder<Figure>(figures, ends, all, options)
      .build(piece, items, all, 0, std::max(items.size(), static_cast<std::size_t>(budget)));
  tree.nodes = std::move(piece.nodes), tree.first = std::move(piece.first), tree.items = std::move(piece.items);
  return tree;
}

template <KeptFigure Figure>
std::uint32_t locate(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Point& p) {
  query::require_figure("locate", "p", p);
  if (tree.nodes.empty()) return 0;
  const auto at = coordinates(p);
  std::uint32_t node = 0;
  while (!tree.nodes[node].is_leaf()) {
    const SplitNode& n = tree.nodes[node];
    node = at[n.axis] < n.plane ? node + 1 : n.link;
  }
  return tree.nodes[node].link;
}

template <KeptFigure Figure>
std::size_t memory_of(const SplitTree<Figure>& tree) {
  return sizeof(SplitNode) * tree.nodes.capacity() +
         sizeof(std::uint32_t) * (tree.first.capacity() + tree.items.capacity()) +
         sizeof(Figure) * tree.figures.capacity();
}

#define PLUMB_INSTANTIATE(F)                                                           \
  template SplitTree<F> build_split_tree(std::span<const F>, const SplitTreeOptions&); \
  template std::uint32_t locate(const SplitTree<F>&, const SplitTree<F>::Point&);      \
  template std::size_t memory_of(const SplitTree<F>&);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
