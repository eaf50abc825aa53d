#include <algorithm>

#include "degenerate/mesh_case.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/predicates.hpp"

namespace plumb::degenerate {

namespace {

/// The dimension of what these points span: 0 where all are equal.
template <std::size_t dimension>
int spanned(std::span<const double> x) {
  const std::size_t n = x.size() / dimension;
  const auto seen = [&](std::size_t i, std::size_t right, std::size_t up) {
    return Point2{x[i * dimension + right], x[i * dimension + up]};
  };
  const auto find = [&](const auto& wanted) {
    std::size_t i = 0;
    while (i < n && !wanted(i)) ++i;
    return i;
  };
  const std::size_t b =
      find([&](std::size_t i) { return !std::ranges::equal(x.first(dimension), x.subspan(i * dimension, dimension)); });
  if (b == n) return 0;
  const auto turns = [&](std::size_t i, std::size_t right, std::size_t up) {
    return orient2d(seen(0, right, up), seen(b, right, up), seen(i, right, up)) != Sign::zero;
  };
  const std::size_t c = find([&](std::size_t i) {
    if constexpr (dimension == 2) return turns(i, 0, 1);
    return turns(i, 0, 1) || turns(i, 0, dimension - 1) || turns(i, 1, dimension - 1);
  });
  if (c == n) return 1;
  if constexpr (dimension == 3) {
    const auto point = [&](std::size_t i) { return Point3{x[3 * i], x[3 * i + 1], x[3 * i + 2]}; };
    const auto off = [&](std::size_t i) { return orient3d(point(0), point(b), point(c), point(i)) != Sign::zero; };
    if (find(off) != n) return 3;
  }
  return 2;
}

/// The same of any dimension: the rank of the differences, by elimination.
int spanned_by_elimination(std::span<const double> x, std::size_t dimension) {
  std::vector<std::vector<Rational>> rows;
  for (std::size_t i = dimension; i < x.size(); i += dimension) {
    std::vector<Rational>& row = rows.emplace_back();
    for (std::size_t k = 0; k < dimension; ++k) row.push_back(Rational(x[i + k]) - Rational(x[k]));
  }
  std::size_t rank = 0;
  for (std::size_t k = 0; k < dimension && rank < rows.size(); ++k) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [k](const auto& row) { return row[k].sign() != Sign::zero; });
    if (pivot == rows.end()) continue;
    std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(rank), pivot);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const Rational times = rows[i][k] / rows[rank][k];
      for (std::size_t j = k; j < dimension; ++j) rows[i][j] = rows[i][j] - times * rows[rank][j];
    }
    ++rank;
  }
  return static_cast<int>(rank);
}

int spanned_by_points(std::span<const double> x, std::size_t dimension) {
  return dimension == 2 ? spanned<2>(x) : dimension == 3 ? spanned<3>(x) : spanned_by_elimination(x, dimension);
}

int spanned(const MeshCase& mesh, std::span<const std::array<std::size_t, 3>> triangles) {
  std::vector<double> corners;
  for (const auto& t : triangles) {
    for (const std::size_t i : t) corners.insert(corners.end(), mesh.points[i].begin(), mesh.points[i].end());
  }
  return corners.empty() ? 0 : spanned<3>(corners);
}

}  // namespace

std::vector<Span> spans_of(const Kind& kind, std::span<const double> numbers) {
  std::vector<Span> all;
  Field before{};
  for (const Field& f : fields_of(kind, numbers)) {
    const std::span<const double> x = numbers.subspan(f.first, f.size());
    const std::size_t least = kind.arguments[f.argument].least;
    const int most = static_cast<int>(std::min(f.dimension, (least > 0 ? least : f.count) - 1));
    switch (f.role) {
      case Role::points:
        if (most > 0) all.push_back({std::min(spanned_by_points(x, f.dimension), most), most});
        break;
      case Role::vector:
        all.push_back({std::ranges::any_of(x, [](double c) { return c != 0; }) ? 1 : 0, 1});
        break;
      case Role::corners: {
        int wide = 0;
        for (std::size_t axis = 0; axis < f.dimension; ++axis) wide += x[axis] < x[f.dimension + axis] ? 1 : 0;
        all.push_back({wide, static_cast<int>(f.dimension)});
        break;
      }
      case Role::extents:
        all.push_back(
            {static_cast<int>(x.size()) - static_cast<int>(std::ranges::count(x, 0.0)), static_cast<int>(x.size())});
        break;
      case Role::frame:
        break;
      case Role::soup: {
        const MeshCase mesh = mesh_of(before, f, numbers);
        Span thinnest{2, 2};
        for (const auto& t : mesh.triangles) thinnest.dimension = std::min(thinnest.dimension, spanned(mesh, {&t, 1}));
        all.push_back(thinnest);
        break;
      }
      case Role::surface: {
        const MeshCase mesh = mesh_of(before, f, numbers);
        all.push_back({spanned(mesh, odd_triangles(mesh)), 3});
        break;
      }
    }
    before = f;
  }
  return all;
}

bool is_degenerate(const Kind& kind, std::span<const double> numbers) {
  return std::ranges::any_of(spans_of(kind, numbers), [](const Span& s) { return s.dimension < s.most; });
}

}  // namespace plumb::degenerate
