// OFF: numbers on any lines, but that a line may hold more than its vertex or face: what follows a vertex is told by the
// file's first word, what follows a face is a color up to the line's end.  So a file is read by lines, and if that fails
// or leaves words over that are none of these, as numbers on any lines, if it comes out even so.
#include <algorithm>
#include <array>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

// How vertices and faces are parted: by lines, of whose further words no more is made, or by counting numbers.
struct Layout {
  bool vertices_by_line = true, faces_by_line = true;
  std::uint64_t behind_vertex = 0;  // numbers, where they are counted
};

// A color's place in a map, or red, green and blue, and how opaque it is.
constexpr std::array<std::uint64_t, 3> color_of_face{1, 3, 4};

// How many numbers follow a vertex: a normal, a color, a place in a texture.
std::vector<std::uint64_t> numbers_behind_vertex(std::string_view prefix) {
  const auto has = [prefix](std::string_view part) { return prefix.find(part) != std::string_view::npos; };
  const std::uint64_t others = (has("N") ? 3U : 0U) + (has("ST") ? 2U : 0U);
  if (has("C")) return {others + 4, others + 3};
  return {others};
}

class OffReader {
 public:
  OffReader(Parse& parse, const Layout& layout)
      : parse_(parse), layout_(layout), lines_(parse.bytes, parse.file, {.comments = true}) {}

  void read() {
    if (!lines_.next_line()) return;
    lines_.set_flowing(!layout_.vertices_by_line);
    read_header();
    read_vertices();
    if (!layout_.vertices_by_line && layout_.faces_by_line && !lines_.at_line_end()) refuse_rest("the last vertex");
    read_faces();
    if (lines_.at_line_end() && !lines_.next_line()) return;
    if (!parse_.lenient() || !layout_.vertices_by_line) refuse_rest("the last face");
    do {
      parse_.pass_over_in_line("lines behind the last face", lines_.line(), lines_.rest());
    } while (lines_.next_line());
  }

  [[nodiscard]] bool left_words() const { return left_words_; }
  [[nodiscard]] std::string_view prefix() const { return prefix_; }

 private:
  [[noreturn]] void refuse_rest(const std::string& behind) {
    lines_.fail(MeshFileProblem::syntax,
                "found " + in_quotes(lines_.rest()) + " after " + behind + ", expected the end of the " +
                    (behind == "the last face" ? "file; correct the numbers in the header" : "line; part the line"));
  }

  // The words and numbers before the first vertex.
  void read_header() {
    std::string_view token = lines_.next_token();
    if (const auto header = off_header(token)) {
      prefix_ = header->prefix;
      if (prefix_.find_first_of("4n") != std::string_view::npos)
        lines_.fail(MeshFileProblem::unsupported, "found " + in_quotes(token) +
                                                      ", expected OFF in three dimensions (OFF, COFF, NOFF, STOFF and "
                                                      "their mixtures); export three coordinates a vertex");
      token = header->count.empty() ? lines_.next_token() : header->count;
      if (is_word(token, "binary"))
        lines_.fail(MeshFileProblem::unsupported, "found binary OFF, expected ASCII; export it as ASCII OFF or as PLY");
      if (token.empty()) {
        lines_.require_line("the numbers of vertices and faces");
        token = lines_.next_token();
      }
    }
    std::int64_t vertices = -1;
    if (!read_integer(token, vertices) || vertices < 0)
      lines_.fail(MeshFileProblem::syntax,
                  "found " + in_quotes(token) + ", expected OFF or the number of vertices; is this an OFF file?");
    vertices_ = static_cast<std::uint64_t>(vertices);
    faces_ = lines_.count("the number of faces");
    const std::string_view edges = lines_.next_token();  // nobody relies on it, and some leave it out
    std::int64_t ignored = 0;
    if (!edges.empty() && !read_integer(edges, ignored))
      lines_.fail(MeshFileProblem::syntax,
                  "the number of edges is " + in_quotes(edges) + ", expected a whole number; mend the line");
    if (layout_.vertices_by_line) end_line("texts behind the counts", {});
    behind_vertex_ = numbers_behind_vertex(prefix_);
  }

