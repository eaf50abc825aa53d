#include "world/gpu/cells.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/arith/interval.hpp"

namespace plumb::world {
namespace {

constexpr std::int64_t cells = std::int64_t{1} << CellView::depth_bits;
constexpr double far_away = 0x1p50;  // a power of two that leaves room to add

std::array<double, 3> numbers(const Point3& p) { return {p.x, p.y, p.z}; }

/// A guess: whatever it is, cells are right.
double scale_for(double width, double whole) {
  const double fitting = width > 0 ? static_cast<double>(cells - 1) / width : 0x1p1000;
  const double steady = whole > 0 ? 0x1p40 / whole : 1;
  return std::min({fitting, steady, 0x1p1000});
}

/// Ranges of integers that hold a point: floor of the least, ceiling of the greatest.
struct WholeRange {
  std::int64_t low, high;
  bool is_far;
};
WholeRange range_of(double low, double high, double origin, double scale) {
  const double from = ((Interval(low) - Interval(origin)) * Interval(scale)).lower;
  const double to = ((Interval(high) - Interval(origin)) * Interval(scale)).upper;
  const bool is_far = !(from >= -far_away && to <= far_away);
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::clamp(x, -far_away, far_away)); };
  return {whole(std::floor(from)), whole(std::ceil(to)), is_far};
}

std::int64_t half_down(std::int64_t x) { return x >> 1; }
std::int64_t half_up(std::int64_t x) { return (x + 1) >> 1; }

}  // namespace

CellView::CellView(const Aabb3& box, const Aabb3& around, std::size_t depth_axis, int pixel_bits)
    : shift_(depth_bits - pixel_bits), fine_(std::max(cells >> pixel_bits, cells / 16)) {
  const auto low = numbers(box.min), high = numbers(box.max), least = numbers(around.min), most = numbers(around.max);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t axis = (depth_axis + 1 + k) % 3;
    axes_[k] = axis;
    origin_[k] = low[axis];
    scale_[k] = scale_for(high[axis] - low[axis], most[axis] - least[axis]);
    last_[k] = range_of(low[axis], high[axis], origin_[k], scale_[k]).high;
    top_[k] = std::clamp(last_[k], std::int64_t{0}, cells - 1);
    small_ = std::max(small_, (high[axis] - low[axis]) / 16);
  }
}

CellView::Place CellView::place_of(const Aabb3& corner) const {
  const auto low = numbers(corner.min), high = numbers(corner.max);
  Place place{{}, {}, false};
  for (std::size_t k = 0; k < 3; ++k) {
    const WholeRange r = range_of(low[axes_[k]], high[axes_[k]], origin_[k], scale_[k]);
    place.low[k] = r.low;
    place.high[k] = r.high;
    place.is_far = place.is_far || r.is_far;
  }
  return place;
}

std::vector<CellView::Place> CellView::places_of(const DrawnShape& shape) const {
  std::vector<Place> places;
  places.reserve(shape.corners.size());
  for (const Aabb3& corner : shape.corners) places.push_back(place_of(corner));
  return places;
}

/// Parts of a triangle or an edge until each takes about a pixel.
template <std::size_t corners>
struct CellView::Drawing {
  const CellView& view;
  bool is_surface;  // what is not in the depths of the box is left out
  std::int32_t tile;
  std::vector<CellRange>& to;

  void draw(const std::array<Place, corners>& at) const {
    Place whole = at[0];
    std::array<std::int64_t, 3> widest{};
    for (const Place& p : at) {
      whole.is_far = whole.is_far || p.is_far;
      for (std::size_t k = 0; k < 3; ++k) {
        whole.low[k] = std::min(whole.low[k], p.low[k]);
        whole.high[k] = std::max(whole.high[k], p.high[k]);
        widest[k] = std::max(widest[k], p.high[k] - p.low[k]);
      }
    }
    for (std::size_t k = 0; k < (is_surface ? 3 : 2); ++k)
      if (whole.high[k] < 0 || whole.low[k] > view.last_[k]) return;
    bool divides = false;
    for (std::size_t k = 0; k < 3; ++k) {
      divides = divides || (inside(whole.high[k], k) - inside(whole.low[k], k) > view.fine_ &&
                            whole.high[k] - whole.low[k] > 2 * widest[k] + 2);
    }
    if (!divides || whole.is_far || is_small(whole)) return add(whole);
    divide(at);
  }

 private:
  [[nodiscard]] std::int64_t inside(std::int64_t x, std::size_t k) const {
    return std::clamp(x, std::int64_t{0}, view.top_[k]);
  }
  /// A guess, so that of a thin slab no more parts are made than of a cube.
  [[nodiscard]] bool is_small(const Place& whole) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (static_cast<double>(whole.high[k] - whole.low[k]) > view.small_ * view.scale_[k]) return false;
    return true;
  }
  static Place middle(const Place& a, const Place& b) {
    Place m{{}, {}, false};
    for (std::size_t k = 0; k < 3; ++k) {
      m.low[k] = half_down(a.low[k] + b.low[k]);
      m.high[k] = half_up(a.high[k] + b.high[k]);
    }
    return m;
  }
  /// A guess of it in space, where parts are to be as long as they are wide.
  [[nodiscard]] double length(const Place& a, const Place& b) const {
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t way = std::max(a.high[k], b.high[k]) - std::min(a.low[k], b.low[k]);
      most = std::max(most, static_cast<double>(way) / view.scale_[k]);
    }
    return most;
  }
  /// At the middle of the longest edge.
  void divide(const std::array<Place, corners>& at) const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < (corners == 2 ? 1 : corners); ++i)
      if (length(at[i], at[(i + 1) % corners]) > length(at[longest], at[(longest + 1) % corners])) longest = i;
    const std::size_t other = (longest + 1) % corners;
    const Place m = middle(at[longest], at[other]);
    auto first = at, second = at;
    first[other] = m;
    second[longest] = m;
    draw(first);
    draw(second);
  }
  void add(const Place& whole) const {
    const auto cell = [&](std::int64_t x, std::size_t k) { return static_cast<std::int32_t>(inside(x, k)); };
    const auto pixel = [&](std::int64_t x, std::size_t k) { return cell(x, k) >> view.shift_; };
    to.push_back({{pixel(whole.low[0], 0), pixel(whole.low[1], 1), pixel(whole.high[0], 0), pixel(whole.high[1], 1)},
                  {cell(whole.low[2], 2), cell(whole.high[2], 2)},
                  tile});
  }
};

void CellView::draw_faces(const DrawnShape& shape, std::int32_t tile, std::vector<CellRange>& to) const {
  const std::vector<Place> places = places_of(shape);
  const Drawing<3> drawing{*this, shape.is_surface, tile, to};
  for (const auto& f : shape.faces) drawing.draw({places[f[0]], places[f[1]], places[f[2]]});
}

void CellView::draw_edges(const DrawnShape& shape, std::int32_t tile, std::vector<CellRange>& to) const {
  const std::vector<Place> places = places_of(shape);
  const Drawing<2> drawing{*this, shape.is_surface, tile, to};
  for (const auto& e : shape.edges) drawing.draw({places[e[0]], places[e[1]]});
}

}  // namespace plumb::world
