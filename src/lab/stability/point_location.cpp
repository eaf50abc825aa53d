// Points in polygons and in solids, at corners, on edges, and beside them.
#include "lab/stability/float_ways.hpp"
#include "lab/stability/judged.hpp"
#include "lab/stability/sample_meshes.hpp"
#include "lab/trial/location_tests.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/ray/parity.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t polygon_numbers = std::tuple_size_v<trial::PolygonNumbers>;
using InPolygon = std::array<double, polygon_numbers>;
using InSolid = std::array<double, 21>;

bool in_polygon(const InPolygon& q) {
  Polygon2 polygon;
  for (std::size_t i = 2; i < q.size(); i += 2) polygon.vertices.push_back({q[i], q[i + 1]});
  return contains(polygon, Point2{q[0], q[1]});
}

/// A square, cut in two by a chain of four edges from its lower to its upper side, and a point at the cut.
struct CutSquare {
  std::array<InPolygon, 2> halves;
  std::array<bool, 2> held;  // truly, as closed sets
};

CutSquare cut_square(const trial::Task& task, Entropy& entropy) {
  std::array<Point2, 5> chain{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    chain[i] = {signed_unit_coordinate(entropy) / 2, static_cast<double>(i) / 2 - 1};
    if (i > 0 && i + 1 < chain.size()) chain[i].y += signed_unit_coordinate(entropy) / 8;
  }
  // A corner of the cut, the middle of one of its edges, or a place anywhere along one, a few doubles off or not.
  const std::size_t i = entropy.below(chain.size() - 1);
  const Point2 from = chain[i], to = chain[i + 1];
  const std::array<double, 4> along{0, 1, 0.5, unit_coordinate(entropy)};
  const double t = along[entropy.below(along.size())];
  Point2 p{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
  if (t == 1) p = to;
  if (entropy.coin()) p.x = moved_by_ulps(p.x, entropy.within(4));
  const std::array<Point2, 8> left{{{-1, 0}, {-1, -1}, chain[0], chain[1], chain[2], chain[3], chain[4], {-1, 1}}};
  const std::array<Point2, 8> right{{{1, 0}, {1, 1}, chain[4], chain[3], chain[2], chain[1], chain[0], {1, -1}}};
  CutSquare cut{};
  for (const std::size_t half : {0U, 1U}) {
    const auto& corners = half == 0 ? left : right;
    InPolygon& q = cut.halves[half];
    q[0] = p.x, q[1] = p.y;
    for (std::size_t k = 0; k < corners.size(); ++k) q[2 + 2 * k] = corners[k].x, q[3 + 2 * k] = corners[k].y;
    cut.held[half] = task.judge(q) == 1;
  }
  return cut;
}

Findings cut_squares(const Settings& settings) {
  const trial::Task task = trial::point_in_polygon_task();
  std::vector<CutSquare> cuts;
  for (std::uint64_t i = 0, n = settings.quick ? 2'000 : 100'000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    cuts.push_back(cut_square(task, entropy));
  }
  auto ways = float_ways<polygon_numbers>(trial::PointInPolygon{});
  ways.push_back(exact_way<polygon_numbers>(in_polygon));
  return {outcomes_of(ways,
                      [&](const Way<polygon_numbers>& way) {
                        Count lost{"points of the square that neither half holds"};
                        Count twice{"points beside the cut that both halves hold"};
                        Count wrong{"points beside the cut that the wrong half holds"};
                        Count edge{"points on the cut that one of its halves does not hold"};
                        for (const CutSquare& cut : cuts) {
                          const bool on_cut = cut.held[0] && cut.held[1];
                          const bool left = way.ask(cut.halves[0]), right = way.ask(cut.halves[1]);
                          ++lost.of;
                          if (on_cut) ++edge.of;
                          if (!on_cut) ++twice.of, ++wrong.of;
                          if (!left && !right) ++lost.failures;
                          if (on_cut && !(left && right)) ++edge.failures;
                          if (!on_cut && left && right) ++twice.failures;
                          if (!on_cut && left != right && left != cut.held[0]) ++wrong.failures;
                        }
                        return std::vector{lost, twice, wrong, edge};
                      }),
          {}};
}

/// Octahedra with a corner on either side of each axis; the ray from the point goes along the first.
Findings solids(const Settings& settings, std::string_view input) {
  const trial::Task task = trial::point_in_polyhedron_task();
  auto ways = float_ways<21>(trial::PointInPolyhedron{});
  ways.push_back(exact_way<21>([](const InSolid& q) {
    TriangleMesh mesh;
    for (std::size_t i = 3; i < q.size(); i += 3) mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
    for (const auto& [a, b, c] : trial::octahedron_faces) {
      mesh.triangles.push_back(
          {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    }
    return contains(mesh, Point3{q[0], q[1], q[2]});
  }));
  const auto cases = judged<21>(task, settings.quick ? 1'000 : 20'000, settings.seed, filled(task, input));
  return {outcomes_of(ways,
                      [&](const Way<21>& way) {
                        Count missed{"points of the solid, its surface included, that it does not hold"};
                        Count invented{"points outside that it holds"};
                        for (const Judged<21>& c : cases) {
                          const bool held = c.truth == 1;
                          Count& count = held ? missed : invented;
                          ++count.of;
                          if (way.ask(c.question) != held) ++count.failures;
                        }
                        return std::vector{missed, invented};
                      }),
          {}};
}

Point3 turned(const Point3& p, int times) {
  return times == 0 ? p : times == 1 ? Point3{p.y, p.z, p.x} : Point3{p.z, p.x, p.y};
}

/// Is p in the mesh?  By a ray along the first axis, its crossings counted.
using InMesh = std::function<bool(const TriangleMesh& mesh, const Point3& p)>;

/// The rays from a point along the three axes tell the same of it, or two of them do not tell the truth.
Findings three_rays(const NamedMesh& named, const Settings& settings) {
  std::array<TriangleMesh, 3> meshes{named.make(), {}, {}};
  for (const int times : {1, 2}) {
    TriangleMesh& mesh = meshes[static_cast<std::size_t>(times)];
    mesh.triangles = meshes[0].triangles;
    for (const Point3& p : meshes[0].vertices) mesh.vertices.push_back(turned(p, times));
  }
  // Level with two vertices, so that rays along the axes pass corners, edges and flats.
  const auto& vertices = meshes[0].vertices;
  std::vector<Point3> points;
  for (std::uint64_t i = 0, n = settings.quick ? 40 : 1'000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    const Point3 p = vertices[entropy.below(vertices.size())], q = vertices[entropy.below(vertices.size())];
    const Point3 level{p.x, entropy.coin() ? p.y : q.y, q.z};
    if (locate(meshes[0], level) != Location::boundary) points.push_back(level);
  }
  const auto by_parity = [](const Ask<15>& hit) -> InMesh {
    return [hit](const TriangleMesh& mesh, const Point3& p) {
      bool inside = false;
      for (const auto& [i, j, k] : mesh.triangles) {
        const Point3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
        if (hit({p.x, p.y, p.z, 1, 0, 0, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z})) inside = !inside;
      }
      return inside;
    };
  };
  Findings findings;
  const auto try_way = [&](const std::string& name, bool exact, const InMesh& in_mesh) {
    Count torn{"points of which rays along the three axes tell different things"};
    Count outside{"points inside that all three rays put outside, or the other way round"};
    for (const Point3& p : points) {
      std::array<bool, 3> says{};
      for (const int times : {0, 1, 2}) {
        const auto i = static_cast<std::size_t>(times);
        says[i] = in_mesh(meshes[i], turned(p, times));
      }
      ++torn.of, ++outside.of;
      const bool agree = says[0] == says[1] && says[1] == says[2];
      if (!agree) ++torn.failures;
      if (agree && says[0] != contains(meshes[0], p)) ++outside.failures;
    }
    findings.outcomes.push_back({name, {torn, outside}, exact});
  };
  for (const Way<15>& way : float_ways<15>(trial::RayAgainstTriangle<false>{}))
    try_way(way.name, false, by_parity(way.ask));
  try_way("exact", true, [](const TriangleMesh& mesh, const Point3& p) { return contains(mesh, p); });
  return findings;
}

}  // namespace

Experiment location_experiment() {
  return {"point-location", "is a point in a polygon or a solid, where a corner or an edge is level with it?",
          "RTCD 5.4.1, 5.4.3, 11.3.3", [](const Settings& settings) {
            std::vector<Scene> scenes{
                {"cut-square", "points on and beside a chain that cuts a square into two polygons",
                 [settings] { return cut_squares(settings); }},
                {"octahedron", "integers to 4: the ray often leaves by a corner, through an edge or along a face",
                 [settings] { return solids(settings, "touching"); }},
                {"moved-octahedron", "the same, scaled and moved, so that every coordinate rounds",
                 [settings] { return solids(settings, "off_by_ulps"); }},
            };
            for (const NamedMesh& mesh : generated_meshes(settings.quick)) {
              scenes.push_back({"in-" + mesh.name, "points level with the vertices of " + mesh.about,
                                [mesh, settings] { return three_rays(mesh, settings); }});
            }
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
