// Certificates as text: what is read is what was written, of every kind of body; other texts are refused by place; and
// docs/verify_certificate.py, which shares nothing with this library, comes to the same verdicts.
#include "plumb/query/certificate/certificate_text.hpp"

#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "query/certificate/body_pairs.hpp"
#include "query/certificate/mutants.hpp"

namespace plumb {
namespace {

using body_pairs::OwnedBody, body_pairs::PairMaker;
using certificate_laws::MutantsOf;
using testing::HasSubstr;

/// The verdict on a text, or what refuses it.
std::string flaw_of(const std::string& text) {
  try {
    return verify(read_certificate(text)).flaw;
  } catch (const Error& e) {
    return e.what();
  }
}

/// Lines for the program in Python, and the verdict that is expected of each.
struct Lines {
  std::vector<std::string> texts;
  std::vector<bool> proved;

  void add(const std::string& text) {
    texts.push_back(text);
    proved.push_back(flaw_of(text).empty());
  }
};

template <class A, class B>
void expect_read_back(const A& a, const B& b, Lines& lines) {
  const Certificate c = relate_with_proof(a, b);
  const std::string text = certificate_text(c, a, b);
  const RecordedProof read = read_certificate(text);
  EXPECT_EQ(std::get<Certificate>(read.proof), c) << text;
  EXPECT_EQ(verify(read).flaw, "") << text;
  const DistanceCertificate d = distance_with_proof(a, b);
  const std::string of_distance = certificate_text(d, a, b);
  const auto back = std::get<DistanceCertificate>(read_certificate(of_distance).proof);
  EXPECT_EQ(back.distance, d.distance) << of_distance;
  EXPECT_EQ(back.exact.square, d.exact.square) << of_distance;
  EXPECT_EQ(back.direction, d.direction) << of_distance;
  EXPECT_EQ(back.pairs, d.pairs) << of_distance;
  EXPECT_EQ(flaw_of(of_distance), "") << of_distance;
  lines.add(text), lines.add(of_distance), lines.add(certificate_text(intersects_with_proof(a, b), a, b));
}

/// Every kind of body against this one, as it stands and under poses that keep balls round.
template <class B>
void against_every_kind(const B& b, Lines& lines) {
  const Pose turned{{{{0, 3, 4}, {5, 0, 0}, {0, 4, -3}}}, {0.1, -2, 7}};
  const RigidPose rigid{{0x1.8p-1, 0x1p-3, -0x1.4p-2, 0x1p-25}, {0.1, -2, 7}};
  const RigidChain chain{{rigid, {{0.1, 0.2, 0.3, 0.4}, {1, 2, 3}}}};
  const auto ask = [&](const auto& a) {
    expect_read_back(a, b, lines);
    expect_read_back(Posed{a, turned}, b, lines);
    expect_read_back(Posed{a, rigid}, Posed{b, chain}, lines);
    expect_read_back(b, a, lines);
  };
  const std::vector<Point3> hull{{0.1, 0, 0}, {1, 0.3, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.2}, {1, 0.3, 0}};
  ask(Point3{0.1, 0.2, 0.3});
  ask(Segment3{{0.1, 0, 0}, {1, 1, 1}});
  ask(Triangle3{{0.1, 0, 0}, {1, 1, 1}, {0, 0, 4}});
  ask(Quadrilateral3{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  ask(Polygon3{{{0, 0, 1}, {1, 0, 1}, {1.5, 1, 1}, {1, 2, 1}, {0, 2, 1}}});
  ask(Rectangle3{{0.1, 0, 0}, {{{1, 0, 0.5}, {0, 1, 0}}}, {2, -3}});
  ask(Tetrahedron3{{0.1, 0, 0}, {1, 1, 1}, {0, 0, 4}, {2, 0, 0}});
  ask(Sphere3{{0.1, 0, 0}, 0.7});
  ask(Aabb3{{0.1, 0, 0}, {1, 1, 1}});
  ask(Obb3{{0.1, 0, 0}, {{{1, 0, 0.5}, {0, 1, 0}, {0, 0.25, 1}}}, {2, -3, 0.1}});
  ask(Capsule3{{0.1, 0, 0}, {1, 1, 1}, 0.7});
  ask(Lozenge3{{0.1, 0, 0}, {{{1, 1, 1}, {0, 2, 0}}}, 0.7});
  ask(convex_polyhedron(convex_hull(hull), hull));
  ask(VertexHull3{hull});
}

/// Certificates of hard pairs; of every tenth all mutants.
void add_hard_pairs(Lines& lines) {
  for (std::uint64_t i = 0; i < battery::fitting(200U); ++i) {
    PairMaker maker(33'001, i);
    OwnedBody a = maker.a(), b = maker.b();
    if (i % 3 == 0) a.pose = pair_cases::whole_pose(maker.material());
    const query::BodyView v = a.view(), w = b.view();
    const auto add = [&](const auto& proof) {
      lines.add(query::text_of_proof(proof, v, w));
      if (i % 10 != i / 10 % 10) return;
      const MutantsOf mutants(proof);
      for (const auto& mutant : mutants.all()) lines.add(query::text_of_proof(mutant.proof, v, w));
    };
    add(query::certified_relation(v, w)), add(query::certified_intersection(v, w)),
        add(query::certified_distance(v, w));
  }
}

/// One piece of the text by another.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == text.npos ? "" : text.replace(at, from.size(), to);
}

const std::string touching = R"({"claim":"touching","direction":["2","3","6"],"pairs":[{"a":7,"b":0,"weight":"1"}],)"
                             R"("a":{"min":["0x0p+0","0x0p+0","0x0p+0"],"max":["0x1p+2","0x1p+2","0x1p+2"]},)"
                             R"("b":{"vertices":[["0x1.8p+2","0x1.cp+2","0x1.4p+3"]],"radius":"0x1.cp+2"}})";

struct Broken {
  std::string text, why;
};
/// Texts that are no certificates, and what is said of them.
std::vector<Broken> broken_texts() {
  const auto t = [](const std::string& from, const std::string& to) { return with(touching, from, to); };
  return {
      {"", "not JSON"},
      {"[]", "claim is missing"},
      {t("\"radius\"", "\"Radius\""), "b has a member \"Radius\" that is not known; there are vertices, radius, pose"},
      {t("\"weight\"", "\"weight\":\"1\",\"weight\""), "\"weight\" is given twice"},
      {"\xef\xbb\xbf" + touching, "byte-order mark"},
      {touching + std::string(1, '\0') + "x", "NUL"},
      {touching.substr(0, 80), "not JSON"},
      {t("touching", "near"), "claim is \"near\""},
      {t("\"claim\":\"touching\",", ""), "claim is missing"},
      {t("[\"2\",", "["), "direction has 2 items, not 3"},
      {t("[\"2\",", "[2,"), "direction[0] is no text"},
      {t("\"2\"", "\"1/0\""), "direction[0]"},
      {t("\"2\"", "\"nan\""), "direction[0] is \"nan\""},
      {t("\"2\"", "\"2.0\""), "direction[0] is \"2.0\""},
      {t("\"2\"", "\"1/-3\""), "direction[0] is \"1/-3\""},
      {t("\"2\"", "\"0x1p+99999\""), "direction[0]"},
      {t("\"2\"", "\"0xinf\""), "direction[0]"},
      {t("\"2\"", "\"\""), "direction[0]"},
      {t("\"pairs\":[{\"a\":7,\"b\":0,\"weight\":\"1\"}]", "\"pairs\":null"), "pairs is no list"},
      {t("\"a\":7", "\"a\":-1"), "pairs[0].a is not the number of a vertex"},
      {t("\"a\":7", "\"a\":7.0"), "pairs[0].a is not the number of a vertex"},
      {t("\"a\":7", "\"a\":true"), "pairs[0].a is not the number of a vertex"},
      {t("\"a\":7", "\"a\":4294967303"), "pairs[0].a is not the number of a vertex"},
      {t("\"weight\":\"1\"", "\"weight\":1"), "pairs[0].weight is no text"},
      {t(",\"weight\":\"1\"", ""), "pairs[0].weight is missing"},
      {t("\"0x1.8p+2\"", "\"6\""), "b.vertices[0][0] is \"6\""},
      {t("[[\"0x1.8p+2\",", "[["), "b.vertices[0] has 2 items, not 3"},
      {t("\"vertices\":[[\"0x1.8p+2\",\"0x1.cp+2\",\"0x1.4p+3\"]]", "\"vertices\":[]"), "b.radius is of one vertex"},
      {t("\"min\"", "\"least\""), "a has none of vertices, min, corner and center"},
      {t("\"max\"", "\"most\""), "a has a member \"most\" that is not known; there are min, max, pose"},
      {t("\"max\":[\"0x1p+2\"", "\"max\":[\"-0x1p+2\""), "is empty"},
      {t("\"radius\":\"0x1", "\"radius\":\"-0x1"), "radius is negative"},
      {t("\"radius\":\"0x1.cp+2\"", "\"radius\":\"0x1.cp+2\",\"pose\":{}"), "b.pose.columns is missing"},
      {t("\"radius\":\"0x1.cp+2\"",
         R"("radius":"0x1.cp+2","pose":{"columns":[["0x1p+0","0x0p+0","0x0p+0"],["0x0p+0","0x1p+1","0x0p+0"],)"
         R"(["0x0p+0","0x0p+0","0x1p+0"]],"translation":["0x0p+0","0x0p+0","0x0p+0"]})"),
       "ellipsoid"},
  };
}

TEST(CertificateText, SaysItByHand) {
  const Aabb3 box{{0, 0, 0}, {4, 4, 4}};
  const Sphere3 ball{{6, 7, 10}, 7};
  EXPECT_EQ(certificate_text(relate_with_proof(box, ball), box, ball), touching);
  EXPECT_EQ(flaw_of(touching), "");
  const Point3 far{-0x1.fffffffffffffp+1023, 0, 0}, p{0x1.fffffffffffffp+1023, 0, 0};
  const DistanceCertificate d = distance_with_proof(far, p);
  EXPECT_EQ(d.distance, HUGE_VAL);
  const std::string text = certificate_text(d, far, p);
  EXPECT_THAT(text, HasSubstr(R"("distance":"infinity")"));
  EXPECT_EQ(flaw_of(text), "");
}

TEST(CertificateText, RefusesByPlace) {
  for (const auto& [text, why] : broken_texts()) EXPECT_THAT(flaw_of(text), HasSubstr(why)) << text;
  const Point3 p{NAN, 0, 0};
  EXPECT_THAT(text_of<NonFinite>([&] { (void)certificate_text(Certificate{}, p, Point3{}); }),
              HasSubstr("certificate_text: a.x"));
}

TEST(CertificateText, IsVerifiedByTheProgramInPython) {
  Lines lines;
  against_every_kind(Point3{1, 1, 1}, lines);
  against_every_kind(Aabb3{{0, 0, 0}, {1, 2, 1}}, lines);
  against_every_kind(Capsule3{{0, 0, 3}, {4, 0, 3}, 0.3}, lines);
  const std::size_t of_kinds = lines.texts.size();
  add_hard_pairs(lines);
  for (const Broken& broken : broken_texts()) {
    if (!broken.text.empty()) lines.add(broken.text);
  }
  const std::string path = testing::TempDir() + "plumb_certificates.jsonl";
  {
    std::ofstream out(path);
    for (const std::string& text : lines.texts) out << text << '\n';
  }
  const std::string command = "python3 " PLUMB_SOURCE_DIR "/docs/verify_certificate.py " + path;
  std::FILE* pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string printed;
  std::array<char, 4096> piece{};
  for (std::size_t n = 0; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;) printed.append(piece.data(), n);
  EXPECT_NE(pclose(pipe), 0);  // some are refused
  std::istringstream all(printed);
  std::string line;
  std::size_t i = 0, proved = 0;
  for (; std::getline(all, line); ++i) {
    ASSERT_LT(i, lines.texts.size()) << line;
    const bool holds = line.starts_with("proved: ");
    EXPECT_TRUE(holds || line.starts_with("refused: ")) << line;
    EXPECT_EQ(holds, lines.proved[i]) << line << "\n" << flaw_of(lines.texts[i]) << "\n" << lines.texts[i];
    proved += holds ? 1 : 0;
  }
  EXPECT_EQ(i, lines.texts.size()) << line;
  std::printf("%zu certificates of %zu proved, %zu of them of every kind of body\n", proved, i, of_kinds);
  EXPECT_GE(proved, of_kinds);
  EXPECT_GT(i - proved, proved / 4);
  EXPECT_EQ(std::remove(path.c_str()), 0);
}

}  // namespace
}  // namespace plumb
