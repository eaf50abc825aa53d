// All of them are chains, and a chain is made one link by its numbers; what is of the plane is of space as well.
#include "plumb/figure/basic/rigid_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/pose_numbers.hpp"

namespace plumb {
namespace {

using arith::Vec;
using figure::PoseNumbers, figure::Quaternion;

RigidPose raised(const RigidPose2& p) { return {{p.turn.w, 0, 0, p.turn.z}, {p.translation.x, p.translation.y, 0}}; }
RigidChain raised(const RigidChain2& chain) {
  RigidChain made;
  for (const RigidPose2& link : chain.links) made.links.push_back(raised(link));
  return made;
}
RigidPose2 lowered(const RigidPose& p) { return {{p.turn.w, p.turn.z}, {p.translation.x, p.translation.y}}; }
std::optional<RigidPose2> lowered(const std::optional<RigidPose>& p) {
  return p ? std::optional(lowered(*p)) : std::nullopt;
}

RigidPose negated(const RigidPose& p) { return {{}, {-p.translation.x, -p.translation.y, -p.translation.z}}; }
RigidPose2 negated(const RigidPose2& p) { return {{}, {-p.translation.x, -p.translation.y}}; }

template <class Chain>
Chain inverse_of(const Chain& chain) {
  figure::require_sound("inverse", chain);
  Chain made;
  for (std::size_t i = chain.links.size(); i-- > 0;) {
    made.links.push_back({inverse(chain.links[i].turn), {}});
    made.links.push_back(negated(chain.links[i]));
  }
  return made;
}

template <class Chain>
Chain relative_of(const Chain& in, const Chain& of) {
  figure::require_sound("relative", "in", in);
  figure::require_sound("relative", "of", of);
  Chain made = inverse_of(in);
  made.links.insert(made.links.end(), of.links.begin(), of.links.end());
  return made;
}

template <class T>
std::array<T, 4> product_of(const RigidChain& chain) {
  Quaternion<T> made{T(1.0), {T(0.0), T(0.0), T(0.0)}};
  for (const RigidPose& link : chain.links) made = product(made, figure::quaternion<T>(link.turn));
  return {made.w, made.v.x, made.v.y, made.v.z};
}

/// Numbers, each rounded to nearest, and whether none had to be; nothing is said of that where it is not asked.
template <std::size_t N>
struct Made {
  std::array<double, N> numbers;
  bool exact;
};

/// Nothing where pairs of doubles leave a choice.
std::optional<Made<4>> quick_turn(const RigidChain& chain, bool asks_exact) {
  Made<4> made{{}, true};
  const auto q = product_of<Ball>(chain);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto nearest = q[i].nearest();
    if (!nearest || (asks_exact && q[i].radius != 0)) return {};
    made.numbers[i] = *nearest;
    made.exact = made.exact && q[i].radius == 0 && q[i].low == 0;
  }
  return made;
}

/// Rounds the multiple by the least power of two of which no part loses digits below the doubles, unless the largest
/// would be beyond them.
Made<4> turn_by_integers(const RigidChain& chain) {
  auto q = product_of<BigDyadic>(chain);
  long most = std::numeric_limits<long>::min(), least = std::numeric_limits<long>::max();  // exponents of bits
  for (const BigDyadic& x : q) {
    if (x.sign() == Sign::zero) continue;
    most = std::max(most, x.exponent() + static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2)));
    least = std::min(least, x.exponent());
  }
  constexpr long step = 1000;
  long by = std::min(std::max(0L, std::numeric_limits<double>::min_exponent - 53 - least),
                     std::numeric_limits<double>::max_exponent - most);
  for (; by != 0; by -= std::clamp(by, -step, step)) {
    const BigDyadic power(std::ldexp(1.0, static_cast<int>(std::clamp(by, -step, step))));
    for (BigDyadic& x : q) x = x * power;
  }
  for (;;) {
    Made<4> made{{}, true};
    for (std::size_t i = 0; i < 4; ++i) made.numbers[i] = rounded(Rounding::nearest, q[i]);
    if (std::ranges::any_of(made.numbers, [](double x) { return x - x != 0; })) {  // rounded up, at most once
      for (BigDyadic& x : q) x = x * BigDyadic(0.5);
      continue;
    }
    for (std::size_t i = 0; i < 4; ++i)
      made.exact = made.exact && (q[i] - BigDyadic(made.numbers[i])).sign() == Sign::zero;
    return made;
  }
}

