#include "lab/stability/command.hpp"

namespace plumb::lab {

Command stability_command(CLI::App& program, const std::vector<stability::WorldRival>& worlds) {
  const auto options = std::make_shared<StabilityOptions>();
  StabilityOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("stability", "Find where geometric algorithms fail, and picture it.");
  parser->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
      ->type_name("DIR");
  parser->add_flag("--quick", o.settings.quick, "Try little of everything: seconds instead of minutes.");
  parser->add_option("--experiment", o.experiments, "Only this experiment; repeatable.")
      ->allow_extra_args(false)
      ->type_name("NAME");
  add_seed(parser, o.settings.seed, "Other inputs of the same kinds;");
  parser->add_option("--ccd", o.settings.ccd, "Try the queries of continuous tests in this folder as well.")
      ->type_name("DIR");
  parser->add_option("--models", o.settings.models, "Try the meshes in this folder as well.")->type_name("DIR");
  const auto all = std::make_shared<const std::vector<stability::Experiment>>(stability::all_experiments(worlds));
  const auto experiments = [all] {
    std::vector<std::string> names;
    for (const stability::Experiment& e : *all) names.push_back(e.name);
    return names;
  };
  return {parser,
          stability_manual,
          [options, all] { return run_stability(*options, *all); },
          nullptr,
          {{"--experiment", experiments}}};
}

}  // namespace plumb::lab
