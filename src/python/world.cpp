// Worlds: bodies that come, go and move by rigid poses.
#include "python/world.hpp"

#include <limits>

#include "python/figure_class.hpp"
#include "python/mesh.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

AnyPose pose_in(const py::object& turn, const py::object& translation, std::string_view function) {
  return pose_of(3, py::none(), turn, translation, function);
}

/// A figure, a mesh, or a list of these, which is a compound.
AnyBody body_of(const py::handle& given) {
  if (py::isinstance<TriangleMesh>(given)) return AnyBody(plumb::SharedMesh(given.cast<const TriangleMesh&>()));
  if (py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) {
    std::vector<AnyBody> parts;
    for (const py::handle& part : given) parts.push_back(body_of(part));
    return AnyBody::compound(parts);
  }
  return AnyBody(figure_or_point(given, {"CollisionWorld.add", "body"}));
}
AnyBody body_under(const py::object& given, const py::object& turn, const py::object& translation) {
  AnyBody body = body_of(given);
  if (turn.is_none() && translation.is_none()) return body;
  return body.under(pose_in(turn, translation, "CollisionWorld.add"));
}

py::array_t<std::uint64_t> told_handles(const std::vector<WorldPair>& pairs) {
  py::array_t<std::uint64_t> out(std::vector<py::ssize_t>{static_cast<py::ssize_t>(pairs.size()), 2});
  std::uint64_t* at = out.mutable_data();
  for (const WorldPair& p : pairs) *at++ = number_of(p.a), *at++ = number_of(p.b);
  return out;
}
py::object commit(CollisionWorld& self) {
  const WorldEvents& now = unlocked([&]() -> const WorldEvents& { return self.commit(); });
  return answer("WorldEvents", told_handles(now.begun), told_handles(now.kept), told_handles(now.ended));
}

py::tuple pairs(const CollisionWorld& self) {
  const std::vector<WorldPair>& all = self.pairs();
  py::array_t<bool> overlapping(static_cast<py::ssize_t>(all.size()));
  bool* at = overlapping.mutable_data();
  for (const WorldPair& p : all) *at++ = p.relation == Relation::overlapping;
  return py::make_tuple(told_handles(all), overlapping);
}

py::list contacts(const CollisionWorld& self) {
  py::list all;
  for (const WorldContact& c : self.contacts()) {
    all.append(answer("WorldContact", number_of(c.a), number_of(c.b), told_part(c.part_a), told_part(c.part_b),
                      answer_of(c.manifold)));
  }
  return all;
}

py::list told_corners(const std::vector<WorldCorner>& corners) {
  py::list all;
  for (const WorldCorner& c : corners) {
    all.append(answer("WorldCorner", number_of(c.a), number_of(c.b), told_part(c.part_a), told_part(c.part_b),
                      py::make_tuple(answer_of(c.id.a), answer_of(c.id.b))));
  }
  return all;
}
py::object corner_events(const CollisionWorld& self) {
  const WorldContactEvents& events = self.contact_events();
  return answer("WorldCornerEvents", told_corners(events.begun), told_corners(events.ended));
}

py::list told_near(const std::vector<WorldNear>& near) {
  py::list all;
  for (const WorldNear& n : near) all.append(answer("WorldNear", number_of(n.body), told_part(n.part), n.distance));
  return all;
}

void add_bodies(World& world) {
  world
      .def(
          "add",
          [](CollisionWorld& self, const py::object& body, std::uint32_t group, std::uint32_t mask,
             std::uint64_t user_id, double margin, bool is_static, const std::string& proxy, const py::object& turn,
             const py::object& translation) {
            const ProxyKind kind = proxy_in(proxy, "CollisionWorld.add");
            return number_of(
                self.add(body_under(body, turn, translation), {group, mask, user_id, margin, is_static, kind}));
          },
          py::arg("body"), py::kw_only(), py::arg("group") = 1, py::arg("mask") = every_group, py::arg("user_id") = 0,
          py::arg("margin") = 0.0, py::arg("is_static") = false, py::arg("proxy") = "none",
          py::arg("turn") = py::none(), py::arg("translation") = py::none(),
          "add(self, body, *, group=1, mask=0xffffffff, user_id=0, margin=0.0, is_static=False, proxy='none', "
          "turn=None,\n"
          "    translation=None)\n--\n\nPuts a bounded figure of space, a Mesh, or a list of these as one body into "
          "the world.  Its proxy, a\n'sphere', 'box' or 'hull', is asked first, and changes no "
          "answer.\n\nReturns\n-------\nint, its handle, which names no other body ever")
      .def(
          "move",
          [](CollisionWorld& self, std::uint64_t body, const py::object& turn, const py::object& translation) {
            self.move(handle_of(body), rigid_in(turn, translation, "CollisionWorld.move"));
          },
          py::arg("body"), py::kw_only(), py::arg("turn") = py::none(), py::arg("translation") = py::none(),
          "move(self, body, *, turn=None, translation=None)\n--\n\nThe pose takes the place of that which the body "
          "had.")
      .def(
          "replace",
          [](CollisionWorld& self, std::uint64_t body, const py::object& by) {
            self.replace(handle_of(body), body_of(by));
          },
          py::arg("body"), py::arg("by"), "replace(self, body, by)\n--\n\nAnother body by the same handle.")
      .def(
          "remove", [](CollisionWorld& self, std::uint64_t body) { self.remove(handle_of(body)); }, py::arg("body"),
          "remove(self, body)\n--\n\nIts handle is refused from then on.")
      .def("__len__", &CollisionWorld::size)
      .def("__contains__",
           [](const CollisionWorld& self, std::uint64_t body) { return self.contains(handle_of(body)); })
      .def(
          "user_id",
          [](const CollisionWorld& self, std::uint64_t body) { return self.options(handle_of(body)).user_id; },
          py::arg("body"), "user_id(self, body)\n--\n\nAs it was given.")
      .def(
          "allow_collision",
          [](CollisionWorld& self, std::uint64_t a, std::uint64_t b, bool allowed) {
            self.allow_collision(handle_of(a), handle_of(b), allowed);
          },
          py::arg("a"), py::arg("b"), py::arg("allowed") = true,
          "allow_collision(self, a, b, allowed=True)\n--\n\nMay these two collide without being told?");
}

