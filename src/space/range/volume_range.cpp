#include "plumb/space/range/volume_range.hpp"

#include <algorithm>

namespace plumb::space {

void make_ascending(std::vector<std::uint32_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());  // a triangle may be in several slots
}

}  // namespace plumb::space
