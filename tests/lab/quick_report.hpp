// What does a command that reports write?  One quick run of it into a folder of its own, for all tests of a program.
#pragma once

#include <string>

#include "lab/trial/terms.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::lab {

class QuickReport {
 public:
  /// `plumb-lab chart` writes chart.txt, chart.json, chart.html.
  explicit QuickReport(const std::string& command)
      : outcome(run("$PLUMB_LAB " + command + " --quick --out " + folder())),
        table(file(command + ".txt")),
        page(file(command + ".html")),
        raw(json::parse(file(command + ".json"), nullptr, false)) {}

  [[nodiscard]] std::string folder() const { return folder_ / "report"; }
  [[nodiscard]] std::string file(const std::string& name) const { return content(folder() + "/" + name); }

 private:
  Folder folder_;

 public:
  const Outcome outcome;
  const std::string table, page;
  const json raw;
};

/// The page without the name of the SVG language, from which nothing is fetched.
inline std::string without_svg_names(std::string page) {
  constexpr std::string_view name = "http://www.w3.org/2000/svg";
  for (std::size_t at = 0; (at = page.find(name)) != std::string::npos;) page.erase(at, name.size());
  return page;
}

/// A page that refers to nothing outside of itself.
inline auto needs_no_network() {
  return testing::ResultOf(without_svg_names, AllOf(StartsWith("<!DOCTYPE html>"), Not(HasSubstr("http:")),
                                                    Not(HasSubstr("https:")), Not(HasSubstr(" src="))));
}

}  // namespace plumb::lab
