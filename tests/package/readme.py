"""readme.py README FOLDER: makes a project of the README's C++, C and CMake.

FOLDER gets what the README calls CMakeLists.txt, outline.cpp and outline.c, and the other blocks of C++, one after
another in scopes of their own behind the program's own statements, as snippets.cpp.
"""
import pathlib
import re
import sys
import textwrap

# What the README's reader is to bring.
BEFORE = """\
#include <fstream>
#include <iterator>

static std::vector<std::uint8_t> download() {
    std::ifstream stream{"part.ply", std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}
"""
WITHIN = """\
const glm::dmat4 worldToView{1.0}, cameraToWorld{1.0};
const glm::dmat3 k{500, 0, 0, 0, 510, 0, 400, 300, 1};
"""


def main(readme, folder):
    text = pathlib.Path(readme).read_text(encoding="utf-8")
    text = text[text.index("\n## The library\n"):]
    text = text[:text.index("\n## ", 1)]
    blocks = re.findall(r"```(cpp|cmake|c)\n(.*?)```", text, re.S)
    of = {kind: [block for name, block in blocks if name == kind] for kind in ("cpp", "cmake", "c")}
    program, *others = of["cpp"]
    assert len(others) >= 4 and len(of["cmake"]) == len(of["c"]) == 1, f"found {[kind for kind, _ in blocks]}"
    head, mark, tail = program.partition("    } catch (")
    assert mark, "expected a program that catches errors"
    scopes = [WITHIN, *("{\n" + textwrap.indent(block, "    ") + "}\n" for block in others)]
    snippets = head.replace("int main", BEFORE + "\nint main") + "".join(scopes) + mark + tail
    folder = pathlib.Path(folder)
    for name, content in {"CMakeLists.txt": of["cmake"][0], "outline.cpp": program, "outline.c": of["c"][0],
                          "snippets.cpp": snippets}.items():
        (folder / name).write_text(content, encoding="utf-8")


main(*sys.argv[1:])
