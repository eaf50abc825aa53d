#include "tool/intersect/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command intersect_command(CLI::App& program) {
  const auto options = std::make_shared<IntersectOptions>();
  IntersectOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("intersect", "Say which triangles of a mesh, or of two, touch or overlap.");
  parser->add_option("A B", o.meshes.words,
                     "The mesh file, and another; of one alone its own triangles are asked. '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_flag("--overlapping", o.overlapping, "Look only for triangles that overlap, not for those that touch.");
  parser->add_flag("--first", o.first, "End at the first pair that is come upon: whether there is any.");
  parser->add_flag("--count", o.count, "Say only how many pairs there are, and keep none in memory.");
  parser->add_flag("--common", o.common, "Say of each pair what it has in common: a point, a segment or a polygon.");
  parser->add_flag("--all", o.all, "List every pair; without this option, the first ten.");
  parser->add_flag("--fail-on-found", o.fail_on_found, "Exit with 1 where a pair is found.");
  add_output(parser, "--json", o.json, "Write counts and every pair as JSON");
  add_obj(parser, o.obj, "Write the triangles of the pairs as OBJ");
  return {parser, intersect_manual, [options] { return run_intersect(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
