// `plumb plan`: what a lattice is said to save is never missed, what snapping is said to do is what it does, and text,
// JSON and picture say the same.
#include "plumb/certify/plan.hpp"

#include <gmock/gmock.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "certify/catalog.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/predicates/manifest.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/mesh/snap.hpp"
#include "tool/plan/command.hpp"
#include "tool/plan/lattice_savings.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;
using testing::AllOf, testing::HasSubstr, testing::Not, testing::StartsWith;

Sign plain_double(const CatalogEntry& e, std::vector<double> number) {
  for (const certify::tape::Instruction& i : e.program.instructions) {
    const double l = number[i.left], r = number[i.right];
    number.push_back(i.operation == '+' ? l + r : i.operation == '-' ? l - r : l * r);
  }
  return sign_of_number(number.back());
}

// Coordinates on the lattice, with long and short spans, and many equal ones.
std::vector<double> coordinates_on(const Lattice& lattice, std::size_t count, Entropy& entropy) {
  std::vector<double> p(count);
  for (double& x : p) {
    const int length = static_cast<int>(entropy.below(static_cast<std::uint64_t>(std::min(lattice.bits, 53)) + 1));
    const int shift = static_cast<int>(entropy.below(static_cast<std::uint64_t>(lattice.bits - length) + 1));
    x = std::ldexp(static_cast<double>(entropy.bits(length)), lattice.exponent + shift) * (entropy.coin() ? 1 : -1);
  }
  if (entropy.coin()) p[entropy.below(count)] = p[entropy.below(count)];
  return p;
}

TEST(LatticeSavings, SkipNothingThatDecides) {
  int plain = 0, said = 0;
  for (const int bits : {1, 4, 9, 12, 24, 49, 53, 57, 61, 62, 100, 125, 189, 190, 202, 253, 317, 318, 335, 509, 600}) {
    for (const int exponent : {-1074, -1000, -963, -962, -537, -300, -214, -50, 0, 100, 190, 300, 500, 960}) {
      if (exponent + bits > 1024) continue;
      const Lattice lattice{exponent, bits};
      const std::vector<Saving> savings = lattice_savings(lattice);
      for (std::size_t k = 0; k < classics().size(); ++k) {
        const CatalogEntry& e = classics()[k];
        ASSERT_EQ(savings[k].predicate, e.name);
        plain += savings[k].suffices == "plain double";
        said += !savings[k].skips.empty();
        for (std::uint64_t i = 0; i < 40; ++i) {
          Entropy entropy(i);
          const std::vector<double> p = coordinates_on(lattice, e.arity(), entropy);
          const Decision d = e.decide(p);
          const std::string stage(to_string(d.stage));
          EXPECT_EQ((", " + savings[k].skips + ",").find(" " + stage + ","), std::string::npos)
              << e.name << " on 2^" << exponent << ", " << bits << " bits: decided by " << stage;
          if (savings[k].suffices == "plain double") {
            EXPECT_EQ(plain_double(e, p), d.sign) << e.name << " on 2^" << exponent << ", " << bits << " bits";
          }
        }
      }
    }
  }
  EXPECT_GT(plain, 50);
  EXPECT_GT(said, 300);
}

TEST(PlannedBits, AreThoseOfThePlan) {
  for (int bits = 0; bits <= 64; ++bits) {
    std::size_t k = 0;
#define PLUMB_SAME(formula) \
  EXPECT_EQ(arithmetic_of(classics()[k++].planned_bits, bits), arithmetic_for<predicates::formula>(bits)) << bits;
    PLUMB_CLASSICS(PLUMB_SAME)
#undef PLUMB_SAME
  }
  std::size_t planned = 0;
  for (const CatalogEntry& e : catalog()) {
    planned += static_cast<std::size_t>(e.planned_bits[0] > 0);
    if (e.homogeneous) continue;
    EXPECT_THAT(e.planned_bits, testing::Each(-1)) << e.name;
  }
  EXPECT_GT(planned, 50);
}

