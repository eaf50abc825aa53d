#include "space/ray/wide_rays.hpp"

#include <array>
#include <limits>
#include <new>
#include <type_traits>

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/ray/wide_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/ray/triangle_lanes.hpp"
#include "space/bvh/compact_lanes.hpp"
#include "space/ray/child_order.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace in_lanes = query::HWY_NAMESPACE;
using in_lanes::D, in_lanes::V, in_lanes::lanes;
using FloatTag = hn::Rebind<float, D>;
using Floats = hn::Vec<FloatTag>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of the child that comes next, and of those that are still to be looked at: arrays, so that eight are put at once.
struct Later {
  static constexpr std::size_t room = CompactTree::most_waiting + 8;
  alignas(64) float key[room];
  std::uint32_t link[room], count[room];
};

/// Rounded as lanes round a key: what is above in doubles is not below in floats.
float in_floats(double limit) {
  constexpr float most = std::numeric_limits<float>::max();
  return limit > static_cast<double>(most) ? std::numeric_limits<float>::infinity() : static_cast<float>(limit);
}

// The slab test of RaySlabs for eight boxes; which plane of an axis is entered is told by the ray's direction.
class Slabs {
 public:
  explicit Slabs(const RaySlabs::Planes& p) : all_met_(p.all_met) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool down = p.low_rate[k] < 0;
      near_[k] = down ? 3 + k : k;
      far_[k] = down ? k : 3 + k;
      near_from_[k] = (down ? p.high_from : p.low_from)[k];
      near_rate_[k] = (down ? p.high_rate : p.low_rate)[k];
      far_from_[k] = (down ? p.low_from : p.high_from)[k];
      far_rate_[k] = (down ? p.low_rate : p.high_rate)[k];
    }
  }

  /// Of lanes that begin at child i: the keys of those that are met at one of at most the limit, else less than 0.
  HWY_INLINE Floats keys(const WideNode<8>& node, std::size_t i, double limit) const {
    const D tag;
    const V zero = hn::Zero(tag);
    if (HWY_UNLIKELY(all_met_)) return hn::DemoteTo(FloatTag(), zero);
    const V guard = hn::Set(tag, underflow_guard), most = hn::Set(tag, limit);
    const auto at = [&](std::size_t plane, double from, double rate) {
      const V place = hn::PromoteTo(tag, hn::LoadU(FloatTag(), node.planes[plane].data() + i));
      return hn::Mul(hn::Sub(place, hn::Set(tag, from)), hn::Set(tag, rate));  // as RaySlabs::parameter
    };
    const V enters =
        hn::Max(hn::Max(at(near_[0], near_from_[0], near_rate_[0]), at(near_[1], near_from_[1], near_rate_[1])),
                hn::Max(at(near_[2], near_from_[2], near_rate_[2]), zero));
    const V leaves =
        hn::Add(hn::Min(hn::Min(at(far_[0], far_from_[0], far_rate_[0]), at(far_[1], far_from_[1], far_rate_[1])),
                        at(far_[2], far_from_[2], far_rate_[2])),
                guard);
    const V key = hn::Sub(enters, guard);
    const auto met = hn::Le(key, hn::Min(leaves, most));
    return hn::DemoteTo(FloatTag(), hn::IfThenElse(met, hn::Max(key, zero), hn::Set(tag, -infinity)));
  }

 private:
  bool all_met_;
  std::size_t near_[3], far_[3];
  double near_from_[3], near_rate_[3], far_from_[3], far_rate_[3];
};

// How a tree is kept: its nodes, which compact ones become as they are opened, and the corners of slots, three each.
class WideForm {
 public:
  using Node = WideNode<8>;
  explicit WideForm(const Bvh& bvh) : nodes_(bvh.wide.nodes.data()), corners_(bvh.triangles.data()) {}

  [[nodiscard]] const Node& opened(std::uint32_t node) const { return nodes_[node]; }
  [[nodiscard]] std::size_t vertex(std::size_t slot, std::size_t k) const { return corners_[slot][k]; }
  [[nodiscard]] const void* node_at(std::uint32_t node) const { return nodes_ + node; }
  [[nodiscard]] const void* leaf_at(std::uint32_t slot) const { return corners_ + slot; }

 private:
  const Node* nodes_;
  const Bvh::Corners* corners_;
};
class CompactForm {
 public:
  using Node = CompactNode;
  explicit CompactForm(const CompactBvh& bvh) : nodes_(bvh.tree.nodes.data()), corners_(bvh.corners.view()) {}

