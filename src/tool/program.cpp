#include "program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iostream>
#include <new>

#include "bounds_command.hpp"
#include "chart_command.hpp"
#include "check_command.hpp"
#include "doctor_command.hpp"
#include "fuzz_command.hpp"
#include "help_text.hpp"
#include "plan_command.hpp"
#include "plumb/arith/error.hpp"
#include "proof_command.hpp"
#include "sign_command.hpp"
#include "stability_command.hpp"
#include "terminal.hpp"
#include "vectors_command.hpp"

namespace plumb::tool {
namespace {

/// The page of a command, with the options that its parser knows.
std::string manual_page(const Manual& manual, const CLI::App& app, const Style& style) {
  std::vector<ShownOption> options;
  for (const CLI::Option* const option : app.get_options()) {
    ShownOption& shown = options.emplace_back();
    shown.description = option->get_description();
    if (option->get_positional()) {
      shown.names.push_back(option->get_name(true));
      continue;
    }
    for (const std::string& name : option->get_snames()) shown.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) shown.names.push_back("--" + name);
    const std::string type = option->get_type_name();  // "METHOD:{float32,...}": the checks follow the colon
    if (option->get_items_expected_max() > 0) shown.value = type.substr(0, type.find(':'));
  }
  return tool::manual_page(manual, options, style);
}

class Program {
 public:
  explicit Program(std::span<const trial::Rival> rivals) : rivals_(rivals) {
    constexpr const char* page = "Show this page.";
    app_.set_help_flag("-h,--help", page);
    for (const Command& c : commands_) c.parser->set_help_flag("-h,--help", page);
    app_.add_flag("--version", version_, "Print the version.");
    add_bounds();
    add_chart();
    add_check();
    add_fuzz();
    add_plan();
    add_proof();
    add_stability();
    add_vectors();
    sign_->prefix_command();  // what follows is a case: a leading '-' there is a sign, not an option
  }

  int run(int argc, char** argv) {
    // What follows "--" is kept from the parser, which would not take it for a MESH once there is another.
    char** const end = argv + argc;
    char** const dashes = std::find_if(argv, end, [](const char* word) { return std::string_view(word) == "--"; });
    const std::vector<std::string> rest(dashes == end ? end : dashes + 1, end);
    app_.parse(static_cast<int>(dashes - argv), argv);
    if (version_) {
      say(fmt::format("plumb {}\n", check_environment().version));
      return 0;
    }
    const Command* const c = named();
    if (c != nullptr && c->takes_rest != nullptr) {
      c->takes_rest->insert(c->takes_rest->end(), rest.begin(), rest.end());
    } else if (!rest.empty()) {
      throw CLI::ExtrasError(rest);
    }
    if (c != nullptr) return c->run();
    std::string names;
    for (const Command& known : commands_) names.append(names.empty() ? "" : ", ").append(known.parser->get_name());
    throw Error(fmt::format("a command is needed, one of {}; 'plumb --help' explains", names));
  }

  /// The page of the command that was named, or of the program.
  void help() const {
    const Style style(stdout);
    const Command* const c = named();
    say(c != nullptr ? manual_page(c->manual(), *c->parser, style) : manual_page(program_manual(), app_, style));
  }

  [[nodiscard]] std::string help_hint() const {
    const Command* const c = named();
    return c != nullptr ? fmt::format("'plumb {} --help' explains", c->parser->get_name()) : "'plumb --help' explains";
  }

 private:
  struct Command {
    CLI::App* parser;
    Manual (*manual)();
    std::function<int()> run;
    std::vector<std::string>* takes_rest = nullptr;  // what stands after "--"
  };

  [[nodiscard]] const Command* named() const {
    const auto at = std::ranges::find_if(commands_, [](const Command& c) { return bool(*c.parser); });
    return at == commands_.end() ? nullptr : &*at;
  }

  /// What plans of scenes and ratings of bounds are made from.
  template <class Options>
  static void add_placements(CLI::App* command, Options& o) {
    command
        ->add_option("--placements", o.placements,
                     fmt::format("How many placements of two copies; {} when not given.", o.placements))
        ->check(CLI::Range(1U, 1'000'000U))
        ->type_name("N");
    command
        ->add_option(
            "--refined", o.refined_ns,
            fmt::format("What the test behind the bounds costs, in nanoseconds; {} when not given.", o.refined_ns))
        ->check(CLI::Range(0.0, 1e12))
        ->type_name("NS");
  }

  void add_bounds() {
    BoundsOptions& o = bounds_options_;
    bounds_->add_option("MESH", o.meshes, "Mesh files, each rated in turn.");
    bounds_->add_option("--json", o.json, "Write the numbers as JSON; '-' is standard output.")->type_name("FILE");
    bounds_->add_option("--chart", o.chart, "Draw the spectrum over all meshes, as SVG.")->type_name("FILE");
    add_placements(bounds_, o);
  }

