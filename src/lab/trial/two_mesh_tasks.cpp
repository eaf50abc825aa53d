// Which triangles of two meshes meet, and how far are they apart?
#include <algorithm>

#include "lab/trial/float_methods.hpp"
#include "lab/trial/mesh_judge.hpp"
#include "lab/trial/mesh_questions.hpp"
#include "lab/trial/plain_tree.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb::lab::trial {
namespace {

/// One mesh, and another that throws of dice choose or place.
InputClass two_meshes(std::string name, std::string about, Surface surface, const Moved& moved_a, const Moved& moved_b,
                      bool posed = false) {
  const bool both_thrown = surface == Surface::pile;
  return {std::move(name), std::move(about), [=](std::span<double> q, Entropy& e) {
            const std::uint64_t dice = 1 + e.below(1U << 30);
            const std::array<double, mesh_pair_numbers> numbers{mesh_name(surface, moved_a, both_thrown ? dice + 1 : 0),
                                                                mesh_name(surface, moved_b, dice),
                                                                0,
                                                                1,
                                                                2,
                                                                posed ? 1.0 : 0.0};
            std::ranges::copy(numbers, q.begin());
          }};
}

std::vector<InputClass> pair_classes() {
  return {
      two_meshes("generic", "two rings of 1,024 triangles, one turned at random, all numbers floats", Surface::band, {},
                 {.turned_at_random = true}),
      two_meshes("vertices_and_edges", "two cubes of unit squares on one lattice", Surface::blocks, {},
                 {.stepped = true}),
      two_meshes("near_ties", "the same, one of them 2^-48 off, or not", Surface::blocks, {},
                 {.stepped = true, .nudged = true}),
      {"same", "a ring of 256 triangles, turned at random, and itself",
       [](std::span<double> q, Entropy& e) {
         const double name = mesh_name(Surface::loop, {.turned_at_random = true}, 1 + e.below(1U << 30));
         const std::array<double, mesh_pair_numbers> numbers{name, name, 0, 1, 2, 0};
         std::ranges::copy(numbers, q.begin());
       }},
      two_meshes("degenerate", "twice 200 triangles of small integers, in heaps", Surface::pile, {}, {}),
      two_meshes("far_away", "as generic, a million from the origin", Surface::band, {.far = true},
                 {.turned_at_random = true, .far = true}),
      two_meshes("turned", "as vertices_and_edges, under one pose that turns both", Surface::blocks, {},
                 {.stepped = true}, true),
  };
}

std::vector<InputClass> distance_classes_of_meshes() {
  return {
      two_meshes("generic", "two rings of 1,024 triangles, one turned at random and moved aside, all numbers floats",
                 Surface::band, {}, {.turned_at_random = true, .aside = true}),
      two_meshes("vertices_and_edges", "two cubes of unit squares on one lattice, side by side", Surface::die, {},
                 {.aside = true}),
      two_meshes("near_ties", "as vertices_and_edges, one of them 2^-48 off, or not", Surface::die, {},
                 {.aside = true, .nudged = true}),
      two_meshes("degenerate", "twice 200 triangles of small integers, in heaps, side by side", Surface::pile, {},
                 {.aside = true}),
      two_meshes("far_away", "as generic, a million from the origin", Surface::band, {.far = true},
                 {.turned_at_random = true, .aside = true, .far = true}),
      two_meshes("turned", "as vertices_and_edges, both turned alike, and rounded", Surface::die, {.turned = true},
                 {.aside = true, .turned = true}),
  };
}

/// The answers in full are kept, for they are counted pair by pair.
class PairJudge {
 public:
  const Pairs& pairs(std::span<const double> q) {
    // A regular pose of both changes no pair.
    const std::pair key{first_key(q), second_key(q)};
    const auto at = found_.find(key);
    if (at != found_.end()) return at->second;
    const JudgedMesh a(mesh_of(key.first)), b(mesh_of(key.second));
    return found_.emplace(key, pairs_that_meet(a, b)).first->second;
  }
  std::uint64_t wrong_pairs(std::span<const double> q, Pairs said) {
    std::ranges::sort(said);
    Pairs differing;
    std::ranges::set_symmetric_difference(pairs(q), said, std::back_inserter(differing));
    return differing.size();
  }

