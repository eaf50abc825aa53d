// `plumb-lab chart`: what does exactness cost, and what does it buy?  Every method on every task and class of inputs.
//
// Laws: (1) nothing is written that was not measured; text, JSON, SVG and HTML hold the same numbers; (2) without a
// folder nothing but the table is written; (3) a task or class that does not exist is refused before anything runs, and
// so is a folder that cannot be written to.
// Source: RTCD 11.2.
// Cost: minutes, seconds when quick; one thread, because times are taken.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/trial/tasks.hpp"
#include "tool/manual/command.hpp"

namespace plumb::lab {

struct ChartOptions {
  std::optional<std::string> out;           // a folder
  std::vector<std::string> tasks, classes;  // none: all
  bool quick = false;
  std::uint64_t seed = 2026;
};

/// Of all tasks, in the order of the report.
std::vector<std::string> task_names(std::span<const trial::Rival> rivals);
std::vector<std::string> class_names(std::span<const trial::Rival> rivals);

int run_chart(const ChartOptions& options, std::span<const trial::Rival> rivals);

Command chart_command(CLI::App& program, std::span<const trial::Rival> rivals);
Manual chart_manual();

}  // namespace plumb::lab
