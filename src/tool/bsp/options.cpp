#include "tool/bsp/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command bsp_command(CLI::App& program) {
  const auto arguments = std::make_shared<BspArguments>();
  BspArguments& a = *arguments;
  CLI::App* const parser = program.add_subcommand("bsp", "Build the BSP tree of a mesh and tell its figures.");
  parser->add_option("MESH", a.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, a.meshes);
  parser
      ->add_option("--leaves", a.leaves,
                   "What is told of leaves: solid or not, their pieces, or nothing; solid when not given.")
      ->check(CLI::IsMember({"solid", "pieces", "none"}))
      ->capture_default_str()
      ->type_name("WHAT");
  parser->add_option("--planes", a.planes, "Which planes may divide; faces-and-axes when not given.")
      ->check(CLI::IsMember({"faces", "faces-and-axes"}))
      ->capture_default_str()
      ->type_name("WHICH");
  parser
      ->add_option(
          "--split-weight", a.options.split_weight,
          "What a split costs to what imbalance does: 0, balance alone, to 1, the fewest splits; 0.5 when not given.")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str()
      ->type_name("X");
  parser
      ->add_option("--candidates", a.options.candidates,
                   "Faces whose planes are looked at for each node; 8 when not given.")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  parser
      ->add_option("--leaf-size", a.options.leaf_size,
                   "Pieces that may be left in a leaf, with --leaves pieces; 4 when not given.")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  add_output(parser, "--json", a.json, "Write the figures as JSON");
  return {parser, bsp_manual, [arguments] { return run_bsp(*arguments); }, &a.meshes.words};
}

}  // namespace plumb::tool
