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
#include "tool/browser.hpp"
#include "tool/clash/page.hpp"
#include "tool/clash/rules.hpp"
#include "tool/drawing/drawn_mesh.hpp"
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

TEST(ClashCommand, TellsVolumesAndWhyThereIsNone) {
  const Folder folder;
  const std::string at = with_parts(folder);
  TriangleMesh open = solids::box({3, 3, -1}, {3.5, 3.5, 2});
  open.triangles.pop_back();
  write_mesh(folder / "parts/tube.obj", open);
  const Outcome o = run(at + "parts --json out.json --csv out.csv");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("no volume: tube is not closed\n"));
  const std::string csv = content(folder / "out.csv");
  EXPECT_THAT(csv, AllOf(HasSubstr(",meeting,why_no_volume\n"), HasSubstr("bar,plate,piercing through,"),
                         HasSubstr(",1,2,2,"), HasSubstr(",tube is not closed\n")));
  std::size_t seen = 0;
  const auto look = [&](const json& report, const json& volume, const json& why_of_bar, const json& why_of_tube) {
    for (const json& c : report.at("clashes")) {
      const bool is_bar = c.at("part_a") == "bar", is_tube = c.at("part_a") == "tube" || c.at("part_b") == "tube";
      if (is_bar || is_tube) {
        EXPECT_EQ(c.at("volume"), is_bar ? volume : json());
        EXPECT_EQ(c.at("why_no_volume"), is_bar ? why_of_bar : why_of_tube);
      } else if (c.at("word") == "touching") {
        EXPECT_EQ(c.at("why_no_volume"), json()) << "nothing is in common inside";
      }
      seen += is_bar || is_tube ? 1U : 0U;
    }
  };
  look(json::parse(content(folder / "out.json")), 1.0, json(), "tube is not closed");
  const json unmeasured = json::parse(run(at + "parts --unmeasured --json -").out);
  look(unmeasured, json(), "it was not asked for", "it was not asked for");
  EXPECT_EQ(seen, 4U);
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

TEST(ClashCommand, APageShowsTheListBesideTheScene) {
  const Folder folder;
  const std::string at = with_parts(folder);
  // Names that would end a script, or hide its end, or end an attribute.
  const std::string hostile = "<!--<script>\"'&{}<b>";
  std::filesystem::rename(folder / "parts/lid.stl", std::filesystem::path(folder / "parts") / (hostile + ".stl"));
  ASSERT_EQ(run(at + "parts --clearance 0.25 --page page.html --json out.json").code, 0);
  const std::string page = content(folder / "page.html");
  EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>"), testing::EndsWith("</html>\n"),
                          HasSubstr("5 parts, 5 pairs in reach: 2 within clearance"),
                          HasSubstr("<button type=\"button\">bar - plate</button></td><td>piercing through</td>")));
  EXPECT_THAT(page, testing::Not(testing::AnyOf(HasSubstr("http:"), HasSubstr("https:"), HasSubstr("src=\""),
                                                HasSubstr("<!--"), HasSubstr("missing, for so many"))));
  const Outcome again = run(at + "parts --page page.html");
  EXPECT_EQ(again.code, 2) << "no file is replaced that was not to be";
  EXPECT_THAT(again.err, AllOf(HasSubstr("page.html"), HasSubstr("--overwrite")));
  EXPECT_EQ(content(folder / "page.html"), page);
  EXPECT_EQ(run(at + "parts --ignore touching --page page.html --overwrite").code, 0);
  EXPECT_NE(content(folder / "page.html"), page);
  if (!has_browser()) return;
  const Outcome shown = in_browser(page, R"(addEventListener('DOMContentLoaded', () => {
const canvas = document.getElementById('scene'), find = id => document.getElementById(id);
const painted = () => {
  const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const count = { orange: 0, blue: 0, yellow: 0, grey: 0, y: 0 };
  for (let i = 0; i < data.length; i += 4) {
    const r = data[i], g = data[i + 1], b = data[i + 2], a = data[i + 3];
    if (!a) continue;
    if (r > 3 * g / 2 && b < 20) ++count.orange, count.y += Math.floor(i / 4 / canvas.width);
    if (b > 2 * r && r < 20 && b > 60) ++count.blue;
    if (r > 60 && g > r * 0.7 && b < r / 3) ++count.yellow;
    if (r > 40 && b > r && b < 1.3 * r) ++count.grey;
  }
  return count;
};
const rows = [...document.querySelectorAll('tr[data-clash]')], told = () => find('told').textContent, said = [];
const event = (id, name, more = {}) => find(id).dispatchEvent(Object.assign(new Event(name), more));
const bar = rows.find(row => row.textContent.startsWith('bar - plate'));
said.push(rows.length, rows.some(row => row.querySelector('button').textContent === `\u003c!--\u003cscript>"'&{}<b> - plate`));
bar.querySelector('button').click();
const before = painted();
said.push(told().startsWith('bar - plate: piercing through at (') && told().endsWith(', volume 1, depth 2'), bar.classList.contains('fails'));
said.push(before.orange > 200, before.blue > 200, before.yellow > 200, before.grey > 20, canvas.mark[0] === 380 && canvas.mark[1] === 280);
find('others').value = 'hidden', event('others', 'input');
said.push(painted().grey === 0, find('moved').textContent.includes('free'));
find('apart').value = 100, event('apart', 'input');
const after = painted();
said.push(find('moved').textContent.endsWith(', free'), Math.abs(after.y / after.orange - before.y / before.orange) > 30);
event('scene', 'keydown', { key: 'n' });
said.push(told() !== '' && !told().startsWith('bar - plate'), find('apart').value);
event('scene', 'keydown', { key: 'ArrowLeft' });
document.querySelector('input[value="touching"]').click();
said.push(rows.filter(row => row.hidden).length);
find('all').click();
said.push(told() === '', painted().grey > 1000);
document.title = said.join();
});)");
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_THAT(shown.err, testing::Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(shown.out, HasSubstr("<title>5,true,true,true,true,true,true,true,true,true,false,true,true,true,0,1,"
                                   "true,true</title>"));
}

