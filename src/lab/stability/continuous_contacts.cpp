// Vertices against triangles and edges against edges, in motion: contacts missed and contacts invented.
#include <cmath>

#include "lab/stability/ccd_queries.hpp"
#include "lab/stability/float_ways.hpp"
#include "lab/stability/judged.hpp"
#include "lab/trial/motion_tests.hpp"

namespace plumb::lab::stability {
namespace {

using Numbers = std::array<double, trial::motion_numbers>;
using MotionWay = Way<trial::motion_numbers, double>;

using MotionCase = Judged<trial::motion_numbers>;

lab::ccd::Query query_of(bool vertex_face, const Numbers& q) {
  lab::ccd::Query query;
  query.vertex_face = vertex_face;
  for (std::size_t i = 0; i < 4; ++i) {
    query.at_0[i] = {q[3 * i], q[3 * i + 1], q[3 * i + 2]};
    query.at_1[i] = {q[12 + 3 * i], q[13 + 3 * i], q[14 + 3 * i]};
  }
  return query;
}
Numbers numbers_of(const lab::ccd::Query& query) {
  Numbers q{};
  double* to = q.data();
  for (const auto& points : {query.at_0, query.at_1}) {
    for (const Point3& p : points) *to++ = p.x, *to++ = p.y, *to++ = p.z;
  }
  return q;
}

/// As cloth solvers choose it.
constexpr double coarse_epsilon = 1e-6;

template <bool VertexFace>
std::vector<MotionWay> motion_ways() {
  constexpr std::size_t n = trial::motion_numbers;
  const trial::CubicContact<VertexFace> cubic;
  const trial::ConservativeAdvancement<VertexFace> advancement;
  auto ways = float_ways<n, double>(cubic);
  ways.push_back({"coarse", asked_in<double, n, double>(cubic, coarse_epsilon)});
  ways.push_back({"advancement", asked_in<double, n, double>(advancement, trial::customary_epsilon, true)});
  ways.push_back({"coarse-advancement", asked_in<double, n, double>(advancement, coarse_epsilon, true)});
  ways.push_back({"exact", [](const Numbers& q) { return intersects(query_of(VertexFace, q)) ? 1.0 : 0.0; }, true});
  return ways;
}

template <bool VertexFace>
Findings tried(const std::vector<MotionCase>& cases) {
  return {outcomes_of(motion_ways<VertexFace>(),
                      [&](const MotionWay& way) {
                        Count missed{"contacts that were missed"}, invented{"contacts that were invented"};
                        Count untold{"motions of which nothing was told"};
                        for (const MotionCase& c : cases) {
                          const double told = way.ask(c.question);
                          ++untold.of;
                          ++(c.truth == 1 ? missed : invented).of;
                          if (std::isnan(told)) ++untold.failures;
                          if (c.truth == 1 && told == 0) ++missed.failures;
                          if (c.truth == 0 && told == 1) ++invented.failures;
                        }
                        return std::vector{missed, invented, untold};
                      }),
          {}};
}

std::vector<MotionCase> recorded(const std::vector<lab::ccd::Query>& queries, bool vertex_face) {
  std::vector<MotionCase> cases;
  for (const lab::ccd::Query& q : queries) {
    if (q.vertex_face == vertex_face) cases.push_back({numbers_of(q), q.meets ? 1.0 : 0.0});
  }
  return cases;
}

template <bool VertexFace>
void add_scenes(std::vector<Scene>& scenes, const Settings& settings, const std::vector<lab::ccd::Query>& queries) {
  const std::string kind = VertexFace ? "vertex-face" : "edge-edge";
  const auto task = [] { return VertexFace ? trial::vertex_face_motion_task() : trial::edge_edge_motion_task(); };
  const auto add = [&](const std::string& name, const std::string& about, std::string_view input) {
    scenes.push_back({kind + "-" + name, about, [=] {
                        return tried<VertexFace>(judged<trial::motion_numbers>(task(), settings.quick ? 150 : 4'000,
                                                                               settings.seed, filled(task(), input)));
                      }});
  };
  add("meeting", "planted to touch at some time, on coordinates of few bits", "meeting");
  add("double-root", "four points in one plane at half the time, which they do not cross", "double_root");
  add("in-plane", "small integers, in one plane the whole time", "in_plane");
  add("at-rest", "small integers, of which one point or two do not move", "at_rest");
  if (settings.ccd) {
    scenes.push_back({kind + "-recorded", "the queries of " + *settings.ccd + " with their known answers",
                      [cases = recorded(queries, VertexFace)] { return tried<VertexFace>(cases); }});
  }
}

}  // namespace

Experiment motion_experiment() {
  return {"continuous-contacts", "do a moving vertex and triangle, or two moving edges, meet?", "RTCD 5.5",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            std::vector<lab::ccd::Query> queries;
            if (settings.ccd) queries = lab::ccd::all_queries(*settings.ccd);
            if (settings.ccd && queries.empty())
              throw Error(*settings.ccd + ": no queries, files .csv, in this folder");
            add_scenes<true>(scenes, settings, queries);
            add_scenes<false>(scenes, settings, queries);
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
