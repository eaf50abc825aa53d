#include "lab/vectors/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "lab/trial/measure.hpp"
#include "lab/vectors/sized_cases.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "query/kinds/kind_generators.hpp"
#include "tool/manual/meanings.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::lab {
namespace {

using trial::InputClass;
using trial::Task;

constexpr std::uint64_t most_looked_at = 96;  // cases of a class
constexpr std::size_t first_cases = 4, of_answer = 2, of_method = 4;
constexpr double lost_doubles = 0x1p33;  // between the answer and the nearest double: some 20 bits of 53 are right

enum class Form : std::uint8_t { sign, yes_no, number, corners };

struct Layout {
  std::string_view task, numbers;
  Form form;
};

constexpr std::array layouts{
    Layout{"orient2d", "points a, b, c: x y each", Form::sign},
    Layout{"orient3d", "points a, b, c, d: x y z each", Form::sign},
    Layout{"incircle", "points a, b, c, d: x y each", Form::sign},
    Layout{"insphere", "points a, b, c, d, e: x y z each", Form::sign},
    Layout{"segment-segment", "the ends of two segments: x y each", Form::yes_no},
    Layout{"ray-triangle", "origin and direction of the ray, corners of the triangle: x y z each", Form::yes_no},
    Layout{"ray-mesh",
           "origin and direction of the ray, then the 6 corners +x -x +y -y +z -z of an octahedron: x y z each",
           Form::yes_no},
    Layout{"segment-triangle", "ends of the segment, corners of the triangle: x y z each", Form::yes_no},
    Layout{"triangle-triangle", "corners of either triangle: x y z each", Form::yes_no},
    Layout{"box-box", "least and largest corner of either box: x y z each", Form::yes_no},
    Layout{"obb-obb", "center, three axes and three half sizes of either box, as they are given: x y z each",
           Form::yes_no},
    Layout{"point-in-polygon", "the point, then the 8 corners of the polygon in turn: x y each", Form::yes_no},
    Layout{"point-in-polyhedron",
           "the point, then the 6 corners +x -x +y -y +z -z of an octahedron about the origin: x y z each",
           Form::yes_no},
    Layout{"hull-2d", "16 points: x y each", Form::corners},
    Layout{"hull-3d", "12 points: x y z each", Form::corners},
    Layout{"vertex-face-motion", "the vertex and the three corners at time 0, then at time 1: x y z each",
           Form::yes_no},
    Layout{"edge-edge-motion", "the ends of both edges at time 0, then at time 1: x y z each", Form::yes_no},
    Layout{"smallest-ball", "5 points: x y z each", Form::number},
    Layout{"point-triangle-distance", "the point, corners of the triangle: x y z each", Form::number},
    Layout{"segment-segment-distance", "ends of either segment: x y z each", Form::number},
    Layout{"convex-convex", "8 points of one set, 8 of the other: x y z each", Form::yes_no},
    Layout{"convex-distance", "4 points of one set, 4 of the other: x y z each", Form::number},
};

std::string_view form_in_words(Form form) {
  switch (form) {
    case Form::sign:
      return "the sign: + 0 -";
    case Form::yes_no:
      return "yes or no; touching is yes";
    case Form::number:
      return "the double nearest to the exact number";
    case Form::corners:
      break;
  }
  return "the numbers of the points that are corners, from 0; of equal points the first";
}

std::string answer_text(Form form, double answer) {
  switch (form) {
    case Form::sign:
      return {answer < 0 ? '-' : answer > 0 ? '+' : '0'};
    case Form::yes_no:
      return answer != 0 ? "yes" : "no";
    case Form::number:
      return fmt::format("{:a}", answer);
    case Form::corners:
      break;
  }
  std::string corners;
  const auto set = static_cast<std::uint32_t>(answer);
  for (std::uint32_t i = 0; i < 32; ++i) {
    if ((set >> i & 1U) != 0) corners += fmt::format("{}{}", corners.empty() ? "" : " ", i);
  }
  return corners;
}

bool wrong(Form form, double said, double truth) {
  if (form != Form::number) return said != truth;
  return !std::isfinite(said) || trial::doubles_apart(said, truth) > lost_doubles;
}

/// Tasks of two shapes that are no kinds of plumb/query/kinds/kinds.hpp, or kinds of any number of points.
struct ShapesOfTask {
  std::string_view task;
  degenerate::ShapeKind a, b;
};
constexpr std::array shapes_of_tasks{
    ShapesOfTask{"segment-triangle", degenerate::ShapeKind::segment, degenerate::ShapeKind::triangle},
    ShapesOfTask{"point-triangle-distance", degenerate::ShapeKind::point, degenerate::ShapeKind::triangle},
    ShapesOfTask{"segment-segment-distance", degenerate::ShapeKind::segment, degenerate::ShapeKind::segment},
    ShapesOfTask{"convex-distance", degenerate::ShapeKind::tetrahedron, degenerate::ShapeKind::tetrahedron},
};

std::vector<degenerate::Generator> generators_of(std::string_view task) {
  const auto shapes = std::ranges::find(shapes_of_tasks, task, &ShapesOfTask::task);
  if (shapes != shapes_of_tasks.end())
    return degenerate::position_generators(shapes->a, shapes->b, 3, degenerate::join_plainly);
  for (const degenerate::Kind& kind : degenerate::kinds()) {
    if (kind.name == task && std::ranges::none_of(kind.arguments, &degenerate::Argument::any_number))
      return kind.generators;
  }
  return {};
}

/// The task's classes, and the generators of its like among the kinds.
std::vector<InputClass> classes_of(const Task& task) {
  std::vector<InputClass> classes = task.classes;
  for (const degenerate::Generator& g : generators_of(task.name)) {
    if (std::ranges::find(classes, g.name, &InputClass::name) != classes.end()) continue;
    classes.push_back({g.name, g.about, [make = g.make](std::span<double> question, Entropy& entropy) {
                         degenerate::Numbers numbers;
                         make(numbers, entropy);
                         std::ranges::copy(numbers, question.begin());
                       }});
  }
  return classes;
}

/// Cases of one class, with the true answers and who is wrong on which.
class ClassCases {
 public:
  ClassCases(const Task& task, const InputClass& input, Form form, std::uint64_t seed)
      : task_(task), form_(form), looked_at_(most_looked_at / task.fewer), numbers_(looked_at_ * task.numbers) {
    for (std::uint64_t i = 0; i < looked_at_; ++i) {
      Entropy entropy(seed, i);
      const auto question = std::span(numbers_).subspan(i * task.numbers, task.numbers);
      input.fill(question, entropy);
      truths_.push_back(task.judge(question));
    }
    const trial::Scene scene = trial::scene_of(numbers_);
    for (std::size_t m = 0; m < marked_methods.size(); ++m) {
      const auto method = std::ranges::find(task.methods, marked_methods[m], &trial::Method::name);
      const auto round = method->prepare(numbers_, scene);
      round->answer();
      for (std::size_t i = 0; i < looked_at_; ++i) wrong_[m].push_back(wrong(form, round->given(i), truths_[i]));
    }
  }

