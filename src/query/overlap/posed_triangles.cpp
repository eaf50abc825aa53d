// The signs of triangle_signs.hpp over posed corners; what has no area as the sets that they are (query/overlap/posed.hpp).
#include "query/overlap/posed_triangles.hpp"

#include <array>

#include "certify/carried_errors.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/overlap/triangle_signs.hpp"

namespace plumb::query {
namespace {

/// Corners 0 to 2 of a, 3 to 5 of b.
template <class T>
class PosedSigns {
 public:
  PosedSigns(const PosedTriangle3& a, const PosedTriangle3& b, CertainSigns& ask)
      : PosedSigns(CornersTogether<T>(a, b), ask) {}

  static constexpr bool doubles_first = false;
  static constexpr std::array<std::size_t, 3> axes() { return {0, 1, 2}; }
  static std::optional<std::size_t> running_axis() { return {}; }

  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    const Vec3<T> normal = cross(corner_[i + 1] - corner_[i], corner_[i + 2] - corner_[i]);
    return {over(normal, i, j), over(normal, i, j + 1), over(normal, i, j + 2)};
  }
  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    const Vec3<T>& from = corner_[l];
    return ask_(dot(corner_[i] - from, cross(corner_[j] - from, corner_[k] - from)));
  }
  [[nodiscard]] Sign turn_of_b(std::size_t axis) const { return area(axis, 3, 4, 5); }
  [[nodiscard]] TriangleAreas<double> areas(std::size_t axis) const {
    return areas_by([&](std::size_t i, std::size_t j, std::size_t k) { return area(axis, i, j, k); });
  }

 private:
  PosedSigns(const CornersTogether<T>& both, CertainSigns& ask)
      : corner_{both.a[0], both.a[1], both.a[2], both.b[0], both.b[1], both.b[2]}, ask_(ask) {}

  [[nodiscard]] Sign over(const Vec3<T>& normal, std::size_t i, std::size_t j) const {
    return ask_(dot(corner_[j] - corner_[i], normal));
  }
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    const Vec3<T> to = corner_[j] - corner_[i], on = corner_[k] - corner_[i];
    return axis == 0   ? ask_(to.y * on.z - to.z * on.y)
           : axis == 1 ? ask_(to.z * on.x - to.x * on.z)
                       : ask_(to.x * on.y - to.y * on.x);
  }

  std::array<Vec3<T>, 6> corner_;
  CertainSigns& ask_;
};

}  // namespace

Relation relate(const PosedTriangle3& a, const PosedTriangle3& b) {
  const auto answer = certainly<CarriedErrors<>>(
      [&]<class T>(Carrying<T>& ask) { return relate_by(a.shape, b.shape, PosedSigns<T>(a, b, ask)); });
  return answer ? *answer : relate_posed("relate", posed_view(a), posed_view(b));
}

}  // namespace plumb::query
