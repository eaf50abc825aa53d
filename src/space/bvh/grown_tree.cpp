#include "space/bvh/grown_tree.hpp"

namespace plumb::space {

std::vector<BoxNode> put_together(Execution execution, const std::vector<TopNode>& top,
                                  std::vector<std::vector<BoxNode>> trees) {
  if (trees.size() == 1) {
    trees[0].shrink_to_fit();
    return std::move(trees[0]);
  }
  std::size_t all = top.size() - trees.size();
  for (const std::vector<BoxNode>& tree : trees) all += tree.size();
  std::vector<BoxNode> nodes(all);
  std::vector<std::size_t> start(trees.size()), above;  // in depth-first order
  struct Later {
    std::uint32_t top;
    std::size_t parent;  // whose second child it is, or `all`
  };
  std::vector<Later> later{{0, all}};
  std::size_t next = 0;
  while (!later.empty()) {
    const auto [t, parent] = later.back();
    later.pop_back();
    if (parent != all) nodes[parent].link = static_cast<std::uint32_t>(next - parent);
    if (top[t].children == 0) {
      start[top[t].tree] = next;
      next += trees[top[t].tree].size();
      continue;
    }
    above.push_back(next);
    later.push_back({top[t].children + 1, next});
    later.push_back({top[t].children, all});
    ++next;
  }
  for_blocks(execution, trees.size(), 1, [&](std::size_t t, std::size_t, std::size_t) {
    std::copy(trees[t].begin(), trees[t].end(), nodes.begin() + static_cast<std::ptrdiff_t>(start[t]));
  });
  for (std::size_t i = above.size(); i-- > 0;) fit(nodes, above[i]);
  return nodes;
}

}  // namespace plumb::space
