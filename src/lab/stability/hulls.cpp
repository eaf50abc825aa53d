// Hulls in the plane and in space by textbook algorithms: of degenerate clouds, of families of hard points, of rounded
// grids, of boxes of integers.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <tuple>

#include "lab/stability/experiment.hpp"
#include "lab/stability/hull_judge.hpp"
#include "lab/stability/hull_picture.hpp"
#include "lab/stability/hull_ways.hpp"
#include "lab/stability/space_hull_judge.hpp"
#include "lab/stability/space_hull_picture.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::lab::stability {
namespace {

template <std::size_t D>
using Points = std::vector<typename HullSigns<D>::Point>;

template <std::size_t D>
struct Sample {
  std::string name;
  Points<D> points;
};

template <std::size_t D>
struct Group {
  std::string name, about;
  std::vector<Sample<D>> (*make)(std::size_t count, std::size_t rounds, std::uint64_t start);
};

template <std::size_t D>
std::vector<Sample<D>> degenerate_clouds(std::size_t count, std::size_t rounds, std::uint64_t start) {
  std::vector<Sample<D>> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const CloudInfo& c : clouds) {
      Entropy entropy(start, i);
      Sample<D>& sample = samples.emplace_back(Sample<D>{std::string(c.name), {}});
      if constexpr (D == 2) {
        sample.points = cloud2(c.cloud, count, entropy);
      } else {
        sample.points = cloud3(c.cloud, count, entropy);
      }
    }
  }
  return samples;
}

std::vector<Sample<2>> family_points(std::size_t count, std::size_t rounds, std::uint64_t start) {
  std::vector<Sample<2>> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const FamilyInfo& f : families) {
      Entropy entropy(start, i);
      samples.push_back({std::string(f.name), points2(f.family, Degeneracy::collinear, count, entropy)});
    }
  }
  return samples;
}

/// The integer grid after a step that rounds: written in decimals, turned, moved far away.
template <std::size_t D>
std::vector<Sample<D>> rounded_grids(std::size_t count, std::size_t rounds, std::uint64_t start) {
  const auto side = std::lround(std::pow(count, 1.0 / D));
  std::vector<Sample<D>> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    Entropy entropy(start, i);
    const double angle = 2 * std::numbers::pi * static_cast<double>(entropy.below(1000)) / 1000;
    const double c = std::cos(angle), s = std::sin(angle), far = static_cast<double>(entropy.below(1'000'000)) + 0.1;
    Sample<D> decimal{"tenths", {}}, turned{"turned", {}}, moved{"tenths moved away", {}};
    const auto add = [&](double x, double y, double z) {
      const double u = c * x - s * y, v = s * x + c * y;
      if constexpr (D == 2) {
        decimal.points.push_back({x * 0.1, y * 0.1});
        turned.points.push_back({u, v});
        moved.points.push_back({x * 0.1 + far, y * 0.1 + far});
      } else {
        decimal.points.push_back({x * 0.1, y * 0.1, z * 0.1});
        turned.points.push_back({u, c * v - s * z, s * v + c * z});
        moved.points.push_back({x * 0.1 + far, y * 0.1 + far, z * 0.1 + far});
      }
    };
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        for (int z = 0; z < (D == 2 ? 1 : side); ++z) add(x, y, z);
      }
    }
    for (Sample<D>* sample : {&decimal, &turned, &moved}) samples.push_back(std::move(*sample));
  }
  return samples;
}

/// The corners of a box whose edges are any integers, with the middles of its edges and sides and its own, shuffled.
std::vector<Sample<3>> integer_boxes(std::size_t, std::size_t rounds, std::uint64_t start) {
  std::vector<Sample<3>> samples;
  for (std::size_t i = 0; i < rounds; ++i) {
    for (const int bits : {3, 10, 17, 24, 31}) {
      Entropy entropy(start, i);
      const auto any = [&] { return static_cast<double>(entropy.within(std::int64_t{1} << bits)); };
      std::array<Vector3, 4> v{};  // a corner, and half of each edge
      for (Vector3& x : v) x.x = any(), x.y = any(), x.z = any();
      Points<3> points;
      for (int k = 0; k < 27; ++k) {
        const double a = k % 3, b = k / 3 % 3, c = k / 9;
        points.push_back({v[0].x + a * v[1].x + b * v[2].x + c * v[3].x, v[0].y + a * v[1].y + b * v[2].y + c * v[3].y,
                          v[0].z + a * v[1].z + b * v[2].z + c * v[3].z});
        std::swap(points.back(), points[entropy.below(points.size())]);
      }
      samples.push_back({fmt::format("integers to 2^{}", bits), std::move(points)});
    }
  }
  return samples;
}

