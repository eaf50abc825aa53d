#include "figure/obb/box_search.hpp"

#include <algorithm>
#include <cmath>

#include "figure/obb/flush_part.hpp"
#include "figure/obb/flush_volume.hpp"
#include "figure/obb/frame_volume.hpp"

namespace plumb::figure::frame {
namespace {

// The tolerance of the result, a guess of what pays: no volume is sought that is smaller by less than this part of it.
constexpr double finest_worth = 0x1p-42;
// By how much, as a part of the hull's extent, a box is too thick because its axes are doubles: what that leaves open
// is not worth the while, which is a guess too, as is how far off volumes in doubles are.
constexpr double axes_error = 0x1p-52, noise = 4 * axes_error;
// Where the search stops, guesses of what still pays: a turn smaller than this is not halved, nor are parts beyond this
// depth; what is left so counts as what it may be.
constexpr double finest = 0x1p-50;
constexpr int deepest = 200;
// Guesses of how many parts are enough: a hull of n arcs has seldom needed 200 n.
constexpr std::size_t parts_of_any = 32768, parts_of_arc = 512;
constexpr std::size_t cost_of_pairs = 4;  // a verdict by pairs of doubles takes about as long as so many parts
// Guesses: where a part has been halved so often, or its bound is so near to the limit, a box that is flush with a face
// may be the least.
constexpr int ends_from = 6;
constexpr double close = 1 - 0x1p-16;

double least_of(double a, double b) { return a < b ? a : b; }

// What the volume along the curve is measured with: doubles that carry their errors, or pairs of doubles.
struct Doubles {
  const FlushArcs& flush;
  [[nodiscard]] auto chord(const SearchedArc& a, double s) const {
    const double error = flush.direction_error;
    return exact_chord(known(a.flush.from, error), known(a.flush.to, error), s);
  }
  [[nodiscard]] auto edge(const SearchedArc& a) const { return known(a.flush.edge, flush.direction_error); }
  [[nodiscard]] auto vertex(std::uint32_t v) const { return known(flush.vertices[v], flush.vertex_error); }
};
struct Pairs {
  const FlushArcs& flush;
  [[nodiscard]] auto chord(const SearchedArc& a, double s) const {
    return exact_chord(flush.enclosed[a.number].from, flush.enclosed[a.number].to, s);
  }
  [[nodiscard]] const auto& edge(const SearchedArc& a) const { return flush.enclosed[a.number].edge; }
  [[nodiscard]] const auto& vertex(std::uint32_t v) const { return flush.places[v]; }
};

class BoxSearch {
 public:
  BoxSearch(const HullModel& model, const FlushArcs& flush, const FoundBox& start, double worth, std::size_t most_parts)
      : model_(model),
        flush_(flush),
        starts_(model_),
        error_(flush.vertex_error, flush.direction_error),
        most_parts_(most_parts),
        best_(start) {
    arcs_.reserve(flush.arcs.size());
    double thinness = 0;
    for (const Vector3& n : best_.axes) thinness += 1 / std::fabs(width(n));
    precision_ = worth + axes_error * thinness;
    noise_ = 1 + noise * thinness;
    if (!(precision_ < 0.5) || !(error_.third * thinness < 0.5) || !flush.are_sure) return;
    for (std::size_t i = 0; i < flush.arcs.size(); ++i) {
      const FlushArc& f = flush.arcs[i];
      add({f, i, {0, 1}, {f.from, f.to}}, 0);
    }
    std::ranges::stable_sort(arcs_, {}, &SearchedArc::width);
    least_width_ = arcs_.front().width;
  }

  // `least` of these may be little where parts were left because they were too many.
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
      if (is_cut_short()) {
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

  [[nodiscard]] bool is_cut_short() const { return parts_ >= most_parts_; }
  [[nodiscard]] double precision() const { return precision_; }

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
    add({a.flush, a.number, {a.s[0], mid}, {a.end[0], n}}, depth + 1);
    add({a.flush, a.number, {mid, a.s[1]}, {n, a.end[1]}}, depth + 1);
  }

  // Looks at all vertices, in doubles, for a frame that may become the best.
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

