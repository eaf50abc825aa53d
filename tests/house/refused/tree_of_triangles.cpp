// A tree is made of vertices and the numbers of corners.
// refused: plumb: build_bvh takes a TriangleMesh
#include "plumb/plumb.hpp"

auto ask(const std::vector<plumb::Triangle3>& many) {
#ifdef MENDED
  return plumb::build_bvh(plumb::TriangleMesh{{many[0].a, many[0].b, many[0].c}, {{0, 1, 2}}});
#else
  return plumb::build_bvh(many);
#endif
}
