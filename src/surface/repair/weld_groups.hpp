// The parts of a weld, for who welds some of the vertices only.
#pragma once

#include <span>
#include <string_view>

#include "plumb/surface/repair/weld.hpp"

namespace plumb::surface {

inline constexpr std::uint32_t no_group = 0xffffffff;

/// Of each point the first of its group's least point; `first` is first_equal.  Beyond equal points those alone are
/// grouped that are `among`, of which all are where it is empty.
std::vector<std::uint32_t> weld_groups(std::span<const Point3> points, std::span<const std::uint32_t> first,
                                       std::span<const std::uint8_t> among, const WeldOptions& options);

/// The weld by these groups, less those that turn triangles over where that is refused.
Weld weld_into(const TriangleMesh& mesh, std::span<const std::uint32_t> first, std::vector<std::uint32_t> into,
               TurnedOver turned_over);

/// Throws NonFinite or InvalidShape.
void require_tolerance(std::string_view function, double tolerance);

}  // namespace plumb::surface