  void add_chart() {
    ChartOptions& o = chart_options_;
    chart_->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
        ->type_name("DIR");
    chart_->add_flag("--quick", o.quick, "Ask little of each class: seconds instead of minutes.");
    chart_->add_option("--task", o.tasks, "Only this task; repeatable.")->allow_extra_args(false)->type_name("NAME");
    chart_->add_option("--class", o.classes, "Only inputs of this class; repeatable.")
        ->allow_extra_args(false)
        ->type_name("NAME");
    chart_->add_option("--seed", o.seed, "Other inputs of the same classes; 2026 when not given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
  }

  void add_check() {
    const std::vector<std::string> methods(method_names.begin(), method_names.end());
    CheckOptions& o = check_options_;
    check_->add_option("MESH", o.meshes, "Mesh files, each checked in turn.");
    check_->add_option("--json", o.json, "Write the report as JSON; '-' is standard output.")->type_name("FILE");
    check_->add_option("--chart", o.chart, "Draw the share of wrong signs against the time per decision, as SVG.")
        ->type_name("FILE");
    check_->add_option("--threads", o.threads, "How many threads work; as many as the machine has when not given.")
        ->check(CLI::Range(1U, 4096U))
        ->type_name("N");
    check_->add_flag("--verify", o.verify,
                     "Take every decision once more in rational numbers (of a big mesh a sample, and say so), and "
                     "judge the exact method by them.");
    check_->add_option("--fail-on-wrong", o.fail_on_wrong, "Exit with 1 when METHOD takes a wrong sign; repeatable.")
        ->check(CLI::IsMember(methods))
        ->allow_extra_args(false)
        ->type_name("METHOD");
    check_
        ->add_option(
            "--write-sample", o.write_sample,
            "Write the mesh that the program brings along, in the format of the extension; alone, it checks nothing.")
        ->type_name("FILE");
  }

  void add_fuzz() {
    FuzzOptions& o = fuzz_options_;
    const auto repeatable = [this](const char* name, std::vector<std::string>& values, const char* about) {
      return fuzz_->add_option(name, values, about)->allow_extra_args(false)->type_name("NAME");
    };
    fuzz_->add_option("--kind", o.kind, "What the function is asked; --list tells the kinds.")->type_name("KIND");
    fuzz_->add_option("--library", o.library, "The shared library that holds the function.")->type_name("FILE");
    fuzz_->add_option("--symbol", o.symbol, "The function's name.")->type_name("NAME");
    fuzz_->add_flag("--list", o.list, "List the kinds with their C signatures; with --kind, its generators.");
    fuzz_->add_option("--cases", o.cases, "Ask so many of each generator; 1000 when no budget is given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    fuzz_->add_option("--time", o.seconds, "Ask for so long.")->type_name("SECONDS");
    fuzz_->add_option("--seed", o.seed, "Other cases of the same generators; 2026 when not given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    repeatable("--generator", o.generators, "Only cases of this generator; repeatable.");
    CLI::Option* const one_case =
        fuzz_->add_option("--case", o.case_line, "Ask only this case, as findings are printed.")->type_name("LINE");
    fuzz_->add_option("--corpus", o.corpus, "Ask the cases in this folder first, and add to it what is found.")
        ->type_name("DIR");
    fuzz_->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
        ->type_name("DIR");
    repeatable("--format", o.formats, "Print each finding as cpp, python or obj as well; repeatable.")
        ->check(CLI::IsMember({"cpp", "python", "obj"}));
    fuzz_->add_option("--ulps", o.ulps, "Of numbers, allow so many doubles beside the nearest.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    fuzz_->add_option("--relative", o.relative, "Of numbers, allow so much of the case's largest coordinate.")
        ->type_name("X");
    fuzz_->add_option("--timeout", o.timeout, "A call that takes longer hangs; 1 when not given.")
        ->type_name("SECONDS");
    fuzz_->add_option("--memory", o.memory_mib, "What the function may take; 1024 when not given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("MIB");
    for (const char* const of_many : {"--cases", "--time", "--generator", "--corpus", "--out"})
      one_case->excludes(fuzz_->get_option(of_many));
  }

  void add_plan() {
    PlanOptions& o = plan_options_;
    plan_->add_option("MESH", o.meshes, "Mesh files, together one scene.");
    plan_->add_option("--json", o.json, "Write the plan as JSON; '-' is standard output.")->type_name("FILE");
    plan_->add_option("--chart", o.chart, "Draw the times on each lattice and of each volume, as SVG.")
        ->type_name("FILE");
    plan_->add_flag("--all", o.all, "List the plan of every predicate.");
    add_placements(plan_, o);
  }

  void add_proof() {
    ProofOptions& o = proof_options_;
    CLI::Option* const predicate = proof_->add_option("PREDICATE", o.predicate, "As of `plumb proof --list`.");
    proof_->add_flag("--every-scale", o.every_scale,
                     "Claim instead, of every term by itself, what holds at every scale, of an operation that errs by "
                     "2^-53 of its result and of which nothing else is known.");
    proof_->add_option("--out", o.out, "Write the script there; '-' is standard output.")->type_name("FILE");
    proof_
        ->add_flag("--list", o.list,
                   "List the predicates with what is derived from each: its degree, its operations, the number of its "
                   "terms, and the constant of its filter.")
        ->excludes(predicate);
  }

  void add_stability() {
    StabilityOptions& o = stability_options_;
    stability_->add_option("--out", o.out, "Write the report into this folder, which is made where it is missing.")
        ->type_name("DIR");
    stability_->add_flag("--quick", o.settings.quick, "Try little of everything: seconds instead of minutes.");
    stability_->add_option("--experiment", o.experiments, "Only this experiment; repeatable.")
        ->allow_extra_args(false)
        ->type_name("NAME");
    stability_->add_option("--seed", o.settings.seed, "Other inputs of the same kinds; 2026 when not given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    stability_->add_option("--ccd", o.settings.ccd, "Try the queries of continuous tests in this folder as well.")
        ->type_name("DIR");
    stability_->add_option("--models", o.settings.models, "Try the meshes in this folder as well.")->type_name("DIR");
  }

  void add_vectors() {
    VectorsOptions& o = vectors_options_;
    vectors_->add_option("--out", o.out, "Write the files into this folder, which is made where it is missing.")
        ->required()
        ->type_name("DIR");
    vectors_->add_option("--seed", o.seed, "Other cases of the same classes; 2026 when not given.")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
  }

  int run_case() {
    std::vector<std::string> words = sign_->remaining();
    words.insert(words.end(), after_dashes_.begin(), after_dashes_.end());
    if (std::ranges::any_of(words, [](const std::string& w) { return w == "--help" || w == "-h"; })) {
      help();
      return 0;
    }
    if (!words.empty() && words.front().starts_with('-')) throw CLI::ExtrasError({words.front()});
    errno = 0;
    const int code = run_sign(words, std::cin);
    // The stream ends alike at the end of a file and at a failure; only the C stream below it knows which it was.
    if (std::ferror(stdin) != 0) throw Error(fmt::format("cannot read standard input: {}", std::strerror(errno)));
    return code;
  }

  CLI::App app_;
  bool version_ = false;
  BoundsOptions bounds_options_;
  CLI::App* bounds_ = app_.add_subcommand("bounds", "Rate bounding volumes on meshes.");
  std::span<const trial::Rival> rivals_;
  ChartOptions chart_options_;
  CLI::App* chart_ = app_.add_subcommand("chart", "Hold the ways of answering geometric questions against each other.");
  CheckOptions check_options_;
  CLI::App* check_ = app_.add_subcommand("check", "Hold floating-point decisions on meshes against the exact ones.");
  FuzzOptions fuzz_options_;
  CLI::App* fuzz_ = app_.add_subcommand("fuzz", "Find inputs on which a function of another library is wrong.");
  PlanOptions plan_options_;
  CLI::App* plan_ = app_.add_subcommand("plan", "Say what exact decisions on a scene need, and no more.");
  std::vector<std::string> after_dashes_;  // of a case
  CLI::App* sign_ = app_.add_subcommand("sign", "Decide one sign exactly.");
  ProofOptions proof_options_;
  CLI::App* proof_ = app_.add_subcommand("proof", "Write the claim of a filter's bound for a prover.");
  StabilityOptions stability_options_;
  CLI::App* stability_ = app_.add_subcommand("stability", "Find where geometric algorithms fail, and picture it.");
  VectorsOptions vectors_options_;
  CLI::App* vectors_ = app_.add_subcommand("vectors", "Write test vectors: inputs with exact answers.");
  CLI::App* doctor_ = app_.add_subcommand("doctor", "Look whether this machine is as the proofs assume.");
  const std::vector<Command> commands_ = {
      {bounds_, bounds_manual, [this] { return run_bounds(bounds_options_); }, &bounds_options_.meshes},
      {chart_, chart_manual, [this] { return run_chart(chart_options_, rivals_); }},
      {check_, check_manual, [this] { return run_check(check_options_); }, &check_options_.meshes},
      {fuzz_, fuzz_manual, [this] { return run_fuzz(fuzz_options_); }},
      {plan_, plan_manual, [this] { return run_plan(plan_options_); }, &plan_options_.meshes},
      {sign_, sign_manual, [this] { return run_case(); }, &after_dashes_},
      {proof_, proof_manual, [this] { return run_proof(proof_options_); }},
      {stability_, stability_manual, [this] { return run_stability(stability_options_); }},
      {vectors_, vectors_manual, [this] { return run_vectors(vectors_options_); }},
      {doctor_, doctor_manual, run_doctor}};
};

int refuse(std::string_view text) {
  complain(text);
  return 2;
}

}  // namespace

int run_program(int argc, char** argv, std::span<const trial::Rival> rivals) try {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that left is an output error like a full disk, not sudden death
  Program program(rivals);
  int code = 0;
  try {
    code = program.run(argc, argv);
  } catch (const CLI::CallForHelp&) {
    program.help();
  } catch (const CLI::ParseError& e) {
    return refuse(fmt::format("{}; {}", e.what(), program.help_hint()));
  }
  flush_output();
  return code;
} catch (const std::bad_alloc&) {
  return refuse("out of memory");
} catch (const std::exception& e) {
  return refuse(e.what());
}

}  // namespace plumb::tool
