import collections.abc as _abc
import enum as _enum
import importlib.machinery as _machinery
import pathlib as _pathlib
import sys as _sys

_built = [file.name for file in _pathlib.Path(__file__).parent.glob("_inkedge*.so")]
if not any(f"_inkedge{suffix}" in _built for suffix in _machinery.EXTENSION_SUFFIXES):
    raise ImportError(f"inkedge: expected a Python for {', '.join(_built) or 'its module, which is missing'}, found "
                      f"{_sys.executable}, {_sys.implementation.cache_tag}; Debian's own is /usr/bin/python3")

from . import _inkedge
from ._inkedge import (
    Backend,
    Camera,
    CameraMatrices,
    ContextError,
    Error,
    InputError,
    Instance,
    Lines,
    LinesComparison,
    Maps,
    OutputError,
    PictureComparison,
    Renderer,
    RuntimeError,
    Scene,
    Setting,
    StoppedError,
    UsageError,
    Warning,
    __doc__,
    __version__,
    compare_lines,
    compare_pictures,
    settings,
    write_png,
)

LineType = _enum.IntFlag("LineType", {name.upper(): bit for name, bit in _inkedge.line_types.items()})
LineType.__doc__ = 'What a line is: bits of maps["types"] and of lines.types.'

for _type in (Backend, Camera, CameraMatrices, Instance, LineType, Lines, LinesComparison, Maps, PictureComparison,
              Renderer, Scene, Setting):
    _type.__module__ = __name__
_abc.Mapping.register(Maps)
