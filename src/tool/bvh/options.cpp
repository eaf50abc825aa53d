#include "tool/bvh/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command bvh_command(CLI::App& program) {
  const auto options = std::make_shared<BvhArguments>();
  BvhArguments& o = *options;
  CLI::App* const parser = program.add_subcommand("bvh", "Build the tree of a mesh, rate it and draw it.");
  std::vector<std::string> methods;
  for (const BvhMethod method : bvh_methods) methods.push_back(word_of(method));
  methods.emplace_back("all");
  parser->add_option("MESH", o.meshes.words, "The mesh file; '-' is standard input.");
  add_reading(parser, o.meshes);
  parser->add_option("--method", o.method, "Build the tree this way; 'all' compares all of them.")
      ->check(CLI::IsMember(methods))
      ->capture_default_str()
      ->type_name("NAME");
  parser
      ->add_option("--split-share", o.split_share,
                   "Divide long triangles, into at most so many parts more, as a share of the triangles.")
      ->check(CLI::Range(0.0, 16.0))
      ->type_name("X");
  add_output(parser, "--json", o.json, "Write the numbers as JSON");
  add_output(parser, "--svg", o.svg, "Draw the boxes at some depths, and what each depth costs, as SVG");
  add_output(parser, "--out", o.out, "Keep the tree in a file, for --tree of the commands that ask it");
  parser->add_flag("--overwrite", o.overwrite, "Replace the files of --svg and --out where they are there.");
  return {parser, bvh_manual, [options] { return run_bvh(*options); }, &o.meshes.words};
}

}  // namespace plumb::tool
