// What two figures have in common, and bounds for convex bodies that the caller alone knows.
#include <algorithm>

#include "c/figures.hpp"
#include "c/texts.hpp"
#include "plumb/query/penetration/penetration_bounds.hpp"
#include "plumb/query/variant/questions.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

struct plumb_common {
  AnyIntersection answer;
  std::vector<ExactPoint3> of_planes;  // the one point of what planes have in common
};

namespace {

std::span<const ExactPoint2> common_corners(const plumb_common& /*of*/, const Intersection2& a) { return a.vertices; }
template <class Common>
std::span<const ExactPoint3> common_corners(const plumb_common& of, const Common& a) {
  if constexpr (requires { a.vertices; }) {
    return a.vertices;
  } else {
    return of.of_planes;
  }
}

/// Three numbers each, from whichever way the C++ answer says them.
template <class Common>
auto common_directions(const Common& a) {
  if constexpr (requires { a.directions; }) {
    return std::span(a.directions);
  } else {
    return std::span<const ExactVector3>();
  }
}

constexpr plumb_common_kind kind_of_flat(FlatKind kind) {
  switch (kind) {
    case FlatKind::nothing:
      return PLUMB_COMMON_NOTHING;
    case FlatKind::point:
      return PLUMB_COMMON_POINT;
    case FlatKind::line:
      return PLUMB_COMMON_LINE;
    case FlatKind::plane:
      return PLUMB_COMMON_PLANE;
    case FlatKind::space:
      break;
  }
  return PLUMB_COMMON_SPACE;
}

template <class Vector>
std::string text_of_three(const Vector& v) {
  return v.x.text() + " " + v.y.text() + " " + v.z.text();
}
std::string text_of_common_corner(const ExactPoint3& p) { return text_of_three(rational_point(p)); }
std::string text_of_common_corner(const ExactPoint2& p) {
  const RationalPoint2 exact = rational_point(p);
  return exact.x.text() + " " + exact.y.text();
}

void need_below(std::size_t number, std::size_t count, const char* argument) {
  if (number < count) return;
  throw c::InvalidArgument(std::string(argument) + " " + std::to_string(number) + " is none of the " +
                           std::to_string(count) + " that there are");
}

const SolidIntersection3& solid_of(const plumb_common& common) {
  const auto* solid = std::get_if<SolidIntersection3>(&common.answer);
  if (solid == nullptr) throw c::InvalidArgument("common is of figures that make no solid");
  return *solid;
}

/// A body that the caller's function tells.
auto mapping_of(const plumb_support* support, const char* argument) {
  need_size(support, argument);
  if (support->farthest == nullptr) throw c::InvalidArgument(std::string(argument) + "->farthest is NULL");
  return [farthest = support->farthest, user = support->user](const Vector3& direction) {
    const double along[3] = {direction.x, direction.y, direction.z};
    double point[3] = {0, 0, 0};
    farthest(along, point, user);
    return Point3{point[0], point[1], point[2]};
  };
}

template <class Bounds>
void write_bounds(const Bounds& from, plumb_bounds* to) {
  plumb_bounds out{};
  out.lower = from.lower, out.upper = from.upper;
  c::copy(out.direction, from.direction);
  out.told = static_cast<std::int32_t>(from.told);
  out.steps = from.steps;
  c::write(to, out);
}

}  // namespace

