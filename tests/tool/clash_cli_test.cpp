// `plumb clash` as a user meets it: parts of folders, OBJ objects and glTF nodes, what is told of each pair, rules, and
// what cannot be read.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "surface/file/zip_archive.hpp"
#include "tool/clash/rules.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

/// A plate, a bar through it, a lid on it, a rod that is near it, twice; and notes.
std::string with_parts(const Folder& folder) {
  std::filesystem::create_directory(folder / "parts");
  write_mesh(folder / "parts/plate.obj", solids::box({0, 0, 0}, {4, 4, 1}));
  write_mesh(folder / "parts/bar.obj", solids::box({1, 1, -1}, {2, 2, 2}));
  write_mesh(folder / "parts/lid.stl", solids::box({0, 0, 1}, {4, 0.5, 2}));
  write_mesh(folder / "parts/rod.off", solids::box({0, 4.25, 0}, {4, 4.5, 0.25}));
  std::filesystem::create_directory(folder / "parts/more");
  write_mesh(folder / "parts/more/rod.off", solids::box({0, 4.25, 0}, {4, 4.5, 0.25}));
  std::ofstream(folder / "parts/notes.txt") << "none\n";
  return "cd " + (folder / "") + " && $PLUMB clash ";
}

std::vector<std::string> told(const json& report) {
  std::vector<std::string> lines;
  for (const json& c : report.at("clashes"))
    lines.push_back(c.at("part_a").get<std::string>() + " " + c.at("part_b").get<std::string>() + ": " +
                    c.at("word").get<std::string>());
  return lines;
}

TEST(ClashCommand, TellsWhatIsInTheWay) {
  const Folder folder;
  const std::string at = with_parts(folder);
  const Outcome o = run(at + "parts --clearance 0.25 --json out.json --csv out.csv");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("bar - plate: piercing through at ("), HasSubstr("volume 1, depth 2\n"),
                           HasSubstr("lid - plate: touching"), HasSubstr("rod - rod#2: duplicate"),
                           HasSubstr("rod - plate: within clearance at (0, 4.25, 0)"), HasSubstr(", distance 0.25\n"),
                           HasSubstr("5 parts, 5 pairs in reach: 2 within clearance, 1 touching, 1 piercing through, 1 "
                                     "duplicate\n")));
  const json report = json::parse(content(folder / "out.json"));
  EXPECT_THAT(told(report),
              testing::ElementsAre("bar plate: piercing through", "lid plate: touching", "rod plate: within clearance",
                                   "rod rod#2: duplicate", "plate rod#2: within clearance"));
  EXPECT_EQ(report.at("assembly").size(), 5U);
  EXPECT_EQ(report.at("passed_over"), json({"parts/notes.txt"}));
  const std::string csv = content(folder / "out.csv");
  EXPECT_THAT(csv, StartsWith("part_a,part_b,word,x,y,z,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_EQ(run(at + "parts --quiet --fail-on-found").code, 1);
  EXPECT_EQ(run(at + "parts --quiet --threads 1 --json again.json").code, 0);
}

TEST(ClashCommand, KeepsRules) {
  const Folder folder;
  const std::string at = with_parts(folder);
  const auto listed = [&](const std::string& options) {
    const Outcome o = run(at + "parts --json - " + options);
    EXPECT_EQ(o.code, 0) << o.err;
    return told(json::parse(o.out));
  };
  using testing::ElementsAre;
  EXPECT_THAT(listed(""), ElementsAre("bar plate: piercing through", "lid plate: touching", "rod rod#2: duplicate"));
  EXPECT_THAT(listed("--ignore touching --ignore duplicate"), ElementsAre("bar plate: piercing through"));
  EXPECT_THAT(listed("--rule 'plate,b?r: skip' --rule '*,lid: ignore touching,enclosed'"),
              ElementsAre("rod rod#2: duplicate"));
  EXPECT_THAT(listed("--ignore touching --rule 'ro*,pl*: clearance 0.25' --rule 'bar,*: ignore piercing'"),
              ElementsAre("rod plate: within clearance", "rod rod#2: duplicate", "plate rod#2: within clearance"));
  EXPECT_THAT(listed("--ignore touching --clearance 9 --rule '*,*: clearance 0' --rule 'bar,*: skip'"),
              ElementsAre("rod rod#2: duplicate"));
  for (const std::string rule : {"x", "a: skip", "a,b skip", ",b: skip", "a,b: clearance", "a,b: clearance -1",
                                 "a,b: ignore nothing", "a,b: ignore", "a,b: forget"}) {
    const Outcome o = run(at + "parts --rule '" + rule + "'");
    EXPECT_EQ(o.code, 2) << rule;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: --rule '" + rule + "': "), HasSubstr("write it like"))) << rule;
  }
}

TEST(ClashCommand, TakesPartsOfOneFile) {
  const Folder folder;
  const std::string box = "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
  const auto corners = [](int from, int to) {
    std::string text;
    for (const int z : {from, to})
      for (const int y : {from, to})
        for (const int x : {from, to})
          text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    return text;
  };
  std::ofstream(folder / "two.obj") << "o case\n" << corners(0, 4) << box << "o core\n" << corners(1, 2) << box;
  const Outcome o = run("$PLUMB clash " + (folder / "two.obj"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("case - core: enclosed at (1, 1, 1), core in case, volume 1, depth 2\n"));
  EXPECT_THAT(run("$PLUMB clash -", content(folder / "two.obj")).out, HasSubstr("case - core: enclosed"));
}

TEST(ClashCommand, TellsWhatCannotBeRead) {
  const Folder folder;
  const std::string at = with_parts(folder);
  std::ofstream(folder / "parts/bad.obj") << "v 0 0 0\nf 1 2 3\n";
  const Outcome o = run(at + "parts --json out.json");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("parts/bad.obj:2: "));
  EXPECT_THAT(o.out, HasSubstr("bar - plate: piercing through"));
  const json report = json::parse(content(folder / "out.json"));
  ASSERT_EQ(report.at("not_read").size(), 1U);
  EXPECT_EQ(report.at("not_read")[0].at("mesh"), "parts/bad.obj");
  EXPECT_EQ(report.at("assembly").size(), 5U);
  EXPECT_EQ(run(at + "parts parts/bad.obj --json named.json").code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "named.json"));
  EXPECT_THAT(run(at).err, HasSubstr("no assembly is named"));
  // A node of a glTF whose mesh is not there: the other is asked, and it is told by its name.
  std::ofstream(folder / "arm.gltf")
      << R"({"asset": {"version": "2.0"}, "nodes": [{"name": "nut", "mesh": 0}, {"name": "bolt", "mesh": 1}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}, {"primitives": [{"attributes": {"POSITION": 9}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "zeros.bin"}]})";
  std::ofstream(folder / "zeros.bin") << std::string(36, '\0');
  const Outcome arm = run(at + "arm.gltf --json arm.json");
  EXPECT_EQ(arm.code, 2);
  EXPECT_THAT(arm.err, HasSubstr("bolt: arm.gltf: "));
  const json said = json::parse(content(folder / "arm.json"));
  EXPECT_EQ(said.at("assembly")[0].at("part_name"), "nut");
  EXPECT_EQ(said.at("not_read")[0].at("mesh"), "arm.gltf: bolt");
}

