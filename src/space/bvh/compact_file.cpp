#include "plumb/space/bvh/compact_file.hpp"

#include <array>
#include <type_traits>

#include "space/bvh/kept_file.hpp"
#include "space/bvh/tree_check.hpp"

namespace plumb {
namespace space {
namespace {

constexpr FileKind compact_kind{"plumbcmp", 1, "compact tree", "write_compact_bvh"};

struct CompactHead {
  FileOpening opening;
  std::int32_t exponent;
  std::uint32_t corner_width, number_width, unused;
  std::uint64_t nodes, vertices, slots, length;
  FloatBox3 root;
  std::byte rest[40];
};
static_assert(sizeof(CompactHead) == 128 && std::is_trivially_copyable_v<CompactHead>);

std::uint64_t compact_length(const CompactHead& h) {
  return sizeof(CompactHead) + h.nodes * sizeof(CompactNode) + h.vertices * sizeof(Point3) +
         PackedNumbers::bytes_of(3 * h.slots, h.corner_width) + PackedNumbers::bytes_of(h.slots, h.number_width);
}

CompactHead compact_head_of(const std::string& path, std::span<const std::byte> bytes) {
  const auto head = head_in<CompactHead>(compact_kind, path, bytes);
  if (head.nodes >= most_in_file || head.vertices > most_in_file || head.slots >= most_in_file) {
    refuse_file(compact_kind, path, BvhFileProblem::broken_law, "promises more than 2^32 nodes, vertices or slots");
  }
  for (const std::uint32_t width : {head.corner_width, head.number_width}) {
    if (width >= 1 && width <= sizeof(std::uint32_t)) continue;
    refuse_file(compact_kind, path, BvhFileProblem::broken_law, "has numbers of " + std::to_string(width) + " bytes");
  }
  require_length(compact_kind, path, bytes.size(), head.length, compact_length(head));
  require_exponent(compact_kind, path, head.exponent);
  return head;
}

}  // namespace
}  // namespace space

void write_compact_bvh(const std::string& path, const CompactBvh& bvh) {
  space::CompactHead head{};
  head.opening = space::opening_of(space::compact_kind);
  head.exponent = bvh.tree.frame.exponent();
  head.corner_width = bvh.corners.width();
  head.number_width = bvh.numbers.width();
  head.nodes = bvh.tree.nodes.size();
  head.vertices = bvh.vertices.size();
  head.slots = bvh.slots();
  head.root = bvh.tree.root;
  head.length = space::compact_length(head);
  const std::array<std::span<const std::byte>, 5> parts{
      std::as_bytes(std::span(&head, 1)), std::as_bytes(bvh.tree.nodes.view()), std::as_bytes(bvh.vertices.view()),
      bvh.corners.memory(), bvh.numbers.memory()};
  space::write_file(path, parts);
}

CompactBvh map_compact_bvh(const std::string& path) {
  const space::FileBytes file = space::map_file(path);
  const space::CompactHead head = space::compact_head_of(path, file.bytes);
  space::FileArrays arrays(file, sizeof head);
  CompactBvh bvh;
  bvh.tree.nodes = arrays.next<CompactNode>(head.nodes);
  bvh.vertices = arrays.next<Point3>(head.vertices);
  const auto packed = [&](std::uint64_t n, std::uint32_t width) {
    return PackedNumbers(arrays.next<std::byte>(PackedNumbers::bytes_of(n, width)), static_cast<std::size_t>(n), width);
  };
  bvh.corners = packed(3 * head.slots, head.corner_width);
  bvh.numbers = packed(head.slots, head.number_width);
  bvh.tree.frame = BoxFrame::of_exponent(head.exponent);
  bvh.tree.root = head.root;
  if (const std::string broken = space::broken_law(bvh); !broken.empty())
    space::refuse_file(space::compact_kind, path, BvhFileProblem::broken_law, broken);
  return bvh;
}

CompactBvh read_compact_bvh(const std::string& path) {
  CompactBvh bvh = map_compact_bvh(path);
  (void)bvh.tree.nodes.writable();
  (void)bvh.vertices.writable();
  bvh.corners.own();
  bvh.numbers.own();
  return bvh;
}

}  // namespace plumb
