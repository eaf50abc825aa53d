// The tasks on meshes and on many things of `plumb-lab chart`: these are what they are said to be, their judge is the loop
// over all by the library's exact tests, and what is wrong, missed or far off is counted as such.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "certify/sanitized.hpp"
#include "lab/crowd/crowds.hpp"
#include "lab/trial/measure.hpp"
#include "lab/trial/mesh_judge.hpp"
#include "lab/trial/mesh_questions.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/parity.hpp"

namespace plumb::lab::trial {
namespace {

Triangle3 triangle_of(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Calls see(question) of the first cases of each class.
template <class See>
void each_question(const Task& task, std::uint64_t cases, See see) {
  for (const InputClass& input : task.classes) {
    SCOPED_TRACE(task.name + ", " + input.name);
    for (std::uint64_t i = 0; i < cases; ++i) {
      SCOPED_TRACE("case " + std::to_string(i));
      std::vector<double> q(task.numbers);
      Entropy entropy(2026, i);
      input.fill(q, entropy);
      see(std::span<const double>(q));
    }
  }
}

double answer_of(const Task& task, std::string_view method, std::span<const double> question) {
  const auto found = std::ranges::find(task.methods, method, &Method::name);
  const auto round = found->prepare(question, {});
  round->answer();
  return round->given(0);
}

/// Ours name the lowest of those that are right, alone and together: what the judge says.
void expect_said(const Task& task, std::span<const double> questions) {
  for (const std::string_view method : {"exact", "batch"}) {
    const auto round = std::ranges::find(task.methods, method, &Method::name)->prepare(questions, {});
    round->answer();
    for (std::size_t i = 0; i * task.numbers < questions.size(); ++i)
      EXPECT_EQ(round->given(i), task.judge(questions.subspan(i * task.numbers, task.numbers))) << method << ' ' << i;
  }
}

TEST(MeshScenes, AreOnTheLatticeAndAsTheyAreNamed) {
  std::set<double> names;
  for (const Surface surface : {Surface::ring, Surface::band, Surface::loop, Surface::shells, Surface::blocks,
                                Surface::die, Surface::heap, Surface::pile}) {
    for (const Moved& moved : {Moved{}, Moved{.turned_at_random = true}, Moved{.stepped = true, .nudged = true},
                               Moved{.aside = true}, Moved{.turned = true}, Moved{.far = true}}) {
      if (moved.nudged && surface == Surface::shells) continue;
      const double name = mesh_name(surface, moved, 7);
      EXPECT_TRUE(names.insert(name).second);
      const TriangleMesh mesh = mesh_of({name, 0, 1, 2});
      const bool soup = surface == Surface::heap || surface == Surface::pile;
      EXPECT_EQ(is_closed(mesh), !soup);
      if (surface == Surface::shells && (moved.turned_at_random || moved.far)) continue;  // they round 2^-50 away
      for (const Point3& p : mesh.vertices) {
        for (const double x : {p.x, p.y, p.z}) EXPECT_EQ(std::ldexp(x, 50), std::trunc(std::ldexp(x, 50)));
      }
      const TriangleMesh again = mesh_of({name, 0, 1, 2}), other = mesh_of({name, 1, 2, 0});
      EXPECT_EQ(again.vertices, mesh.vertices);
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Point3 &p = mesh.vertices[i], &q = other.vertices[i];
        EXPECT_EQ(q, (Point3{p.y, p.z, p.x}));
      }
    }
  }
  EXPECT_EQ(mesh_of({mesh_name(Surface::ring), 0, 1, 2}).triangles.size(), 6400U);
  EXPECT_EQ(mesh_of({mesh_name(Surface::blocks), 0, 1, 2}).triangles.size(), 300U);
  EXPECT_EQ(mesh_of({mesh_name(Surface::die), 0, 1, 2}).triangles.size(), 108U);
}

TEST(MeshJudge, TakesNoNumberThatItCannotHold) { EXPECT_THROW(integer_vec(0x1p-51, 0, 0), InvalidShape); }

TEST(MeshJudge, AgreesWithEveryTriangleAskedForARay) {
  const Task task = closest_hit_task();
  const std::uint64_t cases = battery::sanitized ? 10 : 40;
  std::map<MeshKey, TriangleMesh> meshes;
  std::vector<double> questions;
  std::size_t none = 0;
  each_question(task, cases, [&](std::span<const double> q) {
    const TriangleMesh& mesh = meshes.try_emplace(key_of(q), mesh_of(key_of(q))).first->second;
    const auto first = first_hit(ray_in(q), mesh);
    EXPECT_EQ(task.judge(q), first ? first->index : no_item);
    if (!first) ++none;
    questions.insert(questions.end(), q.begin(), q.end());
  });
  EXPECT_GT(none, cases / 8);
  EXPECT_LT(none, 5 * cases);
  expect_said(task, questions);
}

TEST(MeshJudge, AgreesWithEveryTriangleAskedForAPoint) {
  const Task task = closest_point_task();
  std::vector<double> questions;
  each_question(task, battery::fitting(12), [&](std::span<const double> q) {
    const TriangleMesh mesh = mesh_of(key_of(q));
    const Point3 p = place_in(q);
    std::size_t best = 0;
    for (std::size_t i = 1; i < mesh.triangles.size(); ++i) {
      // Doubles first, for those that are much farther.
      if (distance(p, triangle_of(mesh, i)) > 1.001 * distance(p, triangle_of(mesh, best)) + 1e-9) continue;
      if (squared_distance_exact(p, triangle_of(mesh, i)) < squared_distance_exact(p, triangle_of(mesh, best)))
        best = i;
    }
    EXPECT_EQ(task.judge(q), static_cast<double>(best));
    questions.insert(questions.end(), q.begin(), q.end());
  });
  expect_said(task, questions);
}

TEST(MeshJudge, AgreesWithEveryPairOfTriangles) {
  const Task task = mesh_pairs_task();
  std::size_t all = 0;
  each_question(task, 1, [&](std::span<const double> q) {
    const TriangleMesh a = mesh_of(first_key(q)), b = mesh_of(second_key(q));
    Pairs pairs;
    for (std::uint32_t i = 0; i < a.triangles.size(); ++i) {
      const Triangle3 s = triangle_of(a, i);
      for (std::uint32_t k = 0; k < b.triangles.size(); ++k) {
        if (intersects(s, triangle_of(b, k))) pairs.push_back({i, k});
      }
    }
    all += pairs.size();
    EXPECT_EQ(pairs_that_meet(JudgedMesh(a), JudgedMesh(b)), pairs);
    EXPECT_EQ(task.judge(q), as_answer(pairs));
    EXPECT_EQ(answer_of(task, "exact", q), as_answer(pairs));
  });
  EXPECT_GT(all, 1000U);
}

TEST(MeshJudge, AgreesWithEveryPairOfTrianglesOnTheDistance) {
  const Task task = mesh_distance_task();
  each_question(task, 1, [&](std::span<const double> q) {
    const TriangleMesh a = mesh_of(first_key(q)), b = mesh_of(second_key(q));
    const double truth = task.judge(q);
    double least = std::numeric_limits<double>::infinity();
    // Of large meshes some rows, which is enough to be noticed: none may be nearer.
    for (std::size_t i = 0; i<a.triangles.size(); i += a.triangles.size()> 300 ? 16 : 1) {
      for (std::size_t k = 0; k < b.triangles.size(); ++k)
        least = std::min(least, distance(triangle_of(a, i), triangle_of(b, k)));
    }
    if (a.triangles.size() > 300) {
      EXPECT_LE(truth, least);
    } else {
      EXPECT_EQ(truth, least);
    }
    EXPECT_EQ(answer_of(task, "exact", q), truth);
  });
}

/// The same by another code path: linear programs in rationals, on triangles of small integers, flat ones among them.
TEST(ExactMeet, AgreesWithLinearPrograms) {
  int met = 0, hit = 0;
  for (std::uint64_t i = 0; i < battery::fitting(1500U); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    Entropy e(5, i);
    const auto generated = [](const IntegerTriangle& t) {
      Generated g;
      for (const IntegerVec& p : t) g.points.push_back({p.x, p.y, p.z});
      return g;
    };
    const auto number = [&e] { return mpz_class(static_cast<long>(e.within(2))); };
    IntegerTriangle a, b;
    for (IntegerTriangle* t : {&a, &b}) {
      for (IntegerVec& p : *t) p.x = number(), p.y = number(), p.z = number();
    }
    const bool meeting = meet(generated(a), generated(b));
    met += meeting;
    EXPECT_EQ(triangles_meet(a, b), meeting);
    EXPECT_EQ(square_distance(a, b) == 0, meeting);
    IntegerVec d = b[1] - b[0];
    if (d.x == 0 && d.y == 0 && d.z == 0) d.x = 1;
    const auto first = first_meeting(b[0], d, a);
    const RationalVec o{b[0].x, b[0].y, b[0].z}, along{d.x, d.y, d.z};
    EXPECT_EQ(first.has_value(), meet({{o}, {along}}, generated(a)));
    if (!first) continue;
    ++hit;
    // It is there, and not before.
    mpq_class t(first->above, first->below);
    t.canonicalize();
    const mpq_class before = t / 2;
    EXPECT_TRUE(meet({{o + along * t}, {}}, generated(a)));
    EXPECT_EQ(meet({{o, o + along * before}, {}}, generated(a)), t == 0);
  }
  EXPECT_GT(met, battery::fitting(300));
  EXPECT_GT(hit, battery::fitting(100));
}

/// Boxes, points and walks: each method of ours says what the judge says, of ties the lowest.
TEST(CrowdJudges, AgreeWithOurs) {
  std::size_t pairs = 0, cells = 0;
  for (const Task& task : {box_pairs_task(), grid_walk_task()}) {
    each_question(task, task.name == "box-pairs" ? 1 : battery::fitting(20), [&](std::span<const double> q) {
      for (const Method& method : task.methods) {
        const bool common = method.value || method.about.find("ours") == std::string::npos;
        if (common) continue;
        const auto round = method.prepare(q, {});
        round->answer();
        EXPECT_EQ(round->given(0), task.judge(q)) << method.name;
        (task.name == "box-pairs" ? pairs : cells) += round->given_pairs(0).size();
      }
    });
  }
  EXPECT_GT(pairs, 10'000U);
  EXPECT_GT(cells, battery::fitting(500));
  const Task task = nearest_point_task();
  std::vector<double> questions;
  each_question(task, battery::fitting(20),
                [&](std::span<const double> q) { questions.insert(questions.end(), q.begin(), q.end()); });
  expect_said(task, questions);
}

/// A box shares its walls' doubles with 26 others; where it has them nudged, with some of these.
TEST(Crowds, TouchAsTheyAreSaidTo) {
  const Task task = box_pairs_task();
  const auto count = [&](Spread spread) {
    const std::array<double, box_crowd_numbers> q{crowd_name(spread, 5), 0, 1, 2};
    const auto round = task.methods.back().prepare(q, {});
    round->answer();
    return round->given_pairs(0).size();
  };
  constexpr std::size_t side = 8, touching = ((3 * side - 2) * (3 * side - 2) * (3 * side - 2) - crowd_size) / 2;
  EXPECT_EQ(count(Spread::touching), touching);
  EXPECT_GT(count(Spread::nudged), touching / 4);
  EXPECT_LT(count(Spread::nudged), 3 * touching / 4);
  for (const Spread s : {Spread::uniform, Spread::clustered, Spread::sizes, Spread::degenerate, Spread::far}) {
    EXPECT_GT(count(s), crowd_size) << static_cast<int>(s);
    EXPECT_LT(count(s), 40 * crowd_size) << static_cast<int>(s);
  }
}

TEST(PairsAsAnswer, AreToldApartAndKnowNoOrder) {
  EXPECT_EQ(as_answer(Pairs{{1, 2}, {3, 4}}), as_answer(Pairs{{3, 4}, {1, 2}}));
  std::set<double> all;
  for (const Pairs& p : {Pairs{}, Pairs{{0, 0}}, Pairs{{0, 1}}, Pairs{{1, 0}}, Pairs{{0, 0}, {0, 0}},
                         Pairs{{1, 2}, {3, 4}}, Pairs{{1, 4}, {3, 2}}, Pairs{{1, 2}, {3, 4}, {5, 6}}})
    EXPECT_TRUE(all.insert(as_answer(p)).second);
  for (const double x : all) EXPECT_EQ(x, std::trunc(x));
}

/// What a method that always says the same is found to be.
Score score_of_saying(Task task, const std::string& input, const std::function<double(std::size_t)>& say,
                      Pairs pairs = {}) {
  class Says final : public Round {
   public:
    Says(std::function<double(std::size_t)> say, Pairs pairs) : say_(std::move(say)), pairs_(std::move(pairs)) {}
    void answer() override {}
    [[nodiscard]] double given(std::size_t i) const override { return say_(i); }
    [[nodiscard]] Pairs given_pairs(std::size_t) const override { return pairs_; }

   private:
    std::function<double(std::size_t)> say_;
    Pairs pairs_;
  };
  task.methods = {{"says", "", [=](std::span<const double>, const Scene&) -> std::unique_ptr<Round> {
                     return std::make_unique<Says>(say, pairs);
                   }}};
  const auto found = std::ranges::find(task.classes, input, &InputClass::name);
  return measure(task, *found, {2026, 256}, [] {}).scores.at(0);
}

TEST(Tally, CountsWhatIsMissed) {
  const Score none = score_of_saying(closest_hit_task(), "vertices_and_edges", [](std::size_t) { return no_item; });
  EXPECT_EQ(none.asked, 64U);
  EXPECT_EQ(none.tallied.at(0), none.asked);  // each hits
  EXPECT_EQ(none.wrong, none.asked);
  const Score beyond = score_of_saying(closest_hit_task(), "generic", [](std::size_t) { return 1e9; });
  EXPECT_EQ(beyond.wrong, beyond.asked);
  EXPECT_EQ(beyond.tallied.at(0), 0U);
  const Score unknown = score_of_saying(closest_hit_task(), "generic", [](std::size_t) { return unsure; });
  EXPECT_EQ(unknown.unsure, unknown.asked);
  EXPECT_EQ(unknown.tallied.at(0) + unknown.wrong, 0U);
}

TEST(Tally, CountsPairsAndDistancesThatAreOff) {
  const Score far = score_of_saying(mesh_distance_task(), "generic", [](std::size_t) { return 1e9; });
  EXPECT_EQ(far.tallied.at(0), far.asked);
  const Score far_triangle = score_of_saying(closest_point_task(), "far_away", [](std::size_t) { return no_item; });
  EXPECT_EQ(far_triangle.tallied.at(0), far_triangle.asked);
  const Score pairs = score_of_saying(mesh_pairs_task(), "same", [](std::size_t) { return 0.0; });
  EXPECT_EQ(pairs.wrong, 1U);
  // A triangle of a closed ring, every vertex of which has six, has 12 neighbors, and is its own.
  EXPECT_EQ(pairs.tallied.at(0), 256U * 13);
  const Score more = score_of_saying(mesh_pairs_task(), "same", [](std::size_t) { return 0.0; }, {{0, 0}, {900, 900}});
  EXPECT_EQ(more.tallied.at(0), 256U * 13);  // one that meets, and one that is none
}

TEST(Tally, TellsFalsePairsFromMissedOnes) {
  const Score none = score_of_saying(box_pairs_task(), "touching", [](std::size_t) { return 0.0; });
  EXPECT_EQ(none.tallied, (std::vector<std::uint64_t>{0, 5068}));
  const Score some = score_of_saying(box_pairs_task(), "touching", [](std::size_t) { return 0.0; }, {{0, 1}, {0, 511}});
  EXPECT_EQ(some.tallied, (std::vector<std::uint64_t>{1, 5067}));
  const Score cells = score_of_saying(grid_walk_task(), "corners", [](std::size_t) { return 0.0; });
  EXPECT_EQ(cells.tallied.at(0), 0U);
  EXPECT_GT(cells.tallied.at(1), 10 * cells.asked);
}

/// Equally first and equally near triangles are as right as the lowest.
TEST(Ties, AreRightWhicheverIsNamed) {
  const Task hits = closest_hit_task(), places = closest_point_task();
  std::size_t ties = 0;
  const auto look = [&](const Task& task, std::span<const double> q) {
    const TriangleMesh mesh = mesh_of(key_of(q));
    const double truth = task.judge(q);
    if (truth == no_item) return;
    EXPECT_FALSE(task.is_right(q, truth, no_item));
    EXPECT_FALSE(task.is_right(q, truth, 1e9));
    if (mesh.triangles.size() > 2000) return;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (static_cast<double>(i) == truth || !task.is_right(q, truth, static_cast<double>(i))) continue;
      EXPECT_GT(static_cast<double>(i), truth);
      ++ties;
    }
  };
  each_question(hits, 6, [&](std::span<const double> q) { look(hits, q); });
  each_question(places, 4, [&](std::span<const double> q) { look(places, q); });
  EXPECT_GT(ties, 10U);
}

}  // namespace
}  // namespace plumb::lab::trial
