// Clashes: parts of an assembly by their names, what a rule says of each two, and one answer a pair.
#include <pybind11/stl.h>

#include <algorithm>

#include "plumb/figure/basic/rounded_poses.hpp"
#include "plumb/world/clashes.hpp"
#include "python/figure_answers.hpp"
#include "python/figure_class.hpp"
#include "python/mesh.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

constexpr const char* asked = "clash";

const TriangleMesh& mesh_in(const py::handle& given) {
  if (!py::isinstance<TriangleMesh>(given))
    throw py::type_error("clash: parts are meshes, or tuples of a mesh and where it stands");
  return given.cast<const TriangleMesh&>();
}

/// A mesh; a mesh and a matrix; or a mesh, a turn and a translation.
TriangleMesh part_in(const py::handle& given) {
  if (!py::isinstance<py::tuple>(given)) return mesh_in(given);
  const auto of = py::reinterpret_borrow<py::tuple>(given);
  if (of.size() != 2 && of.size() != 3)
    throw py::type_error("clash: a part has " + std::to_string(of.size()) +
                         " items; give (mesh, pose) or (mesh, turn, translation)");
  TriangleMesh mesh = mesh_in(of[0]);
  const py::object none = py::none();
  const AnyPose pose = of.size() == 2 ? pose_of(3, of[1], none, none, asked) : pose_of(3, none, of[1], of[2], asked);
  for (Point3& p : mesh.vertices) {
    if (const auto* matrix = std::get_if<Pose>(&pose)) p = rounded_image(*matrix, p);
    if (const auto* rigid = std::get_if<RigidPose>(&pose)) p = rounded_image(*rigid, p);
  }
  return mesh;
}

struct NamedParts {
  std::vector<py::object> names;
  std::vector<TriangleMesh> meshes;
};
/// A dict of names, or a sequence, whose names are numbers.
NamedParts parts_in(const py::object& given) {
  NamedParts parts;
  if (py::isinstance<py::dict>(given)) {
    for (const auto& [name, part] : given.cast<py::dict>()) {
      parts.names.push_back(py::reinterpret_borrow<py::object>(name));
      parts.meshes.push_back(part_in(part));
    }
    return parts;
  }
  for (const py::handle& part : given) {
    parts.names.push_back(py::int_(parts.names.size()));
    parts.meshes.push_back(part_in(part));
  }
  return parts;
}

std::optional<double> clearance_in(const py::handle& given) {
  if (given.is_none()) return {};
  const double clearance = given.cast<double>();
  if (!(clearance >= 0)) throw py::value_error("clash: clearance is below zero, or no number; give a length");
  return clearance;
}

/// What the rule says of each two in reach: nothing, for the clearance of all; False, not to ask; or a clearance.
std::vector<AskedPair> pairs_asked(const NamedParts& parts, std::optional<double> clearance, const py::object& rule) {
  std::vector<AskedPair> all;
  if (rule.is_none()) {
    all = pairs_in_reach(parts.meshes, clearance.value_or(0));
    for (AskedPair& p : all) p.clearance = clearance;
    return all;
  }
  double reach = clearance.value_or(0);
  // A rule may say any clearance, so it is asked of all pairs before the boxes are.
  std::vector<AskedPair> wanted;
  for (std::uint32_t a = 0; a < parts.meshes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < parts.meshes.size(); ++b) {
      const py::object said = rule(parts.names[a], parts.names[b]);
      if (py::isinstance<py::bool_>(said)) {
        if (!said.cast<bool>()) continue;
        wanted.push_back({a, b, clearance});
      } else {
        const auto own = clearance_in(said);
        wanted.push_back({a, b, own ? own : clearance});
      }
      reach = std::max(reach, wanted.back().clearance.value_or(0));
    }
  }
  const std::vector<AskedPair> near = pairs_in_reach(parts.meshes, reach);
  const auto key = [](const AskedPair& p) { return std::pair(p.a, p.b); };
  for (const AskedPair& p : wanted)
    if (std::ranges::binary_search(near, key(p), {}, key)) all.push_back(p);
  return all;
}

py::object told_clash(const PartClash& pair, const NamedParts& parts) {
  const Clash& c = pair.clash;
  py::array_t<std::int32_t> meeting(std::vector<py::ssize_t>{static_cast<py::ssize_t>(c.meeting.size()), 2});
  std::int32_t* at = meeting.mutable_data();
  for (const TrianglePair& p : c.meeting) {
    *at++ = static_cast<std::int32_t>(p.a);
    *at++ = static_cast<std::int32_t>(p.b);
  }
  py::object inner = py::none(), depth = py::none(), direction = py::none();
  if (c.inner) inner = parts.names[*c.inner == 0 ? pair.a : pair.b];
  if (c.depth) {
    depth = py::make_tuple(c.depth->lower, c.depth->upper);
    direction = row_of(c.depth->direction, 3);
  }
  return answer("Clash", parts.names[pair.a], parts.names[pair.b], std::string(name_of(c.kind)), row_of(c.place, 3),
                c.distance, inner, c.volume, depth, direction, meeting);
}

py::list clash(const py::object& given, const py::object& given_clearance, const py::object& rule, bool measure) {
  const NamedParts parts = parts_in(given);
  const std::vector<AskedPair> pairs = pairs_asked(parts, clearance_in(given_clearance), rule);
  ClashesOptions options;
  options.measure = measure;
  options.progress = interruptible();
  const Clashes found = unlocked([&] { return find_clashes(parts.meshes, pairs, options); });
  py::list told;
  for (const PartClash& pair : found.found) told.append(told_clash(pair, parts));
  return told;
}

}  // namespace

void add_clash(py::module_& module) {
  module.def(
      "clash", &clash, py::arg("parts"), py::kw_only(), py::arg("clearance") = py::none(), py::arg("rule") = py::none(),
      py::arg("measure") = true,
      "clash(parts, *, clearance=None, rule=None, measure=True)\n--\n\nWhich parts of an assembly touch, overlap, "
      "pierce or enclose one another, or come too near?\n\nA closed mesh is a solid, any other a sheet; all is decided "
      "exactly, of corners that a pose has moved as rounded once.\n\n"
      "Parameters\n----------\nparts : dict of names and parts, or sequence of parts, whose names are their numbers\n"
      "    A part is a Mesh, (Mesh, pose) with a matrix of shape (4, 4), or (Mesh, turn, translation) with a "
      "quaternion, "
      "w first.\nclearance : parts that are at most this far apart are told as well\n"
      "rule : function of two names\n    None or True asks with the clearance of all, False does not ask, a number is "
      "a "
      "clearance.\nmeasure : tell volume and depth, too\n\nReturns\n-------\nlist of Clash\n    All pairs that are not "
      "apart, in the order of parts.\n\nRaises\n------\nTypeError\n    If a part is no mesh.\nValueError\n    If a "
      "number is not finite, or a clearance is below zero.");
}

}  // namespace plumb::python
