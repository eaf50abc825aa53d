// Do `plumb pairs` and `plumb nearest` tell what a search through all boxes and points finds, from every kind of file,
// draw it, and refuse what holds none?
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/pairs/method_names.hpp"
#include "tool/row_files.hpp"
#include "tool/rows/npy.hpp"
#include "tool/run_program.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

using Rows = std::vector<std::vector<double>>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;
using nlohmann::json;

std::string csv_of(const Rows& rows) {
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      std::array<char, 40> number{};
      std::snprintf(number.data(), number.size(), "%s%.17g", k == 0 ? "" : ",", row[k]);
      text += number.data();
    }
    text += "\n";
  }
  return text;
}

void write(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// The number that stands before these words, without its commas.
std::size_t number_before(const std::string& text, const std::string& words) {
  const std::size_t end = text.find(words), begin = text.find_last_of(" >", end - 1) + 1;
  if (end == std::string::npos) return 0;
  std::string digits = text.substr(begin, end - begin);
  std::erase(digits, ',');
  return std::stoul(digits);
}

double whole_number(std::mt19937& draw, std::uint32_t below) { return static_cast<std::uint32_t>(draw()) % below; }

/// Of few whole numbers, so that many touch; rows of min and max.
Rows random_boxes(std::size_t many, std::size_t axes, std::uint32_t seed) {
  std::mt19937 draw(seed);
  Rows rows;
  for (std::size_t i = 0; i < many; ++i) {
    std::vector<double> row(2 * axes);
    for (std::size_t k = 0; k < axes; ++k) {
      row[k] = whole_number(draw, 24);
      row[k + axes] = row[k] + whole_number(draw, 4);
    }
    rows.push_back(row);
  }
  return rows;
}

bool boxes_meet(const std::vector<double>& a, const std::vector<double>& b) {
  bool meet = true;
  for (std::size_t k = 0; k < a.size() / 2; ++k) meet &= a[k] <= b[k + a.size() / 2] && b[k] <= a[k + a.size() / 2];
  return meet;
}

std::vector<Pair> pairs_by_hand(const Rows& a, const Rows& b, bool one_set) {
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = one_set ? i + 1 : 0; j < b.size(); ++j) {
      if (boxes_meet(a[i], b[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

std::vector<Pair> pairs_in(const json& said) {
  std::vector<Pair> pairs;
  for (const json& p : said.at("box_pairs")) pairs.emplace_back(p[0], p[1]);
  std::ranges::sort(pairs);
  return pairs;
}

/// The numbers of an array that the program wrote, which must have this type and shape.
std::vector<std::int64_t> numbers_in(const std::string& bytes, const std::string& type, const std::string& shape) {
  expect_text(bytes, {std::string("\x93NUMPY\x01\0", 8)});
  const std::size_t length = static_cast<unsigned char>(bytes.at(8)) + 256U * static_cast<unsigned char>(bytes.at(9));
  EXPECT_EQ((10 + length) % 64, 0U);
  expect_text(bytes.substr(10, length),
              {"{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }"});
  EXPECT_EQ(bytes.at(9 + length), '\n');
  std::vector<std::int64_t> numbers((bytes.size() - 10 - length) / 8);
  std::memcpy(numbers.data(), bytes.data() + 10 + length, numbers.size() * 8);
  return numbers;
}

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t many = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++many;
  return many;
}

std::string at(const Folder& folder, const std::string& command) {
  return "cd " + (folder / "") + " && $PLUMB " + command + " ";
}

TEST(Pairs, AreCountedExactlyWhereBoxesTouch) {
  const Folder folder;
  Rows cubes;
  for (int i = 0; i < 27; ++i) {
    const double x = i % 3, y = i / 3 % 3, z = i / 9;
    cubes.push_back({x, y, z, x + 1, y + 1, z + 1});
  }
  cubes[13][3] = std::nextafter(cubes[13][3], 9);
  write(folder / "cubes.csv", "x0,y0,z0,x1,y1,z1\n" + csv_of(cubes));
  const std::string pairs = at(folder, "pairs");
  expect_text(run(pairs + "cubes.csv").out, {"cubes.csv: 27 boxes in space\n",
                                             "158 pairs meet: 157 touch, 1 overlaps\n", "by the method brute-force\n"});
  expect_text(run(pairs + "--no-touching --all cubes.csv").out,
              {"1 pair overlaps\n", "        13         14 overlap\n"});
  cubes[13][3] = 2;
  expect_text(run(pairs + "--no-touching -", csv_of(cubes)).out,
              {"standard input: 27 boxes", "no two boxes overlap\n"});
  const Outcome inexact = run(pairs + "-", "0.1 0 1 1\n# not this\n\n1;0;1;1");
  expect_text(inexact.out,
              {"1 of 2 boxes are given by decimals that are no doubles", "1 pair meets: 1 touches, 0 overlap\n"});
}

TEST(Pairs, AreTheSameByEveryMethodAndNumberOfThreads) {
  const Folder folder;
  for (const std::size_t axes : {2U, 3U}) {
    const Rows rows = random_boxes(axes == 2 ? 150 : 600, axes, 7);
    const std::vector<Pair> expected = pairs_by_hand(rows, rows, true);
    ASSERT_GT(expected.size(), 200U);
    write(folder / "boxes.csv", csv_of(rows));
    for (const BroadPhaseMethod m : broad_phase_methods) {
      const std::string name = command_name(m);
      const std::string line = at(folder, "pairs") + "boxes.csv --json --method " + name;
      const json one = json::parse(run(line + " --threads 1").out);
      EXPECT_EQ(one.at("method"), name);
      const bool by_itself = m == BroadPhaseMethod::automatic;
      EXPECT_EQ(one.at("method_taken"), by_itself ? "sort-and-sweep" : name);
      EXPECT_EQ(one.at("sets")[0].at("dimension"), axes);
      EXPECT_EQ(pairs_in(one), expected) << name;
      if (axes == 3 && m <= BroadPhaseMethod::brute_force) {
        EXPECT_EQ(json::parse(run(line + " --threads 2").out).at("box_pairs"), one.at("box_pairs")) << name;
      }
      EXPECT_EQ(one.at("touching").get<std::size_t>() + one.at("overlapping").get<std::size_t>(), expected.size());
      EXPECT_GT(one.at("touching"), 100);
      EXPECT_GT(one.at("overlapping"), 20);
    }
  }
  const json counts = json::parse(run(at(folder, "pairs") + "boxes.csv --no-touching --count --json").out);
  EXPECT_FALSE(counts.contains("box_pairs"));
  EXPECT_FALSE(counts.contains("touching"));
}

TEST(Pairs, OfTwoSetsAndOfMeshesGoIntoAnArray) {
  const Folder folder;
  const TriangleMesh mesh = solids::torus(4, 1, 20, 10);
  write_mesh(folder / "torus.obj", mesh);
  Rows triangles;
  for (const auto& corners : mesh.triangles) {
    std::vector<double> box{9, 9, 9, -9, -9, -9};
    for (const std::uint32_t v : corners) {
      const Point3& p = mesh.vertices[v];
      const std::array x{p.x, p.y, p.z};
      for (std::size_t k = 0; k < 3; ++k) box[k] = std::min(box[k], x[k]), box[k + 3] = std::max(box[k + 3], x[k]);
    }
    triangles.push_back(box);
  }
  const Rows boxes = {{-9, -9, -9, 0, 0, 9}, {100, 0, 0, 101, 1, 1}, {4, 0, 1, 4, 0, 1}};
  write(folder / "boxes.csv", csv_of(boxes));
  const std::vector<Pair> expected = pairs_by_hand(triangles, boxes, false);
  ASSERT_GT(expected.size(), 50U);
  const Outcome o = run(at(folder, "pairs") + "torus.obj boxes.csv --out pairs.npy");
  expect_text(o.out, {"torus.obj: 200 vertices, 400 triangles, closed; the boxes of its triangles\n",
                      "boxes.csv: 3 boxes in space\n"});
  const auto shape = "(" + std::to_string(expected.size()) + ", 2)";
  const std::vector<std::int64_t> numbers = numbers_in(content(folder / "pairs.npy"), "<i8", shape);
  ASSERT_EQ(numbers.size(), 2 * expected.size());
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < numbers.size(); i += 2) pairs.emplace_back(numbers[i], numbers[i + 1]);
  std::ranges::sort(pairs);
  EXPECT_EQ(pairs, expected);
  EXPECT_EQ(pairs_in(json::parse(run(at(folder, "pairs") + "- --json <" + (folder / "torus.obj")).out)),
            pairs_by_hand(triangles, triangles, true));
}

TEST(Pairs, AreDrawnWithTheColumnsOfTheSweep) {
  const Folder folder;
  const Rows rows = random_boxes(400, 2, 3);
  write(folder / "boxes.csv", csv_of(rows));
  const std::string line = at(folder, "pairs") + "boxes.csv --svg ";
  const std::string svg = run(line + "- --method swept-columns").out;
  expect_text(svg,
              {"<svg", "<title>The boxes of boxes.csv, by swept-columns</title>", "a wall of columns", "</svg>\n"});
  EXPECT_EQ(times(svg, "<line class=\"wall\"") + 1, number_before(svg, " columns, each swept along "));
  EXPECT_GT(times(svg, "<line class=\"wall\""), 1U);
  const std::string boxes = svg.substr(svg.find("<g id=\"boxes\""));
  EXPECT_EQ(times(boxes, "<rect class=\""), rows.size());
  std::size_t alone = 0;
  for (const auto& a : rows)
    alone += std::ranges::count_if(rows, [&](const auto& b) { return boxes_meet(a, b); }) == 1 ? 1 : 0;
  EXPECT_EQ(times(boxes, "<rect class=\"alone\""), alone);
  expect_text(run(line + "- --method brute-force").out, {"nothing divides the boxes"});
  for (const std::string extreme :
       {"-1e308 -1e308 -1e308 1e308 1e308 1e308\n0 0 0 5e-324 5e-324 5e-324\n",
        "-1.7e308 -1.7e308 1.7e308 1.7e308\n0 0 1.7e308 1.7e308\n", "0 0 0 0\n0 0 0 0\n", "1 1 1 1\n0 0 5e-324 1\n"}) {
    const std::string drawn = run(at(folder, "pairs") + "--svg - --method swept-columns -", extreme).out;
    expect_text(drawn, {"<svg"}, {"nan", "inf", "=\"-"}, extreme);
    if (extreme.starts_with("-1.7"))
      expect_text(drawn, {"width=\"720.0\" height=\"720.0\"", "width=\"360.0\" height=\"360.0\""});
  }
  write(folder / "kept.svg", "precious");
  expect_text(run(line + "kept.svg").err, {"--svg: kept.svg is there already and is kept"});
  EXPECT_EQ(content(folder / "kept.svg"), "precious");
  EXPECT_EQ(run(line + "kept.svg --overwrite").code, 0);
  expect_text(content(folder / "kept.svg"), {"<svg"});
}

/// Of the cells of this side that boxes of the plane reach into.
std::size_t cells_by_hand(const Rows& rows, double side) {
  std::set<std::pair<double, double>> cells;
  for (const auto& r : rows) {
    for (double x = std::floor(r[0] / side); x <= std::floor(r[2] / side); ++x) {
      for (double y = std::floor(r[1] / side); y <= std::floor(r[3] / side); ++y) cells.emplace(x, y);
    }
  }
  return cells.size();
}

TEST(Pairs, AreDrawnWithTheStructureOfTheMethod) {
  const Folder folder;
  const Rows rows = random_boxes(300, 2, 4);
  write(folder / "boxes.csv", csv_of(rows));
  write(folder / "space.csv", csv_of(random_boxes(60, 3, 4)));
  write(folder / "far.csv", "-1.7e308 -1.7e308 1.7e308 1.7e308\n0 0 0 5e-324\n1e-300 1 1e300 1\n");
  for (const BroadPhaseMethod method : broad_phase_methods) {
    const std::string name = command_name(method);
    const auto drawn = [&](const std::string& files) {
      const std::string svg = run(at(folder, "pairs") + files + " --svg - --method " + name).out;
      expect_text(svg, {"<svg", "</svg>\n"}, {"nan", "inf"}, name + " of " + files);
      return svg;
    };
    const std::string svg = drawn("boxes.csv"), over = svg.substr(svg.find("<g id=\"boxes\""));
    const std::size_t cells = times(over, "<rect class=\"cell\""), walls = times(over, "<line class=\"wall\"");
    const bool is_even = name.ends_with("ed-grid") || name == "static-grid" || name == "implicit-grid";
    if (method != BroadPhaseMethod::automatic) expect_text(svg, {", by " + name + "</title>"});
    if (is_even) {
      EXPECT_EQ(cells, number_before(svg, " cells of side ")) << name;
      EXPECT_EQ(cells, cells_by_hand(rows, std::stod(svg.substr(svg.find(" cells of side ") + 15)))) << name;
    } else if (name.ends_with("-grid")) {
      EXPECT_EQ(cells, number_before(svg, " cells of ")) << name;
      EXPECT_EQ(times(over, "<g id=\"level-"), number_before(svg, " sides, each twice the next")) << name;
    } else if (name == "octree" || name == "octree-of-leaves") {
      EXPECT_EQ(number_before(svg, " cells, inner ones") % 4, 1U) << name;
      EXPECT_GT(cells, 4U) << name;
    } else if (name == "loose-octree") {
      EXPECT_EQ(cells, number_before(svg, " cells that have boxes")) << name;
    } else if (name == "box-tree") {
      EXPECT_EQ(cells, 2 * number_before(svg, " of which are leaves") - 1) << name;
    } else if (name == "kd-tree") {
      EXPECT_EQ(walls + 1, number_before(svg, " leaves; a box")) << name;
    }
    EXPECT_EQ(cells > 0, is_even || name.ends_with("tree") ? name != "kd-tree"
                                                           : name.ends_with("-grid") || name.ends_with("-leaves"))
        << name;
    const std::size_t axes = name == "sort-and-sweep" || name == "automatic" || name == "lists-along-one" ? 1
                             : name.starts_with("lists")                                                  ? 2
                                                                                                          : 0;
    EXPECT_EQ(times(svg, "<rect class=\"bar "), axes * rows.size()) << name;
    if (walls > 0 || name == "lists-along-three" || name == "box-tree" || name == "hashed-grid")
      expect_text(drawn("space.csv"), {"; seen along "});
    drawn("far.csv boxes.csv");
  }
}

TEST(Pairs, AreRefusedOfWhatHoldsNoBoxes) {
  const Folder folder;
  const std::string one = bytes_of(0.0, false) + bytes_of(0.0, false) + bytes_of(1.0, false) + bytes_of(1.0, false);
  const std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 4), }\n";
  write(folder / "plane.csv", "0,0,1,1\n");
  write(folder / "space.csv", "0,0,0,1,1,1\n");
  write(folder / "five.csv", "0,0,1,1\n\n1,1,2,2,3\n");
  write(folder / "mixed.csv", "0,0,1,1\n0,0,0,1,1,1\n");
  write(folder / "word.csv", "0,0,1,1\n0,0,\033[31mone,1\n");
  write(folder / "nan.csv", "nan,0,1,1\n");
  write(folder / "quoted.csv", "\"0\",\"0\",\"1\",\"1\"\n0,0,1,1\n");
  write(folder / "gap.csv", "0,0,1,1\n0,,1,1\n");
  write(folder / "more.csv", "0,0,1,1,\n");
  write(folder / "boxes.npz", "PK");
  write(folder / "turned.csv", "x0,y0,x1,y1\n0,0,1,1\n0,3,1,1\n");
  write(folder / "empty.csv", "");
  write(folder / "header.csv", "x0,y0,x1,y1\n");
  write(folder / "text.npy", "0,0,1,1\n");
  write(folder / "nan.npy", npy_with(header, one.substr(8) + bytes_of(std::nan(""), false)));
  write(folder / "turned.npy", npy_with(header, one.substr(8) + bytes_of(-1.0, false)));
  write(folder / "row.npy", npy_with("{'descr': '<f8', 'fortran_order': False, 'shape': (4,), }\n", one));
  const std::pair<const char*, const char*> refusals[] = {
      {"", "one file of boxes is needed, or two"},
      {"plane.csv plane.csv plane.csv", "one file of boxes is needed, or two"},
      {"plane.csv space.csv", "the boxes of plane.csv lie in the plane, those of space.csv in space"},
      {"five.csv", "five.csv, line 3: this has 5 numbers; a box has 4 (min x, min y, max x, max y) or 6"},
      {"mixed.csv", "mixed.csv, line 2: this has 6 numbers, and line 1 has 4"},
      {"word.csv", "word.csv, line 2: '?[31mone' is not a decimal number"},
      {"nan.csv", "nan.csv, line 1: 'nan' is not a decimal number"},
      {"quoted.csv", "quoted.csv, line 1: '\"0\"' is not a decimal number"},
      {"gap.csv", "gap.csv, line 2: number 2 is missing"},
      {"more.csv", "more.csv, line 1: number 5 is missing"},
      {"boxes.npz", "boxes.npz: this is an archive of NumPy's arrays (.npz)"},
      {"turned.csv", "turned.csv, line 3: min y 3 is above max y 1"},
      {"empty.csv", "empty.csv: the file is empty"},
      {"header.csv", "header.csv: there is no row of numbers in it"},
      {"none.csv", "cannot read none.csv: No such file"},
      {"none.obj", "none.obj: there is no such file"},
      {".", "cannot read .: Is a directory"},
      {"- -", "'-' stands twice"},
      {"text.npy", "text.npy: this is no NumPy file"},
      {"nan.npy", "nan.npy, row 0: max y is nan, not a real number"},
      {"turned.npy", "turned.npy, row 0: min y 1 is above max y -1"},
      {"row.npy", "the array has the shape (4,)"},
      {"--method best plane.csv", "best not in {automatic,"},
      {"--json plane.csv space.csv", "--json takes the name of the file to write, and plane.csv is that of a table"},
      {"plane.csv --out part.stl", "part.stl"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at(folder, "pairs") + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    expect_text(o.err, {"plumb: ", words}, {}, line);
  }
}

/// By whole numbers, which squares and sums leave exact: square, number.
std::vector<std::pair<double, std::uint32_t>> by_distance(const Rows& points, const std::vector<double>& query) {
  std::vector<std::pair<double, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    double square = 0;
    for (std::size_t k = 0; k < query.size(); ++k) square += (points[i][k] - query[k]) * (points[i][k] - query[k]);
    all.emplace_back(square, i);
  }
  std::ranges::sort(all);
  return all;
}

TEST(Nearest, TellsTheNearestOfTheLowestNumbers) {
  const Folder folder;
  for (const std::size_t axes : {2U, 3U}) {
    std::mt19937 draw(11);
    Rows points, queries;
    for (int i = 0; i < 300; ++i) {
      std::vector<double> p(axes);
      for (double& x : p) x = whole_number(draw, 12);
      (i % 10 == 0 ? queries : points).push_back(p);
    }
    write(folder / "points.csv", csv_of(points));
    write(folder / "queries.csv", csv_of(queries));
    const std::string nearest = at(folder, "nearest") + "points.csv queries.csv ";
    const json three = json::parse(run(nearest + "-k 3 --json --threads 2").out);
    const json ties = json::parse(run(nearest + "-k 3 --ties --json").out);
    const json within = json::parse(run(nearest + "--within 3 --json").out);
    std::size_t tied = 0, found = 0;
    for (std::size_t q = 0; q < queries.size(); ++q) {
      const auto all = by_distance(points, queries[q]);
      json indices, distances, as_near, inside;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [square, number] = all[i];
        if (i < 3) indices.push_back(number), distances.push_back(std::sqrt(square));
        if (square <= all[2].first) as_near.push_back(number);
        if (square <= 9) inside.push_back(number);
      }
      if (!inside.is_null()) std::sort(inside.begin(), inside.end());
      EXPECT_EQ(three.at("indices")[q], indices) << q;
      EXPECT_EQ(three.at("distances")[q], distances) << q;
      EXPECT_EQ(ties.at("indices")[q], as_near) << q;
      EXPECT_EQ(within.at("indices")[q], inside.is_null() ? json::array() : inside) << q;
      tied += as_near.size() > 3 ? 1 : 0;
      found += inside.size();
    }
    EXPECT_GT(tied, 5U);
    EXPECT_EQ(ties.at("queries_with_ties"), tied);
    expect_text(run(nearest + "--within 3").out, {grouped(found) + " points within 3 of a query\n"});
  }
}

