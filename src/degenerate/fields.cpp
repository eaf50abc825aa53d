#include "degenerate/fields.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "certify/case_line.hpp"
#include "degenerate/mesh_case.hpp"

namespace plumb::degenerate {

std::size_t numbers_in(const Argument& argument) {
  std::size_t all = 0;
  for (const Part& part : argument.parts) all += static_cast<std::size_t>(part.dimension) * part.count;
  return all;
}

namespace {

// Calls visit(field) for each, and returns what is wrong with the counts.
template <class Visit>
std::string walk(const Kind& kind, std::span<const double> numbers, const Visit& visit) {
  const auto named = [&](const Argument& a, std::string what) {
    return std::string(kind.name).append(": ").append(a.name).append(" ").append(what);
  };
  std::size_t at = 0;
  for (std::size_t i = 0; i < kind.arguments.size(); ++i) {
    const Argument& argument = kind.arguments[i];
    const std::size_t each = numbers_in(argument);
    const std::string items = names_points(argument.parts[0].role) ? "triangles" : "points";
    std::size_t times = 1;
    if (argument.any_number()) {
      if (at == numbers.size()) return named(argument, "lacks its count of " + items);
      const double count = numbers[at++];
      if (!(count >= 0 && count == std::trunc(count))) {
        return named(argument, "begins with " + hexadecimal(count) + ", which is no count of " + items);
      }
      if (count < static_cast<double>(argument.least)) {
        return named(argument, "takes at least " + std::to_string(argument.least) + " " + items);
      }
      // Not cast before: any double may stand here.
      if (count > static_cast<double>((numbers.size() - at) / each)) return named(argument, "lacks numbers");
      times = static_cast<std::size_t>(count);
    }
    if (numbers.size() - at < each * times) return named(argument, "lacks numbers");
    for (const Part& part : argument.parts) {
      const auto dimension = static_cast<std::size_t>(part.dimension);
      visit(Field{part.role, i, dimension, at, part.count * times});
      at += dimension * part.count * times;
    }
  }
  if (at == numbers.size()) return {};
  return std::string(kind.name).append(": numbers too many: ").append(std::to_string(numbers.size() - at));
}

}  // namespace

std::vector<Field> fields_of(const Kind& kind, std::span<const double> numbers) {
  std::vector<Field> fields;
  walk(kind, numbers, [&](const Field& field) { fields.push_back(field); });
  return fields;
}

std::vector<Field> lengths_of(const Kind& kind, std::span<const double> numbers) {
  std::vector<Field> fields = fields_of(kind, numbers);
  std::erase_if(fields, [](const Field& f) { return f.role == Role::frame || names_points(f.role); });
  return fields;
}

std::vector<Given> given(const Kind& kind, std::span<const double> numbers) {
  std::vector<Given> all;
  for (const Field& f : fields_of(kind, numbers)) {
    const Argument& argument = kind.arguments[f.argument];
    if (!all.empty() && &all.back().argument == &argument) {
      const auto first = static_cast<std::size_t>(all.back().numbers.data() - numbers.data());
      all.back().numbers = numbers.subspan(first, all.back().numbers.size() + f.size());
    } else {
      all.push_back({argument, numbers.subspan(f.first, f.size()), f.count});
    }
  }
  return all;
}

std::string flaw_of(const Kind& kind, std::span<const double> numbers) {
  for (const double x : numbers) {
    if (!std::isfinite(x)) return std::string(kind.name).append(": a number is not finite");
  }
  std::string flaw;
  Field before{};
  std::string counts = walk(kind, numbers, [&](const Field& f) {
    const std::span<const double> part = numbers.subspan(f.first, f.size());
    const auto say = [&](std::string_view what) {
      flaw = std::string(kind.name).append(": ").append(kind.arguments[f.argument].name).append(" ").append(what);
    };
    if (f.role == Role::corners) {
      for (std::size_t axis = 0; axis < f.dimension; ++axis) {
        if (part[axis] > part[f.dimension + axis]) say("has its corners out of order");
      }
    } else if (f.role == Role::extents) {
      if (std::ranges::any_of(part, [](double x) { return x < 0; })) say("has a negative length");
    } else if (names_points(f.role)) {
      const auto known = [&](double x) {
        return x >= 0 && x < static_cast<double>(before.count) && x == std::trunc(x);
      };
      if (!std::ranges::all_of(part, known)) {
        say("name a point that is not there");
      } else if (f.role == Role::surface && !is_closed(mesh_of(before, f, numbers))) {
        say("do not close");
      }
    }
    before = f;
  });
  return counts.empty() ? flaw : counts;
}

void put_in_order(const Kind& kind, std::span<double> numbers) {
  std::size_t points = 0;  // of the field before
  for (const Field& f : fields_of(kind, numbers)) {
    const std::span<double> part = numbers.subspan(f.first, f.size());
    if (f.role == Role::corners) {
      for (std::size_t axis = 0; axis < f.dimension; ++axis) {
        if (part[axis] > part[f.dimension + axis]) std::swap(part[axis], part[f.dimension + axis]);
      }
    } else if (f.role == Role::extents) {
      for (double& x : part) x = std::fabs(x);
    } else if (names_points(f.role)) {
      for (double& x : part) x = std::fmod(std::trunc(std::fabs(x)), static_cast<double>(points));
    }
    points = f.count;
  }
}

std::uint64_t fingerprint(std::span<const double> numbers) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, by words
  for (const double x : numbers) hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
  return hash;
}

Numbers gathered(std::span<const double> numbers, std::span<const Field> fields) {
  Numbers all;
  for (const Field& f : fields) {
    const std::span<const double> part = numbers.subspan(f.first, f.size());
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

void scatter(std::span<const double> coordinates, std::span<const Field> fields, std::span<double> numbers) {
  std::size_t at = 0;
  for (const Field& f : fields) {
    std::ranges::copy(coordinates.subspan(at, f.size()), numbers.begin() + static_cast<std::ptrdiff_t>(f.first));
    at += f.size();
  }
}

}  // namespace plumb::degenerate
