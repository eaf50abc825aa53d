#include "lab/vectors/command.hpp"

namespace plumb::lab {

Command vectors_command(CLI::App& program) {
  const auto options = std::make_shared<VectorsOptions>();
  VectorsOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("vectors", "Write test vectors: inputs with exact answers.");
  parser->add_option("--out", o.out, "Write the files into this folder, which is made where it is missing.")
      ->required()
      ->type_name("DIR");
  add_seed(parser, o.seed, "Other cases of the same classes;");
  return {parser, vectors_manual, [options] { return run_vectors(*options); }};
}

}  // namespace plumb::lab
