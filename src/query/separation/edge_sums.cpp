#include "query/separation/edge_sums.hpp"

#include <cmath>

#include "arith/vec.hpp"
#include "plumb/certify/accepted.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {

template <class Shape>
inline constexpr bool is_edge_sum = figure_dimension<Shape> == 3 &&
                                    is_one_of(figure_kind<Shape>,
                                              {FigureKind::point, FigureKind::segment, FigureKind::rectangle,
                                               FigureKind::ball, FigureKind::aabb, FigureKind::obb,
                                               FigureKind::capsule});

void EdgeSum::take_edge(const Vector3& axis, const Vector3& begin, const Vector3& end) {
  edges[size++] = {axis, begin, end, all};
}

template <class Shape>
bool EdgeSum::take(const Shape& s) {
  if (!is_sound(s) || is_nothing(s)) return false;
  constexpr FigureKind kind = figure_kind<Shape>;
  const auto as_vector = [](const Point3& p) { return Vector3{p.x, p.y, p.z}; };
  const auto opposite = [](const Vector3& v) { return Vector3{-v.x, -v.y, -v.z}; };
  /// The ends of what is twice the middle; where it stands they are seen from the first.
  const auto take_middle = [&](const Point3& p, const Point3& q) {
    const bool stands = form == PoseForm::none;
    to = as_vector(q), from = stands ? as_vector(p) : opposite(as_vector(p));
    if (stands) at = as_vector(p);
  };
  if constexpr (kind == FigureKind::point) {
    take_middle(s, s);
  } else if constexpr (kind == FigureKind::ball) {
    take_middle(s.center, s.center);
  } else if constexpr (kind == FigureKind::segment || kind == FigureKind::capsule) {
    take_middle(s.a, s.b);
    if (s.a != s.b) take_edge({1, 1, 1}, as_vector(s.a), as_vector(s.b));
    all = 1;
  } else if constexpr (kind == FigureKind::aabb) {
    take_middle(s.min, s.max);
    const Vector3 least = as_vector(s.min), most = as_vector(s.max);
    const auto take_axis = [&](const Vector3& axis, bool has_length) {
      if (has_length) take_edge(axis, least, most);
      ++all;
    };
    take_axis({1, 0, 0}, least.x != most.x), take_axis({0, 1, 0}, least.y != most.y);
    take_axis({0, 0, 1}, least.z != most.z);
  } else {
    static_assert(kind == FigureKind::obb || kind == FigureKind::rectangle);
    take_middle(s.center, s.center);
    const auto half = coordinates(s.half);
    for (std::size_t k = 0; k < half.size(); ++k) {
      const double h = std::fabs(half[k]);
      if (h != 0 && s.axes[k] != Vector3{}) take_edge(s.axes[k], {-h, -h, -h}, {h, h, h});
      ++all;
    }
  }
  if constexpr (requires { s.radius; }) radius = s.radius;
  return radius >= 0;
}

bool EdgeSum::take_pose(const RigidPose& by) {
  const auto m = exact_matrix(by.turn);
  if (!m) return false;
  form = PoseForm::doubles, columns = m->columns, weight = m->weight, at = by.translation;
  return true;
}

bool EdgeSum::take_pose(const AnyPoseView& by) {
  const auto* chain = std::get_if<const RigidChain*>(&by.by);
  if (by.stands() || (chain != nullptr && (*chain)->links.empty())) {
    columns = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    return true;
  }
  const auto* rigid = std::get_if<const RigidPose*>(&by.by);
  if (chain != nullptr) {
    if ((*chain)->links.size() == 1 && take_pose((*chain)->links.front())) return true;
    if (!is_sound(**chain)) return false;
  } else {
    if (rigid == nullptr) return false;
    if (take_pose(**rigid)) return true;
    if (!is_sound(**rigid)) return false;
  }
  const auto about = weighted_pose<double>(by);
  const auto vector = [](const arith::Plain& v) { return Vector3{v.x, v.y, v.z}; };
  form = PoseForm::other, pose = by, weight = about.weight;
  columns = {vector(about.columns[0]), vector(about.columns[1]), vector(about.columns[2])};
  at = vector(about.translation * (1 / weight));
  return true;
}

bool EdgeSum::set(const PosedView& v) {
  if (v.figure.dimension != 3 || !take_pose(v.pose)) return false;
  return with_figure(v.figure, [this]<class Shape>(const Shape& s) {
    if constexpr (is_edge_sum<Shape>) {
      return take(s);
    } else {
      return false;
    }
  });
}

