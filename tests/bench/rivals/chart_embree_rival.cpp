// Embree: rays against triangles in single precision, a scene for each question.
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/location_tests.hpp"

namespace plumb::bench {
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

RTCDevice device() {
  static RTCDevice const one = rtcNewDevice("threads=1");
  return one;
}

struct Release {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

/// Triangles given by the places of their corners among the coordinates.
Scene scene_of(std::span<const double> coordinates, std::span<const std::array<std::size_t, 3>> faces,
               RTCSceneFlags flags) {
  RTCGeometry mesh = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                     3 * sizeof(float), coordinates.size() / 3));
  for (std::size_t i = 0; i < coordinates.size(); ++i) vertices[i] = static_cast<float>(coordinates[i]);
  auto* const corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), faces.size()));
  for (std::size_t i = 0; i < 3 * faces.size(); ++i) corners[i] = static_cast<unsigned>(faces[i / 3][i % 3]);
  rtcCommitGeometry(mesh);
  RTCScene scene = rtcNewScene(device());
  rtcSetSceneFlags(scene, flags);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
  return Scene(scene);
}

struct Cast {
  Scene scene;
  RTCRay ray;
};

RTCRay ray_of(const double* origin, std::array<double, 3> direction, float end) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(origin[0]);
  ray.org_y = static_cast<float>(origin[1]);
  ray.org_z = static_cast<float>(origin[2]);
  ray.dir_x = static_cast<float>(direction[0]);
  ray.dir_y = static_cast<float>(direction[1]);
  ray.dir_z = static_cast<float>(direction[2]);
  ray.tfar = end;
  ray.mask = ~0U;
  return ray;
}

/// Embree takes no number beyond this one (FLT_LARGE in its kernels/common/default.h); Debian's asserts it.
bool taken(const RTCRay& r) {
  constexpr float largest = 1.844e18F;
  return std::ranges::all_of(std::array{r.org_x, r.org_y, r.org_z, r.dir_x, r.dir_y, r.dir_z},
                             [](float x) { return std::fabs(x) <= largest; });
}

double occluded(const Cast& q) {
  if (!taken(q.ray)) return lab::trial::unsure;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = q.ray;
  rtcOccluded1(q.scene.get(), &context, &ray);
  return lab::trial::as_answer(ray.tfar < 0);  // so Embree says yes
}

struct Crossings {
  RTCIntersectContext context;
  unsigned count;
};

/// Counts a hit and goes on: every face that the ray meets is seen once.
void count_hit(const RTCFilterFunctionNArguments* args) {
  ++reinterpret_cast<Crossings*>(args->context)->count;  // the context is the first member, as Embree's manual has it
  args->valid[0] = 0;
}

double odd(const Cast& q) {
  if (!taken(q.ray)) return lab::trial::unsure;
  Crossings crossings{};
  rtcInitIntersectContext(&crossings.context);
  crossings.context.filter = count_hit;
  RTCRay ray = q.ray;
  rtcOccluded1(q.scene.get(), &crossings.context, &ray);
  return lab::trial::as_answer(crossings.count % 2 == 1);
}

void add(Rivals& all, const std::string& name, const std::string& how, RTCSceneFlags flags) {
  constexpr std::array<std::array<std::size_t, 3>, 1> face{{{0, 1, 2}}};
  join<15>(
      all, "ray-triangle", name, "Embree's rtcOccluded1, " + how,
      [=](const std::array<double, 15>& q) {
        return Cast{scene_of(std::span(q).subspan(6), face, flags), ray_of(&q[0], {q[3], q[4], q[5]}, endless)};
      },
      occluded);
  join<15>(
      all, "segment-triangle", name, "Embree's rtcOccluded1 up to 1, " + how,
      [=](const std::array<double, 15>& q) {
        return Cast{scene_of(std::span(q).subspan(6), face, flags),
                    ray_of(&q[0], {q[3] - q[0], q[4] - q[1], q[5] - q[2]}, 1)};
      },
      occluded);
  join<21>(
      all, "point-in-polyhedron", name, "the faces met by Embree's ray along the first axis, " + how,
      [=](const std::array<double, 21>& q) {
        const auto with_filter = static_cast<RTCSceneFlags>(flags | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
        return Cast{scene_of(std::span(q).subspan(3), lab::trial::octahedron_faces, with_filter),
                    ray_of(&q[0], {1, 0, 0}, endless)};
      },
      odd);
}

}  // namespace

void add_embree(Rivals& all) {
  add(all, "embree", "its default", RTC_SCENE_FLAG_NONE);
  add(all, "embree-robust", "a scene with RTC_SCENE_FLAG_ROBUST", RTC_SCENE_FLAG_ROBUST);
}

}  // namespace plumb::bench
