#include "tool/manual/command.hpp"
#include "tool/manual/whole_number.hpp"
#include "tool/parts/command.hpp"

namespace plumb::tool {

Command parts_command(CLI::App& program) {
  const auto options = std::make_shared<PartsOptions>();
  PartsOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("parts", "Part a solid into convex ones, or cover it with hulls.");
  parser->add_option("MESH", o.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser
      ->add_option("--concavity", o.concavity,
                   "Cover with hulls that reach beyond what they cover by at most this, as few as are found.")
      ->type_name("LENGTH");
  parser->add_option("--most", o.most, "Cover with at most so many hulls, however far they reach then.")
      ->check(whole_number_from(1, 4294967295U))
      ->type_name("N");
  parser->add_flag("--all", o.all, "List every part; without this option, the first ten.");
  add_output(parser, "--json", o.json, "Write the parts' sizes as JSON");
  add_obj(parser, o.obj, "Write the parts as OBJ, an object each");
  return {parser, parts_manual, [options] { return run_parts(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