extern "C" {

plumb_status plumb_intersection(const plumb_figure* a, const plumb_figure* b, plumb_common** common) {
  return guarded("plumb_intersection", [&] {
    need(common, "common");
    plumb_common made{intersection(c::figure_of(a, "a"), c::figure_of(b, "b")), {}};
    if (const auto* flat = std::get_if<FlatIntersection>(&made.answer); flat != nullptr && flat->point) {
      made.of_planes.push_back(*flat->point);
    }
    *common = new plumb_common(std::move(made));
  });
}

void plumb_common_destroy(plumb_common* common) { delete common; }

plumb_status plumb_common_of(const plumb_common* common, plumb_common_size* size) {
  return guarded("plumb_common_of", [&] {
    need(common, "common");
    need_size(size, "size");
    plumb_common_size out{};
    std::visit(
        [&]<class Common>(const Common& answer) {
          const auto corners = common_corners(*common, answer);
          if constexpr (std::same_as<Common, FlatIntersection>) {
            out.kind = kind_of_flat(answer.kind);
            out.dimension = static_cast<std::int32_t>(answer.kind);
          } else {
            out.kind = static_cast<std::int32_t>(answer.kind);
            out.dimension = dimension(answer.kind);
          }
          out.coordinates = std::same_as<Common, Intersection2> ? 2 : 3;
          out.vertex_count = corners.size();
          out.direction_count = common_directions(answer).size();
          if constexpr (std::same_as<Common, SolidIntersection3>) out.face_count = answer.faces();
        },
        common->answer);
    c::write(size, out);
  });
}

plumb_status plumb_common_vertices(const plumb_common* common, double* vertices, std::size_t capacity,
                                   std::size_t* count) {
  return guarded("plumb_common_vertices", [&] {
    need(common, "common");
    need(vertices, capacity, "vertices");
    need(count, "count");
    std::visit(
        [&](const auto& answer) {
          const auto corners = common_corners(*common, answer);
          const auto first = corners.first(std::min(capacity, corners.size()));
          std::vector<decltype(approximate(corners[0]))> rounded;
          for (const auto& p : first) rounded.push_back(approximate(p));
          if (!rounded.empty()) std::memcpy(vertices, rounded.data(), rounded.size() * sizeof(rounded[0]));
          *count = corners.size();
        },
        common->answer);
  });
}

plumb_status plumb_common_vertex(const plumb_common* common, std::size_t vertex, char* text, std::size_t capacity,
                                 std::size_t* length) {
  return guarded("plumb_common_vertex", [&] {
    need(common, "common");
    c::need_text(text, capacity, length);
    std::visit(
        [&](const auto& answer) {
          const auto corners = common_corners(*common, answer);
          need_below(vertex, corners.size(), "vertex");
          c::write_text(text_of_common_corner(corners[vertex]), text, capacity, length);
        },
        common->answer);
  });
}

plumb_status plumb_common_direction(const plumb_common* common, std::size_t direction, char* text, std::size_t capacity,
                                    std::size_t* length) {
  return guarded("plumb_common_direction", [&] {
    need(common, "common");
    c::need_text(text, capacity, length);
    std::visit(
        [&](const auto& answer) {
          const auto directions = common_directions(answer);
          need_below(direction, directions.size(), "direction");
          c::write_text(text_of_three(directions[direction]), text, capacity, length);
        },
        common->answer);
  });
}

plumb_status plumb_common_face(const plumb_common* common, std::size_t face, const std::uint32_t** corners,
                               std::size_t* count) {
  return guarded("plumb_common_face", [&] {
    need(common, "common");
    need(corners, "corners");
    need(count, "count");
    const SolidIntersection3& solid = solid_of(*common);
    need_below(face, solid.faces(), "face");
    *corners = solid.corners_of(face).data();
    *count = solid.corners_of(face).size();
  });
}

plumb_status plumb_common_plane(const plumb_common* common, std::size_t face, char* text, std::size_t capacity,
                                std::size_t* length) {
  return guarded("plumb_common_plane", [&] {
    need(common, "common");
    c::need_text(text, capacity, length);
    const SolidIntersection3& solid = solid_of(*common);
    need_below(face, solid.faces(), "face");
    const RationalHalfspace3 plane = plane_of(solid, face);
    c::write_text(text_of_three(plane.normal) + " " + plane.offset.text(), text, capacity, length);
  });
}

plumb_status plumb_common_volume(const plumb_common* common, double* rounded, char* text, std::size_t capacity,
                                 std::size_t* length) {
  return guarded("plumb_common_volume", [&] {
    need(common, "common");
    c::need_text(text, capacity, length);
    const SolidIntersection3& solid = solid_of(*common);
    const std::string exact = exact_volume(solid).text();
    if (rounded != nullptr) *rounded = volume(solid);
    c::write_text(exact, text, capacity, length);
  });
}

plumb_status plumb_gjk_bounds(const plumb_support* a, const plumb_support* b, const plumb_bounds_options* options,
                              plumb_bounds* bounds) {
  return guarded("plumb_gjk_bounds", [&] {
    need_size(bounds, "bounds");
    GjkBoundsOptions wanted;
    if (options != nullptr) {
      need_size(options, "options");
      wanted = {.rounding = options->rounding, .within = options->within};
    }
    write_bounds(gjk_bounds(mapping_of(a, "a"), mapping_of(b, "b"), wanted), bounds);
  });
}

plumb_status plumb_penetration_bounds(const plumb_support* a, const plumb_support* b,
                                      const plumb_bounds_options* options, plumb_bounds* bounds) {
  return guarded("plumb_penetration_bounds", [&] {
    need_size(bounds, "bounds");
    PenetrationBoundsOptions wanted;
    if (options != nullptr) {
      need_size(options, "options");
      wanted.rounding = options->rounding, wanted.within = options->within;
      if (options->most_steps != 0) wanted.most_steps = options->most_steps;
    }
    write_bounds(penetration_bounds(mapping_of(a, "a"), mapping_of(b, "b"), wanted), bounds);
  });
}

}  // extern "C"
