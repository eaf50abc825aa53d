// What did a run of `plumb fuzz` find?  The same findings as text, JSON, chart and page.
//
// Laws: (1) all hold the same numbers; (2) the text has no times and no paths but those that were given, so the same
// run prints the same; (3) what foreign code left in a text (an exception's words) cannot command a terminal or a page.
// Source: none.
// Cost: none that counts.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tool/fuzz/options.hpp"
#include "tool/fuzz/run.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct FuzzReport {
  const degenerate::Kind& kind;
  const FuzzOptions& options;
  FuzzRun run;
  std::vector<SortOfFailure> found;  // in it
};

/// The switches that declare what is not as it is without them, each after a blank: " --ends open --range 1000".
std::string declared(const FuzzOptions& options);

/// The line that asks a case again, for a shell.
std::string replay_line(const FuzzOptions& options, const degenerate::Kind& kind, const degenerate::Numbers& numbers);

/// A finding ready to paste: what it is called, as a file and in words.
struct PasteFormat {
  std::string_view name, extension, title;
};
inline constexpr std::array paste_formats = {PasteFormat{"cpp", "cpp", "C++"}, PasteFormat{"python", "py", "Python"},
                                             PasteFormat{"obj", "obj", "OBJ"}};

/// In a format of paste_formats.
std::string pasteable(std::string_view format, const degenerate::Kind& kind, const degenerate::Numbers& numbers,
                      const FuzzOptions& options);
/// What the user allows of numbers; nothing: what the kind does.
std::optional<degenerate::Tolerance> tolerance_of(const FuzzOptions& options, const degenerate::Kind& kind);

std::string fuzz_text(const FuzzReport& report, const Style& style);
nlohmann::json fuzz_json(const FuzzReport& report);

/// A row a generator: the share of wrong answers, and that of calls which did not end in an answer.
std::string fuzz_chart(const FuzzReport& report);

/// `raw` is fuzz_json's.
std::string fuzz_html(const FuzzReport& report, const nlohmann::json& raw);

}  // namespace plumb::tool
