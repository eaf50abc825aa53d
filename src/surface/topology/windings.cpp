#include "surface/topology/windings.hpp"

#include "plumb/surface/topology/adjacency.hpp"

namespace plumb::surface {

Windings find_windings(const TriangleMesh& mesh, const MeshEdges& edges) {
  Windings found;
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  const auto edges_of = edges_of_faces(mesh, edges);
  constexpr std::uint32_t not_yet = no_edge;
  found.components.of.assign(n, not_yet);
  found.against.assign(n, 0);
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < n; ++first) {
    if (found.components.of[first] != not_yet) continue;
    const std::uint32_t component = found.components.count++;
    found.orientable.push_back(1);
    found.components.of[first] = component;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t f = open.back();
      open.pop_back();
      for (const std::uint32_t e : edges_of[f]) {
        if (e == no_edge) continue;
        const auto uses = edges.uses_of(e);
        if (uses.size() != 2) continue;
        const std::uint32_t other = uses[0].face == f ? uses[1].face : uses[0].face;
        const auto against = static_cast<std::uint8_t>(found.against[f] ^ (uses[0].forward == uses[1].forward ? 1 : 0));
        if (found.components.of[other] == not_yet) {
          found.components.of[other] = component;
          found.against[other] = against;
          open.push_back(other);
        } else if (found.against[other] != against) {
          found.orientable[component] = 0;
        }
      }
    }
  }
  return found;
}

}  // namespace plumb::surface
