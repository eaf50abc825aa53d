#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

constexpr std::int64_t most_vertices = std::int64_t{1} << 32;

// A corner may name a vertex that the file defines further down; whether it does is known at the end.
struct ForwardReference {
  std::int64_t vertex;  // from 1
  std::uint64_t line;
};

std::string bad_vertex(std::int64_t vertex, std::size_t vertices) {
  const std::string count = std::to_string(vertices);
  if (vertex == 0) return "the face names vertex 0, expected numbers from 1 in OBJ; add 1 to every index";
  if (vertex < 0)
    return "the face names vertex " + std::to_string(vertex) + ", expected at least -" + count +
           ", for only so many vertices stand before it; renumber the face";
  return "the face names vertex " + std::to_string(vertex) + ", but the file has " + count + ", expected 1 to " +
         count + " or, counted backwards, -1 and below; renumber the face or restore the vertices";
}

// The i of i, i/j, i//k or i/j/k; to a lenient reading, which tells, also of those with nothing behind a slash.
std::int64_t corner_vertex(Parse& parse, const TextLines& lines, std::string_view token) {
  std::int64_t vertex = 0, other = 0;
  std::string_view rest = token;
  for (int part = 0; part < 3; ++part) {
    const auto slash = std::min(rest.find('/'), rest.size());
    const bool last = slash == rest.size();
    const bool may_be_empty = part == 1 && !last, ends_early = part > 0 && last && slash == 0;
    if (ends_early && parse.lenient()) {
      parse.pass_over_in_line("corners with nothing behind a slash", lines.line(), token);
      return vertex;
    }
    if (!read_integer(rest.substr(0, slash), part == 0 ? vertex : other) && !(may_be_empty && slash == 0)) break;
    if (last) return vertex;
    rest.remove_prefix(slash + 1);
  }
  lines.fail(MeshFileProblem::syntax, "the corner is " + in_quotes(token) +
                                          ", expected whole numbers as in 7, 7/1, 7//2 or 7/1/2; mend the face");
}

void read_face(Parse& parse, TextLines& lines, std::vector<ForwardReference>& forward) {
  auto& mesh = parse.mesh;
  const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
  std::string_view token = lines.require_token("the face's first corner");
  for (; !token.empty(); token = lines.next_token()) {
    const std::int64_t vertex = corner_vertex(parse, lines, token);
    if (vertex == 0 || vertex < -vertices || vertex > most_vertices)
      lines.fail(MeshFileProblem::bad_index, bad_vertex(vertex, mesh.vertices.size()));
    if (vertex > vertices) forward.push_back({vertex, lines.line()});
    mesh.corners.push_back(static_cast<std::uint32_t>(vertex < 0 ? vertices + vertex : vertex - 1));
  }
  parse.end_face();
}

// Statements that say nothing of where a polygon's corners are.  Those that would add to the surface are not among them
// (curves, surfaces, patches, files called), so that what is lost with them is told.
bool is_other_statement(std::string_view word) {
  constexpr std::array<std::string_view, 30> words{
      "vn",   "vt",    "vp",       "s",        "l",   "p",      "usemtl", "mtllib", "usemap",    "maplib",
      "mg",   "bevel", "c_interp", "d_interp", "lod", "cstype", "deg",    "bmat",   "step",      "parm",
      "trim", "hole",  "scrv",     "sp",       "end", "con",    "ctech",  "stech",  "trace_obj", "shadow_obj"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

// A name that ends in a backslash, as a folder's may, takes the next line for a part of it.
bool is_name(std::string_view word) {
  constexpr std::array<std::string_view, 5> words{"g", "o", "usemtl", "mtllib", "usemap"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Behind the coordinates there may be a weight, a color, or a color and one more.
void read_vertex(Parse& parse, TextLines& lines) {
  parse.mesh.vertices.push_back(lines.point(parse.decimals));
  if (lines.at_line_end()) return;
  const TextLines::Words behind = lines.words_left();
  if (!behind.numbers || (behind.count != 1 && behind.count != 3 && behind.count != 4))
    parse.pass_over_in_line("texts behind a vertex that are no weight and no color", lines.line(), behind.text);
}

}  // namespace

void parse_obj(Parse& parse) {
  TextLines lines(parse.bytes, parse.file, {.comments = true, .continuations = true});
  std::vector<ForwardReference> forward;
  while (lines.next_line()) {
    const std::string_view keyword = lines.next_token();
    if (keyword == "v") {
      read_vertex(parse, lines);
    } else if (keyword == "f" || keyword == "fo") {
      read_face(parse, lines, forward);
    } else if (is_name(keyword) && lines.is_joined()) {
      parse.pass_over_in_line("lines joined to a name by a backslash", lines.line(), lines.rest());
    } else if (keyword == "o" || keyword == "g") {
      parse.begin_part(keyword == "o" ? FileParts::Kind::object : FileParts::Kind::group, lines.rest());
    } else if (!is_other_statement(keyword)) {
      if (keyword.find('\0') != std::string_view::npos)
        lines.fail(MeshFileProblem::syntax, "found binary data " + in_quotes(keyword) +
                                                ", expected the text of an OBJ file; give the file's right name");
      const std::string_view rest = lines.rest();
      parse.pass_over_in_line(
          "lines that are no statement of OBJ", lines.line(),
          {keyword.data(), rest.empty() ? keyword.data() + keyword.size() : rest.data() + rest.size()});
    }
  }
  const auto vertices = parse.mesh.vertices.size();
  for (const auto& reference : forward)
    if (static_cast<std::uint64_t>(reference.vertex) > vertices)
      fail_at_line(MeshFileProblem::bad_index, parse.file, reference.line, bad_vertex(reference.vertex, vertices));
}

}  // namespace plumb::surface
