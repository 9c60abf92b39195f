#!/usr/bin/env python3
"""Makes a source of a text: embed_file.py FILE NAMESPACE NAME OUT.cpp: const std::string_view NAMESPACE::NAME."""
import pathlib
import sys

file, namespace, name, out = sys.argv[1:]
text = pathlib.Path(file).read_text(encoding="utf-8")
pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]  # compilers limit one literal
literals = "\n".join(f'R"~~~~({piece})~~~~"' for piece in pieces)
pathlib.Path(out).write_text(f"""#include <string_view>
namespace {namespace} {{
extern const std::string_view {name};
const std::string_view {name} =
{literals};
}}  // namespace {namespace}
""", encoding="utf-8")
