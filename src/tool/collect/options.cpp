#include "tool/collect/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command collect_command(CLI::App& program) {
  const auto options = std::make_shared<CollectArguments>();
  CollectArguments& o = *options;
  CLI::App* const parser =
      program.add_subcommand("collect", "Tell what was found of a folder of models, of all shards, the worst first.");
  parser->add_option("DIR", o.folders, "The folder into which shards were written.");
  parser->add_option("--worst", o.worst, "List so many models that are not well; else twenty.")->type_name("N");
  add_output(parser, "--json", o.json, "Write every model as JSON");
  add_output(parser, "--csv", o.csv, "Write a row for each model as CSV");
  add_output(parser, "--page", o.page, "Write one page for a browser, which needs no network, with the worst models");
  return {parser, collect_manual, [options] { return run_collect(*options); }, &o.folders};
}

}  // namespace plumb::tool
