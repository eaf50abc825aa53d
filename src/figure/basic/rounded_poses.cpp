// Both dimensions by the same lines: a pose is read as columns, and each number that is made is one formula of theirs.
#include "plumb/figure/basic/rounded_poses.hpp"

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "plumb/certify/determinant_sign.hpp"

namespace plumb {
namespace {

template <std::size_t N>
using Numbers = std::array<double, N>;

/// The columns of the matrix and, last, the translation.
template <std::size_t N>
using PoseColumns = std::array<Numbers<N>, N + 1>;

PoseColumns<2> columns_of(const Pose2& p) {
  return {coordinates(p.columns[0]), coordinates(p.columns[1]), coordinates(p.translation)};
}
PoseColumns<3> columns_of(const Pose& p) {
  return {coordinates(p.columns[0]), coordinates(p.columns[1]), coordinates(p.columns[2]), coordinates(p.translation)};
}

template <class To>
To made_of(const Numbers<2>& x) {
  return {x[0], x[1]};
}
template <class To>
To made_of(const Numbers<3>& x) {
  return {x[0], x[1], x[2]};
}
Pose2 pose_of(const PoseColumns<2>& c) {
  return {{made_of<Vector2>(c[0]), made_of<Vector2>(c[1])}, made_of<Vector2>(c[2])};
}
Pose pose_of(const PoseColumns<3>& c) {
  return {{made_of<Vector3>(c[0]), made_of<Vector3>(c[1]), made_of<Vector3>(c[2])}, made_of<Vector3>(c[3])};
}

template <std::size_t N>
void require_finite_pose(std::string_view function, std::string_view name, const PoseColumns<N>& pose) {
  for (std::size_t j = 0; j <= N; ++j) {
    const std::string part =
        j == N ? std::string(name) + ".translation" : std::string(name) + ".columns[" + std::to_string(j) + "]";
    require_finite_parts(function, {std::string_view(part)}, pose[j]);
  }
}

/// A row of the matrix times x, and a number added or not; less what is claimed of it, or not.
template <std::size_t N, bool Moved, bool Claimed>
struct ImageNumber {
  static constexpr std::string_view name = "image";
  static constexpr std::array arguments = [] {
    constexpr int n = static_cast<int>(N);
    if constexpr (Moved && Claimed) {
      return std::array{n, n, 1, 1};
    } else if constexpr (Moved || Claimed) {
      return std::array{n, n, 1};
    } else {
      return std::array{n, n};
    }
  }();
  static constexpr bool homogeneous = !Moved && !Claimed;

