#include "tool/fuzz/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/degenerate/convention.hpp"
#include "plumb/degenerate/own_kind.hpp"
#include "plumb/degenerate/paste.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "tool/fuzz/corpus.hpp"
#include "tool/fuzz/foreign_judge.hpp"
#include "tool/fuzz/own_arguments.hpp"
#include "tool/fuzz/report.hpp"
#include "tool/terminal/suggestion.hpp"
#include "tool/terminal/terminal.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::tool {
namespace {

using degenerate::Answer;
using degenerate::Kind;
using degenerate::Numbers;

constexpr std::uint64_t kCases = 1000;  // of each generator, when no budget is given
constexpr std::size_t kSorts = 12;      // of failure that are kept of a generator: more than there are of signs
constexpr double kLongest = 1e9;        // seconds; thirty years
constexpr std::uint64_t kMostCases = 1ull << 53;

/// One of those there are.
const Kind& kind_called(const std::string& name) {
  if (const Kind* const kind = degenerate::find_kind(name)) return *kind;
  throw Error(
      fmt::format("fuzz: --kind: there is no kind {}{}; 'plumb fuzz --list' names those there are, and "
                  "--argument makes one of your own",
                  printable(name), suggestion(name, kind_names())));
}

void list(const Kind& kind, const Style& style) {
  say(fmt::format("{}: {}\n  {};\n  {}\n", style.bold(kind.name), kind.question, kind.signature, kind.convention));
  std::string switches;
  if (kind.has_boundary) switches += " --boundary in|out|any";
  if (kind.has_ends) switches += " --ends closed|open|any";
  if (!switches.empty()) say(fmt::format("  to be declared:{}\n", switches));
}

/// What there is: kinds with their signatures, or of one the generators.
int list(const FuzzOptions& options) {
  const Style style(stdout);
  if (options.kind.empty()) {
    for (const Kind& kind : degenerate::kinds()) list(kind, style);
    say("\nThe sign of any predicate is a kind too, by its name:");
    std::size_t column = 80;
    for (const Kind& kind : degenerate::predicate_kinds()) {
      if (column + kind.name.size() + 1 > 78) say("\n "), column = 1;
      say(fmt::format(" {}", kind.name));
      column += kind.name.size() + 1;
    }
    say("\n");
    return 0;
  }
  const Kind& kind = kind_called(options.kind);
  list(kind, style);
  say("\n");
  std::size_t width = degenerate::mutated_generator.size();
  for (const degenerate::Generator& g : kind.generators) width = std::max(width, g.name.size());
  for (const degenerate::Generator& g : kind.generators) say(fmt::format("  {:{}}  {}\n", g.name, width, g.about));
  say(fmt::format("  {:{}}  cases of the others and of the corpus, changed a little\n", degenerate::mutated_generator,
                  width));
  return 0;
}

void require_between(double value, double least, double most, std::string_view option) {
  if (!(value >= least && value <= most))  // nor NaN
    throw Error(fmt::format("fuzz: {} takes a number from {} to {}, not {}", option, least, most, value));
}

void require_sense(const FuzzOptions& o) {
  const auto require = [](bool given, std::string_view option, std::string_view what) {
    if (!given) throw Error(fmt::format("fuzz: {} is wanted: {}; 'plumb fuzz --help' explains", option, what));
  };
  require(!o.kind.empty(), "--kind", "what the function is asked, of 'plumb fuzz --list'");
  require(!o.library.empty(), "--library", "the shared library that holds the function");
  require(!o.symbol.empty(), "--symbol", "the function's name");
  if (o.cases) require_between(static_cast<double>(*o.cases), 1, static_cast<double>(kMostCases), "--cases");
  if (o.seconds) require_between(*o.seconds, 1e-3, kLongest, "--time");
  if (o.relative) require_between(*o.relative, 0, 1, "--relative");
  require_between(o.timeout, 1e-3, 1e6, "--timeout");
  require_between(static_cast<double>(o.memory_mib), 1, 1 << 20, "--memory");
  if (const auto flaw = flaw_of(o.domain))
    throw Error(fmt::format("fuzz: --{}: {}", flaw->member == "largest" ? "range" : flaw->member, flaw->why));
}

/// The kind under what the switches declare; one that makes no difference to it is refused.
Kind as_declared(const Kind& kind, const FuzzOptions& o) {
  const auto place = [](const auto& names, std::string_view name) {
    return std::ranges::find(names, name) - names.begin();  // the parser lets no other name through
  };
  const degenerate::Convention declared{
      static_cast<degenerate::Boundary>(place(degenerate::boundary_names, o.boundary)),
      static_cast<degenerate::Ends>(place(degenerate::ends_names, o.ends))};
  const auto require = [&](bool difference, std::string_view option) {
    if (difference) return;
    throw Error(fmt::format("fuzz: {} {}; leave it out", option,
                            o.judge ? "is for the judge to decide" : "makes no difference to " + kind.name));
  };
  const degenerate::Convention standard;
  require(kind.has_boundary || declared.boundary == standard.boundary, "--boundary");
  require(kind.has_ends || declared.ends == standard.ends, "--ends");
  return under(kind, declared);
}

/// FILE and SYMBOL.
std::pair<std::string, std::string> split_judge(const std::string& judge) {
  const std::size_t colon = judge.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == judge.size())
    throw Error(fmt::format("fuzz: --judge takes FILE:SYMBOL, such as ./libmine.so:exactly, not {}", printable(judge)));
  return {judge.substr(0, colon), judge.substr(colon + 1)};
}

