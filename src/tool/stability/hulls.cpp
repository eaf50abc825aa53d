// Hulls in the plane by four textbook algorithms: of degenerate clouds, of families of hard points, of rounded grids.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"
#include "tool/stability/experiment.hpp"
#include "tool/stability/hull_judge.hpp"
#include "tool/stability/hull_picture.hpp"
#include "tool/stability/hull_ways.hpp"

namespace plumb::tool::stability {
namespace {

struct Sample {
  std::string name;
  std::vector<Point2> points;
};

struct Group {
  std::string name, about;
  std::vector<Sample> (*make)(std::size_t count, std::size_t rounds, std::uint64_t start);
};

std::vector<Sample> degenerate_clouds(std::size_t count, std::size_t rounds, std::uint64_t start) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const CloudInfo& c : clouds) {
      Entropy entropy(start, i);
      samples.push_back({std::string(c.name), cloud2(c.cloud, count, entropy)});
    }
  }
  return samples;
}

std::vector<Sample> family_points(std::size_t count, std::size_t rounds, std::uint64_t start) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const FamilyInfo& f : families) {
      Entropy entropy(start, i);
      samples.push_back({std::string(f.name), points2(f.family, Degeneracy::collinear, count, entropy)});
    }
  }
  return samples;
}

/// The integer grid after a step that rounds: written in decimals, turned, moved far away.
std::vector<Sample> rounded_grids(std::size_t count, std::size_t rounds, std::uint64_t start) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(count)));
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    Entropy entropy(start, i);
    const double angle = 2 * std::numbers::pi * static_cast<double>(entropy.below(1000)) / 1000;
    const double c = std::cos(angle), s = std::sin(angle), far = static_cast<double>(entropy.below(1'000'000)) + 0.1;
    Sample decimal{"tenths", {}}, turned{"turned", {}}, moved{"tenths moved away", {}};
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        decimal.points.push_back({x * 0.1, y * 0.1});
        turned.points.push_back({c * x - s * y, s * x + c * y});
        moved.points.push_back({x * 0.1 + far, y * 0.1 + far});
      }
    }
    for (Sample* sample : {&decimal, &turned, &moved}) samples.push_back(std::move(*sample));
  }
  return samples;
}

const std::vector<Group>& groups() {
  static const std::vector<Group> all{
      {"clouds", "clouds with many points on lines, circles or one place", degenerate_clouds},
      {"families", "points of every family of hard inputs, nearly collinear where it can be", family_points},
      {"rounded grids", "square grids written in tenths, turned, and moved away", rounded_grids}};
  return all;
}

/// The failure that is easiest to see: by double rather than with an epsilon, with an area, far off.
struct Worst {
  std::tuple<bool, bool, double> seen{false, false, 0};
  std::size_t sample = 0;
  std::string method;
  std::vector<std::uint32_t> corners;
};

Findings run_way(const HullWay& way, const Group& group, const std::vector<Sample>& samples) {
  Findings findings;
  for (const HullMethod& m : hull_methods()) {
    findings.outcomes.push_back({m.name,
                                 {{"hulls that are not convex"},
                                  {"hulls that leave points outside"},
                                  {"hulls that lost an extreme point"},
                                  {"hulls with a corner that is none"},
                                  {"runs that did not end"}},
                                 m.exact});
  }
  Worst worst;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const HullJudge judge(samples[i].points);
    for (std::size_t m = 0; m < hull_methods().size(); ++m) {
      std::vector<Count>& counts = findings.outcomes[m].counts;
      const Corners corners = way.run(*hull_methods()[m].signs(samples[i].points));
      ++counts[4].of;
      counts[4].failures += !corners;
      if (!corners) continue;
      const HullFlaws flaws = judge.flaws(*corners);
      for (std::size_t k = 0; k < 4; ++k) ++counts[k].of;
      counts[0].failures += flaws.not_convex;
      counts[1].failures += flaws.leaves_out;
      counts[2].failures += flaws.lost;
      counts[3].failures += flaws.no_corner;
      const std::string& method = hull_methods()[m].name;
      const std::tuple seen{corners->size() > 2, method == "double", flaws.worst_outside};
      const bool shown = method == "double" || method == "absolute";
      if (shown && flaws.worst_outside > 0 && seen > worst.seen) worst = {seen, i, method, *corners};
    }
  }
  if (worst.corners.empty()) return findings;
  const HullJudge judge(samples[worst.sample].points);
  const std::string title = fmt::format("{}, {}: {}", way.name, worst.method, samples[worst.sample].name);
  const std::string scale =
      fmt::format("drawn {:.3g} times as tall as it is, so that the true hull fills the picture", judge.stretch());
  std::string file = fmt::format("hull-{}-{}", way.name, group.name);
  for (char& c : file) c = c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  findings.pictures.push_back({std::move(file),
                               fmt::format("The worst that {} with float signs made of {} points ({}); {}.", way.name,
                                           samples[worst.sample].points.size(), samples[worst.sample].name, scale),
                               hull_picture({title, scale}, judge, worst.corners)});
  return findings;
}

std::vector<Scene> hull_scenes(const Settings& settings) {
  const std::size_t count = settings.quick ? 25 : 49, rounds = settings.quick ? 1 : 12;
  std::vector<Scene> scenes;
  for (const HullWay& way : hull_ways()) {
    for (const Group& group : groups()) {
      scenes.push_back({fmt::format("{}, {}", way.name, group.name), fmt::format("{}; {}", way.about, group.about),
                        [&way, &group, count, rounds, start = settings.seed] {
                          return run_way(way, group, group.make(count, rounds, start));
                        }});
    }
  }
  return scenes;
}

}  // namespace

Experiment hull_experiment() {
  return {"hulls", "is it a convex hull, and does it hold the points?",
          "RTCD 3.9.1, 3.9.2; Kettner and others, Classroom examples of robustness problems", hull_scenes};
}

}  // namespace plumb::tool::stability