/// The quotient of a number and the weight: the translation's, the columns'.
template <std::size_t N, class F>
Made<N> numbers_of(const figure::CertainPose& pose, F numerator_of, bool asks_exact, std::string_view function) {
  Made<N> made{{}, true};
  for (std::size_t i = 0; i < N; ++i) {
    const auto numerator = [&]<class T>(const PoseNumbers<T>& n) { return T(numerator_of(n, i)); };
    const double x = made.numbers[i] = pose.rounded(Rounding::nearest, numerator);
    if (!asks_exact) {
      figure::within_doubles(x, function, "a number of it");
    } else if (x - x != 0) {
      made.exact = false;
    } else {
      const auto less = [&]<class T>(const PoseNumbers<T>& n) { return numerator(n) - n.weight * T(x); };
      made.exact = made.exact && pose.sign(less) == Sign::zero;
    }
  }
  return made;
}

template <class T>
const T& coordinate_at(const Vec<T>& v, std::size_t i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

struct MadePose {
  RigidPose pose;
  bool exact;
};
MadePose link_of(const RigidChain& chain, bool asks_exact, std::string_view function) {
  auto turn = quick_turn(chain, asks_exact);
  if (!turn) turn = turn_by_integers(chain);
  const figure::CertainPose pose{PoseView(chain)};
  const auto translation = numbers_of<3>(
      pose, [](const auto& n, std::size_t i) { return coordinate_at(n.translation, i); }, asks_exact, function);
  const auto& [w, x, y, z] = turn->numbers;
  const auto& t = translation.numbers;
  return {{{w, x, y, z}, {t[0], t[1], t[2]}}, turn->exact && translation.exact};
}
RigidPose rounded_of(const RigidChain& chain, std::string_view function) {
  return link_of(chain, false, function).pose;
}
std::optional<RigidPose> exact_of(const RigidChain& chain, std::string_view function) {
  const auto [pose, exact] = link_of(chain, true, function);
  return exact ? std::optional(pose) : std::nullopt;
}

template <class By>
void require_both(std::string_view function, const By& outer, const By& inner) {
  figure::require_sound(function, "outer", outer);
  figure::require_sound(function, "inner", inner);
}

struct MadeMatrix {
  Pose pose;
  bool exact;
};
template <class View>
MadeMatrix matrix_of(View view, bool asks_exact, std::string_view function) {
  figure::require_sound(function, view);
  const auto [m, exact] = numbers_of<12>(
      figure::CertainPose(view),
      [](const auto& n, std::size_t i) { return coordinate_at(i < 9 ? n.columns[i / 3] : n.translation, i % 3); },
      asks_exact, function);
  return {{{{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}}}, {m[9], m[10], m[11]}}, exact};
}
Pose2 in_plane(const Pose& p) {
  return {{{{p.columns[0].x, p.columns[0].y}, {p.columns[1].x, p.columns[1].y}}}, {p.translation.x, p.translation.y}};
}

}  // namespace

RigidChain inverse(const RigidPose& pose) {
  figure::require_sound("inverse", pose);
  return inverse_of(RigidChain{{pose}});
}
RigidChain2 inverse(const RigidPose2& pose) {
  figure::require_sound("inverse", pose);
  return inverse_of(RigidChain2{{pose}});
}
RigidChain inverse(const RigidChain& pose) { return inverse_of(pose); }
RigidChain2 inverse(const RigidChain2& pose) { return inverse_of(pose); }

RigidChain relative(const RigidPose& in, const RigidPose& of) {
  figure::require_sound("relative", "in", in);
  figure::require_sound("relative", "of", of);
  return relative_of(RigidChain{{in}}, RigidChain{{of}});
}
RigidChain2 relative(const RigidPose2& in, const RigidPose2& of) {
  figure::require_sound("relative", "in", in);
  figure::require_sound("relative", "of", of);
  return relative_of(RigidChain2{{in}}, RigidChain2{{of}});
}
RigidChain relative(const RigidChain& in, const RigidChain& of) { return relative_of(in, of); }
RigidChain2 relative(const RigidChain2& in, const RigidChain2& of) { return relative_of(in, of); }

RigidPose rounded_link(const RigidChain& chain) {
  figure::require_sound("rounded_link", "chain", chain);
  return rounded_of(chain, "rounded_link");
}
RigidPose2 rounded_link(const RigidChain2& chain) {
  figure::require_sound("rounded_link", "chain", chain);
  return lowered(rounded_of(raised(chain), "rounded_link"));
}
std::optional<RigidPose> exact_link(const RigidChain& chain) {
  figure::require_sound("exact_link", "chain", chain);
  return exact_of(chain, "exact_link");
}
std::optional<RigidPose2> exact_link(const RigidChain2& chain) {
  figure::require_sound("exact_link", "chain", chain);
  return lowered(exact_of(raised(chain), "exact_link"));
}

