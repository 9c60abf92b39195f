#!/usr/bin/env python3
"""Holds what each room of src/ includes to what its CMakeLists.txt says that it sees: tests/rooms_test.py SRC.

A room sees itself, the rooms after USES, and the third-party libraries after LIBRARIES. A public header belongs to the
room that defines what it declares, but for plain data. No room may see itself by way of others. What a room's headers
declare is in the room's namespace; its sources may also define what public headers declare.
"""
import pathlib
import re
import sys

# Data, which all may see.
PLAIN = ["bounds", "edge_kinds", "error", "export", "image", "line_types", "lines", "maps", "stage_time", "version"]
OWNERS = {  # of the other public headers
    "base": ["write_file"],
    "images": ["encode_png"],
    "settings": ["setting_table", "settings", "surface_functions"],
    "mesh": ["face_surfaces", "mesh", "mesh_arrays"],
    "formats": ["inspect_model", "load_scene"],
    "scene": ["scene", "scene_arrays", "scene_names"],
    "camera": ["camera", "views"],
    "gl": ["backends"],
    "render": ["renderer"],
    "io": ["compare", "read_lines", "write"],
    "diff": ["compare_lines"],
    "job": ["job"],
    "sheet": ["sheet"],
}
LIBRARIES = {  # start of a header's name: what stands for it after LIBRARIES
    "CLI/": "CLI11",
    "cairo": "Cairo",
    "OpenImageIO/": "OpenImageIO",
    "draco/": "draco",
    "embree": "embree",
    "GL/glu.h": "GLU",
    "httplib.h": "httplib",
    "isa-l/": "Isal",
    "meshoptimizer.h": "meshoptimizer",
    "nlohmann/": "nlohmann_json",
    "opensubdiv/": "OpenSubdiv",
    "png.h": "PNG",
}
SEEN_BY = {  # has no target to name
    "tiny_gltf.h": ("formats",),
    "EGL/": ("gl",),
    "GL/": ("gl",),
    "KHR/": ("gl",),
    "glad/": ("gl",),
}
DEFINE_PUBLIC = ("prepared.h",)  # the PreparedScene that a public header declares
GENERATED = ("glad", "shader_texts")  # they stand after USES


def declared(folder):
    """The rooms and libraries that a room's CMakeLists.txt names, in whatever order its commands have them."""
    text = re.sub(r"#.*", "", (folder / "CMakeLists.txt").read_text())
    uses = re.search(r"inkedge_room\(\s*\S+(.*?)\)", text, re.S)
    words = uses.group(1).split() if uses else []
    rooms, keyword = set(), ""
    for word in words:
        if word in ("USES", "SOURCES", "LIBRARIES"):
            keyword = word
        elif keyword == "USES":
            rooms.add(word)
    return rooms, text


def owner(header):
    for room, headers in OWNERS.items():
        if header in headers:
            return room
    return None


def faults_of(folder, rooms, all_rooms):
    name = folder.name
    uses, text = rooms[name]
    for file in sorted(folder.rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        for line, include in enumerate(file.read_text().splitlines(), 1):
            found = re.match(r'#include ["<]([^">]+)[">]', include)
            if not found:
                continue
            header = found.group(1)
            where = f"src/{file.relative_to(folder.parent)}:{line}"
            first = header.split("/")[0]
            if first == "inkedge":
                public = header.split("/")[1].removesuffix(".h")
                room = name if public in PLAIN else owner(public)
                if room is None:
                    yield f"{where}: expected a public header of a room that is known here, found {header}"
                    continue
            elif first in all_rooms:
                room = first
            else:
                if header.endswith(".hxx") and not file.name.startswith("occt_"):
                    yield f"{where}: expected {header} in files of OpenCASCADE only, occt_*, found it here"
                for start, library in LIBRARIES.items():
                    if header.startswith(start) and library not in text:
                        yield f"{where}: expected {library} in {name}/CMakeLists.txt for {header}, found none"
                for start, seers in SEEN_BY.items():
                    if header.startswith(start) and name not in seers and not header.startswith("GL/glu"):
                        yield f"{where}: expected {header} in {' or '.join(seers)} only, found it in {name}"
                continue
            if room != name and room not in uses:
                yield f"{where}: expected {room} among what {name} uses, found {header} without"


def strangers(folder):
    """Namespaces that are not the room's own."""
    for file in sorted(folder.rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        room = file.parent.name if file.parent.parent.name == "formats" else folder.name
        public = file.suffix == ".cpp" or file.name in DEFINE_PUBLIC
        for line, text in enumerate(file.read_text().splitlines(), 1):
            found = re.match(r"namespace inkedge((?:::\w+)*) \{", text)
            if found and found.group(1) != f"::{room}" and not (public and not found.group(1)):
                yield f"src/{file.relative_to(folder.parent)}:{line}: expected namespace inkedge::{room}, found {text}"


def cycles(rooms):
    def seen_from(room, path):
        for used in sorted(rooms[room][0]):
            if used not in rooms:
                continue
            if used == path[0]:
                yield " -> ".join([*path, used])
            elif used not in path:
                yield from seen_from(used, [*path, used])

    for room in rooms:
        for cycle in seen_from(room, [room]):
            yield f"expected rooms that see one way only, found {cycle}"
            return


def unused(folder, rooms):
    """Rooms that are named and never included."""
    name = folder.name
    text = "\n".join(file.read_text() for file in folder.rglob("*") if file.suffix in (".h", ".cpp"))
    for used in sorted(rooms[name][0]):
        public = "|".join(OWNERS.get(used, ["-"]))
        if used in ("base", *GENERATED):
            continue  # errors are thrown by way of plain headers, generated headers are seen by way of gl
        if not re.search(rf'#include ["<]({used}/|inkedge/({public})\.h)', text):
            yield f"src/{name}/CMakeLists.txt: expected only rooms that {name} includes, found {used}"


def main(source):
    source = pathlib.Path(source)
    folders = sorted(path.parent for path in source.glob("*/CMakeLists.txt"))
    rooms = {folder.name: declared(folder) for folder in folders}
    users = ("c", "cli", "python")  # of the library: they see its public headers
    checked = [folder for folder in folders if folder.name not in users]
    faults = []
    for folder in checked:
        faults += faults_of(folder, rooms, rooms.keys())
        faults += unused(folder, rooms)
    for folder in folders:
        faults += strangers(folder)
    faults += cycles(rooms)
    print("\n".join(faults))
    if len(rooms) < 10:
        faults.append("")
        print(f"expected the rooms of src/, found {len(rooms)} in {source}")
    print(f"{len(rooms)} rooms, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(print("usage: tests/rooms_test.py SRC", file=sys.stderr) or 2)
    sys.exit(main(sys.argv[1]))
