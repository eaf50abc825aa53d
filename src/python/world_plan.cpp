// Worlds: what changes which questions are asked, and no answer but by a filter of the caller's.
#include "plumb/world/plan.hpp"
#include "python/fractions.hpp"
#include "python/named.hpp"
#include "python/unlocked.hpp"
#include "python/world.hpp"

namespace plumb::python {
namespace {

py::object told_plan(const WorldPlan& plan) {
  py::list bodies;
  for (const BodyPlan& b : plan.bodies) {
    bodies.append(answer("BodyPlan", number_of(b.body), std::string(name_of(b.proxy)), b.pairs, b.told_apart, b.saved));
  }
  py::object index = py::none();
  if (plan.index) index = py::str(std::string(name_of(plan.index->best().method)));
  return answer("WorldPlan", bodies, plan.questions_without, plan.questions_with, index);
}

/// What of it a world adopts.
WorldPlan plan_in(const py::object& given) {
  WorldPlan plan;
  for (const py::handle& body : given.attr("bodies")) {
    BodyPlan& of = plan.bodies.emplace_back();
    of.body = handle_of(body.attr("body").cast<std::uint64_t>());
    of.proxy = proxy_in(body.attr("proxy").cast<std::string>(), "CollisionWorld.adopt");
  }
  return plan;
}

void set_filter_of(CollisionWorld& self, const py::object& keeps) {
  if (keeps.is_none()) return self.clear_filter();
  if (PyCallable_Check(keeps.ptr()) == 0) throw py::type_error("CollisionWorld.set_filter: keeps is no function");
  self.set_filter([keeps](const BodyHandle& a, const BodyHandle& b) {
    const py::gil_scoped_acquire held;
    return py::bool_(keeps(number_of(a), number_of(b))).cast<bool>();
  });
}

}  // namespace

ProxyKind proxy_in(const std::string& given, const char* function) {
  return named<ProxyKind>({function, "proxy"}, given,
                          {{name_of(ProxyKind::none), ProxyKind::none},
                           {name_of(ProxyKind::sphere), ProxyKind::sphere},
                           {name_of(ProxyKind::obb), ProxyKind::obb},
                           {name_of(ProxyKind::hull), ProxyKind::hull}});
}

void add_world_plan(World& world) {
  world
      .def(
          "proxy",
          [](const CollisionWorld& self, std::uint64_t body) {
            return std::string(name_of(self.options(handle_of(body)).proxy));
          },
          py::arg("body"), "proxy(self, body)\n--\n\n'none', 'sphere', 'box' or 'hull'.")
      .def(
          "set_proxy",
          [](CollisionWorld& self, std::uint64_t body, const std::string& proxy) {
            self.set_proxy(handle_of(body), proxy_in(proxy, "CollisionWorld.set_proxy"));
          },
          py::arg("body"), py::arg("proxy"),
          "set_proxy(self, body, proxy)\n--\n\nWhat misses the proxy, a 'sphere', a 'box' or a 'hull' that holds the "
          "body, is not asked about the\nbody; 'none' asks always.  No answer depends on it.\n\nRaises\n------\n"
          "ValueError\n    If the body has no proxy of the kind, as a flat one has no hull.")
      .def(
          "plan",
          [](const CollisionWorld& self, double moving_share) {
            return told_plan(unlocked([&] { return plan(self, {.moving_share = moving_share}); }));
          },
          py::arg("moving_share") = 1.0,
          "plan(self, moving_share=1.0)\n--\n\nFor which bodies does a proxy pay, and which one?\n\nParameters\n"
          "----------\nmoving_share : of the bodies, from one frame to the next; for the index "
          "alone\n\nReturns\n-------\n"
          "WorldPlan, which the world adopts if asked to")
      .def(
          "adopt", [](CollisionWorld& self, const py::object& taken) { adopt(self, plan_in(taken)); }, py::arg("plan"),
          "adopt(self, plan)\n--\n\nGives each body the proxy of a plan; every answer stays what it was.")
      .def("set_filter", set_filter_of, py::arg("keeps"),
           "set_filter(self, keeps)\n--\n\nPairs of which keeps(a, b), of two handles, is false are left out from the "
           "next "
           "commit on; None leaves\nout none.\n\nEach is asked once a commit, in the order of pairs.  The function may "
           "ask the world, and not change it;\nwhat it raises is raised by commit, and leaves the world as it was.");
}

}  // namespace plumb::python
