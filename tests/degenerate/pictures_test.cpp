// The pictures of docs/degeneracies.md are what the generators make; with PLUMB_WRITE_PICTURES set, this test writes
// them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "degenerate/picture.hpp"
#include "degenerate/shape_pictures.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace {

using plumb::Degeneracy, plumb::Entropy, plumb::Family, plumb::Point2, plumb::Point3;
using plumb_test::Dot, plumb_test::Panel, plumb_test::Picture;

constexpr double size = 200, margin = 10, words_height = 20;
constexpr int width = 220, height = 240;
constexpr std::string_view red = "#c03020";

std::vector<Point2> points_of(Family family, Degeneracy degeneracy, std::size_t count, std::uint64_t index) {
  Entropy entropy(61, index);
  return points2(family, degeneracy, count, entropy);
}

std::vector<Dot> dots_of(const std::vector<Point2>& points) {
  std::vector<Dot> dots;
  for (const Point2& p : points) dots.push_back({p.x, p.y});
  return dots;
}

std::string hexadecimal(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  return text.data();
}

Picture scatter(const std::vector<Dot>& dots, const std::string& words) {
  Picture picture(width, height);
  const Panel panel = Panel::around(dots, margin, margin, size);
  for (const Dot& d : dots) picture.dot(panel.at(d));
  picture.words({margin, margin + size + words_height}, words);
  return picture;
}

// Center of the circle through three points: only to draw it.
Dot circumcenter(Dot a, Dot b, Dot c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double twice = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  return {a.x + (cy * b2 - by * c2) / twice, a.y + (bx * c2 - cx * b2) / twice};
}

// A line on the left, a circle on the right, each with the first coordinate in words.
Picture line_and_circle(Family family, std::uint64_t index) {
  Picture picture(2 * width, height);
  for (const bool circle : {false, true}) {
    const auto dots = dots_of(points_of(family, circle ? Degeneracy::cocircular : Degeneracy::collinear, 12, index));
    const Panel panel = Panel::around(dots, margin + (circle ? width : 0), margin, size);
    if (circle) {
      const Dot center = circumcenter(dots[0], dots[4], dots[8]);
      const double dx = dots[0].x - center.x, dy = dots[0].y - center.y;
      picture.ring(panel.at(center), panel.length(std::sqrt(dx * dx + dy * dy)));
    } else {
      const auto [low, high] = std::minmax_element(dots.begin(), dots.end(), [](Dot a, Dot b) { return a.x < b.x; });
      picture.line(panel.at(*low), panel.at(*high));
    }
    for (const Dot& d : dots) picture.dot(panel.at(d));
    picture.words({panel.left, margin + size + words_height}, "a.x = " + hexadecimal(dots[0].x));
  }
  return picture;
}

Picture moved_by_ulps() {
  std::vector<std::uint64_t> choices;
  std::vector<Point2> moved, exact;
  // The first case that moves two coordinates of points well spread, found by replaying it without its moves.
  for (std::uint64_t index = 0, coordinates = 0; coordinates != 2; ++index) {
    choices.clear();
    Entropy entropy(61, index);
    entropy.record_into(&choices);
    moved = points2(Family::off_by_ulps, Degeneracy::collinear, 8, entropy);
    Entropy replay = Entropy::from_choices(std::span(choices).subspan(1));
    exact =
        points2(choices[0] != 0 ? Family::degenerate_long : Family::degenerate_short, Degeneracy::collinear, 8, replay);
    coordinates = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      coordinates += (exact[i].x != moved[i].x) + (exact[i].y != moved[i].y);
    }
    const Panel panel = Panel::around(dots_of(exact), 0, 0, 1);
    const auto inner = std::count_if(exact.begin(), exact.end(), [&](const Point2& q) {
      const Dot at = panel.at({q.x, q.y});
      return std::fabs(at.x - 0.5) < 0.3 && std::fabs(at.y - 0.5) < 0.3;
    });
    if (inner < 4) coordinates = 0;
  }
  Picture picture(width, height);
  const auto dots = dots_of(exact);
  const Panel panel = Panel::around(dots, margin, margin, size);
  const auto [low, high] = std::minmax_element(dots.begin(), dots.end(), [](Dot a, Dot b) { return a.x < b.x; });
  picture.line(panel.at(*low), panel.at(*high));
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const Dot at = panel.at(dots[i]);
    const auto across = static_cast<double>(plumb::place_of(moved[i].x) - plumb::place_of(exact[i].x));
    const auto up = static_cast<double>(plumb::place_of(moved[i].y) - plumb::place_of(exact[i].y));
    if (across != 0 || up != 0) picture.line(at, {at.x + 8 * across, at.y - 8 * up}, red);
    picture.dot(at);
  }
  picture.words({margin, margin + size + words_height}, "red: moved, 8 pixels an ulp");
  return picture;
}

