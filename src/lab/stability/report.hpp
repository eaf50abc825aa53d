// What did the laboratory find?  The same counts as text, JSON and one page of HTML with the pictures in it.
//
// Law: all hold the same numbers.
// Source: none.
// Cost: milliseconds.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "lab/stability/experiment.hpp"
#include "lab/trial/terms.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::lab {

/// A scene that was run.
struct SceneReport {
  std::string experiment, question, source;
  std::string scene, about;
  stability::Findings findings;
};

/// A table: a line a method, a column a kind of failure, numbered where their names stand above it.
std::string scene_text(const SceneReport& report, const Style& style);

/// With where and when: origin_json, now.
nlohmann::json scenes_json(std::span<const SceneReport> reports, const stability::Settings& settings);

std::string scenes_html(std::span<const SceneReport> reports, const nlohmann::json& raw);

/// Names of scenes in which an exact method failed: there should be none.
std::vector<std::string> failed_exactly(std::span<const SceneReport> reports);

}  // namespace plumb::lab
