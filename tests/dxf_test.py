#!/usr/bin/env python3
"""A strict reader finds nothing to mend in our DXF, and in it what was drawn, at its true size.

usage: dxf_test.py SOURCE COMMAND; exit status 77: ezdxf is not there
"""
import os
import subprocess
import sys
import tempfile

try:
    import ezdxf
    from ezdxf import bbox
except ImportError as missing:
    print(f"SKIPPED: {missing}; tools/setup installs python3-ezdxf", flush=True)
    sys.exit(77)


def read(file):
    document = ezdxf.readfile(file)
    audit = document.audit()
    faults = [fault.message for fault in [*audit.errors, *audit.fixes]]
    assert not faults, f"{file}: expected nothing to mend, found {faults}"
    assert document.dxfversion == "AC1015" and document.units == ezdxf.units.MM
    return document


def expect_size(document, expected):
    """Within what --simplify may take of a round outline, a quarter of a pixel."""
    size = bbox.extents(document.modelspace()).size
    assert all(abs(found - wanted) < 1.3 for found, wanted in zip(size, expected)), f"{size}, not {expected}"


def expect_sheet(document):
    """On an A3 page, with the gear at 1:20 and hidden lines on layers of their own."""
    frame = bbox.extents(document.modelspace().query('*[layer=="frame"]'))
    assert abs(frame.extmax.x - 415) < 1e-3 and abs(frame.extmin.x - 15) < 1e-3, frame
    views = bbox.extents(document.modelspace().query('*[layer ? "(outline|occlusion|crease)-visible"]'))
    assert views.extmin.x > 20 and views.extmax.x < 410 and views.extmin.y > 10 and views.extmax.y < 287, views
    dashed = document.layers.get("crease-hidden")
    pattern = document.linetypes.get(dashed.dxf.linetype).pattern_tags.tags
    lengths = [tag.value for tag in pattern if tag.code == 49]
    assert dashed.dxf.lineweight == 25 and lengths == [3.0, -0.75], lengths  # ISO 128-20: 12 widths and 3
    assert document.layers.get("crease-visible").dxf.lineweight == 50


def main():
    source, command = map(os.path.abspath, sys.argv[1:])
    gear = os.path.join(source, "assets", "gear.glb")
    draw = [command, "render", gear, "--view", "front", "--hidden", "dashed", "-q"]
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([*draw, "-o", "true.dxf"], check=True)
        subprocess.run([*draw, "-o", "page.dxf", "--scale", "1:20", "--page-size", "A4"], check=True)
        subprocess.run([*draw, "-o", "none.dxf", "--lines", "none"], check=True)
        subprocess.run([command, "sheet", gear, "-o", "sheet.dxf"], check=True)
        true, page, sheet = read("true.dxf"), read("page.dxf"), read("sheet.dxf")
        assert len(read("none.dxf").modelspace()) == 0
    expect_size(true, (2398.3, 2398.3))  # metres in the file
    expect_size(page, (2398.3 / 20, 2398.3 / 20))
    middle = bbox.extents(page.modelspace()).center
    assert abs(middle.x - 105) < 0.5 and abs(middle.y - 148.5) < 0.5, middle
    expect_sheet(sheet)
    layers = {entity.dxf.layer for entity in true.modelspace()}
    assert layers <= {layer.dxf.name for layer in true.layers} and "outline-visible" in layers, layers
    print("ezdxf finds nothing to mend")


if __name__ == "__main__":
    main()
