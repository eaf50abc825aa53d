#include "tool/boolean/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command resolve_command(CLI::App& program) {
  const auto options = std::make_shared<BooleanOptions>();
  BooleanOptions& o = *options;
  o.operation = "resolve";
  CLI::App* const parser =
      program.add_subcommand("resolve", "Make of a mesh that crosses itself one that does not, exactly.");
  add_meshes(parser, o.meshes, "a closed mesh.");
  add_rule(parser, o);
  add_solid_options(parser, o);
  return {parser, resolve_manual, [options] { return run_boolean(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
