#include "space/pairs/checked_boxes.hpp"

#include <limits>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb::space {
namespace {

// A NaN fails every comparison.
bool is_interval(double from, double to) {
  constexpr double most = std::numeric_limits<double>::max();
  return (-most <= from) & (from <= to) & (to <= most);
}
bool is_taken(const Aabb2& b) { return is_interval(b.min.x, b.max.x) && is_interval(b.min.y, b.max.y); }
bool is_taken(const Aabb3& b) {
  return is_interval(b.min.x, b.max.x) && is_interval(b.min.y, b.max.y) && is_interval(b.min.z, b.max.z);
}
bool is_taken(const FloatBox2& b) { return is_taken(widened(b)); }
bool is_taken(const FloatBox3& b) { return is_taken(widened(b)); }

[[noreturn]] void refuse_empty(std::string_view function, std::string_view name, char axis) {
  std::string text(function);
  text.append(": ").append(name).append(" is empty, its min.").append(1, axis).append(" is above its max.");
  throw InvalidShape(text.append(1, axis).append("; leave it out"));
}

template <class Box>
void check(std::string_view function, std::string_view name, std::span<const Box> boxes) {
  if (boxes.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw InvalidShape(
        std::string(function).append(": ").append(name).append(" are more than 2^31 - 1 boxes, which no numbers name"));
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (is_taken(boxes[i])) [[likely]]
      continue;
    refuse_box(function, std::string(name).append("[").append(std::to_string(i)).append("]"), boxes[i]);
  }
}

}  // namespace

void refuse_box(std::string_view function, std::string_view name, const Aabb2& box) {
  figure::refuse(function, std::string(name), box);
  if (box.min.x > box.max.x) refuse_empty(function, name, 'x');
  if (box.min.y > box.max.y) refuse_empty(function, name, 'y');
}
void refuse_box(std::string_view function, std::string_view name, const Aabb3& box) {
  figure::refuse(function, std::string(name), box);
  if (box.min.x > box.max.x) refuse_empty(function, name, 'x');
  if (box.min.y > box.max.y) refuse_empty(function, name, 'y');
  if (box.min.z > box.max.z) refuse_empty(function, name, 'z');
}

void refuse_box(std::string_view function, std::string_view name, const FloatBox2& box) {
  refuse_box(function, name, widened(box));
}
void refuse_box(std::string_view function, std::string_view name, const FloatBox3& box) {
  refuse_box(function, name, widened(box));
}

void check_boxes(std::string_view function, std::string_view name, std::span<const Aabb2> boxes) {
  check(function, name, boxes);
}
void check_boxes(std::string_view function, std::string_view name, std::span<const Aabb3> boxes) {
  check(function, name, boxes);
}
void check_boxes(std::string_view function, std::string_view name, std::span<const FloatBox2> boxes) {
  check(function, name, boxes);
}
void check_boxes(std::string_view function, std::string_view name, std::span<const FloatBox3> boxes) {
  check(function, name, boxes);
}

}  // namespace plumb::space
