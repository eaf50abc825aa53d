// How is a pool of faces arranged, and which meshes make a pool without copies of them?
//
// Laws: those of plumb/surface/solid/arrangement.hpp.
// Source: Zhou et al. 2016.
// Cost: that of arrange.
#pragma once

#include <span>
#include <vector>

#include "surface/solid/face_pool.hpp"

namespace plumb::surface {

Arrangement arranged(FacePool pool, Pieces pieces);

template <class Mesh>
std::vector<const Mesh*> each_of(std::span<const Mesh> meshes) {
  std::vector<const Mesh*> all;
  for (const Mesh& mesh : meshes) all.push_back(&mesh);
  return all;
}

}  // namespace plumb::surface
