#include <array>
#include <bit>
#include <cmath>
#include <string>

#include "surface/file/byte_reader.hpp"
#include "surface/file/mesh_parsers.hpp"
#include "surface/file/ply_header.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

using Role = PlyProperty::Role;

double& coordinate_of(Point3& point, Role role) {
  return role == Role::x ? point.x : role == Role::y ? point.y : point.z;
}

std::string progress(const PlyElement& element, std::uint64_t have) {
  return in_quotes(element.name) + " " + std::to_string(have + 1) + " of the " + std::to_string(element.count) +
         " that the header claims";
}

// A lenient reading takes fewer faces than the header claims, if there are any; where vertices are missing, what follows
// is none of theirs.
bool may_be_short(const Parse& parse, const PlyElement& element, std::uint64_t have) {
  return parse.lenient() && element.name != "vertex" && (have > 0 || element.name != "face");
}

void note_short(Parse& parse, const PlyElement& element, std::uint64_t have) {
  parse.pass_over_at_byte("counts in the header that are too high", parse.bytes.size(),
                          "it claims " + std::to_string(element.count) + " of " + in_quotes(element.name) +
                              ", where there are " + std::to_string(have));
}

// Triangles from a strip: each further vertex makes one with the two before it, every second one the other way around.
// A strip that names a vertex twice does so to turn or to jump; that is no face.
class Strip {
 public:
  void restart() { length_ = 0; }
  void add(std::uint32_t vertex, Parse& parse) {
    if (length_ >= 2) {
      const bool turned = length_ % 2 == 1;
      auto& corners = parse.mesh.corners;
      if (vertex != last_[0] && vertex != last_[1] && last_[0] != last_[1])
        corners.insert(corners.end(), {last_[turned], last_[!turned], vertex});
      parse.end_face();
    }
    last_ = {last_[1], vertex};
    ++length_;
  }

 private:
  std::array<std::uint32_t, 2> last_{};
  std::uint64_t length_ = 0;
};

// Numbers on any lines; a lenient reading, which comes second, takes an element a line and passes over what follows it.
class AsciiBody {
 public:
  AsciiBody(Parse& parse, const PlyHeader& header)
      : parse_(parse),
        header_(header),
        lines_(parse.bytes.substr(header.size), parse.file, {.flowing = !parse.lenient()}, header.first_line) {}

  void read(const PlyElement& element) {
    if (element.properties.empty()) return;  // says nothing, however often
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (lines_.at_line_end() && !lines_.next_line()) {
        if (may_be_short(parse_, element, i)) return note_short(parse_, element, i);
        lines_.fail_at_end(progress(element, i));
      }
      Point3 point{};
      for (const auto& property : element.properties) read(property, point);
      if (!lines_.at_line_end()) note_long_line();
      if (element.name == "vertex") parse_.mesh.vertices.push_back(point);
      if (element.name == "face") parse_.end_face();
    }
  }

  void finish() {
    if (lines_.at_line_end() && !lines_.next_line()) return;
    if (!parse_.lenient())
      lines_.fail(MeshFileProblem::syntax, "found " + in_quotes(lines_.rest()) +
                                               " after the last element, expected the end of the file; correct the "
                                               "counts in the header");
    do {
      parse_.pass_over_in_line("lines behind the last element", lines_.line(), lines_.rest());
    } while (lines_.next_line());
  }

 private:
  void note_long_line() {
    if (parse_.lenient()) {
      parse_.pass_over_in_line("texts behind an element that the header does not know", lines_.line(), lines_.rest());
    } else if (!lines_.has_odd_line()) {
      TextLines ahead = lines_;
      lines_.note_odd_line("found " + in_quotes(ahead.rest()) +
                           " after the properties of the header, expected the end of the line; mend the line or the "
                           "header");
    }
  }

  void read(const PlyProperty& property, Point3& point) {
    if (property.count_type) {
      const std::uint64_t count = lines_.count("the list's length");
      Strip strip;
      for (std::uint64_t k = 0; k < count; ++k) {
        const std::string_view token = lines_.require_token(property.entry);
        if (property.role == Role::corners) parse_.mesh.corners.push_back(lines_.index(token, header_.vertices));
        if (property.role != Role::strip) continue;
        if (token == "-1")
          strip.restart();
        else
          strip.add(lines_.index(token, header_.vertices), parse_);
      }
    } else if (property.role == Role::ignored) {
      lines_.require_token(property.entry);
    } else {
      coordinate_of(point, property.role) = lines_.coordinate(parse_.decimals, property.entry);
    }
  }

  Parse& parse_;
  const PlyHeader& header_;
  TextLines lines_;
};

class BinaryBody {
 public:
  BinaryBody(Parse& parse, const PlyHeader& header)
      : parse_(parse),
        header_(header),
        bytes_(parse.bytes, parse.file, header.size,
               header.encoding == MeshEncoding::binary_big_endian ? std::endian::big : std::endian::little) {}

