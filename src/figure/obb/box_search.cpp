#include "figure/obb/box_search.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::figure::frame {
namespace {

// No volume is sought that is smaller by less than this part of it, nor by less than this much of the cube around.
constexpr double precision = 0x1p-28, flat = 0x1p-40;
// Boxes looked at before the best so far is taken: about a second.  Hulls of some thousands of vertices need fewer.
constexpr long most_boxes = 1L << 22;
// A product of unit vectors below this may be zero.
constexpr double slack = 0x1p-40;

// The normals beside an edge, and no less than this is the hull's width along any normal between them.
struct Arc {
  Vector3 from, to;
  std::uint32_t vertex;  // on the edge
  double width;
};

// A box at one angle: normals, the vectors between the vertices that it touches on opposite sides, and widths.
struct Placed {
  std::array<Vector3, 3> normal, across;
  double volume;
};

class BoxSearch {
 public:
  BoxSearch(const HullModel& model, const FoundBox& start) : model_(model), starts_(model), best_(start) {
    arcs_.reserve(model.edges.size());
    for (const HullModel::Edge& e : model.edges) {
      const Vector3 &l = model.normals[e.left], &r = model.normals[e.right];
      const Vector3 a = across(e.from, l), b = across(e.from, r);
      arcs_.push_back({l, r, e.from, std::max(std::min(dot(a, l), dot(a, r)), std::min(dot(b, l), dot(b, r)))});
    }
    std::ranges::stable_sort(arcs_, {}, &Arc::width);
    least_width_ = arcs_.front().width;
  }

  FoundBox run() {
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      const double others = arcs_[i].width * least_width_;
      for (std::size_t j = i; j < arcs_.size() && boxes_ < most_boxes && others * arcs_[j].width < limit(); ++j)
        try_pair(arcs_[i], arcs_[j]);
    }
    return best_;
  }

 private:
  [[nodiscard]] double limit() const { return best_.volume * (1 - precision) - flat; }

  // From the farthest vertex against n to a vertex farthest along n.
  [[nodiscard]] Vector3 across(std::uint32_t vertex, const Vector3& n) const {
    return minus(model_.vertices[vertex], model_.vertices[starts_.farthest({-n.x, -n.y, -n.z})]);
  }

  // n1 = from + s (to - from) of the first arc; the second has a normal perpendicular to it where the products of n1
  // with its ends differ in sign.
  void try_pair(const Arc& a, const Arc& b) {
    const double ll = dot(a.from, b.from), lr = dot(a.from, b.to), rl = dot(a.to, b.from), rr = dot(a.to, b.to);
    if ((ll > slack && lr > slack && rl > slack && rr > slack) ||
        (ll < -slack && lr < -slack && rl < -slack && rr < -slack))
      return;
    std::array<double, 4> s{0, 1, 1, 1};
    std::size_t count = 1;
    for (const auto& [at0, at1] : {std::pair{ll, rl}, std::pair{lr, rr}}) {
      if ((at0 < 0) != (at1 < 0)) s.at(count++) = std::clamp(at0 / (at0 - at1), 0.0, 1.0);
    }
    if (count == 3 && s[1] > s[2]) std::swap(s[1], s[2]);
    s.at(count) = 1;
    for (std::size_t k = 0; k < count; ++k) {
      const double mid = (s.at(k) + s.at(k + 1)) / 2;
      const double l = ll + mid * (rl - ll), r = lr + mid * (rr - lr);
      if ((l > slack && r > slack) || (l < -slack && r < -slack)) continue;
      between(a, b, s.at(k), s.at(k + 1));
    }
  }

