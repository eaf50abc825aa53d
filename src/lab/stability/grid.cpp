// The classroom grid: one point moves by ulps about a line, plane, circle or sphere that it lies on exactly.  Judged in
// rationals.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/stability/experiment.hpp"
#include "lab/stability/sign_picture.hpp"
#include "lab/trial/tasks.hpp"

namespace plumb::lab::stability {
namespace {

using trial::Symmetry;
using trial::Task;

struct GridCase {
  std::string name, shape;  // "orient2d", "the line"
  Task (*task)();
  std::vector<double> fixed;   // all points but the one that moves, which comes last
  std::vector<double> around;  // that one, in the middle of the grid, exactly on the shape
  std::string negative, zero, positive;
};

/// Of the cube from one half to 24 and a half, or of the square below it, the shape goes through the first corner.
std::vector<GridCase> grid_cases() {
  return {{"orient2d",
           "the line",
           trial::orient2d_task,
           {12, 12, 24, 24},
           {0.5, 0.5},
           "right of the line",
           "on the line",
           "left of the line"},
          {"orient2d-long",
           "the line",
           trial::orient2d_task,
           {17.300000000000001, 17.300000000000001, 24.00000000000005, 24.00000000000005},
           {0.50000000000002531, 0.50000000000002531},
           "right of the line",
           "on the line",
           "left of the line"},
          {"incircle",
           "the circle",
           trial::incircle_task,
           {24.5, 0.5, 24.5, 24.5, 0.5, 24.5},
           {0.5, 0.5},
           "outside of the circle",
           "on the circle",
           "inside of the circle"},
          {"orient3d",
           "the plane",
           trial::orient3d_task,
           {12.5, -11.5, 0.5, -7.25, 3.5, 5.25, 2.75, 7.5, -8.75},
           {0.5, 0.5, 0.5},
           "above the plane",
           "on the plane",
           "below the plane"},
          {"insphere",
           "the sphere",
           trial::insphere_task,
           {0.5, 24.5, 0.5, 24.5, 0.5, 0.5, 0.5, 0.5, 24.5, 24.5, 24.5, 24.5},
           {0.5, 0.5, 0.5},
           "outside of the sphere",
           "on the sphere",
           "inside of the sphere"}};
}

/// The steps of the grid: an ulp below one half of the doubles, and of the floats.
struct Step {
  std::string name, about;
  double size;
};
const std::vector<Step>& steps() {
  static const std::vector<Step> all{{"ulps of doubles", "2^-53", 0x1p-53}, {"ulps of floats", "2^-24", 0x1p-24}};
  return all;
}

/// All questions of a grid, row by row.
std::vector<double> questions_of(const GridCase& c, double step, std::size_t width) {
  std::vector<double> questions;
  const auto middle = static_cast<double>(width / 2);
  for (std::size_t row = 0; row < width; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      questions.insert(questions.end(), c.fixed.begin(), c.fixed.end());
      questions.push_back(c.around[0] + (static_cast<double>(column) - middle) * step);
      questions.push_back(c.around[1] + (static_cast<double>(row) - middle) * step);
      questions.insert(questions.end(), c.around.begin() + 2, c.around.end());
    }
  }
  return questions;
}

std::vector<double> answers_of(const trial::Method& method, std::span<const double> questions, std::size_t numbers,
                               const trial::Scene& scene) {
  const auto round = method.prepare(questions, scene);
  round->answer();
  std::vector<double> answers(questions.size() / numbers);
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = round->given(i);
  return answers;
}

std::vector<double> reordered(std::span<const double> questions, std::size_t numbers, const Symmetry& symmetry) {
  std::vector<double> changed(questions.size());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    changed[i] = questions[i - i % numbers + symmetry.from[i % numbers]];
  }
  return changed;
}

