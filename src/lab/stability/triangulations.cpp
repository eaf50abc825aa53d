// Polygons cut into triangles, ear by ear and by the library: who loses a vertex, who covers too much.  Judged in GMP's
// rationals.
#include "lab/stability/float_ways.hpp"
#include "lab/trial/cutting_judge.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"

namespace plumb::lab::stability {
namespace {

using trial::cut_corners;
using trial::CutPolygon;
using trial::CuttingJudge;
using PolygonAnswer = std::optional<trial::EarTriangles>;
using PolygonWay = Way<2 * cut_corners, PolygonAnswer>;

struct Ears {
  template <class T>
  PolygonAnswer operator()(const std::array<T, 2 * cut_corners>& q, T epsilon) const {
    std::vector<trial::Place<T>> points;
    for (std::size_t i = 0; i < q.size(); i += 2) points.push_back({q[i], q[i + 1]});
    return trial::EarClipping<T>(points, epsilon).run();
  }
};

PolygonAnswer ours(const CutPolygon& q) {
  Polygon2 polygon;
  for (std::size_t i = 0; i < q.size(); i += 2) polygon.vertices.push_back({q[i], q[i + 1]});
  return triangulate(polygon);
}

Findings triangulated(const trial::PolygonFamily& family, const Settings& settings) {
  std::vector<std::pair<CutPolygon, CuttingJudge>> cases;
  for (std::uint64_t i = 0, n = settings.quick ? 60 : 2000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    CutPolygon q{};
    family.fill(q, entropy);
    cases.emplace_back(q, CuttingJudge(q));
  }
  auto ways = float_ways<2 * cut_corners, PolygonAnswer>(Ears{});
  ways.push_back(exact_way<2 * cut_corners, PolygonAnswer>(ours));
  return {outcomes_of(ways,
                      [&](const PolygonWay& way) {
                        std::vector<Count> counts{{"polygons that lost a vertex"},
                                                  {"polygons covered by another area than theirs"},
                                                  {"polygons with a triangle of no area, or turned over"},
                                                  {"polygons whose triangles overlap"},
                                                  {"polygons left without triangles: no ear was found"}};
                        for (const auto& [question, judge] : cases) {
                          const PolygonAnswer told = way.ask(question);
                          ++counts[4].of;
                          if (!told) ++counts[4].failures;
                          if (!told) continue;
                          const std::array failed{judge.lost(*told), judge.other_area(*told), judge.flat(*told),
                                                  judge.overlap(*told)};
                          for (std::size_t k = 0; k < failed.size(); ++k) {
                            ++counts[k].of;
                            counts[k].failures += failed[k];
                          }
                        }
                        return counts;
                      }),
          {}};
}

}  // namespace

Experiment triangulation_experiment() {
  return {"triangulation", "do triangles cover a polygon, all of its vertices kept?", "RTCD 12.5.1",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            for (const trial::PolygonFamily& family : trial::polygon_families())
              scenes.push_back({family.name, family.about, [=] { return triangulated(family, settings); }});
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
