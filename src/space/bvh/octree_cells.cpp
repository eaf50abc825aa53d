#include "space/bvh/octree_cells.hpp"

#include <algorithm>
#include <limits>

#include "plumb/query/overlap/overlap.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {
namespace {

struct OctreeCell {
  Aabb3 box;
  std::vector<std::uint32_t> slots;  // whose triangles meet it
};

Aabb3 box_of_slot(const Bvh& mesh, std::uint32_t slot) {
  return box_around(mesh.triangles[slot], mesh.vertices.view());
}

Aabb3 cut(const Aabb3& a, const Aabb3& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y), std::max(a.min.z, b.min.z)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y), std::min(a.max.z, b.max.z)}};
}
Aabb3 both(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

/// About a cube, with the box of all triangles in it.
OctreeCell root_cell(const Bvh& mesh, double& side) {
  OctreeCell cell{box_of_slot(mesh, 0), {}};
  for (std::uint32_t s = 0; s < mesh.triangles.size(); ++s) {
    cell.box = both(cell.box, box_of_slot(mesh, s));
    cell.slots.push_back(s);
  }
  auto& [low, high] = cell.box;
  side = std::min(std::max({high.x - low.x, high.y - low.y, high.z - low.z}), std::numeric_limits<double>::max());
  const auto end = [&](double from, double to) {
    return std::min(std::max(to, from + side), std::numeric_limits<double>::max());
  };
  high = {end(low.x, high.x), end(low.y, high.y), end(low.z, high.z)};
  return cell;
}

/// One half where doubles have no more.
struct AxisHalves {
  double low, middle, high;
  int n;
  AxisHalves(double l, double h) : low(l), middle(l / 2 + h / 2), high(h), n(l < middle && middle < h ? 2 : 1) {}
  [[nodiscard]] double begin(int i) const { return i == 0 ? low : middle; }
  [[nodiscard]] double end(int i) const { return i == n - 1 ? high : middle; }
};

std::vector<OctreeCell> parts_of(const Bvh& mesh, const OctreeCell& cell) {
  std::vector<OctreeCell> parts;
  const AxisHalves x(cell.box.min.x, cell.box.max.x), y(cell.box.min.y, cell.box.max.y),
      z(cell.box.min.z, cell.box.max.z);
  for (int i = 0; i < x.n; ++i) {
    for (int j = 0; j < y.n; ++j) {
      for (int k = 0; k < z.n; ++k) {
        OctreeCell part{{{x.begin(i), y.begin(j), z.begin(k)}, {x.end(i), y.end(j), z.end(k)}}, {}};
        for (const std::uint32_t slot : cell.slots) {
          if (!boxes_meet(part.box, box_of_slot(mesh, slot))) continue;
          if (intersects(mesh.triangle(slot), part.box)) part.slots.push_back(slot);
        }
        if (!part.slots.empty()) parts.push_back(std::move(part));
      }
    }
  }
  return parts;
}

}  // namespace

OctreeCells octree_cells(const Bvh& mesh, std::uint32_t levels) {
  OctreeCells cells;
  if (mesh.triangles.empty()) return cells;
  std::vector<OctreeCell> now{root_cell(mesh, cells.side)};
  for (std::uint32_t level = 1; level < levels; ++level) {
    std::vector<std::vector<OctreeCell>> parts(now.size());
    for_blocks(Execution::parallel, now.size(), 16, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) parts[i] = parts_of(mesh, now[i]);
    });
    std::vector<OctreeCell> next;
    std::vector<std::uint32_t>& counts = cells.children.emplace_back();
    for (auto& of_cell : parts) {
      counts.push_back(static_cast<std::uint32_t>(of_cell.size()));
      std::ranges::move(of_cell, std::back_inserter(next));
    }
    now.swap(next);
    cells.side /= 2;
  }
  for (const OctreeCell& cell : now) {
    Aabb3 least = cut(cell.box, box_of_slot(mesh, cell.slots[0]));
    for (const std::uint32_t slot : cell.slots) least = both(least, cut(cell.box, box_of_slot(mesh, slot)));
    cells.least.push_back(least);
  }
  return cells;
}

}  // namespace plumb::space
