#include "plumb/figure/basic/sound.hpp"

#include "plumb/arith/error.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb::figure {
namespace {

[[noreturn]] void refuse_shape(std::string_view function, const std::string& name, const std::string& what) {
  throw InvalidShape(std::string(function).append(": ").append(name).append(what));
}

}  // namespace

void refuse_chain(std::string_view function, const std::string& name, std::size_t size) {
  refuse_shape(function, name,
               std::string(" has ")
                   .append(std::to_string(size))
                   .append(size == 1 ? " vertex" : " vertices")
                   .append("; a polygon has three at least"));
}

void refuse_ends(std::string_view function, const std::string& name, std::size_t directions, std::size_t min,
                 std::size_t max) {
  refuse_shape(function, name,
               std::string(" has ")
                   .append(std::to_string(min))
                   .append(" entries in min and ")
                   .append(std::to_string(max))
                   .append(" in max for ")
                   .append(std::to_string(directions))
                   .append(" directions; give one for each"));
}

void refuse_length(std::string_view function, const std::string& name) {
  refuse_shape(function, name, " is negative; give zero or more");
}

void refuse_surface(std::string_view function, const std::string& name) {
  refuse_shape(function, name, " has no faces; make it by convex_polyhedron");
}

void refuse_turn(std::string_view function, const std::string& name) {
  refuse_shape(function, name, " is zero, which is no turn; give a quaternion with a number that is not zero");
}

std::string name_of_part(const std::string& whole, std::string_view part) {
  return part.empty() ? whole : std::string(whole).append(".").append(part);
}

std::string name_of_item(const std::string& list, std::size_t i) {
  return std::string(list).append("[").append(std::to_string(i)).append("]");
}

void refuse_number(std::string_view function, const std::string& name, std::span<const double> numbers,
                   std::string_view letters) {
  for (const double x : numbers) {
    if (x - x == 0) continue;
    const std::array<std::string_view, 1> names{name};
    throw_non_finite(function, std::array{static_cast<int>(numbers.size())}, numbers, letters, names);
  }
}

}  // namespace plumb::figure