/// A finite double of any size, often near a tie of the step.
double any_double(int exponent, Entropy& entropy) {
  const auto mantissa = static_cast<double>(entropy.bits(static_cast<int>(entropy.below(54))));
  const int near = exponent - 1 - static_cast<int>(entropy.below(60)),
            far = -1074 + static_cast<int>(entropy.below(2040));
  const double x = std::ldexp(mantissa, entropy.coin() ? std::clamp(near, -1074, 960) : std::min(far, 960));
  return entropy.coin() ? -x : x;
}

TEST(Snap, GoesToTheNearestMultiple) {
  int ties = 0, moved = 0, zeros = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Entropy entropy(11, i);
    const int exponent = -1074 + static_cast<int>(entropy.below(2040));
    const double x = any_double(exponent, entropy), to = nearest_multiple(x, exponent);
    SCOPED_TRACE(testing::Message() << "start 11, case " << i << ": " << x << " to multiples of 2^" << exponent);
    ASSERT_TRUE(std::isfinite(to));
    mpq_class step = 1;
    (exponent >= 0 ? mpq_mul_2exp : mpq_div_2exp)(step.get_mpq_t(), step.get_mpq_t(),
                                                  static_cast<mp_bitcnt_t>(std::abs(exponent)));
    const mpq_class multiple = mpq_class(to) / step, off = abs(mpq_class(mpq_class(x) - mpq_class(to)));
    EXPECT_EQ(multiple.get_den(), 1);
    EXPECT_LE(mpq_class(2 * off), step);
    if (2 * off == step) {
      ++ties;
      EXPECT_EQ(mpz_even_p(multiple.get_num_mpz_t()) != 0, true);
    }
    EXPECT_EQ(mpq_class(x - to), mpq_class(x) - mpq_class(to));  // the move is a double
    EXPECT_FALSE(to == 0 && std::signbit(to));
    moved += to != x;
    zeros += to == 0;
  }
  EXPECT_GT(ties, 50);
  EXPECT_GT(moved, 2'000);
  EXPECT_GT(zeros, 2'000);
  EXPECT_TRUE(std::isinf(nearest_multiple(0x1.fffffffffffffp1023, 1022)));
}

/// Two triangles over an edge: one that a step of 1 collapses, one that it turns over; and two points that it merges.
TriangleMesh fragile() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0},     {4, 0, 0},     {2, 0.25, 0},   {2.25, 0.375, 0},
                   {0, 0.625, 0}, {4, 0.625, 0}, {2, 0.5625, 0}, {2, 1.5, 0}};
  mesh.triangles = {{0, 1, 2}, {4, 5, 7}, {0, 1, 7}, {4, 6, 5}};
  return mesh;
}

TEST(Snap, CountsWhatMergesCollapsesAndTurnsOver) {
  const auto damage = snap_damage(fragile(), 0);
  ASSERT_TRUE(damage);
  EXPECT_EQ(damage->lattice, (Lattice{0, 3}));
  EXPECT_EQ(damage->greatest_move, 0.5);  // 1.5 goes to 2, the even one
  EXPECT_EQ(damage->merged, (std::vector<std::array<std::uint32_t, 2>>{{3, 2}}));
  EXPECT_EQ(damage->collapsed, (std::vector<std::uint32_t>{0, 3}));
  EXPECT_THAT(damage->turned_over, testing::IsEmpty());
  TriangleMesh sliver;  // its apex goes from above the base to below it
  sliver.vertices = {{0, 0.375, 0}, {8, 0.625, 0}, {2, 0.46875, 0}};
  sliver.triangles = {{0, 1, 2}};
  EXPECT_EQ(snap_damage(sliver, 0)->turned_over, std::vector<std::uint32_t>{0});
  EXPECT_FALSE(snap_damage(TriangleMesh{{{0x1.fffffffffffffp1023, 0, 0}}, {}}, 1022));
  EXPECT_EQ(snap_damage(fragile(), -10)->greatest_move, 0);
  EXPECT_EQ(snap_damage(fragile(), 40)->lattice, Lattice{});  // all at the origin
}

