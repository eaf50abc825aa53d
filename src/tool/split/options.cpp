#include "tool/manual/command.hpp"
#include "tool/split/command.hpp"

namespace plumb::tool {

Command split_command(CLI::App& program) {
  const auto options = std::make_shared<SplitOptions>();
  SplitOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("split", "Cut a solid by a plane or by another solid, exactly.");
  add_meshes(parser, o.meshes, "a closed mesh.");
  parser->add_option("--plane", o.plane, "Cut by this plane, as 'plumb section' takes it: z=1.5, or NX,NY,NZ,OFFSET.")
      ->type_name("PLANE");
  parser->add_option("--by", o.by, "Cut by this closed mesh.")->type_name("MESH");
  add_solid_options(parser, o);
  parser->add_option("--other", o.other, "Write the other part to this file: what is below the plane, or inside.")
      ->type_name("OUT");
  return {parser, split_manual, [options] { return run_split(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
