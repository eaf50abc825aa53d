#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "certify/catalog.hpp"
#include "tool/plan/command.hpp"
#include "tool/plan/lattice_savings.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json json_of(const Lattice& l) { return {{"exponent", l.exponent}, {"bits", l.bits}}; }

json json_of(const DecisionTimes& t) {
  return {{"decisions", t.decisions}, {"contradictions", t.contradictions},
          {"bare_ns", t.plain},       {"decide_ns", t.decide},
          {"batch_ns", t.batch},      {"plan_ns", t.plan},
          {"take", t.taken()}};
}

json json_of(const ScenePlanRow& row) {
  json j{{"bits", row.bits}, {"step", row.exponent}, {"predicates", json::array()}};
  for (std::size_t k = 0; k < row.times.size(); ++k) {
    json p = json_of(row.times[k]);
    p["predicate"] = classics()[k].name;
    p["plan"] = to_string(row.arithmetic[k]);
    j["predicates"].push_back(std::move(p));
  }
  if (row.damage.empty()) return j;
  j["greatest_move"] = row.greatest_move();
  j["greatest_move_hexadecimal"] = fmt::format("{:a}", row.greatest_move());
  j["greatest_distance"] = row.greatest_distance();
  j["merged"] = row.merged();
  j["collapsed"] = row.collapsed();
  j["turned_over"] = row.turned_over();
  j["damage"] = json::array();
  for (const SnapDamage& d : row.damage) {
    const auto listed = [](const auto& list) {
      return json(
          std::vector(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), most_listed))));
    };
    j["damage"].push_back({{"lattice", json_of(d.lattice)},
                           {"merged_pairs", listed(d.merged)},
                           {"collapsed_triangles", listed(d.collapsed)},
                           {"turned_triangles", listed(d.turned_over)}});
  }
  return j;
}

json json_of(const BoundPlan& b) {
  json j{{"mesh", b.rated.name},
         {"take", b.taken()},
         {"chosen", name_of(bound_kinds[b.chosen])},
         {"with_ns", b.with_ns()},
         {"without_ns", b.without_ns()},
         {"placements", b.rated.ratings.placements.size()},
         {"kinds", json::array()}};
  for (std::size_t k = 0; k < bound_kinds.size(); ++k) {
    const BoundRating& r = b.rated.ratings.kinds[k];
    j["kinds"].push_back({{"kind", name_of(bound_kinds[k])},
                          {"test_ns", r.test_ns},
                          {"overlapping", r.overlapping},
                          {"query_ns", b.rated.expected_ns(k)}});
  }
  return j;
}

json json_of(const TreePlan& plan) {
  json j{{"ray_ns_without", plan.ray_ns_without},
         {"rays_in_plane", plan.rays_in_plane},
         {"trees", json::array()},
         {"choices", json::array()}};
  for (const TreeTimes& t : plan.trees) {
    j["trees"].push_back({{"method", name_of(t.method)},
                          {"build_ms", t.build_ms},
                          {"ray_ns", t.ray_ns},
                          {"nearest_ns", t.nearest_ns},
                          {"bytes_per_triangle", t.bytes},
                          {"contradictions", t.contradictions}});
  }
  if (plan.trees.empty()) return j;
  for (const TreeChoice& c : plan.choices())
    j["choices"].push_back({{"method", c.method ? name_of(*c.method) : "none"}, {"from_rays", c.from}});
  return j;
}

json json_of(const VolumePlan& plan) {
  json j{{"kinds", json::array()}};
  for (const VolumeTimes& t : plan.kinds) {
    j["kinds"].push_back({{"kind", t.kind},
                          {"build_ms", t.build_ms},
                          {"query_ms", t.query_ms},
                          {"volume_tests", t.work.volume_tests},
                          {"triangle_tests", t.work.triangle_pairs},
                          {"meeting_pairs", t.work.pairs},
                          {"contradicts", t.contradicts}});
  }
  j["left_out"] = plan.left_out;
  if (!plan.kinds.empty()) j["chosen"] = plan.chosen().kind;
  return j;
}

}  // namespace

json plan_json(const ScenePlan& scene) {
  json all = origin_json("plumb plan");
  all["lattice"] = json_of(scene.lattice());
  for (const char* const list :
       {"meshes", "classics", "predicates", "lattices", "bound_plans", "tree_plans", "volume_plans"})
    all[list] = json::array();
  for (std::size_t i = 0; i < scene.names.size(); ++i) {
    json alone = json::array();
    for (const CatalogEntry& e : classics())
      alone.push_back(
          {{"predicate", e.name}, {"plan", to_string(arithmetic_of(e.planned_bits, scene.lattices[i].bits))}});
    all["meshes"].push_back({{"mesh", scene.names[i]},
                             {"vertices", scene.vertices[i]},
                             {"triangles", scene.triangles[i]},
                             {"lattice", json_of(scene.lattices[i])},
                             {"alone", std::move(alone)}});
  }
  for (const Saving& s : lattice_savings(scene.lattice())) {
    all["classics"].push_back({{"predicate", s.predicate},
                               {"value_bits", s.value_bits},
                               {"suffices", s.suffices},
                               {"never_needs", s.skips},
                               {"plan", s.plan}});
  }
  for (const CatalogEntry& e : catalog()) {
    all["predicates"].push_back(
        {{"predicate", e.name}, {"plan", to_string(arithmetic_of(e.planned_bits, scene.lattice().bits))}});
  }
  for (const ScenePlanRow& row : scene.rows) all["lattices"].push_back(json_of(row));
  for (const BoundPlan& b : scene.bounds) all["bound_plans"].push_back(json_of(b));
  for (std::size_t i = 0; i < scene.trees.size(); ++i) {
    all["tree_plans"].push_back(json_of(scene.trees[i]));
    all["tree_plans"].back()["mesh"] = scene.names[i];
    all["volume_plans"].push_back(json_of(scene.volumes[i]));
    all["volume_plans"].back()["mesh"] = scene.names[i];
  }
  return all;
}

}  // namespace plumb::tool
