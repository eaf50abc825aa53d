#include "surface/file/ply_header.hpp"

#include <algorithm>
#include <array>

#include "surface/file/text_lines.hpp"

namespace plumb::surface {
namespace {

PlyType read_type(const TextLines& lines, std::string_view token) {
  struct Name {
    std::string_view name;
    PlyType type;
  };
  constexpr std::array<Name, 16> names{{{"char", PlyType::int8},
                                        {"int8", PlyType::int8},
                                        {"uchar", PlyType::uint8},
                                        {"uint8", PlyType::uint8},
                                        {"short", PlyType::int16},
                                        {"int16", PlyType::int16},
                                        {"ushort", PlyType::uint16},
                                        {"uint16", PlyType::uint16},
                                        {"int", PlyType::int32},
                                        {"int32", PlyType::int32},
                                        {"uint", PlyType::uint32},
                                        {"uint32", PlyType::uint32},
                                        {"float", PlyType::float32},
                                        {"float32", PlyType::float32},
                                        {"double", PlyType::float64},
                                        {"float64", PlyType::float64}}};
  for (const auto& [name, type] : names)
    if (token == name) return type;
  lines.fail(MeshFileProblem::syntax, "the type is " + in_quotes(token) +
                                          ", expected char, uchar, short, ushort, int, uint, float, double or int8 to "
                                          "float64; mend the header");
}

MeshEncoding read_encoding(TextLines& lines) {
  const std::string_view encoding = lines.require_token("the encoding");
  const std::string_view version = lines.require_token("the version 1.0");
  if (version != "1.0")
    lines.fail(MeshFileProblem::unsupported,
               "the version is " + in_quotes(version) + ", expected 1.0; export it as such");
  if (encoding == "ascii") return MeshEncoding::ascii;
  if (encoding == "binary_little_endian") return MeshEncoding::binary_little_endian;
  if (encoding == "binary_big_endian") return MeshEncoding::binary_big_endian;
  lines.fail(MeshFileProblem::syntax,
             "the encoding is " + in_quotes(encoding) +
                 ", expected ascii, binary_little_endian or binary_big_endian; mend the header");
}

PlyProperty::Role role_of(const PlyElement& element, std::string_view property) {
  using Role = PlyProperty::Role;
  if (element.name == "vertex")
    return property == "x" ? Role::x : property == "y" ? Role::y : property == "z" ? Role::z : Role::ignored;
  if (property != "vertex_indices" && property != "vertex_index") return Role::ignored;
  return element.name == "face" ? Role::corners : element.name == "tristrips" ? Role::strip : Role::ignored;
}

void read_property(TextLines& lines, std::vector<PlyElement>& elements) {
  using Role = PlyProperty::Role;
  if (elements.empty())
    lines.fail(MeshFileProblem::syntax, "a property before any element, expected `element` first; mend the header");
  PlyElement& element = elements.back();
  PlyProperty property;
  std::string_view token = lines.require_token("a type");
  if (token == "list") {
    property.count_type = read_type(lines, lines.require_token("the type of the list's length"));
    if (!is_integer(*property.count_type))
      lines.fail(MeshFileProblem::syntax, "the list's length is no integer type, expected one; mend the header");
    token = lines.require_token("a type");
  }
  property.type = read_type(lines, token);
  property.name = lines.require_token("the property's name");
  property.role = role_of(element, property.name);
  const bool is_coordinate = property.role == Role::x || property.role == Role::y || property.role == Role::z;
  property.entry = (property.count_type ? "an entry of list "
                    : is_coordinate     ? "coordinate "
                                        : "property ") +
                   (is_coordinate ? property.name : in_quotes(property.name));
  const std::string name = "property " + in_quotes(property.name) + " of element " + in_quotes(element.name);
  const bool corners = property.role == Role::corners || property.role == Role::strip;
  if (property.role != Role::ignored && corners != property.count_type.has_value())
    lines.fail(
        MeshFileProblem::syntax,
        name + (corners ? " is one number, expected a list" : " is a list, expected one number") + "; mend the header");
  if (corners && !is_integer(property.type))
    lines.fail(MeshFileProblem::syntax, name + " is no integer type, expected one; mend the header");
  for (const auto& other : element.properties)
    if (property.role != Role::ignored && other.role == property.role)
      lines.fail(MeshFileProblem::syntax, name + " stands there twice, expected once; mend the header");
  element.properties.push_back(std::move(property));
}

void read_element(TextLines& lines, std::vector<PlyElement>& elements) {
  PlyElement element;
  element.name = lines.require_token("the element's name");
  element.count = lines.count("the element's count");
  for (const auto& other : elements)
    if (other.name == element.name)
      lines.fail(MeshFileProblem::syntax,
                 "element " + in_quotes(element.name) + " stands there twice, expected once; mend the header");
  elements.push_back(std::move(element));
}

bool has_role(const PlyElement& element, PlyProperty::Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [role](const PlyProperty& property) { return property.role == role; });
}

// What the header lacks, empty when nothing.
std::string missing(const PlyHeader& header) {
  using Role = PlyProperty::Role;
  bool vertex = false;
  for (const auto& element : header.elements) {
    if (element.name == "vertex") {
      vertex = true;
      for (const auto& [role, name] : {std::pair(Role::x, "x"), std::pair(Role::y, "y"), std::pair(Role::z, "z")})
        if (!has_role(element, role)) return std::string("property ") + name + " of element vertex";
    }
    if (element.name == "face" && !has_role(element, Role::corners)) return "list vertex_indices of element face";
    if (element.name == "tristrips" && !has_role(element, Role::strip))
      return "list vertex_indices of element tristrips";
  }
  return vertex ? "" : "element vertex";
}

// Data begin behind the line end, which is the one that the first line has: behind a lone \r a \n is data.
std::size_t data_offset(std::string_view bytes, std::size_t offset) {
  const auto first = bytes.find_first_of("\r\n");
  const bool carriage_return_only = bytes[first] == '\r' && bytes.substr(first, 2) != "\r\n";
  return carriage_return_only && bytes.substr(offset - 2, 2) == "\r\n" ? offset - 1 : offset;
}

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.count_type.has_value(); });
}

