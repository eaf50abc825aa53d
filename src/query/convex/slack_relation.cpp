#include "query/convex/slack_relation.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "query/body/boundary.hpp"
#include "query/convex/bounding_side.hpp"

namespace plumb::query {
namespace {

using namespace axes;
using arith::Vec;
using figure::HalfspaceSlack;

double size(const Vec<Running>& v) { return std::fabs(v.x.value) + std::fabs(v.y.value) + std::fabs(v.z.value); }
/// Of a figure's numbers within what bounds them, and the sides given.
class Program {
 public:
  Program(const FlatView& figure, const ImageNumbers& numbers, std::span<const Side> sides, const Point3& origin)
      : figure_(figure), own_(rows_of(numbers)), sides_(sides), origin_(origin) {
    const Image<Running> image = this->image<Running>();
    slack_.reserve(own_.size() + sides_.size());
    for (const OwnRow& row : own_) slack_.add(row_of<Running>(row), 1);
    double longest = image.moves_only ? 1 : 0;
    for (const auto& column : image.columns) longest = std::max(longest, size(column));
    for (const Side& side : sides_) {
      const auto normal = normal_of<Running>(side);
      const auto row = row_of(side, normal, image);
      is_beyond_one_ = is_beyond_one_ || leave(row, numbers);
      slack_.add(row, size(normal) * longest);
    }
  }
  /// Where the greatest slack was guessed.
  [[nodiscard]] Point3 place() const {
    const Image<Running> image = this->image<Running>();
    const auto& x = slack_.guessed_point();
    Vec<Running> at = image.origin;
    for (std::size_t k = 0; k < 3; ++k) at = at + image.columns[k] * Running(x[k]);
    return {at.x.value, at.y.value, at.z.value};
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  std::optional<int> sign_by_doubles() { return is_beyond_one_ ? -1 : slack_.sign_by_doubles(); }
  std::optional<int> sign_by_integers() { return slack_.sign_by_integers(); }

  /// The sides that keep the slack down, by their places among those given.
  [[nodiscard]] std::vector<std::size_t> deciding_sides() const {
    std::vector<std::size_t> sides;
    for (const std::size_t row : slack_.deciding()) {
      if (row >= own_.size()) sides.push_back(row - own_.size());
    }
    return sides;
  }

 private:
  template <class T>
  [[nodiscard]] Image<T> image() const {
    return with_shape(figure_, [this](const auto& s) {
      using Shape = std::remove_cvref_t<decltype(s)>;
      if constexpr (has_body<Shape> || figure_kind<Shape> == FigureKind::plane) {
        return image_of<T>(s);
      } else {
        return moved_to<T>(origin_);
      }
    });
  }
  [[nodiscard]] HalfspaceSlack::Exact exact_row(std::size_t i) {
    if (i < own_.size()) return row_of<BigDyadic>(own_[i]);
    if (!exact_) exact_ = image<BigDyadic>();
    const Side& side = sides_[i - own_.size()];
    return row_of(side, normal_of<BigDyadic>(side), *exact_);
  }

  const FlatView& figure_;
  std::vector<OwnRow> own_;
  std::span<const Side> sides_;
  Point3 origin_;
  bool is_beyond_one_ = false;
  std::optional<Image<BigDyadic>> exact_;
  HalfspaceSlack slack_{[this](std::size_t i) { return exact_row(i); }};
};
/// The figure's numbers; nothing where it is no image of numbers that is known.
std::optional<ImageNumbers> numbers_of_view(const FlatView& v) {
  return with_shape(v, [](const auto& s) -> std::optional<ImageNumbers> {
    using Shape = std::remove_cvref_t<decltype(s)>;
    if constexpr (figure_kind<Shape> == FigureKind::plane) {
      if (s.normal == Vector3{}) return {};
    }
    return numbers_of<Shape>();
  });
}
/// Sides without a normal are all of space, or nothing.
bool drop_zero_sides(std::vector<Side>& sides) {
  for (const Side& side : sides) {
    if (has_no_normal(side) && side.offset < 0) return false;
  }
  std::erase_if(sides, has_no_normal);
  return true;
}

/// A place to take coordinates from.
Point3 origin_of_sides(const std::vector<Side>& sides) {
  for (const Side& side : sides) {
    if (side.corners[0] != nullptr) return *side.corners[0];
  }
  return {0, 0, 0};
}
/// All whose hull the figure is, where they are doubles.
std::vector<Point3> vertices_of(const FlatView& v) {
  std::vector<Point3> all;
  with_shape(v, [&]<class Shape>(const Shape& s) {
    constexpr bool are_doubles = !is_one_of(figure_kind<Shape>, {FigureKind::obb, FigureKind::rectangle});
    if constexpr (has_boundary<Shape> && are_doubles)
      for_each_corner<double>(s, [&](const Vec<double>& p) { all.push_back({p.x, p.y, p.z}); });
  });
  return all;
}
/// Along one side of the solid: beyond it, or a vertex in it that the solid has too, of those nearest to a place.
/// Nothing where neither is.
std::optional<Relation> relate_along(const Side& side, std::span<const Side> solid, std::span<const Point3> other,
                                     const Point3& place) {
  constexpr std::size_t most = 4;
  if (other.empty()) return {};
  const Beyond beyond(side);
  std::vector<std::pair<double, const Point3*>> level;
  for (const Point3& p : other) {
    const Sign sign = beyond.sign(p);
    if (sign == Sign::negative) return {};
    const double x = p.x - place.x, y = p.y - place.y, z = p.z - place.z;
    if (sign == Sign::zero) level.emplace_back(x * x + y * y + z * z, &p);
  }
  if (level.empty()) return Relation::disjoint;
  const auto end = level.begin() + static_cast<std::ptrdiff_t>(std::min(most, level.size()));
  std::ranges::partial_sort(level, end);
  for (auto p = level.begin(); p != end; ++p) {
    if (std::ranges::all_of(solid,
                            [&](const Side& s) { return &s == &side || Beyond(s).sign(*p->second) != Sign::positive; }))
      return Relation::touching;
  }
  return {};
}

std::optional<Relation> relate_along_sides(const Program& program, std::span<const Side> all, std::size_t of_solid,
                                           const FlatView& solid, const FlatView& other) {
  std::optional<std::vector<Point3>> of_other, vertices_of_solid;
  for (const std::size_t i : program.deciding_sides()) {
    const bool own = i < of_solid;
    auto& vertices = own ? of_other : vertices_of_solid;
    if (!vertices) vertices = vertices_of(own ? other : solid);
    const auto sides = own ? all.first(of_solid) : all.subspan(of_solid);
    if (const auto found = relate_along(all[i], sides, *vertices, program.place())) return found;
  }
  return {};
}

bool has_inside(const FlatView& v, std::span<const Side> sides) {
  if (sides.empty() || v.kind == FigureKind::convex_polyhedron || v.kind == FigureKind::halfspace) return true;
  Program inside(v, {0, Range::all}, sides, {0, 0, 0});
  const auto sign = inside.sign_by_doubles();
  return sign ? *sign == 1 : inside.sign_by_integers() == 1;
}

}  // namespace

std::optional<Relation> relate_by_slack(const FlatView& solid, const FlatView& other) {
  std::vector<Side> all = sides_of(solid), of_other = sides_of(other);
  if (!drop_zero_sides(all) || !drop_zero_sides(of_other)) return Relation::disjoint;
  const auto numbers = numbers_of_view(other);
  if (!numbers) return {};
  const std::size_t of_solid = all.size();
  all.insert(all.end(), of_other.begin(), of_other.end());
  const std::span<const Side> sides(all);
  Program program(other, *numbers, sides, origin_of_sides(all));
  if (const auto sign = program.sign_by_doubles()) return static_cast<Relation>(*sign);
  auto found = relate_along_sides(program, sides, of_solid, solid, other);
  if (!found) {
    if (const auto sign = program.sign_by_integers()) found = static_cast<Relation>(*sign);
  }
  if (found == Relation::touching &&
      !(has_inside(solid, sides.first(of_solid)) && has_inside(other, sides.subspan(of_solid))))
    return {};
  return found;
}

}  // namespace plumb::query
