// Which leaves does a ray come to?  The descent of one ray, a node or a leaf at a time.
//
// Source: RTCD 6.3.1; Wald, Benthin and Boulos 2008.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_RAY_WALK) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_RAY_WALK
#undef PLUMB_RAY_WALK
#else
#define PLUMB_RAY_WALK
#endif

#include <hwy/highway.h>

#include <array>
#include <limits>

#include "space/ray/child_order.hpp"
#include "space/ray/leaf_lanes.hpp"
#include "space/ray/packet_task.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

using FloatTag = hn::Rebind<float, D>;
using Floats = hn::Vec<FloatTag>;

/// Of the child that comes next, and of those that are still to be looked at: arrays, so that eight are put at once.
template <bool boxes>
struct Later {
  static constexpr std::size_t room = CompactTree::most_waiting + 8;
  alignas(64) float key[room];
  std::uint32_t link[room], count[room];
  float planes[boxes ? 6 : 0][room];  // of their boxes

  /// Where eight more are put.
  struct Place {
    static constexpr bool has_boxes = boxes;
    float* key;
    std::uint32_t *link, *count;
    std::array<float*, boxes ? 6 : 0> planes;

    void put(std::size_t at, float new_key, const WideNode<8>& node, std::size_t child) const {
      key[at] = new_key, link[at] = node.link[child], count[at] = node.count[child];
      for (std::size_t k = 0; k < planes.size(); ++k) planes[k][at] = node.planes[k][child];
    }
    /// One further.
    void move_up(std::size_t at) const {
      key[at + 1] = key[at], link[at + 1] = link[at], count[at + 1] = count[at];
      for (std::size_t k = 0; k < planes.size(); ++k) planes[k][at + 1] = planes[k][at];
    }
  };
  [[nodiscard]] Place from(std::size_t waiting) {
    Place place{key + waiting, link + waiting, count + waiting, {}};
    for (std::size_t k = 0; k < place.planes.size(); ++k) place.planes[k] = planes[k] + waiting;
    return place;
  }
};

/// Children whose keys_of(i), of lanes that begin at child i, are not below 0, sorted.
template <class Place, class KeysOf>
HWY_INLINE std::size_t put_children(const WideNode<8>& node, const Place& place, const KeysOf& keys_of) {
#if HWY_MAX_BYTES >= 64
  return put_sorted(node, keys_of(0), place);
#elif HWY_MAX_BYTES >= 32
  const auto low = keys_of(0), high = keys_of(4);
  return put_sorted(node, hn::Combine(EightFloats(), high, low), place);
#else
  HWY_ALIGN float keys[8];
  for (std::size_t i = 0; i < 8; i += lanes) hn::StoreU(keys_of(i), FloatTag(), keys + i);
  return put_one_by_one(node, keys, place);
#endif
}

/// Rounded as lanes round a key: what is above in doubles is not below in floats.
inline float in_floats(double limit) {
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

  /// Of one of a packet's rays.
  Slabs(const PacketPlanes& p, std::size_t ray) : all_met_(false) {
    for (std::size_t k = 0; k < 3; ++k) {
      near_[k] = p.down[k] ? 3 + k : k;
      far_[k] = p.down[k] ? k : 3 + k;
      near_from_[k] = p.enter[k].from[ray];
      near_rate_[k] = p.enter[k].rate[ray];
      far_from_[k] = p.leave[k].from[ray];
      far_rate_[k] = p.leave[k].rate[ray];
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

/// The descent of one ray, a node or a leaf at a time.
template <class Mesh>
class Walk {
  using Form = FormOf<Mesh>;

 public:
  Walk(const RayTask& task, const Mesh& mesh) : Walk(task.asked, Slabs(task.planes), mesh, 0, task.limit) {}
  /// Below a node, and up to a limit.
  Walk(const AskedRay& asked, const Slabs& slabs, const Mesh& mesh, std::uint32_t node, double limit)
      : slabs_(slabs),
        asked_(&asked),
        leaves_{Form(mesh), reinterpret_cast<const double*>(mesh.vertices.data())},
        limit_(limit),
        float_limit_(in_floats(limit)),
        link_(node) {}

  [[nodiscard]] bool at_leaf() const { return count_ != 0; }

  void open_node() {
    const WideNode<8>& node = leaves_.form.opened(link_);
    waiting_ += put_children(node, later_.from(waiting_), [&](std::size_t i) { return slabs_.keys(node, i, limit_); });
  }
  void visit_leaf() {
    limit_ = leaves_.visit(*asked_, link_, count_, limit_);
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
    leaves_.fetch_next(link_, count_);
    return true;
  }

  /// Until there is nothing more; the limit then.
  double walk_to_end() {
    do {
      if (at_leaf())
        visit_leaf();
      else
        open_node();
    } while (go_on());
    return limit_;
  }

  /// Before a leaf is looked at, and when its corners have been fetched: fetches its vertices.  GCC would leave out the
  /// call of what only fetches.
  HWY_INLINE void fetch_vertices() const { leaves_.fetch(link_, count_); }

 private:
  Slabs slabs_;
  const AskedRay* asked_;
  Leaves<Form> leaves_;
  double limit_;
  float float_limit_;
  std::uint32_t link_, count_ = 0;
  std::size_t waiting_ = 0;
  Later<false> later_;
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
