#include "tool/proof/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/bound_report.hpp"
#include "plumb/certify/proof_script.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/suggestion.hpp"

namespace plumb::tool {
namespace {

/// What is derived from each predicate, one a line.
std::string table(const Style& style) {
  std::size_t width = 9;
  for (const CatalogEntry& e : catalog()) width = std::max(width, e.name.size());
  std::string text = style.bold(fmt::format("{:<{}}  {:>6}  {:>10}  {:>5}  {}", "predicate", width, "degree",
                                            "operations", "terms", "constant of the filter"));
  text += '\n';
  for (const CatalogEntry& e : catalog()) {
    const BoundReport r = bound_report(e.name, e.program, e.filter_constant);
    const std::string degree = fmt::format("{}{}", r.homogeneous ? "" : "<= ", r.degree);
    text += fmt::format("{:<{}}  {:>6}  {:>10}  {:>5}  {}\n", r.name, width, degree, r.operations, r.terms,
                        hexadecimal(r.constant));
  }
  return text;
}

const CatalogEntry& entry_of(const std::string& name) {
  if (name.empty()) {
    throw Error("proof: a predicate is expected, such as orient2d; 'plumb proof --list' lists them");
  }
  if (const CatalogEntry* entry = find_predicate(name)) return *entry;
  std::vector<std::string> names;
  for (const CatalogEntry& e : catalog()) names.emplace_back(e.name);
  throw Error(fmt::format("proof: there is no predicate '{}'{}; there are {}", printable(name), suggestion(name, names),
                          fmt::join(names, ", ")));
}

}  // namespace

int run_proof(const ProofOptions& options) {
  if (options.list) {
    say(table(Style(stdout)));
    return 0;
  }
  const CatalogEntry& e = entry_of(options.predicate);
  const ProofScale scale = options.every_scale ? ProofScale::every : ProofScale::unit;
  OutputFiles outputs;
  outputs.promise("--out", options.out.value_or("-"));
  outputs.write("--out", proof_script(e.name, e.program, e.filter_constant, scale));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