TEST(Nearest, WritesArraysAndLists) {
  const Folder folder;
  write(folder / "line.csv", "x,y\n0,0\n3,4\n6,8\n0,0\n");
  write(folder / "queries.csv", "0,0\n6,7\n");
  const std::string nearest = at(folder, "nearest") + "line.csv queries.csv ";
  expect_text(run(nearest).out, {"line.csv: 4 points in the plane\nqueries.csv: 2 queries in the plane\n",
                                 "         0          0  0\n         1          2  1\n"});
  EXPECT_EQ(run(nearest + "-q -k 2 --out near.npy --distances far.npy").code, 0);
  EXPECT_EQ(numbers_in(content(folder / "near.npy"), "<i8", "(2, 2)"), (std::vector<std::int64_t>{0, 3, 2, 1}));
  const std::vector<std::int64_t> far = numbers_in(content(folder / "far.npy"), "<f8", "(2, 2)");
  EXPECT_EQ(far[1], 0);
  EXPECT_EQ(std::bit_cast<double>(far[2]), 1);
  EXPECT_EQ(std::bit_cast<double>(far[3]), std::sqrt(18.0));
  EXPECT_EQ(run(nearest + "-q --ties --overwrite --out near.npy --distances far.npy").code, 0);
  EXPECT_EQ(numbers_in(content(folder / "near.npy"), "<i8", "(3, 2)"), (std::vector<std::int64_t>{0, 0, 0, 3, 1, 2}));
  EXPECT_EQ(numbers_in(content(folder / "far.npy"), "<f8", "(3,)").size(), 3U);
  // A ball is closed: 3, 4 is exactly 5 away, and no farther.
  expect_text(run(nearest + "--within 5").out, {"\n         0          1  5\n"});
  expect_text(run(nearest + "--within 4.9999999999999991").out, {}, {"\n         0          1"});
  write(folder / "empty.npy", npy_of(std::span<const double>(), std::array<std::size_t, 2>{0, 2}));
  expect_text(run(at(folder, "nearest") + "line.csv empty.npy").out, {"empty.npy: 0 queries in the plane\n"});
  write_mesh(folder / "box.obj", solids::box({0, 0, 0}, {1, 1, 1}));
  expect_text(run(at(folder, "nearest") + "-k 8 --all box.obj -", "0.75,1,1\n").out,
              {"box.obj: 8 points in space, the mesh's vertices\n", "  0.25\n"});
  expect_text(run(at(folder, "nearest") + "-k 4 line.csv line.csv").out, {"and 6 more; --all lists them\n"});
}