Picture repeated() {
  const auto points = points_of(Family::repeated, Degeneracy::collinear, 14, 8);
  Picture picture(width, height);
  const Panel panel = Panel::around(dots_of(points), margin, margin, size);
  for (const Point2& p : points) {
    const auto times = std::count(points.begin(), points.end(), p);
    const Dot at = panel.at({p.x, p.y});
    for (std::ptrdiff_t k = 1; k < times; ++k) picture.ring(at, 2.5 + 3 * static_cast<double>(k), red);
    picture.dot(at);
  }
  picture.words({margin, margin + size + words_height}, "a ring for each repetition");
  return picture;
}

// Position on an axis of exponents: 0 in the middle, then the smallest doubles, the largest at the ends.
double on_axis_of_exponents(double x) {
  if (x == 0) return 0;
  const int exponent = plumb::highest_exponent(x);
  const double position = exponent + 1075 + (std::ldexp(std::fabs(x), -exponent) - 1);
  return x < 0 ? -position : position;
}

Picture exponents(Family family) {
  Picture picture(width, height);
  const Panel panel{margin, margin, size, -2105, -2105, 4210};
  for (const int exponent : {-1074, -500, 0, 500, 1023}) {
    const double at = on_axis_of_exponents(std::ldexp(1.0, exponent));
    for (const double signed_at : {at, -at}) {
      picture.line(panel.at({signed_at, -2100}), panel.at({signed_at, 2100}), "#e8e8e8");
      picture.line(panel.at({-2100, signed_at}), panel.at({2100, signed_at}), "#e8e8e8");
    }
  }
  for (std::uint64_t index = 0; index < 60; ++index) {
    for (const Point2& p : points_of(family, Degeneracy::collinear, 2, index)) {
      picture.dot(panel.at({on_axis_of_exponents(p.x), on_axis_of_exponents(p.y)}), 2);
    }
  }
  picture.words({margin, margin + size + words_height}, "axes: 0 and ± 2^-1074 to 2^1023");
  return picture;
}

Picture near_half() {
  std::vector<Dot> dots;
  for (const Point2& p : points_of(Family::near_half, Degeneracy::collinear, 50, 3)) {
    if (std::fabs(p.x - 0.5) < 0x1p-40) dots.push_back({(p.x - 0.5) * 0x1p53, (p.y - 0.5) * 0x1p53});
  }
  return scatter(dots, "(0.5 + i 2^-53, 0.5 + j 2^-53)");
}

// What the plain formula says of (0.5 + i 2^-53, 0.5 + j 2^-53), (12, 12), (24, 24), for 50 by 50 points.
Picture wrong_signs() {
  constexpr int cells = 50;
  constexpr double cell = size / cells;
  Picture picture(width, height);
  for (int j = 0; j < cells; ++j) {
    int run = 0;
    for (int i = 0; i < cells; ++i) {
      const auto sign_at = [&](int column) {
        const double x = 0.5 + column * 0x1p-53, y = 0.5 + j * 0x1p-53;
        const double det = (12 - x) * (24 - y) - (12 - y) * (24 - x);
        return (det > 0) - (det < 0);
      };
      ++run;
      if (i + 1 < cells && sign_at(i + 1) == sign_at(i)) continue;
      const std::string_view fill = sign_at(i) > 0 ? "#7fa8d8" : sign_at(i) < 0 ? "#e8c080" : "#505050";
      picture.rectangle(margin + (i + 1 - run) * cell, margin + (cells - 1 - j) * cell, run * cell, cell, fill);
      run = 0;
    }
  }
  picture.line({margin, margin + size}, {margin + size, margin}, red);
  picture.words({margin, margin + size + words_height}, "float sign; the true zeros are red");
  return picture;
}

// Points of a sphere or plane seen from above; the higher the point, the larger.
Picture from_above(Degeneracy degeneracy, std::uint64_t index) {
  Entropy entropy(61, index);
  const std::vector<Point3> points = points3(Family::degenerate_short, degeneracy, 60, entropy);
  std::vector<Dot> dots;
  double low = INFINITY, high = -INFINITY;
  for (const Point3& p : points) {
    dots.push_back({p.x, p.y});
    low = std::fmin(low, p.z), high = std::fmax(high, p.z);
  }
  Picture picture(width, height);
  const Panel panel = Panel::around(dots, margin, margin, size);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    picture.dot(panel.at(dots[i]), 1.5 + 3 * (points[i].z - low) / std::fmax(high - low, 1));
  }
  picture.words({margin, margin + size + words_height}, "larger: nearer");
  return picture;
}

