#include <algorithm>

#include "degenerate/fields.hpp"
#include "plumb/degenerate/moves.hpp"

namespace plumb::degenerate {

namespace {

// Two arguments of the same parts change places, if there are such.
void swap_arguments(const Kind& kind, Numbers& numbers, Entropy& entropy) {
  std::vector<std::vector<Numbers>> parts(kind.arguments.size());
  for (const Field& f : fields_of(kind, numbers)) {
    parts[f.argument].emplace_back(numbers.begin() + static_cast<std::ptrdiff_t>(f.first),
                                   numbers.begin() + static_cast<std::ptrdiff_t>(f.first + f.size()));
  }
  const std::size_t i = entropy.below(parts.size()), j = entropy.below(parts.size());
  const auto alike = [](const Argument& a, const Argument& b) {
    return a.least == b.least && std::ranges::equal(a.parts, b.parts, [](const Part& p, const Part& q) {
             return p.role == q.role && p.dimension == q.dimension && p.count == q.count;
           });
  };
  if (!alike(kind.arguments[i], kind.arguments[j])) return;
  std::swap(parts[i], parts[j]);
  numbers.clear();
  for (std::size_t a = 0; a < parts.size(); ++a) {
    if (kind.arguments[a].any_number()) {
      numbers.push_back(static_cast<double>(parts[a][0].size()) / kind.arguments[a].parts[0].dimension);
    }
    for (const Numbers& part : parts[a]) numbers.insert(numbers.end(), part.begin(), part.end());
  }
}

// Of an argument that may have any number of points or triangles, one is dropped or stands twice.  Points that
// triangles name stay, and a triangle of a surface comes with its reverse.
void change_count(const Kind& kind, Numbers& numbers, Entropy& entropy) {
  std::vector<Field> fields = fields_of(kind, numbers);
  for (std::size_t i = 1; i < fields.size(); ++i) {
    if (names_points(fields[i].role)) fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(--i));
  }
  std::erase_if(fields, [&](const Field& f) { return !kind.arguments[f.argument].any_number(); });
  if (fields.empty()) return;
  const Field f = fields[entropy.below(fields.size())];
  const auto point = numbers.begin() + static_cast<std::ptrdiff_t>(f.first + entropy.below(f.count) * f.dimension);
  const auto after = point + static_cast<std::ptrdiff_t>(f.dimension);
  if (f.role == Role::surface) {
    const Numbers both{point[0], point[1], point[2], point[1], point[0], point[2]};
    numbers[f.first - 1] += 2;
    numbers.insert(after, both.begin(), both.end());
  } else if (entropy.coin() && f.count > kind.arguments[f.argument].least) {
    numbers[f.first - 1] -= 1;
    numbers.erase(point, after);
  } else {
    numbers[f.first - 1] += 1;
    const Numbers twice(point, after);
    numbers.insert(after, twice.begin(), twice.end());
  }
}

void move_once(const Kind& kind, Numbers& numbers, Entropy& entropy) {
  const std::uint64_t which = entropy.below(7);
  if (which == 5) return swap_arguments(kind, numbers, entropy);
  if (which == 6) return change_count(kind, numbers, entropy);
  std::vector<Field> fields = lengths_of(kind, numbers);
  if (which >= 3) {  // of points, those of one dimension
    std::erase_if(fields, [](const Field& f) { return f.role == Role::extents; });
    if (fields.empty()) return;
    if (which > 3) std::erase_if(fields, [d = fields[0].dimension](const Field& f) { return f.dimension != d; });
  }
  if (which == 3) fields = {fields[entropy.below(fields.size())]};
  Numbers moved = gathered(numbers, fields);
  const auto dimension = static_cast<int>(fields[0].dimension);
  switch (which) {
    case 0:
    case 1:
      move_by_ulps(moved, 3, 4, entropy);
      break;
    case 2:
      scale_exactly(moved, entropy);
      break;
    case 3:  // within one part: the order of a figure's points, the ends of a segment
      permute_points(moved, dimension, entropy);
      break;
    default:
      repeat_points(moved, dimension, entropy);
      break;
  }
  scatter(moved, fields, numbers);
}

}  // namespace

void mutate(const Kind& kind, Numbers& numbers, Entropy& entropy) {
  const bool closed =
      std::ranges::any_of(kind.arguments, [](const Argument& a) { return a.parts[0].role == Role::surface; });
  for (std::uint64_t moves = 1 + entropy.below(3); moves > 0; --moves) {
    Numbers before;
    if (closed) before = numbers;
    move_once(kind, numbers, entropy);
    if (closed && !flaw_of(kind, numbers).empty()) numbers = std::move(before);
  }
  put_in_order(kind, numbers);
}

}  // namespace plumb::degenerate