TEST(Nearest, DrawsThePlanesOfTheTree) {
  const Folder folder;
  Rows points;
  std::mt19937 draw(5);
  for (int i = 0; i < 100; ++i) points.push_back({whole_number(draw, 1000), whole_number(draw, 1000)});
  write(folder / "points.csv", csv_of(points));
  const std::string svg = run(at(folder, "nearest") + "-k 2 --svg - points.csv points.csv").out;
  expect_text(svg, {"<svg", "<title>The k-d tree of points.csv</title>",
                    "100 points in 16 leaves of a tree of 4 levels", "all planes, points and queries are drawn"});
  EXPECT_EQ(times(svg, "<line class=\"plane\""), 15U);
  EXPECT_EQ(times(svg, "<circle class=\"point\""), 100U);
  EXPECT_EQ(times(svg, "<circle class=\"query\""), 100U);
  EXPECT_EQ(times(svg, "<line class=\"found\""), 200U);
  for (const std::string extreme : {"-1.7e308 0 1\n1.7e308 5e-324 3\n0 0 0\n", "1 1\n1 1\n"}) {
    write(folder / "in", extreme);
    const std::string far = run(at(folder, "nearest") + "--within 1e308 --svg - in in").out;
    expect_text(far, {"<svg"}, {"nan", "inf"}, extreme);
  }
}