Picture grid() {
  std::vector<Dot> dots;
  double largest = 0;
  for (std::uint64_t index = 0; largest != 7; ++index) {  // the first set of three bits
    dots = dots_of(points_of(Family::grid, Degeneracy::collinear, 40, index));
    largest = 0;
    for (const Dot& d : dots) largest = std::fmax(largest, std::fmax(std::fabs(d.x), std::fabs(d.y)));
  }
  Picture picture(width, height);
  const Panel panel = Panel::around(dots, margin, margin, size);
  for (double at = -7; at <= 7; ++at) {
    picture.line(panel.at({at, -7}), panel.at({at, 7}), "#e8e8e8");
    picture.line(panel.at({-7, at}), panel.at({7, at}), "#e8e8e8");
  }
  for (const Dot& d : dots) picture.dot(panel.at(d));
  picture.words({margin, margin + size + words_height}, "integers from -7 to 7");
  return picture;
}

// A cloud of space from above.
Picture cloud_picture(std::size_t which) {
  Entropy entropy(61, which);
  std::vector<Dot> dots;
  for (const Point3& p : cloud3(plumb::clouds[which].cloud, 125, entropy)) dots.push_back({p.x, p.y});
  Picture picture(width, width);
  const Panel panel = Panel::around(dots, margin, margin, size);
  for (Dot& d : dots) d = panel.at(d);
  picture.scatter(dots, 1.5);
  return picture;
}

using Draw = std::function<Picture()>;

std::map<std::string, Draw> with_all(std::map<std::string, Draw> made) {
  using namespace plumb::degenerate;
  const auto add = [&](std::string_view of, std::string_view name, const Draw& draw) {
    made.emplace(std::string(of).append("_").append(name), draw);
  };
  for (std::size_t i = 0; i < plumb::clouds.size(); ++i) {
    add("cloud", plumb::clouds[i].name, [i] { return cloud_picture(i); });
  }
  for (const auto& info : shape_kinds) add("shape", info.name, [&info] { return plumb_test::kind_picture(info.kind); });
  for (const auto& info : forms) add("form", info.name, [&info] { return plumb_test::form_picture(info.form); });
  for (const auto& info : positions) {
    add("position", info.name, [&info] { return plumb_test::position_picture(info.position); });
  }
  return made;
}

const std::map<std::string, Draw> pictures = with_all({
    {"grid", grid},
    {"uniform", [] { return scatter(dots_of(points_of(Family::uniform, Degeneracy::collinear, 60, 0)), "uniform"); }},
    {"float32", [] { return scatter(dots_of(points_of(Family::float32, Degeneracy::collinear, 60, 0)), "float32"); }},
    {"near_half", near_half},
    {"near_half_signs", wrong_signs},
    {"degenerate_short", [] { return line_and_circle(Family::degenerate_short, 3); }},
    {"degenerate_long", [] { return line_and_circle(Family::degenerate_long, 1); }},
    {"coplanar", [] { return from_above(Degeneracy::coplanar, 4); }},
    {"cospherical", [] { return from_above(Degeneracy::cospherical, 1); }},
    {"off_by_ulps", moved_by_ulps},
    {"repeated", repeated},
    {"wide", [] { return exponents(Family::wide); }},
    {"extreme", [] { return exponents(Family::extreme); }},
    {"mixture", [] { return exponents(Family::mixture); }},
});

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(Pictures, AreWhatTheGeneratorsMake) {
  const std::string folder = std::string(PLUMB_SOURCE_DIR) + "/docs/degeneracies/";
  for (const auto& [name, draw] : pictures) {
    const std::string path = folder + name + ".svg", drawn = draw().text();
    if (std::getenv("PLUMB_WRITE_PICTURES") != nullptr) std::ofstream(path, std::ios::binary) << drawn;
    EXPECT_EQ(read(path), drawn) << "run this test with PLUMB_WRITE_PICTURES=1 to draw " << path << " anew";
  }
}

TEST(Pictures, AreAllInTheCatalogWithEveryFamily) {
  const std::string catalog = read(std::string(PLUMB_SOURCE_DIR) + "/docs/degeneracies.md");
  for (const auto& [name, draw] : pictures) {
    EXPECT_NE(catalog.find("degeneracies/" + name + ".svg"), std::string::npos) << name;
  }
  for (const auto& info : plumb::families) {
    EXPECT_NE(catalog.find("## " + std::string(info.name) + "\n"), std::string::npos) << info.name;
    EXPECT_NE(catalog.find(info.about), std::string::npos) << info.about;
  }
  for (const auto& info : plumb::clouds) {
    EXPECT_NE(catalog.find("- `" + std::string(info.name) + "`: " + std::string(info.about)), std::string::npos)
        << info.about;
  }
  const auto listed = [&](std::string_view name, std::string_view about) {
    const std::string line = std::string("- `").append(name).append("`: ").append(about);
    EXPECT_NE(catalog.find(line), std::string::npos) << line;
  };
  for (const auto& info : plumb::degenerate::shape_kinds) listed(info.name, info.layout);
  for (const auto& info : plumb::degenerate::forms) listed(info.name, info.about);
  for (const auto& info : plumb::degenerate::positions) listed(info.name, info.about);
}

}  // namespace
