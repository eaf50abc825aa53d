#include "tool/manual/command.hpp"
#include "tool/section/command.hpp"

namespace plumb::tool {

Command section_command(CLI::App& program) {
  const auto options = std::make_shared<SectionOptions>();
  SectionOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("section", "Cut a mesh by planes into exact contours.");
  parser->add_option("MESH", o.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_option("--plane", o.planes, "Cut by this plane, or by these; repeatable.")
      ->allow_extra_args(false)
      ->type_name("PLANE");
  parser->add_flag("--below", o.below, "Vertices in a plane count as below it; without this option, as above.");
  add_output(parser, "--svg", o.svg, "Draw all sections, a layer a plane, as SVG");
  add_output(parser, "--dxf", o.dxf, "Write the contours as polylines of AutoCAD R12");
  add_output(parser, "--json", o.json, "Write contours and counts as JSON");
  parser
      ->add_option("--out", o.out,
                   "Draw each section as an SVG of its own into this folder, which is made where it is missing.")
      ->type_name("DIR");
  return {parser, section_manual, [options] { return run_section(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
