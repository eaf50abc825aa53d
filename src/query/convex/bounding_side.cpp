#include "query/convex/bounding_side.hpp"

#include "arith/plane_value.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/predicates.hpp"

namespace plumb::query {
namespace {

/// Corners of a face that are not on one line: those that doubles see spread, or the first that are.
Side side_of_face(const PolygonMesh& mesh, std::size_t f) {
  const auto corner = [&](std::size_t i) { return &mesh.vertices[mesh.corners[i]]; };
  const std::size_t first = mesh.first[f], last = mesh.first[f + 1], n = last - first;
  Side side{{}, 0, {corner(first), corner(first + n / 3), corner(first + 2 * n / 3)}};
  const auto& [a, b, c] = side.corners;
  const arith::Vec<Running> from = arith::vec<Running>(*a);
  const arith::Vec<Running> normal = arith::cross(arith::vec<Running>(*b) - from, arith::vec<Running>(*c) - from);
  if (normal.x.sign().certain() && normal.x.value != 0) return side;
  if (normal.y.sign().certain() && normal.y.value != 0) return side;
  if (normal.z.sign().certain() && normal.z.value != 0) return side;
  std::size_t second = first + 1;
  while (*corner(second) == *corner(first)) ++second;
  std::size_t third = second + 1;
  while (collinear(*corner(first), *corner(second), *corner(third))) ++third;
  side.corners = {corner(first), corner(second), corner(third)};
  return side;
}

}  // namespace

std::vector<Side> sides_of(const FlatView& v) {
  std::vector<Side> sides;
  with_shape(v, [&](const auto& s) {
    if constexpr (requires { s.halfspaces; }) {
      for (const auto& h : s.halfspaces) sides.push_back({in_space(h.normal), h.offset});
    } else if constexpr (requires { s.directions; }) {
      for (std::size_t i = 0; i < s.min.size(); ++i) {
        const Vector3 d = in_space(s.directions.all()[i]);
        sides.push_back({d, s.max[i]});
        sides.push_back({{-d.x, -d.y, -d.z}, -s.min[i]});
      }
    } else if constexpr (requires { s.mesh; }) {
      for (std::size_t f = 0; f + 1 < s.mesh.first.size(); ++f) sides.push_back(side_of_face(s.mesh, f));
    } else if constexpr (figure_kind<std::remove_cvref_t<decltype(s)>> == FigureKind::halfspace) {
      sides.push_back({in_space(s.normal), s.offset});
    }
  });
  return sides;
}

Sign sign_beyond(const Side& side, const Point3& p) {
  if (side.corners[0] == nullptr) {
    const auto sign = sign_of_plane_value(side.normal, side.offset, p);
    return sign ? *sign : side_of_plane(side.normal, side.offset, p);
  }
  return -orient3d(*side.corners[0], *side.corners[1], *side.corners[2], p);
}
}  // namespace plumb::query
