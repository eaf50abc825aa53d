#include "plumb/query/separation/fat.hpp"

#include <string>

namespace plumb::query {

void require_fat_radius(std::string_view function, double radius) {
  const std::string name(function);
  if (!(radius - radius == 0)) throw NonFinite(name + ": fat.radius is not a real number; give a finite double");
  if (radius < 0) throw InvalidShape(name + ": fat.radius is negative; give one that is not");
}

}  // namespace plumb::query
