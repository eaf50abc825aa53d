// Solids united, intersected and subtracted, by trees of planes in floats and by the library: whose results are open, meet
// themselves or have another volume.  Volumes are judged exactly, by the common points of convex solids and by counted cells.
#include <algorithm>
#include <bitset>
#include <cmath>
#include <map>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/plane_tree.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/section/solid.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "plumb/surface/topology/faults.hpp"

namespace plumb::lab::stability {
namespace {

/// One for each operation that a question asks; none where the method gave up.
using Solids = std::vector<std::optional<TriangleMesh>>;

template <std::size_t N>
using SolidWay = Way<N, Solids>;

template <std::size_t N>
struct SolidCase {
  std::array<double, N> question;
  std::vector<Rational> truth;  // the volumes
  Rational whole;               // of what was given
};

// Tetrahedra.

constexpr std::array<std::array<std::size_t, 3>, 4> tetrahedron_faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
constexpr std::array operations{SolidOperation::unite, SolidOperation::intersect, SolidOperation::subtract};

template <class T>
SolidFace<T> face_of(std::vector<trial::Vec<T>> corners) {
  trial::Vec<T> normal = trial::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const T length = std::sqrt(trial::dot(normal, normal));
  normal = normal * T(T(1) / length);
  const T offset = trial::dot(normal, corners[0]);
  return {std::move(corners), normal, offset};
}

/// Fans of the polygons, equal vertices made one.
template <class T>
TriangleMesh mesh_of(const std::vector<SolidFace<T>>& faces) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> number;
  const auto vertex = [&](const trial::Vec<T>& v) {
    const Point3 p{static_cast<double>(v.x) + 0.0, static_cast<double>(v.y) + 0.0, static_cast<double>(v.z) + 0.0};
    const auto [at, is_new] = number.emplace(std::array{p.x, p.y, p.z}, static_cast<std::uint32_t>(number.size()));
    if (is_new) mesh.vertices.push_back(p);
    return at->second;
  };
  for (const SolidFace<T>& face : faces) {
    std::vector<std::uint32_t> ring;
    for (const trial::Vec<T>& v : face.corners) {
      if (const std::uint32_t n = vertex(v); ring.empty() || ring.back() != n) ring.push_back(n);
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    for (std::size_t k = 2; k < ring.size(); ++k) mesh.triangles.push_back({ring[0], ring[k - 1], ring[k]});
  }
  return mesh;
}

struct TetrahedraByTrees {
  template <class T>
  Solids operator()(const std::array<T, 24>& q, T epsilon) const {
    std::array<std::vector<SolidFace<T>>, 2> solids;
    for (std::size_t s = 0; s < 2; ++s) {
      for (const auto& f : tetrahedron_faces)
        solids[s].push_back(
            face_of<T>({trial::vec(q, 4 * s + f[0]), trial::vec(q, 4 * s + f[1]), trial::vec(q, 4 * s + f[2])}));
    }
    Solids made;
    for (const SolidOperation operation : operations) {
      const auto faces = PlaneTree<T>::made(operation, solids[0], solids[1], epsilon);
      made.push_back(faces ? std::optional(mesh_of(*faces)) : std::nullopt);
    }
    return made;
  }
};

Point3 corner(const std::array<double, 24>& q, std::size_t i) { return {q[3 * i], q[3 * i + 1], q[3 * i + 2]}; }
Tetrahedron3 tetrahedron(const std::array<double, 24>& q, std::size_t s) {
  return {corner(q, 4 * s), corner(q, 4 * s + 1), corner(q, 4 * s + 2), corner(q, 4 * s + 3)};
}

Solids tetrahedra_by_ours(const std::array<double, 24>& q) {
  std::array<TriangleMesh, 2> mesh;
  for (std::size_t s = 0; s < 2; ++s) {
    for (std::size_t i = 0; i < 4; ++i) mesh[s].vertices.push_back(corner(q, 4 * s + i));
    for (const auto& f : tetrahedron_faces)
      mesh[s].triangles.push_back(
          {static_cast<std::uint32_t>(f[0]), static_cast<std::uint32_t>(f[1]), static_cast<std::uint32_t>(f[2])});
  }
  return {round(unite(mesh[0], mesh[1])).mesh, round(intersect(mesh[0], mesh[1])).mesh,
          round(subtract(mesh[0], mesh[1])).mesh};
}

/// Volumes are told by inclusion and exclusion, from the points that the convex solids have in common.
SolidCase<24> tetrahedra_case(const std::array<double, 24>& q) {
  const Tetrahedron3 a = tetrahedron(q, 0), b = tetrahedron(q, 1);
  const auto volume_of = [](const SolidIntersection3& s) { return exact_volume(s); };
  const Rational first = volume_of(intersection(a, a)), second = volume_of(intersection(b, b)),
                 both = volume_of(intersection(a, b));
  return {q, {first + second - both, both, first - both}, first + second};
}

/// Those of which either has no volume, or which are inside out, are passed over.
template <class Fill>
std::vector<SolidCase<24>> tetrahedra_cases(const Settings& settings, const Fill& fill) {
  std::vector<SolidCase<24>> cases;
  for (std::uint64_t i = 0, n = settings.quick ? 10 : 500; cases.size() < n; ++i) {
    Entropy entropy(settings.seed, i);
    std::array<double, 24> q{};
    fill(q, entropy);
    const auto winds = [&](std::size_t s) {
      const Tetrahedron3 t = tetrahedron(q, s);
      return orient3d(t.a, t.b, t.c, t.d) == Sign::negative;
    };
    if (winds(0) && winds(1)) cases.push_back(tetrahedra_case(q));
  }
  return cases;
}

void scatter(std::array<double, 24>& q, Entropy& entropy) {
  for (double& x : q) x = static_cast<double>(entropy.within(1 << 20)) / 1000;
}
void put_on_lattice(std::array<double, 24>& q, Entropy& entropy) {
  for (double& x : q) x = static_cast<double>(entropy.within(2));
}
void put_on_small_lattice(std::array<double, 24>& q, Entropy& entropy) {
  for (double& x : q) x = std::ldexp(static_cast<double>(entropy.within(2)), -30);
}
void move_by_ulps(std::array<double, 24>& q, Entropy& entropy) {
  for (std::size_t i = 0; i < 12; ++i) {
    q[i] = static_cast<double>(entropy.within(9)) / 10;
    q[12 + i] = q[i];
    const std::int64_t ulps = entropy.within(1);
    if (ulps != 0) q[12 + i] = std::nextafter(q[i], ulps > 0 ? 2.0 : -2.0);
  }
}

// Chains of boxes on a lattice: united and subtracted in turn.

constexpr std::size_t boxes = 8, chain_numbers = 6 * boxes, lattice = 7;
constexpr std::array<std::array<std::size_t, 4>, 6> box_faces{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
constexpr bool subtracts(std::size_t step) { return step % 3 == 2; }

/// Corner c of box b: bits 1, 2 and 4 of c choose the greater x, y and z.
template <class T>
trial::Vec<T> box_corner(const std::array<T, chain_numbers>& q, std::size_t b, std::size_t c) {
  const std::size_t at = 6 * b;
  return {q[at + (c & 1 ? 3 : 0)], q[at + (c & 2 ? 4 : 1)], q[at + (c & 4 ? 5 : 2)]};
}

struct ChainByTrees {
  template <class T>
  Solids operator()(const std::array<T, chain_numbers>& q, T epsilon) const {
    std::vector<SolidFace<T>> chain;
    for (std::size_t b = 0; b < boxes; ++b) {
      std::vector<SolidFace<T>> box;
      for (const auto& f : box_faces)
        box.push_back(face_of<T>(
            {box_corner(q, b, f[0]), box_corner(q, b, f[1]), box_corner(q, b, f[2]), box_corner(q, b, f[3])}));
      auto made =
          PlaneTree<T>::made(subtracts(b) ? SolidOperation::subtract : SolidOperation::unite, chain, box, epsilon);
      if (!made) return {std::nullopt};
      chain = *std::move(made);
    }
    return {mesh_of(chain)};
  }
};

Solids chain_by_ours(const std::array<double, chain_numbers>& q) {
  ExactMesh chain;
  for (std::size_t b = 0; b < boxes; ++b) {
    std::vector<SolidFace<double>> box;
    for (const auto& f : box_faces)
      box.push_back(
          {{box_corner(q, b, f[0]), box_corner(q, b, f[1]), box_corner(q, b, f[2]), box_corner(q, b, f[3])}, {}, 0});
    const ExactMesh next = exact_mesh(mesh_of(box));
    chain = subtracts(b) ? subtract(chain, next) : unite(chain, next);
  }
  return {round(chain).mesh};
}

/// Cells are counted.
std::vector<SolidCase<chain_numbers>> chain_cases(const Settings& settings) {
  std::vector<SolidCase<chain_numbers>> cases(settings.quick ? 8 : 300);
  for (std::uint64_t i = 0; i < cases.size(); ++i) {
    Entropy entropy(settings.seed, i);
    std::bitset<lattice * lattice * lattice> cells;
    std::size_t given = 0;
    auto& q = cases[i].question;
    for (std::size_t b = 0; b < boxes; ++b) {
      std::array<std::size_t, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = entropy.below(lattice - 1);
        high[k] = low[k] + 1 + entropy.below(lattice - low[k]);
        q[6 * b + k] = static_cast<double>(low[k]);
        q[6 * b + 3 + k] = static_cast<double>(high[k]);
      }
      for (std::size_t x = low[0]; x < high[0]; ++x)
        for (std::size_t y = low[1]; y < high[1]; ++y)
          for (std::size_t z = low[2]; z < high[2]; ++z) {
            cells[(x * lattice + y) * lattice + z] = !subtracts(b);
            ++given;
          }
    }
    cases[i].truth.emplace_back(static_cast<double>(cells.count()));
    cases[i].whole = Rational(static_cast<double>(given));
  }
  return cases;
}

// The judge.

std::vector<Count> failures_of(const TriangleMesh& told, const Rational& truth, const Rational& whole) {
  std::vector<Count> counts{{"results that are not closed", 0, 1},
                            {"results that meet themselves or have triangles of no area", 0, 1},
                            {"volumes off by a thousandth of the solids", 0, 1}};
  const bool is_finite = std::ranges::all_of(
      told.vertices, [](const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
  if (!is_finite) {
    for (Count& count : counts) count.failures = 1;
    return counts;
  }
  const SurfaceFaults faults = find_faults(told, {.execution = Execution::serial});
  counts[0].failures = !faults.closed || !faults.oriented;
  counts[1].failures = faults.meets_itself() || faults.degenerate != 0;
  const Rational off = exact_volume(exact_mesh(told)) - truth;
  counts[2].failures = (off.sign() == Sign::negative ? -off : off) * Rational(1000) >= whole;
  return counts;
}

template <std::size_t N>
Findings tried(const std::vector<SolidWay<N>>& ways, const std::vector<SolidCase<N>>& cases) {
  return {outcomes_of(ways,
                      [&](const SolidWay<N>& way) {
                        std::vector<Count> all;
                        Count given_up{"operations that were given up: their tree had no end"};
                        for (const SolidCase<N>& c : cases) {
                          const Solids told = way.ask(c.question);
                          for (std::size_t k = 0; k < told.size(); ++k) {
                            ++given_up.of;
                            given_up.failures += !told[k];
                            const auto counts = failures_of(told[k].value_or(TriangleMesh{}), c.truth[k], c.whole);
                            if (all.empty()) all.assign(counts.size(), {});
                            for (std::size_t j = 0; j < counts.size(); ++j) {
                              all[j].failure = counts[j].failure;
                              all[j].failures += told[k] ? counts[j].failures : 0;
                              all[j].of += told[k] ? counts[j].of : 0;
                            }
                          }
                        }
                        all.push_back(given_up);
                        return all;
                      }),
          {}};
}

template <class Fill>
Scene tetrahedra_scene(std::string name, std::string about, const Settings& settings, Fill fill) {
  return {std::move(name), std::move(about), [=] {
            auto ways = float_ways<24, Solids>(TetrahedraByTrees{});
            ways.push_back(exact_way<24, Solids>(tetrahedra_by_ours));
            return tried(ways, tetrahedra_cases(settings, fill));
          }};
}

}  // namespace

Experiment boolean_experiment() {
  return {"booleans", "what do solids make that are united, intersected and subtracted?", "RTCD 2.2.1, 8.3.4",
          [](const Settings& settings) -> std::vector<Scene> {
            return {tetrahedra_scene("scattered", "tetrahedra in general position", settings, scatter),
                    tetrahedra_scene("on-a-lattice",
                                     "tetrahedra with corners on few integers, so that faces, edges and "
                                     "corners meet",
                                     settings, put_on_lattice),
                    tetrahedra_scene("small", "the same, of 2^-30 of their size", settings, put_on_small_lattice),
                    tetrahedra_scene("off-by-ulps", "a tetrahedron and itself, its coordinates an ulp aside or not",
                                     settings, move_by_ulps),
                    {"chains", "eight boxes on a lattice, united and subtracted in turn", [=] {
                       auto ways = float_ways<chain_numbers, Solids>(ChainByTrees{});
                       ways.push_back(exact_way<chain_numbers, Solids>(chain_by_ours));
                       return tried(ways, chain_cases(settings));
                     }}};
          }};
}

}  // namespace plumb::lab::stability
