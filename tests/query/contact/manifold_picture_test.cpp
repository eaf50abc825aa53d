// The picture of contacts in docs/contacts.md is what contact() tells; with PLUMB_WRITE_PICTURES set, this test writes it.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "degenerate/picture.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/query/contact/contact.hpp"

namespace plumb {
namespace {

using plumb_test::Dot, plumb_test::Panel, plumb_test::Picture;

constexpr double size = 210, margin = 12, words_height = 18;
constexpr std::string_view red = "#c03020", blue = "#1f5fa8", gray = "#a0a0a0";

/// Seen from before and above.
Dot seen(const Point3& p) { return {p.x - 0.375 * p.z, p.y - 0.4375 * p.z}; }

/// The corners as boxes number them: bit k is set where it is on the upper side along axis k.
std::array<Point3, 8> corners_of(const Aabb3& b) {
  std::array<Point3, 8> all{};
  for (std::size_t i = 0; i < 8; ++i) {
    all[i] = {(i & 1) != 0 ? b.max.x : b.min.x, (i & 2) != 0 ? b.max.y : b.min.y, (i & 4) != 0 ? b.max.z : b.min.z};
  }
  return all;
}
std::array<Point3, 8> corners_of(const Obb3& b) {
  std::array<Point3, 8> all{};
  for (std::size_t i = 0; i < 8; ++i) {
    const double u = (i & 1) != 0 ? b.half.x : -b.half.x, v = (i & 2) != 0 ? b.half.y : -b.half.y,
                 w = (i & 4) != 0 ? b.half.z : -b.half.z;
    const auto& [p, q, r] = b.axes;
    all[i] = {b.center.x + u * p.x + v * q.x + w * r.x, b.center.y + u * p.y + v * q.y + w * r.y,
              b.center.z + u * p.z + v * q.z + w * r.z};
  }
  return all;
}
void draw(Picture& picture, const Panel& panel, const std::array<Point3, 8>& corners, std::string_view stroke) {
  for (std::size_t i = 0; i < 8; ++i) {
    for (const std::size_t bit : {1U, 2U, 4U}) {
      if ((i & bit) == 0) picture.line(panel.at(seen(corners[i])), panel.at(seen(corners[i | bit])), stroke);
    }
  }
}

std::string name_of(const Feature& f) {
  return std::string(1, "vef"[static_cast<std::size_t>(f.kind)]) + std::to_string(f.index);
}

/// The table and the crate of the page, which rests, is in it, and is above it.
std::string drawn() {
  const Aabb3 table{{0, -1, 0}, {4, 0, 4}};
  const auto crate = [](double height) {
    return Obb3{{1, height, 1}, {Vector3{1, 0, 1}, Vector3{0, 1, 0}, Vector3{-1, 0, 1}}, {1, 0.5, 1}};
  };
  const std::array<double, 3> heights{0.5, 0.25, 1};
  const std::array<Relation, 3> relations{Relation::touching, Relation::overlapping, Relation::disjoint};
  std::vector<Dot> dots;
  for (const double h : heights) {
    for (const Point3& p : corners_of(crate(h))) dots.push_back(seen(p));
  }
  for (const Point3& p : corners_of(table)) dots.push_back(seen(p));
  constexpr double panel_width = size + 2 * margin;
  Picture picture(static_cast<int>(panel_width) * 3, static_cast<int>(size + 2 * margin + words_height));
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const Panel panel = Panel::around(dots, margin + panel_width * static_cast<double>(k), margin, size);
    const Obb3 upon = crate(heights[k]);
    const auto m = contact(upon, table, {.margin = 1});
    EXPECT_TRUE(m);
    if (!m) continue;
    EXPECT_EQ(m->relation, relations[k]);
    EXPECT_EQ(m->corners.size(), 5U);
    draw(picture, panel, corners_of(table), gray);
    draw(picture, panel, corners_of(upon), blue);
    for (const ContactCorner& c : m->corners) {
      const Dot a = panel.at(seen(c.on_a)), b = panel.at(seen(c.on_b));
      picture.line(a, b, red);
      picture.ring(b, 3.5, red);
      picture.dot(a, 2.5, red);
      picture.words({a.x + 5, a.y - 4}, name_of(c.id.a) + " " + name_of(c.id.b));
    }
    std::array<char, 64> words{};
    std::snprintf(words.data(), words.size(), "distance %g", m->distance);
    picture.words({panel.left, size + 2 * margin + words_height / 2}, words.data());
  }
  return picture.text();
}

TEST(ContactManifold, IsAsItsPictureShows) {
  const std::string path = std::string(PLUMB_SOURCE_DIR) + "/docs/contact.svg", picture = drawn();
  if (std::getenv("PLUMB_WRITE_PICTURES") != nullptr) std::ofstream(path, std::ios::binary) << picture;
  std::ifstream in(path, std::ios::binary);
  const std::string kept{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  EXPECT_EQ(kept, picture) << "run this test with PLUMB_WRITE_PICTURES=1 to draw " << path << " anew";
}

}  // namespace
}  // namespace plumb
