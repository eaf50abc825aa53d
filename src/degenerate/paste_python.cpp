// A case as a script: it asks the function in a process of its own and judges the answer, by what Python brings along.
#include <algorithm>
#include <array>
#include <cmath>

#include "certify/case_line.hpp"
#include "degenerate/fields.hpp"
#include "degenerate/known_answer.hpp"
#include "degenerate/reserved_names.hpp"
#include "degenerate/words.hpp"
#include "plumb/degenerate/paste.hpp"

namespace plumb::degenerate {

namespace {

constexpr std::string_view kBegin = R"py(import ctypes
import math
import mmap
import os
import select
import signal
import struct
import sys
from fractions import Fraction

)py";

// What is asked of every function.
constexpr std::string_view kAsk = R"py(

def guarded(kind, values):
    """The values as C has them, at the end of readable memory, as plumb fuzz hands them over."""
    size = len(values) * ctypes.sizeof(kind)
    room = -(-max(size, 1) // mmap.PAGESIZE) * mmap.PAGESIZE
    memory = mmap.mmap(-1, room + mmap.PAGESIZE)
    start = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    ctypes.CDLL(None).mprotect(ctypes.c_void_p(start + room), ctypes.c_size_t(mmap.PAGESIZE), 0)
    array = (kind * len(values)).from_buffer(memory, room - size)
    array[:] = values
    return array
)py";

// Of numbers.
constexpr std::string_view kWithin = R"py(

def place_of(x):
    """The place of a double among all doubles."""
    bits = struct.unpack("<q", struct.pack("<d", x))[0]
    return bits if bits >= 0 else -(bits & 0x7FFFFFFFFFFFFFFF)


def within(x, wanted, size):
    """Whether x is as near to the wanted number as was allowed; nothing of it is rounded."""
    if x == wanted or not (math.isfinite(x) and math.isfinite(wanted)):
        return x == wanted
    if abs(place_of(x) - place_of(wanted)) <= ULPS:
        return True
    return abs(Fraction(x) - Fraction(wanted)) <= Fraction(RELATIVE) * Fraction(size)
)py";

constexpr std::string_view kMain = R"py(

