#include "plumb/degenerate/shape_pair.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>

#include "degenerate/body_frame.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate/moves.hpp"

namespace plumb::degenerate {

namespace {

constexpr IntMap mirror{{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, 1};
constexpr int form_bits = 8;

struct Features {
  int a, b;
};

/// Of the positions in which shapes touch.
std::optional<Features> features_of(Position position) {
  switch (position) {
    case Position::vertex_on_vertex:
      return Features{0, 0};
    case Position::vertex_on_edge:
      return Features{0, 1};
    case Position::vertex_on_face:
      return Features{0, 2};
    case Position::edge_across_edge:
    case Position::edge_along_edge:
    case Position::shared_edge:
      return Features{1, 1};
    case Position::edge_on_face:
      return Features{1, 2};
    case Position::face_on_face:
    case Position::shared_face:
      return Features{2, 2};
    default:
      return std::nullopt;
  }
}

bool is_shared(Position position) { return position == Position::shared_edge || position == Position::shared_face; }

bool has_feature(ShapeKind kind, int dimension, int feature) {
  return ((features_of(kind, dimension) >> feature) & 1) != 0;
}

/// Which features they can have in common position, either way round.
std::vector<Features> ways(ShapeKind a, ShapeKind b, int dimension, Features wanted) {
  std::vector<Features> found;
  const auto add = [&](int of_a, int of_b) {
    if (has_feature(a, dimension, of_a) && has_feature(b, dimension, of_b)) found.push_back({of_a, of_b});
  };
  add(wanted.a, wanted.b);
  if (wanted.a != wanted.b) add(wanted.b, wanted.a);
  return found;
}

/// The highest feature that both have; below 1 where it is a vertex or none.
int common_feature(ShapeKind a, ShapeKind b, int dimension) {
  return static_cast<int>(std::bit_width(features_of(a, dimension) & features_of(b, dimension))) - 1;
}

bool is_unbounded(ShapeKind kind) {
  return kind == ShapeKind::line || kind == ShapeKind::ray || kind == ShapeKind::plane ||
         kind == ShapeKind::halfspace || kind == ShapeKind::three_point_plane || kind == ShapeKind::slab;
}

bool can_contain(ShapeKind kind, int dimension) {
  if (kind == ShapeKind::triangle || is_chain(kind)) return dimension == 2;
  return kind == ShapeKind::halfspace || kind == ShapeKind::slab || kind == ShapeKind::halfspaces ||
         kind == ShapeKind::tetrahedron || kind == ShapeKind::points || kind == ShapeKind::mesh || is_aligned(kind) ||
         kind == ShapeKind::obb || kind == ShapeKind::ellipsoid || is_round(kind);
}

bool can_stand_upright(ShapeKind kind, int dimension) {
  const bool thin = kind == ShapeKind::segment || kind == ShapeKind::ray;
  return thin || (dimension == 3 && (kind == ShapeKind::triangle || is_chain(kind) || kind == ShapeKind::rectangle));
}

bool stands_on(ShapeKind ground, ShapeKind upright, int dimension) {
  return has_feature(ground, dimension, dimension - 1) && can_stand_upright(upright, dimension);
}

bool can_be_reversed(ShapeKind kind) {
  return kind != ShapeKind::point && kind != ShapeKind::ray && kind != ShapeKind::halfspace && !is_aligned(kind) &&
         kind != ShapeKind::ball && kind != ShapeKind::cone;
}

/// The same set of points.
Body reversed(Body body) {
  auto& p = body.points;
  switch (body.kind) {
    case ShapeKind::rectangle:
    case ShapeKind::obb:
    case ShapeKind::ellipsoid:
      for (std::size_t i = 1; i < p.size(); ++i) p[i] = 2 * p[0] - p[i];
      break;
    case ShapeKind::lozenge:
      p = {p[1] + p[2] - p[0], p[2], p[1]};
      break;
    case ShapeKind::plane:
      std::swap(p[1], p[2]);
      break;
    case ShapeKind::slab:
      p = {p[3], p[3] + p[1] - p[0], p[3] + p[2] - p[0], p[0]};
      break;
    case ShapeKind::halfspaces:  // the last one first
      std::reverse(p.begin(), p.end());
      for (std::size_t i = 0; i < p.size(); i += 4) std::reverse(&p[i], &p[i] + 4);
      break;
    case ShapeKind::holed_polygon: {
      auto chain = p.begin();
      for (const std::size_t size : body.parts) {
        const auto end = chain + static_cast<std::ptrdiff_t>(size);
        std::reverse(chain, end);
        chain = end;
      }
      break;
    }
    case ShapeKind::mesh:
      std::reverse(p.begin(), p.end());
      for (std::size_t& corner : body.parts) corner = p.size() - 1 - corner;
      break;
    default:
      std::reverse(p.begin(), p.end());
  }
  return body;
}

/// How far from the origin the body reaches along any axis, at most.
Int reach(const Body& body) {
  Int most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Int along = 0;
    for (std::size_t i = 0; i < body.points.size(); ++i) {
      const Int x = std::abs(body.points[i][axis]);
      if (body.kind == ShapeKind::halfspaces) {  // a box about the origin, by a point of each face
        along += i % 4 == 0 ? x : 0;
      } else if (!has_axes(body.kind)) {
        along = std::max(along, x);
      } else {
        along += i == 0 ? x : std::abs(body.arm(i - 1)[axis]);
      }
    }
    if (body.kind == ShapeKind::lozenge) {
      along = std::max(along, std::abs(body.points[1][axis] + body.points[2][axis] - body.points[0][axis]));
    }
    most = std::max(most, along);
  }
  return most + body.radius;
}

/// Makes one pair.
class Pairing {
 public:
  Pairing(ShapeKind a, ShapeKind b, int dimension, Entropy& entropy)
      : a_(a), b_(b), dimension_(dimension), space_(dimension), entropy_(entropy) {}