  [[nodiscard]] HWY_INLINE WideNode<8> opened(std::uint32_t node) const {
    WideNode<8> wide;
    widen_node(nodes_[node], wide);
    return wide;
  }
  [[nodiscard]] std::size_t vertex(std::size_t slot, std::size_t k) const { return corners_[3 * slot + k]; }
  [[nodiscard]] const void* node_at(std::uint32_t node) const { return nodes_ + node; }
  [[nodiscard]] const void* leaf_at(std::uint32_t slot) const {
    return corners_.bytes + 3 * std::size_t{slot} * corners_.width;
  }

 private:
  const Node* nodes_;
  PackedView corners_;
};
template <class Mesh>
using FormOf = std::conditional_t<std::is_same_v<Mesh, Bvh>, WideForm, CompactForm>;

/// The triangles of slots, a vector of them at once.
template <class Form>
struct Leaves {
  Form form;
  const double* numbers;  // three a vertex

  /// The numbers of vertices, lane by lane.
  HWY_INLINE static in_lanes::Lanes3 turned(const double* const* at) {
#if HWY_TARGET == HWY_SCALAR
    return {hn::Set(D(), at[0][0]), hn::Set(D(), at[0][1]), hn::Set(D(), at[0][2])};
#else
    const V even = pairs(D(), at, 0), odd = pairs(D(), at + 1, 0);
    return {hn::InterleaveLower(D(), even, odd), hn::InterleaveUpper(D(), even, odd),
            hn::InterleaveUpper(D(), pairs(D(), at, 1), pairs(D(), at + 1, 1))};
#endif
  }

  HWY_INLINE void fetch(std::uint32_t first, std::uint32_t count) const {
    for (std::size_t slot = first, end = slot + count; slot < end; ++slot) {
      for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(numbers + 3 * form.vertex(slot, k));
    }
  }

  HWY_INLINE double visit(const RayTask& task, std::uint32_t first, std::uint32_t count, double limit) const {
    const in_lanes::RayLanes ray(task.ray, task.doubts);
    for (std::uint32_t from = first, end = first + count; from < end; from += lanes) {
      const std::uint32_t rest = end - from;
      const double* at[3][lanes];
      for (std::uint32_t i = 0; i < lanes; ++i) {
        const std::uint32_t slot = from + (i < rest ? i : rest - 1);
        for (std::size_t k = 0; k < 3; ++k) at[k][i] = numbers + 3 * form.vertex(slot, k);
      }
      const in_lanes::TrianglesTold told = in_lanes::tell(ray, turned(at[0]), turned(at[1]), turned(at[2]));
      unsigned maybe = ~told.no & (rest < lanes ? (1u << rest) - 1 : (1u << lanes) - 1);
      if (maybe == 0) continue;
      HWY_ALIGN double least[lanes], most[lanes];
      hn::Store(told.least, D(), least);
      hn::Store(told.most, D(), most);
      for (; maybe != 0; maybe &= maybe - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(maybe));
        limit = task.visitor->visit(from + i, (told.yes >> i & 1) != 0, least[i], most[i]);
        if (limit == -infinity) return limit;
      }
    }
    return limit;
  }

 private:
#if HWY_TARGET != HWY_SCALAR
  /// Two numbers from each second vertex on, from the number k on.
  template <class Tag>
  HWY_INLINE static hn::Vec<Tag> pairs(Tag tag, const double* const* at, std::size_t k) {
    if constexpr (hn::MaxLanes(Tag()) == 2) {
      return hn::LoadU(tag, at[0] + k);
    } else {
      const hn::Half<Tag> half;
      return hn::Combine(tag, pairs(half, at + hn::MaxLanes(half), k), pairs(half, at, k));
    }
  }
#endif
};

/// The descent of one ray, a node or a leaf at a time.
template <class Mesh>
class Walk {
  using Form = FormOf<Mesh>;

 public:
  Walk(const RayTask& task, const Mesh& mesh)
      : slabs_(task.planes),
        task_(&task),
        leaves_{Form(mesh), reinterpret_cast<const double*>(mesh.vertices.data())},
        limit_(task.limit),
        float_limit_(in_floats(task.limit)) {}

  [[nodiscard]] bool at_leaf() const { return count_ != 0; }

  void open_node() {
    const WideNode<8>& node = leaves_.form.opened(link_);
    waiting_ += put_children(node, later_.key + waiting_, later_.link + waiting_, later_.count + waiting_);
  }
  void visit_leaf() {
    limit_ = leaves_.visit(*task_, link_, count_, limit_);
    float_limit_ = in_floats(limit_);
  }

  /// Goes to what comes next, and fetches it; is there any?
  bool go_on() {
    do {
      if (waiting_ == 0) return false;
      --waiting_;
    } while (later_.key[waiting_] > float_limit_);
    link_ = later_.link[waiting_];
    count_ = later_.count[waiting_];
    const void *const node = leaves_.form.node_at(link_), *const leaf = leaves_.form.leaf_at(link_);
    const auto* const at = static_cast<const char*>(count_ == 0 ? node : leaf);
    for (std::size_t i = 0; i < sizeof(typename Form::Node); i += 64) __builtin_prefetch(at + i);
    return true;
  }

