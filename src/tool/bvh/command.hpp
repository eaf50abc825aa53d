// `plumb bvh`: which tree of boxes do the builders make of this mesh, and what does it cost to be asked?
//
// Laws: (1) everything but the times depends on the mesh and the methods alone.  (2) The levels of a tree sum up to its
// cost_of.  (3) Text and JSON hold the same trees.  (4) The picture and the tree that is kept replace no file,
// unless that is asked for.
// Source: RTCD 6.1.2, 6.2; plumb/space/bvh/tree_cost.hpp.
// Cost: up to three builds with each method, so that one that a machine was slow in does not count.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/tree_cost.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

/// Of the name that --method takes: that of name_of, in one word.
std::string word_of(BvhMethod method);

struct BvhArguments {
  MeshArguments meshes;  // one file
  std::string method = "binned";
  float split_share = 0;                      // as BvhOptions has it
  std::optional<std::string> json, svg, out;  // "-" is standard output
  bool overwrite = false;

  [[nodiscard]] bool all() const { return method == "all"; }
};

int run_bvh(const BvhArguments& arguments);

/// What the nodes of one depth add to a tree's cost.
struct TreeLevel {
  std::uint32_t nodes = 0, leaves = 0;
  double nodes_met = 0, items_met = 0;
};

/// Of depths 0, 1, ...
std::vector<TreeLevel> levels_of(const BoxTree& tree);
/// Of each node.
std::vector<std::uint32_t> depths_of(const BoxTree& tree);

struct BuiltTree {
  BvhMethod method;
  TreeCost cost;
  std::vector<TreeLevel> levels;
  std::size_t bytes = 0, slots = 0;  // a triangle that is split is in several
  double build_ms = 0;
};

struct BvhReport {
  AskedMesh mesh;
  float split_share = 0;
  std::vector<BuiltTree> trees;
  std::vector<BvhMethod> left_out;  // too slow for this mesh
};

BvhReport bvh_report(const BvhArguments& arguments, AskedMesh mesh);
std::string bvh_text(const BvhReport& report, const Style& style);
nlohmann::json bvh_json(const BvhReport& report);

/// The boxes of some depths, seen along the shortest axis, and under them what each depth costs.
std::string tree_svg(const std::string& mesh_name, const BoxTree& tree, BvhMethod method);

}  // namespace plumb::tool
