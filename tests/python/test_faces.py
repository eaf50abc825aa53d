"""Does docs/faces.md have a row for every question of the library about figures, and is what it says of the languages so?"""

import re
from pathlib import Path

import plumb

TREE = Path(__file__).resolve().parents[2]
PAGE = (TREE / "docs" / "faces.md").read_text()


def declared(header):
    """The functions that a header declares in namespace plumb itself."""
    text = re.sub(r"//[^\n]*", "", header.read_text())
    text = re.sub(r"\n#[^\n]*", "\n", text).replace(" = {}", "")
    kept, inside = "", []
    for token in re.finditer(r"namespace ([\w:]+) \{|namespace \{|[{}]|[^{}]", text):
        word = token.group(0)
        if word.startswith("namespace") or word == "{":
            inside.append(token.group(1) if word != "{" else "")
            kept += ";"
        elif word == "}":
            inside.pop()
            kept += ";"
        elif inside == ["plumb"]:
            kept += word
    names = set()
    for statement in map(" ".join, map(str.split, kept.split(";"))):
        statement = re.sub(r"( const| noexcept)+$", "", statement)
        if not statement.endswith(")") or re.match(r"(struct|class|enum|using|template <class> concept)\b", statement):
            continue
        depth, at = 0, len(statement)
        while at > 0:  # back to where the last argument list opens
            at -= 1
            depth += {")": 1, "(": -1}.get(statement[at], 0)
            if depth == 0:
                break
        name = re.search(r"[\s*&>]([a-z]\w*)$", statement[:at])
        if name and name.group(1) not in ("requires", "operator"):
            names.add(name.group(1))
    return names


def questions():
    return set().union(*(declared(h) for h in (TREE / "include/plumb/query").rglob("*.hpp") if "detail" not in h.parts))


def table(heading):
    """The rows of the table below a heading."""
    part = PAGE.split(f"\n## {heading}\n")[1].split("\n## ")[0]
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in part.splitlines()
            if line.startswith(("| `", "| its `"))]


def rows():
    """Question, Python, C."""
    return table("About figures")


def face_of_c():
    return "".join(header.read_text() for header in (TREE / "include/plumb").glob("plumb*.h"))


def test_every_question_has_its_row():
    found = questions()
    assert len(found) > 60 and {"relate", "distance", "first_hit", "penetration", "contact", "gjk"} <= found
    named = [re.fullmatch(r"`(\w+)`", row[0]).group(1) for row in rows()]
    assert sorted(named) == sorted(set(named)), "a question stands twice"
    assert set(named) - found == set(), "the library has no such question"
    assert found - set(named) == set(), "a question without its row in docs/faces.md"


def test_what_python_and_c_are_said_to_have_is_there():
    face = face_of_c()
    done = 0
    for question, python, c in rows():
        assert python and c
        for name in re.findall(r"`([\w.]+)", python):
            at = plumb
            for part in name.split("."):
                at = getattr(at, part)
            assert callable(at), name
            done += 1
        assert all(re.search(rf"\b{name}\(", face) for name in re.findall(r"`(\w+)`", c))
    assert done > 20


def of_classes(row):
    """A class, or its methods, which no function of the module is."""
    return row.startswith(("`CollisionWorld`", "`ExactMesh`", "`Heightfield`", "its "))


def test_every_question_about_surfaces_has_its_row():
    asked = set()
    for source in ("surface", "topology", "planar", "solids", "exact_meshes", "clash"):
        text = (TREE / f"src/python/{source}.cpp").read_text()
        asked |= set(re.findall(r'(?:module\.def\(|\badd\(\{)\s*"(\w+)"', text))
    rows = [row[0] for row in table("About signs, points, boxes and meshes")]
    named = [name for row in rows if not of_classes(row) for name in re.findall(r"`(\w+)`", row)]
    assert len(asked) > 15 and sorted(named) == sorted(asked)
    face, of = face_of_c(), None
    for row in table("About signs, points, boxes and meshes"):
        names = re.findall(r"`(\w+)`", row[0])
        of = getattr(plumb, names.pop(0)) if row[0].startswith("`") else of
        assert not of_classes(row[0]) or all(hasattr(of, name) for name in names)
        done = re.findall(r"`(\w+)`", row[1])
        assert done and all(re.search(rf"\b{name}\(", face) for name in done)


def test_every_function_of_python_is_on_the_page():
    named = set(re.findall(r"`(\w+)", PAGE))
    assert {n for n in plumb._plumb.__all__ if n.islower()} <= named
