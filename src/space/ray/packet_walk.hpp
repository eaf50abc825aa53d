// Which leaves do rays come to that lie close together?  The descent of sixteen at once, as of one.
//
// A node is opened for those that meet its box, which all are asked about when its turn comes; where few of them do,
// these go on alone.
// Source: RTCD 6.6.7; Wald, Boulos and Shirley 2007.
// Cost: a node's boxes are tested once for all rays, each that may be met once for each vector of rays, and a leaf's
// triangles are fetched once.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_PACKET_WALK) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_PACKET_WALK
#undef PLUMB_PACKET_WALK
#else
#define PLUMB_PACKET_WALK
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "space/ray/packet_slabs.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

/// So few go on alone below a node: a guess of what is faster.
inline constexpr int few_rays = 1;

template <class Mesh>
class PacketWalk {
  using Form = FormOf<Mesh>;

 public:
  PacketWalk(const PacketTask& task, const Mesh& mesh)
      : mesh_(&mesh),
        task_(&task),
        slabs_(task),
        leaves_{Form(mesh), reinterpret_cast<const double*>(mesh.vertices.data())},
        limit_(slabs_.most_limit()),
        float_limit_(in_floats(limit_)),
        is_one_origin_(std::all_of(task.asked.begin(), task.asked.begin() + task.size, [&](const AskedRay& asked) {
          return std::ranges::equal(asked.ray.origin, task.asked[0].ray.origin);
        })) {}

  [[nodiscard]] bool at_leaf() const { return count_ != 0; }

  void open_node() {
    const WideNode<8>& node = leaves_.form.opened(link_);
    waiting_ += put_children(node, later_.from(waiting_), [&](std::size_t i) { return slabs_.keys(node, i, limit_); });
  }

  void visit_leaf() {
    leaves_.for_vectors(link_, count_,
                        [&](std::uint32_t from, unsigned there, const auto& p, const auto& q, const auto& r) {
                          if (!is_one_origin_) {
                            for_active([&](const AskedRay& asked, const in_lanes::RayLanes& ray, double limit) {
                              return Leaves<Form>::visited(asked, in_lanes::tell(ray, p, q, r), from, there, limit);
                            });
                            return true;
                          }
                          in_lanes::TrianglesSeen seen(in_lanes::RayLanes(task_->asked[0].ray).origin, p, q, r);
                          for_active([&](const AskedRay& asked, const in_lanes::RayLanes& ray, double limit) {
                            return Leaves<Form>::visited(asked, in_lanes::tell(ray, seen), from, there, limit);
                          });
                          return true;
                        });
    set_limit();
  }

  /// Goes to what comes next, and fetches it; is there any?
  bool go_on() {
    while (waiting_ != 0) {
      --waiting_;
      if (later_.key[waiting_] > float_limit_) continue;
      active_ = slabs_.met(later_.planes, waiting_);
      if (active_ == 0) continue;
      link_ = later_.link[waiting_];
      count_ = later_.count[waiting_];
      if (count_ == 0 && std::popcount(active_) <= few_rays) {
        walk_alone();
        continue;
      }
      leaves_.fetch_next(link_, count_);
      return true;
    }
    return false;
  }

  HWY_INLINE void fetch_vertices() const { leaves_.fetch(link_, count_); }

 private:
  template <class Work>
  HWY_INLINE void for_active(const Work& work) {
    for (unsigned rest = active_; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      const AskedRay& asked = task_->asked[i];
      const double limit = work(asked, in_lanes::RayLanes(asked.ray, asked.doubts), slabs_.limit(i));
      slabs_.set_limit(i, limit);
      if (limit == -infinity) active_ &= ~(1u << i);
    }
  }

  void walk_alone() {
    for (unsigned rest = active_; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(rest));
      Walk<Mesh> walk(task_->asked[i], Slabs(task_->planes, i), *mesh_, link_, slabs_.limit(i));
      slabs_.set_limit(i, walk.walk_to_end());
    }
    set_limit();
  }

  void set_limit() {
    limit_ = slabs_.most_limit();
    float_limit_ = in_floats(limit_);
  }

  const Mesh* mesh_;
  const PacketTask* task_;
  PacketSlabs slabs_;
  Leaves<Form> leaves_;
  double limit_;
  float float_limit_;
  bool is_one_origin_;
  unsigned active_ = (1u << packet_size) - 1;
  std::uint32_t link_ = 0, count_ = 0;
  std::size_t waiting_ = 0;
  Later<true> later_;
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