Kind own_kind_of(const FuzzOptions& o, const ForeignLimits& limits) {
  if (!o.judge) throw Error("fuzz: --judge is wanted: who knows the answers of a kind of your own?");
  if (degenerate::find_kind(o.kind) != nullptr)
    throw Error(fmt::format("fuzz: {} has its arguments; give a kind of your own another name, or leave --argument",
                            printable(o.kind)));
  degenerate::OwnKind own{.name = o.kind, .arguments = {}, .form = own_answer(o.answer), .exact = {}};
  for (const std::string& word : o.arguments) own.arguments.push_back(own_argument(word));
  own.exact = [](std::span<const double>) { return Answer(0.0); };  // until there is the judge, whose type this tells
  const auto [library, symbol] = split_judge(*o.judge);
  own.convention = fmt::format("right is what {} answers", symbol);
  own.exact = judged_by(own_kind(own), library, symbol, o.memory_mib, limits).exact;
  return own_kind(std::move(own));
}

Kind kind_of(const FuzzOptions& o, const ForeignLimits& limits) {
  if (!o.arguments.empty()) return as_declared(own_kind_of(o, limits), o);
  const Kind& kind = kind_called(o.kind);
  if (!o.judge) return as_declared(kind, o);
  const auto [library, symbol] = split_judge(*o.judge);
  return as_declared(judged_by(kind, library, symbol, o.memory_mib, limits), o);
}

/// The line's case; the kind's name before the numbers may be left out.
Numbers given_case(const Kind& kind, const std::string& line) {
  try {
    if (std::optional<Numbers> numbers = parse_case(kind, line)) return *numbers;
    if (std::optional<Numbers> numbers = parse_case(kind, fmt::format("{} {}", kind.name, line))) return *numbers;
  } catch (const Error& e) {
    throw Error(fmt::format("fuzz: --case: {}", printable(e.what())));
  }
  throw Error(fmt::format("fuzz: --case: this is no case of {}", kind.name));
}

int replay(const FuzzOptions& o, const Kind& kind, ForeignProcess& process, const Numbers& numbers) {
  Answer given;
  if (process.ask(std::span(&numbers, 1), std::span(&given, 1)) == 0)
    throw Error("fuzz: the foreign process could not be asked");
  const degenerate::Judgment j = judge(kind, numbers, given, tolerance_of(o, kind).value_or(kind.tolerance));
  const Style style(stdout);
  const bool found = j.verdict == degenerate::Verdict::wrong || j.verdict == degenerate::Verdict::failed;
  say(fmt::format("{}\ngiven {}, exact {}: {}\n", decimal_text(kind, numbers), printable(words(kind, given)),
                  words(kind, kind.exact(numbers)),
                  j.verdict == degenerate::Verdict::unsure ? style.yellow("unsure")
                  : found                                  ? style.red(printable(j.sort))
                                                           : style.green("right")));
  for (const std::string& format : o.formats) say(fmt::format("\n{}", pasteable(format, kind, numbers, o)));
  return found ? 1 : 0;
}

