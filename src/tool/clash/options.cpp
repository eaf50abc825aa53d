#include "tool/clash/command.hpp"
#include "tool/clash/rules.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command clash_command(CLI::App& program) {
  const auto options = std::make_shared<ClashArguments>();
  ClashArguments& o = *options;
  CLI::App* const parser =
      program.add_subcommand("clash", "Say which parts of an assembly touch, overlap, pierce or enclose one another.");
  add_meshes(parser, o.meshes, "its parts are held against each other and those of all others.");
  parser->add_option("--clearance", o.clearance, "Also list parts that are at most this far from one another.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("LENGTH");
  parser
      ->add_option("--rule", o.rules,
                   "For pairs of parts whose names match: 'A*,B*: clearance LENGTH', 'A*,B*: ignore WORD,...' or "
                   "'A*,B*: skip'; repeatable.")
      ->allow_extra_args(false)
      ->type_name("RULE");
  parser->add_option("--ignore", o.ignore, "List no clash of this WORD; repeatable.")
      ->check(CLI::IsMember(clash_words()))
      ->allow_extra_args(false)
      ->type_name("WORD");
  parser->add_flag("--unmeasured", o.unmeasured, "Say neither volumes nor depths, which take longest.");
  parser->add_flag("--all", o.all, "List every clash; without this option, the first twenty.");
  parser->add_flag("--fail-on-found", o.fail_on_found, "Exit with 1 where a clash is listed.");
  add_output(parser, "--json", o.json, "Write parts and every clash as JSON");
  add_output(parser, "--csv", o.csv, "Write a row for each clash as CSV");
  add_output(parser, "--bcf", o.bcf, "Write a topic with a viewpoint for each clash as BCF 2.1");
  add_output(parser, "--page", o.page,
             "Write one HTML page, which opens offline: the list beside the scene, each two parts in color");
  parser->add_flag("--overwrite", o.overwrite, "Replace the file of --page where it is there.");
  add_threads(parser, o.threads);
  add_shard(parser, o.shard);
  return {parser, clash_manual, [options] { return run_clash(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
