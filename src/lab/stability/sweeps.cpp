// Sweeps over segments in floating point: which pairs do they lose, which do they invent, and do they end?  Judged pair
// by pair in GMP's rationals.
#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "lab/stability/experiment.hpp"
#include "lab/stability/segment_methods.hpp"
#include "lab/stability/sweep.hpp"
#include "lab/stability/sweep_picture.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::lab::stability {
namespace {

using Segments = std::vector<Segment2>;

Segments between(const std::vector<Point2>& points) {
  Segments all;
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) all.push_back({points[i], points[i + 1]});
  return all;
}

double unit(Entropy& entropy) { return static_cast<double>(entropy.bits(53)) * 0x1p-53; }

Segments anywhere(std::size_t n, Entropy& entropy) {
  Segments all;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(entropy), y = unit(entropy), u = unit(entropy), v = unit(entropy);
    all.push_back({{x, y}, {u, v}});
  }
  return all;
}

Segments on_small_grid(std::size_t n, Entropy& entropy) {
  Segments all;
  const auto any = [&entropy] { return static_cast<double>(entropy.below(8)); };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = any(), y = any(), u = any(), v = any();
    all.push_back({{x, y}, {u, v}});
  }
  return all;
}

/// Between two places that hardly differ from one segment to the other, so that they cross at tiny angles.
Segments nearly_parallel(std::size_t n, Entropy& entropy) {
  Segments all;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = unit(entropy), y = unit(entropy), u = unit(entropy), v = unit(entropy);
    all.push_back({{0.1 + x * 0x1p-45, 0.3 + y * 0x1p-45}, {2.1 + u * 0x1p-45, 0.7 + v * 0x1p-45}});
  }
  return all;
}

/// Through the middle of a circle, as well as doubles can.
Segments bundle(std::size_t n, Entropy& entropy) {
  Segments all;
  const double x = unit(entropy), y = unit(entropy);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = std::numbers::pi * unit(entropy), c = std::cos(angle), s = std::sin(angle);
    all.push_back({{x - c, y - s}, {x + c, y + s}});
  }
  return all;
}

/// Every second one ends exactly on the one before, or in its end: three points of a line, and the next.
Segments ends_on_others(std::size_t n, Entropy& entropy) {
  Segments all;
  while (all.size() < n) {
    std::vector<Point2> p = points2(Family::degenerate_long, Degeneracy::collinear, 3, entropy);
    std::ranges::sort(p, [](const Point2& a, const Point2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const Point2 away = points2(Family::degenerate_long, Degeneracy::collinear, 1, entropy)[0];
    all.push_back({p[0], p[2]});
    all.push_back({p[1], away});
  }
  all.resize(n);
  return all;
}

Segments of_mixture(std::size_t n, Entropy& entropy) {
  return between(points2(Family::mixture, Degeneracy::collinear, 2 * n, entropy));
}

struct Kind {
  std::string name, about;
  Segments (*make)(std::size_t n, Entropy& entropy);
  bool of_one_scale = true;  // so that a picture shows something
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"anywhere", "segments between uniform points of a square", anywhere},
      {"small grid", "segments between integers below 8: many meet in ends, many overlap", on_small_grid},
      {"nearly parallel", "segments that cross at tiny angles", nearly_parallel},
      {"bundle", "segments through one point, as well as doubles can", bundle},
      {"ends on others", "every second segment ends exactly on the one before", ends_on_others, false},
      {"mixture", "segments between points of the mixture of all hard families", of_mixture, false}};
  return all;
}

Pairs true_pairs(const Segments& segments) {
  std::vector<trial::Segment<mpq_class>> exact;
  for (const Segment2& s : segments) exact.push_back(converted<mpq_class>(s));
  Pairs pairs;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t j = i + 1; j < exact.size(); ++j) {
      if (meet_by_signs(exact[i], exact[j], mpq_class(0))) pairs.insert({i, j});
    }
  }
  return pairs;
}

std::optional<Pairs> swept(std::string_view method, const Segments& segments) {
  return in_numbers_of(method, segments, [&](auto epsilon) {
    using T = decltype(epsilon);
    std::vector<trial::Segment<T>> converted_ones;
    for (const Segment2& s : segments) converted_ones.push_back(converted<T>(s));
    return Sweep<T>(std::move(converted_ones), epsilon).run();
  });
}

/// Those of `a` that are not in `b`.
Pairs without(const Pairs& a, const Pairs& b) {
  Pairs rest;
  std::ranges::set_difference(a, b, std::inserter(rest, rest.end()));
  return rest;
}

Findings run_kind(const Kind& kind, std::size_t n, std::size_t rounds, std::uint64_t start) {
  const std::vector<Count> none{{"pairs that meet and were lost"},
                                {"pairs that do not meet and were reported"},
                                {"sweeps that lost or invented a pair"},
                                {"sweeps that did not end"}};
  Findings findings;
  for (const std::string_view m : float_method_names) findings.outcomes.push_back({std::string(m), none});
  findings.outcomes.push_back({"exact", none, true});
  Segments worst;
  Pairs worst_lost;
  for (std::size_t i = 0; i < rounds; ++i) {
    Entropy entropy(start, i);
    const Segments segments = kind.make(n, entropy);
    const Pairs truth = true_pairs(segments);
    for (MethodOutcome& o : findings.outcomes) {
      const std::optional<Pairs> said = swept(o.method, segments);
      ++o.counts[3].of;
      o.counts[3].failures += !said;
      if (!said) continue;
      const Pairs lost = without(truth, *said), invented = without(*said, truth);
      o.counts[0].of += truth.size();
      o.counts[0].failures += lost.size();
      o.counts[1].of += n * (n - 1) / 2 - truth.size();
      o.counts[1].failures += invented.size();
      ++o.counts[2].of;
      o.counts[2].failures += !lost.empty() || !invented.empty();
      if (o.method == "double" && lost.size() > worst_lost.size()) {
        worst = segments;
        worst_lost = lost;
      }
    }
  }
  if (worst.empty() || !kind.of_one_scale) return findings;
  std::string file = "sweep-" + kind.name;
  std::ranges::replace(file, ' ', '-');
  const std::string about = fmt::format("{} segments, {} pairs of which meet and were lost", n, worst_lost.size());
  findings.pictures.push_back({std::move(file), fmt::format("The sweep that lost most: {}.", about),
                               sweep_picture("A sweep in double: " + kind.name, about, worst, worst_lost)});
  return findings;
}

std::vector<Scene> sweep_scenes(const Settings& settings) {
  const std::size_t n = settings.quick ? 10 : 24, rounds = settings.quick ? 4 : 40;
  std::vector<Scene> scenes;
  for (const Kind& kind : kinds()) {
    scenes.push_back({kind.name, kind.about,
                      [&kind, n, rounds, start = settings.seed] { return run_kind(kind, n, rounds, start); }});
  }
  return scenes;
}

}  // namespace

Experiment sweep_experiment() {
  return {"sweeps", "which of many segments meet?", "Bentley and Ottmann 1979; RTCD 5.1.9.1", sweep_scenes};
}

}  // namespace plumb::lab::stability
