#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tool/nearest/command.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

std::string set_line(const PointInput& set, std::string_view one, std::string_view many, const Style& style) {
  return style.bold(printable(set.name)) +
         fmt::format(": {} {}{}\n{}", plural(set.size(), one, many), set.is_planar ? "in the plane" : "in space",
                     set.mesh ? ", the mesh's vertices" : "", inexact_remark(set.inexact, set.size(), many));
}

nlohmann::json set_json(const PointInput& set) {
  nlohmann::json said =
      set.mesh ? mesh_json(*set.mesh) : nlohmann::json{{"file", set.name}, {"inexact_decimals", set.inexact}};
  said.update({{"size", set.size()}, {"dimension", set.is_planar ? 2 : 3}});
  return said;
}

}  // namespace

std::string nearest_text(const NearestReport& r, bool all, const Style& style) {
  std::string text = set_line(r.points, "point", "points", style) + set_line(r.queries, "query", "queries", style);
  if (r.radius) text += plural(r.answers, "point", "points") + fmt::format(" within {} of a query\n", *r.radius);
  if (r.ties)
    text += fmt::format("{} more points that are exactly as near as the last one asked for\n",
                        r.tied == 1 ? "1 query has" : grouped(r.tied) + " queries have");
  text += style.dim(fmt::format("{} ms for a tree of {}, {} ms for the queries\n", three_digits(r.build_ms),
                                plural(r.levels, "level", "levels"), three_digits(r.search_ms)));
  if (r.found.empty()) return text;
  text += style.dim(fmt::format("{:>10} {:>10}  {}\n", "query", "point", "distance"));
  std::size_t shown = 0;
  for (std::size_t q = 0; q < r.queries.size() && (all || shown < NearestReport::listed); ++q) {
    for (const NearestPoint& n : r.of(q)) {
      if (!all && shown++ == NearestReport::listed) break;
      fmt::format_to(std::back_inserter(text), "{:>10} {:>10}  {}\n", q, n.index, n.distance);
    }
  }
  if (!all && r.answers > NearestReport::listed)
    text += fmt::format("and {} more; --all lists them\n", grouped(r.answers - NearestReport::listed));
  return text;
}

nlohmann::json nearest_json(const NearestReport& r) {
  using nlohmann::json;
  json said = origin_json("plumb nearest");
  said.update({{"point_set", set_json(r.points)}, {"query_set", set_json(r.queries)}, {"ties", r.ties}});
  said["k"] = r.k ? json(*r.k) : json();
  said["within"] = r.radius ? json(*r.radius) : json();
  said["build_ms"] = r.build_ms;
  said["search_ms"] = r.search_ms;
  if (r.ties) said["queries_with_ties"] = r.tied;
  json &indices = said["indices"] = json::array(), &distances = said["distances"] = json::array();
  for (std::size_t q = 0; q < r.queries.size(); ++q) {
    json numbers = json::array(), away = json::array();
    for (const NearestPoint& n : r.of(q)) {
      numbers.push_back(n.index);
      away.push_back(n.distance);
    }
    indices.push_back(std::move(numbers));
    distances.push_back(std::move(away));
  }
  return said;
}

}  // namespace plumb::tool
