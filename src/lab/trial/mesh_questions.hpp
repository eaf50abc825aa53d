// How is a method asked of meshes?  What it makes of each mesh is made once, before the clock runs; then come rays,
// points, or the other mesh.
//
// Laws: those of contestant.hpp.  A question names its meshes (mesh_scenes.hpp): of a ray the numbers are name, axes,
// origin and direction; of a point name, axes and point; of two meshes both names, the axes, and 1 where both carry
// the common turn as a pose, else 0.
// Source: none.
// Cost: none beside the method's.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "lab/trial/mesh_scenes.hpp"
#include "lab/trial/tasks.hpp"
#include "plumb/figure/basic/linear.hpp"

namespace plumb::lab::trial {

inline constexpr std::size_t ray_numbers = 10, place_numbers = 7, mesh_pair_numbers = 6;

/// What is answered where there is no triangle.
inline constexpr double no_item = -1;

inline MeshKey key_of(std::span<const double> q) { return {q[0], q[1], q[2], q[3]}; }
inline Ray3 ray_in(std::span<const double> q) { return {{q[4], q[5], q[6]}, {q[7], q[8], q[9]}}; }
inline Point3 place_in(std::span<const double> q) { return {q[4], q[5], q[6]}; }

inline MeshKey first_key(std::span<const double> q) { return {q[0], q[2], q[3], q[4]}; }
inline MeshKey second_key(std::span<const double> q) { return {q[1], q[2], q[3], q[4]}; }
/// The turn of both, the axes changed as the question has it.
Pose pose_in(std::span<const double> q);

/// What `make(mesh)` makes, once for each mesh.
template <class Make>
class MadeOnce {
 public:
  explicit MadeOnce(Make make) : make_(std::move(make)) {}
  using Made = std::shared_ptr<const std::invoke_result_t<const Make&, const TriangleMesh&>>;
  Made operator()(const MeshKey& key) {
    Made& made = made_[key];
    if (!made) made = Made(new auto(make_(mesh_of(key))));
    return made;
  }

 private:
  Make make_;
  std::map<MeshKey, Made> made_;
};

/// A method of rays or points: `make` of a mesh, `ask` of a question's numbers, `take(made, asked)` is measured.
template <std::size_t N, class Make, class Ask, class Take>
Method of_one_mesh(std::string name, std::string about, Make make, Ask ask, Take take) {
  return {std::move(name), std::move(about), [=](std::span<const double> questions, const Scene&) {
            MadeOnce<Make> made(make);
            struct Question {
              typename MadeOnce<Make>::Made mesh;
              std::invoke_result_t<const Ask&, std::span<const double>> asked;
            };
            std::vector<Question> all;
            for (std::size_t i = 0; i < questions.size(); i += N) {
              const auto q = questions.subspan(i, N);
              all.push_back({made(key_of(q)), ask(q)});
            }
            return one_by_one(std::move(all), [take](const Question& q) { return take(*q.mesh, q.asked); });
          }};
}

/// A method of two meshes that asks `take(a, b, pose)`; one that takes no pose has the vertices' rounded images, and
/// take(a, b).
template <class Make, class Take>
Method of_two_meshes(std::string name, std::string about, Make make, Take take) {
  return {std::move(name), std::move(about), [=](std::span<const double> questions, const Scene&) {
            using Made = std::invoke_result_t<const Make&, const TriangleMesh&>;
            constexpr bool poses = std::is_invocable_v<const Take&, const Made&, const Made&, const Pose&>;
            struct Question {
              std::shared_ptr<const Made> a, b;
              Pose pose;
            };
            MadeOnce<Make> made(make);
            std::vector<Question> all;
            for (std::size_t i = 0; i < questions.size(); i += mesh_pair_numbers) {
              const auto q = questions.subspan(i, mesh_pair_numbers);
              if (poses || q[5] == 0) {
                all.push_back({made(first_key(q)), made(second_key(q)), pose_in(q)});
              } else {
                const auto posed = [&](const MeshKey& key) {
                  return std::shared_ptr<const Made>(new auto(make(rounded_image(mesh_of(key), pose_in(q)))));
                };
                all.push_back({posed(first_key(q)), posed(second_key(q)), identity_pose});
              }
            }
            return one_by_one(std::move(all), [take](const Question& q) {
              if constexpr (poses) {
                return take(*q.a, *q.b, q.pose);
              } else {
                return take(*q.a, *q.b);
              }
            });
          }};
}

/// The axes in turn: the same meshes, rays and points.
Symmetry mesh_axes_in_turn(std::size_t names, std::size_t points, bool posed = false);

}  // namespace plumb::lab::trial
