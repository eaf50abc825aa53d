// The facets of what is round are OpenSCAD's guess at it: their corners come from sines of doubles.
#include "tool/csg/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plumb/arith/error.hpp"

namespace plumb::tool {
namespace {

/// Exact where OpenSCAD's is: at 0, 30, 45, 60, 90 and what is symmetric to these.
double cosine_of_degrees(double degrees) {
  double x = std::fmod(std::fabs(degrees), 360.0), sign = 1;
  if (x > 180) x = 360 - x;
  if (x > 90) {
    x = 180 - x;
    sign = -1;
  }
  if (x == 90) return 0;
  if (x == 60) return sign * 0.5;
  if (x == 45) return sign * (std::numbers::sqrt2 / 2);
  if (x == 30) return sign * (std::numbers::sqrt3 / 2);
  const double radians = x * (std::numbers::pi / 180);
  return sign * (x > 45 ? std::sin((90 - x) * (std::numbers::pi / 180)) : std::cos(radians));
}
double sine_of_degrees(double degrees) { return cosine_of_degrees(degrees - 90); }

unsigned fragments(const CsgArguments& arguments, double radius) {
  const double fn = arguments.number("$fn", 0), fa = arguments.number("$fa", 12), fs = arguments.number("$fs", 2);
  if (radius < 0x1p-20) return 3;
  double n = std::max(fn, 3.0);
  if (fn <= 0) {
    if (fa < 0.01 || fs < 0.01) arguments.fail("$fa and $fs are at least 0.01");
    n = std::ceil(std::max(std::min(360 / fa, radius * 2 * std::numbers::pi / fs), 5.0));
  }
  if (n > most_fragments)
    arguments.fail(fmt::format("it would have {} fragments; at most {} are made", n, most_fragments));
  return static_cast<unsigned>(n);
}

void put_face(PolygonMesh& mesh, const std::vector<std::uint32_t>& corners) {
  mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
}

/// Rings of as many corners each, one above the other, and a lid at each end.
PolygonMesh mesh_of_rings(const std::vector<std::array<double, 2>>& rings, unsigned around) {
  PolygonMesh mesh;
  for (const auto& [radius, z] : rings)
    for (unsigned i = 0; i < around; ++i) {
      const double degrees = 360.0 * i / around;
      mesh.vertices.push_back({radius * cosine_of_degrees(degrees), radius * sine_of_degrees(degrees), z});
    }
  std::vector<std::uint32_t> bottom, top;
  const auto last = static_cast<std::uint32_t>(rings.size() - 1) * around;
  for (unsigned i = 0; i < around; ++i) {
    bottom.push_back(around - 1 - i);
    top.push_back(last + i);
  }
  if (rings.front()[0] != 0) put_face(mesh, bottom);
  for (std::uint32_t r = 0; r < last; r += around)
    for (unsigned i = 0; i < around; ++i) {
      const unsigned next = (i + 1) % around;
      put_face(mesh, {r + i, r + next, r + around + next});
      put_face(mesh, {r + i, r + around + next, r + around + i});
    }
  if (rings.back()[0] != 0) put_face(mesh, top);
  return mesh;
}

double positive(const CsgArguments& arguments, const std::string& name, double value) {
  if (!(value > 0)) arguments.fail(name + " is not greater than 0");
  return value;
}

}  // namespace

CsgArguments::CsgArguments(const CsgCall& call, const std::string& text, std::vector<std::string> in_order)
    : call_(call), text_(text), in_order_(std::move(in_order)) {}

void CsgArguments::fail(const std::string& text) const { fail_at(text_, call_.line, call_.name + ": " + text); }

const CsgValue* CsgArguments::find(const std::string& name) const {
  std::size_t place = 0;
  const CsgValue* found = nullptr;
  for (const auto& [given, value] : call_.arguments) {
    if (given == name || (given.empty() && place < in_order_.size() && in_order_[place] == name)) found = &value;
    place += given.empty() ? 1 : 0;
  }
  return found != nullptr && !std::holds_alternative<std::monostate>(found->is) ? found : nullptr;
}

double CsgArguments::number(const std::string& name, double otherwise) const {
  const CsgValue* const value = find(name);
  if (value == nullptr) return otherwise;
  if (const double* const is = std::get_if<double>(&value->is)) return *is;
  fail(name + " is no number");
}

bool CsgArguments::flag(const std::string& name) const {
  const CsgValue* const value = find(name);
  if (value == nullptr) return false;
  if (const bool* const is = std::get_if<bool>(&value->is)) return *is;
  fail(name + " is neither true nor false");
}

std::vector<double> CsgArguments::numbers(const CsgValue& list, const std::string& name) const {
  const auto* const all = std::get_if<std::vector<CsgValue>>(&list.is);
  if (all == nullptr) fail(name + " is no list");
  std::vector<double> made;
  for (const CsgValue& v : *all) {
    const double* const is = std::get_if<double>(&v.is);
    if (is == nullptr) fail(name + " holds something else than numbers");
    made.push_back(*is);
  }
  return made;
}

std::vector<std::vector<double>> CsgArguments::rows(const std::string& name, std::size_t fewest,
                                                    std::size_t most) const {
  const CsgValue* const value = find(name);
  if (value == nullptr) fail(name + " is not given");
  const auto* const all = std::get_if<std::vector<CsgValue>>(&value->is);
  if (all == nullptr) fail(name + " is no list");
  std::vector<std::vector<double>> made;
  for (const CsgValue& v : *all) {
    made.push_back(numbers(v, name));
    if (made.back().size() < fewest || made.back().size() > most)
      fail(name + " has a row of " + std::to_string(made.back().size()) + " numbers");
  }
  return made;
}

PolygonMesh mesh_of_cube(const CsgCall& call, const std::string& text) {
  const CsgArguments arguments(call, text, {"size", "center"});
  std::vector<double> size(3, 1);
  if (const CsgValue* const given = arguments.find("size")) {
    if (std::holds_alternative<double>(given->is))
      size.assign(3, std::get<double>(given->is));
    else
      size = arguments.numbers(*given, "size");
  }
  if (size.size() != 3) arguments.fail("size is not three numbers");
  for (const double s : size) positive(arguments, "size", s);
  const bool centered = arguments.flag("center");
  PolygonMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    const auto end = [&](unsigned axis) {
      const bool greater = (i >> axis) % 2 != 0;
      return centered ? (greater ? size[axis] / 2 : -size[axis] / 2) : greater ? size[axis] : 0.0;
    };
    mesh.vertices.push_back({end(0), end(1), end(2)});
  }
  for (const auto& face : {std::array{0U, 2U, 3U, 1U}, std::array{4U, 5U, 7U, 6U}, std::array{0U, 1U, 5U, 4U},
                           std::array{2U, 6U, 7U, 3U}, std::array{0U, 4U, 6U, 2U}, std::array{1U, 3U, 7U, 5U}})
    put_face(mesh, {face.begin(), face.end()});
  return mesh;
}