std::vector<Count> counted(const GridCase& c, std::span<const double> said, std::span<const double> truths,
                           const std::vector<bool>& contradicted) {
  Count opposite{fmt::format("points put on the wrong side of {}", c.shape)};
  Count missed{fmt::format("points on {} put off it", c.shape)};
  Count invented{fmt::format("points off {} put on it", c.shape)};
  Count inconsistent{"points answered otherwise when the others are named in another order"};
  for (std::size_t i = 0; i < said.size(); ++i) {
    opposite.failures += said[i] * truths[i] < 0;
    missed.failures += said[i] != 0 && truths[i] == 0;
    invented.failures += said[i] == 0 && truths[i] != 0;
    inconsistent.failures += contradicted[i];
    ++(truths[i] == 0 ? missed : invented).of;
  }
  opposite.of = invented.of;
  inconsistent.of = said.size();
  return {opposite, missed, invented, inconsistent};
}

std::string share_wrong(const std::vector<Count>& counts) {
  const std::uint64_t wrong = counts[0].failures + counts[1].failures + counts[2].failures, of = counts[3].of;
  if (wrong == 0) return fmt::format("all of {} right", of);
  return fmt::format("{} of {} wrong", wrong, of);
}

Findings run_grid(const GridCase& c, const Step& step, std::size_t width) {
  const Task task = c.task();
  const std::vector<double> questions = questions_of(c, step.size, width);
  std::vector<double> truths;
  for (std::size_t i = 0; i < questions.size(); i += task.numbers) {
    truths.push_back(task.judge(std::span(questions).subspan(i, task.numbers)));
  }
  const trial::Scene scene = trial::scene_of(questions);
  Findings findings;
  std::vector<SignPanel> panels;
  for (const char* const name : {"float32", "double", "absolute", "relative", "long-double", "exact"}) {
    const trial::Method& method = *std::ranges::find(task.methods, name, &trial::Method::name);
    const std::vector<double> said = answers_of(method, questions, task.numbers, scene);
    std::vector<bool> contradicted(said.size());
    for (const Symmetry& s : task.symmetries) {
      const std::vector<double> again = answers_of(method, reordered(questions, task.numbers, s), task.numbers, scene);
      for (std::size_t i = 0; i < said.size(); ++i) contradicted[i] = contradicted[i] || s.factor * said[i] != again[i];
    }
    findings.outcomes.push_back({method.name, counted(c, said, truths, contradicted), method.name == "exact"});
    SignPanel panel{method.name, share_wrong(findings.outcomes.back().counts), {}};
    for (const double s : said) panel.signs.push_back(s < 0 ? Sign::negative : s > 0 ? Sign::positive : Sign::zero);
    panels.push_back(std::move(panel));
  }
  const std::string title = fmt::format("{}, {}", c.name, step.name);
  const std::string about =
      fmt::format("one point on a grid of {0} by {0}, {1} apart, about a point on {2}", width, step.about, c.shape);
  const std::string file = fmt::format("grid-{}-{}", c.name, step.name == "ulps of floats" ? "float32" : "double");
  findings.pictures.push_back({file, fmt::format("What each method says of {}.", about),
                               sign_picture({title, about, c.negative, c.zero, c.positive}, panels)});
  return findings;
}

std::vector<Scene> grid_scenes(const Settings& settings) {
  const std::size_t width = settings.quick ? 32 : 256;
  std::vector<Scene> scenes;
  for (const GridCase& c : grid_cases()) {
    for (const Step& step : steps()) {
      scenes.push_back({fmt::format("{}, {}", c.name, step.name),
                        fmt::format("a point about {}, on a grid of steps of {}", c.shape, step.about),
                        [c, step, width] { return run_grid(c, step, width); }});
    }
  }
  return scenes;
}

}  // namespace

Experiment grid_experiment() {
  return {"grid", "on which side of a shape is a point that hardly leaves it?",
          "Kettner, Mehlhorn, Pion, Schirra and Yap, Classroom examples of robustness problems; RTCD 11.2",
          grid_scenes};
}

}  // namespace plumb::lab::stability