  [[nodiscard]] std::set<std::size_t> chosen() const {
    std::set<std::size_t> cases;
    for (std::size_t i = 0; i < first_cases; ++i) cases.insert(i);
    if (form_ == Form::sign || form_ == Form::yes_no) {
      for (const double answer : {-1.0, 0.0, 1.0})
        add_first(cases, of_answer, [&](std::size_t i) { return truths_[i] == answer; });
    }
    for (const std::vector<bool>& w : wrong_) add_first(cases, of_method, [&](std::size_t i) { return w[i]; });
    return cases;
  }

  [[nodiscard]] bool wrong_by(std::size_t method, std::size_t i) const { return wrong_[method][i]; }

  [[nodiscard]] std::string line(std::size_t i, std::string_view input) const {
    std::string text = task_.name;
    for (const double x : std::span(numbers_).subspan(i * task_.numbers, task_.numbers))
      text += fmt::format(" {:a}", x);
    text += fmt::format(" = {} # {}", answer_text(form_, truths_[i]), input);
    bool any = false;
    for (std::size_t m = 0; m < marked_methods.size(); ++m) {
      if (!wrong_[m][i]) continue;
      text += fmt::format("{}{}", any ? " " : "; wrong: ", marked_methods[m]);
      any = true;
    }
    return text + '\n';
  }