RigidPose rounded_composition(const RigidPose& outer, const RigidPose& inner) {
  require_both("rounded_composition", outer, inner);
  return rounded_of({{outer, inner}}, "rounded_composition");
}
RigidPose2 rounded_composition(const RigidPose2& outer, const RigidPose2& inner) {
  require_both("rounded_composition", outer, inner);
  return lowered(rounded_of({{raised(outer), raised(inner)}}, "rounded_composition"));
}
std::optional<RigidPose> exact_composition(const RigidPose& outer, const RigidPose& inner) {
  require_both("exact_composition", outer, inner);
  return exact_of({{outer, inner}}, "exact_composition");
}
std::optional<RigidPose2> exact_composition(const RigidPose2& outer, const RigidPose2& inner) {
  require_both("exact_composition", outer, inner);
  return lowered(exact_of({{raised(outer), raised(inner)}}, "exact_composition"));
}
Rotation rounded_composition(const Rotation& outer, const Rotation& inner) {
  require_both("rounded_composition", outer, inner);
  return rounded_of({{{outer, {}}, {inner, {}}}}, "rounded_composition").turn;
}
Rotation2 rounded_composition(const Rotation2& outer, const Rotation2& inner) {
  require_both("rounded_composition", outer, inner);
  return rounded_composition(RigidPose2{outer, {}}, RigidPose2{inner, {}}).turn;
}
std::optional<Rotation> exact_composition(const Rotation& outer, const Rotation& inner) {
  require_both("exact_composition", outer, inner);
  const auto made = exact_of({{{outer, {}}, {inner, {}}}}, "exact_composition");
  return made ? std::optional(made->turn) : std::nullopt;
}
std::optional<Rotation2> exact_composition(const Rotation2& outer, const Rotation2& inner) {
  require_both("exact_composition", outer, inner);
  const auto made = exact_composition(RigidPose2{outer, {}}, RigidPose2{inner, {}});
  return made ? std::optional(made->turn) : std::nullopt;
}

RigidPose rounded_inverse(const RigidPose& pose) {
  figure::require_sound("rounded_inverse", pose);
  return rounded_of(inverse(pose), "rounded_inverse");
}
RigidPose2 rounded_inverse(const RigidPose2& pose) {
  figure::require_sound("rounded_inverse", pose);
  return lowered(rounded_of(raised(inverse(pose)), "rounded_inverse"));
}
std::optional<RigidPose> exact_inverse(const RigidPose& pose) {
  figure::require_sound("exact_inverse", pose);
  return exact_of(inverse(pose), "exact_inverse");
}
std::optional<RigidPose2> exact_inverse(const RigidPose2& pose) {
  figure::require_sound("exact_inverse", pose);
  return lowered(exact_of(raised(inverse(pose)), "exact_inverse"));
}

RigidPose rounded_relative(const RigidPose& in, const RigidPose& of) {
  figure::require_sound("rounded_relative", "in", in);
  figure::require_sound("rounded_relative", "of", of);
  return rounded_of(relative(in, of), "rounded_relative");
}
RigidPose2 rounded_relative(const RigidPose2& in, const RigidPose2& of) {
  figure::require_sound("rounded_relative", "in", in);
  figure::require_sound("rounded_relative", "of", of);
  return lowered(rounded_of(raised(relative(in, of)), "rounded_relative"));
}

bool same_turn(const Rotation& p, const Rotation& q) {
  figure::require_sound("same_turn", "p", p);
  figure::require_sound("same_turn", "q", q);
  const std::array a{p.w, p.x, p.y, p.z}, b{q.w, q.x, q.y, q.z};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto minor_of = [](auto ai, auto aj, auto bi, auto bj) { return ai * bj - aj * bi; };
      if (sign_of(minor_of, a[i], a[j], b[i], b[j]) != Sign::zero) return false;
    }
  }
  return true;
}
bool same_turn(const Rotation2& p, const Rotation2& q) {
  return same_turn(Rotation{p.w, 0, 0, p.z}, Rotation{q.w, 0, 0, q.z});
}

Pose rounded_pose(PoseView pose) { return matrix_of(pose, false, "rounded_pose").pose; }
Pose2 rounded_pose(PoseView2 pose) { return in_plane(matrix_of(pose, false, "rounded_pose").pose); }
std::optional<Pose> exact_pose(PoseView pose) {
  const auto [made, exact] = matrix_of(pose, true, "exact_pose");
  return exact ? std::optional(made) : std::nullopt;
}
std::optional<Pose2> exact_pose(PoseView2 pose) {
  const auto [made, exact] = matrix_of(pose, true, "exact_pose");
  return exact ? std::optional(in_plane(made)) : std::nullopt;
}

}  // namespace plumb
