#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "lab/chart/trial_report.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::lab {
namespace {

using nlohmann::json;

json json_of(const trial::Score& s, const trial::Trial& t) {
  json j{{"method", s.method},
         {"asked", s.asked},
         {"wrong", s.wrong},
         {"unsure", s.unsure},
         {"inconsistent", s.inconsistent},
         {"query_ns", s.ns},
         {"allocations", s.allocations}};
  if (t.kind == trial::AnswerKind::number) {
    j["mean_ulps"] = s.mean_ulps;
    j["largest_ulps"] = s.largest_ulps;
  }
  if (!t.tallies.empty()) j["tallied"] = s.tallied;
  return j;
}

}  // namespace

json trials_json(std::span<const trial::Trial> trials, const trial::Settings& settings) {
  constexpr std::array<std::string_view, 4> kinds{"decision", "set", "number", "item"};
  json j = origin_json("plumb-lab chart");
  j["seed"] = settings.seed;
  j["cases"] = settings.cases;
  j["trials"] = json::array();
  for (const trial::Trial& t : trials) {
    json one{{"task", t.task},
             {"question", t.question},
             {"class", t.input},
             {"about", t.about},
             {"answer", kinds[static_cast<std::size_t>(t.kind)]},
             {"methods", json::array()}};
    if (t.kind == trial::AnswerKind::decision)
      one["truths"] = {{"negative", t.truths[0]}, {"zero", t.truths[1]}, {"positive", t.truths[2]}};
    for (const auto& [name, about] : t.tallies) one["tallies"].push_back({{"tally", name}, {"about", about}});
    for (const trial::Score& s : t.scores) one["methods"].push_back(json_of(s, t));
    j["trials"].push_back(std::move(one));
  }
  return j;
}

}  // namespace plumb::lab
