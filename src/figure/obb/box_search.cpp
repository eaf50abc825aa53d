#include "figure/obb/box_search.hpp"

#include <algorithm>
#include <cmath>

#include "figure/obb/flush_part.hpp"
#include "figure/obb/flush_volume.hpp"

namespace plumb::figure::frame {
namespace {

// The tolerance of the result, a guess of what pays: no volume is sought that is smaller by less than this part of it.
constexpr double precision = 0x1p-42;
// Where the search stops, guesses of what still pays: a turn smaller than this is not halved, nor are parts beyond this
// depth; what is left so counts as what it may be.
constexpr double finest = 0x1p-46;
constexpr int deepest = 200;
// Guesses: where a part has been halved so often, or its bound is so near to the limit, a box that is flush with a face
// may be the least.
constexpr int ends_from = 6;
constexpr double close = 1 - 0x1p-16;

double least_of(double a, double b) { return a < b ? a : b; }

class BoxSearch {
 public:
  BoxSearch(const HullModel& model, const FlushArcs& flush, const FoundBox& start, std::size_t most_parts)
      : model_(model),
        starts_(model),
        vertex_error_(flush.vertex_error),
        direction_error_(flush.direction_error),
        error_(flush.vertex_error, flush.direction_error),
        most_parts_(most_parts),
        best_(start) {
    arcs_.reserve(flush.arcs.size());
    best_.volume = volume_of(best_.axes);
    double doubt = 0;
    for (const Vector3& n : best_.axes) doubt += error_.third / std::fabs(width(n));
    precision_ = precision + doubt;  // what roundings leave undecided is not worth the while
    if (!(precision_ < 0.5) || !flush.are_sure) return;
    for (const FlushArc& f : flush.arcs) add({f, {0, 1}, {f.from, f.to}}, 0);
    std::ranges::stable_sort(arcs_, {}, &SearchedArc::width);
    least_width_ = arcs_.front().width;
  }

  SearchedBox run() {
    if (!(least_width_ > 0)) return {best_, 0};
    const std::size_t n = arcs_.size();
    std::vector<double> x(n), y(n), z(n), reach(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3& c = arcs_[i].center;
      x[i] = c.x, y[i] = c.y, z[i] = c.z, reach[i] = arcs_[i].reach;
    }
    std::vector<std::uint32_t> met(n);
    for (std::size_t i = 0; i < n; ++i) {
      const SearchedArc& a = arcs_[i];
      if (parts_ >= most_parts_) {
        leave(below(below(a.width * a.width) * least_width_));
        break;
      }
      const double enough = above(limit() / below(a.width * least_width_));
      const auto end = static_cast<std::size_t>(std::ranges::lower_bound(arcs_.begin() + static_cast<std::ptrdiff_t>(i),
                                                                         arcs_.end(), enough, {}, &SearchedArc::width) -
                                                arcs_.begin());
      // Arcs of which a normal can be perpendicular to one of a's, without a branch.
      std::size_t count = 0;
      for (std::size_t j = i; j < end; ++j) {
        met[count] = static_cast<std::uint32_t>(j);
        const double along = a.center.x * x[j] + a.center.y * y[j] + a.center.z * z[j];
        count += static_cast<std::size_t>(std::fabs(along) <= a.reach + reach[j]);
      }
      for (std::size_t k = 0; k < count; ++k) {
        const SearchedArc& b = arcs_[met[k]];
        look(a, b, {a.s, b.s, a.end, b.end}, 0);
      }
    }
    return {best_, least_of(limit(), left_)};
  }

 private:
  // Falls as better boxes are found: what was no less than a limit is no less than the last one.
  [[nodiscard]] double limit() const { return best_.volume * (1 - precision_); }
  // What is not looked at any further may be as small as this.
  void leave(double least) { left_ = least_of(left_, std::max(least, 0.0)); }

  [[nodiscard]] Vector3 between(std::uint32_t from, std::uint32_t to) const {
    return minus(model_.vertices[to], model_.vertices[from]);
  }
  [[nodiscard]] std::uint32_t farthest(const Vector3& n) const { return starts_.farthest(n); }
  [[nodiscard]] std::uint32_t opposite(const Vector3& n) const { return farthest({-n.x, -n.y, -n.z}); }
  [[nodiscard]] double width(const Vector3& n) const { return dot(between(opposite(n), farthest(n)), n); }