  void between(const Arc& a, const Arc& b, double s0, double s1) {
    for (const double t : {0.0, 1.0}) {  // where n1 is parallel to the second edge, n2 is any normal of its arc
      ++boxes_;
      Placed p0, p1;
      const bool free0 = normals(a, b, s0, t, p0), free1 = normals(a, b, s1, t, p1);
      Placed mid;
      (void)normals(a, b, (s0 + s1) / 2, t, mid);
      const Vector3 third = across(starts_.farthest(mid.normal[2]), mid.normal[2]);
      const double width = std::min(dot(third, p0.normal[2]), dot(third, p1.normal[2])) - bulge(p0, p1, third);
      if (a.width * b.width * std::max(width, least_width_) < limit()) {
        place(a, b, p0);
        place(a, b, p1);
        halve(a, b, s0, p0, s1, p1, 0);
      }
      if (!free0 && !free1) return;
    }
  }

  // The first two normals; true where `t` was needed.
  static bool normals(const Arc& a, const Arc& b, double s, double t, Placed& p) {
    const Vector3 n1 = unit(plus(times(a.from, 1 - s), times(a.to, s)));
    const double l = dot(n1, b.from), r = dot(n1, b.to);
    const bool free = std::fabs(l) <= slack && std::fabs(r) <= slack;
    const double at = free ? t : std::clamp(l / (l - r), 0.0, 1.0);
    Vector3 n2 = plus(times(b.from, 1 - at), times(b.to, at));
    (void)beside(n1, n2);
    p.normal = {n1, n2, cross(n1, n2)};
    return free;
  }

  // Not so where faces are so thin that they have no normal.
  static bool is_frame(const Placed& p) {
    return std::ranges::all_of(p.normal, [](const Vector3& n) { return dot(n, n) > 0.5; });
  }

  void place(const Arc& a, const Arc& b, Placed& p) {
    ++boxes_;
    p.across[0] = across(a.vertex, p.normal[0]);
    p.across[1] = across(b.vertex, p.normal[1]);
    p.across[2] = across(starts_.farthest(p.normal[2]), p.normal[2]);
    p.volume = dot(p.across[0], p.normal[0]) * dot(p.across[1], p.normal[1]) * dot(p.across[2], p.normal[2]);
    if (p.volume < best_.volume && is_frame(p)) best_ = {p.normal, p.volume};
  }

  // The third normal leaves the great circle between its ends by no more than the squares of the angles: what that may
  // take from the width along it.
  static double bulge(const Placed& p, const Placed& q, const Vector3& across) {
    const Vector3 turn0 = minus(p.normal[0], q.normal[0]), turn1 = minus(p.normal[1], q.normal[1]);
    return std::sqrt(dot(across, across)) * (dot(turn0, turn0) + dot(turn1, turn1)) / 2;
  }

  // Of the volume between two angles: the widths of fixed pairs of vertices are concave between them.
  static double lower_bound(const Placed& p, const Placed& q) {
    double product = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double of_p = std::min(dot(p.across[k], p.normal[k]), dot(p.across[k], q.normal[k]));
      const double of_q = std::min(dot(q.across[k], p.normal[k]), dot(q.across[k], q.normal[k]));
      double width = std::max(of_p, of_q);
      if (k == 2) width -= std::max(bulge(p, q, p.across[k]), bulge(p, q, q.across[k]));
      product *= std::max(width, 0.0);
    }
    return product;
  }

  void halve(const Arc& a, const Arc& b, double s0, const Placed& p0, double s1, const Placed& p1, int depth) {
    constexpr int deepest = 20;
    if (depth == deepest || boxes_ >= most_boxes || lower_bound(p0, p1) >= limit()) return;
    const double mid = (s0 + s1) / 2;
    Placed p;
    if (normals(a, b, mid, 0, p)) return;
    place(a, b, p);
    halve(a, b, s0, p0, mid, p, depth + 1);
    halve(a, b, mid, p, s1, p1, depth + 1);
  }

  const HullModel& model_;
  ClimbStarts starts_;
  std::vector<Arc> arcs_;
  double least_width_ = 0;
  long boxes_ = 0;
  FoundBox best_;
};

}  // namespace

FoundBox smallest_box(const HullModel& model, FoundBox start) { return BoxSearch(model, start).run(); }

}  // namespace plumb::figure::frame
