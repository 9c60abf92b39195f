"""The list of cases, and variations of one model to make them from."""

from lib.small_gltf import U32, Model

PICTURE = None  # what is expected of a file that can be drawn; else a word of the error
CASES = {}  # by file name: the expectation, and the content or a function that puts the file in its place


def case(name, expected, content):
    assert name not in CASES, name
    CASES[name] = (expected, content.encode() if isinstance(content, str) else content)


def quad(**primitive):
    model = Model()
    model.mesh(**primitive)
    return model


def changed(path, value, model=None):
    """A model with one member of its JSON replaced; DELETE removes it."""
    model = model or quad()
    *parents, last = path
    place = model.json
    for key in parents:
        place = place[key]
    if value is DELETE:
        del place[last]
    else:
        place[last] = value
    return model


DELETE = object()


def text_with(model, old, new):
    text = model.gltf().decode()
    assert old in text, old
    return text.replace(old, new, 1)


def with_positions(rows, indices=None):
    model = Model()
    model.mesh({"POSITION": model.accessor(rows)}, indices or list(range(len(rows))), U32)
    return model


ACCESSOR = ["accessors", 0]
INDEX = ["accessors", 1]
VIEW = ["bufferViews", 0]