/// What is told of one hull: of each failure whether it is there, if it can be; and how well it shows in a picture.
template <std::size_t Failures>
struct Told {
  std::array<std::optional<bool>, Failures> failed;
  bool is_clear = false;  // a hull with an inside, of no more parts than a hull has
  double severity = 0;    // 0: there is nothing to be seen
};

struct InPlane {
  static constexpr std::size_t dimension = 2, quick_count = 25, count = 49;
  static constexpr std::string_view file = "hull";
  static constexpr std::array<std::string_view, 4> failures{
      "hulls that are not convex", "hulls that leave points outside", "hulls that lost an extreme point",
      "hulls with a corner that is none"};
  using Judge = HullJudge;
  using Way = HullWay;
  using Answer = std::vector<std::uint32_t>;

  static const std::vector<Way>& ways() { return hull_ways(); }
  static const std::vector<Group<2>>& groups() {
    static const std::vector<Group<2>> all{
        {"clouds", "clouds with many points on lines, circles or one place", degenerate_clouds<2>},
        {"families", "points of every family of hard inputs, nearly collinear where it can be", family_points},
        {"rounded grids", "square grids written in tenths, turned, and moved away", rounded_grids<2>}};
    return all;
  }
  static Answer of_library(const Points<2>& points) { return convex_hull(points).vertices; }
  static Told<4> told(const Judge& judge, const Answer& corners) {
    const HullFlaws f = judge.flaws(corners);
    return {{f.not_convex, f.leaves_out, f.lost, f.no_corner}, corners.size() > 2, f.worst_outside};
  }
  static std::string scale(const Judge& judge) {
    return fmt::format("drawn {:.3g} times as tall as it is, so that the true hull fills the picture", judge.stretch());
  }
  static std::string picture(const std::string& title, const std::string& subtitle, const Judge& judge,
                             const Answer& corners) {
    return hull_picture({title, subtitle}, judge, corners);
  }
};

struct InSpace {
  static constexpr std::size_t dimension = 3, quick_count = 27, count = 64;
  static constexpr std::string_view file = "space-hull";
  static constexpr std::array<std::string_view, 5> failures{
      "hulls that lost an extreme point", "hulls with a face that has points on its outer side",
      "hulls with an edge that has not two faces", "hulls with a face of which three corners are on a line",
      "solids of points in a plane, or no face where there is a solid"};
  using Judge = SpaceHullJudge;
  using Way = SpaceHullWay;
  using Answer = Faces;

  static const std::vector<Way>& ways() { return space_hull_ways(); }
  static const std::vector<Group<3>>& groups() {
    static const std::vector<Group<3>> all{
        {"clouds", "clouds with many points in planes, on spheres or one place", degenerate_clouds<3>},
        {"rounded grids", "cubic grids written in tenths, turned, and moved away", rounded_grids<3>},
        {"integer boxes", "27 points of skewed boxes of small and of large integers", integer_boxes}};
    return all;
  }
  static Answer of_library(const Points<3>& points) {
    const Hull3 hull = convex_hull(points);
    Answer faces;
    for (std::size_t f = 0; f < hull.face_count(); ++f) faces.emplace_back(hull.face(f).begin(), hull.face(f).end());
    return hull.dimension < 3 ? Answer{} : faces;
  }
  static Told<5> told(const Judge& judge, const Answer& faces) {
    const SpaceHullFlaws f = judge.flaws(faces);
    Told<5> told;
    told.failed[4] = f.wrong_dimension;
    if (judge.is_flat() || faces.empty()) return told;
    const std::array flawed{!f.lost.empty(), !f.seen.empty(), !f.torn.empty(), !f.flat.empty()};
    std::ranges::copy(flawed, told.failed.begin());
    told.is_clear = faces.size() <= 2 * judge.points().size();
    told.severity = static_cast<double>(f.lost.size() + f.seen.size() + f.torn.size());
    return told;
  }
  static std::string scale(const Judge&) { return "the true hull's box is drawn as a cube"; }
  static std::string picture(const std::string& title, const std::string& subtitle, const Judge& judge,
                             const Answer& faces) {
    return space_hull_picture(title, subtitle, judge, faces);
  }
};

