#include "space/ray/wide_rays.hpp"

#include <array>
#include <limits>
#include <new>

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/ray/wide_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "query/ray/triangle_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
namespace in_lanes = query::HWY_NAMESPACE;
using in_lanes::D, in_lanes::V, in_lanes::lanes;
using Node = WideNode<8>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A child that is still to be looked at.
struct Later {
  double key;
  std::uint32_t link, count;
};

// The slab test of RaySlabs for eight boxes; which plane of an axis is entered is told by the ray's direction.
class Slabs {
 public:
  explicit Slabs(const RaySlabs::Planes& p) : all_met_(p.all_met) {
    for (std::size_t k = 0; k < 3; ++k) {
      const bool down = p.low_rate[k] < 0;
      near_[k] = down ? 3 + k : k;
      far_[k] = down ? k : 3 + k;
      near_from_[k] = hn::Set(D(), (down ? p.high_from : p.low_from)[k]);
      near_rate_[k] = hn::Set(D(), (down ? p.high_rate : p.low_rate)[k]);
      far_from_[k] = hn::Set(D(), (down ? p.low_from : p.high_from)[k]);
      far_rate_[k] = hn::Set(D(), (down ? p.low_rate : p.high_rate)[k]);
    }
  }

  /// Bit i: is child i met at a key of at most the limit?
  HWY_INLINE unsigned operator()(const Node& node, double limit, double* keys) const {
    const D tag;
    if (HWY_UNLIKELY(all_met_)) {
      for (std::size_t i = 0; i < 8; ++i) keys[i] = -infinity;
      return 0xff;
    }
    const V guard = hn::Set(tag, underflow_guard), most = hn::Set(tag, limit);
    unsigned bits = 0;
    for (std::size_t i = 0; i < 8; i += lanes) {
      const auto at = [&](std::size_t plane, V from, V rate) {
        const hn::Rebind<float, D> floats;
        const V place = hn::PromoteTo(tag, hn::LoadU(floats, node.planes[plane].data() + i));
        return hn::Mul(hn::Sub(place, from), rate);  // as RaySlabs::parameter
      };
      const V enters = hn::Sub(
          hn::Max(hn::Max(at(near_[0], near_from_[0], near_rate_[0]), at(near_[1], near_from_[1], near_rate_[1])),
                  hn::Max(at(near_[2], near_from_[2], near_rate_[2]), hn::Zero(tag))),
          guard);
      const V leaves =
          hn::Add(hn::Min(hn::Min(at(far_[0], far_from_[0], far_rate_[0]), at(far_[1], far_from_[1], far_rate_[1])),
                          at(far_[2], far_from_[2], far_rate_[2])),
                  guard);
      hn::Store(enters, tag, keys + i);
      bits |= in_lanes::bits_of(hn::Le(enters, hn::Min(leaves, most))) << i;
    }
    return bits;
  }

 private:
  bool all_met_;
  std::size_t near_[3], far_[3];
  V near_from_[3], near_rate_[3], far_from_[3], far_rate_[3];
};

/// The triangles of slots, a vector of them at once.
struct Leaves {
  in_lanes::RayLanes ray;
  const std::int32_t* corners;  // three a slot
  const double* numbers;        // three a vertex

  HWY_INLINE in_lanes::Lanes3 corner(std::uint32_t first, hn::Vec<hn::Rebind<std::int32_t, D>> slot,
                                     std::int32_t k) const {
    const hn::Rebind<std::int32_t, D> words;
    const hn::RebindToSigned<D> wide;
    const auto vertex = hn::GatherIndex(words, corners + 3 * std::size_t{first}, hn::Add(slot, hn::Set(words, k)));
    const auto index = hn::PromoteTo(wide, vertex);
    const auto at = hn::Add(hn::Add(index, index), index);
    return {hn::GatherIndex(D(), numbers, at), hn::GatherIndex(D(), numbers + 1, at),
            hn::GatherIndex(D(), numbers + 2, at)};
  }

  HWY_INLINE void fetch(std::uint32_t first, std::uint32_t count) const {
    for (std::size_t i = 3 * std::size_t{first}, end = i + 3 * count; i < end; ++i)
      __builtin_prefetch(numbers + 3 * static_cast<std::size_t>(corners[i]));
  }

  HWY_INLINE double visit(std::uint32_t first, std::uint32_t count, double limit, TriangleVisitor& visitor) const {
    const hn::Rebind<std::int32_t, D> words;
    for (std::uint32_t from = first, end = first + count; from < end; from += lanes) {
      const std::uint32_t rest = end - from;
      const auto slot = hn::Min(hn::Iota(words, 0), hn::Set(words, static_cast<std::int32_t>(rest - 1)));
      const auto offset = hn::Add(hn::Add(slot, slot), slot);
      const in_lanes::TrianglesTold told =
          in_lanes::tell(ray, corner(from, offset, 0), corner(from, offset, 1), corner(from, offset, 2));
      unsigned maybe = ~told.no & (rest < lanes ? (1u << rest) - 1 : (1u << lanes) - 1);
      if (maybe == 0) continue;
      HWY_ALIGN double least[lanes], most[lanes];
      hn::Store(told.least, D(), least);
      hn::Store(told.most, D(), most);
      for (; maybe != 0; maybe &= maybe - 1) {
        const auto i = static_cast<unsigned>(__builtin_ctz(maybe));
        limit = visitor.visit(from + i, (told.yes >> i & 1) != 0, least[i], most[i]);
        if (limit == -infinity) return limit;
      }
    }
    return limit;
  }
};

