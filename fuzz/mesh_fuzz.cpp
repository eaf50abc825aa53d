// Do a ray's first hit of many triangles at once, and the place of a point seen along another axis, agree with the
// exact answers triangle by triangle, whatever the mesh?
#include <cstddef>
#include <cstdint>

#include "plumb/degenerate.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "query/kinds/foreign_functions.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb::degenerate;
  static const Kind &rays = kind_named("ray-mesh"), &points = kind_named("point-in-polyhedron");
  if (size == 0) return 0;
  const Bytes bytes(data + 1, size - 1);
  return data[0] % 2 == 0 ? fuzz_target(rays, plumb_test::foreign::ray_mesh, bytes)
                          : fuzz_target(points, plumb_test::foreign::point_in_polyhedron, bytes);
}
