// What do the handles of meshes, trees and pairs hold?  A C++ value each.
//
// Source: none.
// Cost: none.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "c/guarded.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/progress.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"

struct plumb_mesh {
  plumb::TriangleMesh mesh;
};

struct plumb_bvh {
  plumb::Bvh tree;
};

struct plumb_pairs {
  std::vector<std::uint32_t> numbers;
  std::vector<std::int8_t> relations;
};

struct plumb_points {
  std::variant<plumb::KdTree2, plumb::KdTree3> tree;
};

namespace plumb::c {

/// Points, vectors or boxes where a caller in C has their numbers; nothing is copied.
template <class Item>
std::span<const Item> items(const double* numbers, std::size_t count, const char* argument) {
  need(numbers, count, argument);
  return {reinterpret_cast<const Item*>(numbers), count};
}

/// Nothing to tell where there is no callback.
inline Progress progress_of(const plumb_progress* progress) {
  if (progress == nullptr || progress->call == nullptr) return {};
  return [call = progress->call, user = progress->user](double done) { return call(done, user) != 0; };
}

}  // namespace plumb::c
