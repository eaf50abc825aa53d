// How do shapes and pairs of shapes look?  Their wire frames, one picture for each kind, form and position.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "degenerate/picture.hpp"
#include "degenerate/wire_frame.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/shape_pair.hpp"

namespace plumb_test {

using plumb::degenerate::Form;
using plumb::degenerate::Position;
using plumb::degenerate::ShapePair;

inline constexpr int panel_size = 200, panel_margin = 10;
inline constexpr std::string_view blue = "#1f5fa8", orange = "#c07000";

/// Seen from somewhat above; `up` leads upward in the picture.
struct View {
  Vec3 right{0.9, -0.44, 0}, up{-0.17, -0.35, 0.92};

  [[nodiscard]] Dot operator()(const Vec3& p) const { return {along(p, right), along(p, up)}; }
};

/// A drawing that a panel can show.
class Flattened {
 public:
  Flattened(const Wires& wires, const View& view) {
    for (const auto& chain : wires.chains) {
      chains_.emplace_back();
      for (const Vec3& p : chain) chains_.back().push_back(view(p));
    }
    for (const Vec3& p : wires.corners) corners_.push_back(view(p));
  }

  void add_to(std::vector<Dot>& all) const {
    for (const auto& chain : chains_) all.insert(all.end(), chain.begin(), chain.end());
    all.insert(all.end(), corners_.begin(), corners_.end());
  }
  void draw(Picture& picture, const Panel& panel, std::string_view color, double dot) const {
    for (const auto& chain : chains_) {
      std::vector<Dot> on_panel;
      for (const Dot& d : chain) on_panel.push_back(panel.at(d));
      picture.chain(on_panel, color);
    }
    for (const Dot& d : corners_) picture.dot(panel.at(d), dot, color);
  }
  [[nodiscard]] const std::vector<Dot>& corners() const { return corners_; }

 private:
  std::vector<std::vector<Dot>> chains_;
  std::vector<Dot> corners_;
};

/// Far from the origin and at the ends of the format doubles are not for drawing.
inline bool is_for_drawing(const std::vector<double>& x) {
  double most = 0;
  for (const double c : x) {
    most = std::fmax(most, std::fabs(c));
    if (std::trunc(0x1p20 * c) != 0x1p20 * c) return false;
  }
  return most > 2 && most < 2000;
}

inline bool apart(const Dot& a, const Dot& b, double least) { return std::hypot(a.x - b.x, a.y - b.y) > least; }

/// Whether the corners are some way from one another, and the whole is as high as wide, all but.
inline bool is_fit_to_see(const Flattened& drawing, double least) {
  std::vector<Dot> all;
  drawing.add_to(all);
  const Panel around = Panel::around(all, 0, 0, 1);
  const auto& corners = drawing.corners();
  double low = INFINITY, high = -INFINITY, left = INFINITY, right = -INFINITY;
  for (const Dot& d : all) {
    low = std::fmin(low, d.y), high = std::fmax(high, d.y), left = std::fmin(left, d.x), right = std::fmax(right, d.x);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!apart(corners[i], corners[j], least * around.extent)) return false;
    }
  }
  if (corners.size() < 3) return true;
  double area = 0;  // of the largest triangle of corners
  for (const Dot& p : corners) {
    for (const Dot& q : corners) {
      const Dot& o = corners[0];
      area = std::fmax(area, ((p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x)) / 2);
    }
  }
  return area > 0.1 * around.extent * around.extent && std::fmin(high - low, right - left) > 0.5 * around.extent;
}

/// How far apart corners are to be, as a part of the picture.
constexpr double least_of(ShapeKind kind) {
  const bool many = kind == ShapeKind::k_dop || kind == ShapeKind::mesh || kind == ShapeKind::holed_polygon;
  return many ? 0.04 : 0.16;
}
constexpr bool is_swept(ShapeKind kind) { return kind == ShapeKind::capsule || kind == ShapeKind::lozenge; }

/// The first plain shape of the kind that is fit to see, if there is one.
inline bool draw_kind(Picture& picture, double left, ShapeKind kind, int dimension) {
  for (std::uint64_t index = 0; index < 50'000; ++index) {
    plumb::Entropy entropy(64, index);
    std::vector<double> x = shape(kind, dimension, Form::plain, entropy);
    if (!is_for_drawing(x)) continue;
    if (kind == ShapeKind::holed_polygon && x[0] < 4) continue;
    if (kind == ShapeKind::mesh && (x[0] < 7 || x[0] > 9)) continue;
    const double radius = x.back();
    const WireFrame frame(kind, dimension, std::move(x));
    const Flattened drawing(frame.wires(), dimension == 2 ? View{{1, 0, 0}, {0, 1, 0}} : View{});
    if (!is_fit_to_see(drawing, least_of(kind))) continue;
    if (kind == ShapeKind::halfspaces && drawing.corners().size() < 4) continue;
    if (kind == ShapeKind::k_dop && drawing.corners().size() < (dimension == 2 ? 7u : 16u)) continue;
    std::vector<Dot> all;
    drawing.add_to(all);
    const Panel panel = Panel::around(all, left, panel_margin, panel_size);
    if (is_swept(kind) && radius < 0.12 * panel.extent) continue;
    drawing.draw(picture, panel, blue, 2.5);
    return true;
  }
  return false;
}