  void read(const PlyElement& element) {
    const bool vertex = element.name == "vertex", face = element.name == "face";
    const bool may_end = parse_.lenient() && !vertex;
    const std::uint64_t size = element.size();
    if (may_end && !element.has_lists() && size != 0 && bytes_.left() / size < element.count) {
      note_short(parse_, element, bytes_.left() / size);
      return bytes_.skip(bytes_.left(), 1, "an element");
    }
    if (!may_end) bytes_.require(element.count, size, "the elements that the header claims");
    if (!vertex && !element.has_lists()) return bytes_.skip(element.count, size, "an element");
    // At least three bytes a vertex were just found to be there.
    if (vertex) parse_.mesh.vertices.reserve(static_cast<std::size_t>(element.count));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (bytes_.left() == 0 && may_be_short(parse_, element, i)) return note_short(parse_, element, i);
      Point3 point{};
      for (const auto& property : element.properties) read(property, point);
      if (vertex) parse_.mesh.vertices.push_back(point);
      if (face) parse_.end_face();
    }
  }

  // Some writers end with a line end.
  void finish() const {
    if (bytes_.rest().find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    if (!parse_.lenient())
      bytes_.fail(MeshFileProblem::syntax, "found " + std::to_string(bytes_.left()) +
                                               " more bytes after the last element, expected the end of the file; "
                                               "correct the counts in the header");
    parse_.pass_over_at_byte("appendices behind the last element", bytes_.offset(), bytes_text(bytes_.left()));
  }

 private:
  void read(const PlyProperty& property, Point3& point) {
    if (property.count_type) {
      const std::int64_t count = integer(*property.count_type);
      if (count < 0) refuse(MeshFileProblem::syntax, *property.count_type, "the list's length", count, "at least 0");
      bytes_.require(static_cast<std::uint64_t>(count), size_of(property.type), "the entries of a list");
      if (property.role == Role::ignored)
        bytes_.skip(static_cast<std::uint64_t>(count), size_of(property.type), "a list");
      Strip strip;
      for (std::int64_t k = 0; k < count && property.role != Role::ignored; ++k) {
        const std::int64_t vertex = integer(property.type);
        if (property.role == Role::corners)
          parse_.mesh.corners.push_back(index(vertex, property.type));
        else if (vertex == -1)
          strip.restart();
        else
          strip.add(index(vertex, property.type), parse_);
      }
    } else if (property.role == Role::ignored) {
      bytes_.skip(1, size_of(property.type), "a property");
    } else {
      coordinate_of(point, property.role) = coordinate(property);
    }
  }

  std::uint32_t index(std::int64_t vertex, PlyType type) const {
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= header_.vertices)
      refuse(MeshFileProblem::bad_index, type, "the face's vertex", vertex,
             "from 0 and below " + std::to_string(header_.vertices) + ", the number of vertices");
    return static_cast<std::uint32_t>(vertex);
  }

  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return bytes_.read<std::int8_t>("an integer");
      case PlyType::uint8:
        return bytes_.read<std::uint8_t>("an integer");
      case PlyType::int16:
        return bytes_.read<std::int16_t>("an integer");
      case PlyType::uint16:
        return bytes_.read<std::uint16_t>("an integer");
      case PlyType::int32:
        return bytes_.read<std::int32_t>("an integer");
      default:
        return bytes_.read<std::uint32_t>("an integer");
    }
  }

  double coordinate(const PlyProperty& property) {
    const std::size_t at = bytes_.offset();
    const double value = property.type == PlyType::float64   ? bytes_.read<double>("a coordinate")
                         : property.type == PlyType::float32 ? static_cast<double>(bytes_.read<float>("a coordinate"))
                                                             : static_cast<double>(integer(property.type));
    if (!std::isfinite(value))
      fail_at_byte(MeshFileProblem::bad_number, parse_.file, at,
                   "coordinate " + property.name + " of vertex " + std::to_string(parse_.mesh.vertices.size()) +
                       (std::isnan(value) ? " is NaN" : " is infinite") +
                       ", expected a finite number; mend the tool that computed it");
    return value;
  }

  [[noreturn]] void refuse(MeshFileProblem problem, PlyType type, const char* what, std::int64_t found,
                           const std::string& expected) const {
    fail_at_byte(
        problem, parse_.file, bytes_.offset() - size_of(type),
        std::string(what) + " is " + std::to_string(found) + ", expected " + expected + "; export the file again");
  }

  Parse& parse_;
  const PlyHeader& header_;
  ByteReader bytes_;
};

template <class Body>
void read_body(Parse& parse, const PlyHeader& header) {
  Body body(parse, header);
  for (const auto& element : header.elements) body.read(element);
  body.finish();
}

}  // namespace

void parse_ply(Parse& parse) {
  const PlyHeader header = read_ply_header(parse.bytes, parse.file);
  parse.report.encoding = header.encoding;
  if (header.encoding == MeshEncoding::ascii)
    read_body<AsciiBody>(parse, header);
  else
    read_body<BinaryBody>(parse, header);
}

}  // namespace plumb::surface
