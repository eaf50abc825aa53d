#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "certify/catalog.hpp"
#include "plumb/certify/environment.hpp"
#include "tool/plan/command.hpp"
#include "tool/plan/lattice_savings.hpp"

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
  j["meshes"] = json::array();
  for (const SnapDamage& d : row.damage) {
    const auto listed = [](const auto& list) {
      return json(
          std::vector(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), most_listed))));
    };
    j["meshes"].push_back({{"lattice", json_of(d.lattice)},
                           {"merged", listed(d.merged)},
                           {"collapsed", listed(d.collapsed)},
                           {"turned_over", listed(d.turned_over)}});
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
  json j{{"ray_ns_without", plan.ray_ns_without}, {"trees", json::array()}, {"choices", json::array()}};
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
                          {"triangle_pairs", t.work.triangle_pairs},
                          {"pairs", t.work.pairs},
                          {"contradicts", t.contradicts}});
  }
  j["left_out"] = plan.left_out;
  if (!plan.kinds.empty()) j["chosen"] = plan.chosen().kind;
  return j;
}

}  // namespace

json plan_json(const ScenePlan& scene) {
  json all{{"program", "plumb plan"},
           {"version", check_environment().version},
           {"compiler", check_environment().compiler},
           {"lattice", json_of(scene.lattice())},
           {"meshes", json::array()},
           {"classics", json::array()},
           {"predicates", json::array()},
           {"lattices", json::array()},
           {"bounds", json::array()},
           {"trees", json::array()},
           {"tree_volumes", json::array()}};
  for (std::size_t i = 0; i < scene.names.size(); ++i) {
    json alone = json::array();
    for (const CatalogEntry& e : classics())
      alone.push_back(
          {{"predicate", e.name}, {"plan", to_string(arithmetic_of(e.planned_bits, scene.lattices[i].bits))}});
    all["meshes"].push_back({{"name", scene.names[i]},
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
  for (const BoundPlan& b : scene.bounds) all["bounds"].push_back(json_of(b));
  for (std::size_t i = 0; i < scene.trees.size(); ++i) {
    all["trees"].push_back(json_of(scene.trees[i]));
    all["trees"].back()["mesh"] = scene.names[i];
    all["tree_volumes"].push_back(json_of(scene.volumes[i]));
    all["tree_volumes"].back()["mesh"] = scene.names[i];
  }
  return all;
}

}  // namespace plumb::tool
