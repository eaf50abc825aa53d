#include "plumb/degenerate/shrink_case.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "degenerate/shrink_mesh.hpp"

namespace plumb::degenerate {

namespace {

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); });
}

std::vector<double> identity(std::size_t dimension) {
  std::vector<double> axes(dimension * dimension, 0.0);
  for (std::size_t i = 0; i < dimension; ++i) axes[i * dimension + i] = 1;
  return axes;
}

// Whether the axes are those of the coordinates, in some order and direction.
bool is_along_coordinates(std::span<const double> axes, std::size_t dimension) {
  for (std::size_t i = 0; i < dimension; ++i) {
    double row = 0, column = 0;
    for (std::size_t j = 0; j < dimension; ++j) {
      const double x = axes[i * dimension + j];
      if (x != 0 && x != 1 && x != -1) return false;
      row += std::fabs(x);
      column += std::fabs(axes[j * dimension + i]);
    }
    if (row != 1 || column != 1) return false;
  }
  return true;
}

// How far a frame is from the coordinates' own: smaller is simpler.
int rank_of(std::span<const double> axes, std::size_t dimension) {
  return same_bits(axes, identity(dimension)) ? 0 : is_along_coordinates(axes, dimension) ? 1 : 2;
}

class CaseShrinker {
 public:
  CaseShrinker(const Kind& kind, Numbers numbers, const FailsOnCoordinates& still_fails, std::size_t most_calls)
      : kind_(kind),
        current_(std::move(numbers)),
        spans_(spans_of(kind, current_)),
        still_fails_(still_fails),
        calls_left_(most_calls) {}

  Numbers shrunk() && {
    for (Numbers before; calls_left_ > 0 && !same_bits(before, current_);) {
      before = current_;
      drop_points();
      shrink_meshes();
      turn_frames();
      const auto where = [&](const auto& wanted) {
        std::vector<Field> fields = fields_of(kind_, current_);
        std::erase_if(fields, [&](const Field& f) { return !wanted(f.role); });
        return fields;
      };
      // Points alone first: a translation moves points, and leaves directions and lengths as they are.
      coordinates(where([](Role role) { return role == Role::points || role == Role::corners; }));
      coordinates(lengths_of(kind_, current_));
    }
    return std::move(current_);
  }

 private:
  bool fails(std::span<const double> candidate) {
    if (calls_left_ == 0 || !flaw_of(kind_, candidate).empty()) return false;
    const auto keeps = [](const Span& now, const Span& before) { return now.dimension >= before.dimension; };
    if (!std::ranges::equal(spans_of(kind_, candidate), spans_, keeps)) return false;
    --calls_left_;
    return still_fails_(candidate);
  }
  bool attempt(Numbers candidate) {
    if (!fails(candidate)) return false;
    current_ = std::move(candidate);
    return true;
  }

  [[nodiscard]] bool is_of_mesh(std::size_t argument) const {
    const auto named = [&](std::size_t a) {
      return a < kind_.arguments.size() && names_points(kind_.arguments[a].parts[0].role);
    };
    return named(argument) || named(argument + 1);
  }

  void drop_points() {
    for (std::size_t a = 0; a < kind_.arguments.size(); ++a) {
      if (!kind_.arguments[a].any_number() || is_of_mesh(a)) continue;
      const auto field = [&] {
        const std::vector<Field> fields = fields_of(kind_, current_);
        return *std::ranges::find(fields, a, &Field::argument);
      };
      for (std::size_t block = std::bit_floor(field().count); block > 0; block /= 2) {
        for (std::size_t end = field().count; end >= block; --end) {
          const Field f = field();
          if (end > f.count) continue;
          Numbers fewer = current_;
          const auto at = fewer.begin() + static_cast<std::ptrdiff_t>(f.first + (end - block) * f.dimension);
          fewer.erase(at, at + static_cast<std::ptrdiff_t>(block * f.dimension));
          fewer[f.first - 1] -= static_cast<double>(block);
          attempt(std::move(fewer));
        }
      }
    }
  }

  void shrink_meshes() {
    for (std::size_t a = 1; a < kind_.arguments.size(); ++a) {
      if (!names_points(kind_.arguments[a].parts[0].role)) continue;
      const auto fields = [&] {
        std::vector<Field> both = fields_of(kind_, current_);
        const auto at = std::ranges::find(both, a, &Field::argument);
        return std::array{*(at - 1), *at};
      };
      const auto [points, triangles] = fields();
      shrink_mesh(mesh_of(points, triangles, current_), triangles.role == Role::surface, [&](const MeshCase& mesh) {
        const auto [p, t] = fields();
        return attempt(with_mesh(current_, p, t, mesh));
      });
    }
  }

  void turn_frames() {
    for (const Field& f : fields_of(kind_, current_)) {
      if (f.role != Role::frame) continue;
      const std::span<const double> axes = std::span(current_).subspan(f.first, f.size());
      const int rank = rank_of(axes, f.dimension);
      Numbers rounded(axes.begin(), axes.end());
      for (double& x : rounded) x = std::round(x) + 0.0;
      for (const Numbers& other : {identity(f.dimension), rounded}) {
        if (rank_of(other, f.dimension) >= rank) continue;
        Numbers turned = current_;
        std::ranges::copy(other, turned.begin() + static_cast<std::ptrdiff_t>(f.first));
        if (attempt(std::move(turned))) break;
      }
    }
  }

  void coordinates(const std::vector<Field>& fields) {
    if (fields.empty()) return;
    Numbers candidate = current_;
    const auto with = [&](std::span<const double> simpler) {
      scatter(simpler, fields, candidate);
      return fails(candidate);
    };
    const Numbers made =
        shrink_coordinates(gathered(current_, fields), static_cast<int>(fields[0].dimension), with, calls_left_);
    Numbers next = current_;
    scatter(made, fields, next);
    if (is_simpler(next, current_)) current_ = std::move(next);
  }

  const Kind& kind_;
  Numbers current_;
  const std::vector<Span> spans_;
  const FailsOnCoordinates& still_fails_;
  std::size_t calls_left_;
};

}  // namespace

Numbers shrink_case(const Kind& kind, Numbers numbers, const FailsOnCoordinates& still_fails, std::size_t most_calls) {
  return CaseShrinker(kind, std::move(numbers), still_fails, most_calls).shrunk();
}

}  // namespace plumb::degenerate
