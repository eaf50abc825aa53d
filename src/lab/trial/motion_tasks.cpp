#include <algorithm>

#include "lab/trial/branching_methods.hpp"
#include "lab/trial/contact_judge.hpp"
#include "lab/trial/motion_interval.hpp"
#include "lab/trial/motion_tests.hpp"
#include "lab/trial/moving_cases.hpp"

namespace plumb::lab::trial {
namespace {

using lab::moving_cases::Case;
using lab::moving_cases::Kind;
using Numbers = std::array<double, motion_numbers>;

Case case_of(bool vertex_face, std::span<const double> q) {
  Case c;
  c.vertex_face = vertex_face;
  for (std::size_t i = 0; i < 4; ++i) {
    c.at_0[i] = {q[3 * i], q[3 * i + 1], q[3 * i + 2]};
    c.at_1[i] = {q[12 + 3 * i], q[13 + 3 * i], q[14 + 3 * i]};
  }
  return c;
}

InputClass motions(std::string name, std::string about, Kind kind, bool vertex_face) {
  return {std::move(name), std::move(about), [=](std::span<double> q, Entropy& entropy) {
            const Case c = lab::moving_cases::make(kind, vertex_face, entropy);
            for (std::size_t i = 0; i < 4; ++i) {
              const std::array p{c.at_0[i].x, c.at_0[i].y, c.at_0[i].z, c.at_1[i].x, c.at_1[i].y, c.at_1[i].z};
              for (std::size_t k = 0; k < 3; ++k) {
                q[3 * i + k] = p[k];
                q[12 + 3 * i + k] = p[3 + k];
              }
            }
          }};
}

std::vector<InputClass> motion_classes(bool vertex_face) {
  std::vector<InputClass> classes = shape_classes(3);
  // So many points rarely touch; of those of every exponent the judge would take a tenth of a second each.
  std::erase_if(classes, [](const InputClass& c) { return c.name == "touching" || c.name == "extreme"; });
  const auto add = [&](const char* name, const char* about, Kind kind) {
    classes.push_back(motions(name, about, kind, vertex_face));
  };
  add("meeting", "planted to touch at a quarter of the time, on coordinates of few bits", Kind::planted);
  add("double_root", "in one plane at half the time, which they do not cross", Kind::double_root);
  add("in_plane", "small integers, in one plane the whole time", Kind::planar);
  add("at_rest", "small integers, of which one point or two do not move", Kind::resting);
  add("parallel", "small integers, edges parallel the whole time, often in one plane", Kind::parallel);
  return classes;
}

template <bool VertexFace>
Task motion_task(std::string name, std::string question, const std::vector<std::size_t>& order) {
  Task task{std::move(name), std::move(question), motion_numbers, AnswerKind::decision, {}, {}, {}, {}};
  task.classes = motion_classes(VertexFace);
  task.fewer = 8;
  std::vector<std::size_t> other = order;
  for (const std::size_t i : order) other.push_back(4 + i);
  task.symmetries = {reordered(3, {4, 5, 6, 7, 0, 1, 2, 3}), reordered(3, other)};
  task.judge = [](std::span<const double> q) {
    const Case c = case_of(VertexFace, q);
    return as_answer(!lab::contact_judge::contacts(VertexFace, c.at_0, c.at_1, 0).empty());
  };
  task.methods = float_methods<motion_numbers>(CubicContact<VertexFace>{});
  task.methods.push_back(compensated_method<motion_numbers>(CubicContact<VertexFace>{}));
  task.methods.push_back(each_of<double, motion_numbers>("interval", "time halved until interval arithmetic tells",
                                                         IntervalContact<VertexFace>{}));
  task.methods.push_back(each_of<double, motion_numbers>(
      "advancement", "conservative advancement, to a distance of 1e-9 of the largest coordinate",
      [](const Numbers& q) { return ConservativeAdvancement<VertexFace>{}(q, customary_epsilon * largest_of(q)); }));
  task.methods.push_back(each_made<motion_numbers>(
      "exact", "ours, one at a time",
      [](const Numbers& q) {
        const Case c = case_of(VertexFace, q);
        if constexpr (VertexFace)
          return std::pair(c.vertex(), c.triangle());
        else
          return std::pair(c.edge(0), c.edge(1));
      },
      [](const auto& q) { return intersects(q.first, q.second); }));
  return task;
}

}  // namespace

Task vertex_face_motion_task() {
  return motion_task<true>("vertex-face-motion", "does a moving vertex meet a moving triangle?", {0, 2, 3, 1});
}

Task edge_edge_motion_task() {
  return motion_task<false>("edge-edge-motion", "do two moving edges meet?", {2, 3, 1, 0});
}

}  // namespace plumb::lab::trial
