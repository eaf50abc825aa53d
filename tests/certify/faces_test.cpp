// Do the functions that compose several formulas agree with CGAL, degenerate shapes included?
#include <gtest/gtest.h>

#include <iostream>

#include "certify/tally.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/certify/smallest_sphere.hpp"

namespace plumb::battery {
namespace {

using P2 = const Point2&;
using P3 = const Point3&;
template <class... Arguments>
using Function = Sign (*)(Arguments...);

template <class Argument>
Argument taken(std::span<const double>& p) {
  Argument x{};
  if constexpr (coordinate_count<Argument> == 1) {
    x = p[0];
  } else if constexpr (coordinate_count<Argument> == 2) {
    x = {p[0], p[1]};
  } else {
    x = {p[0], p[1], p[2]};
  }
  p = p.subspan(coordinate_count<Argument>);
  return x;
}

template <class... Arguments>
Sign call(Sign (*f)(Arguments...), std::span<const double> p) {
  // In braces the arguments are taken in turn.
  return std::apply(f, std::tuple<std::remove_cvref_t<Arguments>...>{taken<std::remove_cvref_t<Arguments>>(p)...});
}

template <class... Arguments>
constexpr std::array<int, sizeof...(Arguments)> counts_of(Sign (*)(Arguments...)) {
  return {coordinate_count<std::remove_cvref_t<Arguments>>...};
}

// A function as an entry of the catalog, so that the cases of formulas serve it.
template <auto f>
CatalogEntry face(std::string_view name) {
  static constexpr auto counts = counts_of(f);
  CatalogEntry e{};
  e.name = name;
  e.arguments = counts;
  const bool points = std::ranges::min(counts) == std::ranges::max(counts);
  if (points) e.points = static_cast<int>(counts.size());
  if (points) e.dimension = counts[0];
  e.homogeneous = !name.starts_with("normal");
  for (const int n : counts) e.program.arity += static_cast<std::size_t>(n);
  e.decide = [](std::span<const double> p) { return Decision{call(f, p), Stage::filter}; };
  return e;
}

const std::vector<CatalogEntry>& faces() {
  static const std::vector<CatalogEntry> all{
      face<Function<P2, P2, double>{compare_distance}>("compare_distance_to_number2d"),
      face<Function<P3, P3, double>{compare_distance}>("compare_distance_to_number3d"),
      face<Function<P2, P2, P2, P2>{compare_distance_to_line}>("line2d"),
      face<Function<P3, P3, P3, P3>{compare_distance_to_line}>("line3d"),
      face<Function<P2, P2, P2, double>{compare_distance_to_line}>("line_to_number2d"),
      face<Function<P3, P3, P3, double>{compare_distance_to_line}>("line_to_number3d"),
      face<Function<P2, P2, P2, P2, P2, P2>{compare_distance_to_lines}>("lines2d"),
      face<Function<P3, P3, P3, P3, P3, P3>{compare_distance_to_lines}>("lines3d"),
      face<Function<P2, P2, P2, P2>{compare_distance_to_segment}>("segment2d"),
      face<Function<P3, P3, P3, P3>{compare_distance_to_segment}>("segment3d"),
      face<Function<P2, P2, P2, double>{compare_distance_to_segment}>("segment_to_number2d"),
      face<Function<P3, P3, P3, double>{compare_distance_to_segment}>("segment_to_number3d"),
      face<Function<P2, P2, P2, P2, P2, P2>{compare_distance_to_segments}>("segments2d"),
      face<Function<P3, P3, P3, P3, P3, P3>{compare_distance_to_segments}>("segments3d"),
      face<Function<P3, P3, P3, P3, P3>{compare_distance_to_plane}>("plane"),
      face<Function<P3, P3, P3, P3, double>{compare_distance_to_plane}>("plane_to_number"),
      face<Function<P3, P3, P3, P3, P3, P3, P3, P3>{compare_distance_to_planes}>("planes"),
      face<Function<const Vector2&, double, P2, double>{compare_distance_to_line}>("normal2d_to_number"),
      face<Function<const Vector3&, double, P3, double>{compare_distance_to_plane}>("normal3d_to_number"),
      face<Function<P2, P2, P2, P2>{in_smallest_circle}>("circle3"),
      face<Function<P3, P3, P3, P3>{in_smallest_sphere}>("sphere3"),
  };
  return all;
}

class Faces : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] const CatalogEntry& entry() const { return faces()[GetParam()]; }

  template <class Fill>
  Tally try_cases(std::string_view sort, std::uint64_t count, Fill fill) {
    Tally tally;
    std::vector<double> p(entry().arity());
    for (std::uint64_t i = 0; i < count; ++i) {
      Entropy entropy(start_of(entry()), i);
      fill(p, entropy);
      const Decision said = entry().decide(p);
      const auto truth = oracle::face_by_cgal(entry().name, p);
      EXPECT_TRUE(truth.has_value());
      if (!truth) return tally;
      EXPECT_EQ(said.sign, *truth) << sort << ' ' << i << ": " << to_string(CaseLine{std::string(entry().name), p, {}});
      if (said.sign != *truth) return tally;
      tally.add(said);
    }
    return tally;
  }
};

TEST_P(Faces, SayWhatCgalSays) {
  const std::uint64_t each = sanitized ? 10 : 60;
  for (const FamilyInfo& f : families) {
    try_cases(f.name, each,
              [&](std::vector<double>& p, Entropy& entropy) { fill_arguments(entry(), f.family, p, entropy); });
  }
  // Tiny ones repeat points and make flat shapes, too.
  const auto tiny = [](std::vector<double>& p, Entropy& entropy) {
    fill_tiny(1 + static_cast<std::int64_t>(entropy.below(2)), p, entropy);
  };
  const auto near = [&](std::vector<double>& p, Entropy& entropy) { fill_near_zero(entry(), p, entropy); };
  const Tally small = try_cases("tiny", 20 * each, tiny);
  const Tally zero =
      try_cases("zero", 5 * each, [&](std::vector<double>& p, Entropy& entropy) { fill_at_zero(entry(), p, entropy); });
  const Tally near_zero = try_cases("near zero", 10 * each, near);
  if (HasFailure()) return;
  std::cout << entry().name << ":\n  tiny" << small << "\n  zero" << zero << "\n  near" << near_zero << '\n';
  for (const Sign s : {Sign::negative, Sign::zero, Sign::positive}) EXPECT_GE(small.share(s), 0.01) << to_char(s);
  EXPECT_GE(zero.share(Sign::zero), 0.4);
}

INSTANTIATE_TEST_SUITE_P(All, Faces, testing::Range<std::size_t>(0, faces().size()),
                         [](const auto& at) { return std::string(faces()[at.param].name); });

}  // namespace
}  // namespace plumb::battery
