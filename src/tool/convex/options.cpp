#include "tool/convex/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command convex_command(CLI::App& program) {
  const auto options = std::make_shared<ConvexOptions>();
  ConvexOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("convex", "Say how the convex hulls of two meshes lie, how near or deep, with a proof.");
  parser->add_option("A B", o.meshes.words, "The two mesh files; '-' is standard input.");
  o.meshes.points_too = true;
  add_reading(parser, o.meshes);
  add_output(parser, "--json", o.json, "Write relation, distance, points, penetration and steps as JSON");
  add_output(parser, "--certificate", o.certificate, "Write the proof, with both bodies, as JSON");
  parser
      ->add_option("--history", o.history,
                   "Write the simplices of the search into the folder DIR: an OBJ file a step, and a page.")
      ->type_name("DIR");
  return {parser, convex_manual, [options] { return run_convex(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
