// A function of one's own, or of another library, held against exact answers: is this segment test right?
//
// `plumb fuzz` does the same with a function of a shared library, in a process of its own (docs/fuzzing.md).
#include <cstdio>
#include <plumb/degenerate.hpp>
#include <plumb/query.hpp>
#include <plumb/query/kinds/kinds.hpp>

namespace {

double turn(const double a[2], const double b[2], const double c[2]) {
  return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
}

// As it stands in many a textbook; it forgets segments on one line.
int textbook(const double a[4], const double b[4]) {
  const auto sign = [](double x) { return (x > 0) - (x < 0); };
  return sign(turn(a, a + 2, b)) != sign(turn(a, a + 2, b + 2)) &&
         sign(turn(b, b + 2, a)) != sign(turn(b, b + 2, a + 2));
}

// The same on exact signs, with what the textbook forgot.
int mended(const double a[4], const double b[4]) {
  const plumb::Segment2 s{{a[0], a[1]}, {a[2], a[3]}}, t{{b[0], b[1]}, {b[2], b[3]}};
  return intersects(s, t);
}

}  // namespace

int main() {
  using namespace plumb::degenerate;
  const Kind& kind = kind_named("segment-segment");
  struct Tried {
    const char* name;
    int (*function)(const double*, const double*);
  };
  for (const auto& [name, function] : {Tried{"textbook", textbook}, Tried{"mended", mended}}) {
    const Findings findings = check(kind, function, {.seed = 1, .cases = 500, .generators = {"touching"}});
    std::printf("%s: %s in %llu cases\n", name, findings.clean() ? "nothing wrong" : "wrong",
                static_cast<unsigned long long>(findings.asked()));
    for (const Finding& finding : findings.findings)  // shrunk, as a test
      std::printf("%s", cpp_text(kind, finding.smallest, name).c_str());
  }
}
