#include "c/figures.hpp"

#include <vector>

#include "c/texts.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/query/variant/question_line.hpp"

namespace plumb::c {
namespace {

template <class Shape, class Numbers>
AnyFigure shape_of(const Numbers& numbers) {
  static_assert(sizeof(Shape) == sizeof(Numbers) && std::is_trivially_copyable_v<Shape>);
  Shape shape;
  std::memcpy(static_cast<void*>(&shape), &numbers, sizeof(shape));
  return shape;
}

template <class Item>
std::vector<Item> items_of(const double* numbers, std::size_t count, const char* what) {
  need(numbers, count, what);
  std::vector<Item> items(count);
  if (count != 0) std::memcpy(static_cast<void*>(items.data()), numbers, count * sizeof(Item));
  return items;
}

template <class Polygon, class Point>
AnyFigure polygon_of(const plumb_rings& rings) {
  return Polygon{items_of<Point>(rings.vertices, rings.vertex_count, "rings.vertices")};
}

template <class Holed, class Polygon, class Point>
AnyFigure holed_of(const plumb_rings& rings) {
  need(rings.ring_sizes, rings.ring_count, "rings.ring_sizes");
  const std::vector<Point> all = items_of<Point>(rings.vertices, rings.vertex_count, "rings.vertices");
  Holed holed;
  std::size_t first = 0;
  for (std::size_t r = 0; r < rings.ring_count; ++r) {
    if (rings.ring_sizes[r] > all.size() - first) {
      throw InvalidArgument("rings.ring_sizes[" + std::to_string(r) + "] is " + std::to_string(rings.ring_sizes[r]) +
                            ", but only " + std::to_string(all.size() - first) + " vertices are left");
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    Polygon ring{{begin, begin + static_cast<std::ptrdiff_t>(rings.ring_sizes[r])}};
    first += rings.ring_sizes[r];
    if (r == 0) {
      holed.outer = std::move(ring);
    } else {
      holed.holes.push_back(std::move(ring));
    }
  }
  if (first != all.size()) {
    throw InvalidArgument("rings.ring_sizes add up to " + std::to_string(first) + ", but there are " +
                          std::to_string(all.size()) + " vertices");
  }
  return holed;
}

template <class KDop, class Directions, class Vector>
AnyFigure k_dop_of(const plumb_k_dop& k) {
  return KDop{Directions(items_of<Vector>(k.directions, k.count, "k_dop.directions")),
              items_of<double>(k.min, k.count, "k_dop.min"), items_of<double>(k.max, k.count, "k_dop.max")};
}

AnyFigure polyhedron_of(const plumb_polyhedron& p) {
  need(p.face_sizes, p.face_count, "polyhedron.face_sizes");
  PolygonMesh mesh;
  mesh.vertices = items_of<Point3>(p.vertices, p.vertex_count, "polyhedron.vertices");
  std::size_t corners = 0;
  for (std::size_t f = 0; f < p.face_count; ++f) {
    corners += p.face_sizes[f];
    mesh.first.push_back(static_cast<std::uint32_t>(corners));
  }
  need(p.corners, corners, "polyhedron.corners");
  if (corners != 0) mesh.corners.assign(p.corners, p.corners + corners);
  for (std::size_t k = 0; k < corners; ++k) {
    if (mesh.corners[k] < p.vertex_count) continue;
    throw InvalidArgument("polyhedron.corners[" + std::to_string(k) + "] is " + std::to_string(mesh.corners[k]) +
                          ", but there are " + std::to_string(p.vertex_count) + " vertices");
  }
  return convex_polyhedron(std::move(mesh));
}

AnyFigure of_plane(const plumb_figure& f, const char* argument) {
  switch (f.kind) {
    case PLUMB_POINT:
      return shape_of<Point2>(f.as.point2);
    case PLUMB_LINE:
      return shape_of<Line2>(f.as.line2);
    case PLUMB_RAY:
      return shape_of<Ray2>(f.as.ray2);
    case PLUMB_SEGMENT:
      return shape_of<Segment2>(f.as.segment2);
    case PLUMB_HALFSPACE:
      return shape_of<Halfspace2>(f.as.halfspace2);
    case PLUMB_TRIANGLE:
      return shape_of<Triangle2>(f.as.triangle2);
    case PLUMB_QUADRILATERAL:
      return shape_of<Quadrilateral2>(f.as.quadrilateral2);
    case PLUMB_POLYGON:
      return polygon_of<Polygon2, Point2>(f.as.rings);
    case PLUMB_HOLED_POLYGON:
      return holed_of<HoledPolygon2, Polygon2, Point2>(f.as.rings);
    case PLUMB_BALL:
      return shape_of<Circle2>(f.as.circle2);
    case PLUMB_AABB:
      return shape_of<Aabb2>(f.as.aabb2);
    case PLUMB_OBB:
      return shape_of<Obb2>(f.as.obb2);
    case PLUMB_CAPSULE:
      return shape_of<Capsule2>(f.as.capsule2);
    case PLUMB_K_DOP:
      return k_dop_of<KDop2, Directions2, Vector2>(f.as.k_dop);
    case PLUMB_HALFSPACES:
      return HalfspaceIntersection2{
          items_of<Halfspace2>(f.as.halfspaces.numbers, f.as.halfspaces.count, "halfspaces.numbers")};
    default:
      break;
  }
  throw InvalidArgument(std::string(argument) + "->kind " + std::to_string(f.kind) + " is no kind of the plane");
}

AnyFigure of_space(const plumb_figure& f, const char* argument) {
  switch (f.kind) {
    case PLUMB_POINT:
      return shape_of<Point3>(f.as.point3);
    case PLUMB_LINE:
      return shape_of<Line3>(f.as.line3);
    case PLUMB_RAY:
      return shape_of<Ray3>(f.as.ray3);
    case PLUMB_SEGMENT:
      return shape_of<Segment3>(f.as.segment3);
    case PLUMB_PLANE:
      return shape_of<Plane3>(f.as.plane3);
    case PLUMB_THREE_POINT_PLANE:
      return shape_of<ThreePointPlane3>(f.as.three_point_plane3);
    case PLUMB_HALFSPACE:
      return shape_of<Halfspace3>(f.as.halfspace3);
    case PLUMB_TRIANGLE:
      return shape_of<Triangle3>(f.as.triangle3);
    case PLUMB_QUADRILATERAL:
      return shape_of<Quadrilateral3>(f.as.quadrilateral3);
    case PLUMB_POLYGON:
      return polygon_of<Polygon3, Point3>(f.as.rings);
    case PLUMB_HOLED_POLYGON:
      return holed_of<HoledPolygon3, Polygon3, Point3>(f.as.rings);
    case PLUMB_RECTANGLE:
      return shape_of<Rectangle3>(f.as.rectangle3);
    case PLUMB_TETRAHEDRON:
      return shape_of<Tetrahedron3>(f.as.tetrahedron3);
    case PLUMB_BALL:
      return shape_of<Sphere3>(f.as.sphere3);
    case PLUMB_AABB:
      return shape_of<Aabb3>(f.as.aabb3);
    case PLUMB_OBB:
      return shape_of<Obb3>(f.as.obb3);
    case PLUMB_CAPSULE:
      return shape_of<Capsule3>(f.as.capsule3);
    case PLUMB_LOZENGE:
      return shape_of<Lozenge3>(f.as.lozenge3);
    case PLUMB_CYLINDER:
      return shape_of<Cylinder3>(f.as.cylinder3);
    case PLUMB_CONE:
      return shape_of<Cone3>(f.as.cone3);
    case PLUMB_K_DOP:
      return k_dop_of<KDop3, Directions3, Vector3>(f.as.k_dop);
    case PLUMB_HALFSPACES:
      return HalfspaceIntersection3{
          items_of<Halfspace3>(f.as.halfspaces.numbers, f.as.halfspaces.count, "halfspaces.numbers")};
    case PLUMB_POLYHEDRON:
      return polyhedron_of(f.as.polyhedron);
    case PLUMB_SPHERICAL_CAP:
      return shape_of<SphericalCap3>(f.as.spherical_cap3);
    default:
      break;
  }
  throw InvalidArgument(std::string(argument) + "->kind " + std::to_string(f.kind) + " is no kind of space");
}

template <class Pose, class Numbers>
Pose pose_of(const Numbers& numbers) {
  static_assert(sizeof(Pose) == sizeof(Numbers) && std::is_trivially_copyable_v<Pose>);
  Pose pose;
  std::memcpy(static_cast<void*>(&pose), &numbers, sizeof(pose));
  return pose;
}

template <class Chain, class Link, class Links>
Chain chain_of(const Links& links) {
  need(links.links, links.count, "pose.chain.links");
  Chain chain;
  for (std::size_t i = 0; i < links.count; ++i) chain.links.push_back(pose_of<Link>(links.links[i]));
  return chain;
}

AnyPose pose_of(const plumb_figure& f, const char* argument) {
  const bool plane = f.dimension == 2;
  switch (f.pose_kind) {
    case PLUMB_AS_IT_IS:
      return {};
    case PLUMB_MATRIX:
      return plane ? AnyPose(pose_of<Pose2>(f.pose.matrix2)) : AnyPose(pose_of<Pose>(f.pose.matrix3));
    case PLUMB_RIGID:
      return plane ? AnyPose(pose_of<RigidPose2>(f.pose.rigid2)) : AnyPose(pose_of<RigidPose>(f.pose.rigid3));
    case PLUMB_CHAIN:
      return plane ? AnyPose(chain_of<RigidChain2, RigidPose2>(f.pose.chain2))
                   : AnyPose(chain_of<RigidChain, RigidPose>(f.pose.chain3));
    default:
      break;
  }
  throw InvalidArgument(std::string(argument) + "->pose_kind " + std::to_string(f.pose_kind) + " is none");
}

}  // namespace

AnyFigure figure_of(const plumb_figure* given, const char* argument) {
  need_size(given, argument);
  if (given->kept != nullptr) return given->kept->figure;
  if (given->dimension != 2 && given->dimension != 3) {
    throw InvalidArgument(std::string(argument) + "->dimension is " + std::to_string(given->dimension) +
                          "; it is 2 or 3");
  }
  const AnyFigure shape = given->dimension == 2 ? of_plane(*given, argument) : of_space(*given, argument);
  return given->pose_kind == PLUMB_AS_IT_IS ? shape : shape.under(pose_of(*given, argument));
}

Translating<AnyFigure> moved(const plumb_figure* figure, const double* by, const char* argument) {
  AnyFigure any = figure_of(figure, argument);
  Vector3 along{0, 0, 0};
  if (by != nullptr) along = {by[0], by[1], any.dimension() == 3 ? by[2] : 0};
  return {std::move(any), along};
}

}  // namespace plumb::c

using namespace plumb;
using c::guarded, c::need;

extern "C" {

plumb_status plumb_kept_create(const plumb_figure* figure, plumb_kept** kept) {
  return guarded("plumb_kept_create", [&] {
    need(kept, "kept");
    *kept = new plumb_kept{c::figure_of(figure, "figure")};
  });
}

plumb_status plumb_kept_parse(const char* line, plumb_kept** kept) {
  return guarded("plumb_kept_parse", [&] {
    need(line, "line");
    need(kept, "kept");
    auto figure = parse_figure(line);
    if (!figure) throw c::InvalidArgument("the line is blank or a comment");
    *kept = new plumb_kept{*std::move(figure)};
  });
}

void plumb_kept_destroy(plumb_kept* kept) { delete kept; }

plumb_status plumb_figure_line(const plumb_figure* figure, char* line, std::size_t capacity, std::size_t* length) {
  return guarded("plumb_figure_line", [&] {
    need(length, "length");
    c::write_text(to_string(c::figure_of(figure, "figure")), line, capacity, length);
  });
}

plumb_status plumb_ask(const char* question, char* answer, std::size_t capacity, std::size_t* length) {
  return guarded("plumb_ask", [&] {
    need(question, "question");
    need(length, "length");
    const std::optional<QuestionLine> asked = parse_question_line(question);
    if (!asked) throw c::InvalidArgument("question is a blank line or a remark");
    c::write_text(answer_of(*asked), answer, capacity, length);
  });
}

}  // extern "C"
