#!/usr/bin/env python3
"""Expands, validates and embeds GLSL programs.

    embed_shaders.py --glslang EXE --shaders DIR --out DIR [--functions STAGE+STAGE]
                     NAME=STAGE[+STAGE][:DEFINE[=VALUE]...] ...

--functions makes a program of each file of shaders/functions, put behind the last stage, and one of the stages alone.

glslang expands the #include lines of every stage and validates every program, so that a broken shader fails the build.
What it leaves for drivers to stumble over is mended here: Mesa rejects the include extension and #line with a path, so
the extension goes and paths become numbers whose table is embedded for error messages.
"""
import argparse
import pathlib
import re
import subprocess
import sys

STAGES = {".vert": "Vertex", ".frag": "Fragment", ".comp": "Compute", ".geom": "Geometry"}


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)
    return done.stdout


def expand(glslang, shaders, source, defines, files):
    """The stage's text with includes expanded, ready for a driver. Appends the files it came from to files."""
    text = run([glslang, "-E", f"-I{shaders}", *(f"-D{d}" for d in defines), str(source)])
    text = re.sub(r"^#extension GL_GOOGLE_include_directive.*$", "", text, flags=re.M)

    def number(match):
        path = pathlib.Path(match.group(2))
        name = path.name if path.name == source.name else f"{path.parent.name}/{path.name}"
        if name not in files:
            files.append(name)
        return f"#line {match.group(1)} {files.index(name)}"

    return re.sub(r'^#line (\d+) "([^"]*)"$', number, text, flags=re.M)


def embed(arguments, name, stages, defines=(), function=None):
    """A program's row in the table of texts; function: a file under shaders/ put behind the last stage's text."""
    parts, expanded = [], []
    for number, stage in enumerate(stages):
        suffix = pathlib.Path(stage).suffix
        files = [stage]
        source = arguments.shaders / stage
        if function and number == len(stages) - 1:
            source = arguments.out / "expanded" / stage
            source.write_text((arguments.shaders / stage).read_text() + f'#include "{function}"\n')
        text = expand(arguments.glslang, arguments.shaders, source, defines, files)
        path = arguments.out / "expanded" / f"{name}{suffix}"
        path.write_text(text)
        expanded.append(str(path))
        parts.append(f'{{Stage::{STAGES[suffix]}, R"glsl({text})glsl", "{" ".join(files)}"}}')
    if function != "":
        run([arguments.glslang, "-G", "-l", *expanded, "-o", str(arguments.out / "expanded" / f"{name}.spv")])
    return f'    {{"{name}", {{{", ".join(parts)}}}}},'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--glslang", required=True)
    parser.add_argument("--shaders", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--functions")
    parser.add_argument("programs", nargs="+")
    arguments = parser.parse_args()

    (arguments.out / "gl").mkdir(parents=True, exist_ok=True)
    (arguments.out / "expanded").mkdir(exist_ok=True)
    names, rows, functions = [], [], []
    for program in arguments.programs:
        name, _, rest = program.partition("=")
        stages, *defines = rest.split(":")
        names.append(name)
        rows.append(embed(arguments, name, stages.split("+"), defines))
    if arguments.functions:
        stages = arguments.functions.split("+")
        functions.append(embed(arguments, "", stages, function=""))
        for file in sorted((arguments.shaders / "functions").glob("*.glsl")):
            functions.append(embed(arguments, file.stem, stages, function=f"functions/{file.name}"))

    enumerators = [n[0].upper() + n[1:] for n in names]
    (arguments.out / "gl" / "embedded_programs.h").write_text(
        "#pragma once\n\n#include <string_view>\n#include <vector>\n\nnamespace inkedge::gl {\n\n"
        "enum class Program { " + ", ".join(enumerators) + " };\n"
        f"inline constexpr int programCount = {len(names)};\n\n"
        "enum class Stage { Vertex, Fragment, Compute, Geometry };\n"
        "struct StageText {\n    Stage stage;\n    std::string_view text;\n"
        "    std::string_view files;  // names by #line's file number, divided by blanks\n};\n"
        "struct ProgramText {\n    std::string_view name;\n    std::vector<StageText> stages;\n};\n\n"
        "const ProgramText& programText(Program);\n\n"
        "// Surface functions by the names of their files; the first one, without a name, is the text around each.\n"
        "const std::vector<ProgramText>& functionTexts();\n\n}  // namespace inkedge::gl\n")
    (arguments.out / "embedded_programs.cpp").write_text(
        '#include "gl/embedded_programs.h"\n\nnamespace inkedge::gl {\n\n'
        "const ProgramText& programText(Program program) {\n"
        "    static const std::vector<ProgramText> texts{\n" + "\n".join(rows) + "\n    };\n"
        "    return texts[static_cast<std::size_t>(program)];\n}\n\n"
        "const std::vector<ProgramText>& functionTexts() {\n"
        "    static const std::vector<ProgramText> texts{\n" + "\n".join(functions) + "\n    };\n"
        "    return texts;\n}\n\n}  // namespace inkedge::gl\n")


main()
