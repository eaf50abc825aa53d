// Do both verifiers take the same texts?  Those of docs/convex.md's grammar and no others: cases by name, and thousands of
// certificates with a byte, a word or a member changed, of which both say "proved" or both do not.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "certify/sanitized.hpp"
#include "plumb/query/certificate/certificate_text.hpp"
#include "query/certificate/changed_text.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using certificate_laws::ChangedText;

/// The verdict of the C++ verifier: the flaw, or nothing of what is proved.
std::string flaw_of(const std::string& text) {
  try {
    return verify(read_certificate(text)).flaw;
  } catch (const Error& e) {
    return e.what();
  }
}

/// What docs/verify_certificate.py says of each text, byte for byte as it is, line feeds and NULs among them.
std::vector<std::string> said_in_python(const std::vector<std::string>& texts) {
  const std::string path = testing::TempDir() + "plumb_texts";
  const std::string program =
      "import sys; sys.dont_write_bytecode = True\n"
      "sys.path.insert(0, '" PLUMB_SOURCE_DIR
      "/docs')\n"
      "import verify_certificate\n"
      "with open(sys.argv[1], 'rb') as texts:\n"
      "    while size := texts.readline():\n"
      "        print(verify_certificate.verdict(texts.read(int(size)))[1].encode('unicode_escape').decode())\n";
  {
    std::ofstream out(path, std::ios::binary);
    for (const std::string& text : texts) out << text.size() << '\n' << text;
    std::ofstream(path + ".py") << program;
  }
  std::FILE* pipe = popen(("python3 " + path + ".py " + path).c_str(), "r");
  std::string printed;
  std::array<char, 4096> piece{};
  for (std::size_t n = 0; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;) printed.append(piece.data(), n);
  EXPECT_EQ(pclose(pipe), 0);
  fs::remove(path), fs::remove(path + ".py");
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = 0; (end = printed.find('\n', at)) != printed.npos; at = end + 1)
    lines.push_back(printed.substr(at, end - at));
  EXPECT_EQ(lines.size(), texts.size());
  lines.resize(texts.size());
  return lines;
}

std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from << " in " << text;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

// A ball of radius 7 that touches a box at a corner, which is 2, 3 and 6 off.
const std::string touching = R"({"claim":"touching","direction":["2","3","6"],"pairs":[{"a":7,"b":0,"weight":"1"}],)"
                             R"("a":{"min":["0x0p+0","0x0p+0","0x0p+0"],"max":["0x1p+2","0x1p+2","0x1p+2"]},)"
                             R"("b":{"vertices":[["0x1.8p+2","0x1.cp+2","0x1.4p+3"]],"radius":"0x1.cp+2"}})";

struct Case {
  std::string name, text;
  bool proved;
};

std::vector<Case> proved_cases() {
  const auto t = [](std::string_view from, std::string_view to) { return with(touching, from, to); };
  return {
      {"as it is written", touching, true},
      {"a line feed at the end", touching + "\n", true},
      {"blanks", " \t\r{ \t\r" + touching.substr(1) + " \t\r\n", true},
      {"a name by an escape", t("\"claim\"", "\"\\u0063laim\""), true},
      {"zeros behind", t("\"0x1.8p+2\"", "\"0x1.8000000000000p+2\""), true},
      {"minus zero, a double", t("\"0x0p+0\"", "\"-0x0p+0\""), true},
      {"zero of any power", t("\"0x0p+0\"", "\"0x0.0p-9999\""), true},
      {"a digit zero before the point", t("\"0x1p+2\"", "\"0x0.8p+3\""), true},
      {"a fraction not in lowest terms", t("\"weight\":\"1\"", "\"weight\":\"3/3\""), true},
      {"a double as a fraction", t("\"2\",", "\"0x1p+1\","), true},
      {"a weight of many digits", t("\"1\"", "\"1" + std::string(3000, '0') + "/1" + std::string(3000, '0') + "\""),
       true},
      {"another length of direction", t(R"(["2","3","6"])", R"(["2/9","1/3","2/3"])"), true},
  };
}

