// Are these options and boxes that a tree is made of?
#pragma once

#include <string>

#include "plumb/space/bvh/build.hpp"

namespace plumb::space {

/// Neither empty nor infinite, and no NaN.
bool is_sound(const Aabb3& box);

/// Throws NonFinite and InvalidShape, naming the function and the box.
void check_box(const std::string& function, const std::string& name, const Aabb3& box);

void check_options(const std::string& function, const BvhOptions& options);

/// The largest magnitude of a coordinate.
double magnitude(const Point3& p);

}  // namespace plumb::space
