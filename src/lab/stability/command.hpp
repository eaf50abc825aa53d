// `plumb-lab stability`: where do methods fail?  The experiments of src/lab/stability, run and reported.
//
// Laws: (1) nothing is written that was not counted; text, JSON and HTML hold the same numbers; (2) without a folder
// nothing but the tables is written; (3) an experiment that does not exist and a folder that cannot be used are refused
// before anything runs.
// Source: RTCD 11.2, 11.3.
// Cost: minutes, seconds when quick.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/stability/experiment.hpp"
#include "lab/trial/terms.hpp"
#include "tool/manual/command.hpp"

namespace plumb::lab {

struct StabilityOptions {
  std::optional<std::string> out;        // a folder
  std::vector<std::string> experiments;  // none: all
  stability::Settings settings;
};

/// 1 where an exact method failed anything, else 0.
int run_stability(const StabilityOptions& options,
                  std::vector<stability::Experiment> experiments = stability::all_experiments());

Command stability_command(CLI::App& program, const std::vector<stability::WorldRival>& worlds = {});
Manual stability_manual();

}  // namespace plumb::lab
