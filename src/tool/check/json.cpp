#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "certify/catalog.hpp"
#include "plumb/certify/environment.hpp"
#include "tool/check/command.hpp"
#include "tool/check/report.hpp"
#include "tool/check/verdict.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json json_of(std::string_view method, const Tally& t) {
  json j{{"method", method},
         {"decisions", t.taken},
         {"wrong", t.wrong()},
         {"opposite", t.opposite},
         {"zeros_missed", t.zeros_missed},
         {"zeros_invented", t.zeros_invented},
         {"unsure", t.unsure},
         {"decision_ns", t.ns_per_decision()}};
  if (t.worst.badness >= 0) {
    j["worst"] = {{"case", t.worst.case_line},
                  {"kind", kinds[static_cast<std::size_t>(t.worst.kind)].name},
                  {"claimed", t.worst.claimed},
                  {"distance_in_magnitudes", t.worst.badness}};
  }
  return j;
}

json json_of(const Comparison& c) {
  json j{{"decisions", c.taken()}, {"methods", json::array()}, {"stages", json::object()}};
  for (std::size_t m = 0; m < method_count; ++m) j["methods"].push_back(json_of(method_names[m], c.method[m]));
  for (std::size_t i = 0; i < stage_names.size(); ++i) j["stages"][std::string(stage_names[i])] = c.stages.count[i];
  if (c.verified != 0) j["verified"] = {{"decisions", c.verified}, {"wrong", c.refuted}};
  return j;
}

json json_of(const PassedOver& p) {
  json j{{"what", p.what}, {"count", p.count}, {"first", p.first}};
  if (p.line) j["line"] = *p.line;
  if (p.byte) j["byte"] = *p.byte;
  return j;
}

json json_of(const LoadReport& l) {
  json passed_over = json::array();
  for (const PassedOver& p : l.passed_over) passed_over.push_back(json_of(p));
  return {{"format", name_of(l.format)},
          {"encoding", name_of(l.encoding)},
          {"bytes", l.bytes},
          {"packed_bytes", l.packed_bytes},
          {"vertices", l.vertices},
          {"faces", l.faces},
          {"polygons", l.polygons},
          {"fans", l.fans},
          {"dropped_faces", l.dropped_faces},
          {"merged_vertices", l.merged_vertices},
          {"decimals", l.decimals},
          {"inexact_decimals", l.inexact_decimals},
          {"largest_move", l.largest_move},
          {"passed_over_text", std::move(passed_over)},
          {"unit", l.unit},
          {"parts", l.parts},
          {"transformed_coordinates", l.transformed},
          {"rounded_coordinates", l.rounded}};
}

json json_of(const MeshStatistics& m) {
  return {{"edges", m.edges},
          {"boundary_edges", m.boundary_edges},
          {"interior_edges", m.interior_edges},
          {"non_manifold_edges", m.non_manifold_edges},
          {"inconsistent_edges", m.inconsistent_edges},
          {"repeated_vertices", m.repeated_vertices},
          {"unused_vertices", m.unused_vertices},
          {"repeated_corners", m.repeated_corners},
          {"zero_area_triangles", m.zero_area_faces}};
}

/// Of more shells the rest is left out: of a mesh without shared vertices every triangle is one.
constexpr std::size_t most_shells = 1000;

json json_of(std::size_t number, const Shell& s) {
  return {{"shell", number},
          {"first_triangle", s.first_triangle},
          {"triangles", s.triangles},
          {"closed", s.closed},
          {"oriented", s.oriented},
          {"volume", s.volume ? json(*s.volume) : json()},
          {"volume_sign", static_cast<int>(s.volume_sign)},
          {"depth", s.depth},
          {"parent", s.parent ? json(*s.parent) : json()},
          {"inside_out", s.inside_out()},
          {"internal_wall", s.wall},
          {"meets_another", s.meets},
          {"crosses_another", s.crosses}};
}

json shells_of(const SurfaceFaults& s) {
  json shells = json::array();
  for (const std::size_t i : shown_shells(s, most_shells)) shells.push_back(json_of(i, s.shells[i]));
  return shells;
}

json json_of(const SurfaceFaults& s) {
  json j{{"closed", s.closed},
         {"oriented", s.oriented},
         {"inside_out", s.inside_out()},
         {"self_intersecting", s.meets_itself()},
         {"touching", s.met.touching},
         {"overlapping", s.met.overlapping},
         {"degenerate_triangles", s.degenerate},
         {"shell_count", s.shells.size()},
         {"closed_shells", s.closed_shells},
         {"inside_out_shells", s.inside_out_shells},
         {"crossing_shells", s.crossing_shells},
         {"internal_walls", s.internal_walls},
         {"non_manifold_vertices", s.non_manifold_vertices},
         {"vertices_on_edges", s.vertices_on_edges},
         {"duplicate_triangles", s.duplicate_triangles},
         {"opposite_triangles", s.opposite_triangles}};
  if (s.nearer_than) {
    j["nearer_than"] = *s.nearer_than;
    j["close_vertices"] = s.close_vertices;
  }
  return j;
}

json json_of(const Lattice& lattice) { return {{"exponent", lattice.exponent}, {"bits", lattice.bits}}; }

json json_of(const MeshCheck& c) {
  json j{{"mesh", c.name},
         {"vertices", c.statistics.vertices},
         {"triangles", c.statistics.faces},
         {"closed", c.surface.closed},
         {"verdict",
          {{"surface_is", surface_verdict(c.surface)},
           {"faults", mesh_verdict(c)},
           {"floats", float_verdict(c)},
           {"advice", advice(c)}}},
         {"surface", json_of(c.surface)},
         {"shells", shells_of(c.surface)},
         {"statistics", json_of(c.statistics)},
         {"bent_faces", c.bent_faces},
         {"lattice", json_of(c.lattice)},
         {"edge_bends",
          {{"convex_edges", c.edges.convex}, {"flat_edges", c.edges.flat}, {"reflex_edges", c.edges.reflex}}},
         {"total", json_of(c.total())},
         {"predicates", json::array()},
         {"kinds", json::array()}};
  if (c.is_sampled()) {
    const Comparison total = c.total();
    j["sample"] = {{"of_each_kind", c.sampled_of_kind}, {"decisions", total.sampled()}, {"of", total.taken()}};
  }
  if (c.from_file) j["load"] = json_of(c.load);
  for (const CatalogEntry& entry : classics()) {
    json p = json_of(c.of_predicate(entry.name));
    p["predicate"] = entry.name;
    j["predicates"].push_back(std::move(p));
  }
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    json kind = json_of(c.kind[k]);
    kind["kind"] = kinds[k].name;
    kind["predicate"] = kinds[k].predicate;
    kind["question"] = kinds[k].question;
    j["kinds"].push_back(std::move(kind));
  }
  return j;
}

}  // namespace

json json_report(std::span<const MeshCheck> checks, const ReportInputs& inputs, unsigned threads) {
  json j = origin_json("plumb check");
  j["sound"] = check_environment().sound();
  j["threads"] = threads;
  j["meshes"] = json::array();
  j["passed_over"] = inputs.passed_over;
  j["not_read"] = json::array();
  for (const UnreadMesh& m : inputs.unread) j["not_read"].push_back({{"mesh", m.name}, {"error", m.why}});
  for (const MeshCheck& c : checks) j["meshes"].push_back(json_of(c));
  return j;
}

}  // namespace plumb::tool