PolygonMesh mesh_of_polyhedron(const CsgCall& call, const std::string& text) {
  const CsgArguments arguments(call, text, {"points", "faces", "convexity"});
  PolygonMesh mesh;
  for (const std::vector<double>& p : arguments.rows("points", 3, 3)) mesh.vertices.push_back({p[0], p[1], p[2]});
  for (const std::vector<double>& face :
       arguments.rows(arguments.find("faces") == nullptr ? "triangles" : "faces", 3, mesh.vertices.size() * 2)) {
    std::vector<std::uint32_t> corners;
    for (const double index : face) {
      if (!(index >= 0) || index >= static_cast<double>(mesh.vertices.size()) || index != std::floor(index))
        arguments.fail(fmt::format("a face names no point: {}", index));
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    std::ranges::reverse(corners);
    put_face(mesh, corners);
  }
  return mesh;
}

PolygonMesh mesh_of_cylinder(const CsgCall& call, const std::string& text) {
  const CsgArguments arguments(call, text, {"h", "r1", "r2", "center"});
  const auto radius = [&](const std::string& end) {
    const double both = arguments.number("r", arguments.number("d", 2) / 2);
    return arguments.number("r" + end,
                            arguments.find("d" + end) != nullptr ? arguments.number("d" + end, 2) / 2 : both);
  };
  const double h = positive(arguments, "h", arguments.number("h", 1)), r1 = radius("1"), r2 = radius("2");
  if (!(r1 >= 0 && r2 >= 0 && r1 + r2 > 0)) arguments.fail("a radius is negative, or both are 0");
  const double bottom = arguments.flag("center") ? -h / 2 : 0;
  return mesh_of_rings({{r1, bottom}, {r2, arguments.flag("center") ? h / 2 : h}},
                       fragments(arguments, std::max(r1, r2)));
}

PolygonMesh mesh_of_sphere(const CsgCall& call, const std::string& text) {
  const CsgArguments arguments(call, text, {"r"});
  const double r = positive(arguments, "r", arguments.number("r", arguments.number("d", 2) / 2));
  const unsigned around = fragments(arguments, r), count = (around + 1) / 2;
  std::vector<std::array<double, 2>> rings;
  for (unsigned i = count; i-- > 0;) {
    const double degrees = 180 * (i + 0.5) / count;
    rings.push_back({r * sine_of_degrees(degrees), r * cosine_of_degrees(degrees)});
  }
  return mesh_of_rings(rings, around);
}

}  // namespace plumb::tool
