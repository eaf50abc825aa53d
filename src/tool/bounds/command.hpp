// `plumb bounds`: how tight is each bounding volume on these meshes, how often does it cry wolf, what does its test
// cost?
//
// Laws: tightness and shares depend on the meshes and the number of placements alone; times are measured here and now.
// Exit code 0 when done; bad input throws Error.
// Source: RTCD 4.1 (figure 4.2).
// Cost: that of rate_bounds for each mesh, some seconds for a large one.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/figure/bound/choose_bound.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct BoundsOptions {
  MeshArguments meshes;                    // none: the embedded part
  std::optional<std::string> json, chart;  // "-" is standard output
  std::uint32_t placements = 400;
  double refined_ns = 1'000;  // what is asked where bounds overlap, for the expected cost of a query
};

int run_bounds(const BoundsOptions& options);

struct MeshBounds {
  std::string name;
  std::size_t vertices;
  BoundRatings ratings;  // with times
  double refined_ns;

  /// Of the placements whose hulls are apart, those where the bounds overlap; 0 where there are none.
  [[nodiscard]] double false_share(std::size_t kind) const;
  /// Of a query, by the model of choose_bound with the times measured.
  [[nodiscard]] double expected_ns(std::size_t kind) const;
};

/// What is charted of a kind: its middle over all meshes.
struct KindMedians {
  double tightness, false_share, test_ns, expected_ns;
};
KindMedians medians(std::span<const MeshBounds> meshes, std::size_t kind);

std::string bounds_text(const MeshBounds& mesh, const Style& style);
std::string bounds_total(std::span<const MeshBounds> meshes, const Style& style);
nlohmann::json bounds_json(std::span<const MeshBounds> meshes);

/// A row a kind, the cheapest test first; a dot a mesh, a bar at the median, in three panels: tightness, false
/// overlaps, time of the test.
std::string bounds_chart(std::span<const MeshBounds> meshes);

}  // namespace plumb::tool