  template <class T>
  constexpr auto operator()(const std::array<T, 2 * N + Moved + Claimed>& p) const {
    const auto product = [&] {
      if constexpr (N == 2) {
        return p[0] * p[2] + p[1] * p[3];
      } else {
        return p[0] * p[3] + p[1] * p[4] + p[2] * p[5];
      }
    }();
    if constexpr (Moved && Claimed) {
      return product + (p[2 * N] - p[2 * N + 1]);
    } else if constexpr (Moved) {
      return product + p[2 * N];
    } else if constexpr (Claimed) {
      return product - p[2 * N];
    } else {
      return product;
    }
  }
};

/// The image of x; `exact` becomes false where a number of it had to be rounded.
template <bool Moved, std::size_t N>
Numbers<N> image(std::string_view function, const PoseColumns<N>& m, const Numbers<N>& x, bool* exact = nullptr) {
  Numbers<N> y{};
  for (std::size_t i = 0; i < N; ++i) {
    Numbers<N> row{};
    for (std::size_t j = 0; j < N; ++j) row[j] = m[j][i];
    if constexpr (Moved) {
      y[i] = rounded_value(Rounding::nearest, ImageNumber<N, true, false>{}, row, x, m[N][i]);
    } else {
      y[i] = rounded_value(Rounding::nearest, ImageNumber<N, false, false>{}, row, x);
    }
    if (exact == nullptr) {
      figure::within_doubles(y[i], function, "a number of the image");
    } else if (!*exact || y[i] - y[i] != 0) {
      *exact = false;
    } else if constexpr (Moved) {
      *exact = sign_of(ImageNumber<N, true, true>{}, row, x, m[N][i], y[i]) == Sign::zero;
    } else {
      *exact = sign_of(ImageNumber<N, false, true>{}, row, x, y[i]) == Sign::zero;
    }
  }
  return y;
}

/// A number of the image, times the weight.
template <bool Moved, class T, class Part>
T image_number(const figure::PoseNumbers<T>& pose, const Part& part, std::size_t i) {
  const arith::Vec<T> x = arith::vec<T>(part);
  return Moved ? pose.image(x, i) : pose.turned(x, i);
}

template <bool Moved, class View, class Part>
Part rounded_part(View view, const Part& x) {
  figure::require_sound("rounded_image", view);
  require_finite_parts("rounded_image", {Moved ? "p" : "v"}, x);
  const figure::CertainPose pose(view);
  auto y = coordinates(x);
  for (std::size_t i = 0; i < y.size(); ++i) {
    y[i] = pose.rounded(Rounding::nearest, [&](const auto& numbers) { return image_number<Moved>(numbers, x, i); });
    figure::within_doubles(y[i], "rounded_image", "a number of the image");
  }
  return made_of<Part>(y);
}

template <class Point, class View>
std::optional<Point> exact_part(View view, const Point& p) {
  figure::require_sound("exact_image", view);
  require_finite_parts("exact_image", {"p"}, p);
  const figure::CertainPose pose(view);
  auto y = coordinates(p);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double made = y[i] =
        pose.rounded(Rounding::nearest, [&](const auto& numbers) { return image_number<true>(numbers, p, i); });
    if (made - made != 0) return {};
    const auto less = [&]<class T>(const figure::PoseNumbers<T>& numbers) {
      return T(image_number<true>(numbers, p, i) - numbers.weight * T(made));
    };
    if (pose.sign(less) != Sign::zero) return {};
  }
  return made_of<Point>(y);
}

template <std::size_t N>
PoseColumns<N> composition(std::string_view function, const PoseColumns<N>& outer, const PoseColumns<N>& inner,
                           bool* exact = nullptr) {
  require_finite_pose(function, "outer", outer);
  require_finite_pose(function, "inner", inner);
  PoseColumns<N> c{};
  for (std::size_t j = 0; j < N; ++j) c[j] = image<false>(function, outer, inner[j], exact);
  c[N] = image<true>(function, outer, inner[N], exact);
  return c;
}

template <class AnyPose>
std::optional<AnyPose> composition_in_doubles(const AnyPose& outer, const AnyPose& inner) {
  bool exact = true;
  const auto c = composition("exact_composition", columns_of(outer), columns_of(inner), &exact);
  return exact ? std::optional(pose_of(c)) : std::nullopt;
}

/// Cramer's rule for columns and a right side that is a difference: the determinant of the columns, the first of them
/// replaced by the difference or not.
template <std::size_t N, bool Replaced>
struct UnknownPart {
  static constexpr std::string_view name = "relative pose";
  static constexpr int points = static_cast<int>(N) + 2, dimension = static_cast<int>(N);

