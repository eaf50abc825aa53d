// GJK in floating point: what its search says of hulls that touch, that miss each other by ulps, that are flat.
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/judged.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/trial/convex_tests.hpp"
#include "plumb/query/gjk/gjk.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t hull_points = 8, hull_numbers = 6 * hull_points;
using HullsCase = Judged<hull_numbers>;

enum class SearchEnd : std::uint8_t { apart, meet, stuck };

struct FloatSearch {
  template <class T>
  SearchEnd operator()(const std::array<T, hull_numbers>& q, T epsilon) const {
    const auto found = trial::ConvexSearch<hull_points>{}(q, epsilon);
    return found.stuck ? SearchEnd::stuck : found.meet ? SearchEnd::meet : SearchEnd::apart;
  }
};

SearchEnd ours(const std::array<double, hull_numbers>& q) {
  std::array<std::array<Point3, hull_points>, 2> hulls{};
  for (std::size_t i = 0; i < 2 * hull_points; ++i) hulls[i / hull_points][i % hull_points] = point_at(&q[3 * i]);
  return gjk_intersects(VertexHull3{hulls[0]}, VertexHull3{hulls[1]}) ? SearchEnd::meet : SearchEnd::apart;
}

/// Integer hulls, each with four points in a plane x = constant, moved until these planes are one, and then by some ulps.
void fill_facing(std::array<double, hull_numbers>& q, Entropy& entropy) {
  for (double& x : q) x = static_cast<double>(entropy.within(4));
  constexpr std::size_t half = hull_numbers / 2, facing_points = 4;
  for (std::size_t i = 0; i < facing_points; ++i) q[3 * i] = 4, q[half + 3 * i] = -4;
  const double by = 8 + static_cast<double>(entropy.within(4)) * 0x1p-50;
  for (std::size_t i = half; i < hull_numbers; i += 3) q[i] += by;
}

Findings tried(const std::vector<HullsCase>& cases) {
  auto ways = float_ways<hull_numbers, SearchEnd>(FloatSearch{});
  ways.push_back(exact_way<hull_numbers, SearchEnd>(ours));
  return {outcomes_of(ways,
                      [&](const Way<hull_numbers, SearchEnd>& way) {
                        std::vector<Count> counts{{"hulls that meet and are told apart"},
                                                  {"hulls that are apart and are told to meet"},
                                                  {"searches that got stuck: a step brought them no nearer"}};
                        for (const HullsCase& c : cases) {
                          const SearchEnd end = way.ask(c.question);
                          const bool meet = c.truth == 1;
                          Count& count = counts[meet ? 0 : 1];
                          ++count.of, ++counts[2].of;
                          if (end == SearchEnd::stuck) ++counts[2].failures;
                          if (end == (meet ? SearchEnd::apart : SearchEnd::meet)) ++count.failures;
                        }
                        return counts;
                      }),
          {}};
}

}  // namespace

Experiment convex_experiment() {
  return {"convex-pairs", "do two convex hulls meet, by GJK?", "RTCD 9.5", [](const Settings& settings) {
            std::vector<Scene> scenes;
            const std::size_t count = settings.quick ? 60 : 1'000;
            const auto add = [&](const std::string& name, const std::string& about, auto fill) {
              scenes.push_back({name, about, [=, seed = settings.seed] {
                                  return tried(judged<hull_numbers>(trial::convex_meeting_task(), count, seed, fill));
                                }});
            };
            const trial::Task task = trial::convex_meeting_task();
            add("uniform", "eight points anywhere against eight, half of them moved apart", filled(task, "uniform"));
            add("touching", "small integers: many touch", filled(task, "touching"));
            add("facing", "integers, a flat side against a flat side, and up to four ulps on or back", fill_facing);
            add("flat", "sixteen points near one plane, exactly in it or off by ulps", filled(task, "off_by_ulps"));
            add("repeated", "points of which several are equal", filled(task, "repeated"));
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