/// The names of the elements in an element, in order.
std::vector<std::string> children(const pugi::xml_node& of) {
  std::vector<std::string> names;
  for (const pugi::xml_node& n : of.children()) names.emplace_back(n.name());
  return names;
}

// Elements and their order as version.xsd, markup.xsd and visinfo.xsd of BCF 2.1 have them.
TEST(ClashCommand, WritesTopicsOfBcf) {
  const Folder folder;
  const std::string at = with_parts(folder);
  std::filesystem::rename(folder / "parts/lid.stl", folder / "parts/a&b <lid>.stl");
  ASSERT_EQ(run(at + "parts --ignore duplicate --bcf out.bcf --json out.json").code, 0);
  const std::string bytes = content(folder / "out.bcf");
  surface::ZipArchive archive(bytes, "out.bcf", 1U << 20U);
  const auto document = [&](const std::string& name) {
    pugi::xml_document made;
    const auto text = archive.entry(name);
    EXPECT_TRUE(text && made.load_buffer(text->data(), text->size())) << name;
    return made;
  };
  const auto version = document("bcf.version");
  EXPECT_STREQ(version.child("Version").attribute("VersionId").value(), "2.1");
  // Folders stand in the archive's directory by their names.
  std::set<std::string> topics;
  const std::string end = "/markup.bcf";
  for (std::size_t i = bytes.find(end); i != std::string::npos; i = bytes.find(end, i + 1))
    topics.insert(bytes.substr(i - 36, 36));
  const json report = json::parse(content(folder / "out.json"));
  ASSERT_EQ(topics.size(), report.at("clashes").size());
  std::set<std::string> titles;
  for (const std::string& topic : topics) {
    EXPECT_THAT(topic, testing::MatchesRegex("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}"));
    const auto markup = document(topic + "/markup.bcf"), view = document(topic + "/viewpoint.bcfv");
    EXPECT_THAT(children(markup.child("Markup")), testing::ElementsAre("Topic", "Viewpoints"));
    const auto of = markup.child("Markup").child("Topic");
    EXPECT_EQ(of.attribute("Guid").value(), topic);
    EXPECT_THAT(children(of), testing::ElementsAre("Title", "CreationDate", "CreationAuthor", "Description"));
    titles.insert(of.child("Title").text().get());
    const auto shown = view.child("VisualizationInfo");
    EXPECT_STREQ(markup.child("Markup").child("Viewpoints").attribute("Guid").value(), shown.attribute("Guid").value());
    EXPECT_THAT(children(shown), testing::ElementsAre("Components", "PerspectiveCamera"));
    EXPECT_THAT(children(shown.child("Components")), testing::ElementsAre("Selection", "Visibility"));
    EXPECT_THAT(children(shown.child("PerspectiveCamera")),
                testing::ElementsAre("CameraViewPoint", "CameraDirection", "CameraUpVector", "FieldOfView"));
  }
  EXPECT_THAT(titles, testing::Contains("a&b <lid> - plate: touching"));
}

TEST(ClashPatterns, MatchNames) {
  for (const auto& [pattern, name, expected] :
       std::vector<std::tuple<std::string, std::string, bool>>{{"*", "", true},
                                                               {"", "", true},
                                                               {"", "a", false},
                                                               {"a*", "abc", true},
                                                               {"*c", "abcc", true},
                                                               {"a?c", "abc", true},
                                                               {"a?c", "ac", false},
                                                               {"*ab*ab", "abxabab", true},
                                                               {"*ab*ab", "abxabb", false},
                                                               {"a", "A", false}})
    EXPECT_EQ(matches_pattern(pattern, name), expected) << pattern << " " << name;
}

}  // namespace
}  // namespace plumb::tool