  /// Before a leaf is looked at, and when its corners have been fetched: fetches its vertices.
  void fetch_vertices() const { leaves_.fetch(link_, count_); }

 private:
  HWY_INLINE std::size_t put_children(const WideNode<8>& node, float* key, std::uint32_t* link,
                                      std::uint32_t* count) const {
#if HWY_MAX_BYTES >= 64
    return put_sorted(node, slabs_.keys(node, 0, limit_), key, link, count);
#elif HWY_MAX_BYTES >= 32
    const auto low = slabs_.keys(node, 0, limit_), high = slabs_.keys(node, 4, limit_);
    return put_sorted(node, hn::Combine(EightFloats(), high, low), key, link, count);
#else
    HWY_ALIGN float keys[8];
    for (std::size_t i = 0; i < 8; i += lanes) hn::StoreU(slabs_.keys(node, i, limit_), FloatTag(), keys + i);
    return put_one_by_one(node, keys, key, link, count);
#endif
  }

  Slabs slabs_;
  const RayTask* task_;
  Leaves<Form> leaves_;
  double limit_;
  float float_limit_;
  std::uint32_t link_ = 0, count_ = 0;
  std::size_t waiting_ = 0;
  Later later_;
};

/// The same for a group: one looks while memory brings what the others asked for, and while the processor is not done
/// with what it looked at before: nodes come after nodes and leaves after leaves, so that it guesses well.
template <class Mesh>
class Group {
  using RayWalk = Walk<Mesh>;

 public:
  Group(const Mesh& mesh, std::span<const RayTask> tasks) : mesh_(mesh), tasks_(tasks) {}
  ~Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void run() {
    for (std::size_t i = 0; i < rays_together; ++i) begin(i);
    while (at_nodes_.size + at_leaves_.size > 0) {
      for (std::size_t i = 0; i < at_leaves_.size; ++i) at(at_leaves_.places[i])->fetch_vertices();
      const Places nodes = at_nodes_, leaves = at_leaves_;
      at_nodes_.size = at_leaves_.size = 0;
      for (std::size_t i = 0; i < nodes.size; ++i) {
        at(nodes.places[i])->open_node();
        go_on(nodes.places[i]);
      }
      for (std::size_t i = 0; i < leaves.size; ++i) {
        at(leaves.places[i])->visit_leaf();
        go_on(leaves.places[i]);
      }
    }
  }

 private:
  struct Places {
    std::size_t size = 0;
    std::array<std::size_t, rays_together + 1> places;
  };

  RayWalk* at(std::size_t place) { return reinterpret_cast<RayWalk*>(memory_) + place; }

  void begin(std::size_t place) {
    if (begun_ == tasks_.size()) return;
    new (at(place)) RayWalk(tasks_[begun_++], mesh_);
    at_nodes_.places[at_nodes_.size++] = place;
  }
  HWY_INLINE void go_on(std::size_t place) {
    if (!at(place)->go_on()) return begin(place);
    // Into both: no branch is to be guessed.
    const bool leaf = at(place)->at_leaf();
    at_nodes_.places[at_nodes_.size] = at_leaves_.places[at_leaves_.size] = place;
    at_nodes_.size += leaf ? 0 : 1;
    at_leaves_.size += leaf ? 1 : 0;
  }

  const Mesh& mesh_;
  std::span<const RayTask> tasks_;
  std::size_t begun_ = 0;
  Places at_nodes_, at_leaves_;
  alignas(RayWalk) std::byte memory_[rays_together * sizeof(RayWalk)];
};

template <class Mesh>
void visit_each(const Mesh& mesh, std::span<const RayTask> tasks) {
  if (tasks.size() > 1) return Group<Mesh>(mesh, tasks).run();
  Walk<Mesh> walk(tasks[0], mesh);
  do {
    if (walk.at_leaf())
      walk.visit_leaf();
    else
      walk.open_node();
  } while (walk.go_on());
}
void visit_wide(const Bvh& bvh, std::span<const RayTask> tasks) { visit_each(bvh, tasks); }
void visit_compact(const CompactBvh& bvh, std::span<const RayTask> tasks) { visit_each(bvh, tasks); }

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

HWY_EXPORT(visit_wide);
HWY_EXPORT(visit_compact);

}  // namespace

void visit_triangles(const Bvh& bvh, std::span<const RayTask> tasks) {
  if (!bvh.wide.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_wide)(bvh, tasks);
}
void visit_triangles(const CompactBvh& bvh, std::span<const RayTask> tasks) {
  if (!bvh.tree.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_compact)(bvh, tasks);
}

}  // namespace plumb::space
#endif