def verdict():
    """The answer and whether it is right, from a process that may crash or hang."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        nowhere = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nowhere, stream)
        given = ask()
        os.write(writing, (judge(given) + "\n" + str(given)).encode())
        os._exit(0)
    os.close(writing)
    ready = select.select([reading], [], [], TIMEOUT)[0]
    if not ready:
        os.kill(child, signal.SIGKILL)
    told = os.read(reading, 65536).decode() if ready else ""
    status = os.waitpid(child, 0)[1]
    if told:
        return told.split("\n", 1)
    if not ready:
        return "wrong", "hung (longer than %g s)" % TIMEOUT
    if os.WIFSIGNALED(status):
        return "wrong", "crashed (%s)" % signal.Signals(os.WTERMSIG(status)).name
    return "wrong", "exited (with code %d)" % os.WEXITSTATUS(status)


try:
    FUNCTION = getattr(ctypes.CDLL(os.path.abspath(LIBRARY) if os.path.exists(LIBRARY) else LIBRARY), SYMBOL)
except (OSError, AttributeError) as error:
    print("cannot ask %s of %s: %s" % (SYMBOL, LIBRARY, error), file=sys.stderr)
    sys.exit(2)
result, told = verdict()
print("%s: given %s, exact %s" % (result, told, EXACT))
sys.exit(1 if result == "wrong" else 0)
)py";

constexpr std::string_view kAskPlainly = R"py(
def ask():
    FUNCTION.restype = RESULT
    return FUNCTION(ARGUMENTS)

)py";

constexpr std::string_view kAskHit = R"py(
def ask():
    """None for a miss, "yes" for a hit whose parameter is left alone."""
    FUNCTION.restype = ctypes.c_int
    untold = bytes.fromhex("0100efbeaddef87f")
    t = ctypes.c_double.from_buffer_copy(untold)
    if not FUNCTION(ARGUMENTS, ctypes.byref(t)):
        return None
    return "yes" if bytes(t) == untold else t.value

)py";

constexpr std::string_view kAskHull = R"py(
def ask():
    """The corners of the triangles; None where the function does not know."""
    FUNCTION.restype = ctypes.c_size_t
    capacity = 2 * (len(points) // 3)
    room = (ctypes.c_size_t * (3 * capacity + 64))()
    count = FUNCTION(ARGUMENTS, room, ctypes.c_size_t(capacity))
    if count == ctypes.c_size_t(-1).value:
        return None
    return list(room[: 3 * count]) if count <= capacity else "too many triangles"

)py";

constexpr std::string_view kJudgeSign = R"py(
def judge(given):
    if math.isnan(given):
        return "unsure"
    return "right" if (given > 0) - (given < 0) in RIGHT else "wrong"
)py";

constexpr std::string_view kJudgeYesNo = R"py(
def judge(given):
    return "right" if bool(given) in RIGHT else "wrong"
)py";

constexpr std::string_view kJudgeNumber = R"py(
def judge(given):
    if math.isnan(given):
        return "unsure"
    return "right" if any(within(given, wanted, SIZE) for wanted in RIGHT) else "wrong"
)py";

constexpr std::string_view kJudgeHit = R"py(
def judge(given):
    def is_right(wanted):
        if given is None or wanted is None:
            return given is wanted
        return "yes" in (given, wanted) or within(given, wanted, wanted)

    return "right" if any(is_right(wanted) for wanted in RIGHT) else "wrong"
)py";

// By the same laws as src/query/kinds/kind_hull.hpp, in fractions.
constexpr std::string_view kJudgeHull = R"py(
def judge(given):
    if given is None:
        return "unsure"
    if not EXACT or isinstance(given, str):
        return "right" if given == EXACT else "wrong"
    corners = [tuple(Fraction(x) for x in points[i : i + 3]) for i in range(0, len(points), 3)]
    first = {}
    for index, corner in enumerate(corners):
        first.setdefault(corner, index)

    def determinant(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))

    def volume(triangles):
        return sum(determinant(*(corners[i] for i in triangles[t : t + 3])) for t in range(0, len(triangles), 3))

    if not given or any(index >= len(corners) for index in given):
        return "wrong"
    given = [first[corners[index]] for index in given]
    edges = [(given[t + k], given[t + (k + 1) % 3]) for t in range(0, len(given), 3) for k in range(3)]
    if len(set(edges)) < len(edges) or any((b, a) not in edges for a, b in edges):
        return "wrong"
    for t in range(0, len(given), 3):
        a, b, c = (corners[i] for i in given[t : t + 3])
        sides = [determinant(*([x - y for x, y in zip(q, a)] for q in (b, c, p))) for p in corners]
        if any(side > 0 for side in sides) or all(side == 0 for side in sides):
            return "wrong"
    return "right" if volume(given) == volume(EXACT) else "wrong"
)py";

// Who judges did not know either.
constexpr std::string_view kJudgeNothing = R"py(
def judge(given):
    return "right"
)py";

std::string replaced(std::string_view text, std::string_view what, std::string_view with) {
  std::string made(text);
  for (std::size_t at = 0; (at = made.find(what, at)) != std::string::npos; at += with.size()) {
    made.replace(at, what.size(), with);
  }
  return made;
}

std::string python_number(double x) {
  if (std::isnan(x)) return "math.nan";
  if (std::isinf(x)) return x > 0 ? "math.inf" : "-math.inf";
  return std::string("float.fromhex(\"").append(hexadecimal(x)).append("\")");
}

std::string python_answer(const Kind& kind, const Answer& exact) {
  if (!is_known(kind, exact)) return "math.nan";
  switch (kind.form) {
    case AnswerForm::sign:
      return decimal(exact.numbers[0]);
    case AnswerForm::yes_no:
      return exact.numbers[0] != 0 ? "True" : "False";
    case AnswerForm::number:
      return python_number(exact.numbers[0]);
    case AnswerForm::hit:
      return exact.numbers[0] == 0 ? "None" : knows_parameter(exact) ? python_number(exact.numbers[1]) : "\"yes\"";
    case AnswerForm::triangles:
      break;
  }
  return std::string("[").append(joined(exact.numbers, ", ", decimal)).append("]");
}

std::string_view asking(const Kind& kind) {
  return kind.form == AnswerForm::hit ? kAskHit : kind.form == AnswerForm::triangles ? kAskHull : kAskPlainly;
}

std::string_view judging(AnswerForm form) {
  constexpr std::array all = {kJudgeSign, kJudgeYesNo, kJudgeNumber, kJudgeHit, kJudgeHull};
  return all[static_cast<std::size_t>(form)];
}

/// A string of Python's.
std::string in_quotes(std::string_view text) {
  std::string made = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') made.push_back('\\');
    if (c == '\n') {
      made.append("\\n");
    } else {
      made.push_back(c);
    }
  }
  return made.append("\"");
}

std::string variable(const std::string& name) { return is_taken_in_python(name) ? name + "_" : name; }

}  // namespace

std::string python_text(const Kind& kind, std::span<const double> numbers, std::string_view function,
                        const PythonOptions& options) {
  const Answer exact = kind.exact(numbers);
  const Tolerance tolerance = options.tolerance.value_or(kind.tolerance);
  std::string text = std::string("#!/usr/bin/env python3\n# ").append(kind.name).append(": ").append(kind.question);
  text.append("\n# ").append(kind.convention).append(".\n");
  text.append(
      "# Asks again; exit status 1 while the answer is wrong, 0 when it is right, 2 where nothing can be asked.\n");
  text.append(kBegin);
  const std::string library =
      options.library.empty() ? std::string("lib").append(function).append(".so") : options.library;
  text.append("LIBRARY = sys.argv[1] if len(sys.argv) > 1 else ").append(in_quotes(library)).append("\n");
  text.append("SYMBOL = ").append(in_quotes(function)).append("\n");
  text.append("TIMEOUT = ").append(decimal(options.timeout)).append("  # seconds\n");
  std::string arguments;
  for (const Given& g : given(kind, numbers)) {
    const bool indices = names_points(g.argument.parts[0].role);
    const std::string name = variable(g.argument.name);
    text.append(name).append(" = [");
    if (indices) {
      text.append(joined(g.numbers, ", ", decimal)).append("]\n");
    } else {
      text.append("float.fromhex(x) for x in \"").append(joined(g.numbers, " ", hexadecimal));
      text.append("\".split()]  # ").append(joined(g.numbers, ", ", decimal)).append("\n");
    }
    arguments.append(arguments.empty() ? "" : ", ").append("guarded(ctypes.c_").append(indices ? "size_t" : "double");
    arguments.append(", ").append(name).append(")");
    if (g.argument.any_number()) {
      arguments.append(", ctypes.c_size_t(").append(std::to_string(g.count)).append(")");
    }
  }
  text.append("EXACT = ").append(python_answer(kind, exact)).append("  # ").append(words(kind, exact)).append("\n");
  if (kind.form != AnswerForm::triangles) {
    text.append("RIGHT = [EXACT");
    for (const Exact& other : kind.also_right) text.append(", ").append(python_answer(kind, other(numbers)));
    text.append("]\n");
  }
  if (kind.form == AnswerForm::number || kind.form == AnswerForm::hit) {
    text.append("ULPS = ").append(std::to_string(tolerance.ulps));
    text.append("\nRELATIVE = ").append(python_number(tolerance.relative)).append("\n");
  }
  if (kind.form == AnswerForm::number) {
    double size = 0;
    for (const double x : gathered(numbers, lengths_of(kind, numbers))) size = std::max(size, std::fabs(x));
    text.append("SIZE = ").append(python_number(size)).append("  # the largest magnitude\n");
  }
  text.append(kAsk);
  if (kind.form == AnswerForm::number || kind.form == AnswerForm::hit) text.append(kWithin);
  text.append("\n").append(replaced(replaced(asking(kind), "ARGUMENTS", arguments), "RESULT",
                                    kind.form == AnswerForm::yes_no ? "ctypes.c_int" : "ctypes.c_double"));
  return text.append(is_known(kind, exact) ? judging(kind.form) : kJudgeNothing).append(kMain);
}

}  // namespace plumb::degenerate
