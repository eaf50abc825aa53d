#include "tool/bounds/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command bounds_command(CLI::App& program) {
  const auto options = std::make_shared<BoundsOptions>();
  BoundsOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("bounds", "Rate bounding volumes on meshes.");
  parser->add_option("MESH", o.meshes, "Mesh files, each rated in turn.");
  parser->add_option("--json", o.json, "Write the numbers as JSON; '-' is standard output.")->type_name("FILE");
  parser->add_option("--chart", o.chart, "Draw the spectrum over all meshes, as SVG.")->type_name("FILE");
  add_placements(parser, o.placements, o.refined_ns);
  return {parser, bounds_manual, [options] { return run_bounds(*options); }, &o.meshes};
}

}  // namespace plumb::tool