 private:
  template <class Wanted>
  void add_first(std::set<std::size_t>& cases, std::size_t count, Wanted wanted) const {
    for (std::size_t i = 0, found = 0; i < looked_at_ && found < count; ++i) {
      if (!wanted(i)) continue;
      cases.insert(i);
      ++found;
    }
  }

  const Task& task_;
  const Form form_;
  const std::uint64_t looked_at_;
  std::vector<double> numbers_, truths_;
  std::array<std::vector<bool>, marked_methods.size()> wrong_;
};

std::string file_of(const Task& task, const Layout& layout, std::uint64_t seed) {
  std::string lines;
  std::size_t count = 0;
  std::array<std::size_t, marked_methods.size()> caught{};
  for (const InputClass& input : classes_of(task)) {
    lines += fmt::format("#\n# {}: {}\n", input.name, input.about);
    const ClassCases cases(task, input, layout.form, seed);
    for (const std::size_t i : cases.chosen()) {
      lines += cases.line(i, input.name);
      ++count;
      for (std::size_t m = 0; m < caught.size(); ++m) caught[m] += static_cast<std::size_t>(cases.wrong_by(m, i));
    }
  }
  const std::string_view meaning = meaning_of(task.name);
  std::string head =
      fmt::format("# {}: {}\n# Numbers: {}\n# Answer: {}{}{}\n# {} cases; wrong on", task.name, task.question,
                  layout.numbers, form_in_words(layout.form), meaning.empty() ? "" : "; ", meaning, count);
  for (std::size_t m = 0; m < caught.size(); ++m)
    head += fmt::format("{} {} {}", m == 0 ? "" : ",", marked_methods[m], caught[m]);
  return head + fmt::format("\n# Made by: plumb-lab vectors --seed {}; how to read it: docs/vectors.md\n", seed) +
         lines;
}

std::vector<std::string> file_names() {
  std::vector<std::string> names;
  for (const Layout& layout : layouts) names.push_back(fmt::format("{}.txt", layout.task));
  for (const SizedTask& task : sized_tasks()) names.push_back(sized_name(task) + ".txt");
  return names;
}

}  // namespace

std::vector<trial::Task> vector_tasks() {
  std::vector<Task> tasks = trial::all_tasks({});
  tasks.push_back(trial::ray_mesh_task());
  return tasks;
}

std::vector<NamedText> vector_files(std::uint64_t seed, std::string_view only) {
  std::vector<NamedText> files;
  for (const Task& task : vector_tasks()) {
    if (!only.empty() && task.name != only) continue;
    const auto layout = std::ranges::find(layouts, task.name, &Layout::task);
    if (layout != layouts.end()) files.push_back({task.name + ".txt", file_of(task, *layout, seed)});
  }
  if (only.empty()) std::ranges::move(sized_files(seed), std::back_inserter(files));
  return files;
}

int run_vectors(const VectorsOptions& options) {
  require_report_folder(options.out, "vectors", file_names());  // before seconds of work, not after
  std::vector<NamedText> files = vector_files(options.seed);
  const std::size_t count = files.size();
  say(fmt::format("{} files in {}\n", count, printable(options.out)));
  write_report(options.out, "vectors", std::move(files));
  return 0;
}

}  // namespace plumb::lab