/// Of the plane on the left, of space on the right.
inline Picture kind_picture(ShapeKind kind) {
  std::vector<int> dimensions;
  for (const int dimension : {2, 3}) {
    if (is_kind_of(kind, dimension)) dimensions.push_back(dimension);
  }
  Picture picture(static_cast<int>(dimensions.size()) * (panel_size + 2 * panel_margin), 240);
  double left = panel_margin;
  for (const int dimension : dimensions) {
    if (!draw_kind(picture, left, kind, dimension)) throw plumb::Error("kind_picture: no shape is fit to see");
    picture.words({left, 230}, dimension == 2 ? "in the plane" : "in space");
    left += panel_size + 2 * panel_margin;
  }
  return picture;
}

/// Four triangles of the form; of the empty one, slabs and halfspaces whose bounds part.
inline Picture form_picture(Form form) {
  Picture picture(panel_size + 2 * panel_margin, 240);
  const bool empty = form == Form::empty;
  for (std::size_t row = 0; row < 4; ++row) {
    const ShapeKind kind = !empty ? ShapeKind::triangle : row % 2 == 0 ? ShapeKind::slab : ShapeKind::halfspaces;
    plumb::Entropy entropy(63, static_cast<std::size_t>(form) * 10 + row);
    std::vector<double> x = shape(kind, 2, form, entropy);
    if (!empty) {  // as they are far from the origin as well
      const double first = x[0], second = x[1];
      for (std::size_t i = 0; i < x.size(); i += 2) x[i] -= first, x[i + 1] -= second;
    }
    const Flattened drawing(WireFrame(kind, 2, std::move(x), empty).wires(), View{{1, 0, 0}, {0, 1, 0}});
    std::vector<Dot> all;
    drawing.add_to(all);
    const double left = panel_margin + 105.0 * static_cast<double>(row % 2);
    const double top = panel_margin + 105.0 * static_cast<double>(row / 2);
    drawing.draw(picture, Panel::around(all, left, top, 95), blue, 2);
  }
  picture.words({panel_margin, 230}, empty ? "ticks: inside of each bound" : "four triangles");
  return picture;
}

/// By shapes that show the position: the first case that is fit to see, looked at along the plane between them.
inline Picture position_picture(Position position) {
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
  const auto [a, b] = shown[static_cast<std::size_t>(position)];
  Picture picture(panel_size + 2 * panel_margin, 240);
  for (std::uint64_t index = 0; index < 50'000; ++index) {
    plumb::Entropy entropy(62, index);
    const ShapePair pair = shape_pair(a, b, 3, position, plumb::degenerate::Nearness::exactly, entropy);
    if (pair.contact != Vec3{} || !is_for_drawing(pair.a) || !is_for_drawing(pair.b)) continue;
    const bool has_normal = along(pair.normal, pair.normal) > 0;
    View view;
    view.up = unit(has_normal ? pair.normal : Vec3{1, 2, 9});
    view.right = unit(crossed(std::fabs(view.up[2]) < 0.9 ? Vec3{0.3, 0.2, 1} : Vec3{1, 0.2, 0.1}, view.up));
    const Vec3 back = crossed(view.up, view.right);
    view.right = plus(view.right, back, 0.35);
    view.up = plus(view.up, back, 0.3);
    const Flattened first(WireFrame(a, 3, pair.a).wires(), view), second(WireFrame(b, 3, pair.b).wires(), view);
    std::vector<Dot> all;
    first.add_to(all);
    second.add_to(all);
    const Panel panel = Panel::around(all, panel_margin, panel_margin, panel_size);
    const double least = 0.16 * panel.extent;
    const auto spread = [&](const Flattened& drawing) {
      const auto& c = drawing.corners();
      for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (!apart(c[i], c[j], least)) return false;
        }
      }
      return is_fit_to_see(drawing, 0);
    };
    // Two shapes are to be seen, not one before the other.
    const bool both = std::any_of(second.corners().begin(), second.corners().end(), [&](const Dot& q) {
      return std::all_of(first.corners().begin(), first.corners().end(),
                         [&](const Dot& p) { return apart(p, q, least); });
    });
    if (!spread(first) || !spread(second) || !(both || position >= Position::equal)) continue;
    first.draw(picture, panel, blue, 3);
    second.draw(picture, panel, orange, 1.5);
    if (position <= Position::shared_face) picture.ring(panel.at({0, 0}), 5, "#c02020");
    return picture;
  }
  throw plumb::Error("position_picture: no pair is fit to see");
}

}  // namespace plumb_test
