#include "plumb/degenerate/convention.hpp"
#include "tool/fuzz/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command fuzz_command(CLI::App& program) {
  const auto options = std::make_shared<FuzzOptions>();
  FuzzOptions& o = *options;
  CLI::App* const parser =
      program.add_subcommand("fuzz", "Find inputs on which a function of another library is wrong.");
  const auto repeatable = [parser](const char* name, std::vector<std::string>& values, const char* about) {
    return parser->add_option(name, values, about)->allow_extra_args(false)->type_name("NAME");
  };
  const auto one_of = [](const auto& names) {
    return CLI::IsMember(std::vector<std::string>(names.begin(), names.end()));
  };
  parser->add_option("--kind", o.kind, "What the function is asked; --list tells the kinds.")->type_name("KIND");
  parser->add_option("--library", o.library, "The shared library that holds the function.")->type_name("FILE");
  parser->add_option("--symbol", o.symbol, "The function's name.")->type_name("NAME");
  parser->add_flag("--list", o.list, "List the kinds with their C signatures; with --kind, its generators.");
  parser->add_option("--cases", o.cases, "Ask so many of each generator; 1000 when no budget is given.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  parser->add_option("--time", o.seconds, "Ask for so long.")->type_name("SECONDS");
  add_seed(parser, o.seed, "Other cases of the same generators;");
  repeatable("--generator", o.generators, "Only cases of this generator; repeatable.");
  CLI::Option* const one_case =
      parser->add_option("--case", o.case_line, "Ask only this case, as findings are printed.")->type_name("LINE");
  parser->add_option("--corpus", o.corpus, "Ask the cases in this folder first, and add to it what is found.")
      ->type_name("DIR");
  parser->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
      ->type_name("DIR");
  repeatable("--format", o.formats, "Print each finding as cpp, python or obj as well; repeatable.")
      ->check(CLI::IsMember({"cpp", "python", "obj"}));
  parser->add_option("--ulps", o.ulps, "Of numbers, allow so many doubles beside the nearest.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  parser->add_option("--relative", o.relative, "Of numbers, allow so much of the case's largest coordinate.")
      ->type_name("X");
  parser->add_option("--boundary", o.boundary, "Figures with their boundaries (in), without (out), or either (any).")
      ->check(one_of(degenerate::boundary_names))
      ->type_name("WHICH");
  parser->add_option("--ends", o.ends, "Segments with their ends, rays with their origins: closed, open or any.")
      ->check(one_of(degenerate::ends_names))
      ->type_name("WHICH");
  parser->add_flag("!--no-degenerate", o.domain.degenerate, "Ask no case that is degenerate.");
  parser->add_option("--range", o.domain.largest, "Ask no number of a larger magnitude.")->type_name("X");
  parser->add_option("--smallest", o.domain.smallest, "Ask no number but 0 of a smaller magnitude.")->type_name("X");
  parser->add_option("--grid", o.domain.grid, "Ask multiples of this power of two only.")->type_name("X");
  parser->add_option("--bits", o.domain.bits, "Ask mantissas of so many bits at most; 24: those of a float.")
      ->type_name("N");
  parser->add_option("--judge", o.judge, "Right is what this function answers, whose signature is the kind's.")
      ->type_name("FILE:SYMBOL");
  repeatable("--argument", o.arguments, "Of a kind of your own, the arguments in turn, such as a:point2; repeatable.")
      ->type_name("NAME:WHAT");
  parser->add_option("--answer", o.answer, "Of a kind of your own: sign, yes-no or number; sign when not given.")
      ->check(CLI::IsMember({"sign", "yes-no", "number"}))
      ->type_name("FORM")
      ->needs("--argument");
  parser->add_option("--timeout", o.timeout, "A call that takes longer hangs; 1 when not given.")->type_name("SECONDS");
  parser->add_option("--memory", o.memory_mib, "What the function may take; 1024 when not given.")
      ->check(CLI::NonNegativeNumber)
      ->type_name("MIB");
  for (const char* const of_many : {"--cases", "--time", "--generator", "--corpus", "--out"})
    one_case->excludes(parser->get_option(of_many));
  return {parser, fuzz_manual, [options] { return run_fuzz(*options); }, nullptr, {{"--kind", kind_names}}};
}

}  // namespace plumb::tool
