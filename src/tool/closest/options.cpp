#include "tool/closest/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command closest_command(CLI::App& program) {
  const auto options = std::make_shared<ClosestCommandOptions>();
  ClosestCommandOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("closest", "Say where a mesh is nearest to points, and how far.");
  parser->add_option("MESH POINTS", o.files.words,
                     "The mesh file, and a table of points, one a line; '-' is standard input.");
  add_reading(parser, o.files);
  parser->add_option("--point", o.points, "Ask about this point; repeatable.")
      ->allow_extra_args(false)
      ->type_name("X,Y,Z");
  parser->add_option("--within", o.within, "Say nothing of what is farther away than this.")->type_name("RADIUS");
  add_tree(parser, o.tree);
  parser->add_flag("--all", o.all, "List every point; without this option, the first ten.");
  add_threads(parser, o.threads);
  add_output(parser, "--json", o.json, "Write the answers as JSON");
  add_obj(parser, o.obj, "Write the triangles that are nearest as OBJ");
  return {parser, closest_manual, [options] { return run_closest(*options); }, &o.files.words};
}

}  // namespace plumb::tool