/// The descent of one ray, a node or a leaf at a time.
class Walk {
 public:
  Walk(const RayTask& task, const Bvh& bvh)
      : slabs_(task.planes),
        leaves_{in_lanes::RayLanes(task.ray), reinterpret_cast<const std::int32_t*>(bvh.triangles.data()),
                reinterpret_cast<const double*>(bvh.vertices.data())},
        nodes_(bvh.wide.nodes.data()),
        limit_(task.limit),
        visitor_(task.visitor) {}

  /// Looks at what comes next, and fetches what comes after it; is there any?
  bool step() {
    if (now_.count != 0) {
      limit_ = leaves_.visit(now_.link, now_.count, limit_, *visitor_);
      if (limit_ == -infinity) return false;
    } else {
      open(nodes_[now_.link]);
    }
    do {
      if (waiting_ == 0) return false;
      now_ = later_[--waiting_];
    } while (now_.key > limit_);
    fetch();
    return true;
  }

  /// Before a leaf is looked at, and when its corners have been fetched: fetches its vertices.
  void fetch_vertices() const {
    if (now_.count != 0) leaves_.fetch(now_.link, now_.count);
  }

 private:
  HWY_INLINE void open(const Node& node) {
    HWY_ALIGN double keys[8];
    const std::size_t own = waiting_;
    for (unsigned met = slabs_(node, limit_, keys); met != 0; met &= met - 1) {
      const auto i = static_cast<unsigned>(__builtin_ctz(met));
      if (!node.has(i)) continue;
      // The nearest last.
      std::size_t place = waiting_++;
      for (; place > own && later_[place - 1].key < keys[i]; --place) later_[place] = later_[place - 1];
      later_[place] = {keys[i], node.link[i], node.count[i]};
    }
  }

  HWY_INLINE void fetch() const {
    const char* at = now_.count != 0 ? reinterpret_cast<const char*>(leaves_.corners + 3 * std::size_t{now_.link})
                                     : reinterpret_cast<const char*>(nodes_ + now_.link);
    const std::size_t size = now_.count != 0 ? 12 * std::size_t{now_.count} : sizeof(Node);
    for (std::size_t i = 0; i < size; i += 64) __builtin_prefetch(at + i);
  }

  Slabs slabs_;
  Leaves leaves_;
  const Node* nodes_;
  double limit_;
  TriangleVisitor* visitor_;
  Later now_{-infinity, 0, 0};
  std::size_t waiting_ = 0;
  std::array<Later, 8 * most_tree_depth> later_;
};

/// The same for a group: one looks while memory brings what the others asked for.
class Group {
 public:
  Group(const Bvh& bvh, std::span<const RayTask> tasks) : bvh_(bvh), tasks_(tasks) {}
  ~Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  void run() {
    std::array<Walk*, rays_together> walks;
    std::size_t left = 0;
    while (left < rays_together && begun_ < tasks_.size()) {
      walks[left] = begin(left);
      ++left;
    }
    while (left > 0) {
      for (std::size_t i = 0; i < left; ++i) walks[i]->fetch_vertices();
      for (std::size_t i = 0; i < left;) {
        if (walks[i]->step()) {
          ++i;
        } else if (begun_ < tasks_.size()) {
          walks[i] = begin(static_cast<std::size_t>(walks[i] - at(0)));
        } else {
          walks[i] = walks[--left];
        }
      }
    }
  }

 private:
  Walk* at(std::size_t place) { return reinterpret_cast<Walk*>(memory_) + place; }
  Walk* begin(std::size_t place) { return new (at(place)) Walk(tasks_[begun_++], bvh_); }

  const Bvh& bvh_;
  std::span<const RayTask> tasks_;
  std::size_t begun_ = 0;
  alignas(Walk) std::byte memory_[rays_together * sizeof(Walk)];
};

void visit_all(const Bvh& bvh, std::span<const RayTask> tasks) {
  if (tasks.size() > 1) return Group(bvh, tasks).run();
  Walk walk(tasks[0], bvh);
  while (walk.step()) {
  }
}

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

HWY_EXPORT(visit_all);

}  // namespace

void visit_triangles(const Bvh& bvh, std::span<const RayTask> tasks) {
  if (!bvh.wide.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_all)(bvh, tasks);
}

}  // namespace plumb::space
#endif
