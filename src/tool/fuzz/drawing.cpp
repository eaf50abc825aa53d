#include "tool/fuzz/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "degenerate/wire_model.hpp"
#include "degenerate/words.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/degenerate/ulps.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/label_placement.hpp"

namespace plumb::tool {
namespace {

using degenerate::Kind;
using degenerate::Numbers;
using degenerate::WireFigure;
using Place = std::array<double, 3>;
using Exact3 = std::array<Rational, 3>;

constexpr double kWidth = 560, kHeight = 340, kEdge = 56, kDot = 4.5;
constexpr double kThinnest = 0.3;  // of the length: what is flatter is stretched to this
constexpr double kTogether = 7;    // pixels: points that share a label
constexpr std::size_t kMostLabels = 40, kMostRows = 12, kMostCrowds = 3;
constexpr double kTooNear = 1.0 / 400;  // of the extent: what a drawing to scale cannot tell apart

Exact3 minus(const Exact3& a, const Exact3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Exact3& a, const Exact3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The square root of a quotient, as far as doubles reach.
double root(const Rational& x) { return std::sqrt(x.rounded()); }

/// Coordinates along the longest distance, across it, and above both: of each, the longest is 1.
struct Frame {
  std::vector<Place> places;
  std::array<double, 3> extent{1, 0, 0};  // of across and above, beside the length
};

template <class Value>
std::size_t farthest(std::size_t count, const Value& value) {
  std::size_t best = 0;
  Rational most = value(0);
  for (std::size_t i = 1; i < count; ++i) {
    Rational other = value(i);
    if (most < other) best = i, most = std::move(other);
  }
  return best;
}

Frame frame_of(const std::vector<Exact3>& points, bool flat) {
  const std::size_t n = points.size();
  const auto square_from = [&](std::size_t from) {
    return [&, from](std::size_t i) {
      const Exact3 d = minus(points[i], points[from]);
      return dot(d, d);
    };
  };
  // Twice the farthest of another is as good as the longest of all, within a factor of two.
  const std::size_t a = farthest(n, square_from(farthest(n, square_from(0)))), b = farthest(n, square_from(a));
  Frame frame{std::vector<Place>(n, Place{0, 0, 0})};
  const Exact3 u = minus(points[b], points[a]);
  const Rational length = dot(u, u);
  if (length == Rational(0.0)) return frame;
  std::vector<Exact3> across(n), up(n);  // |u|^2 times what is across u
  for (std::size_t i = 0; i < n; ++i) {
    const Exact3 d = minus(points[i], points[a]);
    const Rational along = dot(d, u);
    frame.places[i][0] = (along / length).rounded();
    for (std::size_t k = 0; k < 3; ++k) across[i][k] = length * d[k] - along * u[k];
  }
  const std::size_t c = farthest(n, [&](std::size_t i) { return dot(across[i], across[i]); });
  const Rational width = dot(across[c], across[c]);
  if (width == Rational(0.0)) return frame;
  frame.extent[1] = root(width / (length * length * length));
  // In the plane up is up: left of the line, not where the first point happens to be.
  const bool mirrored = flat && (u[0] * across[c][1] - u[1] * across[c][0]).sign() == Sign::negative;
  for (std::size_t i = 0; i < n; ++i) {
    const Rational part = dot(across[i], across[c]) / width;
    frame.places[i][1] = (mirrored ? -part : part).rounded();
  }
  if (flat) return frame;
  const Exact3 normal = cross(u, across[c]);
  const auto height = [&](std::size_t i) { return dot(minus(points[i], points[a]), normal); };
  const std::size_t d = farthest(n, [&](std::size_t i) { return height(i) * height(i); });
  const Rational most = height(d);
  if (most == Rational(0.0)) return frame;
  frame.extent[2] = root(most * most / (dot(normal, normal) * length));
  for (std::size_t i = 0; i < n; ++i) frame.places[i][2] = (height(i) / most).rounded();
  if (most.sign() == Sign::negative) {
    for (Place& p : frame.places) p[2] = -p[2];
  }
  return frame;
}

/// What is drawn: points, and outlines through some of them.
struct Scene {
  struct Outline {
    std::vector<std::size_t> at;
    std::size_t color = 0;
    bool closed = true, arrow = false;
  };
  std::vector<Place> given = {};
  std::vector<Exact3> exact = {};
  std::vector<std::string> names = {};
  std::vector<std::size_t> colors = {};
  std::vector<bool> tips = {};  // of arrows: no points of the case
  std::vector<Outline> outlines = {};
  bool flat = true;
  bool round = false;  // in the plane: the last of four points lies to the circle of the others

  /// Only these points, and the outlines that have no others.
  [[nodiscard]] Scene part(const std::vector<std::size_t>& kept) const {
    Scene some;
    some.flat = flat;
    std::map<std::size_t, std::size_t> now;
    for (const std::size_t i : kept) {
      now[i] = some.given.size();
      some.given.push_back(given[i]);
      some.exact.push_back(exact[i]);
      some.names.push_back(names[i]);
      some.colors.push_back(colors[i]);
      some.tips.push_back(tips[i]);
    }
    for (Outline o : outlines) {
      if (!std::ranges::all_of(o.at, [&](std::size_t i) { return now.contains(i); })) continue;
      for (std::size_t& i : o.at) i = now[i];
      some.outlines.push_back(std::move(o));
    }
    return some;
  }
};

Scene scene_of(const Kind& kind, const Numbers& numbers) {
  Scene scene;
  for (const degenerate::Argument& argument : kind.arguments) {
    for (const degenerate::Part& part : argument.parts)
      scene.flat = scene.flat && (part.dimension <= 2 || part.role == degenerate::Role::extents);
  }
  std::size_t color = 0;
  bool points_alone = true;
  for (const WireFigure& f : wire_model(kind, numbers)) {
    const std::size_t first = scene.given.size();
    const auto outline = [&](const auto& at, bool closed, bool arrow = false) {
      Scene::Outline o{{}, color, closed, arrow};
      for (const std::size_t i : at) o.at.push_back(first + i);
      scene.outlines.push_back(std::move(o));
    };
    for (const auto& face : f.faces) outline(face, true);
    for (const auto& edge : f.edges) outline(edge, false);
    for (const auto& arrow : f.arrows) outline(arrow, false, true);
    for (std::size_t i = 0; i < f.points.size(); ++i) {
      const Place& p = f.points[i];
      scene.given.push_back(p);
      scene.exact.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
      scene.names.push_back(f.points.size() == 1 ? f.name : fmt::format("{}{}", f.name, i));
      scene.colors.push_back(color);
      scene.tips.push_back(std::ranges::any_of(f.arrows, [i](const auto& arrow) { return arrow[1] == i; }));
    }
    points_alone = points_alone && f.points.size() == 1;
    color = (color + 1) % 6;
  }
  scene.round = points_alone && kind.name == "incircle";
  if (points_alone && scene.given.size() >= 3) {  // what the last point lies to: a line, a plane, a circle, a sphere
    Scene::Outline others{{}, 6, scene.given.size() > 3, false};
    for (std::size_t i = 0; i + 1 < scene.given.size(); ++i) others.at.push_back(i);
    scene.outlines.push_back(std::move(others));
  }
  return scene;
}

/// How far the fourth point is off the circle of three, in parts of its radius; nothing where they lie in line.
std::string off_the_circle(const std::vector<Exact3>& p) {
  const Exact3 b = minus(p[1], p[0]), c = minus(p[2], p[0]), d = minus(p[3], p[0]);
  const Rational twice = Rational(2.0) * (b[0] * c[1] - b[1] * c[0]), bb = dot(b, b), cc = dot(c, c);
  if (twice.sign() == Sign::zero) return " The first three lie in line.";
  const Exact3 center{(bb * c[1] - cc * b[1]) / twice, (cc * b[0] - bb * c[0]) / twice, Rational(0.0)};
  const Exact3 from = minus(d, center);
  const Rational square = dot(center, center), off = (dot(from, from) - square) / square;
  if (off.sign() == Sign::zero) return " The last point is on the circle.";
  const double part = std::sqrt(1 + off.rounded()) - 1;
  return fmt::format(" The last point is {} the circle, by {:.2g} of its radius.",
                     off.sign() == Sign::positive ? "outside of" : "inside of",
                     std::fabs(part) < 1e-6 ? std::fabs(off.rounded()) / 2 : std::fabs(part));
}

/// Points that fall together in a drawing.
struct Cluster {
  double x, y;
  std::vector<std::size_t> points;
};

class Drawing {
 public:
  explicit Drawing(Scene scene) : scene_(std::move(scene)) { project(frame_of(scene_.exact, scene_.flat)); }

  std::string svg(const std::string& title) {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n",
        kWidth, kHeight, escaped(title));
    if (scene_.round && to_scale_) draw_circle();
    for (const Scene::Outline& o : scene_.outlines) draw(o);
    for (std::size_t i = 0; i < at_.size(); ++i) {
      if (!scene_.tips[i])
        out_ += fmt::format("<circle class=\"s{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>\n", scene_.colors[i],
                            at_[i][0], at_[i][1], kDot);
    }
    draw_labels();
    return out_ + "</svg>\n";
  }

  [[nodiscard]] const std::string& scale() const { return scale_; }

  /// What cannot be told apart here and differs, each to be drawn from near.
  [[nodiscard]] std::vector<Scene> crowds() const {
    std::vector<Scene> all;
    for (const Cluster& c : clusters()) {
      const auto differs = [&](std::size_t i) { return scene_.given[i] != scene_.given[c.points[0]]; };
      if (c.points.size() < at_.size() && std::ranges::any_of(c.points, differs)) all.push_back(scene_.part(c.points));
    }
    return all;
  }

 private:
  void project(const Frame& frame) {
    std::array<double, 3> drawn = frame.extent;
    std::vector<std::string> said;
    for (std::size_t k = 1; k < 3; ++k) {
      if (frame.extent[k] == 0 || frame.extent[k] >= kThinnest) continue;
      drawn[k] = kThinnest;
      said.push_back(
          fmt::format("{} stretched {:.3g} times", k == 1 ? "across" : "height", kThinnest / frame.extent[k]));
    }
    scale_ = said.empty() ? "To scale" : fmt::format("Along the longest distance to scale, {}", fmt::join(said, ", "));
    scale_ += scene_.flat ? "." : "; seen aslant.";
    to_scale_ = said.empty();
    if (scene_.round) scale_ += off_the_circle(scene_.exact);
    double left = 0, right = 0, low = 0, high = 0;
    for (const Place& p : frame.places) {
      const double s = p[0], t = p[1] * drawn[1], r = p[2] * drawn[2];
      at_.push_back(scene_.flat ? std::array{s, t} : std::array{s + 0.45 * t, 0.5 * t + r});
      left = std::min(left, at_.back()[0]), right = std::max(right, at_.back()[0]);
      low = std::min(low, at_.back()[1]), high = std::max(high, at_.back()[1]);
    }
    const double room_x = kWidth - 2 * kEdge, room_y = kHeight - 2 * kEdge;
    const double unit = right == left && high == low
                            ? 0
                            : std::min(room_x / std::max(right - left, 1e-9), room_y / std::max(high - low, 1e-9));
    for (auto& [x, y] : at_) {
      x = kWidth / 2 + unit * (x - (left + right) / 2);
      y = kHeight / 2 - unit * (y - (low + high) / 2);
    }
  }

  void draw(const Scene::Outline& o) {
    std::string points;
    for (const std::size_t i : o.at) points += fmt::format("{:.1f},{:.1f} ", at_[i][0], at_[i][1]);
    out_ += fmt::format("<poly{} class=\"s{} drawn\" fill-opacity=\"0.14\" points=\"{}\"/>\n",
                        o.closed ? "gon" : "line", o.color, points);
    if (o.arrow) draw_tip(at_[o.at[0]], at_[o.at[1]], o.color);
  }

  void draw_circle() {
    const auto [ax, ay] = at_[0];
    const double bx = at_[1][0] - ax, by = at_[1][1] - ay, cx = at_[2][0] - ax, cy = at_[2][1] - ay;
    const double twice = 2 * (bx * cy - by * cx), bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double x = (bb * cy - cc * by) / twice, y = (cc * bx - bb * cx) / twice, radius = std::hypot(x, y);
    if (!(radius < 20 * kWidth)) return;  // nor NaN
    out_ += fmt::format("<circle class=\"axis\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n", ax + x, ay + y, radius);
  }

  void draw_tip(const std::array<double, 2>& from, const std::array<double, 2>& to, std::size_t color) {
    const double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
    if (length == 0) return;
    const double ux = 11 * x / length, uy = 11 * y / length;
    out_ += fmt::format("<polygon class=\"s{}\" points=\"{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}\"/>\n", color, to[0],
                        to[1], to[0] - ux - 0.45 * uy, to[1] - uy + 0.45 * ux, to[0] - ux + 0.45 * uy,
                        to[1] - uy - 0.45 * ux);
  }

  [[nodiscard]] std::vector<Cluster> clusters() const {
    std::vector<Cluster> all;
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const auto near = std::ranges::find_if(
          all, [&](const Cluster& c) { return std::hypot(c.x - at_[i][0], c.y - at_[i][1]) < kTogether; });
      if (near == all.end()) {
        all.push_back({at_[i][0], at_[i][1], {i}});
      } else {
        near->points.push_back(i);
      }
    }
    return all;
  }

