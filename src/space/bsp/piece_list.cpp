#include "space/bsp/piece_list.hpp"

#include <cmath>

namespace plumb::space {

void PieceList::add(std::uint32_t face, std::span<const GuessedCorner> its_corners, bool is_used) {
  pieces.push_back(
      {face, static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(its_corners.size()), is_used});
  corners.insert(corners.end(), its_corners.begin(), its_corners.end());
}

void add_polygon(const BspTree& tree, std::uint32_t face, PieceList& list) {
  const std::uint32_t count = tree.mesh.first[face + 1] - tree.mesh.first[face];
  list.pieces.push_back({face, static_cast<std::uint32_t>(list.corners.size()), count, false});
  for (std::uint32_t i = 0; i < count; ++i) list.corners.push_back({{i, BspCorner::no_plane, i}, tree.vertex(face, i)});
}

GuessedPlane::GuessedPlane(const BspTree& tree, std::uint32_t plane) : at_{}, normal_{} {
  const auto [a, b, c] = tree.points_of_plane(plane);
  at_ = a;
  if (is_axis_plane(plane)) {
    const std::uint32_t axis = tree.axis_planes[number_of_plane(plane)].axis;
    normal_ = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    return;
  }
  const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  normal_ = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(normal_.x, normal_.y, normal_.z);
  if (length > 0 && std::isfinite(length)) normal_ = {normal_.x / length, normal_.y / length, normal_.z / length};
}

namespace {

/// The corner where the edge that leaves `from` meets the plane.
GuessedCorner crossing(const GuessedCorner& from, const GuessedCorner& to, std::uint32_t plane,
                       const GuessedPlane& guessed) {
  const double a = guessed(from.guess), b = guessed(to.guess), part = a / (a - b);
  const double t = part >= 0 && part <= 1 ? part : 0.5;
  const auto between = [t](double p, double q) { return p + t * (q - p); };
  return {{from.corner.edge, plane, from.corner.edge},
          {between(from.guess.x, to.guess.x), between(from.guess.y, to.guess.y), between(from.guess.z, to.guess.z)}};
}

/// Adds the part on one side to the corners.
void cut(std::span<const GuessedCorner> corners, std::span<const Sign> signs, std::uint32_t plane, Sign side,
         const GuessedPlane& guessed, std::vector<GuessedCorner>& kept) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i + 1 < corners.size() ? i + 1 : 0;
    const GuessedCorner& here = corners[i];
    const Sign now = signs[i] * side, then = signs[next] * side;
    if (now == Sign::negative) {
      if (then == Sign::positive) kept.push_back(crossing(here, corners[next], plane, guessed));
      continue;
    }
    kept.push_back(here);
    if (then != Sign::negative) continue;
    if (now == Sign::positive) kept.push_back(crossing(here, corners[next], plane, guessed));
    kept.back().corner.edge = plane;
  }
}

}  // namespace

DividedPieces divided(const BspTree& tree, const PieceList& list, std::uint32_t plane) {
  DividedPieces parts;
  const GuessedPlane guessed(tree, plane);
  std::vector<Sign> signs;
  for (const ListedPiece& p : list.pieces) {
    const auto corners = list.corners_of(p);
    signs.clear();
    bool before = false, behind = false;
    for (const GuessedCorner& c : corners) {
      const Sign s = corner_side(tree, plane, p.face, c.corner);
      before |= s == Sign::positive;
      behind |= s == Sign::negative;
      signs.push_back(s);
    }
    if (!before && !behind) {
      parts.coplanar.add(p.face, corners, true);
    } else if (!behind) {
      parts.front.add(p.face, corners, p.is_used);
    } else if (!before) {
      parts.back.add(p.face, corners, p.is_used);
    } else {
      ++parts.splits;
      for (const Sign side : {Sign::positive, Sign::negative}) {
        PieceList& part = side == Sign::positive ? parts.front : parts.back;
        const auto first = static_cast<std::uint32_t>(part.corners.size());
        cut(corners, signs, plane, side, guessed, part.corners);
        part.pieces.push_back({p.face, first, static_cast<std::uint32_t>(part.corners.size()) - first, p.is_used});
      }
    }
  }
  return parts;
}

}  // namespace plumb::space
