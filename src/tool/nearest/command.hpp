// `plumb nearest`: nearest neighbors in files: which of these points are nearest to each query, or within a radius?
//
// Laws: (1) what is nearer in real arithmetic comes first, of equally near points that of the lower number.  (2) Text,
// JSON and arrays hold the same answers, query by query, and depend on the files, k, the radius and --ties alone, not
// on threads.  (3) Arrays and picture replace no file, unless that is asked for.  Exit code 0 when done; files that
// cannot be read, more neighbors than there are points, more answers to keep than --most and outputs that cannot be
// written throw Error.  (4) Where no output has all answers, the first ten are kept and the others counted as they come.
// Source: RTCD 7.3.7; plumb/space/kd_tree/nearest_point.hpp, plumb/space/kd_tree/point_range.hpp.
// Cost: that of reading, of the tree, and some 300 ns a query and neighbor.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/space/kd_tree/nearest_point.hpp"
#include "tool/nearest/point_input.hpp"
#include "tool/terminal/progress.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct NearestOptions {
  MeshArguments files;  // points and queries
  std::optional<std::uint32_t> k;
  std::optional<std::string> within;  // a decimal
  bool ties = false;
  unsigned threads = 0;
  bool all = false;                                      // list every answer
  std::uint64_t most = 100'000'000;                      // answers to keep
  std::optional<std::string> json, out, distances, svg;  // "-" is standard output
  bool overwrite = false;                                // what --out, --distances and --svg name
};

int run_nearest(const NearestOptions& options);

struct NearestReport {
  PointInput points, queries;
  std::optional<std::uint32_t> k;  // either so many
  std::optional<double> radius;    // or all within that
  bool ties = false;
  std::size_t tied = 0;  // queries with more points that are exactly as near as the last that was asked for
  unsigned levels = 0;   // of the tree
  double build_ms = 0, search_ms = 0;
  /// Of what is found the first, or all, where there are so many at the most; distances of the first, or of all.
  static constexpr std::size_t listed = 10;
  bool keeps_all = false, keeps_distances = false;
  std::uint64_t most = 0;
  std::uint64_t answers = 0;          // that were found
  std::vector<std::size_t> first{0};  // of each query's answers that are kept, and the end
  std::vector<NearestPoint> found;

  [[nodiscard]] bool is_planar() const { return points.is_planar; }
  /// Has every query as many answers?
  [[nodiscard]] bool is_even() const { return k.has_value() && !ties; }
  [[nodiscard]] std::span<const NearestPoint> of(std::size_t query) const {
    return std::span(found).subspan(first[query], first[query + 1] - first[query]);
  }
};

/// Builds the tree and answers the queries of a report that has all else.
void search_nearest(NearestReport& report, Progress& bar);
/// Lists all answers, or the first.
std::string nearest_text(const NearestReport& report, bool all, const Style& style);
nlohmann::json nearest_json(const NearestReport& report);
/// The planes that divide the points, the queries, and what is nearest to them; so many of each at the most.
struct NearestPicture {
  unsigned levels = 8;
  std::size_t points = 20'000, queries = 200, lines = 5000;
};
std::string nearest_svg(const NearestReport& report, const NearestPicture& most = {});

}  // namespace plumb::tool