TEST(Plan, TextJsonAndChartAgree) {
  const Folder folder;
  TriangleMesh moved = fragile();
  for (Point3& p : moved.vertices) p = {p.x + 0.1, p.y + 1.0 / 3, p.z * 0.7 + 0.2};
  write_mesh(folder / "short.off", fragile());
  write_mesh(folder / "long.off", moved);
  const Outcome o =
      run("cd '" + (folder / "") + "'; $PLUMB plan short.off long.off --placements 20 --json p.json --chart p.svg");
  ASSERT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out,
              AllOf(StartsWith("short.off: 8 vertices, 4 triangles; alone multiples of 2^-4 of 7 bits\n"),
                    HasSubstr("alone, short.off needs less: orient2d: plain double; "), HasSubstr("bounding volume")));
  const json j = json::parse(content(folder / "p.json"));
  EXPECT_EQ(j["meshes"][0]["lattice"], (json{{"exponent", -4}, {"bits", 7}}));
  EXPECT_EQ(j["predicates"].size(), catalog().size());
  const int bits = j["lattice"]["bits"];
  EXPECT_GT(bits, 50);
  EXPECT_EQ(j["lattices"][0]["bits"], bits);
  EXPECT_EQ(j["lattices"].size(), bits > 62 ? 14 : 13);  // each number of bits at which a classic gets by with less
  int last = bits + 1;
  double move = -1;
  for (const json& row : j["lattices"]) {
    EXPECT_LT(row["bits"], last);
    last = row["bits"];
    for (std::size_t k = 0; k < classic_count; ++k) {
      const json& p = row["predicates"][k];
      EXPECT_EQ(p["contradictions"], 0);
      EXPECT_EQ(p["plan"], to_string(arithmetic_of(classics()[k].planned_bits, row["bits"])));
      EXPECT_EQ(p["decisions"].get<int>() != 0, p["plan_ns"].get<double>() > 0);
      if (p["decisions"] != 0) {
        EXPECT_EQ(p["take"], p["plan_ns"] <= p["decide_ns"] ? "plan" : "decide");
      }
    }
    if (row.contains("greatest_move")) {
      EXPECT_GE(row["greatest_move"], move);
      move = row["greatest_move"];
      double listed = 0;
      for (const json& mesh : row["damage"]) listed += static_cast<double>(mesh["merged_pairs"].size());
      EXPECT_EQ(row["merged"], listed);
    }
  }
  ASSERT_EQ(j["bound_plans"].size(), 2);
  for (const json& b : j["bound_plans"]) {
    double least = b["without_ns"];
    least = HUGE_VAL;
    for (const json& kind : b["kinds"]) least = std::min(least, kind["query_ns"].get<double>());
    EXPECT_EQ(b["with_ns"], least);
    EXPECT_EQ(b["take"], b["with_ns"] < b["without_ns"] ? b["chosen"] : json("none"));
  }
  ASSERT_EQ(j["tree_plans"].size(), 2);
  EXPECT_EQ(j["tree_plans"][1]["mesh"], "long.off");
  for (const json& t : j["tree_plans"]) {
    EXPECT_GT(t["ray_ns_without"], 0);
    EXPECT_EQ(t["rays_in_plane"], true);  // both meshes are flat
    EXPECT_EQ(t["trees"].size(), planned_methods().size());
    for (const json& tree : t["trees"]) EXPECT_EQ(tree["contradictions"], 0) << tree;
    EXPECT_EQ(t["choices"][0]["from_rays"], 0);
  }
  ASSERT_EQ(j["volume_plans"].size(), 2);
  for (const json& v : j["volume_plans"]) {
    ASSERT_EQ(v["kinds"].size(), 4);
    EXPECT_TRUE(v["left_out"].empty());
    double least = HUGE_VAL;
    for (const json& kind : v["kinds"]) {
      EXPECT_FALSE(kind["contradicts"]) << kind;
      EXPECT_EQ(kind["meeting_pairs"], v["kinds"][0]["meeting_pairs"]);
      least = std::min(least, kind["query_ms"].get<double>());
      if (kind["kind"] == v["chosen"]) {
        EXPECT_EQ(kind["query_ms"], least);
      }
    }
  }
  EXPECT_THAT(o.out, AllOf(HasSubstr("tree of boxes"), HasSubstr("take none"), HasSubstr("volumes of a tree"),
                           HasSubstr("  take\n")));
  const std::string chart = content(folder / "p.svg");
  EXPECT_THAT(chart,
              AllOf(StartsWith("<svg "), HasSubstr("a scene of 2 meshes"), HasSubstr(">short.off</text>"),
                    HasSubstr("turned</text>"), HasSubstr("</svg>"), Not(HasSubstr("\"nan")), Not(HasSubstr("\"inf"))));
}

