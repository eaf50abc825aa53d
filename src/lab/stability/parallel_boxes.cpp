// The separating axes of oriented boxes whose edges are parallel, or all but parallel.
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/judged.hpp"
#include "lab/stability/share_curves.hpp"
#include "lab/trial/box_tests.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t numbers = 30;
using BoxesQuestion = std::array<double, numbers>;

Obb3 box_at(const double* x) {
  return {{x[0], x[1], x[2]}, {{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}}}, {x[12], x[13], x[14]}};
}

using BoxesCase = Judged<numbers>;

/// Boxes of one orientation, one standing beside the other: a gap between them of a 2^-8th to a 2^-44th, or an overlap.
std::vector<BoxesCase> beside_one_another(const trial::Task& task, std::size_t count, std::uint64_t seed) {
  return judged<numbers>(task, count, seed, [stacked = filled(task, "stacked")](BoxesQuestion& q, Entropy& entropy) {
    stacked(q, entropy);
    const double size = q[12 + entropy.below(3)];
    const double gap = std::ldexp(size, -static_cast<int>(8 + entropy.below(37))) * (entropy.coin() ? 1 : -1);
    // Along the line of their centers, which the class chose to be an axis.
    const double x = q[15] - q[0], y = q[16] - q[1], z = q[17] - q[2], length = std::sqrt(x * x + y * y + z * z);
    if (length > 0) q[15] += gap * (x / length), q[16] += gap * (y / length), q[17] += gap * (z / length);
  });
}

std::array<Count, 2> verdicts(const Ask<numbers>& ask, const std::vector<BoxesCase>& cases) {
  std::array<Count, 2> counts{{{"boxes that meet and are told apart"}, {"boxes that are apart and are told to meet"}}};
  for (const BoxesCase& c : cases) {
    const bool meet = c.truth == 1;
    Count& count = counts[meet ? 0 : 1];
    ++count.of;
    if (ask(c.question) != meet) ++count.failures;
  }
  return counts;
}

double share(const Count& count) {
  return count.of == 0 ? 0 : static_cast<double>(count.failures) / static_cast<double>(count.of);
}

/// Both kinds of failure over the epsilon chosen, from below a unit in the last place to more than half of a box.
template <class T>
SharePanel panel_of(std::string title, const std::vector<BoxesCase>& cases) {
  SharePanel panel{std::move(title), "epsilon", {{"false separations", {}}, {"false contacts", {}}}};
  for (int exponent = -56; exponent <= -1; exponent += 5) {
    const double epsilon = std::ldexp(1, exponent);
    const auto counts = verdicts(asked_in<T, numbers>(trial::OrientedAgainstOriented{}, epsilon), cases);
    for (const std::size_t i : {0U, 1U}) panel.curves[i].points.push_back({epsilon, share(counts[i])});
  }
  return panel;
}

Findings tried(const std::string& name, const std::string& about, const std::vector<BoxesCase>& cases) {
  auto ways = float_ways<numbers>(trial::OrientedAgainstOriented{});
  ways.push_back(
      exact_way<numbers>([](const BoxesQuestion& q) { return intersects(box_at(q.data()), box_at(&q[15])); }));
  Findings findings;
  findings.outcomes = outcomes_of(ways, [&](const Way<numbers>& way) {
    const auto counts = verdicts(way.ask, cases);
    return std::vector(counts.begin(), counts.end());
  });
  const std::array panels{panel_of<float>("float32", cases), panel_of<double>("double", cases)};
  findings.pictures.push_back({"boxes-" + name + "-epsilon",
                               "How the verdict on two boxes depends on the epsilon: " + about,
                               share_curves("Two oriented boxes: what an epsilon buys and costs",
                                            about + "; the exact test needs none and has no failure", panels)});
  return findings;
}

}  // namespace

Experiment box_experiment() {
  return {"parallel-boxes", "do two oriented boxes meet whose edges are parallel?", "RTCD 4.4.1, 4.4.2",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            const std::size_t count = settings.quick ? 300 : 5'000;
            const auto add = [&](const std::string& name, const std::string& about, auto cases) {
              scenes.push_back({name, about, [=, seed = settings.seed] {
                                  return tried(name, about, cases(trial::oriented_boxes_task(), count, seed));
                                }});
            };
            const auto of_class = [](std::string_view input) {
              return [input](const trial::Task& task, std::size_t n, std::uint64_t seed) {
                return judged<numbers>(task, n, seed, filled(task, input));
              };
            };
            add("stacked", "boxes of the same axes, one on the other, touching but for rounding", of_class("stacked"));
            add("beside", "boxes of the same axes, a small gap or a small overlap between them", beside_one_another);
            add("nearly-parallel", "integers along the coordinates, one axis off by ulps", of_class("nearly_parallel"));
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
