// The parts of a hull's proof: what is known of its faces and edges, and which of them are seen from above or below.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figure/basic/plane_of_points.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::figure::hull3 {

using Index = std::uint32_t;

/// Thrown within the proof alone.
struct Flaw {
  std::string text;
};

template <class... Parts>
std::string text_of(const Parts&... parts) {
  std::string text;
  const auto add = [&text](const auto& part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
      text.append(std::to_string(part));
    } else {
      text.append(part);
    }
  };
  (add(parts), ...);
  return text;
}

template <class... Parts>
void require(bool holds, const Parts&... parts) {
  if (!holds) throw Flaw{text_of(parts...)};
}

/// A hull whose lists are in order, whose faces are planar, convex polygons and whose edges are matched.
struct Checked {
  Checked(const Hull3& of, std::span<const Point3> input, const HullOptions& how);

  const Hull3& hull;
  std::span<const Point3> points;
  const HullOptions& options;
  std::vector<Index> face_of;                 // of each corner; corner i also names the edge that leaves it
  std::vector<Index> twin;                    // the corner whose edge runs back; none on the rim of a flat hull
  std::vector<std::array<Index, 3>> spanned;  // by face: three points of its plane, counterclockwise
  std::vector<Index> bend, first_bend{0};     // the corners at which a face turns, as corners and first are
  std::vector<unsigned char> flat;            // by corner: both faces at the edge are coplanar

  [[nodiscard]] const Point3& at(Index corner) const { return points[hull.corners[corner]]; }
  [[nodiscard]] Index next(Index corner) const {
    return corner + 1 == hull.first[face_of[corner] + 1] ? hull.first[face_of[corner]] : corner + 1;
  }
  /// 1 below the plane of the face, -1 above it.
  [[nodiscard]] Sign side(Index face, const Point3& p) const {
    const auto& s = spanned[face];
    return sign_of(predicates::Orient3d{}, points[s[0]], points[s[1]], points[s[2]], p);
  }

 private:
  void check_lists() const;
  void check_face(Index face);
  void match_edges();
};

/// Do the points go around a convex region once, counterclockwise?  `straight`: some may lie on its edges.
bool goes_around_once(std::span<const Point2> loop, bool straight);

/// The faces that a look along an axis sees on one side, as a subdivision of a convex region.
class Sheet {
 public:
  /// orientation: the sign of the faces' turns in this look.
  Sheet(const Checked& checked, Look look, Sign orientation);

  /// The corners on the region's rim, in the order of the faces.
  [[nodiscard]] const std::vector<Index>& rim() const { return rim_; }
  [[nodiscard]] bool empty() const { return faces_ == 0; }
  [[nodiscard]] bool holds(Index face) const { return member_[face] != 0; }

  struct Place {
    Index face;
    bool on_rim, at_turn;  // at_turn: at a corner of the region
    bool on_edge;          // of the face
  };
  /// The face that the point is seen in; throws a flaw for a point beyond the rim.
  Place place(const Point3& p, std::size_t name);

 private:
  [[nodiscard]] Sign turn(Index corner, const Point2& p) const;
  [[nodiscard]] bool is_rim(Index corner) const;
  /// Where it is in the face, or the edge beyond which it is.
  std::optional<Index> beyond(Index face, const Point2& p, Place& place) const;
  [[nodiscard]] Index& start_for(const Point2& p);

  const Checked& checked_;
  Look look_;
  Sign orientation_;
  std::vector<unsigned char> member_;  // by face
  std::size_t faces_ = 0;
  std::vector<Index> rim_, start_;  // start_: a face for each cell of a grid, where a walk begins
  struct RimPoint {
    Point2 p;
    bool turns;
  };
  std::vector<RimPoint> rim_points_;  // by x, then y
  Point2 low_{}, scale_{};
  std::size_t cells_ = 1;
};

}  // namespace plumb::figure::hull3
