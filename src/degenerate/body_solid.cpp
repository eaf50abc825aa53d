#include <algorithm>
#include <map>

#include "degenerate/body_drawing.hpp"

namespace plumb::degenerate {

namespace {

using Corners = std::vector<std::size_t>;  // of a face or a triangle, in turn

/// A tetrahedron whose edges and faces are cut at points of them: coplanar and needle-shaped triangles of one solid.
class CutTetrahedron {
 public:
  explicit CutTetrahedron(const Drawing& draw) : draw_(draw) {}

  Body made() {
    body_.kind = draw_.order.kind;
    auto& p = body_.points;
    p = vertices_of(draw_, 4, Drawing::fraction);
    if (dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0) std::swap(p[1], p[2]);  // faces turn to the outside
    const std::array<std::array<std::size_t, 3>, 4> faces{{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    const std::size_t dented = draw_.order.around ? faces.size() : draw_.entropy.below(2 * faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      Corners around;
      for (std::size_t i = 0; i < 3; ++i) {
        around.push_back(faces[f][i]);
        if (const auto cut = cut_of(faces[f][i], faces[f][(i + 1) % 3])) around.push_back(*cut);
      }
      const bool ground = std::all_of(faces[f].begin(), faces[f].end(), [&](std::size_t i) { return p[i][2] == 0; });
      const bool dent = f == dented && !ground, whole = ground && draw_.order.shared != 0;
      if (dent || (draw_.entropy.coin() && !whole)) {
        fan_from_within(faces[f], dent, around);
      } else {
        fan(around);
      }
    }
    return std::move(body_);
  }

 private:
  // A weight of each in eighths, none zero.
  Int3 eighths(const Corners& corners) {
    Int left = Drawing::fraction - static_cast<Int>(corners.size());
    Int3 sum{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const bool last = i + 1 == corners.size();
      const Int more = last ? left : static_cast<Int>(draw_.entropy.below(static_cast<std::uint64_t>(left) + 1));
      left -= more;
      sum = sum + (1 + more) * body_.points[corners[i]];
    }
    for (Int& x : sum) x /= Drawing::fraction;
    return sum;
  }
  std::size_t add(const Int3& p) {
    body_.points.push_back(p);
    return body_.points.size() - 1;
  }

  /// The point that cuts an edge, for both of its faces.
  std::optional<std::size_t> cut_of(std::size_t i, std::size_t j) {
    const auto [at, fresh] = cuts_.try_emplace(std::minmax(i, j));
    const bool ground = body_.points[i][2] == 0 && body_.points[j][2] == 0;
    if (fresh && draw_.entropy.below(3) == 2 && !(ground && draw_.order.shared != 0)) {
      at->second = add(eighths({std::min(i, j), std::max(i, j)}));
    }
    return at->second;
  }

  void triangle(std::size_t a, std::size_t b, std::size_t c) { body_.parts.insert(body_.parts.end(), {a, b, c}); }

  // From a point on an edge, if there is one: no triangle then has its corners on one line.
  void fan(Corners around) {
    const auto cut = std::find_if(around.begin(), around.end(), [](std::size_t i) { return i >= 4; });
    if (cut != around.end()) std::rotate(around.begin(), cut, around.end());
    for (std::size_t i = 1; i + 1 < around.size(); ++i) triangle(around[0], around[i], around[i + 1]);
  }
  void fan_from_within(const std::array<std::size_t, 3>& face, bool dented, const Corners& around) {
    Corners all(face.begin(), face.end());
    if (dented) all = {0, 1, 2, 3};  // within the tetrahedron instead of the face
    const std::size_t middle = add(eighths(all));
    for (std::size_t i = 0; i < around.size(); ++i) triangle(middle, around[i], around[(i + 1) % around.size()]);
  }

  const Drawing& draw_;
  Body body_{};
  std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> cuts_;
};

}  // namespace

Body mesh_body(const Drawing& draw) { return CutTetrahedron(draw).made(); }

// A turned ball, stretched along the axes and sheared along the ground: it touches the ground below its center.
Body ellipsoid_body(const Drawing& draw) {
  const Int3 stretched{draw.length(0), draw.length(1), draw.length(2)};
  const Int half = 1 + static_cast<Int>(draw.entropy.below(4));
  const IntMap turned = any_turn(draw.entropy);
  const Int3 leaning{draw.entropy.within(2), draw.entropy.within(2), 1};
  const IntMap shape{{{{stretched[0], 0, 0}, {0, stretched[1], 0}, stretched[2] * leaning}}, 0};
  Body body{draw.order.kind, {half * turned.stretch * stretched[2] * leaning}};
  for (const Int3& axis : turned.columns) {
    body.half.push_back(half);
    body.points.push_back(body.points[0] + shape(axis));
  }
  return body;
}

}  // namespace plumb::degenerate
