#include "certify/catalog.hpp"
#include "tool/manual/command.hpp"
#include "tool/proof/command.hpp"

namespace plumb::tool {

std::vector<std::string> predicate_names() {
  std::vector<std::string> names;
  for (const CatalogEntry& entry : catalog()) names.emplace_back(entry.name);
  return names;
}

Command proof_command(CLI::App& program) {
  const auto options = std::make_shared<ProofOptions>();
  ProofOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("proof", "Write the claim of a filter's bound for a prover.");
  CLI::Option* const predicate = parser->add_option("PREDICATE", o.predicate, "As of `plumb proof --list`.");
  parser->add_flag("--every-scale", o.every_scale,
                   "Claim instead, of every term by itself, what holds at every scale, of an operation that errs by "
                   "2^-53 of its result and of which nothing else is known.");
  add_output(parser, "--out", o.out, "Write the script there");
  parser
      ->add_flag("--list", o.list,
                 "List the predicates with what is derived from each: its degree, its operations, the number of its "
                 "terms, and the constant of its filter.")
      ->excludes(predicate);
  return {parser, proof_manual, [options] { return run_proof(*options); }, nullptr, {{"PREDICATE", predicate_names}}};
}

}  // namespace plumb::tool
