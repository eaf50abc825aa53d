#include "lab/stability/command.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lab/stability/report.hpp"
#include "plumb/arith/error.hpp"
#include "tool/terminal/chosen_names.hpp"
#include "tool/terminal/progress.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::lab {
namespace {

using stability::Experiment;
using stability::Scene;

void keep_chosen(const std::vector<std::string>& names, std::vector<Experiment>& experiments) {
  std::vector<std::string> known;
  for (const Experiment& e : experiments) known.push_back(e.name);
  require_known("stability", "experiment", names, known);
  std::erase_if(experiments, [&](const Experiment& e) { return !is_chosen(names, e.name); });
}

void require_readable_folder(std::string_view option, const std::optional<std::string>& folder) {
  std::error_code error;
  if (folder && !std::filesystem::is_directory(*folder, error)) {
    throw Error(fmt::format("stability: {} {} is no folder that can be read", option, printable(*folder)));
  }
}

std::vector<SceneReport> run_all(const std::vector<Experiment>& experiments, const stability::Settings& settings) {
  std::vector<SceneReport> reports;
  std::vector<Scene> scenes;
  for (const Experiment& e : experiments) {
    for (Scene& s : e.scenes(settings)) {
      reports.push_back({e.name, e.question, e.source, s.name, s.about, {}});
      scenes.push_back(std::move(s));
    }
  }
  tool::Progress progress("stability", scenes.size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    reports[i].findings = scenes[i].run();
    progress.advance();
  }
  return reports;
}

}  // namespace

int run_stability(const StabilityOptions& options, std::vector<Experiment> experiments) {
  keep_chosen(options.experiments, experiments);
  require_readable_folder("--ccd", options.settings.ccd);
  require_readable_folder("--models", options.settings.models);
  if (options.out)  // before minutes of work, not after
    require_report_folder(*options.out, "stability", {"stability.txt", "stability.json", "stability.html"});
  const std::vector<SceneReport> reports = run_all(experiments, options.settings);

  const Style style(stdout);
  std::vector<NamedText> files;
  std::string table;
  for (const SceneReport& r : reports) {
    say(scene_text(r, style) + "\n");
    table += scene_text(r, Style(false)) + "\n";
    for (const stability::Picture& p : r.findings.pictures) files.push_back({p.name + ".svg", p.svg});
  }
  const std::vector<std::string> failed = failed_exactly(reports);
  for (const std::string& scene : failed) complain(fmt::format("the exact method failed in {}", scene));
  if (options.out) {
    files.push_back({"stability.txt", std::move(table)});
    const nlohmann::json raw = scenes_json(reports, options.settings);
    files.push_back({"stability.json", raw.dump(2) + "\n"});
    files.push_back({"stability.html", scenes_html(reports, raw)});
    const std::size_t count = files.size();
    say(fmt::format("{} files in {}\n", count, printable(*options.out)));
    write_report(*options.out, "stability", std::move(files));
  }
  return failed.empty() ? 0 : 1;
}

}  // namespace plumb::lab
