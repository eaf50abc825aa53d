// `plumb check`: are these meshes surfaces of solids, and how often is floating point wrong on them, and where?
//
// Laws: exit code 0 when done, 1 when a method named by --fail-on-wrong took a wrong sign or a mesh has a defect
// named by --fail-on-defect; bad input throws Error.  Meshes of a folder that cannot be read are in the report, which is
// kept, and the code is 2; of a file that was named and cannot be read nothing is kept.
// Source: RTCD 11.2 (what rounding does to geometric decisions).
// Cost: as the meshes demand, on all cores.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tool/corpus/run_shard.hpp"
#include "tool/mesh/inputs.hpp"

namespace plumb::tool {

/// The methods of `plumb-lab chart` that are compared; --fail-on-wrong takes these names.
inline constexpr std::array<std::string_view, 8> method_names{"float32",     "double",   "absolute", "relative",
                                                              "long-double", "interval", "plan",     "exact"};
inline constexpr std::size_t method_count = method_names.size();
constexpr std::size_t method_number(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(method_names, name) - method_names.begin());
}
inline constexpr std::size_t exact_method = method_number("exact");

/// Those that may be wrong or unsure, and those that never are.
enum class Asked : std::uint8_t { inexact, exact };
constexpr bool is_asked(std::size_t method, Asked asked) {
  return (method >= method_number("plan")) == (asked == Asked::exact);
}

struct CheckOptions {
  MeshArguments meshes;                    // none: the embedded part
  ShardOptions shard;                      // else all of the meshes, by this process
  std::optional<std::string> json, chart;  // "-" is standard output
  std::optional<std::string> write_sample;
  unsigned threads = 0;                     // 0: as many as the machine has
  bool verify = false;                      // take every decision in rationals again
  bool all = false;                         // ask the inexact methods of every decision
  bool brief = false;                       // a line for each mesh
  std::optional<double> nearer_than;        // vertices nearer than this are close
  std::vector<std::string> fail_on_wrong;   // methods
  std::vector<std::string> fail_on_defect;  // of surface_defects
};

int run_check(const CheckOptions& options);

}  // namespace plumb::tool
