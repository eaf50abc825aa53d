#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>

#include "oracle/nef_solids.hpp"

namespace plumb::oracle {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Exact>;
using Surface = CGAL::Polyhedron_3<Exact>;

Exact::FT number_of(const std::string& quotient) { return Exact::FT(Exact::FT::ET(quotient)); }
Exact::Point_3 point_of(const QuotientPoint& p) { return {number_of(p[0]), number_of(p[1]), number_of(p[2])}; }

class Builder : public CGAL::Modifier_base<Surface::HalfedgeDS> {
 public:
  Builder(const std::vector<QuotientPoint>& vertices, const std::vector<std::array<std::uint32_t, 3>>& triangles)
      : vertices_(vertices), triangles_(triangles) {}

  void operator()(Surface::HalfedgeDS& to) override {
    CGAL::Polyhedron_incremental_builder_3<Surface::HalfedgeDS> b(to, false);
    b.begin_surface(vertices_.size(), triangles_.size());
    for (const QuotientPoint& p : vertices_) b.add_vertex(point_of(p));
    for (const auto& t : triangles_) {
      if (!b.test_facet(t.begin(), t.end())) {
        is_manifold = false;
        break;
      }
      b.add_facet(t.begin(), t.end());
    }
    if (b.error()) is_manifold = false;
    if (is_manifold) is_manifold = !b.check_unconnected_vertices();
    if (is_manifold)
      b.end_surface();
    else
      b.rollback();
  }
  bool is_manifold = true;

 private:
  const std::vector<QuotientPoint>& vertices_;
  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
};

}  // namespace

struct NefSolid::Polyhedron {
  Nef nef;
};

std::optional<NefSolid> NefSolid::of(const std::vector<QuotientPoint>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Surface surface;
  Builder build(vertices, triangles);
  surface.delegate(build);
  if (!build.is_manifold || !surface.is_closed() || !surface.is_valid()) return {};
  return NefSolid(std::make_shared<const Polyhedron>(Polyhedron{Nef(surface).regularization()}));
}

NefSolid NefSolid::by(SolidOperation operation, const NefSolid& other) const {
  const Nef &a = polyhedron_->nef, &b = other.polyhedron_->nef;
  const Nef made = operation == SolidOperation::unite       ? a + b
                   : operation == SolidOperation::intersect ? a * b
                   : operation == SolidOperation::subtract  ? a - b
                                                            : a ^ b;
  return NefSolid(std::make_shared<const Polyhedron>(Polyhedron{made.regularization()}));
}

Sign NefSolid::place(const QuotientPoint& p) const {
  const Nef::Object_handle at = polyhedron_->nef.locate(point_of(p));
  Nef::Volume_const_handle volume;
  if (!CGAL::assign(volume, at)) return Sign::zero;
  return volume->mark() ? Sign::positive : Sign::negative;
}

bool NefSolid::is_same(const NefSolid& other) const { return polyhedron_->nef == other.polyhedron_->nef; }

}  // namespace plumb::oracle