  [[nodiscard]] std::string label_of(const Cluster& c) const {
    std::string label = scene_.names[c.points[0]];
    for (std::size_t k = 1; k < c.points.size(); ++k) {
      const bool equal = scene_.given[c.points[k - 1]] == scene_.given[c.points[k]];
      label.append(equal ? " = " : ", ").append(scene_.names[c.points[k]]);
    }
    return label.size() > 30 ? label.substr(0, 27) + "..." : label;
  }

  /// One for all that fall together.
  void draw_labels() {
    const std::vector<Cluster> all = clusters();
    if (all.size() > kMostLabels) return;
    std::vector<LabelRequest> requests;
    const Box area{4, 4, kWidth - 4, kHeight - 4};
    for (const Cluster& c : all) {
      requests.push_back({c.x, c.y, 7.5 * static_cast<double>(label_of(c).size()) + 6, 17, area});
    }
    const auto placed = place_labels(requests, area, kDot + 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
      Box box{all[i].x + 7, all[i].y - 20, 0, all[i].y - 3};
      if (placed) {
        const LabelPlace& place = (*placed)[i];
        box = place.box;
        if (place.leader)
          out_ += fmt::format("<line class=\"leader\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                              place.from_x, place.from_y, place.to_x, place.to_y);
      }
      const std::string label = label_of(all[i]);
      out_ += fmt::format(
          "<rect class=\"paper\" fill-opacity=\"0.8\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"15\"/>\n",
          box.left + 1, box.bottom - 16, 7.3 * static_cast<double>(label.size()) + 3);
      out_ += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", box.left + 3, box.bottom - 4,
                          escaped(label));
    }
  }

