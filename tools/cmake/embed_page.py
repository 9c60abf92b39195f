#!/usr/bin/env python3
"""Makes a source of a page: embed_page.py PAGE.html NAMESPACE NAME OUT.cpp: const std::string_view NAMESPACE::NAME.

Styles and scripts that the page names lie beside it, and are put into it: the page needs no other file.
"""
import pathlib
import re
import sys

file, namespace, name, out = sys.argv[1:]
folder = pathlib.Path(file).parent


def beside(found):
    return (folder / found.group(1)).read_text(encoding="utf-8")


text = pathlib.Path(file).read_text(encoding="utf-8")
text = re.sub(r'<link rel="stylesheet" href="([\w.]+)">', lambda f: f"<style>\n{beside(f)}</style>", text)
text = re.sub(r'<script src="([\w.]+)"></script>', lambda f: f"<script>\n{beside(f)}</script>", text)
pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]  # compilers limit one literal
literals = "\n".join(f'R"~~~~({piece})~~~~"' for piece in pieces)
pathlib.Path(out).write_text(f"""#include <string_view>
namespace {namespace} {{
extern const std::string_view {name};
const std::string_view {name} =
{literals};
}}  // namespace {namespace}
""", encoding="utf-8")
