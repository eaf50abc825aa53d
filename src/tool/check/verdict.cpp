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
  std::string one, many, mend;
};

/// Times are medians over blocks of 1024 decisions: of fewer than ten of these a ratio is noise.
constexpr std::uint64_t least_timed = 10 * 1024;

/// What mends each kind of fault, in their order.  What mends the one may mend the others.
std::array<std::string, surface::fault_kinds> mends_of(const MeshStatistics& m, const SurfaceFaults& s) {
  const bool more_faces = s.duplicate_triangles + s.opposite_triangles + s.internal_walls != 0;
  const bool more_opens = s.vertices_on_edges + s.internal_walls != 0;
  return {
      "collapse triangles of zero area",
      "weld repeated vertices",
      "weld vertices that are too close",
      "leave out duplicate triangles",
      "leave out triangles opposite to others (both, where two solids meet there)",
      "leave out walls inside of solids",
      s.internal_walls == 0 ? "divide edges where a vertex is on them" : "divide edges where a vertex is left on them",
      s.open_edges_of_others == 0 ? ""
      : more_opens                ? "close open edges that are left"
                                  : "close open edges",
      more_faces ? "split edges of more than two faces that are left" : "split edges of more than two faces",
      "split non-manifold vertices, one for each fan",
      "wind neighbors alike",
      turning_advice(s),
      "unite shells that cross (`plumb resolve`), or part them",
      "part triangles that overlap (`plumb intersect --obj` shows them)",
      m.repeated_vertices != 0 ? "" : "part triangles that touch (`plumb intersect --obj` shows them)",
      ""};
}

/// The surface's faults, and before unused vertices those of the polygons that were read.
std::vector<Defect> defects_of(const MeshCheck& c) {
  const auto counted = surface::counted_faults(c.surface, c.statistics);
  const auto mends = mends_of(c.statistics, c.surface);
  std::vector<Defect> found;
  const auto add = [&found](Defect d) {
    if (d.count != 0) found.push_back(std::move(d));
  };
  for (std::size_t k = 0; k < counted.size(); ++k) {
    if (k == static_cast<std::size_t>(surface::FaultKind::unused_vertex)) {
      add({c.bent_faces, "polygon whose corners lie in no one plane", "polygons whose corners lie in no one plane",
           "export triangles, not polygons"});
      add({c.load.dropped_faces, "face of fewer than three corners", "faces of fewer than three corners", ""});
      add({c.load.fans, "polygon that crosses itself", "polygons that cross themselves",
           "redraw polygons that cross themselves"});
    }
    add({counted[k].count, counted[k].one, counted[k].many, mends[k]});
  }
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
  const std::string cost = plain > 0 && total.sampled() >= least_timed
                               ? fmt::format(" ({:.1f} times the time of double)", total.judge_nanoseconds / plain)
                               : "";
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
