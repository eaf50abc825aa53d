// How long do the distance and the closest points of an arm's links take under rigid poses?  Ours, exact, and FCL's in
// doubles; capsules and boxes in pairs that are apart, and the same without poses.
//
// Classes: ten pairs of an arm (four of two capsules, four of a capsule and a box, two of boxes) at once, under poses on the
// lattice of turns and under chains of three of them; and each kind of pair by itself, under such a pose and as it stands.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "plumb/query/separation/posed.hpp"
#ifdef PLUMB_BENCH_RIGID_RIVAL
#include <fcl/narrowphase/distance.h>
#endif

namespace plumb {
namespace {

using Link = Posed<Capsule3, RigidPose>;
using Box = Posed<Obb3, RigidPose>;

/// Turns whose matrices are doubles, and places some way apart.
class Places {
 public:
  RigidPose operator()(double x) {
    std::normal_distribution<double> part;
    double w = part(random_), i = part(random_), j = part(random_), k = part(random_);
    const double length = std::sqrt(w * w + i * i + j * j + k * k);
    const auto whole = [&](double q) { return std::nearbyint(q / length * 0x1p25) * 0x1p-25; };
    std::uniform_real_distribution<double> off(-0.4, 0.4);
    return {{whole(w), whole(i), whole(j), whole(k)}, {x + off(random_), off(random_), off(random_)}};
  }

 private:
  std::mt19937_64 random_{36};
};

struct Scene {
  static constexpr std::size_t count = 512;
  std::vector<Link> links;
  std::vector<Box> boxes;
  Scene() {
    Places place;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 4 * static_cast<double>(i);
      links.push_back({{{0, 0, -0.5}, {0, 0, 0.5}, 0.2}, place(x)});
      boxes.push_back({{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0.5, 0.3, 0.2}}, place(x + 2)});
    }
  }
};
const Scene& scene() {
  static const Scene s;
  return s;
}

/// The same numbers without a pose, as near as doubles go.
Capsule3 standing(const Link& l) {
  const auto m = *exact_matrix(l.pose.turn);
  const auto at = [&](const Point3& p) {
    const auto& [c, s] = m;
    const auto& t = l.pose.translation;
    return Point3{(c[0].x * p.x + c[1].x * p.y + c[2].x * p.z) / s + t.x,
                  (c[0].y * p.x + c[1].y * p.y + c[2].y * p.z) / s + t.y,
                  (c[0].z * p.x + c[1].z * p.y + c[2].z * p.z) / s + t.z};
  };
  return {at(l.shape.a), at(l.shape.b), l.shape.radius};
}
Obb3 standing(const Box& b) {
  const auto [c, s] = *exact_matrix(b.pose.turn);
  const auto over = [s = s](const Vector3& v) { return Vector3{v.x / s, v.y / s, v.z / s}; };
  const auto& t = b.pose.translation;
  return {{t.x, t.y, t.z}, {over(c[0]), over(c[1]), over(c[2])}, b.shape.half};
}

template <class A, class B>
void measure(benchmark::State& state, const std::vector<A>& a, const std::vector<B>& b, std::size_t apart) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(closest_points(a[i], b[i + apart]));
    i = (i + 1) % (Scene::count - 1);
  }
}
template <class A>
auto all_standing(const std::vector<A>& posed) {
  std::vector<decltype(standing(posed[0]))> all;
  for (const A& p : posed) all.push_back(standing(p));
  return all;
}

void capsules_posed(benchmark::State& s) { measure(s, scene().links, scene().links, 1); }
void capsule_box_posed(benchmark::State& s) { measure(s, scene().links, scene().boxes, 0); }
void boxes_posed(benchmark::State& s) { measure(s, scene().boxes, scene().boxes, 1); }
void capsules_standing(benchmark::State& s) {
  const auto a = all_standing(scene().links);
  measure(s, a, a, 1);
}
void capsule_box_standing(benchmark::State& s) {
  measure(s, all_standing(scene().links), all_standing(scene().boxes), 0);
}
void boxes_standing(benchmark::State& s) {
  const auto b = all_standing(scene().boxes);
  measure(s, b, b, 1);
}
BENCHMARK(capsules_posed);
BENCHMARK(capsules_standing);
BENCHMARK(capsule_box_posed);
BENCHMARK(capsule_box_standing);
BENCHMARK(boxes_posed);
BENCHMARK(boxes_standing);

template <class Links, class Boxes>
void measure_arm(benchmark::State& state, const Links& links, const Boxes& boxes) {
  std::size_t i = 0;
  for (auto _ : state) {
    for (std::size_t k = 0; k < 4; ++k) {
      benchmark::DoNotOptimize(closest_points(links[i + k], links[i + k + 1]));
      benchmark::DoNotOptimize(closest_points(links[i + k], boxes[i + k]));
    }
    for (std::size_t k = 0; k < 2; ++k) benchmark::DoNotOptimize(closest_points(boxes[i + k], boxes[i + k + 1]));
    i = (i + 1) % (Scene::count - 5);
  }
}
void arm(benchmark::State& state) { measure_arm(state, scene().links, scene().boxes); }
/// At the same places.
template <class A>
auto all_chained(const std::vector<A>& posed) {
  std::vector<Posed<std::remove_cvref_t<decltype(posed[0].shape)>, RigidChain>> all;
  const Rotation forth{1, 0.5, 0.25, 0}, back{1, -0.5, -0.25, 0};
  for (const A& p : posed) all.push_back({p.shape, {{{forth, {0, 0, 0}}, {back, {0, 0, 0}}, p.pose}}});
  return all;
}
void arm_of_chains(benchmark::State& state) {
  const auto links = all_chained(scene().links);
  const auto boxes = all_chained(scene().boxes);
  measure_arm(state, links, boxes);
}
BENCHMARK(arm);
BENCHMARK(arm_of_chains);

#ifdef PLUMB_BENCH_RIGID_RIVAL
fcl::Transform3d transform_of(const RigidPose& pose) {
  const auto& [w, x, y, z] = pose.turn;
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = fcl::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  t.translation() = fcl::Vector3d(pose.translation.x, pose.translation.y, pose.translation.z);
  return t;
}

void arm_fcl(benchmark::State& state) {
  const auto& [links, boxes] = scene();
  const fcl::Capsuled capsule(0.2, 1);
  const fcl::Boxd box(1, 0.6, 0.4);
  std::vector<fcl::Transform3d> at_link, at_box;
  for (const Link& l : links) at_link.push_back(transform_of(l.pose));
  for (const Box& b : boxes) at_box.push_back(transform_of(b.pose));
  const fcl::DistanceRequestd request(true);
  const auto ask = [&](const auto& a, const fcl::Transform3d& p, const auto& b, const fcl::Transform3d& q) {
    fcl::DistanceResultd result;
    benchmark::DoNotOptimize(fcl::distance(&a, p, &b, q, request, result));
  };
  std::size_t i = 0;
  for (auto _ : state) {
    for (std::size_t k = 0; k < 4; ++k) {
      ask(capsule, at_link[i + k], capsule, at_link[i + k + 1]);
      ask(capsule, at_link[i + k], box, at_box[i + k]);
    }
    for (std::size_t k = 0; k < 2; ++k) ask(box, at_box[i + k], box, at_box[i + k + 1]);
    i = (i + 1) % (Scene::count - 5);
  }
}
BENCHMARK(arm_fcl);
#endif

}  // namespace
}  // namespace plumb
