// How do pairs of shapes look?  Wire frames of generated pairs, seen so that the plane between them lies.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "degenerate/picture.hpp"
#include "plumb/degenerate/shape_pair.hpp"

namespace plumb_test {

using plumb::degenerate::Form;
using plumb::degenerate::Position;
using plumb::degenerate::ShapeKind;
using plumb::degenerate::ShapePair;
using Vec3 = std::array<double, 3>;

inline Vec3 difference(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 crossed(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double along(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 unit(const Vec3& a) {
  const double length = std::sqrt(along(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

struct Wires {
  std::vector<Vec3> corners;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// Of shapes with corners in space.
inline Wires wires_of(ShapeKind kind, const std::vector<double>& x) {
  const auto at = [&](std::size_t i) { return Vec3{x[3 * i], x[3 * i + 1], x[3 * i + 2]}; };
  Wires wires;
  if (kind == ShapeKind::obb) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vec3 p = at(0);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) p[k] += (((corner >> i) & 1) != 0 ? 1 : -1) * x[12 + i] * at(1 + i)[k];
      }
      wires.corners.push_back(p);
      for (unsigned i = 0; i < 3; ++i) {
        if (((corner >> i) & 1) == 0) wires.edges.emplace_back(corner, corner | (1u << i));
      }
    }
    return wires;
  }
  for (std::size_t i = 0; 3 * i < x.size(); ++i) {
    wires.corners.push_back(at(i));
    for (std::size_t j = 0; j < i; ++j) wires.edges.emplace_back(i, j);
  }
  return wires;
}

/// Draws both in the panel of a pair; whether no corners fall together, as pictures need.
class PairDrawing {
 public:
  PairDrawing(ShapeKind a, ShapeKind b, const ShapePair& pair) : wires_{wires_of(a, pair.a), wires_of(b, pair.b)} {
    const bool has_normal = along(pair.normal, pair.normal) > 0;
    const Vec3 up = unit(has_normal ? pair.normal : Vec3{1, 2, 9});
    const Vec3 right = unit(crossed(std::fabs(up[2]) < 0.9 ? Vec3{0.3, 0.2, 1} : Vec3{1, 0.2, 0.1}, up));
    const Vec3 back = crossed(up, right);
    for (std::size_t k = 0; k < 2; ++k) {
      for (const Vec3& p : wires_[k].corners) {
        const Vec3 d = difference(p, pair.contact);
        dots_[k].push_back({along(d, right) + 0.35 * along(d, back), along(d, up) + 0.3 * along(d, back)});
      }
    }
  }

  [[nodiscard]] bool fit_to_see(bool same) const {
    std::vector<Dot> all = dots_[0];
    all.insert(all.end(), dots_[1].begin(), dots_[1].end());
    const double extent = Panel::around(all, 0, 0, 1).extent;
    for (const std::vector<Dot>& dots : dots_) {
      for (std::size_t i = 0; i < dots.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (std::hypot(dots[i].x - dots[j].x, dots[i].y - dots[j].y) < 0.16 * extent) return false;
        }
      }
    }
    // Two shapes are to be seen, not one before the other.
    return same || std::any_of(dots_[1].begin(), dots_[1].end(), [&](const Dot& q) {
             return std::all_of(dots_[0].begin(), dots_[0].end(),
                                [&](const Dot& p) { return std::hypot(p.x - q.x, p.y - q.y) > 0.16 * extent; });
           });
  }

  void draw(Picture& picture, double left, double top, double size, bool contact) const {
    std::vector<Dot> all = dots_[0];
    all.insert(all.end(), dots_[1].begin(), dots_[1].end());
    const Panel panel = Panel::around(all, left, top, size);
    constexpr std::array<std::string_view, 2> colors = {"#1f5fa8", "#c07000"};
    for (std::size_t k = 0; k < 2; ++k) {
      for (const auto& [i, j] : wires_[k].edges) picture.line(panel.at(dots_[k][i]), panel.at(dots_[k][j]), colors[k]);
      for (const Dot& d : dots_[k]) picture.dot(panel.at(d), k == 0 ? 3 : 1.5, colors[k]);
    }
    if (contact) picture.ring(panel.at({0, 0}), 5, "#c02020");
  }

 private:
  std::array<Wires, 2> wires_;
  std::array<std::vector<Dot>, 2> dots_;
};

inline constexpr int pair_width = 190, pair_height = 210;

/// Every position, by shapes that show it: the first case that is fit to see.
inline Picture all_positions() {
  using Kinds = std::pair<ShapeKind, ShapeKind>;
  constexpr auto tetrahedron = ShapeKind::tetrahedron, triangle = ShapeKind::triangle, box = ShapeKind::obb;
  constexpr std::array<Kinds, plumb::degenerate::positions.size()> shown = {{{tetrahedron, tetrahedron},
                                                                             {box, tetrahedron},
                                                                             {box, tetrahedron},
                                                                             {tetrahedron, tetrahedron},
                                                                             {box, triangle},
                                                                             {box, triangle},
                                                                             {tetrahedron, box},
                                                                             {triangle, tetrahedron},
                                                                             {tetrahedron, tetrahedron},
                                                                             {box, box},
                                                                             {box, tetrahedron},
                                                                             {box, triangle},
                                                                             {box, tetrahedron},
                                                                             {box, tetrahedron},
                                                                             {tetrahedron, tetrahedron},
                                                                             {triangle, triangle}}};
  Picture picture(4 * pair_width, 4 * pair_height);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const auto [a, b] = shown[k];
    const auto& info = plumb::degenerate::positions[k];
    const double left = 15 + pair_width * static_cast<double>(k % 4);
    const double top = 10 + pair_height * static_cast<double>(k / 4);
    for (std::uint64_t index = 0; index < 5000; ++index) {
      plumb::Entropy entropy(62, index);
      const ShapePair pair = shape_pair(a, b, 3, info.position, plumb::degenerate::Nearness::exactly, entropy);
      // Far from the origin and at the ends of the format doubles are not for drawing.
      if (std::fabs(pair.contact[0]) > 2000 || along(pair.contact, pair.contact) != 0) continue;
      const PairDrawing drawing(a, b, pair);
      if (!drawing.fit_to_see(info.position >= Position::equal)) continue;
      drawing.draw(picture, left, top, 160, info.position <= Position::shared_face);
      break;
    }
    picture.words({left, top + 182}, info.name);
  }
  return picture;
}

/// Triangles of every form.
inline Picture all_forms() {
  Picture picture(4 * pair_width, 2 * pair_height);
  for (std::size_t k = 0; k < plumb::degenerate::forms.size(); ++k) {
    const auto& info = plumb::degenerate::forms[k];
    const double left = 15 + pair_width * static_cast<double>(k % 4);
    const double top = 10 + pair_height * static_cast<double>(k / 4);
    for (int row = 0; row < 4; ++row) {
      plumb::Entropy entropy(63, k * 10 + static_cast<std::size_t>(row));
      const std::vector<double> x = shape(ShapeKind::triangle, 2, info.form, entropy);
      std::vector<Dot> dots;
      for (std::size_t i = 0; i < 3; ++i) dots.push_back({x[2 * i] - x[0], x[2 * i + 1] - x[1]});
      const Panel panel = Panel::around(dots, left + 80 * (row % 2), top + 80 * static_cast<double>(row / 2), 76);
      for (std::size_t i = 0; i < 3; ++i) {
        picture.line(panel.at(dots[i]), panel.at(dots[(i + 1) % 3]), "#1f5fa8");
        picture.dot(panel.at(dots[i]), 2);
      }
    }
    picture.words({left, top + 182}, info.name);
  }
  return picture;
}

}  // namespace plumb_test