  ShapePair made(Position position, Nearness nearness) && {
    if (const std::optional<Features> wanted = features_of(position)) {
      touch(position, *wanted);
    } else {
      switch (position) {
        case Position::parallel:
          parallel();
          break;
        case Position::coplanar:
          coplanar();
          break;
        case Position::perpendicular:
          perpendicular();
          break;
        case Position::contained:
          contained();
          break;
        case Position::equal:
        case Position::reversed:
          concentric();
          second_ = position == Position::equal ? first_ : reversed(first_);
          break;
        default:
          concentric();
      }
    }
    return placed(nearness);
  }

 private:
  bool is_either(ShapeKind kind) const { return a_ == kind || b_ == kind; }

  void choose_frame(int aligned_feature, bool rigid = false) {
    frame_ = frame_of({.dimension = dimension_,
                       .rigid = rigid || is_rigid(a_) || is_rigid(b_),
                       .aabb = is_either(ShapeKind::aabb),
                       .k_dop = is_either(ShapeKind::k_dop),
                       .slabs = is_either(ShapeKind::points),
                       .aligned_feature = aligned_feature},
                      entropy_);
    normal_ = normal_of(frame_, dimension_);
  }
  BodyOrder order(ShapeKind kind, int feature, bool below) {
    BodyOrder made{.kind = kind, .dimension = space_, .feature = feature, .extent = extent()};
    made.axes = axes_of_space(frame_, below);
    return made;
  }
  Int3 extent() {
    const int bits = static_cast<int>(entropy_.below(form_bits));
    return extent_of(any_form(entropy_), bits, entropy_);
  }
  /// Turned about the contact, and of another size.
  void vary(Body& body, bool turn) {
    if (turn && space_ == 3 && !is_aligned(body.kind)) body.map(turned_about_z(entropy_));
    if (has_feature(body.kind, 3, 0) && entropy_.below(4) == 3) body.multiply(Int{1} << entropy_.below(12));
  }

