#include <iterator>

#include "tool/boolean/command.hpp"
#include "tool/manual/command.hpp"
#include "tool/manual/whole_number.hpp"

namespace plumb::tool {

void add_solid_options(CLI::App* parser, SolidOptions& o) {
  parser
      ->add_option("-o,--output", o.output,
                   "Write the result to this file, in the format of its extension. - is standard output, as OBJ.")
      ->type_name("OUT");
  parser->add_flag("--overwrite", o.overwrite, "Replace the file of --output where it is there.");
  parser->add_flag("--merge", o.merge,
                   "Make polygons of what lies in one plane, and as few triangles of these as can be.");
  parser->add_option("--rounds", o.rounds, "Round at most so often until the result is sound; 24 if not given.")
      ->check(whole_number_from(1, 4294967295U))
      ->type_name("N");
  parser->add_flag("--unsound", o.unsound, "Write the result also where it is not sound.");
  add_output(parser, "--json", o.json, "Write what was made, and whether it is sound, as JSON");
  add_threads(parser, o.threads);
}

namespace {

auto one_of_names(const auto& names) {
  return CLI::IsMember(std::vector<std::string>(std::begin(names), std::end(names)));
}

}  // namespace

void add_rule(CLI::App* parser, BooleanOptions& o) {
  parser
      ->add_option("--rule", o.rule,
                   "Inside a mesh is where it winds around a point positive times (the default), nonzero or odd times.")
      ->check(one_of_names(winding_rules))
      ->type_name("RULE");
}

Command boolean_command(CLI::App& program) {
  const auto options = std::make_shared<BooleanOptions>();
  BooleanOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("boolean", "Unite, intersect or subtract solids, exactly, and round the result once.");
  parser->add_option("OPERATION", o.operation, "union, intersection, difference or symmetric.")
      ->check(one_of_names(operation_names));
  add_meshes(parser, o.meshes, "each is a solid; the difference is that of the first and all others.");
  add_rule(parser, o);
  add_solid_options(parser, o);
  return {parser, boolean_manual, [options] { return run_boolean(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
