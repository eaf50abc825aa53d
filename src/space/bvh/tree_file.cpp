#include "plumb/space/bvh/tree_file.hpp"

#include <array>
#include <type_traits>

#include "space/bvh/kept_file.hpp"
#include "space/bvh/tree_check.hpp"

namespace plumb {
namespace space {
namespace {

constexpr FileKind tree_kind{"plumbbvh", 2, "tree", "write_bvh(path, build_bvh(mesh))"};

struct TreeHead {
  FileOpening opening;
  std::int32_t exponent;
  std::uint32_t unused;
  std::uint64_t nodes, vertices, slots, length;
  std::byte rest[64];
  std::uint64_t checksum;
};
static_assert(sizeof(TreeHead) == 128 && std::is_trivially_copyable_v<TreeHead>);

std::uint64_t length_of(const TreeHead& h) {
  return sizeof(TreeHead) + h.nodes * sizeof(BoxNode) + h.vertices * sizeof(Point3) +
         h.slots * (sizeof(Bvh::Corners) + sizeof(std::uint32_t));
}

TreeHead tree_head_of(const std::string& path, std::span<const std::byte> bytes) {
  const auto head = head_in<TreeHead>(tree_kind, path, bytes);
  if (head.nodes >= most_in_file || head.vertices > most_in_file || head.slots >= most_in_file) {
    refuse_file(tree_kind, path, BvhFileProblem::broken_law, "promises more than 2^32 nodes, vertices or slots");
  }
  require_length(tree_kind, path, bytes.size(), head.length, length_of(head));
  require_checksum(tree_kind, path, bytes);
  require_exponent(tree_kind, path, head.exponent);
  return head;
}

/// f(head, arrays): what a file holds, but for the checksum.
template <class F>
void with_file_parts(const Bvh& bvh, const F& f) {
  TreeHead head{};
  head.opening = opening_of(tree_kind);
  head.exponent = bvh.tree.frame.exponent();
  head.nodes = bvh.tree.nodes.size();
  head.vertices = bvh.vertices.size();
  head.slots = bvh.triangles.size();
  head.length = length_of(head);
  const std::array arrays{std::as_bytes(bvh.tree.nodes.view()), std::as_bytes(bvh.vertices.view()),
                          std::as_bytes(bvh.triangles.view()), std::as_bytes(bvh.tree.items.view())};
  f(std::as_writable_bytes(std::span<TreeHead, 1>(&head, 1)), std::span(arrays));
}

}  // namespace
}  // namespace space

void write_bvh(const std::string& path, const Bvh& bvh) {
  space::with_file_parts(bvh, [&](auto head, auto arrays) { space::write_file(path, head, arrays); });
}

std::string bvh_bytes(const Bvh& bvh) {
  std::string all;
  space::with_file_parts(bvh, [&](auto head, auto arrays) {
    space::seal(head, arrays);
    const auto add = [&](std::span<const std::byte> bytes) {
      all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    add(head);
    for (const auto& bytes : arrays) add(bytes);
  });
  return all;
}

Bvh map_bvh(const std::string& path) {
  const space::FileBytes file = space::map_file(path);
  const space::TreeHead head = space::tree_head_of(path, file.bytes);
  space::FileArrays arrays(file, sizeof head);
  Bvh bvh;
  bvh.tree.nodes = arrays.next<BoxNode>(head.nodes);
  bvh.vertices = arrays.next<Point3>(head.vertices);
  bvh.triangles = arrays.next<Bvh::Corners>(head.slots);
  bvh.tree.items = arrays.next<std::uint32_t>(head.slots);
  bvh.tree.frame = BoxFrame::of_exponent(head.exponent);
  if (const std::string broken = space::broken_law(bvh); !broken.empty())
    space::refuse_file(space::tree_kind, path, BvhFileProblem::broken_law, broken);
  widen(bvh);
  return bvh;
}

Bvh read_bvh(const std::string& path) {
  Bvh bvh = map_bvh(path);
  (void)bvh.tree.nodes.writable();
  (void)bvh.tree.items.writable();
  (void)bvh.triangles.writable();
  (void)bvh.vertices.writable();
  return bvh;
}

}  // namespace plumb