  // Halved where the width of one pair of vertices says too little of the whole.
  void add(SearchedArc a, int depth) {
    a.center = unit(plus(a.end[0], a.end[1]));
    a.center = times(a.center, shortening(dot(a.center, a.center), error_.square));
    // Unit normals are no farther from the center than those at the ends, which are no shorter than `end`.
    const auto center = known(a.center, 0);
    double square = 0;
    for (const Vector3& n : a.end) {
      const Running along = arith::dot(known(n, error_.normal), center);
      square = std::max(square, (Running(1.0) + arith::dot(center, center) - along - along).upper());
    }
    a.reach = above(above(std::sqrt(square)) + error_.product);  // with what products of centers are off
    double most = std::numeric_limits<double>::infinity();
    for (const Vector3& n : {a.center, a.end[0], a.end[1]}) {
      const std::uint32_t q = opposite(n);
      const Vector3 d = between(q, a.flush.vertex);
      const double w = below(least_of(dot(d, a.end[0]), dot(d, a.end[1])) - error_.width);
      if (!(w <= a.width)) a.width = w, a.beyond = q;
      most = least_of(most, dot(d, n));
    }
    constexpr double share = 0.75;
    constexpr int cuts = 12;
    if (a.width >= share * most || depth == cuts) {
      arcs_.push_back(a);
      return;
    }
    const double mid = (a.s[0] + a.s[1]) / 2;
    const Vector3 n = at(a.flush, mid);
    add({a.flush, {a.s[0], mid}, {a.end[0], n}}, depth + 1);
    add({a.flush, {mid, a.s[1]}, {n, a.end[1]}}, depth + 1);
  }

  // By all vertices, of a frame that may become the best.
  [[nodiscard]] double volume_of(const std::array<Vector3, 3>& normals) const {
    double volume = 1;
    for (const Vector3& n : normals) {
      double least = dot(model_.vertices[0], n), most = least;
      for (const Vector3& v : model_.vertices) {
        const double far = dot(v, n);
        least = std::min(least, far);
        most = std::max(most, far);
      }
      volume *= most - least;
    }
    return volume;
  }

  // Any box will do: one whose first normal is n, and whose second is perpendicular to an edge.
  void try_box(const Vector3& n, const Vector3& edge) {
    const Vector3 n1 = unit(n);
    Vector3 n2 = cross(edge, n1);
    if (!beside(n1, n2)) return;
    const std::array normals{n1, n2, cross(n1, n2)};
    if (!(width(n1) * width(n2) * width(normals[2]) < best_.volume)) return;
    const double volume = volume_of(normals);
    if (volume < best_.volume && volume > 0) best_ = {normals, volume};
  }

  [[nodiscard]] Vector3 at(const FlushArc& arc, double s) const { return flush_normal(arc, s, error_); }

  // Vertices along n1, n2 and n3, and those opposite them.
  struct Across {
    std::array<std::uint32_t, 3> ahead, behind;
  };

  // No box of the part has less, by the widths of these vertices.
  [[nodiscard]] double least_volume(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p,
                                    const Across& v) const {
    const Vector3 d1 = between(v.behind[0], v.ahead[0]), d2 = between(v.behind[1], v.ahead[1]),
                  d3 = between(v.behind[2], v.ahead[2]);
    const double w1 = std::max(a.width, below(least_of(dot(d1, p.a[0]), dot(d1, p.a[1])) - error_.width));
    const double w2 = std::max(b.width, below(least_of(dot(d2, p.b[0]), dot(d2, p.b[1])) - error_.width));
    const double w3 = least_of(least_of(dot(d3, cross(p.a[0], p.b[0])), dot(d3, cross(p.a[0], p.b[1]))),
                               least_of(dot(d3, cross(p.a[1], p.b[0])), dot(d3, cross(p.a[1], p.b[1]))));
    return below(below(w1 * w2) * std::max(least_width_, below(w3 - error_.third)));
  }

  // The curve is followed along the arc whose normals are farther from the other's edge.
  static bool is_along_a(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p) {
    return std::fabs(dot(plus(p.a[0], p.a[1]), b.flush.edge)) <= std::fabs(dot(plus(p.b[0], p.b[1]), a.flush.edge));
  }

  [[nodiscard]] bool is_excluded(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p,
                                 const Across& v) const {
    const bool along_a = is_along_a(a, b, p);
    const FlushArc &along = (along_a ? a : b).flush, &beside = (along_a ? b : a).flush;
    const auto& s = along_a ? p.s : p.t;
    const std::size_t first = along_a ? 0 : 1, second = 1 - first;
    const auto across = [&](std::size_t k) {
      return known(model_.vertices[v.ahead[k]], vertex_error_) - known(model_.vertices[v.behind[k]], vertex_error_);
    };
    const auto turned = [&](double at) { return exact_chord(along, at, direction_error_); };
    return no_smaller_flush(
        {turned(s[0]), turned(s[1]), known(beside.edge, direction_error_), across(first), across(second), across(2)},
        limit());
  }

