// An arm of six joints over a table: how far are its links from one another and from what stands around, and where do they
// come closest?
//
// A link is a shape in the frame of its last joint, posed by the chain of the joints that carry it.  A joint's turn is a
// quaternion, which keeps lengths exactly; how far it is from the angle that was asked is known.  Neighbors share a joint
// and always meet, so that they are no pair.
#include <cstdio>
#include <numbers>
#include <plumb/figure.hpp>
#include <plumb/query.hpp>
#include <variant>
#include <vector>

using namespace plumb;

namespace {

/// In the frame of the joint before it.
struct Joint {
  Vector3 at, axis;
};
constexpr std::array joints{
    Joint{{0, 0, 0.1}, {0, 0, 1}}, Joint{{0, 0, 0.25}, {0, 1, 0}}, Joint{{0, 0, 0.45}, {0, 1, 0}},
    Joint{{0, 0, 0.4}, {0, 1, 0}}, Joint{{0, 0, 0.12}, {0, 0, 1}}, Joint{{0, 0, 0.1}, {0, 1, 0}},
};
using Angles = std::array<double, joints.size()>;  // in radians

/// Carried by that many joints; what stands around is carried by none.
struct Part {
  const char* name;
  std::size_t joints;
  std::variant<Capsule3, Aabb3> shape;
};
const std::vector<Part> parts{
    {"shoulder", 1, Capsule3{{0, 0, 0}, {0, 0, 0.2}, 0.09}},
    {"upper arm", 2, Capsule3{{0, 0, 0}, {0, 0, 0.45}, 0.07}},
    {"forearm", 3, Capsule3{{0, 0, 0}, {0, 0, 0.4}, 0.06}},
    {"wrist", 4, Aabb3{{-0.05, -0.05, 0}, {0.05, 0.05, 0.12}}},
    {"hand", 6, Aabb3{{-0.09, -0.03, 0}, {0.09, 0.03, 0.15}}},
    {"table", 0, Aabb3{{-1, -1, -0.05}, {1, 1, 0}}},
    {"post", 0, Capsule3{{0.75, 0.3, 0}, {0.75, 0.3, 1.2}, 0.04}},
};
constexpr std::array<std::array<std::size_t, 2>, 10> pairs{
    {{0, 2}, {0, 3}, {0, 4}, {1, 3}, {1, 4}, {2, 4}, {2, 5}, {3, 5}, {4, 5}, {4, 6}}};

/// Where each part is, the joints at these angles; `off` is the most by which a turn differs from its angle.
class Posture {
 public:
  explicit Posture(const Angles& angles) {
    RigidChain chain;
    chains_.push_back(chain);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto [turn, off] = rotation(joints[i].axis, angles[i]);
      off_ = off > off_ ? off : off_;
      chain.links.push_back({turn, joints[i].at});
      chains_.push_back(chain);
    }
  }
  [[nodiscard]] double off() const { return off_; }
  [[nodiscard]] Closest closest(std::size_t a, std::size_t b) const {
    return std::visit(
        [&](const auto& p, const auto& q) {
          return closest_points(Posed{p, chains_[parts[a].joints]}, Posed{q, chains_[parts[b].joints]});
        },
        parts[a].shape, parts[b].shape);
  }

 private:
  std::vector<RigidChain> chains_;
  double off_ = 0;
};

}  // namespace

int main() {
  constexpr double degree = std::numbers::pi / 180;
  const auto posture = [&](int elbow) {
    return Posture({35 * degree, 40 * degree, elbow * degree, 25 * degree, 50 * degree, 20 * degree});
  };
  std::puts("elbow  nearest pair        distance");
  int tightest = 0;
  double least = 10;
  for (int elbow = 20; elbow <= 100; elbow += 20) {
    const Posture p = posture(elbow);
    double nearest = 10;
    std::array<std::size_t, 2> which{};
    for (const auto& [a, b] : pairs) {
      const double d = p.closest(a, b).distance;
      if (d < nearest) nearest = d, which = {a, b};
    }
    std::printf("%5d  %-9s %-9s %8.4f\n", elbow, parts[which[0]].name, parts[which[1]].name, nearest);
    if (nearest < least) least = nearest, tightest = elbow;
  }

  const Posture p = posture(tightest);
  std::printf("\nat %d degrees, meters; each turn is within 2^-23 radians of its angle: %s\n", tightest,
              p.off() <= 0x1p-23 ? "yes" : "no");
  std::puts("pair                distance  from                       to");
  for (const auto& [a, b] : pairs) {
    const Closest c = p.closest(a, b);
    std::printf("%-9s %-9s %8.4f  (%7.4f %7.4f %7.4f)  (%7.4f %7.4f %7.4f)\n", parts[a].name, parts[b].name, c.distance,
                c.on_a.x, c.on_a.y, c.on_a.z, c.on_b.x, c.on_b.y, c.on_b.z);
  }
}
