#include "degenerate/fields.hpp"

namespace plumb::degenerate {

namespace {

template <class T>
const T* laid(std::span<const double> numbers, void* place) {
  T* to = static_cast<T*>(place);
  for (const double x : numbers) *to++ = static_cast<T>(x);
  return static_cast<const T*>(place);
}

}  // namespace

Answer ask(const Kind& kind, ForeignFunction function, std::span<const double> numbers, const Room& room) {
  std::vector<Passed> arguments;
  std::vector<std::vector<std::size_t>> indices(kind.arguments.size());  // where there is no room for them
  for (const Given& g : given(kind, numbers)) {
    const std::size_t i = arguments.size();
    Passed& passed = arguments.emplace_back();
    passed.count = g.count;
    if (names_points(g.argument.parts[0].role)) {
      void* place = room ? room(i, g.numbers.size() * sizeof(std::size_t)) : nullptr;
      if (place == nullptr) {
        indices[i].resize(g.numbers.size());
        place = indices[i].data();
      }
      passed.indices = laid<std::size_t>(g.numbers, place);
    } else {
      void* const place = room ? room(i, g.numbers.size_bytes()) : nullptr;
      passed.numbers = place == nullptr ? g.numbers.data() : laid<double>(g.numbers, place);
    }
  }
  return kind.call(function, arguments);
}

}  // namespace plumb::degenerate