  // Of vertices that lie equally far at this end of the part, those that are farther in the part.
  [[nodiscard]] Across across_at_end(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p,
                                     std::size_t end) const {
    const std::size_t other = std::fabs(dot(p.a[end], p.b[0])) <= std::fabs(dot(p.a[end], p.b[1])) ? 0 : 1;
    constexpr double slightly = 0x1p-42;  // a guess: any vertices will do
    const Vector3 n1 = plus(p.a[end], times(p.a[1 - end], slightly));
    const Vector3 n2 = plus(p.b[other], times(p.b[1 - other], slightly)), n3 = cross(n1, n2);
    return {{a.flush.vertex, b.flush.vertex, farthest(n3)}, {opposite(n1), opposite(n2), opposite(n3)}};
  }

  void look(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p, int depth) {
    ++parts_;
    const double f00 = dot(p.a[0], p.b[0]), f01 = dot(p.a[0], p.b[1]);
    const double f10 = dot(p.a[1], p.b[0]), f11 = dot(p.a[1], p.b[1]);
    if (std::min({f00, f01, f10, f11}) > error_.product || std::max({f00, f01, f10, f11}) < -error_.product) return;

    const Vector3 n1 = plus(p.a[0], p.a[1]), n2 = plus(p.b[0], p.b[1]), n3 = cross(n1, n2);
    const std::uint32_t q1 = depth == 0 ? a.beyond : opposite(n1), q2 = depth == 0 ? b.beyond : opposite(n2);
    const Across across{{a.flush.vertex, b.flush.vertex, farthest(n3)}, {q1, q2, opposite(n3)}};
    double least = least_volume(a, b, p, across);
    if (least >= limit()) return;
    if (depth > 0) {
      if (is_excluded(a, b, p, across)) return;
      is_along_a(a, b, p) ? try_box(n1, b.flush.edge) : try_box(n2, a.flush.edge);
    }
    const bool is_close = least > limit() * close;
    for (std::size_t end = 0; is_close && end < 2; ++end) {
      const Across at_end = across_at_end(a, b, p, end);
      least = std::max(least, least_volume(a, b, p, at_end));
      if (least >= limit() || is_excluded(a, b, p, at_end)) return;
    }
    if (depth == ends_from || is_close) {
      for (const Vector3& n : p.a) try_box(n, b.flush.edge);
      for (const Vector3& n : p.b) try_box(n, a.flush.edge);
    }
    halve(a, b, p, least, depth);
  }

  void halve(const SearchedArc& a, const SearchedArc& b, SearchedPart p, double least, int depth) {
    const std::array given{p.s, p.t};
    narrow(a.flush, p.b, error_, p.s, p.a);
    narrow(b.flush, p.a, error_, p.t, p.b);
    if (!(p.s[0] <= p.s[1]) || !(p.t[0] <= p.t[1])) return;
    const Vector3 turn_a = minus(p.a[1], p.a[0]), turn_b = minus(p.b[1], p.b[0]);
    const double of_a = dot(turn_a, turn_a), of_b = dot(turn_b, turn_b);
    const bool is_finest = std::max(of_a, of_b) < finest * finest;
    if (is_finest && given != std::array{p.s, p.t}) return look(a, b, p, depth + 1);
    if (is_finest || depth >= deepest || parts_ >= most_parts_) {
      leave(least);
      return;
    }
    const bool first = of_a >= of_b;
    SearchedPart q = p;
    auto& [lower, upper] = first ? p.s : p.t;
    const double mid = (lower + upper) / 2;
    const Vector3 n = at(first ? a.flush : b.flush, mid);
    upper = mid;
    (first ? p.a : p.b)[1] = n;
    (first ? q.s : q.t)[0] = mid;
    (first ? q.a : q.b)[0] = n;
    look(a, b, p, depth + 1);
    look(a, b, q, depth + 1);
  }

  const HullModel& model_;
  ClimbStarts starts_;
  double vertex_error_, direction_error_;
  SearchErrors error_;
  std::size_t most_parts_, parts_ = 0;
  FoundBox best_;
  std::vector<SearchedArc> arcs_;
  double least_width_ = 0, precision_ = precision, left_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SearchedBox smallest_box(const HullModel& model, const FlushArcs& flush, const FoundBox& start,
                         std::size_t most_parts) {
  return BoxSearch(model, flush, start, most_parts).run();
}

}  // namespace plumb::figure::frame
