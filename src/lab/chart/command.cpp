#include "lab/chart/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lab/chart/trial_report.hpp"
#include "lab/trial/allocations.hpp"
#include "plumb/arith/error.hpp"
#include "tool/terminal/chosen_names.hpp"
#include "tool/terminal/progress.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::lab {
namespace {

using trial::InputClass;
using trial::Task;

std::vector<std::string> names_of(const std::vector<Task>& tasks) {
  std::vector<std::string> names;
  for (const Task& task : tasks) names.push_back(task.name);
  return names;
}

std::vector<std::string> class_names_of(const std::vector<Task>& tasks) {
  std::vector<std::string> names;
  for (const Task& task : tasks) {
    for (const InputClass& c : task.classes) {
      if (std::ranges::find(names, c.name) == names.end()) names.push_back(c.name);
    }
  }
  return names;
}

/// What is asked for, in the order of the report.
std::vector<Task> chosen(const ChartOptions& options, std::span<const trial::Rival> rivals) {
  std::vector<Task> tasks = trial::all_tasks(rivals);
  require_known("chart", "task", options.tasks, names_of(tasks));
  require_known("chart", "class", options.classes, class_names_of(tasks));
  std::erase_if(tasks, [&](const Task& task) { return !is_chosen(options.tasks, task.name); });
  for (Task& task : tasks)
    std::erase_if(task.classes, [&](const InputClass& c) { return !is_chosen(options.classes, c.name); });
  std::erase_if(tasks, [](const Task& task) { return task.classes.empty(); });
  if (tasks.empty()) throw Error("chart: none of these tasks has any of these classes");
  return tasks;
}

}  // namespace

std::vector<std::string> task_names(std::span<const trial::Rival> rivals) { return names_of(trial::all_tasks(rivals)); }

std::vector<std::string> class_names(std::span<const trial::Rival> rivals) {
  return class_names_of(trial::all_tasks(rivals));
}

int run_chart(const ChartOptions& options, std::span<const trial::Rival> rivals) {
  const std::vector<Task> tasks = chosen(options, rivals);
  if (options.out)  // before minutes of work, not after
    require_report_folder(*options.out, "chart", {"chart.txt", "chart.json", "chart.html"});
  trial::Settings settings;
  settings.seed = options.seed;
  if (options.quick) settings.cases = 128, settings.long_ns = 100'000;
  std::uint64_t steps = 0;
  for (const Task& task : tasks) steps += task.methods.size() * task.classes.size();

  trial::count_gmp_allocations();
  const Style style(stdout);
  std::vector<trial::Trial> trials;
  std::string table;
  {
    Progress progress("chart", steps);
    for (const Task& task : tasks) {
      for (const InputClass& input : task.classes) {
        trials.push_back(trial::measure(task, input, settings, [&] { progress.advance(); }));
      }
    }
  }
  std::vector<NamedText> files;
  for (const trial::Trial& t : trials) {
    say(trial_text(t, style) + "\n");
    table += trial_text(t, Style(false)) + "\n";
    files.push_back({fmt::format("{}-{}.svg", t.task, t.input), trial_chart(t)});
  }
  if (!options.out) return 0;
  files.push_back({"chart.txt", std::move(table)});
  const nlohmann::json raw = trials_json(trials, settings);
  files.push_back({"chart.json", raw.dump(2) + "\n"});
  files.push_back({"chart.html", trials_html(trials, raw)});
  const std::size_t count = files.size();
  say(fmt::format("{} files in {}\n", count, printable(*options.out)));
  write_report(*options.out, "chart", std::move(files));
  return 0;
}

}  // namespace plumb::lab
