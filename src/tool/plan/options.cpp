#include "tool/manual/command.hpp"
#include "tool/plan/command.hpp"

namespace plumb::tool {

Command plan_command(CLI::App& program) {
  const auto options = std::make_shared<PlanOptions>();
  PlanOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("plan", "Say what exact decisions on a scene need, and no more.");
  add_meshes(parser, o.meshes, "together one scene.");
  add_output(parser, "--json", o.json, "Write the plan as JSON");
  add_output(parser, "--chart", o.chart, "Draw the times on each lattice and of each volume, as SVG");
  parser->add_flag("--all", o.all, "List the plan of every predicate.");
  add_placements(parser, o.placements, o.refined_ns);
  return {parser, plan_manual, [options] { return run_plan(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
