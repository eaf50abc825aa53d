// A small game loop: a player walks into a vault, takes a coin, is seen by a guard through a gap, and shoots at a pane that
// is as thin as a sheet.
//
// Each frame moves what moves, commits, and reads what has begun and ended; rays and motions are asked of the world as it
// stands.  What it prints is the same on any machine and on any number of threads.
#include <cstdio>
#include <plumb/query.hpp>
#include <plumb/world.hpp>
#include <vector>

using namespace plumb;

namespace {

enum Name : std::uint64_t { player, coin, vault, guard, left_wall, right_wall, pane, bullet };
constexpr const char* names[] = {"player", "coin", "vault", "guard", "left wall", "right wall", "pane", "bullet"};
constexpr std::uint32_t solid = 1, sensor = 2, seen = 4;  // groups

Point3 eye_of(double x) { return {x, 0, 1.5}; }

void tell(int frame, const char* what, const WorldPair& p) {
  std::printf("frame %d: %s %s %s\n", frame, names[p.id_a], what, names[p.id_b]);
}

}  // namespace

int main() {
  CollisionWorld world;
  const AnyBody body = AnyBody::compound({Capsule3{{0, 0, 0.25}, {0, 0, 1}, 0.25}, Sphere3{{0, 0, 1.5}, 0.25}});
  const BodyHandle walker = world.add(body, {.group = solid | seen, .user_id = player});
  const BodyHandle gold = world.add(Sphere3{{4, 0, 0.5}, 0.25}, {.group = sensor, .user_id = coin, .is_static = true});
  world.add(Aabb3{{3, -2, 0}, {6, 2, 3}}, {.group = sensor, .user_id = vault, .is_static = true});
  const Point3 watch{4, 5, 1.5};
  world.add(Sphere3{watch, 0.25}, {.group = solid, .user_id = guard, .is_static = true});
  // Two walls between the player's way and the guard, with a gap.
  const SharedMesh sheet(TriangleMesh{{{-4, 0, 0}, {4, 0, 0}, {4, 0, 3}, {-4, 0, 3}}, {{0, 1, 2}, {0, 2, 3}}});
  world.add(AnyBody(sheet, RigidPose{{}, {-1, 2, 0}}),
            {.group = solid | seen, .user_id = left_wall, .is_static = true});
  world.add(AnyBody(sheet, RigidPose{{}, {9, 2, 0}}),
            {.group = solid | seen, .user_id = right_wall, .is_static = true});
  world.add(Triangle3{{1e6, -1, 0}, {1e6, 1, 0}, {1e6, 0, 3}}, {.group = solid, .user_id = pane, .is_static = true});

  for (int frame = 0; frame <= 8; ++frame) {
    world.move(walker, RigidPose{{}, {double(frame), 0, 0}});
    const WorldEvents now = world.commit();
    for (const WorldPair& p : now.begun) tell(frame, "meets", p);
    for (const WorldPair& p : now.ended) tell(frame, "leaves", p);
    for (const WorldPair& p : now.begun) {
      if (p.id_b == coin) world.remove(gold);
    }
    const auto first = world.first_hit(Segment3{watch, eye_of(frame)}, seen);
    if (first && first->user_id == player) std::printf("frame %d: the guard sees the player\n", frame);
  }

  const BodyHandle shot = world.add(Sphere3{eye_of(9), 0.125}, {.group = solid, .user_id = bullet});
  const std::vector<BodyMotion> motions{{shot, {2e6, 0, 0}}, {walker, {0, 0.5, 0}}};  // within one frame
  for (const WorldImpact& i : world.first_contacts(motions)) {
    std::printf("the %s meets the %s at time %.9f\n", names[i.id_b], names[i.id_a], i.contact.time);
  }
}