  void touch(Position position, Features wanted) {
    const std::vector<Features> possible = ways(a_, b_, dimension_, wanted);
    const Features chosen = possible[entropy_.below(possible.size())];
    const bool shared = is_shared(position), across = position == Position::edge_across_edge;
    const bool flat = dimension_ == 3 && !shared && !across && chosen.a < 2 && chosen.b < 2 && lies_in_plane(a_) &&
                      lies_in_plane(b_) && entropy_.below(4) == 3;
    const bool both_aligned = is_aligned(a_) && is_aligned(b_);
    int aligned_feature = std::max(is_aligned(a_) ? chosen.a : 0, is_aligned(b_) ? chosen.b : 0);
    if (shared || (across && both_aligned)) aligned_feature = dimension_ - 1;
    choose_frame(aligned_feature);
    if (flat) {  // both in one plane: as in the plane, carried into space
      space_ = 2;
      frame_ = after(frame_, {{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, frame_.stretch == 0 ? 0 : 1});
      normal_ = normal_of(frame_, 3);
    }
    BodyOrder of_a = order(a_, chosen.a, true), of_b = order(b_, chosen.b, false);
    if (shared) of_a.shared = of_b.shared = 1 + static_cast<Int>(entropy_.below(100));
    of_b.across = across && both_aligned;
    first_ = body_of(of_a, entropy_);
    second_ = body_of(of_b, entropy_);
    if (!shared) {
      const bool free = position != Position::edge_along_edge && !across;
      vary(first_, free);
      vary(second_, free);
    }
    if (across && !of_b.across) {
      Body& turned = is_aligned(b_) ? first_ : second_;
      constexpr IntMap quarter{{{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}, 1},
          slanted{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}, 5};
      turned.map(entropy_.coin() ? slanted : quarter);
    }
    first_.map(mirror);
  }
  static bool lies_in_plane(ShapeKind kind) {
    return kind == ShapeKind::point || kind == ShapeKind::line || kind == ShapeKind::ray ||
           kind == ShapeKind::segment || kind == ShapeKind::triangle || is_chain(kind);
  }

  void parallel() {
    const int feature = common_feature(a_, b_, dimension_);
    choose_frame(feature);
    first_ = body_of(order(a_, feature, true), entropy_);
    second_ = body_of(order(b_, feature, false), entropy_);
    vary(first_, feature == 2);
    vary(second_, feature == 2);
    first_.map(mirror);
    second_.move({0, 0, 1 + static_cast<Int>(entropy_.below(std::uint64_t{1} << entropy_.below(10)))});
  }

  void coplanar() {
    choose_frame(dimension_ - 1);
    first_ = body_of(order(a_, dimension_ - 1, false), entropy_);
    second_ = body_of(order(b_, dimension_ - 1, false), entropy_);
    vary(first_, true);
    vary(second_, true);
    const Int away = Int{1} << entropy_.below(14);
    second_.move({entropy_.within(away), dimension_ == 2 ? 0 : entropy_.within(away), 0});
  }

  void perpendicular() {
    const bool second = stands_on(a_, b_, dimension_) && (!stands_on(b_, a_, dimension_) || !entropy_.coin());
    choose_frame(dimension_ - 1);
    const ShapeKind upright = second ? b_ : a_, lying = second ? a_ : b_;
    BodyOrder standing = order(upright, upright == ShapeKind::segment || upright == ShapeKind::ray ? 0 : 1, !second);
    standing.upright = true;
    first_ = body_of(second ? order(lying, dimension_ - 1, true) : standing, entropy_);
    second_ = body_of(second ? standing : order(lying, dimension_ - 1, false), entropy_);
    vary(first_, true);
    vary(second_, true);
    first_.map(mirror);
  }

  Body about_origin(ShapeKind kind, bool bounded = false) {
    const unsigned features = features_of(kind, dimension_);
    int feature = is_chain(kind) ? 2 : static_cast<int>(entropy_.below(3));
    while (!is_chain(kind) && ((features >> feature) & 1) == 0) feature = (feature + 1) % 3;
    BodyOrder wanted = order(kind, feature, false);
    wanted.around = true;
    wanted.bounded = bounded;
    Body body = body_of(wanted, entropy_);
    const bool by_planes = kind == ShapeKind::halfspaces || kind == ShapeKind::k_dop;
    if (!is_chain(kind) && !by_planes) put_middle_at_origin(body);
    if (dimension_ == 3 && !is_aligned(kind)) body.map(any_turn(entropy_));
    return body;
  }

  void concentric() {
    choose_frame(entropy_.coin() ? 0 : dimension_ - 1);
    first_ = about_origin(a_);
    second_ = about_origin(b_);
    normal_ = {};
  }

  void contained() {
    const bool aligned = entropy_.coin() || is_either(ShapeKind::k_dop);
    choose_frame(aligned ? dimension_ - 1 : 0, aligned && is_either(ShapeKind::k_dop));
    second_ = about_origin(b_, true);
    const Int size = std::max<Int>(reach(second_), 1);
    const Int margin = entropy_.coin() ? 0 : 1 + static_cast<Int>(entropy_.below(static_cast<std::uint64_t>(size)));
    first_ = body_around(order(a_, 0, false), size + margin, !aligned);
    normal_ = {};
  }

  ShapePair placed(Nearness nearness) {
    first_.map(frame_);
    second_.map(frame_);
    const bool nearly = nearness == Nearness::nearly;
    Placement placement = any_placement(std::max(bits_of(first_), bits_of(second_)), nearly, entropy_);
    std::optional<std::vector<double>> a = written(first_, dimension_, placement);
    std::optional<std::vector<double>> b = written(second_, dimension_, placement);
    for (int bits = nearly ? 24 : 0; (!a || !b) && bits >= 0; bits -= 4) {  // as long as it can be, about the origin
      placement = {.scale = Int{1} << bits};
      a = written(first_, dimension_, placement);
      b = written(second_, dimension_, placement);
    }
    ShapePair pair{std::move(a).value(), std::move(b).value(), {}, {}};
    for (std::size_t axis = 0, at = 0; axis < 3; ++axis) {
      if (dimension_ == 2 && axis == 1) continue;
      pair.contact[at] = std::ldexp(static_cast<double>(placement.base[axis]), placement.exponent);
      pair.normal[at++] = static_cast<double>(normal_[axis]);
    }
    if (nearly) loosen(pair, placement);
    return pair;
  }

  /// The numbers that may move on their own; none where the shape would not stay one.
  std::span<double> movable(const Body& body, std::vector<double>& numbers) const {
    const std::span all(numbers);
    switch (body.kind) {
      case ShapeKind::plane:
      case ShapeKind::halfspace:
      case ShapeKind::slab:
      case ShapeKind::halfspaces:
      case ShapeKind::rectangle:
      case ShapeKind::obb:
      case ShapeKind::lozenge:
      case ShapeKind::holed_polygon:
        return {};
      case ShapeKind::polygon:
      case ShapeKind::quadrilateral:
        return dimension_ == 2 ? all : std::span<double>{};
      case ShapeKind::mesh:
        return all.subspan(1, 3 * body.points.size());
      case ShapeKind::ellipsoid:
        return all.first(all.size() - body.half.size());
      default:
        return all.first(all.size() - (is_round(body.kind) ? 1 : 0));
    }
  }

  void loosen(ShapePair& pair, Placement placement) {
    const bool second = entropy_.coin();
    std::vector<double>& moved = second ? pair.b : pair.a;
    const Body& body = second ? second_ : first_;
    const std::span<double> alone = movable(body, moved);
    if (!alone.empty() && entropy_.coin()) {
      move_by_ulps(alone, 2, 4, entropy_);
      for (std::size_t i = 0, half = moved.size() / 2; is_aligned(body.kind) && i < half; ++i) {
        if (moved[i] > moved[half + i]) std::swap(moved[i], moved[half + i]);
      }
      return;
    }
    const std::size_t axis = dimension_ == 2 ? 2 * entropy_.below(2) : entropy_.below(3);
    const Int steps = 1 + static_cast<Int>(entropy_.below(4));
    placement.base[axis] += entropy_.coin() ? -steps : steps;
    if (auto shifted = written(body, dimension_, placement)) moved = std::move(*shifted);
  }

  ShapeKind a_, b_;
  int dimension_, space_;  // of the pair, and of the bodies: 2 for what is carried from the plane into space
  Entropy& entropy_;
  IntMap frame_;
  Int3 normal_{};
  Body first_{}, second_{};
};

}  // namespace

bool has_position(ShapeKind a, ShapeKind b, int dimension, Position position) {
  if (!is_kind_of(a, dimension) || !is_kind_of(b, dimension)) return false;
  if (const std::optional<Features> wanted = features_of(position)) {
    if (is_shared(position)) {
      if (!has_corners(a) || !has_corners(b)) return false;
      if (position == Position::shared_face) {
        const auto four = [](ShapeKind kind) { return is_box(kind) || kind == ShapeKind::quadrilateral; };
        const auto three = [](ShapeKind kind) { return !is_box(kind) && !is_chain(kind); };
        if (!(four(a) && four(b)) && !(three(a) && three(b))) return false;
      }
    }
    if (position == Position::edge_across_edge && dimension == 2) return false;
    return !ways(a, b, dimension, *wanted).empty();
  }
  switch (position) {
    case Position::parallel:
      return common_feature(a, b, dimension) >= 1;
    case Position::coplanar:
      return has_feature(a, dimension, dimension - 1) && has_feature(b, dimension, dimension - 1);
    case Position::perpendicular:
      return stands_on(a, b, dimension) || stands_on(b, a, dimension);
    case Position::contained:
      return can_contain(a, dimension) && !is_unbounded(b);
    case Position::equal:
      return a == b;
    case Position::reversed:
      return a == b && can_be_reversed(a);
    default:
      return true;
  }
}

ShapePair shape_pair(ShapeKind a, ShapeKind b, int dimension, Position position, Nearness nearness, Entropy& entropy) {
  if (!has_position(a, b, dimension, position)) {
    throw InvalidShape(std::string("shape_pair: no ")
                           .append(name_of(a))
                           .append(" and ")
                           .append(name_of(b))
                           .append(" lie ")
                           .append(name_of(position))
                           .append(dimension == 2 ? " in the plane" : " in space"));
  }
  return Pairing(a, b, dimension, entropy).made(position, nearness);
}

ShapePair any_shape_pair(ShapeKind a, ShapeKind b, int dimension, Entropy& entropy) {
  std::vector<Position> possible;
  for (const PositionInfo& info : positions) {
    if (has_position(a, b, dimension, info.position)) possible.push_back(info.position);
  }
  if (possible.empty()) possible.push_back(Position::concentric);  // of which shape_pair says that there is none
  const Position position = possible[entropy.below(possible.size())];
  const Nearness nearness = entropy.below(3) == 2 ? Nearness::nearly : Nearness::exactly;
  return shape_pair(a, b, dimension, position, nearness, entropy);
}

}  // namespace plumb::degenerate
