#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certify/catalog.hpp"
#include "tool/check/command.hpp"
#include "tool/check/report.hpp"
#include "tool/check/verdict.hpp"
#include "tool/mesh/load_text.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string file_lines(const MeshCheck& c) {
  if (!c.from_file) return "  the embedded part; `plumb check --write-sample FILE` writes it\n";
  return load_text(c.load);
}

std::string lattice_line(const Lattice& lattice) {
  return fmt::format("  lattice     multiples of 2^{} of {} bits; `plumb plan` says what that saves\n",
                     lattice.exponent, lattice.bits);
}

std::string sample_line(const MeshCheck& c) {
  if (!c.is_sampled()) return {};
  const Comparison total = c.total();
  return fmt::format(
      "  sample      plan and exact took all {} decisions, the others {}: at most {} of each kind, drawn over the\n"
      "              whole mesh; --all asks all\n",
      grouped(total.taken()), grouped(total.sampled()), grouped(c.sampled_of_kind));
}

std::string defect_lines(const MeshStatistics& m) {
  std::string s;
  const auto line = [&](std::uint64_t n, std::string_view one, std::string_view many) {
    if (n != 0) s += fmt::format("{}{}\n", s.empty() ? "  defects     " : "              ", plural(n, one, many));
  };
  line(m.repeated_vertices, "repeated vertex", "repeated vertices");
  line(m.zero_area_faces, "triangle of exactly zero area", "triangles of exactly zero area");
  line(m.repeated_corners, "triangle that names a vertex twice", "triangles that name a vertex twice");
  line(m.non_manifold_edges, "edge of more than two faces", "edges of more than two faces");
  line(m.inconsistent_edges, "edge whose two faces are wound against each other",
       "edges whose two faces are wound against each other");
  line(m.boundary_edges, "boundary edge", "boundary edges");
  line(m.unused_vertices, "unused vertex", "unused vertices");
  return s.empty() ? fmt::format("  defects     none\n") : s;
}

std::string stage_line(const StageCounts& stages) {
  std::string s;
  for (std::size_t i = 0; i < stage_names.size(); ++i) {
    if (stages.count[i] == 0) continue;
    s += fmt::format("{}{} {}", s.empty() ? "" : ", ", stage_names[i], percent(stages.count[i], stages.total()));
  }
  return s;
}

std::string table(std::string_view predicate, const Comparison& c, const Style& style) {
  if (c.taken() == 0) return {};
  std::string s =
      style.bold(fmt::format("  {:<12}{:>12}{:>12}{:>11}{:>12}{:>12}{:>12}{:>10}{:>10}\n", predicate, "decisions",
                             "wrong", "share", "opposite", "missed 0", "invented 0", "unsure", "ns"));
  for (std::size_t m = 0; m < method_count; ++m) {
    const Tally& t = c.method[m];
    const std::string row =
        fmt::format("    {:<12}{:>10}{:>12}{:>11}{:>12}{:>12}{:>12}{:>10}{:>10.1f}\n", method_names[m],
                    grouped(t.taken), grouped(t.wrong()), percent(t.wrong(), t.taken), grouped(t.opposite),
                    grouped(t.zeros_missed), grouped(t.zeros_invented), grouped(t.unsure), t.ns_per_decision());
    s += t.wrong() != 0 ? style.red(row) : row;
  }
  return s + style.dim(fmt::format("    exact decided by: {}\n", stage_line(c.stages)));
}

std::string legend(const Style& style) {
  return style.dim(
      "  wrong: not the exact sign; that is opposite (+ for -, or - for +), missed 0 (a sign, where the points are "
      "exactly\n"
      "  degenerate) or invented 0 (the other way round).  unsure: the method declines to answer.  ns: time a "
      "decision\n");
}

std::string worst_lines(const Comparison& total, const Style& style) {
  std::string s;
  for (std::size_t m = 0; m < method_count; ++m) {
    const WorstCase& w = total.method[m].worst;
    if (w.badness < 0) continue;
    s += fmt::format("    {}, {}: it says {:.6g}\n      {}\n", style.bold(method_names[m]),
                     kinds[static_cast<std::size_t>(w.kind)].name,
                     std::isnan(w.claimed) ? std::fabs(w.claimed) : w.claimed, w.case_line);
  }
  return s.empty() ? s : fmt::format("  worst case of each method, as `plumb sign` takes it\n{}", s);
}

std::string verification_line(const Comparison& total, const Style& style) {
  if (total.verified == 0) return {};
  const std::string which = total.verified == total.taken() ? "all of them" : "a sample, evenly spread";
  const std::string s = fmt::format("  verified    {} of {} exact signs taken again in rationals ({}): {} wrong\n",
                                    grouped(total.verified), grouped(total.taken()), which, grouped(total.refuted));
  return total.refuted == 0 ? style.green(s) : style.red(s);
}

std::string tables(std::span<const MeshCheck> checks, const Style& style) {
  std::string s;
  for (const CatalogEntry& entry : classics()) {
    Comparison sum;
    for (const MeshCheck& c : checks) sum += c.of_predicate(entry.name);
    s += table(entry.name, sum, style);
  }
  return s;
}

}  // namespace

std::string text_opening(const MeshCheck& c, const Style& style) {
  return style.bold(printable(c.name)) + "\n" +
         fmt::format("  surface     {}\n  wrong       {}\n", surface_verdict(c.surface), mesh_verdict(c));
}

std::string text_brief(const MeshCheck& c) {
  const std::string wrong = mesh_verdict(c);
  return fmt::format("{}: {}; {}\n", printable(c.name), surface_verdict(c.surface),
                     wrong == "nothing" ? "nothing wrong" : wrong);
}
std::string text_brief(const UnreadMesh& m) {
  return fmt::format("{}: not read: {}\n", printable(m.name), printable(m.why));
}

std::string text_unread(std::span<const UnreadMesh> unread) {
  if (unread.empty()) return {};
  std::string s = plural(unread.size(), "mesh was", "meshes were") + " not read\n";
  for (const UnreadMesh& m : unread) s += "  " + printable(m.why) + "\n";
  return s;
}

std::string text_verdict(const MeshCheck& c) {
  return fmt::format("  in floats   {}\n  to do       {}\n\n", float_verdict(c), advice(c));
}

std::string text_tables(const MeshCheck& c, const Style& style) {
  const MeshStatistics& m = c.statistics;
  std::string s = file_lines(c);
  s += fmt::format("  mesh        {}, {}, {}\n", plural(m.vertices, "vertex", "vertices"),
                   plural(m.faces, "triangle", "triangles"), plural(m.edges, "edge", "edges"));
  const std::string shells = surface::shell_lines(c.surface, "              ", "; --json lists them");
  if (!shells.empty()) s += "  shells      " + shells;
  s += defect_lines(m);
  s += fmt::format("  edges       of {} interior: {} convex, {} exactly flat, {} reflex\n", grouped(m.interior_edges),
                   grouped(c.edges.convex), grouped(c.edges.flat), grouped(c.edges.reflex));
  s += lattice_line(c.lattice) + sample_line(c) + "\n" + legend(style) + tables({&c, 1}, style) + "\n";
  const Comparison total = c.total();
  return s + worst_lines(total, style) + verification_line(total, style);
}

std::string text_total(std::span<const MeshCheck> checks, const Style& style) {
  Comparison total;
  for (const MeshCheck& c : checks) total += c.total();
  return style.bold(fmt::format("all {} meshes\n", checks.size())) + tables(checks, style) +
         verification_line(total, style);
}

}  // namespace plumb::tool
