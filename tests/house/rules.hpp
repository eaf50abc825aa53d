// Does a source tree keep the house's rules?  The top level, the ladder of folders, the rooms of a folder, who may see
// which library, how includes are spelled, names and sizes of files.
//
// Laws: breaches(tree) is empty exactly when every rule holds; each breach names its file and what is wrong.
// Cost: reads every source file once.
#pragma once

#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace plumb::house {

struct Breach {
  std::string file;  // relative to the tree
  std::string what;
};

inline std::ostream& operator<<(std::ostream& out, const Breach& b) { return out << b.file << ": " << b.what; }

/// The folders of include/plumb and src: each may include those before it and itself.
inline const std::vector<std::string> ladder = {"predicates", "arith", "certify", "classic", "degenerate",
                                                "figure",     "query", "space",   "surface", "world"};

/// The rooms of a folder: each may include those before it and itself.  By the alphabet but where the field's word for a
/// thing comes too early in it or too late.
inline const std::map<std::string, std::vector<std::string>> rooms = {
    {"figure",
     {"basic", "containment", "support", "hull", "measures", "minkowski", "sphere", "aabb", "k_dop", "obb",
      "swept_sphere", "bound", "generated"}},
    {"query",
     {"body", "closest", "convex", "overlap", "ray", "section", "separation", "lp", "certificate", "gjk",
      "polytope_hierarchy", "vclip", "penetration", "contact", "time_of_impact", "variant", "kinds"}},
    {"space",
     {"bvh", "closest", "moving", "pairs", "range", "ray", "coherence", "grid", "octree", "kd_tree", "sort_and_sweep",
      "textbook", "broad_phase", "cells", "bsp"}},
    {"surface", {"planar", "file", "topology", "section", "repair", "parts", "solid"}},
    {"tool",
     {"terminal", "drawing",   "mesh",   "rows",    "trial",     "manual",  "corpus", "boolean", "bounds",     "bsp",
      "bvh",      "check",     "clash",  "closest", "collect",   "convert", "convex", "csg",     "distance",   "doctor",
      "fuzz",     "hausdorff", "help",   "inside",  "intersect", "nearest", "pairs",  "parts",   "placements", "plan",
      "proof",    "ray",       "repair", "replay",  "resolve",   "section", "sign",   "split",   "program"}},
    {"lab", {"trial", "crowd", "chart", "stability", "vectors", "program"}},
};

/// The most source files in one folder; data may be more.
inline constexpr std::size_t most_files = 60;

inline const std::vector<std::string> top_level = {
    "CMakeLists.txt", "CMakePresets.json", "bootstrap", "include", "src", "predicates", "tests", "fuzz",
    "docs",           "README.md",         "LICENSE"};

std::vector<Breach> breaches(const std::filesystem::path& tree);

}  // namespace plumb::house