  template <class T>
  constexpr auto operator()(const std::array<T, N*(N + 2)>& p) const {
    // A determinant is that of its transpose, so columns stand for rows.
    if constexpr (N == 2) {
      if constexpr (Replaced) {
        return (p[4] - p[6]) * p[3] - (p[5] - p[7]) * p[2];
      } else {
        return p[0] * p[3] - p[1] * p[2];
      }
    } else {
      const auto by = [&](const auto& x, const auto& y, const auto& z) {
        return x * (p[4] * p[8] - p[5] * p[7]) + y * (p[5] * p[6] - p[3] * p[8]) + z * (p[3] * p[7] - p[4] * p[6]);
      };
      if constexpr (Replaced) {
        return by(p[9] - p[12], p[10] - p[13], p[11] - p[14]);
      } else {
        return by(p[0], p[1], p[2]);
      }
    }
  }
};

template <std::size_t N>
Sign determinant_of(const PoseColumns<N>& m) {
  Rows<N> rows{};  // the transpose has the same
  for (std::size_t j = 0; j < N; ++j) rows[j] = m[j];
  return determinant_sign(rows);
}

/// The pose x with in * x = of.
template <std::size_t N>
std::optional<PoseColumns<N>> undone(std::string_view function, const PoseColumns<N>& in, const PoseColumns<N>& of) {
  if (determinant_of(in) == Sign::zero) return {};
  PoseColumns<N> x{};
  for (std::size_t j = 0; j <= N; ++j) {
    const Numbers<N> less = j == N ? in[N] : Numbers<N>{};
    for (std::size_t i = 0; i < N; ++i) {
      // The unknown that is asked for is swapped into the first column.
      const auto swapped = [&](std::size_t k) { return in[k == 0 ? i : k == i ? 0 : k]; };
      x[j][i] = [&]<std::size_t... K>(std::index_sequence<K...>) {
        return rounded_quotient(Rounding::nearest, UnknownPart<N, true>{}, UnknownPart<N, false>{}, swapped(K)...,
                                of[j], less);
      }
      (std::make_index_sequence<N>{});
      figure::within_doubles(x[j][i], function, "a number of it");
    }
  }
  return x;
}

template <class AnyPose>
std::optional<AnyPose> pose_if(const auto& columns) {
  return columns ? std::optional<AnyPose>(pose_of(*columns)) : std::nullopt;
}

template <class AnyPose, std::size_t N>
std::optional<AnyPose> inverse_of(const PoseColumns<N>& m) {
  require_finite_pose("rounded_inverse", "pose", m);
  PoseColumns<N> stays{};
  for (std::size_t j = 0; j < N; ++j) stays[j][j] = 1;
  return pose_if<AnyPose>(undone("rounded_inverse", m, stays));
}

template <class AnyPose, std::size_t N>
std::optional<AnyPose> relative(const PoseColumns<N>& in, const PoseColumns<N>& of) {
  require_finite_pose("rounded_relative", "in", in);
  require_finite_pose("rounded_relative", "of", of);
  return pose_if<AnyPose>(undone("rounded_relative", in, of));
}

/// Is the product of two columns this number?
template <std::size_t N>
bool is_product(const Numbers<N>& u, const Numbers<N>& v, double value) {
  return sign_of(ImageNumber<N, false, true>{}, u, v, value) == Sign::zero;
}

template <std::size_t N>
bool orthogonal(const PoseColumns<N>& m) {
  require_finite_pose("keeps_lengths", "pose", m);
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = i; j < N; ++j) {
      if (!is_product(m[i], m[j], i == j ? 1 : 0)) return false;
    }
  }
  return true;
}

template <std::size_t N>
Sign turn_of(const PoseColumns<N>& m) {
  require_finite_pose("handedness", "pose", m);
  return determinant_of(m);
}

}  // namespace

Point2 rounded_image(PoseView2 pose, const Point2& p) { return rounded_part<true>(pose, p); }
Point3 rounded_image(PoseView pose, const Point3& p) { return rounded_part<true>(pose, p); }
Vector2 rounded_image(PoseView2 pose, const Vector2& v) { return rounded_part<false>(pose, v); }
Vector3 rounded_image(PoseView pose, const Vector3& v) { return rounded_part<false>(pose, v); }

std::optional<Point2> exact_image(PoseView2 pose, const Point2& p) { return exact_part(pose, p); }
std::optional<Point3> exact_image(PoseView pose, const Point3& p) { return exact_part(pose, p); }

Pose2 rounded_composition(const Pose2& outer, const Pose2& inner) {
  return pose_of(composition("rounded_composition", columns_of(outer), columns_of(inner)));
}
Pose rounded_composition(const Pose& outer, const Pose& inner) {
  return pose_of(composition("rounded_composition", columns_of(outer), columns_of(inner)));
}
std::optional<Pose2> exact_composition(const Pose2& outer, const Pose2& inner) {
  return composition_in_doubles(outer, inner);
}
std::optional<Pose> exact_composition(const Pose& outer, const Pose& inner) {
  return composition_in_doubles(outer, inner);
}

std::optional<Pose2> rounded_inverse(const Pose2& pose) { return inverse_of<Pose2>(columns_of(pose)); }
std::optional<Pose> rounded_inverse(const Pose& pose) { return inverse_of<Pose>(columns_of(pose)); }

std::optional<Pose2> rounded_relative(const Pose2& in, const Pose2& of) {
  return relative<Pose2>(columns_of(in), columns_of(of));
}
std::optional<Pose> rounded_relative(const Pose& in, const Pose& of) {
  return relative<Pose>(columns_of(in), columns_of(of));
}

Sign handedness(const Pose2& pose) { return turn_of(columns_of(pose)); }
Sign handedness(const Pose& pose) { return turn_of(columns_of(pose)); }

bool keeps_lengths(const Pose2& pose) { return orthogonal(columns_of(pose)); }
bool keeps_lengths(const Pose& pose) { return orthogonal(columns_of(pose)); }

}  // namespace plumb