TEST(Nearest, RefusesWhatCannotBe) {
  const Folder folder;
  write(folder / "plane.csv", "0,0\n1,1\n");
  write(folder / "space.csv", "0,0,0\n");
  write(folder / "boxes.csv", "0,0,1,1\n");
  const std::pair<const char*, const char*> refusals[] = {
      {"plane.csv", "two files are needed, of points and of queries"},
      {"plane.csv space.csv", "the points of plane.csv lie in the plane, those of space.csv in space"},
      {"plane.csv boxes.csv", "boxes.csv, line 1: this has 4 numbers; a point has 2 (x, y) or 3 (x, y, z)"},
      {"-k 3 plane.csv plane.csv", "3 nearest of 2 points are asked for"},
      {"-k 0 plane.csv plane.csv", "-k"},
      {"-k 1 --within 1 plane.csv plane.csv", "-k and --within exclude each other"},
      {"--ties --within 1 plane.csv plane.csv", "--ties and --within exclude each other"},
      {"--within -1e-9 plane.csv plane.csv", "--within: -1e-9 is negative"},
      {"--within far plane.csv plane.csv", "'far' is not a decimal number"},
      {"plane.csv plane.csv --out a.npy --distances a.npy", "name the same output"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at(folder, "nearest") + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    expect_text(o.err, {"plumb: ", words}, {}, line);
  }
}

}  // namespace
}  // namespace plumb::tool
