#include "tool/nearest/command.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/rows/npy.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

void require_sound(const NearestOptions& o) {
  if (o.files.words.size() != 2)
    throw Error("nearest: two files are needed, of points and of queries; 'plumb nearest --help' explains");
  require_input_once(o.files.words);
  if (o.within && o.k) throw Error("nearest: -k and --within exclude each other: one counts, the other measures");
  if (o.within && o.ties)
    throw Error("nearest: --ties and --within exclude each other: all points within a radius are told");
}

void require_one_space(const NearestReport& r) {
  if (r.points.is_planar == r.queries.is_planar) return;
  const auto where = [](const PointInput& set) { return set.is_planar ? "in the plane" : "in space"; };
  throw Error(fmt::format("nearest: the points of {} lie {}, those of {} {}; both must lie in one", r.points.name,
                          where(r.points), r.queries.name, where(r.queries)));
}

void require_as_many(const NearestReport& r) {
  if (!r.k || *r.k <= r.points.size() || r.queries.size() == 0) return;
  if (r.points.size() == 0) throw Error(fmt::format("nearest: there is no point in {}", r.points.name));
  throw Error(fmt::format("nearest: {} nearest of {} are asked for; take a -k of at most so many", *r.k,
                          plural(r.points.size(), "point", "points")));
}

/// A row a query; or, where queries have different numbers of answers, a row an answer, with its query.
std::string indices_of(const NearestReport& r) {
  std::vector<std::int64_t> numbers;
  for (std::size_t q = 0; q < r.queries.size(); ++q) {
    for (const NearestPoint& n : r.of(q)) {
      if (!r.is_even()) numbers.push_back(static_cast<std::int64_t>(q));
      numbers.push_back(n.index);
    }
  }
  if (r.is_even()) return npy_of(numbers, std::array<std::size_t, 2>{r.queries.size(), *r.k});
  return npy_of(numbers, std::array<std::size_t, 2>{r.found.size(), 2});
}

std::string distances_of(const NearestReport& r) {
  std::vector<double> distances;
  for (const NearestPoint& n : r.found) distances.push_back(n.distance);
  if (r.is_even()) return npy_of(distances, std::array<std::size_t, 2>{r.queries.size(), *r.k});
  return npy_of(distances, std::array<std::size_t, 1>{r.found.size()});
}

}  // namespace

int run_nearest(const NearestOptions& options) {
  OutputFiles outputs(options.files.words);
  require_no_table_name("--json", options.json);
  outputs.promise("--json", options.json);
  outputs.promise_unless_there("--out", options.out, options.overwrite);
  outputs.promise_unless_there("--distances", options.distances, options.overwrite);
  outputs.promise_unless_there("--svg", options.svg, options.overwrite);
  require_sound(options);
  const ThreadLimit limit(options.threads);
  NearestReport report;
  report.ties = options.ties;
  report.keeps_distances = options.all || options.json || options.distances;
  report.keeps_all = report.keeps_distances || options.out || options.svg;
  report.most = options.most;
  if (options.within) {
    report.radius = read_decimal(*options.within, "--within").value;
    if (*report.radius < 0)
      throw Error(fmt::format("--within: {} is negative; give a radius of zero or more", printable(*options.within)));
  } else {
    report.k = options.k.value_or(1);
  }
  report.points = read_point_file(options.files.words[0], options.files.reading(), outputs);
  report.queries = read_point_file(options.files.words[1], options.files.reading(), outputs);
  require_one_space(report);
  require_as_many(report);
  {
    Progress bar("nearest", report.queries.size());
    search_nearest(report, bar);
  }
  if (!outputs.on_standard_output()) say(nearest_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(nearest_json(report)));
  if (options.out) outputs.write("--out", indices_of(report));
  if (options.distances) outputs.write("--distances", distances_of(report));
  if (options.svg) outputs.write("--svg", nearest_svg(report));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
