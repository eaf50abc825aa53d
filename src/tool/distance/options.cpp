#include "tool/distance/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command distance_command(CLI::App& program) {
  const auto options = std::make_shared<DistanceOptions>();
  DistanceOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("distance", "Say how far two meshes are apart, and where.");
  parser->add_option("A B", o.meshes.words, "The two mesh files; '-' is standard input.");
  add_reading(parser, o.meshes);
  add_output(parser, "--json", o.json, "Write distance, triangles and points as JSON");
  add_obj(parser, o.obj, "Write the two nearest triangles as OBJ");
  return {parser, distance_manual, [options] { return run_distance(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
