#!/usr/bin/env python3
"""Is the C interface still the one that was recorded?  abidiff (Debian's abigail-tools) holds what a compiler makes of the
headers against tests/c/interface.xml: every function, with all that its types are made of.  What was added is told and
passes; what was changed or taken away fails.

    interface.py check CC INCLUDE RECORDED       interface.py record CC INCLUDE RECORDED

That the library has these functions and no others is what by_ctypes.py looks at."""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
HEADERS = ("plumb.h", "plumb_exact.h", "plumb_surfaces.h", "plumb_world.h")


def declarations(text):
    """Each function that a header declares, without the semicolon."""
    code = re.sub(r"/\*.*?\*/|^#[^\n]*$", "", text, flags=re.DOTALL | re.MULTILINE)
    found = []
    for statement in code.replace('extern "C" {', "").split(";"):
        statement = " ".join(statement.split())
        if re.match(r"(?!typedef)[\w *]+\bplumb_\w+\(.*\)$", statement):
            found.append(statement)
    assert len(found) == len(re.findall(r"\bplumb_\w+\(", code)), "a declaration of another form"
    return found


def compiled(compiler, include, folder, edit=lambda text: text):
    """A library of the functions that the headers declare, with nothing in them."""
    there = folder / "plumb"
    there.mkdir(parents=True, exist_ok=True)
    functions = []
    for name in HEADERS:
        text = edit((include / "plumb" / name).read_text(encoding="utf-8"))
        (there / name).write_text(text, encoding="utf-8")
        functions += declarations(text)
    assert len(functions) > 70, len(functions)
    source, library = folder / "interface.c", folder / "libplumb_c.so"
    bodies = (f + (" {}" if f.startswith("void plumb") else " { return 0; }") for f in functions)
    source.write_text("#include <plumb/plumb.h>\n" + "\n".join(bodies) + "\n", encoding="utf-8")
    subprocess.run([compiler, "-std=c99", "-g", "-O0", "-w", "-shared", "-fPIC", f"-I{folder}", "-o", library, source],
                   check=True)
    return library


def record(library, to):
    subprocess.run(["abidw", "--no-corpus-path", "--no-show-locs", "--no-comp-dir-path", "--no-architecture",
                    "--no-elf-needed", "--out-file", to, library], check=True)
    # Where it was compiled is no part of the interface; nor is what indents it.
    text = re.sub(r"(?<=<abi-instr) .*?(?= language=)|^ +", "", to.read_text(encoding="utf-8"), flags=re.MULTILINE)
    to.write_text(text, encoding="utf-8")


def difference(recorded, now, *options):
    run = subprocess.run(["abidiff", "--no-show-locs", *options, recorded, now], capture_output=True, text=True)
    if run.returncode & 3:
        raise SystemExit(f"abidiff could not compare:\n{run.stdout}{run.stderr}")
    return run.returncode, run.stdout


# What a header could become, and a word of what must be told; None: it is no change.
MUTANTS = {
    "a function is gone": (r"plumb_status plumb_points_within\(.*?\);", "", "plumb_points_within"),
    "a parameter is narrower": (r"plumb_bvh_distance\((.*?)double\* distance", r"plumb_bvh_distance(\1float* distance",
                                "plumb_bvh_distance"),
    "a struct has a member more": (r"double on_a\[3\], on_b\[3\], distance;",
                                   "double on_a[3], on_b[3], distance, more;", "plumb_closest"),
    "members change places": (r"double tolerance;\n  int32_t rule;", "int32_t rule;\n  double tolerance;", "tolerance"),
    "an enumerator has another value": (r"PLUMB_OVERLAPPING = 1", "PLUMB_OVERLAPPING = 2", "PLUMB_OVERLAPPING"),
    "a function is added": (r"const char\* plumb_version\(void\);",
                            "const char* plumb_version(void);\nint plumb_is_new(int x);", None),
    "a comment is another": (r"exact ones rounded once", "exact ones", None),
}


def check(compiler, include, recorded, folder):
    now = folder / "now.xml"
    record(compiled(compiler, include, folder / "now"), now)
    changed, text = difference(recorded, now, "--no-added-syms")
    if changed:
        raise SystemExit(f"{text}\nThe C interface is not the recorded one.  Programs that were compiled for that would "
                         f"break; where this is meant, record it:\n  {sys.argv[0]} record {' '.join(sys.argv[2:])}")
    added, text = difference(recorded, now)
    if added:
        print(f"{text}\nRecord it with the next release.")
    for what, (pattern, replacement, word) in MUTANTS.items():
        seen = 0

        def edit(header):
            nonlocal seen
            header, count = re.subn(pattern, replacement, header, flags=re.DOTALL)
            seen += count
            return header

        mutant = folder / "mutant.xml"
        record(compiled(compiler, include, folder / "mutant", edit), mutant)
        assert seen, f"{what}: no place for it in the headers"
        changed, text = difference(now, mutant, "--no-added-syms")
        assert bool(changed) == (word is not None) and (word or "") in text, f"{what}: {changed}\n{text}"
    print(f"the interface is the recorded one; {len(MUTANTS)} edits of the headers are judged rightly")


def main():
    if shutil.which("abidiff") is None:
        print("skipped: abidiff is not here (Debian's abigail-tools)")
        return SKIPPED
    what, compiler, include, recorded = sys.argv[1], sys.argv[2], Path(sys.argv[3]), Path(sys.argv[4])
    with tempfile.TemporaryDirectory() as name:
        if what == "record":
            record(compiled(compiler, include, Path(name)), recorded)
        else:
            check(compiler, include, recorded, Path(name))
    return 0


if __name__ == "__main__":
    sys.exit(main())
