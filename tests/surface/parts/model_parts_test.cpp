// Convex parts of real models: as many as cuts have made, and together exactly as large as the solid.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <string>

#include "certify/sanitized.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "surface/parts/part_laws.hpp"

namespace plumb {
namespace {

/// Those that are closed, of a few thousand notches: seconds each.
TEST(ModelParts, VolumesAddUpExactly) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: there is no folder " << folder << "\n";
    return;
  }
  if (battery::sanitized) return;  // a minute each
  for (const std::string file : {"spot.obj", "cheburashka.obj"}) {
    SCOPED_TRACE(file);
    const TriangleMesh mesh = read_mesh(folder / file);
    const ConvexParts found = convex_parts(mesh);
    EXPECT_GT(found.notches, 2000U);
    EXPECT_GT(found.parts.size(), found.notches);
    EXPECT_LE(found.parts.size(), 2 * found.cuts + 1);
    EXPECT_EQ(part_laws::volume_of(found), part_laws::volume_of(mesh));
  }
}

}  // namespace
}  // namespace plumb
