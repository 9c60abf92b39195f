"""The stub and the docstrings say what the module and the table of settings say."""
import ast
import inspect
import os
import pathlib

import pytest

import inkedge
import stubs
from conftest import SOURCE

STUB = SOURCE / "src" / "python" / "inkedge" / "__init__.pyi"


def test_settings_of_the_stub_are_the_tables():
    before, rest = STUB.read_text().split(stubs.BEGIN)
    found, after = rest.split(stubs.END)
    if os.environ.get("INKEDGE_UPDATE_README"):
        STUB.write_text(before + stubs.BEGIN + stubs.section() + stubs.END + after)
    else:
        assert found == stubs.section(), "run tools/update_readme"


def members(names):
    return {name for name in names if not name.startswith("_") or name in ("__enter__", "__getitem__", "__len__")}


def test_classes_of_the_stub_are_the_modules():
    classes = {node.name: node for node in ast.parse(STUB.read_text()).body if isinstance(node, ast.ClassDef)}
    declared = {name for name in classes if name not in stubs.CALLS}
    public = {name for name, value in vars(inkedge).items() if inspect.isclass(value) and not name.startswith("_")}
    assert declared == public
    for name in declared:
        own = getattr(inkedge, name)
        assert own.__module__ == "inkedge"
        if issubclass(own, (BaseException, int)):
            continue
        functions = {node.name: node for node in classes[name].body if isinstance(node, ast.FunctionDef)}
        inherited = {"get"} if name == "Maps" else set()
        assert members(functions) == members(vars(own)) - inherited, name
        for function, node in functions.items():
            if not function.startswith("_") and not node.decorator_list and function not in own.__doc__:
                assert getattr(own, function).__doc__ or function in ("keys", "values", "items"), f"{name}.{function}"


@pytest.mark.parametrize(("call", "groups"), [
    (inkedge.Scene.load, stubs.CALLS["LoadSettings"]),
    (inkedge.Camera.frame, stubs.CALLS["FrameSettings"]),
    (inkedge.Renderer.render, stubs.CALLS["RenderSettings"]),
    (inkedge.Renderer.lines, stubs.CALLS["LinesSettings"]),
])
def test_docstrings_describe_the_settings_that_a_call_takes(call, groups):
    for setting in inkedge.settings.values():
        described = f"\n    {setting.name}: " in call.__doc__ or f"\n    {setting.name} or " in call.__doc__
        assert described == (setting.group in groups), setting.name
        assert not described or setting.help in call.__doc__


def test_the_package_says_that_it_has_types():
    assert (pathlib.Path(inkedge.__file__).parent / "py.typed").exists()
