#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plumb/surface/topology.hpp"
#include "surface/byte_reader.hpp"
#include "surface/mesh_parsers.hpp"
#include "surface/text_lines.hpp"

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

void parse_binary(Parse& parse) {
  parse.report.encoding = MeshEncoding::binary_little_endian;
  const auto& bytes = parse.bytes;
  if (bytes.size() < count_end)
    fail_at_byte(MeshFileProblem::truncated, parse.file, bytes.size(),
                 "the file ends here, expected `solid` (ASCII STL) or the 84 bytes that begin a binary STL; is this an "
                 "STL file?");
  const std::uint64_t size = claimed_size(bytes), triangles = (size - count_end) / triangle_size;
  const auto problem = bytes.size() < size ? MeshFileProblem::truncated : MeshFileProblem::syntax;
  if (bytes.size() != size)
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

// The words of ASCII STL, which may stand on lines as they like.
class Words {
 public:
  explicit Words(Parse& parse) : lines_(parse.bytes, parse.file) {}

  // The next word in lower case, empty at the end of the file.
  std::string next() {
    raw_ = lines_.next_token();
    while (raw_.empty() && lines_.next_line()) raw_ = lines_.next_token();
    return lower_case(raw_);
  }
  // The next word, which is not the end of the file.
  std::string require(const std::string& expected) {
    std::string word = next();
    if (word.empty())
      lines_.fail(MeshFileProblem::truncated,
                  "the file ends here, expected " + expected + "; it is cut short: fetch or export it again");
    return word;
  }
  void expect(const std::string& expected) {
    if (require("`" + expected + "`") != expected) refuse("`" + expected + "`");
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    lines_.fail(MeshFileProblem::syntax,
                "found " + in_quotes(raw_) + ", expected " + expected + "; export the file again");
  }
  TextLines& lines() { return lines_; }

 private:
  TextLines lines_;
  std::string_view raw_;
};

void parse_facet(Parse& parse, Words& words) {
  words.expect("normal");
  for (int k = 0; k < 3; ++k) words.require("the facet's normal");  // anything: the corners' order tells
  words.expect("outer");
  words.expect("loop");
  for (int corner = 0; corner < 3; ++corner) {
    words.expect("vertex");
    parse.mesh.vertices.push_back(words.lines().point(parse.decimals));
  }
  words.expect("endloop");
  words.expect("endfacet");
}

// Solid after solid: some files hold several.
void parse_ascii(Parse& parse) {
  parse.report.encoding = MeshEncoding::ascii;
  Words words(parse);
  words.expect("solid");
  for (;;) {
    words.lines().rest();  // the solid's name
    for (std::string word; word != "endsolid";) {
      word = words.require("`facet` or `endsolid`");
      if (word == "facet")
        parse_facet(parse, words);
      else if (word != "endsolid")
        words.refuse("`facet` or `endsolid`");
    }
    words.lines().rest();
    const std::string word = words.next();
    if (word.empty()) return;
    if (word != "solid") words.refuse("`solid` or the end of the file");
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
