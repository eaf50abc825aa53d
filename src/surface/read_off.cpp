#include <algorithm>
#include <array>
#include <string>

#include "surface/mesh_parsers.hpp"
#include "surface/text_lines.hpp"

namespace plumb::surface {
namespace {

struct Counts {
  std::uint64_t vertices, faces;
};

// The words and numbers before the first vertex.
Counts read_header(TextLines& lines) {
  std::string_view token = lines.next_token();
  if (const auto header = off_header(token)) {
    if (header->prefix.find_first_of("4n") != std::string_view::npos)
      lines.fail(MeshFileProblem::unsupported, "found " + in_quotes(token) +
                                                   ", expected OFF in three dimensions (OFF, COFF, NOFF, STOFF and "
                                                   "their mixtures); export three coordinates a vertex");
    token = header->count.empty() ? lines.next_token() : header->count;
    if (lower_case(token) == "binary")
      lines.fail(MeshFileProblem::unsupported, "found binary OFF, expected ASCII; export it as ASCII OFF or as PLY");
    if (token.empty()) {
      lines.require_line("the numbers of vertices and faces");
      token = lines.next_token();
    }
  }
  std::int64_t vertices = -1;
  if (!read_integer(token, vertices) || vertices < 0)
    lines.fail(MeshFileProblem::syntax,
               "found " + in_quotes(token) + ", expected OFF or the number of vertices; is this an OFF file?");
  const std::uint64_t faces = lines.count("the number of faces");
  const std::string_view edges = lines.next_token();  // nobody relies on it, and some leave it out
  std::int64_t ignored = 0;
  if (!edges.empty() && !read_integer(edges, ignored))
    lines.fail(MeshFileProblem::syntax,
               "the number of edges is " + in_quotes(edges) + ", expected a whole number; mend the line");
  return {static_cast<std::uint64_t>(vertices), faces};
}

std::string progress(std::uint64_t have, std::uint64_t of, const char* what) {
  return std::string(what) + " " + std::to_string(have + 1) + " of the " + std::to_string(of) +
         " that the header claims";
}

}  // namespace

std::optional<OffHeader> off_header(std::string_view word) {
  const auto at = lower_case(word).find("off");
  if (at == std::string::npos) return std::nullopt;
  const std::string_view prefix = word.substr(0, at), count = word.substr(at + 3);
  if (count.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  std::string_view left = prefix;
  for (const std::string_view part : std::array<std::string_view, 5>{"ST", "C", "N", "4", "n"})
    if (left.starts_with(part)) left.remove_prefix(part.size());
  if (!left.empty()) return std::nullopt;
  return OffHeader{prefix, count};
}

void parse_off(Parse& parse) {
  TextLines lines(parse.bytes, parse.file, {.comments = true});
  auto& mesh = parse.mesh;
  if (!lines.next_line()) return;
  const Counts counts = read_header(lines);
  // Six bytes a vertex, three a face is the least that they take.
  mesh.vertices.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(counts.vertices, parse.bytes.size() / 6)));
  for (std::uint64_t i = 0; i < counts.vertices; ++i) {
    lines.require_line(progress(i, counts.vertices, "vertex"));
    mesh.vertices.push_back(lines.point(parse.decimals));
  }
  for (std::uint64_t i = 0; i < counts.faces; ++i) {
    lines.require_line(progress(i, counts.faces, "face"));
    const std::uint64_t corners = lines.count("the face's number of corners");
    for (std::uint64_t k = 0; k < corners; ++k)
      mesh.corners.push_back(lines.index(lines.require_token("a vertex number"), counts.vertices));
    parse.end_face();
  }
  if (lines.next_line())
    lines.fail(MeshFileProblem::syntax, "found " + in_quotes(lines.rest()) +
                                            " after the last face, expected the end of the " +
                                            "file; correct the numbers in the header");
}

}  // namespace plumb::surface
