// Does the interval of a generalized winding number hold the solid angle of all triangles, computed to 250 bits?  Open
// meshes and closed ones, points anywhere, in planes of triangles, and in line with their corners.
#include "plumb/space/ray/open_winding.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/space/ray/inside.hpp"
#include "space/ray/rays.hpp"

namespace plumb {
namespace {

using namespace mesh_rays;

/// A number of 250 bits.
class Precise {
 public:
  Precise() { mpfr_init2(x_, 250), mpfr_set_zero(x_, 1); }
  explicit Precise(const mpq_class& x) : Precise() { mpfr_set_q(x_, x.get_mpq_t(), MPFR_RNDN); }
  Precise(const Precise& other) : Precise() { mpfr_set(x_, other.x_, MPFR_RNDN); }
  Precise& operator=(const Precise& other) {
    mpfr_set(x_, other.x_, MPFR_RNDN);
    return *this;
  }
  ~Precise() { mpfr_clear(x_); }

  friend Precise operator+(const Precise& a, const Precise& b) { return by(mpfr_add, a, b); }
  friend Precise operator*(const Precise& a, const Precise& b) { return by(mpfr_mul, a, b); }
  friend Precise operator/(const Precise& a, const Precise& b) { return by(mpfr_div, a, b); }
  friend Precise angle(const Precise& y, const Precise& x) { return by(mpfr_atan2, y, x); }
  friend Precise root(const Precise& a) {
    Precise r;
    mpfr_sqrt(r.x_, a.x_, MPFR_RNDN);
    return r;
  }
  [[nodiscard]] double nearest() const { return mpfr_get_d(x_, MPFR_RNDN); }

 private:
  template <class F>
  static Precise by(F f, const Precise& a, const Precise& b) {
    Precise r;
    f(r.x_, a.x_, b.x_, MPFR_RNDN);
    return r;
  }
  mpfr_t x_;
};

using Rational3 = std::array<mpq_class, 3>;
mpq_class dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Sums each triangle's solid angle; the nearest double, so that an interval of doubles holds it where it holds the sum.
double true_number(const TriangleMesh& mesh, const Point3& p) {
  Precise sum;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle3 t = triangle_of(mesh, i);
    std::array<Rational3, 3> v;
    std::array<Precise, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& q = k == 0 ? t.a : k == 1 ? t.b : t.c;
      v[k] = {mpq_class(mpq_class(q.x) - mpq_class(p.x)), mpq_class(mpq_class(q.y) - mpq_class(p.y)),
              mpq_class(mpq_class(q.z) - mpq_class(p.z))};
      length[k] = root(Precise(dot(v[k], v[k])));
    }
    const Rational3 across{mpq_class(v[1][1] * v[2][2] - v[1][2] * v[2][1]),
                           mpq_class(v[1][2] * v[2][0] - v[1][0] * v[2][2]),
                           mpq_class(v[1][0] * v[2][1] - v[1][1] * v[2][0])};
    const mpq_class volume = dot(v[0], across);
    if (volume == 0) continue;  // seen from the side
    sum = sum + angle(Precise(volume), length[0] * length[1] * length[2] + Precise(dot(v[0], v[1])) * length[2] +
                                           Precise(dot(v[1], v[2])) * length[0] + Precise(dot(v[2], v[0])) * length[1]);
  }
  Precise pi;
  pi = angle(Precise(0), Precise(-1));
  const double number = (sum / (Precise(2) * pi)).nearest();
  return std::fabs(number) < 0x1p-200 ? 0 : number;  // what 250 bits leave of angles that cancel
}

struct Seen {
  long asked = 0, on = 0, whole = 0, narrow = 0;
};

void expect_held(const TriangleMesh& mesh, const Bvh& bvh, std::span<const BorderEdge> border, const Point3& p,
                 Seen& seen, const std::string& about) {
  const auto found = generalized_winding_number(bvh, border, p);
  ++seen.asked;
  ASSERT_EQ(found.has_value(), locate(bvh, p) != Location::boundary) << about;
  if (!found) {
    ++seen.on;
    return;
  }
  const double number = true_number(mesh, p);
  ASSERT_LE(found->least, number) << about;
  ASSERT_GE(found->most, number) << about;
  seen.whole += found->least == found->most;
  seen.narrow += found->most - found->least < 1e-11;
}

Point3 whole_point(Material& m, std::uint64_t most) {
  const auto x = [&] { return static_cast<double>(m.below(most)); };
  return {x(), x(), x()};
}

