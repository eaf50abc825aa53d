// Contours as CAD programs read them: DXF as AutoCAD R12 wrote it, which everything reads.
#include <fmt/format.h>

#include <iterator>

#include "tool/section/command.hpp"

namespace plumb::tool {
namespace {

/// Groups: a code on a line, a value on the next.
class Groups {
 public:
  template <class Value>
  Groups& put(int code, const Value& value) {
    fmt::format_to(std::back_inserter(text_), "{:3}\n{}\n", code, value);
    return *this;
  }
  Groups& point(const Point3& p) { return put(10, p.x).put(20, p.y).put(30, p.z); }
  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::string layer_name(std::size_t plane) { return fmt::format("SECTION_{}", plane + 1); }

/// Plane polylines lie at one z; all others are polylines in space.
bool is_level(const AnyPlane3& plane) {
  const auto* const given = std::get_if<Plane3>(&plane);
  return given != nullptr && given->normal.x == 0 && given->normal.y == 0;
}

}  // namespace

std::string section_dxf(const SectionReport& report) {
  constexpr int closed = 1, in_space = 8, vertex_in_space = 32;
  Groups g;
  g.put(0, "SECTION").put(2, "HEADER").put(9, "$ACADVER").put(1, "AC1009").put(0, "ENDSEC");
  g.put(0, "SECTION").put(2, "TABLES").put(0, "TABLE").put(2, "LAYER").put(70, report.planes.size());
  for (std::size_t i = 0; i < report.planes.size(); ++i)
    g.put(999, report.planes[i].name).put(0, "LAYER").put(2, layer_name(i)).put(70, 0).put(62, 7).put(6, "CONTINUOUS");
  g.put(0, "ENDTAB").put(0, "ENDSEC").put(0, "SECTION").put(2, "ENTITIES");
  for (std::size_t i = 0; i < report.planes.size(); ++i) {
    const Section& section = report.sections[i];
    const std::string layer = layer_name(i);
    const bool level = is_level(section.plane);
    for (const Contour& contour : section.contours) {
      const double height = level ? contour.corners.front().nearest.z : 0;
      g.put(0, "POLYLINE").put(8, layer).put(66, 1).point({0, 0, height});
      g.put(70, (contour.closed ? closed : 0) | (level ? 0 : in_space));
      for (const SectionCorner& corner : contour.corners) {
        g.put(0, "VERTEX").put(8, layer).point(corner.nearest);
        if (!level) g.put(70, vertex_in_space);
      }
      g.put(0, "SEQEND").put(8, layer);
    }
  }
  g.put(0, "ENDSEC").put(0, "EOF");
  return g.take();
}

}  // namespace plumb::tool
