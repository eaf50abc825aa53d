#include "tool/check/command.hpp"
#include "tool/check/surface.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command check_command(CLI::App& program) {
  const auto options = std::make_shared<CheckOptions>();
  CheckOptions& o = *options;
  CLI::App* const parser = program.add_subcommand(
      "check",
      "Say whether meshes are closed, oriented and free of self-intersections, and what floats get wrong on them.");
  const std::vector<std::string> methods(method_names.begin(), method_names.end());
  add_meshes(parser, o.meshes, "each mesh is checked in turn.");
  add_output(parser, "--json", o.json, "Write the report as JSON");
  add_output(parser, "--chart", o.chart, "Draw the share of wrong signs against the time per decision, as SVG");
  add_threads(parser, o.threads);
  parser->add_flag("--all", o.all,
                   "Ask every method of every decision; otherwise, on a big mesh, plan and exact of all and the others "
                   "of a sample.");
  parser->add_flag("--verify", o.verify,
                   "Take every decision once more in rational numbers (of a big mesh a sample, and say so), and "
                   "judge the exact method by them.");
  parser->add_option("--fail-on-wrong", o.fail_on_wrong, "Exit with 1 when METHOD takes a wrong sign; repeatable.")
      ->check(CLI::IsMember(methods))
      ->allow_extra_args(false)
      ->type_name("METHOD");
  parser
      ->add_option("--fail-on-defect", o.fail_on_defect,
                   "Exit with 1 when a mesh has this DEFECT, of those that 'plumb check --help' explains; repeatable.")
      ->check(CLI::IsMember(std::vector<std::string>(surface_defects.begin(), surface_defects.end())))
      ->allow_extra_args(false)
      ->type_name("DEFECT");
  parser
      ->add_option("--nearer-than", o.nearer_than,
                   "Also count vertices that have another nearer than LENGTH, which are close-vertices.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("LENGTH");
  parser->add_flag(
      "--brief", o.brief,
      "Print one line for each mesh, and nothing of floats; files that cannot be read have a line as well.");
  add_shard(parser, o.shard);
  parser
      ->add_option(
          "--write-sample", o.write_sample,
          "Write the mesh that the program brings along, in the format of the extension; alone, it checks nothing.")
      ->type_name("FILE");
  return {parser, check_manual, [options] { return run_check(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