std::vector<Case> refused_texts() {
  const auto t = [](std::string_view from, std::string_view to) { return with(touching, from, to); };
  const std::string deep(100'000, '[');
  return {
      {"nothing", "", false},
      {"a byte-order mark", "\xef\xbb\xbf" + touching, false},
      {"a byte-order mark of UTF-16", "\xff\xfe" + touching, false},
      {"two lines", with(touching, ",", ",\n"), false},
      {"two line feeds at the end", touching + "\n\n", false},
      {"a byte behind", touching + "x", false},
      {"a comma behind", touching + ",", false},
      {"a NUL behind", touching + std::string(1, '\0'), false},
      {"a NUL and a text behind", touching + std::string(1, '\0') + "x", false},
      {"a second certificate behind", touching + touching, false},
      {"a comment", touching + "// proved", false},
      {"another blank", "\v" + touching, false},
      {"a no-break space", "\xc2\xa0" + touching, false},
      {"deep lists", deep, false},
      {"deep lists within", t("\"2\"", deep), false},
      {"deep lists, closed", t("\"2\"", deep + std::string(deep.size(), ']')), false},
      {"deep objects",
       t("\"touching\"",
         [] {
           std::string text;
           for (int i = 0; i < 50'000; ++i) text += R"({"a":)";
           return text + "1" + std::string(50'000, '}');
         }()),
       false},
      {"bytes that are not UTF-8", t("\"claim\"", "\"\xff\":1,\"claim\""), false},
      {"half a surrogate", t("\"claim\"", R"("\ud800":1,"claim")"), false},
      {"a list of certificates", "[" + touching + "]", false},
  };
}

std::vector<Case> refused_members() {
  const auto t = [](std::string_view from, std::string_view to) { return with(touching, from, to); };
  const auto before_claim = [](const std::string& member) {
    return with(touching, "\"claim\"", member + ",\"claim\"");
  };
  const std::string pose = R"("pose":{"columns":[["0x1p+0","0x0p+0","0x0p+0"],["0x0p+0","0x1p+0","0x0p+0"],)"
                           R"(["0x0p+0","0x0p+0","0x1p+0"]],"translation":["0x0p+0","0x0p+0","0x0p+0"])";
  EXPECT_EQ(flaw_of(t("\"min\"", pose + "},\"min\"")), "");
  return {
      {"Radius", t("\"radius\"", "\"Radius\""), false},
      {"poses", t("\"min\"", "\"poses\":{},\"min\""), false},
      {"a pose misspelt", t("\"min\"", with(pose, "pose", "Pose") + "},\"min\""), false},
      {"a member of a pose", t("\"min\"", pose + ",\"scale\":\"2\"},\"min\""), false},
      {"a box with a radius", t("\"min\"", "\"radius\":\"0x1p+0\",\"min\""), false},
      {"a box with a radius of zero", t("\"min\"", "\"radius\":\"0x0p+0\",\"min\""), false},
      {"a box with vertices", t("\"min\"", R"("vertices":[["0x0p+0","0x0p+0","0x0p+0"]],"min")"), false},
      {"a member of a pair", t("\"weight\"", "\"wait\":\"1\",\"weight\""), false},
      {"a comment as a member", before_claim("\"comment\":\"a proof\""), false},
      {"an empty name", before_claim("\"\":\"\""), false},
      {"a name with a NUL", before_claim(R"("claim\u0000":"")"), false},
      {"the square of no distance", before_claim("\"square\":\"49\""), false},
      {"claim twice", before_claim("\"claim\":\"touching\""), false},
      {"claim twice, once by an escape", before_claim(R"("\u0063laim":"touching")"), false},
      {"a corner's number twice", t("\"a\":7", "\"a\":7,\"a\":7"), false},
      {"radius twice", t("\"radius\"", "\"radius\":\"0x1p+9\",\"radius\""), false},
      {"members of what is not known twice", before_claim(R"("x":{"y":1,"y":2})"), false},
      {"no pairs", t(R"("pairs":[{"a":7,"b":0,"weight":"1"}],)", ""), false},
      {"no direction", t(R"("direction":["2","3","6"],)", ""), false},
      {"no direction but null", t(R"(["2","3","6"])", "null"), false},
      {"a pose that is null", t("\"min\"", "\"pose\":null,\"min\""), false},
      {"another claim", t("\"touching\"", "\"Touching\""), false},
  };
}

std::vector<Case> refused_numbers() {
  const auto index = [](std::string_view to) { return with(touching, "7", to); };
  const auto real = [](std::string_view to) { return with(touching, "\"0x0p+0\"", to); };
  const auto exact = [](std::string_view to) { return with(touching, "\"1\"", to); };
  std::vector<Case> all;
  for (const std::string_view i : {"-0", "-7", "+7", "07", "7.0", "7e0", "70e-1", "0x7", "true", "\"7\"", "null", "NaN",
                                   "Infinity", "-Infinity", "8", "4294967303", "18446744073709551623", "1e999", "[7]"})
    all.push_back({"index " + std::string(i), index(i), false});
  all.push_back({"an index of many digits", index(std::string(5000, '7')), false});
  all.push_back({"index zero of b, with a sign", with(touching, "\"b\":0", "\"b\":-0"), false});
  for (const std::string_view x : {"0",
                                   "0x0p+0",
                                   "null",
                                   "[]",
                                   "\"0\"",
                                   "\"0.0\"",
                                   "\"0x0\"",
                                   "\"0x\"",
                                   "\"0xp+0\"",
                                   "\"0x0p0\"",
                                   "\"0x0P+0\"",
                                   "\"0X0p+0\"",
                                   "\"+0x0p+0\"",
                                   "\"--0x0p+0\"",
                                   "\" 0x0p+0\"",
                                   "\"0x0p+0 \"",
                                   "\"0x0.p+0\"",
                                   "\"0x.0p+0\"",
                                   "\"0x00p+0\"",
                                   "\"0x0p+00\"",
                                   "\"0x0p+\"",
                                   "\"0x0p+00000\"",
                                   "\"0x0p+10000\"",
                                   "\"0x0.00000000000000p+0\"",
                                   "\"0x1p-1075\"",
                                   "\"0x1.8p-1074\"",
                                   "\"0x1p+1024\"",
                                   "\"0x1p+9999\"",
                                   "\"0x1p-9999\"",
                                   "\"0x0.1p-1073\"",
                                   "\"0x2p+0\"",
                                   "\"0xap+0\"",
                                   "\"nan\"",
                                   "\"inf\"",
                                   "\"infinity\"",
                                   "\"-infinity\"",
                                   "\"0xinf\"",
                                   "\"0xnan\"",
                                   "\"0x0p+0\\u0000\"",
                                   "\"0x0p+\xd9\xa0\"",
                                   "\"0x0p+0\\n\"",
                                   "\"1e400\"",
                                   "\"0x0.Ap+0\""})
    all.push_back({"double " + std::string(x), real(x), false});
  for (const std::string_view x :
       {"1",         "1.0",      "\"01\"",       "\"+1\"",       "\"-1\"",   "\"1.0\"",   "\"1/0\"",
        "\"1/01\"",  "\"1/-1\"", "\"-1/-1\"",    "\"1/\"",       "\"/1\"",   "\"1 \"",    "\" 1\"",
        "\"1e0\"",   "\"\"",     "\"-\"",        "\"0/1\"",      "\"-0\"",   "\"1/1/1\"", "\"1_0/10\"",
        "\"0x1p0\"", "\"0x1\"",  "\"\xd9\xa1\"", "\"1\\u0000\"", "\"1\\n\"", "\"nan\"",   "\"inf\"",
        "true"})
    all.push_back({"fraction " + std::string(x), exact(x), false});
  return all;
}

/// Cases of distances, whose number is rounded.
std::vector<Case> distance_cases() {
  const Point3 p{0, 0, 0}, q{0, 0, 2};
  const std::string apart = certificate_text(distance_with_proof(p, q), p, q),
                    equal = certificate_text(distance_with_proof(p, p), p, p);
  return {
      {"a distance", apart, true},
      {"a distance of zero", equal, true},
      {"a distance of minus zero", with(equal, R"("distance":"0x0p+0")", R"("distance":"-0x0p+0")"), false},
      {"a distance beyond doubles", with(apart, R"("distance":"0x1p+1")", R"("distance":"infinity")"), false},
      {"a distance that is a fraction", with(apart, R"("distance":"0x1p+1")", R"("distance":"2")"), false},
      {"a distance without a square", with(apart, R"("square":"4",)", ""), false},
      {"a direction of none", with(equal, "\"pairs\"", R"("direction":["1","0","0"],"pairs")"), false},
  };
}

TEST(CertificateGrammar, HasTheseTextsAndNotThose) {
  std::vector<Case> cases;
  for (const auto& some : {proved_cases(), refused_texts(), refused_members(), refused_numbers(), distance_cases()})
    cases.insert(cases.end(), some.begin(), some.end());
  std::vector<std::string> texts;
  for (const Case& c : cases) texts.push_back(c.text);
  const std::vector<std::string> in_python = said_in_python(texts);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string flaw = flaw_of(cases[i].text), &said = in_python[i];
    EXPECT_EQ(flaw.empty(), cases[i].proved) << cases[i].name << ": " << flaw;
    EXPECT_EQ(said.starts_with("proved: "), cases[i].proved) << cases[i].name << ": in Python " << said;
    EXPECT_EQ(flaw.find('\0'), flaw.npos) << cases[i].name;
  }
  std::printf("%zu cases by name\n", cases.size());
}

/// Certificates of bodies of every form, as they stand and under poses.
class Certificates {
 public:
  Certificates() {
    against_every_form(Point3{1, 1, 1});
    against_every_form(Aabb3{{0, 0, 0}, {1, 2, 1}});
    against_every_form(Posed{Capsule3{{0, 0, 3}, {4, 0, 3}, 0.3}, turned});
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  template <class B>
  void against_every_form(const B& b) {
    const auto ask = [&](const auto& a) {
      texts_.push_back(certificate_text(relate_with_proof(a, b), a, b));
      texts_.push_back(certificate_text(intersects_with_proof(b, a), b, a));
      texts_.push_back(certificate_text(distance_with_proof(a, b), a, b));
    };
    const std::vector<Point3> hull{{0.1, 0, 0}, {1, 0.3, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}};
    const Obb3 crate{{0.1, 0, 0}, {{{1, 0, 0.5}, {0, 1, 0}, {0, 0.25, 1}}}, {2, -3, 0.1}};
    ask(VertexHull3{hull}), ask(Posed{VertexHull3{hull}, turned});
    ask(Sphere3{{0.1, 0, 0}, 0.7}), ask(Posed{Sphere3{{0.1, 0, 0}, 0.7}, turned}), ask(Sphere3{{1, 1, 1}, 0});
    ask(Capsule3{{0.1, 0, 0}, {1, 1, 1}, 0.7}), ask(Lozenge3{{0.1, 0, 0}, {{{1, 1, 1}, {0, 2, 0}}}, 0.7});
    ask(Aabb3{{0.1, 0, 0}, {1, 1, 1}}), ask(crate), ask(Posed{crate, turned});
    ask(Rectangle3{{0.1, 0, 0}, {{{1, 0, 0.5}, {0, 1, 0}}}, {2, -3}});
  }

  const Pose turned{{{{0, 3, 4}, {5, 0, 0}, {0, 4, -3}}}, {0.1, -2, 7}};
  std::vector<std::string> texts_;
};

TEST(CertificateGrammar, IsOneForBothVerifiers) {
  const Certificates certificates;
  std::vector<std::string> texts = certificates.texts(), names(texts.size(), "certificate, as it was written");
  const std::size_t whole = texts.size();
  for (std::uint64_t i = 0; i < battery::fitting(12'000U); ++i) {
    const ChangedText change(certificates.texts(), i);
    texts.push_back(change.text()), names.push_back("change " + std::to_string(i) + ", " + change.how());
  }
  const std::vector<std::string> in_python = said_in_python(texts);
  std::map<std::string, std::array<int, 2>> seen;
  std::size_t proved = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string flaw = flaw_of(texts[i]);
    const bool holds = flaw.empty();
    EXPECT_EQ(holds, in_python[i].starts_with("proved: "))
        << names[i] << "\nC++: " << flaw << "\nPython: " << in_python[i] << "\n"
        << texts[i];
    EXPECT_TRUE(holds || i >= whole) << flaw << "\n" << texts[i];
    ++seen[names[i].substr(names[i].find(", ") + 2)][holds ? 1 : 0];
    proved += holds ? 1 : 0;
  }
  for (const auto& [how, count] : seen) std::printf("%6d refused, %5d proved: %s\n", count[0], count[1], how.c_str());
  std::printf("%zu texts, %zu proved\n", texts.size(), proved);
  EXPECT_GT(proved, whole + texts.size() / 20);
  EXPECT_GT(seen["a blank between words"][1], 100);
  EXPECT_GT(texts.size() - proved, texts.size() / 2);
}

}  // namespace
}  // namespace plumb
