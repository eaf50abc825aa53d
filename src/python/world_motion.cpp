// Worlds: what rays hit, and what is met on the way.
#include "python/figure_class.hpp"
#include "python/unlocked.hpp"
#include "python/world.hpp"

namespace plumb::python {
namespace {

py::object told_hit(const WorldHit& h) {
  return answer("WorldHit", number_of(h.body), told_part(h.part), h.hit.t, row_of(h.hit.point, 3),
                row_of(h.hit.normal, 3));
}
py::object told_contact(const Contact& c) {
  return answer("FirstContact", c.time, answer_of(c.feature_a), answer_of(c.feature_b));
}
py::object told_cast(const WorldCast& c) {
  return answer("WorldCast", number_of(c.body), told_part(c.part), told_contact(c.contact));
}

Vector3 way_of(const py::object& given, const char* function) {
  bool single = false;
  const py::array_t<double> rows = row_or_rows_of(given, {function, "by"}, 3, single);
  if (rows.size() != 3) throw py::value_error(std::string(function) + ": by has several rows; give three numbers");
  return points_of<Vector3>(rows)[0];
}
AnyRay ray_of(const py::object& given, const char* function) {
  const AnyFigure figure = figure_or_point(given, {function, "ray"});
  if (const auto* r = get_if<Ray3>(figure)) return *r;
  if (const auto* s = get_if<Segment3>(figure)) return *s;
  if (const auto* l = get_if<Line3>(figure)) return *l;
  throw py::type_error(std::string(function) + ": ray is no Ray3, Segment3 or Line3 of space");
}

py::object first_hit_of(const CollisionWorld& self, const py::object& ray, std::uint32_t mask) {
  const auto hit = self.first_hit(ray_of(ray, "CollisionWorld.first_hit"), mask);
  if (!hit) return py::none();
  return told_hit(*hit);
}
py::list hits_of(const CollisionWorld& self, const py::object& ray, std::uint32_t mask) {
  py::list all;
  for (const WorldHit& hit : self.hits(ray_of(ray, "CollisionWorld.hits"), mask)) all.append(told_hit(hit));
  return all;
}

py::object first_contact_of(const CollisionWorld& self, const py::object& figure, const py::object& by,
                            std::uint32_t mask) {
  constexpr const char* function = "CollisionWorld.first_contact";
  const auto cast = self.first_contact(figure_or_point(figure, {function, "figure"}), way_of(by, function), mask);
  if (!cast) return py::none();
  return told_cast(*cast);
}
py::list contacts_along_of(const CollisionWorld& self, const py::object& figure, const py::object& by,
                           std::uint32_t mask) {
  constexpr const char* function = "CollisionWorld.contacts_along";
  const AnyFigure moving = figure_or_point(figure, {function, "figure"});
  const Vector3 way = way_of(by, function);
  py::list all;
  for (const WorldCast& c : unlocked([&] { return self.contacts_along(moving, way, mask); })) all.append(told_cast(c));
  return all;
}

py::list impacts(const CollisionWorld& self, const py::dict& motions) {
  std::vector<BodyMotion> all;
  for (const auto& [body, by] : motions) {
    all.push_back({handle_of(body.cast<std::uint64_t>()),
                   way_of(py::reinterpret_borrow<py::object>(by), "CollisionWorld.first_contacts")});
  }
  py::list told;
  for (const WorldImpact& c : unlocked([&] { return self.first_contacts(all); })) {
    told.append(answer("WorldImpact", number_of(c.a), number_of(c.b), told_part(c.part_a), told_part(c.part_b),
                       told_contact(c.contact), c.rank));
  }
  return told;
}

py::list spans(const CollisionWorld& self, const py::dict& turns, double resolution) {
  constexpr const char* function = "CollisionWorld.first_contact_spans";
  std::vector<BodyTurn> all;
  for (const auto& [body, to] : turns) {
    if (!py::isinstance<py::tuple>(to) || py::len(to) != 2) {
      throw py::type_error(std::string(function) + ": turns has no pair of a turn and a translation");
    }
    const auto pose = to.cast<py::tuple>();
    all.push_back({handle_of(body.cast<std::uint64_t>()), rigid_in(pose[0], pose[1], function)});
  }
  const HalvingOptions options{.resolution = resolution};
  py::list told;
  for (const WorldContactSpan& c : unlocked([&] { return self.first_contact_spans(all, options); })) {
    told.append(answer("WorldContactSpan", number_of(c.a), number_of(c.b), c.span.from, c.span.to, c.is_certain));
  }
  return told;
}

py::list spans_along(const CollisionWorld& self, const py::object& figure, const py::object& turn,
                     const py::object& translation, std::uint32_t mask, double resolution) {
  constexpr const char* function = "CollisionWorld.contact_spans_along";
  const AnyFigure moving = figure_or_point(figure, {function, "figure"});
  const RigidPose to = rigid_in(turn, translation, function);
  py::list told;
  for (const WorldCastSpan& c : unlocked([&] { return self.contact_spans_along(moving, to, mask, resolution); }))
    told.append(answer("WorldCastSpan", number_of(c.body), c.span.from, c.span.to, c.is_certain));
  return told;
}

}  // namespace

void add_world_motion(World& world) {
  world
      .def("first_hit", first_hit_of, py::arg("ray"), py::arg("mask") = every_group,
           "first_hit(self, ray, mask=0xffffffff)\n--\n\nWhich body does a Ray3, Segment3 or Line3 hit first?\n\n"
           "Returns\n-------\nWorldHit, or None")
      .def(
          "any_hit",
          [](const CollisionWorld& self, const py::object& ray, std::uint32_t mask) {
            return self.any_hit(ray_of(ray, "CollisionWorld.any_hit"), mask);
          },
          py::arg("ray"), py::arg("mask") = every_group,
          "any_hit(self, ray, mask=0xffffffff)\n--\n\nIs any body hit?  It asks less than first_hit does.")
      .def("hits", hits_of, py::arg("ray"), py::arg("mask") = every_group,
           "hits(self, ray, mask=0xffffffff)\n--\n\nWhere is each body hit first?\n\nReturns\n-------\nlist of "
           "WorldHit, "
           "in the order of the ray")
      .def("first_contact", first_contact_of, py::arg("figure"), py::arg("by"), py::arg("mask") = every_group,
           "first_contact(self, figure, by, mask=0xffffffff)\n--\n\nWhich body does a figure that moves along a vector "
           "come to first?\n\nReturns\n-------\nWorldCast, or None")
      .def("contacts_along", contacts_along_of, py::arg("figure"), py::arg("by"), py::arg("mask") = every_group,
           "contacts_along(self, figure, by, mask=0xffffffff)\n--\n\nWhich bodies does a figure that moves along a "
           "vector "
           "come to, and when first?\n\nReturns\n-------\nlist of WorldCast, by exact times")
      .def("first_contacts", impacts, py::arg("motions"),
           "first_contacts(self, motions)\n--\n\nBodies move at once, each by a vector during time [0, 1]: which pairs "
           "meet, and when first?\n\nParameters\n----------\nmotions : dict of handles and vectors\n\n"
           "Returns\n-------\nlist of WorldImpact, by exact times; those of one rank are at exactly one time")
      .def(
          "first_contact_spans", spans, py::arg("turns"), py::arg("resolution") = 0x1p-12,
          "first_contact_spans(self, turns, resolution=2**-12)\n--\n\nBodies go at once, each from its pose to another "
          "during time [0, 1]: which pairs may meet, and when\nfirst?\n\nParameters\n----------\nturns : dict of "
          "handles and pairs (turn, translation), each may be None\nresolution : float, the longest span that is "
          "told\n\nReturns\n-------\nlist of WorldContactSpan; before its span a pair does not meet, for certain")
      .def("contact_spans_along", spans_along, py::arg("figure"), py::kw_only(), py::arg("turn") = py::none(),
           py::arg("translation") = py::none(), py::arg("mask") = every_group, py::arg("resolution") = 0x1p-12,
           "contact_spans_along(self, figure, *, turn=None, translation=None, mask=0xffffffff, "
           "resolution=2**-12)\n--\n\n"
           "A figure goes from its rigid pose to another during time [0, 1]: which bodies may it come to, and\nwhen "
           "first?\n\nReturns\n-------\nlist of WorldCastSpan, by where spans begin; before its span the figure does "
           "not "
           "meet a body, for\ncertain, and what is not told it never does");
}

}  // namespace plumb::python
