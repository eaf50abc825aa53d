#include "tool/inside/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command inside_command(CLI::App& program) {
  const auto options = std::make_shared<InsideOptions>();
  InsideOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("inside", "Say which points are inside of a closed mesh.");
  parser->add_option("MESH", o.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_option("--point", o.points, "Ask about this point; repeatable.")
      ->allow_extra_args(false)
      ->type_name("X,Y,Z");
  parser->add_option("--points", o.file, "Ask about the points of this file, one a line; '-' is standard input.")
      ->type_name("FILE");
  add_tree(parser, o.tree);
  add_output(parser, "--json", o.json, "Write the answers as JSON");
  return {parser, inside_manual, [options] { return run_inside(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