/// Of one mesh whose plan takes so long.
ScenePlan measured(double decide_ns, double plan_ns) {
  ScenePlan scene;
  scene.names = {"a.off"};
  scene.vertices = {4};
  scene.triangles = {2};
  scene.lattices = {Lattice{0, 70}};
  ScenePlanRow row{70, 0, {}, {}, {}};
  row.arithmetic.fill(Arithmetic::bounded_chain);
  row.times.fill({100, 0, 1, decide_ns, 2, plan_ns});
  scene.rows = {row, row};
  scene.rows[1].bits = 12;
  scene.rows[1].arithmetic.fill(Arithmetic::plain_double);
  scene.rows[1].damage.resize(1);
  return scene;
}

TEST(Plan, RecommendsNothingThatTookLonger) {
  const std::string pays = plan_text(measured(7, 5), false, Style(false)),
                    does_not = plan_text(measured(5, 7), false, Style(false));
  EXPECT_THAT(pays, AllOf(HasSubstr("7.0     2.0     5.0  plan\n"), Not(HasSubstr("  decide\n")),
                          HasSubstr("bounded 5.0"), HasSubstr("double 5.0")));
  EXPECT_THAT(does_not, AllOf(HasSubstr("5.0     2.0     7.0  decide\n"), Not(HasSubstr("  plan\n")),
                              HasSubstr("  decide 5.0"), Not(HasSubstr("double 7.0"))));
  EXPECT_EQ(measured(5, 5).rows[0].times[0].taken(), "plan");
  EXPECT_EQ(DecisionTimes{}.taken(), "-");
}

