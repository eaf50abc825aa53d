#include "lab/vectors/sized_cases.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "degenerate/fields.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/query/kinds/kinds.hpp"

namespace plumb::lab {
namespace {

using degenerate::Kind;
using trial::RationalVec;

constexpr std::uint64_t sized_looked_at = 12, sized_first = 2;

std::vector<std::span<const double>> arguments_of(const Kind& kind, std::span<const double> numbers) {
  std::vector<std::span<const double>> all;
  for (const degenerate::Given& g : degenerate::given(kind, numbers)) all.push_back(g.numbers);
  return all;
}

std::vector<RationalVec> points_of(std::span<const double> coordinates) {
  std::vector<RationalVec> points;
  for (std::size_t i = 0; i < coordinates.size() / 3; ++i) points.push_back(trial::rational_vec(coordinates, i));
  return points;
}

std::vector<std::array<RationalVec, 3>> faces_of(std::span<const double> points, std::span<const double> indices) {
  std::vector<std::array<RationalVec, 3>> faces(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i)
    faces[i / 3][i % 3] = trial::rational_vec(points, static_cast<std::size_t>(indices[i]));
  return faces;
}

std::string yes_or_no(bool yes) { return yes ? "yes" : "no"; }

std::string judge_polygon(const Kind& kind, std::span<const double> numbers) {
  const auto given = arguments_of(kind, numbers);
  std::vector<double> q(given[0].begin(), given[0].end());
  q.insert(q.end(), given[1].begin(), given[1].end());
  return yes_or_no(trial::in_polygon(q));
}

std::string judge_ray_mesh(const Kind& kind, std::span<const double> numbers) {
  const auto given = arguments_of(kind, numbers);
  const trial::Generated ray{{trial::rational_vec(given[0], 0)}, {trial::rational_vec(given[0], 1)}};
  bool any = false;
  for (const auto& [a, b, c] : faces_of(given[1], given[2])) any = any || trial::meet(ray, {{a, b, c}, {}});
  return yes_or_no(any);
}

std::string judge_polyhedron(const Kind& kind, std::span<const double> numbers) {
  const auto given = arguments_of(kind, numbers);
  return yes_or_no(trial::in_solid(trial::rational_vec(given[0], 0), faces_of(given[1], given[2])));
}

std::string judge_distance(const Kind& kind, std::span<const double> numbers) {
  const auto given = arguments_of(kind, numbers);
  return fmt::format("{:a}",
                     trial::nearest_root(trial::square_between_hulls(points_of(given[0]), points_of(given[1]))));
}

std::string judge_hull(const Kind& kind, std::span<const double> numbers) {
  const std::uint32_t corners = trial::corners_of_hull(points_of(arguments_of(kind, numbers)[0]));
  std::string text;
  for (std::uint32_t i = 0; i < 32; ++i) {
    if ((corners >> i & 1U) != 0) text += fmt::format("{}{}", text.empty() ? "" : " ", i);
  }
  return text;
}

constexpr std::string_view touching_is_yes = "yes or no; touching is yes";
constexpr std::array tasks{
    SizedTask{"point-in-polygon", "is a point in a closed polygon?",
              "the point, how many corners the polygon has, the corners in turn: x y each", touching_is_yes,
              judge_polygon},
    SizedTask{"ray-mesh", "does a ray hit any of some triangles?",
              "origin and direction of the ray, how many vertices, the vertices: x y z each, how many triangles, three "
              "numbers of vertices each, from 0",
              touching_is_yes, judge_ray_mesh},
    SizedTask{"point-in-polyhedron", "is a point in the solid that a closed mesh bounds?",
              "the point, how many vertices, the vertices: x y z each, how many triangles, three numbers of vertices "
              "each, from 0",
              touching_is_yes, judge_polyhedron},
    SizedTask{"convex-distance", "how far apart are the hulls of two sets of points?",
              "how many points one set has, the points: x y z each, how many the other, its points",
              "the double nearest to the exact number", judge_distance},
    SizedTask{"hull", "which of some points are corners of their hull?", "how many points, the points: x y z each",
              "the numbers of the points that are corners, from 0; of equal points the first", judge_hull},
};

/// The first cases of a generator, and the first of each answer.
std::string lines_of(const SizedTask& task, const Kind& kind, const degenerate::Generator& generator,
                     std::uint64_t seed, std::size_t& count) {
  std::string lines = fmt::format("#\n# {}: {}\n", generator.name, generator.about);
  std::set<std::string> answers;
  for (std::uint64_t i = 0; i < sized_looked_at; ++i) {
    Entropy entropy(seed, i);
    degenerate::Numbers numbers;
    generator.make(numbers, entropy);
    const std::string answer = task.judge(kind, numbers);
    const bool is_decision = answer == "yes" || answer == "no";
    if (!(is_decision && answers.insert(answer).second) && i >= sized_first) continue;
    lines += sized_name(task);
    for (const double x : numbers) lines += fmt::format(" {:a}", x);
    lines += fmt::format(" = {} # {}\n", answer, generator.name);
    ++count;
  }
  return lines;
}

}  // namespace

std::span<const SizedTask> sized_tasks() { return tasks; }

std::string sized_name(const SizedTask& task) { return fmt::format("{}-of-any-size", task.kind); }

std::vector<NamedText> sized_files(std::uint64_t seed) {
  std::vector<NamedText> files;
  for (const SizedTask& task : tasks) {
    const Kind& kind = degenerate::kind_named(task.kind);
    std::string lines;
    std::size_t count = 0;
    for (const degenerate::Generator& g : kind.generators) lines += lines_of(task, kind, g, seed, count);
    files.push_back(
        {sized_name(task) + ".txt",
         fmt::format(
             "# {}: {}\n# Numbers: {}\n# Answer: {}\n# {} cases\n# Made by: plumb-lab vectors --seed {}; how to "
             "read it: docs/vectors.md\n",
             sized_name(task), task.question, task.numbers, task.answer, count, seed) +
             lines});
  }
  return files;
}

}  // namespace plumb::lab
