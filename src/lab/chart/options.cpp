#include "lab/chart/command.hpp"

namespace plumb::lab {

Command chart_command(CLI::App& program, std::span<const trial::Rival> rivals) {
  const auto options = std::make_shared<ChartOptions>();
  ChartOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("chart", "Hold the ways of answering geometric questions against each other.");
  parser->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
      ->type_name("DIR");
  parser->add_flag("--quick", o.quick, "Ask little of each class: seconds instead of minutes.");
  parser->add_option("--task", o.tasks, "Only this task; repeatable.")->allow_extra_args(false)->type_name("NAME");
  parser->add_option("--class", o.classes, "Only inputs of this class; repeatable.")
      ->allow_extra_args(false)
      ->type_name("NAME");
  add_seed(parser, o.seed, "Other inputs of the same classes;");
  return {parser,
          chart_manual,
          [options, rivals] { return run_chart(*options, rivals); },
          nullptr,
          {{"--task", [rivals] { return task_names(rivals); }}, {"--class", [rivals] { return class_names(rivals); }}}};
}

}  // namespace plumb::lab