TEST(TreePlan, TakesWhatCostsLeastForSoManyRays) {
  const auto tree = [](BvhMethod m, double build_ms, double ray_ns) { return TreeTimes{m, build_ms, ray_ns, 0, 0, 0}; };
  // Nothing to 100 rays, then the quick tree; the second is never the least; the good one pays from 4000.
  TreePlan plan{11'000,
                {tree(BvhMethod::linear, 1, 1'000), tree(BvhMethod::binned, 4, 950), tree(BvhMethod::sweep, 3, 500)}};
  const std::vector<TreeChoice> chosen = plan.choices();
  ASSERT_EQ(chosen.size(), 3u);
  EXPECT_FALSE(chosen[0].method);
  EXPECT_EQ(chosen[0].from, 0);
  EXPECT_EQ(chosen[1].method, BvhMethod::linear);
  EXPECT_EQ(chosen[1].from, 100);
  EXPECT_EQ(chosen[2].method, BvhMethod::sweep);
  EXPECT_EQ(chosen[2].from, 4'000);
  plan.ray_ns_without = 400;  // a mesh of so few triangles that a tree never pays
  EXPECT_EQ(plan.choices().size(), 1u);
  plan = {
      10,
      {tree(BvhMethod::linear, 0, 5), tree(BvhMethod::binned, 0, 4)}};  // built in no time: the first is never taken
  ASSERT_EQ(plan.choices().size(), 1u);
  EXPECT_EQ(plan.choices()[0].method, BvhMethod::binned);
  // For every number of rays the choice is the least.
  for (std::uint64_t i = 0; i < 500; ++i) {
    Entropy e(31, i);
    const auto number = [&] { return static_cast<double>(e.below(20)); };
    plan = {number(), {}};
    for (const BvhMethod m : planned_methods()) plan.trees.push_back(tree(m, number() / 1e6, number()));
    const std::vector<TreeChoice> by = plan.choices();
    for (double n = 0; n < 60; n += 0.25) {
      double least = n * plan.ray_ns_without, taken = least;
      const auto next = std::ranges::upper_bound(by, n, {}, &TreeChoice::from);
      for (const TreeTimes& t : plan.trees) {
        const double all = 1e6 * t.build_ms + n * t.ray_ns;
        least = std::min(least, all);
        if (std::prev(next)->method == t.method) taken = all;
      }
      EXPECT_LE(taken, least + 1e-9) << "index " << i << ", " << n << " rays";
    }
  }
}

TEST(TreePlan, FindsATreeForAMeshOfManyTriangles) {
  TriangleMesh sheet;
  constexpr std::uint32_t side = 60;
  for (std::uint32_t i = 0; i < side * side; ++i)
    sheet.vertices.push_back({1.0 * (i % side), 1.0 * (i / side), i * 7 % 5 * 0.25});
  for (std::uint32_t i = 0; i + side < side * side; ++i) {
    if (i % side + 1 < side) sheet.triangles.push_back({i, i + 1, i + side});
  }
  const TreePlan plan = plan_trees(sheet);
  ASSERT_EQ(plan.trees.size(), planned_methods().size());
  for (const TreeTimes& t : plan.trees) {
    EXPECT_EQ(t.contradictions, 0u) << name_of(t.method);
    EXPECT_GT(t.build_ms, 0);
    EXPECT_LT(t.ray_ns, plan.ray_ns_without);
    EXPECT_GT(t.bytes, 12);
  }
  EXPECT_GE(plan.choices().size(), 2u);
  EXPECT_FALSE(plan.rays_in_plane);
  EXPECT_TRUE(plan_trees(TriangleMesh{{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}, {{0, 1, 2}}}).rays_in_plane);
  EXPECT_TRUE(plan_trees(TriangleMesh{{{0, 0, 0}}, {}}).trees.empty());
}

TEST(Plan, AnswersForWhateverCanBeRead) {
  const Folder folder;
  const auto plan_of = [&](const std::string& off, const std::string& options) {
    std::ofstream(folder / "m.off") << off;
    return run("$PLUMB plan --placements 5 " + options + " '" + (folder / "m.off") + "'");
  };
  for (const char* mesh :
       {"OFF\n1 1 0\n1 2 3\n3 0 0 0\n", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n", "OFF\n1 1 0\n0 0 0\n3 0 0 0\n",
        "OFF\n3 1 0\n1e308 0 0\n-1e308 1e308 0\n0 -1e308 1e308\n3 0 1 2\n",
        "OFF\n4 2 0\n5e-324 0 0\n0 5e-324 0\n0 0 1e-310\n1e308 1 1\n3 0 1 2\n3 0 2 3\n"}) {
    const Outcome o = plan_of(mesh, "--chart '" + (folder / "m.svg") + "' --json '" + (folder / "m.json") + "'");
    EXPECT_EQ(o.code, 0) << mesh << o.err;
    EXPECT_EQ(o.err, "");
    EXPECT_THAT(o.out, HasSubstr("bounding volume"));
    EXPECT_THAT(content(folder / "m.svg"),
                AllOf(HasSubstr("</svg>"), Not(HasSubstr("\"nan")), Not(HasSubstr("\"inf"))));
    const json j = json::parse(content(folder / "m.json"), nullptr, false);
    ASSERT_FALSE(j.is_discarded());
    for (const json& v : j["volume_plans"]) {
      EXPECT_EQ(v["kinds"].size() + v["left_out"].size(), v["kinds"].empty() ? 0u : 4u);
      for (const json& kind : v["kinds"]) EXPECT_FALSE(kind["contradicts"]) << mesh << kind;
    }
  }
  for (const char* mesh : {"OFF\n0 0 0\n", "OFF\n1 0 0\n1 2 3\n", "OFF\n1 0 0\n1 2 nan\n", "", "OFF\n3 1 0\n"}) {
    const Outcome o = plan_of(mesh, "");
    EXPECT_EQ(o.code, 2) << mesh;
    EXPECT_EQ(o.out, "");
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr("m.off")));
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1);
  }
  EXPECT_EQ(run("$PLUMB plan --json x --chart x").code, 2);
  EXPECT_EQ(run("$PLUMB plan nowhere.obj").code, 2);
  const Outcome all = run("$PLUMB plan --all --placements 2");
  EXPECT_THAT(all.out, AllOf(StartsWith("embedded flange: "), HasSubstr("  dot_of_crosses ")));
}

}  // namespace
}  // namespace plumb::tool
