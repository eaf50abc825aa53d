#include "surface/topology/fault_words.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "arith/number_words.hpp"

namespace plumb::surface {

using arith::grouped, arith::plural;

namespace {

/// As short as it reads back, and without an exponent where readers want none.
std::string decimal_words(double x) {
  const double size = std::fabs(x);
  const bool is_plain = size == 0 || (size >= 1e-4 && size < 1e16);
  std::array<char, 64> text{};
  char* const end = std::to_chars(text.data(), text.data() + text.size(), x,
                                  is_plain ? std::chars_format::fixed : std::chars_format::scientific)
                        .ptr;
  return {text.data(), end};
}

std::string meeting_words(const SurfaceFaults& f) {
  if (!f.meets_itself()) return "free of self-intersections";
  std::string said = f.met.overlapping != 0 ? "self-intersecting" : "touching itself";
  if (f.met.touching != 0 && f.repeated_vertices != 0) {
    said += " (" + plural(f.repeated_vertices, "vertex lies", "vertices lie") +
            " where another is: triangles that meet there share none, and touch)";
  }
  return said;
}

std::string orientation_words(const SurfaceFaults& f) {
  if (!f.oriented) return "not oriented";
  if (!f.inside_out()) return "oriented";
  if (f.inside_out_shells == f.shells.size()) return "oriented inward";
  return "oriented but for " + plural(f.inside_out_shells, "shell that is inside out", "shells that are inside out");
}

/// Whether it is closed, its volume, where it lies, and what is wrong with it.
std::string shell_words(const Shell& s) {
  std::string text =
      plural(s.triangles, "triangle", "triangles") + " from " + std::to_string(s.first_triangle) + " on, ";
  text += !s.closed ? "open" : s.volume ? "closed, volume " + decimal_words(*s.volume) : "closed, not oriented";
  if (s.parent) text += ", in shell " + std::to_string(*s.parent);
  if (s.wall) text += ", a wall inside of a solid";
  if (s.inside_out()) text += ", inside out";
  if (s.crosses) text += ", crosses another";
  if (s.meets && !s.crosses) text += ", touches another";
  return text;
}

}  // namespace

std::array<CountedFault, fault_kinds> counted_faults(const SurfaceFaults& f, const MeshStatistics& m) {
  const std::string close = f.nearer_than ? "vertices nearer than " + decimal_words(*f.nearer_than) : std::string();
  return {{
      {m.zero_area_faces, "triangle of zero area", "triangles of zero area"},
      {m.repeated_vertices, "repeated vertex", "repeated vertices"},
      {f.close_vertices, close, close},
      {f.duplicate_triangles, "duplicate triangle", "duplicate triangles"},
      {f.opposite_triangles, "triangle opposite to another", "triangles opposite to others"},
      {f.internal_walls, "wall inside of a solid", "walls inside of solids"},
      {f.vertices_on_edges, "vertex on an edge (T-junction)", "vertices on edges (T-junctions)"},
      {m.boundary_edges, "open edge", "open edges"},
      {m.non_manifold_edges, "edge of more than two faces", "edges of more than two faces"},
      {f.non_manifold_vertices, "non-manifold vertex (of several fans)", "non-manifold vertices (of several fans)"},
      {m.inconsistent_edges, "edge whose faces are wound against each other",
       "edges whose faces are wound against each other"},
      {f.inside_out_shells, "shell wound inside out", "shells wound inside out"},
      {f.crossing_shells, "shell that crosses another", "shells that cross others"},
      {f.met.overlapping, "pair of triangles that overlap", "pairs of triangles that overlap"},
      {f.met.touching, "pair of triangles that touch", "pairs of triangles that touch"},
      {m.unused_vertices, "unused vertex", "unused vertices"},
  }};
}

std::string surface_verdict(const SurfaceFaults& f) {
  if (f.triangles == 0) return "none: there are no triangles";
  return (f.shells.size() > 1 ? plural(f.shells.size(), "shell", "shells") + ", " : std::string()) +
         (f.closed ? "closed, " : "not closed, ") + orientation_words(f) + ", " + meeting_words(f) +
         (f.degenerate == 0 ? ", free of degenerate triangles" : ", with degenerate triangles");
}

std::vector<std::size_t> shown_shells(const SurfaceFaults& f, std::size_t most) {
  const auto is_faulty = [](const Shell& s) { return s.inside_out() || s.wall || s.crosses; };
  std::vector<std::size_t> shown;
  for (const bool faulty : {true, false})
    for (std::size_t i = 0; i < f.shells.size() && shown.size() < most; ++i)
      if (is_faulty(f.shells[i]) == faulty) shown.push_back(i);
  std::ranges::sort(shown);
  return shown;
}

std::string shell_lines(const SurfaceFaults& f, const std::string& indent, const std::string& rest) {
  if (f.shells.empty()) return {};
  if (f.shells.size() == 1) return "1: " + shell_words(f.shells[0]) + "\n";
  constexpr std::size_t most = 10;
  std::string s = grouped(f.shells.size()) + ", " + grouped(f.closed_shells) + " of them closed\n";
  const std::vector<std::size_t> shown = shown_shells(f, most);
  for (const std::size_t i : shown) s += indent + std::to_string(i) + ": " + shell_words(f.shells[i]) + "\n";
  if (shown.size() < f.shells.size())
    s += indent + "and " + grouped(f.shells.size() - shown.size()) + " more" + rest + "\n";
  return s;
}

std::string wrong_words(const SurfaceFaults& f, const MeshStatistics& m) {
  std::string wrong;
  for (const CountedFault& fault : counted_faults(f, m)) {
    if (fault.count != 0) wrong += (wrong.empty() ? "" : "; ") + plural(fault.count, fault.one, fault.many);
  }
  return wrong.empty() ? "nothing" : wrong;
}

}  // namespace plumb::surface
