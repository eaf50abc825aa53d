#include <nlohmann/json.hpp>

#include "lab/stability/report.hpp"
#include "lab/trial/terms.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::lab {
namespace {

using nlohmann::json;

json json_of(const stability::MethodOutcome& outcome) {
  json j{{"method", outcome.method}, {"is_exact", outcome.exact}, {"counts", json::array()}};
  for (const stability::Count& c : outcome.counts) {
    j["counts"].push_back({{"failure", c.failure}, {"failures", c.failures}, {"of", c.of}});
  }
  return j;
}

json json_of(const std::optional<std::string>& folder) { return folder ? json(*folder) : json(nullptr); }

}  // namespace

json scenes_json(std::span<const SceneReport> reports, const stability::Settings& settings) {
  json j = origin_json("plumb-lab stability");
  j["seed"] = settings.seed;
  j["quick"] = settings.quick;
  j["ccd"] = json_of(settings.ccd);
  j["models"] = json_of(settings.models);
  j["scenes"] = json::array();
  for (const SceneReport& r : reports) {
    json one{{"experiment", r.experiment}, {"question", r.question},   {"source", r.source},       {"scene", r.scene},
             {"about", r.about},           {"methods", json::array()}, {"pictures", json::array()}};
    for (const stability::MethodOutcome& o : r.findings.outcomes) one["methods"].push_back(json_of(o));
    for (const stability::Picture& p : r.findings.pictures) {
      one["pictures"].push_back({{"picture", p.name + ".svg"}, {"caption", p.caption}});
    }
    j["scenes"].push_back(std::move(one));
  }
  return j;
}

}  // namespace plumb::lab
