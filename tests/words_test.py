#!/usr/bin/env python3
"""Holds names in C++ and GLSL to CONTRIBUTING.md's glossary: tests/words_test.py FOLDER...

A word that was given up stays out of names. Comments and messages may use it in its plain English sense.
"""
import pathlib
import re
import sys

INSTEAD = {  # of these words in a name: what to say
    "place": "position, pixel, uv, transform or index",
    "placed": "instance, or what was done",
    "placement": "transform",
    "most": "max, or what is largest",
    "least": "min, or what is smallest",
    "slant": "viewDot, or the angle that it is",
    "nearness": "inverseDepth",
    "wish": "settings",
    "soup": "randomTriangles",
    "tell": "report or say",
}
ALLOWED = {"leastSquares", "StepGeom_Axis2Placement3d"}
CODE = re.compile(r'R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|//.*|/\*(?:.|\n)*?\*/|#include.*')


def words(name):
    name = re.sub("[aA]t_?(?:Most|Least|most|least)", "", name)  # plain English
    return [word.lower() for word in re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])", name)]


def main():
    wrong = []
    for folder in sys.argv[1:]:
        for file in sorted(pathlib.Path(folder).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".glsl", ".frag", ".vert"):
                continue
            code = CODE.sub(lambda part: "\n" * part.group().count("\n"), file.read_text(encoding="utf-8"))
            for number, line in enumerate(code.split("\n"), 1):
                for name in re.findall(r"[A-Za-z_]\w*", line):
                    for word in [] if name in ALLOWED else words(name):
                        instead = INSTEAD.get(word, INSTEAD.get(word.removesuffix("s")))
                        if instead:
                            wrong.append(f"{file}:{number}: {name}: say {instead}")
    print("\n".join(wrong) or "every name keeps to the glossary")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
