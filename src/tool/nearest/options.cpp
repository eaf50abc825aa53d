#include "tool/manual/command.hpp"
#include "tool/manual/whole_number.hpp"
#include "tool/nearest/command.hpp"

namespace plumb::tool {

Command nearest_command(CLI::App& program) {
  const auto options = std::make_shared<NearestOptions>();
  NearestOptions& o = *options;
  CLI::App* const parser = program.add_subcommand("nearest", "Find the points that are nearest to queries, exactly.");
  parser->add_option("POINTS QUERIES", o.files.words, "The two files; '-' is standard input.");
  o.files.points_too = true;
  add_reading(parser, o.files);
  parser->add_option("-k", o.k, "How many points to find for each query, nearest first; 1 when not given.")
      ->check(whole_number_from(1, 4294967295U))
      ->type_name("N");
  parser->add_option("--within", o.within, "Find all points that are no farther than that, instead.")
      ->type_name("RADIUS");
  parser->add_flag("--ties", o.ties, "Tell all points that are exactly as near as the last one asked for, too.");
  add_threads(parser, o.threads);
  parser->add_flag("--all", o.all, "List every answer; without this option, the first ten.");
  parser->add_option("--most", o.most, "Keep so many answers for the outputs at the most; count any number.")
      ->check(whole_number_from(1, std::uint64_t{1} << 40))
      ->capture_default_str()
      ->type_name("N");
  add_output(parser, "--json", o.json, "Write the answers as JSON");
  add_output(parser, "--out", o.out, "Write the points' numbers as an array of NumPy (.npy)");
  add_output(parser, "--distances", o.distances, "Write the distances as an array of NumPy (.npy)");
  add_output(parser, "--svg", o.svg, "Draw the tree's planes, the points and the queries as SVG");
  parser->add_flag("--overwrite", o.overwrite,
                   "Replace the files of --out, --distances and --svg where they are there.");
  return {parser, nearest_manual, [options] { return run_nearest(*options); }, &o.files.words};
}

}  // namespace plumb::tool
