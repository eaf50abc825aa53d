// What did the trials find?  The same findings as text, JSON, charts and one page of HTML.
//
// Laws: (1) all hold the same numbers; (2) the page opens without a network: it refers to nothing outside of itself.
// Source: none.
// Cost: milliseconds a chart.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "lab/trial/measure.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::lab {

std::string trial_text(const trial::Trial& trial, const Style& style);

/// With where and when: origin_json, now.
nlohmann::json trials_json(std::span<const trial::Trial> trials, const trial::Settings& settings);

/// Wrong share (of numbers: mean and largest error in ulps) against nanoseconds a question, with the frontier drawn.
std::string trial_chart(const trial::Trial& trial);

/// Whether no method is wrong, or answers the same question twice in two ways.
bool is_all_right(const trial::Trial& trial);

/// Tasks by methods, as a section of the page: the worst share wrong over the classes, and the times.
std::string trials_summary(std::span<const trial::Trial> trials, std::span<const std::string> tasks,
                           std::span<const std::string> methods);

/// All charts and figures in one page, with the JSON in it: hovering explains, checkboxes choose.
/// It opens on the summary; charts where nothing is wrong are folded, a fold a task.
std::string trials_html(std::span<const trial::Trial> trials, const nlohmann::json& raw);

}  // namespace plumb::lab
