#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plumb/figure/basic/equal_points.hpp"
#include "surface/file/byte_reader.hpp"
#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

// 80 bytes of anything, the number of triangles, then a normal, three corners and two bytes for each.
constexpr std::size_t header_size = 80, count_end = 84, triangle_size = 50, normal_size = 12, attribute_size = 2;

std::uint64_t claimed_size(std::string_view bytes) {
  return count_end + triangle_size * std::uint64_t{ByteReader(bytes, "", header_size, std::endian::little)
                                                       .read<std::uint32_t>("the number of triangles")};
}

// Some binary files begin with `solid` too.  Binary data show a zero byte early: the triangle count has one at its end
// below sixteen million triangles, and larger files are known by their exact length.
bool is_ascii_stl(std::string_view bytes) {
  if (is_binary_stl(bytes) || bytes.substr(0, count_end).find('\0') != std::string_view::npos) return false;
  TextLines lines(bytes.substr(0, 4096), "");
  return lines.next_line() && lower_case(lines.next_token()) == "solid";
}

// How many facets are read where the count is wrong: those that are there.  Bytes that are no whole facets are something
// that was appended, and then the count is believed.  No zero byte at all means text, or what is no STL.
std::uint64_t facets_there(Parse& parse, std::uint64_t claimed) {
  const std::uint64_t room = (parse.bytes.size() - count_end) / triangle_size;
  const std::uint64_t odd = (parse.bytes.size() - count_end) % triangle_size;
  if (claimed < room && odd != 0) {
    const std::uint64_t end = count_end + claimed * triangle_size;
    parse.pass_over_at_byte("appendices behind the last facet", end, bytes_text(parse.bytes.size() - end));
    return claimed;
  }
  if (claimed != room)
    parse.pass_over_at_byte("counts of facets that are wrong", header_size,
                            "it claims " + std::to_string(claimed) + ", where there are " + std::to_string(room));
  if (odd != 0) parse.pass_over_at_byte("appendices behind the last facet", parse.bytes.size() - odd, bytes_text(odd));
  return room;
}

void parse_binary(Parse& parse) {
  parse.report.encoding = MeshEncoding::binary_little_endian;
  const auto& bytes = parse.bytes;
  if (bytes.size() < count_end)
    fail_at_byte(MeshFileProblem::truncated, parse.file, bytes.size(),
                 "the file ends here, expected `solid` (ASCII STL) or the 84 bytes that begin a binary STL; is this an "
                 "STL file?");
  const std::uint64_t size = claimed_size(bytes);
  std::uint64_t triangles = (size - count_end) / triangle_size;
  const auto problem = bytes.size() < size ? MeshFileProblem::truncated : MeshFileProblem::syntax;
  if (bytes.size() != size && parse.lenient() && bytes.find('\0') != std::string_view::npos)
    triangles = facets_there(parse, triangles);
  else if (bytes.size() != size)
    fail_at_byte(problem, parse.file, header_size,
                 "claims " + std::to_string(triangles) + " triangles, expected " + std::to_string(size) +
                     " bytes in all, but the file has " + std::to_string(bytes.size()) +
                     (bytes.size() < size ? "; it is cut short or no STL: fetch or export it again"
                                          : "; the count is wrong or something was appended: export it again"));
  ByteReader reader(bytes, parse.file, count_end, std::endian::little);
  auto& mesh = parse.mesh;
  mesh.vertices.reserve(3 * static_cast<std::size_t>(triangles));
  for (std::uint64_t t = 0; t < triangles; ++t) {
    reader.skip(1, normal_size, "a normal");
    for (int corner = 0; corner < 3; ++corner) {
      std::array<float, 3> p;
      for (float& x : p) {
        const std::size_t at = reader.offset();
        x = reader.read<float>("a coordinate");
        if (!std::isfinite(x))
          fail_at_byte(MeshFileProblem::bad_number, parse.file, at,
                       "a corner of triangle " + std::to_string(t) + (std::isnan(x) ? " is NaN" : " is infinite") +
                           ", expected a finite number; mend the tool that computed it");
      }
      mesh.vertices.push_back({p[0], p[1], p[2]});
    }
    reader.skip(1, attribute_size, "an attribute");
  }
}

// Names of solids hold any words, also those that begin and end one; what follows tells.  So both are kept: may the next
// word be within a solid, may it be behind one?
struct Place {
  bool within, behind;
};

// The words of ASCII STL, which may stand on lines as they like.
class Words {
 public:
  explicit Words(Parse& parse) : parse_(parse), lines_(parse.bytes, parse.file, {.flowing = true}) {}

