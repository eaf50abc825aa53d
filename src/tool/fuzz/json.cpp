#include <array>
#include <nlohmann/json.hpp>

#include "certify/case_line.hpp"
#include "plumb/degenerate/paste.hpp"
#include "tool/fuzz/report.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using degenerate::Finding;
using nlohmann::json;

json json_of(const FuzzReport& r, const SortOfFailure& found) {
  const Finding& f = *found.simplest;
  json others = json::array();
  for (const Finding& other : r.run.findings.findings) {
    if (other.sort == f.sort && &other != &f)
      others.push_back({{"generator", other.generator}, {"case", case_line(r.kind, other.smallest)}});
  }
  json numbers = json::array();
  for (const double x : f.smallest) numbers.push_back(hexadecimal(x));
  return {{"sort", printable(f.sort)},
          {"found_by", found.generators},
          {"generator", f.generator},
          {"index", f.index},
          {"degenerate", f.degenerate},
          {"repeated", f.repeated},
          {"given", printable(words(r.kind, f.given))},
          {"right", words(r.kind, f.exact)},
          {"numbers", std::move(numbers)},
          {"decimal", decimal_text(r.kind, f.smallest)},
          {"case", case_line(r.kind, f.smallest)},
          {"others", std::move(others)},
          {"again", replay_line(r.options, r.kind, f.smallest)}};
}

}  // namespace

json fuzz_json(const FuzzReport& r) {
  constexpr std::array ends = {"budget spent", "interrupted", "too many crashes or hangs"};
  json j = origin_json("plumb fuzz");
  j["kind"] = r.kind.name;
  j["question"] = r.kind.question;
  j["signature"] = r.kind.signature;
  j["library"] = r.options.library;
  j["symbol"] = r.options.symbol;
  j["seed"] = r.options.seed;
  j["convention"] = r.kind.convention;
  j["declared"] = declared(r.options);
  j["end"] = ends[static_cast<std::size_t>(r.run.end)];
  j["generators"] = json::array();
  for (const degenerate::Tally& t : r.run.findings.tallies) {
    j["generators"].push_back({{"generator", t.generator},
                               {"asked", t.asked},
                               {"wrong", t.wrong},
                               {"failed", t.failed},
                               {"degenerate_cases", t.degenerate},
                               {"unsure", t.unsure},
                               {"none_in_domain", t.passed_over}});
  }
  j["findings"] = json::array();
  for (const SortOfFailure& f : r.found) j["findings"].push_back(json_of(r, f));
  return j;
}

}  // namespace plumb::tool