  void read_vertices() {
    // Six bytes a vertex, three a face is the least that they take.
    parse_.mesh.vertices.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(vertices_, parse_.bytes.size() / 6)));
    for (std::uint64_t i = 0; i < vertices_; ++i) {
      begin(i, vertices_, "vertex");
      parse_.mesh.vertices.push_back(lines_.point(parse_.decimals));
      if (layout_.vertices_by_line) {
        end_line("texts behind a vertex that the file's first word does not tell of", behind_vertex_);
      } else {
        for (std::uint64_t k = 0; k < layout_.behind_vertex; ++k) skip_number("a number behind the vertex");
      }
    }
  }

  void read_faces() {
    for (std::uint64_t i = 0; i < faces_; ++i) {
      if (i > 0 && parse_.lenient() && layout_.vertices_by_line && lines_.at_line_end() && !lines_.next_line())
        return parse_.pass_over_at_byte(
            "counts in the header that are too high", parse_.bytes.size(),
            "it claims " + std::to_string(faces_) + " faces, where there are " + std::to_string(i));
      begin(i, faces_, "face");
      const std::uint64_t corners = lines_.count("the face's number of corners");
      for (std::uint64_t k = 0; k < corners; ++k)
        parse_.mesh.corners.push_back(lines_.index(lines_.require_token("a vertex number"), vertices_));
      parse_.end_face();
      if (layout_.faces_by_line) end_line("texts behind a face that are no color", color_of_face);
    }
  }

  // To the next line, if this one has come to its end.
  void begin(std::uint64_t have, std::uint64_t of, const char* what) {
    if (!lines_.at_line_end() || lines_.next_line()) return;
    lines_.fail_at_end(std::string(what) + " " + std::to_string(have + 1) + " of the " + std::to_string(of) +
                       " that the header claims");
  }

  // Leaves over what the line holds more; if it is not so many numbers as there may be, it is told.
  void end_line(std::string_view what, std::span<const std::uint64_t> may_be) {
    if (lines_.at_line_end()) return;
    left_words_ = true;
    const TextLines::Words words = lines_.words_left();
    if (!words.numbers || std::find(may_be.begin(), may_be.end(), words.count) == may_be.end())
      parse_.pass_over_in_line(what, lines_.line(), words.text);
  }

  void skip_number(std::string_view what) {
    const std::string_view word = lines_.require_token(what);
    if (!looks_like_a_number(word))
      lines_.fail(MeshFileProblem::bad_number,
                  std::string(what) + " is " + in_quotes(word) + ", expected a decimal number; mend the line");
  }

  Parse& parse_;
  Layout layout_;
  TextLines lines_;
  std::string_view prefix_{};
  std::vector<std::uint64_t> behind_vertex_{};
  std::uint64_t vertices_ = 0, faces_ = 0;
  bool left_words_ = false;
};

/// In its place, if all of the file is numbers so laid out.
bool read_numbers(Parse& parse, const Layout& layout, std::exception_ptr& error) try {
  Parse attempt = parse;
  OffReader(attempt, layout).read();
  parse = std::move(attempt);
  return true;
} catch (const MeshFileError&) {
  if (!error) error = std::current_exception();
  return false;
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
  Parse by_lines = parse;
  OffReader lines(by_lines, {});
  std::exception_ptr in_lines, in_numbers;
  try {
    lines.read();
  } catch (const MeshFileError&) {
    in_lines = std::current_exception();
  }
  const auto by_numbers = [&](bool faces_by_line) {
    const std::vector<std::uint64_t> behind = numbers_behind_vertex(lines.prefix());
    return std::any_of(behind.begin(), behind.end(), [&](std::uint64_t numbers) {
      return read_numbers(parse, {.vertices_by_line = false, .faces_by_line = faces_by_line, .behind_vertex = numbers},
                          in_numbers);
    });
  };
  const bool sound =
      !in_lines && by_lines.report.passed_over.empty() && (!lines.left_words() || by_lines.report.dropped_faces == 0);
  if (!sound && by_numbers(false)) return;
  if (in_lines && by_numbers(true)) return;
  // Lines that hold more than they may are a reason to believe that numbers were meant.
  if (in_lines) std::rethrow_exception(by_lines.report.passed_over.empty() ? in_lines : in_numbers);
  parse = std::move(by_lines);
}

}  // namespace plumb::surface
