#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certify/catalog.hpp"
#include "tool/plan/command.hpp"
#include "tool/plan/lattice_savings.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string heading(const ScenePlan& scene, const Style& style) {
  std::string s;
  for (std::size_t i = 0; i < scene.names.size(); ++i) {
    s += style.bold(printable(scene.names[i])) +
         fmt::format(": {} vertices, {} triangles", scene.vertices[i], scene.triangles[i]);
    if (scene.names.size() > 1)
      s += fmt::format("; alone multiples of 2^{} of {} bits", scene.lattices[i].exponent, scene.lattices[i].bits);
    s += '\n';
  }
  return s;
}

/// What a mesh would need less than the scene, where it would.
std::string less_alone(const ScenePlan& scene) {
  std::string s;
  for (std::size_t i = 0; i < scene.names.size() && scene.names.size() > 1; ++i) {
    std::string cheaper;
    for (const CatalogEntry& e : classics()) {
      const Arithmetic alone = arithmetic_of(e.planned_bits, scene.lattices[i].bits);
      if (alone < arithmetic_of(e.planned_bits, scene.lattice().bits))
        cheaper += fmt::format("{}{}: {}", cheaper.empty() ? "" : "; ", e.name, to_string(alone));
    }
    if (!cheaper.empty()) s += fmt::format("  alone, {} needs less: {}\n", printable(scene.names[i]), cheaper);
  }
  return s;
}

std::string time(double ns) { return ns == 0 ? std::string(1, '-') : fmt::format("{:.1f}", ns); }

std::string predicates(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("  {:<10}{:<31}{:<43}{:>7}{:>8}{:>8}{:>8}  {}\n", "", "least exact arithmetic",
                                         "plan", "bare ns", "decide", "batch", "plan", "take"));
  const std::vector<Saving> savings = lattice_savings(scene.lattice());
  for (std::size_t k = 0; k < savings.size(); ++k) {
    const DecisionTimes& t = scene.rows[0].times[k];
    s += fmt::format("  {:<10}{:<31}{:<43}{:>7}{:>8}{:>8}{:>8}  {}\n", savings[k].predicate,
                     fmt::format("{} ({} bits)", savings[k].suffices, savings[k].value_bits), savings[k].plan,
                     time(t.plain), time(t.decide), time(t.batch), time(t.plan), t.taken());
    if (!savings[k].skips.empty()) s += style.dim(fmt::format("  {:<10}never needs {}\n", "", savings[k].skips));
  }
  std::array<std::size_t, arithmetic_count> needs{};
  for (const CatalogEntry& e : catalog())
    ++needs[static_cast<std::size_t>(arithmetic_of(e.planned_bits, scene.lattice().bits))];
  s += fmt::format("  of all {} predicates", catalog().size());
  for (std::size_t a = 0; a < needs.size(); ++a) {
    if (needs[a] != 0)
      s += fmt::format("{} {}: {}", s.ends_with("predicates") ? "," : ";", to_string(static_cast<Arithmetic>(a)),
                       needs[a]);
  }
  return s + '\n';
}

std::string whole_manifest(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("\n  {:<28}{:>10}  {}\n", "predicate", "value bits", "plan"));
  for (const CatalogEntry& e : catalog()) {
    s += fmt::format("  {:<28}{:>10}  {}\n", e.name,
                     e.homogeneous ? std::to_string(e.value_bits(scene.lattice().bits)) : std::string(1, '-'),
                     to_string(arithmetic_of(e.planned_bits, scene.lattice().bits)));
  }
  return s;
}

std::string lattices(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("\n  {:>4} {:<8}{:<24}{:>8}{:>10}{:>12}", "bits", "step", "greatest move",
                                         "merged", "collapsed", "turned over"));
  for (const CatalogEntry& e : classics()) s += style.bold(fmt::format("  {:>15}", e.name));
  s += '\n';
  for (const ScenePlanRow& row : scene.rows) {
    const bool given = row.damage.empty();
    s += fmt::format("  {:>4} {:<8}{:<24}", row.bits, fmt::format("2^{}", row.exponent),
                     given ? std::string("as given") : fmt::format("{}", row.greatest_move()));
    s += given ? fmt::format("{:>8}{:>10}{:>12}", "", "", "")
               : fmt::format("{:>8}{:>10}{:>12}", row.merged(), row.collapsed(), row.turned_over());
    for (std::size_t k = 0; k < row.times.size(); ++k) {
      const DecisionTimes& t = row.times[k];
      const std::string cell =
          fmt::format("  {:>15}", t.plan_pays() ? fmt::format("{} {}", short_name(row.arithmetic[k]), time(t.plan))
                                                : fmt::format("decide {}", time(t.decide)));
      s += t.plan_pays() && row.arithmetic[k] < scene.rows[0].arithmetic[k] ? style.green(cell) : cell;
    }
    s += '\n';
  }
  if (scene.rows.size() == 1) return s;
  return s +
         style.dim(
             "  move: of a coordinate, exactly. merged: points that were distinct. collapsed: to zero area. turned "
             "over: by more\n  than a right angle. ns a decision, of the plan, or of decide where that took less.\n");
}

