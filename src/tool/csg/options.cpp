#include "tool/csg/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command csg_command(CLI::App& program) {
  const auto options = std::make_shared<CsgOptions>();
  CsgOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("csg", "Make the solid that a text says: OpenSCAD's .csg with flat sides, and meshes.");
  parser->add_option("FILE", o.text, "The text; - is standard input.");
  add_solid_options(parser, o);
  add_reading(parser, o.meshes);
  return {parser, csg_manual, [options] { return run_csg(*options); }};
}

}  // namespace plumb::tool
