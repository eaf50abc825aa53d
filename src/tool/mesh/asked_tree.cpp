#include "tool/mesh/asked_tree.hpp"

#include <fmt/format.h>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/tree_file.hpp"

namespace plumb::tool {
namespace {

bool is_of(const Bvh& bvh, const TriangleMesh& mesh) {
  std::vector<bool> found(mesh.triangles.size());
  std::size_t missing = found.size();
  for (std::size_t slot = 0; slot < bvh.slots(); ++slot) {
    const std::uint32_t number = bvh.number(slot);
    if (number >= mesh.triangles.size()) return false;
    const auto& [a, b, c] = mesh.triangles[number];
    if (bvh.triangle(slot) != Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}) return false;
    if (!found[number]) --missing;
    found[number] = true;
  }
  return missing == 0;
}

}  // namespace

Bvh asked_tree(const AskedMesh& asked, const std::optional<std::string>& file) {
  if (!file) return build_bvh(asked.mesh);
  if (*file == "-") throw Error("--tree: a tree is read from a file, not from standard input; give its name");
  Bvh bvh = map_bvh(*file);
  if (!is_of(bvh, asked.mesh)) {
    throw Error(
        fmt::format("--tree: {0} is the tree of another mesh than {1}; 'plumb bvh --out {0} --overwrite {1}' "
                    "builds it anew",
                    printable(*file), printable(asked.name)));
  }
  return bvh;
}

}  // namespace plumb::tool
