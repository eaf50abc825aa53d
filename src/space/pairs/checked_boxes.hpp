// Are these boxes that the broad phase takes: finite, none of them empty, and no more than numbers name?
#pragma once

#include <span>
#include <string_view>

#include "plumb/space/pairs/float_boxes.hpp"

namespace plumb::space {

/// Throws NonFinite or InvalidShape: "overlapping_pairs: boxes[7].min.x is nan, ...".
void check_boxes(std::string_view function, std::string_view name, std::span<const Aabb2> boxes);
void check_boxes(std::string_view function, std::string_view name, std::span<const Aabb3> boxes);
void check_boxes(std::string_view function, std::string_view name, std::span<const FloatBox2> boxes);
void check_boxes(std::string_view function, std::string_view name, std::span<const FloatBox3> boxes);

/// For one that is none of these, by its name; returns where there is nothing to refuse.
void refuse_box(std::string_view function, std::string_view name, const Aabb2& box);
void refuse_box(std::string_view function, std::string_view name, const Aabb3& box);
void refuse_box(std::string_view function, std::string_view name, const FloatBox2& box);
void refuse_box(std::string_view function, std::string_view name, const FloatBox3& box);

}  // namespace plumb::space
