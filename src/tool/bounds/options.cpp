#include "tool/bounds/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command bounds_command(CLI::App& program) {
  const auto options = std::make_shared<BoundsOptions>();
  BoundsOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("bounds", "Rate bounding volumes on meshes.");
  add_meshes(parser, o.meshes, "each mesh is rated in turn.");
  add_output(parser, "--json", o.json, "Write the numbers as JSON");
  add_output(parser, "--chart", o.chart, "Draw the spectrum over all meshes, as SVG");
  add_placements(parser, o.placements, o.refined_ns);
  return {parser, bounds_manual, [options] { return run_bounds(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
