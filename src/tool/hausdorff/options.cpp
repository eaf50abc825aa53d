#include "tool/hausdorff/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command hausdorff_command(CLI::App& program) {
  const auto options = std::make_shared<HausdorffCommandOptions>();
  HausdorffCommandOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("hausdorff", "Say how far two surfaces deviate, between certain bounds.");
  parser->add_option("A B", o.meshes.words, "The two mesh files; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_flag("--from", o.one_way, "Ask how far points of A are from B; without this option, both ways.");
  parser->add_option("--absolute", o.absolute, "How far the bounds may be apart; --relative is 0 then.")
      ->type_name("LENGTH");
  parser->add_option("--relative", o.relative, "The same as a share of the distance; 2^-10 when neither is given.")
      ->type_name("SHARE");
  add_threads(parser, o.threads);
  add_output(parser, "--json", o.json, "Write bounds and places as JSON");
  add_obj(parser, o.obj, "Write the triangle of the farthest point and the one nearest to it as OBJ");
  return {parser, hausdorff_manual, [options] { return run_hausdorff(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
