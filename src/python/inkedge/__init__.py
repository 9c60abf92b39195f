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
    Maps,
    OutputError,
    Renderer,
    RuntimeError,
    Scene,
    Setting,
    StoppedError,
    UsageError,
    Warning,
    __doc__,
    __version__,
    settings,
)
import collections.abc as _abc
import enum as _enum

LineType = _enum.IntFlag("LineType", {name.upper(): bit for name, bit in _inkedge.line_types.items()})
LineType.__doc__ = 'What a line is: bits of maps["types"] and of lines.types.'

for _type in (Backend, Camera, CameraMatrices, Instance, LineType, Lines, Maps, Renderer, Scene, Setting):
    _type.__module__ = __name__
_abc.Mapping.register(Maps)