  // The next word, empty at the end of the file.  Leniently `end loop` is one, too.
  std::string_view next() {
    word_ = lines_.next_token();
    if (!parse_.lenient() || !is_word(word_, "end")) return word_;
    TextLines ahead = lines_;
    const std::string_view behind = ahead.next_token();
    for (const std::string_view whole : {"endloop", "endfacet", "endsolid"}) {
      if (!is_word(behind, whole.substr(3))) continue;
      parse_.pass_over_in_line("blanks within a word", lines_.line(), word_);
      lines_ = ahead;
      return whole;
    }
    return word_;
  }
  void expect(std::string_view expected) {
    if (is_word(next(), expected)) return;
    refuse("`" + std::string(expected) + "`");
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    if (word_.empty()) lines_.fail_at_end(expected);
    lines_.fail(MeshFileProblem::syntax,
                "found " + in_quotes(word_) + ", expected " + expected + "; export the file again");
  }
  // The rest of the line is a name, but for a facet that begins there.
  Place name(Place at) {
    while (!lines_.at_line_end()) {
      const TextLines before = lines_;
      word_ = lines_.next_token();
      if (is_word(word_, "facet") && facet_follows()) {
        lines_ = before;
        break;
      }
      at.behind = at.behind || is_word(word_, "endsolid");
      at.within = at.within || is_word(word_, "solid");
    }
    return at;
  }
  TextLines& lines() { return lines_; }
  // The last word and the rest of its line.
  [[nodiscard]] std::string_view line_from_here() const {
    TextLines ahead = lines_;
    const TextLines::Words behind = ahead.words_left();
    return behind.count == 0 ? word_ : std::string_view(word_.data(), behind.text.data() + behind.text.size());
  }

 private:
  [[nodiscard]] bool facet_follows() const {
    TextLines ahead = lines_;
    const std::string_view word = ahead.next_token();
    return is_word(word, "normal") || is_word(word, "outer");
  }

  Parse& parse_;
  TextLines lines_;
  std::string_view word_;
};

// Up to `outer`.  What the normal is does not matter, for the corners' order tells; that it is there does, but to a
// lenient reading.
void parse_normal(Parse& parse, Words& words) {
  const std::uint64_t line = words.lines().line();
  std::string_view word = words.next();
  const bool named = is_word(word, "normal");
  if (!named && !(parse.lenient() && is_word(word, "outer"))) words.refuse("`normal`");
  int numbers = 0;
  for (word = named ? words.next() : word; !is_word(word, "outer"); word = words.next(), ++numbers)
    if (word.empty() || (numbers == 3 && !parse.lenient()))
      words.refuse(numbers < 3 ? "the facet's normal" : "`outer`");
  if (numbers == 3) return;
  if (!parse.lenient()) words.refuse("the facet's normal");
  parse.pass_over_in_line("facets without a normal", line, named ? "facet normal" : "facet");
}

void parse_facet(Parse& parse, Words& words) {
  parse_normal(parse, words);
  words.expect("loop");
  for (int corner = 0; corner < 3; ++corner) {
    words.expect("vertex");
    parse.mesh.vertices.push_back(words.lines().point(parse.decimals));
  }
  words.expect("endloop");
  words.expect("endfacet");
}

// What a lenient reading says of a word that is none of those that may follow.
std::string_view unfitting(std::string_view word, bool facet) {
  if (word.empty() || is_word(word, "solid")) return "solids without `endsolid`";
  return facet ? "solids without `solid`" : "lines among the facets that are none";
}

// Solid after solid: some files hold several.
void parse_ascii(Parse& parse) {
  parse.report.encoding = MeshEncoding::ascii;
  Words words(parse);
  words.expect("solid");
  for (Place at = words.name({.within = true, .behind = false});;) {
    const std::string_view word = words.next();
    const std::uint64_t line = words.lines().line();
    const bool facet = is_word(word, "facet"), end = is_word(word, "endsolid"), solid = is_word(word, "solid");
    const bool fits = facet || end ? at.within : at.behind && (solid || word.empty());
    if (!fits && !parse.lenient()) words.refuse(at.behind ? "`solid` or the end of the file" : "`facet` or `endsolid`");
    if (!fits) parse.pass_over_in_line(unfitting(word, facet), line, words.line_from_here());
    if (word.empty()) return;
    if (facet) parse_facet(parse, words);
    const bool known = facet || end || solid;
    const Place after = !known ? at : Place{.within = !end, .behind = end};
    at = facet ? after : words.name(after);
  }
}

// One vertex for each distinct point, in the order of first use.
void merge_vertices(Parse& parse) {
  auto& mesh = parse.mesh;
  if (mesh.vertices.size() > std::numeric_limits<std::uint32_t>::max())
    fail_at_file(MeshFileProblem::unsupported, parse.file,
                 "more than 4294967295 corners, expected fewer; cut the mesh up");
  const auto first = first_equal(mesh.vertices);
  std::vector<std::uint32_t> number(first.size());
  std::vector<Point3> distinct;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      number[i] = static_cast<std::uint32_t>(distinct.size());
      distinct.push_back(mesh.vertices[i]);
    }
    mesh.corners.push_back(number[first[i]]);
    if (i % 3 == 2) mesh.first.push_back(static_cast<std::uint32_t>(i + 1));
  }
  parse.report.merged_vertices = first.size() - distinct.size();
  mesh.vertices = std::move(distinct);
}

}  // namespace

bool is_binary_stl(std::string_view bytes) { return bytes.size() >= count_end && bytes.size() == claimed_size(bytes); }

void parse_stl(Parse& parse) {
  if (is_ascii_stl(parse.bytes))
    parse_ascii(parse);
  else
    parse_binary(parse);
  merge_vertices(parse);
}

}  // namespace plumb::surface
