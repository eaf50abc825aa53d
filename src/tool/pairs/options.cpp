#include "tool/manual/command.hpp"
#include "tool/manual/whole_number.hpp"
#include "tool/pairs/command.hpp"
#include "tool/pairs/method_names.hpp"

namespace plumb::tool {

Command pairs_command(CLI::App& program) {
  const auto options = std::make_shared<PairsOptions>();
  PairsOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("pairs", "Find all pairs of boxes that overlap, in one set or two.");
  std::vector<std::string> methods;
  for (const BroadPhaseMethod m : broad_phase_methods) methods.push_back(command_name(m));
  parser->add_option("FILE", o.files.words, "One file of boxes, or two; '-' is standard input.");
  add_reading(parser, o.files);
  parser->add_flag("--no-touching", o.no_touching, "Pass over pairs that only touch.");
  parser->add_option("--method", o.method, "Search this way; all of them find the same pairs.")
      ->check(CLI::IsMember(methods))
      ->capture_default_str()
      ->type_name("NAME");
  add_threads(parser, o.threads);
  parser->add_flag("--all", o.all, "List every pair, too.");
  parser->add_flag("--count", o.count, "Only count: keep no pair, and leave them out of the JSON.");
  parser
      ->add_option("--most", o.most,
                   "Keep so many pairs at the most, for outputs or by a method that keeps all; count any number.")
      ->check(whole_number_from(1, std::uint64_t{1} << 40))
      ->capture_default_str()
      ->type_name("N");
  add_output(parser, "--json", o.json, "Write counts and pairs as JSON");
  add_output(parser, "--out", o.out, "Write the pairs as an array of NumPy (.npy), a row each");
  add_output(parser, "--svg", o.svg, "Draw the boxes, and what the method divides them into, as SVG");
  parser->add_flag("--overwrite", o.overwrite, "Replace the files of --out and --svg where they are there.");
  return {parser, pairs_manual, [options] { return run_pairs(*options); }, &o.files.words};
}

}  // namespace plumb::tool