std::string case_file(std::size_t number, const PasteFormat& format) {
  return fmt::format("case-{}.{}", number, format.extension);
}

/// All files of a report.
std::vector<NamedText> report_files(const FuzzReport& r) {
  const nlohmann::json raw = fuzz_json(r);
  std::vector<NamedText> files{{"fuzz.txt", fuzz_text(r, Style(false))},
                               {"fuzz.json", raw.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"},
                               {"fuzz.svg", fuzz_chart(r)},
                               {"fuzz.html", fuzz_html(r, raw)}};
  for (std::size_t i = 0; i < r.found.size(); ++i) {
    const Numbers& numbers = r.found[i].simplest->smallest;
    for (const PasteFormat& format : paste_formats) {
      files.push_back({case_file(i + 1, format), pasteable(format.name, r.kind, numbers, r.options)});
    }
  }
  return files;
}

/// Report and new cases, all of them or none.
void keep(const FuzzReport& r) {
  namespace fs = std::filesystem;
  std::vector<NamedText> cases;
  std::vector<PathAndText> of_corpus;
  std::vector<fs::path> folder;
  if (const auto& corpus = r.options.corpus) {
    std::vector<Numbers> smallest;
    for (const degenerate::Finding& f : r.run.findings.findings) smallest.push_back(f.smallest);
    cases = new_cases(*corpus, r.kind, smallest);
    for (const NamedText& file : cases) of_corpus.push_back({fs::path(*corpus) / file.name, file.text});
    if (!cases.empty()) folder.emplace_back(*corpus);
    say(fmt::format("{} new in {}\n", cases.size(), printable(*corpus)));
  }
  if (const auto& out = r.options.out) {
    std::vector<NamedText> files = report_files(r);
    say(fmt::format("{} files in {}\n", files.size(), printable(*out)));
    write_report(*out, "fuzz", std::move(files), std::move(of_corpus), std::move(folder));
  } else {
    flush_output();
    keep_files(of_corpus, folder);
  }
}

int search(const FuzzOptions& o, const Kind& kind, ForeignProcess& process, std::vector<Numbers> corpus) {
  degenerate::CheckOptions check;
  check.seed = o.seed;
  check.cases = o.cases.value_or(o.seconds ? 0 : kCases);
  check.seconds = o.seconds.value_or(0);
  check.generators = o.generators;
  check.corpus = std::move(corpus);
  check.tolerance = tolerance_of(o, kind);
  check.domain = o.domain;
  check.keep = kSorts;
  FuzzReport report{kind, o, fuzz(kind, process, check), {}};
  report.found = sorts_of_failure(kind, report.run.findings);
  if (report.found.empty() && report.run.end == FuzzRun::End::exhausted) {
    throw Error(
        fmt::format("fuzz: the process that calls {} ended again and again between calls; a function must not "
                    "close files or end threads that are not its own",
                    printable(o.symbol)));
  }
  say(fuzz_text(report, Style(stdout)));
  keep(report);
  return report.found.empty() ? 0 : 1;
}

}  // namespace

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const std::span<const Kind> all : {degenerate::kinds(), degenerate::predicate_kinds()}) {
    for (const Kind& kind : all) names.push_back(kind.name);
  }
  return names;
}

int run_fuzz(const FuzzOptions& options) {
  if (options.list) return list(options);
  require_sense(options);
  ForeignLimits limits;
  limits.call = std::chrono::milliseconds(std::max<long>(1, std::lround(options.timeout * 1000)));
  const Kind kind = kind_of(options, limits);
  // What a report or a case needs is looked at before anything foreign runs.
  std::optional<Numbers> numbers;
  if (options.case_line) numbers = given_case(kind, *options.case_line);
  std::vector<Numbers> corpus;
  if (!numbers && options.corpus) corpus = read_corpus(*options.corpus, kind);
  if (!numbers && options.out)
    require_report_folder(*options.out, "fuzz", {"fuzz.txt", "fuzz.json", "fuzz.svg", "fuzz.html"});
  ForeignProcess process({options.library, options.symbol, kind, options.memory_mib}, limits);
  return numbers ? replay(options, kind, process, *numbers) : search(options, kind, process, std::move(corpus));
}

}  // namespace plumb::tool