TEST(ClashPage, BoundsWhatIsDrawnAndSaysSo) {
  const std::vector<TriangleMesh> meshes{solids::torus(4, 1, 40, 20), solids::box({4, -1, -1}, {9, 1, 1}),
                                         solids::box({20, 0, 0}, {21, 1, 1})};
  ClashReport report;
  for (const TriangleMesh& m : meshes)
    report.parts.push_back({"part", "", m.vertices.size(), m.triangles.size(), true, 1});
  report.counts.assign(clash_kinds, 0);
  Clashes found = find_clashes(meshes);
  ASSERT_EQ(found.found.size(), 1U);
  report.clashes = {found.found[0], found.found[0]};
  const auto raw_of = [](const std::string& page) {
    const std::string begin = "id=\"raw\">";
    const std::size_t from = page.find(begin) + begin.size();
    return json::parse(page.substr(from, page.find("</script>", from) - from));
  };
  const std::string whole = clash_page(report, meshes), bounded = clash_page(report, meshes, {1, 200});
  EXPECT_EQ(raw_of(whole).at("shown").size(), 2U);
  EXPECT_EQ(raw_of(whole).at("parts").size(), 2U) << "what clashes alone";
  EXPECT_EQ(raw_of(whole).at("parts")[0].at("triangles").size(), 3 * meshes[0].triangles.size());
  EXPECT_THAT(bounded,
              AllOf(HasSubstr("and 1 more clashes"), HasSubstr("1 large part is drawn with triangles missing")));
  const json part = raw_of(bounded).at("parts")[0], clash = raw_of(bounded).at("shown")[0];
  const std::size_t told = std::min<std::size_t>(ClashReport::told, report.clashes[0].clash.meeting.size());
  EXPECT_LE(part.at("triangles").size(), 3 * (100 + told));
  EXPECT_GE(part.at("triangles").size(), 3 * 80U);
  // The triangles that meet are those of the mesh.
  std::set<std::uint32_t> expected;
  for (std::size_t i = 0; i < told; ++i) expected.insert(report.clashes[0].clash.meeting[i].a);
  ASSERT_EQ(clash.at("met_a").size(), expected.size());
  const DrawnCube cube(meshes);
  std::size_t i = 0;
  for (const std::uint32_t t : expected) {
    const std::size_t drawn = clash.at("met_a")[i++];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = part.at("triangles")[3 * drawn + k];
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(part.at("points")[3 * v + axis].get<double>(),
                  cube.of(meshes[0].vertices[meshes[0].triangles[t][k]])[axis]);
    }
  }
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

TEST(ClashCommand, TakesShardsOfAssemblies) {
  const Folder folder;
  with_parts(folder);
  const TriangleMesh plate = solids::box({0, 0, 0}, {4, 4, 1}), bar = solids::box({1, 1, -1}, {2, 2, 2});
  const auto object = [](const TriangleMesh& mesh, std::uint32_t before, const char* name) {
    std::string text = std::string("o ") + name + "\n";
    for (const Point3& p : mesh.vertices)
      text += "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const auto& [a, b, c] : mesh.triangles)
      text += "f " + std::to_string(a + before + 1) + " " + std::to_string(b + before + 1) + " " +
              std::to_string(c + before + 1) + "\n";
    return text;
  };
  std::ofstream(folder / "parts/machine.obj") << object(plate, 0, "plate") << object(bar, 8, "bar");
  std::ofstream(folder / "parts/broken.stl") << "solid none\nfacet\n";
  const std::string at = "cd " + (folder / "") + " && ", clash = at + "$PLUMB clash parts -q --ignore touching ";
  std::string first;
  for (const int n : {1, 2}) {
    const std::string out = "out" + std::to_string(n);
    for (int i = 1; i <= n; ++i)
      ASSERT_EQ(run(clash + "--out " + out + " --shard " + std::to_string(i) + "/" + std::to_string(n)).code, 0);
    const Outcome o = run(at + "$PLUMB collect " + out);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_THAT(o.out, AllOf(StartsWith("plumb clash of parts: 7 models in "), HasSubstr("piercing through"),
                             HasSubstr("machine.obj: clashing (piercing through): 1 piercing through\n"),
                             HasSubstr("broken.stl: unreadable: ")));
    const std::string digest = o.out.substr(o.out.find("digest "));
    if (n == 1) first = digest;
    EXPECT_EQ(digest, first);
  }
  const std::string lines = content(folder / "out1/clash.1-of-1.jsonl");
  EXPECT_THAT(lines, AllOf(HasSubstr("\"verdict\":\"clear\""), HasSubstr("\"pairs\":1")));
  const Outcome other = run(at + "$PLUMB clash parts --shard 1/1 --out out1");
  EXPECT_EQ(other.code, 2);  // with other words left out
  EXPECT_EQ(run(clash + "--out none --shard 1/1 --page a.html").code, 2);
  EXPECT_EQ(run(clash + "--out none --shard 1/1 --rule nonsense").code, 2);
}

}  // namespace
}  // namespace plumb::tool