void add_answers(World& world) {
  world
      .def("commit", commit,
           "commit(self)\n--\n\nWhich pairs have begun to meet, go on meeting, and have ended, since the last one?\n\n"
           "Returns\n-------\nWorldEvents")
      .def(
          "pairs", pairs,
          "pairs(self)\n--\n\nAll that meet, as of the last commit.\n\nReturns\n-------\npairs : uint64, shape (n, 2), "
          "handles\noverlapping : bool, shape (n,), False where a pair only touches")
      .def(
          "check",
          [](const CollisionWorld& self, std::size_t samples) {
            py::list told;
            for (const std::string& sentence : unlocked([&] { return self.check(samples); })) told.append(sentence);
            return told;
          },
          py::arg("samples") = 256,
          "check(self, samples=256)\n--\n\nWhat must hold and does not: a list of sentences, empty where all holds. "
          "So many bodies are\nheld against all others by asking again.")
      .def("contacts", contacts,
           "contacts(self)\n--\n\nWhere parts touch, as of the last commit, of a world made with contacts=True: a list "
           "of WorldContact.")
      .def("corner_events", corner_events,
           "corner_events(self)\n--\n\nWhich corners of contacts have begun and ended since the commit before the "
           "last?  All others were there\nbefore.\n\nReturns\n-------\nWorldCornerEvents")
      .def(
          "overlaps",
          [](const CollisionWorld& self, const py::object& figure, std::uint32_t mask) {
            std::vector<std::uint64_t> found;
            const AnyFigure region = figure_or_point(figure, {"CollisionWorld.overlaps", "figure"});
            for (const BodyHandle& h : self.overlaps(region, mask)) found.push_back(number_of(h));
            return array_of<std::uint64_t>(std::span<const std::uint64_t>(found));
          },
          py::arg("figure"), py::arg("mask") = every_group,
          "overlaps(self, figure, mask=0xffffffff)\n--\n\nThe handles of the bodies that have a point in the figure, "
          "as "
          "they stand now.")
      .def(
          "nearest",
          [](const CollisionWorld& self, const py::object& figure, std::size_t k, std::uint32_t mask) {
            return told_near(self.nearest(figure_or_point(figure, {"CollisionWorld.nearest", "figure"}), k, mask));
          },
          py::arg("figure"), py::arg("k") = 1, py::arg("mask") = every_group,
          "nearest(self, figure, k=1, mask=0xffffffff)\n--\n\nThe bodies nearest to a figure or point: a list of "
          "WorldNear, nearest first.")
      .def(
          "within",
          [](const CollisionWorld& self, const py::object& figure, double distance, std::uint32_t mask) {
            return told_near(self.within(figure_or_point(figure, {"CollisionWorld.within", "figure"}), distance, mask));
          },
          py::arg("figure"), py::arg("distance"), py::arg("mask") = every_group,
          "within(self, figure, distance, mask=0xffffffff)\n--\n\nThe bodies no farther than that from a figure or "
          "point: a list of WorldNear, nearest first.")
      .def(
          "nearest_pairs",
          [](const CollisionWorld& self, std::size_t k, double within) {
            py::list told;
            for (const WorldNearPair& p : unlocked([&] { return self.nearest_pairs(k, within); })) {
              told.append(answer("WorldNearPair", number_of(p.a), number_of(p.b), told_part(p.part_a),
                                 told_part(p.part_b), p.distance));
            }
            return told;
          },
          py::arg("k") = 1, py::arg("within") = std::numeric_limits<double>::infinity(),
          "nearest_pairs(self, k=1, within=inf)\n--\n\nThe k pairs of bodies nearest to one another and no farther "
          "than that: a list of\nWorldNearPair, nearest first.");
}

}  // namespace

RigidPose rigid_in(const py::object& turn, const py::object& translation, std::string_view function) {
  const AnyPose pose = pose_in(turn, translation, function);
  const auto* rigid = std::get_if<RigidPose>(&pose);
  return rigid != nullptr ? *rigid : RigidPose{};
}

void add_world(py::module_& module) {
  World world(
      module, "CollisionWorld",
      "CollisionWorld(contacts=False)\n--\n\nBodies that come, go and move by rigid poses: which meet, where, and "
      "what has begun and ended.\n\nAnswers are those of real arithmetic, ordered by exact numbers and then by "
      "user ids.\nOne that is removed, and what is no body, raises ValueError, which names it.");
  world.def(py::init([](bool contacts) {
              return std::make_unique<CollisionWorld>(CollisionWorldOptions{.contacts = contacts});
            }),
            py::arg("contacts") = false);
  add_bodies(world);
  add_answers(world);
  add_world_motion(world);
  add_world_plan(world);
}

}  // namespace plumb::python