/// The algorithm over each kind of numbers, and the library's own hull.
template <class Kind>
struct Asked {
  std::string name;
  bool exact;
  std::function<std::optional<typename Kind::Answer>(const Points<Kind::dimension>&)> ask;
};
template <class Kind>
std::vector<Asked<Kind>> asked(const typename Kind::Way& way) {
  std::vector<Asked<Kind>> all;
  for (const auto& m : hull_methods<Kind::dimension>())
    all.push_back({m.name, m.exact, [&](const auto& points) { return way.run(*m.signs(points)); }});
  all.push_back({"convex_hull", true, Kind::of_library});
  return all;
}

/// The failure that is easiest to see: a clear hull, by double rather than with an epsilon, far off.
template <class Kind>
struct Worst {
  std::tuple<bool, bool, double> seen{false, false, 0};
  std::size_t sample = 0;
  std::string method;
  typename Kind::Answer answer;
};

template <class Kind>
Findings run_way(const typename Kind::Way& way, const Group<Kind::dimension>& group,
                 const std::vector<Sample<Kind::dimension>>& samples) {
  const std::vector<Asked<Kind>> methods = asked<Kind>(way);
  std::vector<Count> none;
  for (const std::string_view f : Kind::failures) none.push_back({std::string(f)});
  none.push_back({"runs that did not end"});
  Findings findings;
  for (const Asked<Kind>& m : methods) findings.outcomes.push_back({m.name, none, m.exact});
  Worst<Kind> worst;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const typename Kind::Judge judge(samples[i].points);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      std::vector<Count>& counts = findings.outcomes[m].counts;
      const auto answer = methods[m].ask(samples[i].points);
      ++counts.back().of;
      counts.back().failures += !answer;
      if (!answer) continue;
      const auto told = Kind::told(judge, *answer);
      for (std::size_t k = 0; k < told.failed.size(); ++k) {
        counts[k].of += told.failed[k].has_value();
        counts[k].failures += told.failed[k].value_or(false);
      }
      const std::string& method = methods[m].name;
      const std::tuple seen{told.is_clear, method == "double", told.severity};
      const bool shown = method == "double" || method == "absolute";
      if (shown && told.severity > 0 && seen > worst.seen) worst = {seen, i, method, *answer};
    }
  }
  if (worst.answer.empty()) return findings;
  const typename Kind::Judge judge(samples[worst.sample].points);
  const std::string title = fmt::format("{}, {}: {}", way.name, worst.method, samples[worst.sample].name);
  const std::string scale = Kind::scale(judge);
  std::string file = fmt::format("{}-{}-{}", Kind::file, way.name, group.name);
  for (char& c : file) c = c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  findings.pictures.push_back({std::move(file),
                               fmt::format("The worst that {} with float signs made of {} points ({}); {}.", way.name,
                                           samples[worst.sample].points.size(), samples[worst.sample].name, scale),
                               Kind::picture(title, scale, judge, worst.answer)});
  return findings;
}

template <class Kind>
std::vector<Scene> hull_scenes(const Settings& settings) {
  const std::size_t count = settings.quick ? Kind::quick_count : Kind::count, rounds = settings.quick ? 1 : 12;
  std::vector<Scene> scenes;
  for (const auto& way : Kind::ways()) {
    for (const auto& group : Kind::groups()) {
      scenes.push_back({fmt::format("{}, {}", way.name, group.name), fmt::format("{}; {}", way.about, group.about),
                        [&way, &group, count, rounds, start = settings.seed] {
                          return run_way<Kind>(way, group, group.make(count, rounds, start));
                        }});
    }
  }
  return scenes;
}

}  // namespace

Experiment hull_experiment() {
  return {"hulls", "is it a convex hull, and does it hold the points?",
          "RTCD 3.9.1, 3.9.2; Kettner and others, Classroom examples of robustness problems", hull_scenes<InPlane>};
}

Experiment space_hull_experiment() {
  return {"space-hulls", "is it the surface of a convex solid, and does it hold the points?", "RTCD 3.9.2",
          hull_scenes<InSpace>};
}

}  // namespace plumb::lab::stability