  const Scene scene_;
  std::vector<std::array<double, 2>> at_;
  bool to_scale_ = true;
  std::string scale_, out_;
};

std::string doubles_apart(double x, double y) {
  const auto apart = static_cast<std::uint64_t>(place_of(y)) - static_cast<std::uint64_t>(place_of(x));
  if (apart > 1ULL << 52) return "-";  // beyond a factor of two: to count tells nothing
  return apart > 9'999'999 ? fmt::format("{:.2g}", static_cast<double>(apart)) : fmt::format("{}", apart);
}

}  // namespace

std::string case_drawings(const Kind& kind, const Numbers& numbers) {
  Scene scene = scene_of(kind, numbers);
  if (scene.given.empty()) return {};
  Drawing whole(std::move(scene));
  std::string html = fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n",
                                 whole.svg("The figures of the case"), whole.scale());
  std::size_t left = kMostCrowds;
  for (Scene& crowd : whole.crowds()) {
    if (left-- == 0) break;
    std::string names;
    for (const std::string& name : crowd.names) names.append(names.empty() ? "" : ", ").append(name);
    Drawing near(std::move(crowd));
    html += fmt::format("<figure>{}<figcaption>From near: {}. {}</figcaption></figure>\n",
                        near.svg("What falls together"), escaped(names), near.scale());
  }
  return html;
}

