#include "tool/manual/command.hpp"
#include "tool/replay/command.hpp"

namespace plumb::tool {

Command replay_command(CLI::App& program) {
  const auto options = std::make_shared<ReplayOptions>();
  ReplayOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("replay", "Ask questions again that were kept, and say which answers differ.");
  parser->add_option("FILE", o.files, "Questions, one a line, or a ring of a recorder; '-' is standard input.");
  parser->add_flag("--prove", o.prove, "Ask for a proof too, where two convex figures are asked about, and verify it.");
  add_output(parser, "--out", o.out, "Write the lines with the answers of here");
  add_output(parser, "--page", o.page, "Write one question as a page that opens offline");
  parser->add_option("--question", o.question, "The line that the page is about, from 1; else the first that differs.");
  parser->add_flag("--overwrite", o.overwrite, "Replace the files of --out and --page where they are there.");
  add_output(parser, "--json", o.json, "Write what differs as JSON");
  return {parser, replay_manual, [options] { return run_replay(*options); }, &o.files};
}

}  // namespace plumb::tool
