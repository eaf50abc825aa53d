#include "space/octree/cut_cells.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "space/bvh/parts.hpp"
#include "space/octree/cell_keys.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t cell_block = 1 << 10;

/// Where the children's runs begin, and the last one ends; the cell's own items lie before `middle`.
template <std::size_t D>
struct Runs {
  std::array<std::uint32_t, (std::size_t{1} << D) + 1> begin;
  std::uint32_t own_begin;
};

/// By a look at each, which takes less than searches that no processor foresees.
template <std::size_t D>
Runs<D> runs_of_few(std::span<const KeyedItem> sorted, const CellNode& cell, unsigned level) {
  constexpr std::size_t children = std::size_t{1} << D, middle = children / 2;
  const unsigned below = static_cast<unsigned>(D) * (CellFrame<D>::levels - level - 1) + 1;
  const std::uint64_t own = first_key<D>(cell.code << D | middle, level + 1);
  std::array<std::uint32_t, children> end;
  end.fill(cell.begin);
  std::uint32_t own_count = 0;
  for (std::uint32_t i = cell.begin; i < cell.end; ++i) {
    const std::uint64_t key = sorted[i].key;
    end[key >> below & (children - 1)] = i + 1;
    own_count += key == own ? 1 : 0;
  }
  Runs<D> runs;
  runs.begin[0] = cell.begin;
  for (std::size_t c = 0; c < children; ++c) runs.begin[c + 1] = std::max(runs.begin[c], end[c]);
  runs.own_begin = runs.begin[middle];
  runs.begin[middle] += own_count;
  return runs;
}

template <std::size_t D>
Runs<D> runs_of(std::span<const KeyedItem> sorted, const CellNode& cell, unsigned level) {
  constexpr std::uint32_t few = 128;
  if (cell.count() <= few) return runs_of_few<D>(sorted, cell, level);
  constexpr std::size_t children = std::size_t{1} << D, middle = children / 2;
  const auto first_at = [&](std::uint32_t from, std::uint64_t key) {
    const auto before = [](const KeyedItem& a, std::uint64_t k) { return a.key < k; };
    return static_cast<std::uint32_t>(std::lower_bound(sorted.begin() + from, sorted.begin() + cell.end, key, before) -
                                      sorted.begin());
  };
  Runs<D> runs;
  std::uint32_t at = cell.begin;
  for (std::size_t c = 0; c < children; ++c) {
    const std::uint64_t key = first_key<D>(cell.code << D | c, level + 1);
    if (c != 0) at = first_at(at, key);
    if (c == middle) {  // the cell's own key
      runs.own_begin = at;
      at = first_at(at, key + 1);
    }
    runs.begin[c] = at;
  }
  runs.begin[children] = cell.end;
  return runs;
}

}  // namespace

template <std::size_t D>
std::vector<CellNode> cut_cells(std::span<const KeyedItem> sorted, bool are_points, const OctreeOptions& options) {
  constexpr std::size_t children = std::size_t{1} << D, middle = children / 2;
  const unsigned deepest = std::min(options.most_depth, CellFrame<D>::levels);
  std::vector<CellNode> nodes{{1, 0, no_cell, 0, static_cast<std::uint32_t>(sorted.size())}};
  std::size_t first = 0;
  for (unsigned level = 0; level < deepest && first < nodes.size(); ++level) {
    const std::size_t end = nodes.size();
    std::vector<std::uint32_t> cut_before(blocks_of(end - first, cell_block));
    const auto is_cut = [&](const CellNode& cell) {
      if (cell.count() <= options.most_in_leaf) return false;
      if (are_points) return true;
      const std::uint64_t own = first_key<D>(cell.code << D | middle, level + 1);
      const auto begin = sorted.begin() + cell.begin, stop = sorted.begin() + cell.end;
      const auto [from, to] = std::equal_range(begin, stop, KeyedItem{own, 0},
                                               [](const KeyedItem& a, const KeyedItem& b) { return a.key < b.key; });
      return cell.count() - static_cast<std::size_t>(to - from) > options.most_in_leaf;
    };
    for_blocks(options.execution, end - first, cell_block, [&](std::size_t b, std::size_t from, std::size_t to) {
      std::uint32_t cut = 0;
      for (std::size_t i = first + from; i < first + to; ++i) {
        const bool is = is_cut(nodes[i]);
        nodes[i].children = is ? 1 : 0;  // a mark, until the number is known
        cut += is ? 1 : 0;
      }
      cut_before[b] = cut;
    });
    std::size_t cut = 0;
    for (std::uint32_t& before : cut_before) before = static_cast<std::uint32_t>(std::exchange(cut, cut + before));
    if (end + cut * children >= no_cell)
      throw InvalidShape("build_octree: more than 2^32 - 2 cells; raise options.most_in_leaf");
    nodes.resize(end + cut * children);
    for_blocks(options.execution, end - first, cell_block, [&](std::size_t b, std::size_t from, std::size_t to) {
      std::size_t at = end + children * cut_before[b];
      for (std::size_t i = first + from; i < first + to; ++i) {
        CellNode& cell = nodes[i];
        if (cell.children == 0) continue;
        cell.children = static_cast<std::uint32_t>(at);
        const Runs<D> runs = runs_of<D>(sorted, cell, level);
        for (std::size_t c = 0; c < children; ++c) {
          const std::uint32_t stop = c + 1 == middle ? runs.own_begin : runs.begin[c + 1];
          nodes[at++] = {cell.code << D | c, 0, static_cast<std::uint32_t>(i), runs.begin[c], stop};
        }
      }
    });
    first = end;
  }
  return nodes;
}

template std::vector<CellNode> cut_cells<2>(std::span<const KeyedItem>, bool, const OctreeOptions&);
template std::vector<CellNode> cut_cells<3>(std::span<const KeyedItem>, bool, const OctreeOptions&);

void check_octree_options(std::string_view function, const OctreeOptions& options, std::size_t items) {
  if (options.most_in_leaf == 0) {
    throw InvalidShape(std::string(function) + ": options.most_in_leaf is 0, but it must be at least 1");
  }
  if (items >= no_cell) {
    throw InvalidShape(std::string(function) + ": " + std::to_string(items) + " items, but 2^32 - 2 is the most");
  }
}

}  // namespace plumb::space
