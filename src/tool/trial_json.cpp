#include <fstream>
#include <nlohmann/json.hpp>

#include "plumb/certify/environment.hpp"
#include "trial_report.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

/// As the system names it; "unknown" where it does not.
std::string processor() {
  std::ifstream about("/proc/cpuinfo");
  for (std::string line; std::getline(about, line);) {
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

json json_of(const trial::Score& s, trial::AnswerKind kind) {
  json j{{"method", s.method},
         {"asked", s.asked},
         {"wrong", s.wrong},
         {"unsure", s.unsure},
         {"inconsistent", s.inconsistent},
         {"ns", s.ns},
         {"allocations", s.allocations}};
  if (kind == trial::AnswerKind::number) {
    j["mean_ulps"] = s.mean_ulps;
    j["largest_ulps"] = s.largest_ulps;
  }
  return j;
}

}  // namespace

json trials_json(std::span<const trial::Trial> trials, const trial::Settings& settings, const std::string& when) {
  const Environment e = check_environment();
  json j{{"program", "plumb chart"},
         {"version", e.version},
         {"compiler", e.compiler},
         {"flags", e.build},
         {"machine", processor()},
         {"instruction_sets", e.instruction_sets},
         {"date", when},
         {"seed", settings.seed},
         {"cases", settings.cases},
         {"trials", json::array()}};
  for (const trial::Trial& t : trials) {
    json one{{"task", t.task},
             {"question", t.question},
             {"class", t.input},
             {"about", t.about},
             {"answer", t.kind == trial::AnswerKind::decision ? "decision" : "number"},
             {"methods", json::array()}};
    if (t.kind == trial::AnswerKind::decision)
      one["truths"] = {{"negative", t.truths[0]}, {"zero", t.truths[1]}, {"positive", t.truths[2]}};
    for (const trial::Score& s : t.scores) one["methods"].push_back(json_of(s, t.kind));
    j["trials"].push_back(std::move(one));
  }
  return j;
}

}  // namespace plumb::tool