 private:
  std::map<std::pair<MeshKey, MeshKey>, Pairs> found_;
};

template <class T>
auto plain_tree(T epsilon) {
  return [epsilon](const TriangleMesh& m) { return PlainTree<T>(m, epsilon); };
}
template <class T>
Method plain_pairs(std::string name, std::string about, T epsilon) {
  return of_two_meshes(std::move(name), std::move(about), plain_tree(epsilon),
                       [](const PlainTree<T>& a, const PlainTree<T>& b) { return a.pairs_with(b); });
}
template <class T>
Method plain_distance(std::string name, std::string about) {
  return of_two_meshes(std::move(name), std::move(about), plain_tree(T(0)),
                       [](const PlainTree<T>& a, const PlainTree<T>& b) { return a.distance_to(b); });
}

Bvh tree_of_mesh(const TriangleMesh& m) { return build_bvh(m); }

}  // namespace

Task mesh_pairs_task() {
  Task task{"mesh-pairs", "which triangles of two meshes meet?", mesh_pair_numbers, AnswerKind::set, {}, {}, {}, {},
            256};
  task.classes = pair_classes();
  task.symmetries = {mesh_axes_in_turn(2, 0, true)};
  const auto judge = std::make_shared<PairJudge>();
  task.judge = [judge](std::span<const double> q) { return as_answer(judge->pairs(q)); };
  task.tallies = {{"wrong pairs", "pairs that meet and were not named, and pairs named that do not",
                   [judge](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return judge->wrong_pairs(q, round.given_pairs(i));
                   }}};
  task.methods.push_back(
      plain_pairs<float>("float32", "our trees in single precision, of coordinates rounded to it", 0));
  task.methods.push_back(plain_pairs<double>("double", "our trees, triangles by their intervals", 0));
  task.methods.push_back(plain_pairs<double>("absolute", "double, with an epsilon of 1e-9", customary_epsilon));
  task.methods.push_back(of_two_meshes(
      "exact", "ours, all pairs of two meshes", tree_of_mesh, [](const Bvh& a, const Bvh& b, const Pose& pose) {
        const PairOptions serial{.execution = Execution::serial};
        const auto found =
            pose == identity_pose ? intersecting_pairs(a, b, serial) : intersecting_pairs({a, pose}, {b, pose}, serial);
        Pairs pairs(found.size());
        std::ranges::transform(found, pairs.begin(), [](const TrianglePair& p) { return std::array{p.a, p.b}; });
        return pairs;
      }));
  return task;
}

Task mesh_distance_task() {
  Task task{
      "mesh-distance", "how far are two meshes apart?", mesh_pair_numbers, AnswerKind::number, {}, {}, {}, {}, 256};
  task.classes = distance_classes_of_meshes();
  task.symmetries = {mesh_axes_in_turn(2, 0, true)};
  const auto shelf = std::make_shared<JudgedShelf>();
  task.judge = [shelf](std::span<const double> q) {
    const JudgedMesh b(mesh_of(second_key(q)));
    mpq_class square = square_distance((*shelf)(first_key(q)), b);
    mpq_div_2exp(square.get_mpq_t(), square.get_mpq_t(), 100);
    return nearest_root(square);
  };
  task.tallies = {{"far off", "distances that are off by more than 1e-4 of the true one",
                   [](std::span<const double>, double truth, const Round& round, std::size_t i) {
                     return std::uint64_t{magnitude(round.given(i) - truth) > 1e-4 * truth};
                   }}};
  task.methods.push_back(
      plain_distance<float>("float32", "our trees in single precision, of coordinates rounded to it"));
  task.methods.push_back(plain_distance<double>("double", "our trees, distances as commonly written"));
  task.methods.push_back(
      of_two_meshes("exact", "ours, two meshes at a time", tree_of_mesh,
                    [](const Bvh& a, const Bvh& b) { return closest_triangles(a, b)->closest.distance; }));
  return task;
}

}  // namespace plumb::lab::trial