namespace {

using arith::Plain;

/// A guess in doubles, which holds no bound: the least of |middle + sum of c_k edge_k| for all c_k between -1 and 1.
class FaceSearch {
 public:
  FaceSearch(const EdgeSum& a, const EdgeSum& b) : of_a_(a.size), size_(a.size + b.size) {
    const auto turned = [](const EdgeSum& s, const Plain& v) {
      if (s.form == PoseForm::none) return v;
      const auto& c = s.columns;
      return Plain{c[0].x * v.x + c[1].x * v.y + c[2].x * v.z, c[0].y * v.x + c[1].y * v.y + c[2].y * v.z,
                   c[0].z * v.x + c[1].z * v.y + c[2].z * v.z};
    };
    const auto between = [](const Vector3& from, const Vector3& to) {
      return Plain{to.x - from.x, to.y - from.y, to.z - from.z};
    };
    const double over_a = 1 / a.weight, over_b = -1 / b.weight;
    const Plain middle =
        turned(a, between(a.from, a.to)) * over_a + turned(b, between(b.from, b.to)) * over_b + between(b.at, a.at) * 2;
    std::uint32_t n = 0;
    const auto take = [&](const EdgeSum& s, double over) {
      for (std::uint32_t k = 0; k < s.size; ++k) {
        const auto& [axis, from, to, number] = s.edges[k];
        const Plain way{axis.x * (to.x - from.x), axis.y * (to.y - from.y), axis.z * (to.z - from.z)};
        edge_[n++] = turned(s, way) * over;
      }
    };
    take(a, over_a), take(b, over_b);
    for (std::uint32_t i = 0; i < size_; ++i) {
      for (std::uint32_t j = 0; j <= i; ++j) product_[i][j] = product_[j][i] = dot(edge_[i], edge_[j]);
      with_middle_[i] = dot(edge_[i], middle);
      part_[i] = with_middle_[i] > 0 ? -1 : 1;
    }
  }

  std::optional<EdgeFace> run() {
    constexpr int most_rounds = 24;  // a guess: whoever has not ended by then goes round
    for (int round = 0; round < most_rounds; ++round) {
      std::uint32_t worst = size_;
      double most = 0;
      for (std::uint32_t i = 0; i < size_; ++i) {
        const double inward = is_free(i) ? 0 : part_[i] * slope(i);
        if (inward > most) worst = i, most = inward;
      }
      if (worst == size_) return face();
      if (free_ == 3) return {};
      which_[free_++] = worst;
      if (!settle()) return {};
    }
    return {};
  }

 private:
  [[nodiscard]] bool is_free(std::uint32_t i) const {
    return (free_ > 0 && which_[0] == i) || (free_ > 1 && which_[1] == i) || (free_ > 2 && which_[2] == i);
  }
  [[nodiscard]] double slope(std::uint32_t i) const {
    double sum = with_middle_[i];
    for (std::uint32_t j = 0; j < size_; ++j) sum += product_[i][j] * part_[j];
    return sum;
  }
  /// Moves to the least of the free ones; what comes to an end on the way stays there.  False where that is not told.
  bool settle() {
    while (free_ > 0) {
      std::array<double, 3> step{};
      if (!solve(step)) return false;
      double share = 1;
      std::uint32_t ends = free_;
      for (std::uint32_t f = 0; f < free_; ++f) {
        const double c = part_[which_[f]], next = c + step[f];
        if (next > -1 && next < 1) continue;
        const double till = ((next > 0 ? 1 : -1) - c) / step[f];
        if (till <= share) share = till, ends = f;
      }
      for (std::uint32_t f = 0; f < free_; ++f) part_[which_[f]] += share * step[f];
      if (ends == free_) return free_ < 3;
      part_[which_[ends]] = step[ends] > 0 ? 1 : -1;
      which_[ends] = which_[--free_];
    }
    return true;
  }
  /// The step from here to where all slopes of the free ones are zero.
  bool solve(std::array<double, 3>& step) const {
    constexpr double least = 0x1p-40;  // a guess: what is flatter is left to others
    const std::uint32_t i = which_[0], j = which_[1], k = which_[2];
    const auto g = [this](std::uint32_t p, std::uint32_t q) { return product_[p][q]; };
    const double r = -slope(i);
    if (free_ == 1) {
      step[0] = r / g(i, i);
      return true;
    }
    const double s = -slope(j), flat = g(i, i) * g(j, j) - g(i, j) * g(i, j);
    if (!(flat > least * (g(i, i) * g(j, j)))) return false;
    if (free_ == 2) {
      step[0] = (r * g(j, j) - s * g(i, j)) / flat, step[1] = (s * g(i, i) - r * g(i, j)) / flat;
      return true;
    }
    const double t = -slope(k);
    const double jk = g(i, j) * g(i, k) - g(i, i) * g(j, k), ik = g(i, j) * g(j, k) - g(j, j) * g(i, k);
    const double all = g(i, k) * ik + g(j, k) * jk + g(k, k) * flat;
    if (!(all > least * (g(k, k) * flat))) return false;
    step[2] = (r * ik + s * jk + t * flat) / all;
    const double p = r - g(i, k) * step[2], q = s - g(j, k) * step[2];
    step[0] = (p * g(j, j) - q * g(i, j)) / flat, step[1] = (q * g(i, i) - p * g(i, j)) / flat;
    return true;
  }
  [[nodiscard]] EdgeFace face() const {
    EdgeFace f;
    for (std::uint32_t i = 0; i < size_; ++i) {
      const std::size_t which = i < of_a_ ? 0 : 1;
      const std::uint32_t bit = 1U << (which == 0 ? i : i - of_a_);
      if (is_free(i)) {
        f.along[which] |= bit;
      } else if (part_[i] > 0) {
        f.upper[which] |= bit;
      }
    }
    return f;
  }

  std::uint32_t of_a_, size_, free_ = 0;
  std::array<std::uint32_t, 3> which_{};
  std::array<Plain, 6> edge_;
  std::array<std::array<double, 6>, 6> product_;
  std::array<double, 6> with_middle_, part_;
};

}  // namespace

std::optional<EdgeFace> guessed_face(const EdgeSum& a, const EdgeSum& b) { return FaceSearch(a, b).run(); }

}  // namespace plumb::query
