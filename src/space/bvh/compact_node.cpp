#include "certify/batch/instruction_sets.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/bvh/compact_node.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "space/bvh/compact_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

void widen_compact(const CompactNode& from, WideNode<8>& to) { widen_node(from, to); }

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb {
namespace space {
namespace {

PLUMB_EXPORT(widen_compact);

}  // namespace
}  // namespace space

WideNode<8> CompactNode::widened() const {
  using namespace space;
  WideNode<8> node;
  PLUMB_DISPATCH(widen_compact)(*this, node);
  return node;
}

}  // namespace plumb
#endif
