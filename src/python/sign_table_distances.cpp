#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/predicates/distance.hpp"
#include "python/sign_question.hpp"

namespace plumb::python {
namespace {

using P2 = Point2;
using P3 = Point3;

}  // namespace

std::vector<SignQuestion> distance_questions() {
  namespace f = predicates;
  const auto points = [](const auto&... p) { return compare_distance(p...); };
  const auto line = [](const auto&... p) { return compare_distance_to_line(p...); };
  const auto lines = [](const auto&... p) { return compare_distance_to_lines(p...); };
  const auto segment = [](const auto&... p) { return compare_distance_to_segment(p...); };
  const auto segments = [](const auto&... p) { return compare_distance_to_segments(p...); };
  const auto plane = [](const auto&... p) { return compare_distance_to_plane(p...); };
  const auto planes = [](const auto&... p) { return compare_distance_to_planes(p...); };
  return {
      {"compare_distance",
       "The distance |ab| against |cd|; of a, b, c alone against |ac|; or against the number `distance`, which may be\n"
       "negative and is then below every distance.",
       {formula_form<f::CompareDistance2d, P2, P2, P2, P2>({"a", "b", "c", "d"}),
        formula_form<f::CompareDistance3d, P3, P3, P3, P3>({"a", "b", "c", "d"}),
        formula_form<f::CompareDistanceFrom2d, P2, P2, P2>({"a", "b", "c"}),
        formula_form<f::CompareDistanceFrom3d, P3, P3, P3>({"a", "b", "c"}),
        form<P2, P2, double>({"a", "b", "distance"}, points), form<P3, P3, double>({"a", "b", "distance"}, points)}},
      {"compare_distance_to_line",
       "The distance of c from the line ab against that of d, or against the number `distance`.",
       {form<P2, P2, P2, P2>({"a", "b", "c", "d"}, line), form<P3, P3, P3, P3>({"a", "b", "c", "d"}, line),
        form<P2, P2, P2, double>({"a", "b", "c", "distance"}, line),
        form<P3, P3, P3, double>({"a", "b", "c", "distance"}, line)}},
      {"compare_distance_to_lines",
       "The distance of c from the line ab against that of f from the line de.",
       {form<P2, P2, P2, P2, P2, P2>({"a", "b", "c", "d", "e", "f"}, lines),
        form<P3, P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e", "f"}, lines)}},
      {"compare_signed_distance_to_line",
       "From the line ab, positive to its left: the signed distance of c against that of d.",
       {form<P2, P2, P2, P2>({"a", "b", "c", "d"},
                             [](const auto&... p) { return compare_signed_distance_to_line(p...); })}},
      {"compare_distance_to_segment",
       "The distance of c from the segment ab against that of d, or against the number `distance`.",
       {form<P2, P2, P2, P2>({"a", "b", "c", "d"}, segment), form<P3, P3, P3, P3>({"a", "b", "c", "d"}, segment),
        form<P2, P2, P2, double>({"a", "b", "c", "distance"}, segment),
        form<P3, P3, P3, double>({"a", "b", "c", "distance"}, segment)}},
      {"compare_distance_to_segments",
       "The distance of c from the segment ab against that of f from the segment de.",
       {form<P2, P2, P2, P2, P2, P2>({"a", "b", "c", "d", "e", "f"}, segments),
        form<P3, P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e", "f"}, segments)}},
      {"compare_distance_to_plane",
       "The distance of d from the plane abc against that of e, or against the number `distance`.",
       {form<P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e"}, plane),
        form<P3, P3, P3, P3, double>({"a", "b", "c", "d", "distance"}, plane)}},
      {"compare_distance_to_planes",
       "The distance of d from the plane abc against that of h from the plane efg.",
       {form<P3, P3, P3, P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e", "f", "g", "h"}, planes)}},
      {"compare_signed_distance_to_plane",
       "From the plane abc, positive where a, b, c are seen counterclockwise: the signed distance of d against that of "
       "e.",
       {form<P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e"},
                                 [](const auto&... p) { return compare_signed_distance_to_plane(p...); })}},
      {"side_of_line",
       "On which side of the line normal . x = offset is p?  1 on that to which the normal points.",
       {form<Vector2, double, P2>({"normal", "offset", "p"}, [](const auto&... p) { return side_of_line(p...); })}},
      {"side_of_plane",
       "On which side of the plane normal . x = offset is p?  1 on that to which the normal points.",
       {form<Vector3, double, P3>({"normal", "offset", "p"}, [](const auto&... p) { return side_of_plane(p...); })}},
  };
}

}  // namespace plumb::python
