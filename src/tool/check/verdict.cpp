#include "tool/check/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "certify/catalog.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

/// What may be wrong with a mesh, how often it is, and how it is mended; one that needs no mending has no mend.
struct Defect {
  std::uint64_t count;
  std::string_view one, many, mend;
};

std::vector<Defect> defects_of(const MeshCheck& c) {
  const MeshStatistics& m = c.statistics;
  const std::array<Defect, 12> all{{
      {m.zero_area_faces, "triangle of zero area", "triangles of zero area", "collapse triangles of zero area"},
      {m.repeated_vertices, "repeated vertex", "repeated vertices", "weld repeated vertices"},
      {m.boundary_edges, "open edge", "open edges", "close open edges"},
      {m.non_manifold_edges, "edge of more than two faces", "edges of more than two faces",
       "split edges of more than two faces"},
      {m.inconsistent_edges, "edge whose faces are wound against each other",
       "edges whose faces are wound against each other", "wind neighbors alike"},
      {c.surface.inside_out ? 1U : 0U, "surface wound inside out", "", "turn all triangles"},
      {c.surface.met.overlapping, "pair of triangles that overlap", "pairs of triangles that overlap",
       "part triangles that overlap (`plumb intersect --obj` shows them)"},
      {c.surface.met.touching, "pair of triangles that touch", "pairs of triangles that touch",
       m.repeated_vertices != 0 ? "" : "part triangles that touch (`plumb intersect --obj` shows them)"},
      {c.bent_faces, "polygon whose corners lie in no one plane", "polygons whose corners lie in no one plane",
       "export triangles, not polygons"},
      {c.load.dropped_faces, "face of fewer than three corners", "faces of fewer than three corners", ""},
      {c.load.fans, "polygon that crosses itself", "polygons that cross themselves",
       "redraw polygons that cross themselves"},
      {m.unused_vertices, "unused vertex", "unused vertices", ""},
  }};
  std::vector<Defect> found;
  for (const Defect& d : all)
    if (d.count != 0) found.push_back(d);
  return found;
}

/// The predicates that the method takes wrong at times.
std::string wrong_predicates(const MeshCheck& c, std::size_t method) {
  std::vector<std::string_view> wrong;
  for (const CatalogEntry& entry : classics())
    if (c.of_predicate(entry.name).method[method].wrong() != 0) wrong.push_back(entry.name);
  return wrong.size() == classics().size() ? "all predicates" : fmt::format("{}", fmt::join(wrong, ", "));
}

}  // namespace

std::string mesh_verdict(const MeshCheck& c) {
  std::vector<std::string> said;
  for (const Defect& d : defects_of(c)) said.push_back(plural(d.count, d.one, d.many));
  if (said.empty()) return "nothing";
  return fmt::format("{}", fmt::join(said, "; "));
}

std::string float_verdict(const MeshCheck& c) {
  const Comparison total = c.total();
  std::vector<std::string> wrong;
  std::vector<std::string_view> right;
  for (std::size_t m = 0; m < method_count; ++m) {
    if (!is_asked(m, Asked::inexact)) continue;
    const Tally& t = total.method[m];
    if (t.wrong() == 0) {
      right.push_back(method_names[m]);
    } else {
      wrong.push_back(fmt::format("{} {} ({})", method_names[m], percent(t.wrong(), t.taken), wrong_predicates(c, m)));
    }
  }
  const std::string asked =
      fmt::format("{} decisions{}", grouped(total.sampled()), c.is_sampled() ? ", a sample over the whole mesh" : "");
  if (wrong.empty()) return fmt::format("no method took a wrong sign in {}", asked);
  return fmt::format("wrong signs in {}: {}; none: {}", asked, fmt::join(wrong, ", "), fmt::join(right, ", "));
}

std::string advice(const MeshCheck& c) {
  std::vector<std::string> said;
  for (const Defect& d : defects_of(c))
    if (!d.mend.empty()) said.emplace_back(d.mend);
  const Comparison total = c.total();
  const auto errs = [&](std::string_view method) { return total.method[method_number(method)].wrong() != 0; };
  const double plain = total.method[method_number("double")].nanoseconds;
  const std::string cost =
      plain > 0 ? fmt::format(" ({:.1f} times the time of double)", total.judge_nanoseconds / plain) : "";
  if (total.sampled() == 0) {
    said.emplace_back("nothing can be decided on it");
  } else if (errs("double")) {
    said.push_back("take signs exactly" + cost);
  } else if (errs("float32")) {
    said.push_back("do not decide in float32; double was right here, exact signs are certain" + cost);
  } else if (errs("absolute") || errs("relative")) {
    said.push_back("decide without an epsilon; exact signs are certain" + cost);
  } else {
    said.push_back("any arithmetic did here; exact signs are certain" + cost);
  }
  return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace plumb::tool
