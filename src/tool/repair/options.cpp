#include "tool/manual/command.hpp"
#include "tool/repair/command.hpp"

namespace plumb::tool {

Command repair_command(CLI::App& program) {
  const auto settings = std::make_shared<RepairSettings>();
  RepairSettings& o = *settings;
  CLI::App* const parser =
      program.add_subcommand("repair", "Mend meshes: weld, divide, fill, turn and leave out, and tell each change.");
  add_meshes(parser, o.meshes, "each mesh is mended in turn.");
  parser
      ->add_option("-o,--output", o.output,
                   "Write the mended mesh to this file, in the format of its extension; of several meshes, to files of "
                   "their names in this folder, which is made where it is missing. - is standard output, as OBJ.")
      ->type_name("OUT");
  parser->add_flag("--overwrite", o.overwrite, "Replace files of --output and --page that are there.");
  parser->add_flag("--dry-run", o.dry_run, "Write no mesh; say what would be changed.");
  parser
      ->add_option(
          "--only", o.only,
          "Take these STEPS alone, of those that 'plumb repair --help' explains; several are parted by commas.")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(step_names()))
      ->type_name("STEPS");
  parser
      ->add_option(
          "--tolerance", o.tolerance,
          "Weld vertices, zip open edges and divide edges at vertices within LENGTH, in the file's unit; else where "
          "they are equal, or exactly on an edge.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("LENGTH");
  parser
      ->add_option("--planar", o.planar,
                   "Refuse a mesh that has a polygon thicker than LENGTH, and name the polygon; else such polygons are "
                   "triangulated.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("LENGTH");
  parser->add_flag(
      "--chains", o.chains,
      "Weld all that short steps connect, however long that goes; else no group is wider than the tolerance.");
  parser->add_flag("--keep-turned", o.keep_turned,
                   "Weld also where a triangle turns over by it; else such vertices stay apart.");
  parser->add_option("--smallest", o.size, "Leave out components of fewer than N triangles.")->type_name("N");
  add_output(parser, "--json", o.json, "Write what was changed, and what is left, as JSON");
  add_output(parser, "--page", o.page,
             "Write one page for a browser, which needs no network: each mesh before and after, and its changes");
  parser->add_flag("--fail-on-left", o.fail_on_left, "Exit with 1 when a mended mesh still has a fault.");
  add_shard(parser, o.shard);
  add_threads(parser, o.threads);
  return {parser, repair_manual, [settings] { return run_repair(*settings); }, &o.meshes.words};
}

}  // namespace plumb::tool
