// A tower of crates, a crate that slides, one that spins on its foot and a barrel that rolls: rigid bodies under gravity,
// stepped by sequential impulses that are found again by the ids of their contacts.
//
// What it prints is how often an id was lost while its pair stayed in contact, and how often a normal turned by more than
// five degrees from one frame to the next.
#include <cmath>
#include <cstdio>
#include <map>
#include <plumb/query.hpp>
#include <utility>
#include <variant>
#include <vector>

using namespace plumb;

namespace {

Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector3 operator*(const Vector3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
Vector3 operator-(const Vector3& a, const Vector3& b) { return a + b * -1; }
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr double step = 1.0 / 60, friction = 0.4;

/// A crate, or a barrel about its first axis.  The inertia is that of a ball, near enough for a demonstration.
struct Body {
  Vector3 at, half;
  bool is_round = false;
  Vector3 velocity{0, 0, 0}, spin{0, 0, 0};
  std::array<double, 4> turn{1, 0, 0, 0};  // a quaternion

  [[nodiscard]] double inverse_mass() const { return 1 / (8 * half.x * half.y * half.z); }
  [[nodiscard]] double inverse_inertia() const {
    const double r = std::fmax(half.x, std::fmax(half.y, half.z));
    return inverse_mass() / (0.6 * r * r);
  }
  [[nodiscard]] std::array<Vector3, 3> axes() const {
    const auto [w, x, y, z] = turn;
    return {Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            Vector3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
  }
  [[nodiscard]] std::variant<Obb3, Capsule3> shape() const {
    const Point3 center{at.x, at.y, at.z};
    const auto u = axes();
    if (!is_round) return Obb3{center, u, half};
    const Vector3 a = at - u[0] * half.x, b = at + u[0] * half.x;
    return Capsule3{{a.x, a.y, a.z}, {b.x, b.y, b.z}, half.y};
  }
  void move() {
    at = at + velocity * step;
    const auto [w, x, y, z] = turn;
    const Vector3 s = spin * (step / 2);
    turn = {w - s.x * x - s.y * y - s.z * z, x + s.x * w + s.y * z - s.z * y, y + s.y * w + s.z * x - s.x * z,
            z + s.z * w + s.x * y - s.y * x};
    const double length = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    for (double& part : turn) part /= length;
  }
};

/// One corner of a contact, and what was pushed there along its normal and across it.
struct Push {
  Body *a, *b;  // b may be the ground, which has none
  Vector3 normal, arm_a, arm_b;
  double distance, along = 0;
  Vector3 across{0, 0, 0};

  void apply(const Vector3& impulse) const {
    a->velocity = a->velocity - impulse * a->inverse_mass();
    a->spin = a->spin - cross(arm_a, impulse) * a->inverse_inertia();
    if (b == nullptr) return;
    b->velocity = b->velocity + impulse * b->inverse_mass();
    b->spin = b->spin + cross(arm_b, impulse) * b->inverse_inertia();
  }
  /// Of b against a.
  [[nodiscard]] Vector3 speed() const {
    const Vector3 of_a = a->velocity + cross(a->spin, arm_a);
    return b == nullptr ? of_a * -1 : b->velocity + cross(b->spin, arm_b) - of_a;
  }
  [[nodiscard]] double mass(const Vector3& n) const {
    const auto part = [&](const Body& body, const Vector3& arm) {
      const Vector3 c = cross(arm, n);
      return body.inverse_mass() + dot(c, c) * body.inverse_inertia();
    };
    return 1 / (part(*a, arm_a) + (b == nullptr ? 0 : part(*b, arm_b)));
  }
  void solve() {
    const double target = distance > 0 ? -distance / step : 0.1 * std::fmax(0.0, -distance - 0.001) / step;
    const double more = std::fmax(-along, mass(normal) * (target - dot(speed(), normal)));
    along += more, apply(normal * more);
    const Vector3 slip = speed() - normal * dot(speed(), normal);
    const double size = std::sqrt(dot(slip, slip)), most = friction * along;
    if (size == 0) return;
    const Vector3 before = across;
    across = across - slip * (mass(slip * (1 / size)));
    const double all = std::sqrt(dot(across, across));
    if (all > most) across = across * (most / all);
    apply(across - before);
  }
};

using Key = std::pair<std::pair<std::size_t, std::size_t>, ContactId>;

struct Scene {
  std::vector<Body> bodies;
  std::map<std::pair<std::size_t, std::size_t>, ContactCache> caches;
  std::map<std::pair<std::size_t, std::size_t>, Vector3> normals;
  std::map<Key, Push> pushes;
  int corners = 0, lost = 0, turned = 0;

  void see(std::size_t i, std::size_t j, std::map<Key, Push>& next) {
    const bool on_ground = j == bodies.size();
    const std::pair pair{i, j};
    std::variant<Obb3, Capsule3> other;
    if (!on_ground) other = bodies[j].shape();
    const Aabb3 ground{{-100, -1, -100}, {100, 0, 100}};
    ContactCache& cache = caches[pair];
    const ContactManifoldOptions options{.margin = 0.02, .at_most = 4};
    const auto m = std::visit(
        [&](const auto& a) {
          if (on_ground) return contact(a, ground, options, &cache);
          return std::visit([&](const auto& b) { return contact(a, b, options, &cache); }, other);
        },
        bodies[i].shape());
    const auto last = normals.find(pair);
    if (!m) {
      if (last != normals.end()) normals.erase(last);
      return;
    }
    if (last != normals.end()) {
      turned += dot(last->second, m->normal) < 0.996 ? 1 : 0;
      for (const auto& [key, push] : pushes) {
        if (key.first != pair) continue;
        bool is_there = false;
        for (const ContactCorner& c : m->corners) is_there = is_there || c.id == key.second;
        lost += is_there ? 0 : 1;
      }
    }
    normals[pair] = m->normal;
    for (const ContactCorner& c : m->corners) {
      ++corners;
      const Vector3 p{c.on_a.x, c.on_a.y, c.on_a.z}, q{c.on_b.x, c.on_b.y, c.on_b.z};
      Push push{&bodies[i],
                on_ground ? nullptr : &bodies[j],
                m->normal,
                p - bodies[i].at,
                on_ground ? Vector3{0, 0, 0} : q - bodies[j].at,
                c.distance};
      const auto before = pushes.find({pair, c.id});
      if (before != pushes.end()) push.along = before->second.along, push.across = before->second.across;
      next.emplace(Key{pair, c.id}, push);
    }
  }
  void frame() {
    for (Body& b : bodies) b.velocity.y -= 9.81 * step;
    std::map<Key, Push> next;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = i + 1; j <= bodies.size(); ++j) see(i, j, next);
    }
    pushes = std::move(next);
    for (auto& [key, push] : pushes) push.apply(push.normal * push.along + push.across);
    for (int k = 0; k < 20; ++k) {
      for (auto& [key, push] : pushes) push.solve();
    }
    for (Body& b : bodies) b.move();
  }
  void run(const char* name, int frames) {
    for (int k = 0; k < frames; ++k) frame();
    std::printf("%s: %d ids lost, %d normals turned, %s\n", name, lost, turned,
                corners >= 2 * frames ? "in contact" : "not in contact");
  }
};

}  // namespace

int main() {
  Scene tower;
  for (int k = 0; k < 5; ++k) {
    const double size = 0.6 - 0.05 * k;
    double height = 0.3;
    for (int below = 0; below < k; ++below) height += 0.6 - 0.05 * below - 0.025;
    tower.bodies.push_back({{0.01 * k, height, 0.007 * k}, {size / 2, size / 2, size / 2}});
  }
  tower.run("a tower that rests", 240);
  std::printf("its top is at %.1f\n", tower.bodies.back().at.y);

  Scene slide;
  slide.bodies.push_back({{0, 0.25, 0}, {0.5, 0.25, 0.4}, false, {3, 0, 0.5}});
  slide.run("a crate that slides", 120);

  Scene spin;
  spin.bodies.push_back({{0, 0.25, 0}, {0.5, 0.25, 0.4}, false, {0, 0, 0}, {0, 6, 0}});
  spin.run("a crate that spins", 120);

  Scene roll;
  roll.bodies.push_back({{0, 0.25, 0}, {0.5, 0.25, 0.25}, true, {0, 0, 1}, {4, 0, 0}});
  roll.run("a barrel that rolls", 120);
}
