// CGAL's filtered kernel (Exact_predicates_inexact_constructions_kernel) on the same coordinates.
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace plumb::bench {

/// Takes every decision once for each call and returns the sum of the signs; the points are made beforehand.
std::function<long()> epick(std::string_view predicate, std::span<const double> coordinates);

}  // namespace plumb::bench