/// As much of a name as a column takes.
std::string shortened(const std::string& name) {
  std::string s = printable(name);
  return s.size() > 22 ? "..." + s.substr(s.size() - 19) : s;
}

std::string volumes(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("\n  {:<24}{:<10}{:>8}{:>10}{:>12}{:>12}\n", "bounding volume", "chosen",
                                         "test ns", "overlap", "query ns", "without ns"));
  for (const BoundPlan& b : scene.bounds) {
    const BoundRating& r = b.rated.ratings.kinds[b.chosen];
    const auto placements = static_cast<double>(b.rated.ratings.placements.size());
    s += fmt::format("  {:<24}{:<10}{:>8.1f}{:>9.1f}%{:>12.1f}{:>12.1f}\n", shortened(b.rated.name), b.taken(),
                     r.test_ns, placements == 0 ? 0 : 100 * r.overlapping / placements, b.with_ns(), b.without_ns());
  }
  return s;
}

/// "none, then linear from 12 rays on, binned from 3,400"
std::string choices(const TreePlan& plan) {
  std::string s;
  for (const TreeChoice& c : plan.choices()) {
    const std::string what(c.method ? name_of(*c.method) : "none");
    // Beyond 2^53 nobody asks.
    const auto from = static_cast<std::uint64_t>(std::ceil(std::min(c.from, 0x1p53)));
    if (s.empty())
      s = what;
    else
      s += fmt::format(", {} from {}{}", what, grouped(from), s.find(',') == std::string::npos ? " rays on" : "");
  }
  return s;
}

std::string trees(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("\n  {:<24}{:<10}{:>10}{:>10}{:>12}{:>12}\n", "tree of boxes", "method",
                                         "build ms", "bytes", "ray ns", "nearest ns"));
  for (std::size_t i = 0; i < scene.trees.size(); ++i) {
    const TreePlan& plan = scene.trees[i];
    if (plan.trees.empty()) continue;
    s += fmt::format("  {:<24}{:<10}{:>10}{:>10}{:>12}\n", shortened(scene.names[i]), "none", "", "",
                     three_digits(plan.ray_ns_without));
    for (const TreeTimes& t : plan.trees) {
      s += fmt::format("  {:<24}{:<10}{:>10}{:>10.1f}{:>12}{:>12}\n", "", name_of(t.method), three_digits(t.build_ms),
                       t.bytes, three_digits(t.ray_ns), three_digits(t.nearest_ns));
    }
    s += fmt::format("  {:<24}take {}\n", "", choices(plan));
    if (plan.rays_in_plane)
      s += style.dim(
          fmt::format("  {:<24}the mesh is flat, and so these rays lie in its plane; others take less\n", ""));
  }
  return s;
}

std::string tree_volumes(const ScenePlan& scene, const Style& style) {
  std::string s = style.bold(fmt::format("\n  {:<24}{:<10}{:>10}{:>14}{:>16}{:>12}\n", "volumes of a tree", "kind",
                                         "build ms", "volume tests", "triangle pairs", "query ms"));
  for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
    const VolumePlan& plan = scene.volumes[i];
    for (const VolumeTimes& t : plan.kinds) {
      const bool own = &t == &plan.kinds.front(), taken = &t == &plan.chosen();
      s += fmt::format("  {:<24}{:<10}{:>10}{:>14}{:>16}{:>12}{}\n", own ? shortened(scene.names[i]) : "", t.kind,
                       own ? "" : three_digits(t.build_ms), own ? "" : grouped(t.work.volume_tests),
                       own ? "" : grouped(t.work.triangle_pairs), three_digits(t.query_ms), taken ? "  take" : "");
    }
    for (const std::string_view kind : plan.left_out)
      s += fmt::format("  {:<24}{:<10}its volumes are beyond the doubles\n", "", kind);
  }
  return s;
}

}  // namespace

std::string plan_text(const ScenePlan& scene, bool all, const Style& style) {
  const Lattice lattice = scene.lattice();
  std::string s = heading(scene, style);
  s += fmt::format("  {}: multiples of 2^{} of {} bits\n", scene.names.size() > 1 ? "the scene" : "coordinates",
                   lattice.exponent, lattice.bits);
  s += less_alone(scene) + '\n' + predicates(scene, style);
  if (all) s += whole_manifest(scene, style);
  return s + lattices(scene, style) + volumes(scene, style) + trees(scene, style) + tree_volumes(scene, style);
}

}  // namespace plumb::tool
