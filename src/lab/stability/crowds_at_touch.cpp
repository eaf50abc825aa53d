// What comes of rounding where many things are asked at once: boxes that touch or miss by an ulp, points nearly as far, and
// walks along corners of cells.  The tasks of `plumb-lab chart`, counted thing by thing.
#include <algorithm>

#include "lab/stability/experiment.hpp"
#include "lab/trial/measure.hpp"

namespace plumb::lab::stability {
namespace {

/// Names of the failures; where they are empty, they are not counted.
struct CrowdCounts {
  std::string questions;                   // answered wrongly
  std::string otherwise;                   // answered otherwise under a symmetry
  std::string named = {}, not_named = {};  // things, of those that are to be named
  std::string far = {};                    // questions
};

/// How many things are to be named in all: by the last method of the task, one of ours.
std::uint64_t things_to_name(const trial::Task& task, const trial::InputClass& input, const trial::Settings& settings) {
  std::vector<double> questions(settings.cases / task.fewer * task.numbers);
  for (std::size_t i = 0; i * task.numbers < questions.size(); ++i) {
    Entropy entropy(settings.seed, i);
    input.fill(std::span(questions).subspan(i * task.numbers, task.numbers), entropy);
  }
  const auto round = task.methods.back().prepare(questions, {});
  round->answer();
  std::uint64_t things = 0;
  for (std::size_t i = 0; i * task.numbers < questions.size(); ++i) things += round->given_pairs(i).size();
  return things;
}

Findings counted(const trial::Task& task, const trial::InputClass& input, const trial::Settings& settings,
                 const CrowdCounts& names) {
  const trial::Trial trial = trial::measure(task, input, settings, [] {});
  const std::uint64_t things = names.named.empty() ? 0 : things_to_name(task, input, settings);
  Findings findings;
  for (std::size_t i = 0; i < trial.scores.size(); ++i) {
    const trial::Score& score = trial.scores[i];
    MethodOutcome outcome{score.method, {}, task.methods[i].about.starts_with("ours")};
    outcome.counts.push_back({names.questions, score.wrong, score.asked});
    outcome.counts.push_back({names.otherwise, score.inconsistent, score.asked});
    if (!names.named.empty()) {
      const std::uint64_t wrongly = score.tallied.at(0), missed = score.tallied.at(1);
      outcome.counts.push_back({names.named, wrongly, things - missed + wrongly});
      outcome.counts.push_back({names.not_named, missed, things});
    }
    if (!names.far.empty()) outcome.counts.push_back({names.far, score.tallied.at(0), score.asked});
    findings.outcomes.push_back(std::move(outcome));
  }
  return findings;
}

/// The task's classes of these names, of each so many questions, an eighth when quick.
Experiment of_task(std::string name, std::string source, trial::Task (*make)(), std::vector<std::string> classes,
                   std::uint64_t questions, const CrowdCounts& names) {
  return {std::move(name), make().question, std::move(source), [=](const Settings& settings) {
            std::vector<Scene> scenes;
            const trial::Task task = make();
            const trial::Settings of_trial{settings.seed, (settings.quick ? questions / 8 : questions) * task.fewer};
            for (const trial::InputClass& input : task.classes) {
              if (std::ranges::find(classes, input.name) == classes.end()) continue;
              scenes.push_back({input.name, input.about, [=] { return counted(task, input, of_trial, names); }});
            }
            return scenes;
          }};
}

}  // namespace

Experiment touch_experiment() {
  return of_task("boxes-at-touch", "RTCD 2.4.1, 7.5", trial::box_pairs_task,
                 {"uniform", "touching", "off_by_ulps", "degenerate", "far_away"}, 32,
                 {"sets of boxes with a wrong pair", "sets answered otherwise with the axes in another order",
                  "pairs named that do not overlap", "pairs that overlap and were lost"});
}

Experiment neighbor_experiment() {
  return of_task("near-equidistant", "RTCD 7.3.7", trial::nearest_point_task,
                 {"uniform", "near_ties", "ties", "degenerate", "far_away"}, 400,
                 {.questions = "places for which a point was named that is not the nearest",
                  .otherwise = "places answered otherwise with the axes in another order",
                  .far = "of these, points farther by more than 1e-4 of the distance"});
}

Experiment walk_experiment() {
  return of_task("walks-along-corners", "RTCD 7.4.2", trial::grid_walk_task,
                 {"uniform", "corners", "lattice", "off_by_ulps", "touched", "far_away"}, 400,
                 {"segments with a wrong cell", "segments answered otherwise from the other end",
                  "cells named that are not visited", "cells that are visited and were left out"});
}

}  // namespace plumb::lab::stability
