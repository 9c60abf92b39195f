"""STEP, IGES and BREP."""

import re

from lib.hostile.cases import PICTURE, case
from lib.small_step import END, HEADER, box


def replaced(old, new):
    text = box()
    assert old in text, old
    return text.replace(old, new)


def steps():
    def step(name, expected, text):
        case(f"step_{name}.step", expected, text)

    shell = re.search(r"(#\d+)=CLOSED_SHELL\('',\((#\d+)", box())
    step("box", PICTURE, box())
    step("empty", "empty", "")
    step("words", "ISO-10303-21 first", "solid?\n")
    step("cut_off", "cut short", box()[:2000])
    step("cut_off_with_its_end", "text that is not", box()[:2000] + END)
    step("without_shapes", "expected", HEADER + END)
    step("of_zeros", "expected", HEADER + "\0" * 1000 + END)
    step("shell_of_itself", PICTURE, replaced(f"'',({shell[2]},", f"'',({shell[1]},"))
    step("faces_missing", PICTURE, replaced(f"'',({shell[2]},", "'',(#99999,"))
    step("numbers_repeated", "expected", replaced("#2=", "#1="))
    step("coordinates_1e300", "found none", replaced("(0.0,0.0,3.0)", "(0.0,0.0,1.E300)"))
    step("coordinates_too_large", "still at work", replaced("(0.0,0.0,3.0)", "(0.0,0.0,1.E999)"))
    step("coordinates_of_words", "found none", replaced("(0.0,0.0,3.0)", "('a','b','c')"))
    step("directions_of_zeros", "found none", re.sub(r"(DIRECTION\('',)\([^)]*\)", r"\1(0.,0.,0.)", box()))
    step("deep_brackets", "expected", HEADER + "#1=POINT(" + "(" * 100000 + ")" * 100000 + ");\n" + END)
    step("tessellated", "tessellated", replaced("MANIFOLD_SOLID_BREP", "TESSELLATED_SOLID"))


def others():
    case("iges_words.igs", "section S first", "hello\n")
    case("iges_cut_off.igs", "cut short", "start".ljust(72) + "S      1\n")
    case("iges_sections_alone.igs", "expected",
         "start".ljust(72) + "S      1\n" + "S      1G      0D      0P      0".ljust(72) + "T      1\n")
    case("brep_words.brep", "DBRep_DrawableShape", "hello\n")
    case("brep_cut_off.brep", "cut short", "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n")
    case("brep_of_nothing.brep", "expected", "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\n+1 0\n")