/// The coordinates are small whole numbers, so that points are in line with corners, behind and ahead, and on edges and triangles.
TEST(OpenWinding, HoldsTheSolidAngleOfAnyTriangles) {
  Seen seen;
  on_shapes(1761, battery::fitting(1500), [&](Material& m) {
    TriangleMesh mesh;
    for (int i = 0; i < 5; ++i) mesh.vertices.push_back(whole_point(m, 4));
    const auto corner = [&] { return static_cast<std::uint32_t>(m.below(5)); };
    for (std::size_t n = 1 + m.below(4); n-- > 0;) mesh.triangles.push_back({corner(), corner(), corner()});
    const Bvh bvh = build_bvh(mesh, any_options(m));
    const std::vector<BorderEdge> border = border_of(bvh);
    for (int k = 0; k < 3; ++k) expect_held(mesh, bvh, border, whole_point(m, 4), seen, m.about());
  });
  EXPECT_GT(seen.on, seen.asked / 50);
  EXPECT_GT(seen.asked - seen.on, seen.asked / 2);
  EXPECT_GT(seen.narrow, (seen.asked - seen.on) * 9 / 10);
}

TEST(OpenWinding, HoldsTheSolidAngleOfAnOpenTorus) {
  Seen seen;
  on_shapes(1762, battery::fitting(60), [&](Material& m) {
    TriangleMesh mesh = solids::torus(3, 1, 12, 8);
    for (std::size_t n = m.below(9); n-- > 0;) {
      std::swap(mesh.triangles[m.below(mesh.triangles.size())], mesh.triangles.back());
      mesh.triangles.pop_back();
    }
    const Bvh bvh = build_bvh(mesh, {.split_share = 0.3F});
    const auto near = [&](double reach) { return static_cast<double>(m.entropy().within(1000)) / 1000 * reach; };
    const std::vector<BorderEdge> border = border_of(bvh);
    for (int k = 0; k < 5; ++k) expect_held(mesh, bvh, border, {near(5), near(5), near(2)}, seen, m.about());
  });
  EXPECT_EQ(seen.narrow + seen.on, seen.asked);
  EXPECT_GT(seen.whole, 0);
  EXPECT_LT(seen.whole, seen.asked / 2);
}

TEST(OpenWinding, OfClosedMeshesIsTheWindingNumber) {
  const TriangleMesh whole = solids::torus(3, 1, 12, 8);
  TriangleMesh soup;  // each triangle has corners of its own
  for (std::uint32_t i = 0; i < whole.triangles.size(); ++i) {
    const Triangle3 t = triangle_of(whole, i);
    soup.vertices.insert(soup.vertices.end(), {t.a, t.b, t.c});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  for (const TriangleMesh& mesh : {whole, soup}) {
    const Bvh bvh = build_bvh(mesh);
    const std::vector<BorderEdge> border = border_of(bvh);
    EXPECT_TRUE(border.empty());
    EXPECT_EQ(generalized_winding_number(bvh, border, {3, 0.125, 0}), (WindingInterval{1, 1}));
    EXPECT_EQ(generalized_winding_number(bvh, border, {0, 0, 0}), (WindingInterval{0, 0}));
    EXPECT_EQ(generalized_winding_number(bvh, border, mesh.vertices[5]), std::nullopt);
  }
}

TEST(OpenWinding, HasTheBorderOfAHole) {
  const Bvh bvh =
      build_bvh(TriangleMesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}, {{0, 1, 2}, {1, 3, 2}, {1, 1, 2}}});
  std::vector<BorderEdge> border = border_of(bvh);
  ASSERT_EQ(border.size(), 4u);
  EXPECT_TRUE(std::ranges::count(border, BorderEdge{{0, 0, 0}, {2, 0, 0}, 1}) == 1);
  EXPECT_TRUE(std::ranges::count(border, BorderEdge{{0, 2, 0}, {0, 0, 0}, 1}) == 1);
  // A square fills a sixth of all directions from the middle of its cube.
  const auto sixth = generalized_winding_number(bvh, border, {1, 1, -1});
  ASSERT_TRUE(sixth);
  EXPECT_LE(sixth->least * 6, 1 + 1e-12);
  EXPECT_GE(sixth->most * 6, 1 - 1e-12);
  EXPECT_THROW((void)generalized_winding_number(bvh, border, {1, 1, std::nan("")}), NonFinite);
}

}  // namespace
}  // namespace plumb