std::string near_coincidences(const Kind& kind, const Numbers& numbers) {
  std::string rows;
  std::size_t count = 0;
  double extent = 0;
  std::array<std::map<double, std::string>, 3> axes;
  for (const WireFigure& f : wire_model(kind, numbers)) {
    for (std::size_t i = 0; i < f.points.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        std::string& where = axes[k][f.points[i][k]];
        const std::string name =
            f.points.size() == 1 ? fmt::format("{}.{}", f.name, "xyz"[k]) : fmt::format("{}{}.{}", f.name, i, "xyz"[k]);
        if (where.size() < 24) where.append(where.empty() ? "" : ", ").append(name);
      }
    }
  }
  for (const auto& axis : axes) {
    if (!axis.empty()) extent = std::max(extent, axis.rbegin()->first / 2 - axis.begin()->first / 2);
  }
  for (const auto& axis : axes) {
    for (auto x = axis.begin(); x != axis.end(); ++x) {
      const auto y = std::next(x);
      if (y == axis.end() || !(y->first / 2 - x->first / 2 < extent * kTooNear)) continue;
      if (++count > kMostRows) continue;
      rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{}</td></tr>\n",
                          escaped(x->second), degenerate::decimal(x->first), escaped(y->second),
                          degenerate::decimal(y->first), (Rational(y->first) - Rational(x->first)).rounded(),
                          doubles_apart(x->first, y->first));
    }
  }
  if (count == 0) return {};
  std::string html =
      "<div class=\"counts\"><table>\n<tr><th scope=\"col\">all but equal</th><th></th><th></th><th></th>"
      "<th scope=\"col\">apart</th><th scope=\"col\">in ulps</th></tr>\n" +
      rows + "</table></div>\n";
  if (count > kMostRows) html += fmt::format("<p>and {} more</p>\n", count - kMostRows);
  return html;
}

}  // namespace plumb::tool
