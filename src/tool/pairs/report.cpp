#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tool/pairs/command.hpp"
#include "tool/pairs/method_names.hpp"
#include "tool/pairs/shown_structure.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

std::string set_line(const BoxInput& set, const Style& style) {
  if (set.mesh) return mesh_line(*set.mesh, style) + "; the boxes of its triangles\n";
  return style.bold(printable(set.name)) + fmt::format(": {} {}\n{}", plural(set.size(), "box", "boxes"),
                                                       set.is_planar ? "in the plane" : "in space",
                                                       inexact_remark(set.inexact, set.size(), "boxes"));
}

/// "2,100 pairs meet: 2,000 touch, 100 overlap"
std::string found_line(const PairsReport& r, const Style& style) {
  const std::uint64_t pairs = r.touch + r.overlap;
  const std::string_view verb = r.touching ? "meet" : "overlap";
  if (pairs == 0) return style.bold(fmt::format("no two boxes {}\n", verb));
  std::string text = style.bold(fmt::format("{} {}{}", plural(pairs, "pair", "pairs"), verb, pairs == 1 ? "s" : ""));
  if (r.touching)
    text += fmt::format(": {} touch{}, {} overlap{}", grouped(r.touch), r.touch == 1 ? "es" : "", grouped(r.overlap),
                        r.overlap == 1 ? "s" : "");
  return text + "\n";
}

}  // namespace

std::string pairs_text(const PairsReport& r, bool all, const Style& style) {
  std::string text;
  for (const BoxInput& set : r.sets) text += set_line(set, style);
  text += found_line(r, style);
  text += style.dim(fmt::format("{} ms, by the method {}\n", three_digits(r.search_ms), command_name(method_taken(r))));
  if (!all || !r.pairs || r.pairs->empty()) return text;
  text += style.dim(fmt::format("{:>10} {:>10}\n", r.of_one() ? "box" : "box of a", r.of_one() ? "box" : "box of b"));
  for (const BoxPair& p : *r.pairs) {
    const bool overlaps = r.relation(p) == Relation::overlapping;
    fmt::format_to(std::back_inserter(text), "{:>10} {:>10} {}\n", p.a, p.b, overlaps ? "overlap" : "touch");
  }
  return text;
}

nlohmann::json pairs_json(const PairsReport& r, bool with_pairs) {
  using nlohmann::json;
  json sets = json::array();
  for (const BoxInput& set : r.sets) {
    json said = set.mesh ? mesh_json(*set.mesh) : json{{"file", set.name}, {"inexact_decimals", set.inexact}};
    said.update({{"size", set.size()}, {"dimension", set.is_planar ? 2 : 3}});
    sets.push_back(std::move(said));
  }
  json said = origin_json("plumb pairs");
  said.update({{"sets", std::move(sets)},
               {"method", r.method},
               {"method_taken", command_name(method_taken(r))},
               {"search_ms", r.search_ms}});
  said["overlapping"] = r.overlap;
  if (r.touching) said["touching"] = r.touch;
  if (!with_pairs || !r.pairs) return said;
  json& pairs = said["box_pairs"] = json::array();
  for (const BoxPair& p : *r.pairs) pairs.push_back({p.a, p.b});
  return said;
}

}  // namespace plumb::tool