  // Any box will do: one whose first normal is where a's arc is divided by s, and whose second is perpendicular to b's
  // edge.  Doubles say whether it is worth a closer look.
  void try_box(const SearchedArc& a, double s, const SearchedArc& b) {
    const Vector3 n1 = unit(plus(a.flush.from, times(minus(a.flush.to, a.flush.from), s)));
    Vector3 n2 = cross(b.flush.edge, n1);
    if (!beside(n1, n2)) return;
    const std::array normals{n1, n2, cross(n1, n2)};
    const double enough = best_.volume * noise_;
    if (!(width(n1) * width(n2) * width(normals[2]) < enough) || !(volume_of(normals) < enough)) return;
    const Pairs numbers{flush_};
    const auto first = numbers.chord(a, s);
    const double volume = volume_above(flush_, {first, arith::cross(numbers.edge(b), first)});
    if (volume < best_.volume) best_ = {normals, volume};
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

  template <class Numbers>
  [[nodiscard]] FlushVerdict verdict(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p, const Across& v,
                                     double limit) const {
    const Numbers numbers{flush_};
    const bool along_a = is_along_a(a, b, p);
    const SearchedArc &along = along_a ? a : b, &beside = along_a ? b : a;
    const auto& s = along_a ? p.s : p.t;
    const std::size_t first = along_a ? 0 : 1, second = 1 - first;
    const auto across = [&](std::size_t k) { return numbers.vertex(v.ahead[k]) - numbers.vertex(v.behind[k]); };
    return no_smaller_flush(FlushTurn{numbers.chord(along, s[0]), numbers.chord(along, s[1]), numbers.edge(beside),
                                      across(first), across(second), across(2)},
                            limit);
  }

  // Where doubles do not tell: along chords the product is linear in both.
  [[nodiscard]] bool is_never_perpendicular(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p) const {
    const Pairs numbers{flush_};
    const Unsure<Sign> side = arith::dot(numbers.chord(a, p.s[0]), numbers.chord(b, p.t[0])).sign();
    if (!side.certain() || side.value() == Sign::zero) return false;
    for (const double s : p.s) {
      for (const double t : p.t) {
        if (arith::dot(numbers.chord(a, s), numbers.chord(b, t)).sign() != side) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_excluded(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p, const Across& v) {
    const FlushVerdict quick = verdict<Doubles>(a, b, p, v, limit());
    if (quick != FlushVerdict::unsure) return quick == FlushVerdict::excluded;
    parts_ += cost_of_pairs;
    return verdict<Pairs>(a, b, p, v, limit()) == FlushVerdict::excluded;
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
    const auto [least_along, most_along] = std::minmax({f00, f01, f10, f11});
    if (least_along > error_.product || most_along < -error_.product) return;
    if ((least_along > 0 || most_along < 0) && is_never_perpendicular(a, b, p)) return;

    const Vector3 n1 = plus(p.a[0], p.a[1]), n2 = plus(p.b[0], p.b[1]), n3 = cross(n1, n2);
    const std::uint32_t q1 = depth == 0 ? a.beyond : opposite(n1), q2 = depth == 0 ? b.beyond : opposite(n2);
    const Across across{{a.flush.vertex, b.flush.vertex, farthest(n3)}, {q1, q2, opposite(n3)}};
    double least = least_volume(a, b, p, across);
    if (least >= limit()) return;
    if (depth > 0) {
      if (is_excluded(a, b, p, across)) return;
      is_along_a(a, b, p) ? try_box(a, (p.s[0] + p.s[1]) / 2, b) : try_box(b, (p.t[0] + p.t[1]) / 2, a);
    }
    const bool is_close = least > limit() * close;
    for (std::size_t end = 0; is_close && end < 2; ++end) {
      const Across at_end = across_at_end(a, b, p, end);
      least = std::max(least, least_volume(a, b, p, at_end));
      if (least >= limit() || is_excluded(a, b, p, at_end)) return;
    }
    if (depth == ends_from || is_close) {
      for (const double s : p.s) try_box(a, s, b);
      for (const double t : p.t) try_box(b, t, a);
    }
    halve(a, b, p, least, depth);
  }

  // What is too small to be halved, by pairs of doubles where they say more: near to the limit as a rule.
  void leave(const SearchedArc& a, const SearchedArc& b, const SearchedPart& p, double least) {
    const Vector3 n1 = plus(p.a[0], p.a[1]), n2 = plus(p.b[0], p.b[1]), n3 = cross(n1, n2);
    const Across across{{a.flush.vertex, b.flush.vertex, farthest(n3)}, {opposite(n1), opposite(n2), opposite(n3)}};
    for (double less = 2 * precision_; limit() * (1 - less) > least; less *= 2) {
      const double lower = limit() * (1 - less);
      parts_ += cost_of_pairs;
      if (verdict<Pairs>(a, b, p, across, lower) == FlushVerdict::excluded) return leave(lower);
    }
    leave(least);
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
    if (is_cut_short()) return leave(least);
    if (is_finest || depth >= deepest) return leave(a, b, p, least);
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
  const FlushArcs& flush_;
  ClimbStarts starts_;
  SearchErrors error_;
  std::size_t most_parts_, parts_ = 0;
  FoundBox best_;
  std::vector<SearchedArc> arcs_;
  double least_width_ = 0, precision_, noise_, left_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SearchedBox smallest_box(const HullModel& model, const FlushArcs& flush, const FoundBox& start,
                         std::size_t most_parts) {
  constexpr double coarser = 0x1p12, too_coarse = 0.5;
  SearchedBox found{{start.axes, volume_above(flush, right_angle(start.axes))}, 0};
  most_parts = std::min(most_parts, parts_of_any + parts_of_arc * flush.arcs.size());
  // Where there are too many parts for all that is worth the while, as many as can be seen say something.
  for (double worth = finest_worth; worth < too_coarse; most_parts /= 2) {
    BoxSearch search(model, flush, found.best, worth, most_parts);
    const auto [best, least] = search.run();
    found = {best, std::max(found.least, least)};
    if (!search.is_cut_short()) break;
    worth = coarser * search.precision();
  }
  return found;
}

}  // namespace plumb::figure::frame
