// Does a source tree keep the house's rules?  The top level, the ladder of folders, who may see which library, names
// and sizes of files.
//
// Laws: breaches(tree) is empty exactly when every rule holds; each breach names its file and what is wrong.
// Cost: reads every source file once.
#pragma once

#include <filesystem>
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

inline const std::vector<std::string> top_level = {
    "CMakeLists.txt", "CMakePresets.json", "bootstrap", "include", "src", "predicates", "tests", "fuzz",
    "docs",           "README.md",         "LICENSE"};

std::vector<Breach> breaches(const std::filesystem::path& tree);

}  // namespace plumb::house