std::uint64_t PlyElement::size() const {
  std::uint64_t size = 0;
  for (const auto& property : properties)
    if (!property.count_type) size += size_of(property.type);
  return size;
}

PlyHeader read_ply_header(std::string_view bytes, std::string_view file) {
  PlyHeader header;
  TextLines lines(bytes, file);
  lines.require_line("`ply`");
  const std::string_view magic = lines.rest();
  if (magic != "ply")
    lines.fail(MeshFileProblem::syntax, "found " + in_quotes(magic) + ", expected `ply`; is this a PLY file?");
  std::optional<MeshEncoding> encoding;
  for (;;) {
    lines.require_line("`end_header`");
    const std::string_view keyword = lines.next_token();
    if (keyword == "end_header") break;
    if (keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      encoding = read_encoding(lines);
    } else if (keyword == "element") {
      read_element(lines, header.elements);
    } else if (keyword == "property") {
      read_property(lines, header.elements);
    } else {
      lines.fail(MeshFileProblem::syntax, "found " + in_quotes(keyword) +
                                              ", expected format, element, property, comment, obj_info or end_header; "
                                              "mend the header");
    }
  }
  std::string lacking = encoding ? missing(header) : "the line `format`";
  if (!lacking.empty())
    lines.fail(MeshFileProblem::syntax, "the header ends, expected " + lacking + "; export it again");
  header.encoding = *encoding;
  header.first_line = lines.line() + 1;
  header.size = data_offset(bytes, lines.offset());
  for (const auto& element : header.elements)
    if (element.name == "vertex") header.vertices = element.count;
  return header;
}

}  // namespace plumb::surface
