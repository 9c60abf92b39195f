# What lies between the two marks is written by tools/update_readme, from the table of settings.
import enum
from collections.abc import ItemsView, Iterator, KeysView, Mapping, Sequence, ValuesView
from os import PathLike
from typing import Any, Final, Literal, TypeAlias, TypedDict, final

import builtins
import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import Self, Unpack

__version__: Final[str]
settings: Final[Mapping[str, Setting]]

_Number: TypeAlias = float | str
_Count: TypeAlias = int | str
_Text: TypeAlias = ArrayLike | PathLike[str]
_Path: TypeAlias = str | PathLike[str]

# settings
_Maps: TypeAlias = Literal[
    "depth", "depth-edges", "depth_edges", "edges", "ids", "normal", "normal-edges", "normal_edges", "shade", "types"
]
_NormalSpace: TypeAlias = Literal[
    "camera", "world"
]
_Lines: TypeAlias = Literal[
    "outline", "occlusion", "boundary", "crease", "intersection", "object", "isoparametric", "marked", "suggestive",
    "ridge", "valley", "apparent", "tangent"
]
_LinesFrom: TypeAlias = Literal[
    "auto", "image", "object"
]
_Contour: TypeAlias = Literal[
    "auto", "mesh", "smooth"
]
_ContourFinder: TypeAlias = Literal[
    "every", "random", "gauss"
]
_Hidden: TypeAlias = Literal[
    "none", "dashed", "solid"
]
_Coincident: TypeAlias = Literal[
    "merge", "keep"
]
_StrokeWidth: TypeAlias = Literal[
    "constant", "depth", "curvature", "strength"
]
_PathOrder: TypeAlias = Literal[
    "drawn", "travel"
]
_Style: TypeAlias = Literal[
    "ink", "hatch", "sumi", "pencil", "none"
]
_Shade: TypeAlias = Literal[
    "none", "flat", "gooch", "light", "base-color"
]
_View: TypeAlias = Literal[
    "front", "back", "left", "right", "top", "bottom", "iso", "dimetric"
]
_Framing: TypeAlias = Literal[
    "auto", "each", "together"
]
_Unit: TypeAlias = Literal[
    "auto", "m", "mm", "cm", "in", "ft"
]
_Normals: TypeAlias = Literal[
    "auto", "authored", "flat"
]
_Creases: TypeAlias = Literal[
    "auto", "angle", "normals"
]
_Transparent: TypeAlias = Literal[
    "solid", "ignore"
]
_AlphaMask: TypeAlias = Literal[
    "cut", "ignore"
]
_BackFaces: TypeAlias = Literal[
    "draw", "material"
]
_Detector: TypeAlias = Literal[
    "planes", "classic", "saito-takahashi", "raskar-cohen", "none"
]
_Kernel: TypeAlias = Literal[
    "sobel", "farid"
]
_DepthMap: TypeAlias = Literal[
    "linear", "window"
]
_NormalLights: TypeAlias = Literal[
    "single", "two-pass"
]
_LightSpace: TypeAlias = Literal[
    "camera", "world"
]
_Backend: TypeAlias = Literal[
    "auto", "egl", "osmesa"
]

class LoadSettings(TypedDict, total=False):
    preset: str
    maps: str | Sequence[_Maps]
    normal_space: _NormalSpace
    size: _Text
    crop: _Text
    scale: _Text
    line_color: _Text
    background: _Text
    line_width: _Text
    dpi: _Number
    page_size: _Text
    supersampling: _Count
    tile_size: _Count
    lines: str | Sequence[_Lines]
    line_style: _Text
    lines_from: _LinesFrom
    contour: _Contour
    contour_finder: _ContourFinder
    hidden: _Hidden
    coincident: _Coincident
    stroke_width: _StrokeWidth
    stroke_taper: _Number
    brush: _Text
    simplify: _Number
    fit_curves: _Number
    path_order: _PathOrder
    subdivide_adaptive: _Count
    isolines: _Text
    feature_size: _Number
    suggestive_threshold: _Number
    ridge_threshold: _Number
    apparent_threshold: _Number
    style: _Style
    hatch_bend: _Number
    hatch_shade: _Number
    hatch_width: _Number
    sumi_width: _Number
    sumi_length: _Number
    sumi_streaks: _Count
    pencil_strokes: _Count
    pencil_looseness: _Number
    pencil_seed: _Count
    shade: _Shade
    light: _Text
    camera_position: _Text
    eye: _Text
    camera_focal_point: _Text
    target: _Text
    camera_view_up: _Text
    camera_view_angle: _Number
    fov: _Number
    camera_orthographic: _Number
    camera_direction: _Text
    view: _View
    framing: _Framing
    camera_azimuth_angle: _Number
    azimuth: _Number
    camera_elevation_angle: _Number
    elevation: _Number
    camera_index: _Count
    camera_zoom_factor: _Number
    zoom: _Number
    up: _Text
    unit: _Unit
    only: _Text
    hide: _Text
    normals: _Normals
    creases: _Creases
    crease_angle: _Number
    scene: _Count
    animation: _Text
    time: _Number
    transparent: _Transparent
    alpha_mask: _AlphaMask
    back_faces: _BackFaces
    tolerance: _Number
    subdivide: _Count
    max_file_size: _Count
    max_decompressed_size: _Count
    max_vertices: _Count
    max_instances: _Count
    max_nodes: _Count
    max_node_depth: _Count
    max_image_pixels: _Count
    max_reading_time: _Number
    detector: _Detector
    kernel: _Kernel
    depth_map: _DepthMap
    depth_threshold: _Number
    normal_threshold: _Number
    normal_lights: _NormalLights
    light_space: _LightSpace
    profile_limit: _Number
    edge_limit: _Number
    function: _Text

class ArraysSettings(TypedDict, total=False):
    preset: str
    maps: str | Sequence[_Maps]
    normal_space: _NormalSpace
    size: _Text
    crop: _Text
    scale: _Text
    line_color: _Text
    background: _Text
    line_width: _Text
    dpi: _Number
    page_size: _Text
    supersampling: _Count
    tile_size: _Count
    lines: str | Sequence[_Lines]
    line_style: _Text
    lines_from: _LinesFrom
    contour: _Contour
    contour_finder: _ContourFinder
    hidden: _Hidden
    coincident: _Coincident
    stroke_width: _StrokeWidth
    stroke_taper: _Number
    brush: _Text
    simplify: _Number
    fit_curves: _Number
    path_order: _PathOrder
    subdivide_adaptive: _Count
    isolines: _Text
    feature_size: _Number
    suggestive_threshold: _Number
    ridge_threshold: _Number
    apparent_threshold: _Number
    style: _Style
    hatch_bend: _Number
    hatch_shade: _Number
    hatch_width: _Number
    sumi_width: _Number
    sumi_length: _Number
    sumi_streaks: _Count
    pencil_strokes: _Count
    pencil_looseness: _Number
    pencil_seed: _Count
    shade: _Shade
    light: _Text
    camera_position: _Text
    eye: _Text
    camera_focal_point: _Text
    target: _Text
    camera_view_up: _Text
    camera_view_angle: _Number
    fov: _Number
    camera_orthographic: _Number
    camera_direction: _Text
    view: _View
    framing: _Framing
    camera_azimuth_angle: _Number
    azimuth: _Number
    camera_elevation_angle: _Number
    elevation: _Number
    camera_index: _Count
    camera_zoom_factor: _Number
    zoom: _Number
    up: _Text
    unit: _Unit
    only: _Text
    hide: _Text
    creases: _Creases
    crease_angle: _Number
    scene: _Count
    animation: _Text
    time: _Number
    transparent: _Transparent
    alpha_mask: _AlphaMask
    back_faces: _BackFaces
    tolerance: _Number
    subdivide: _Count
    max_file_size: _Count
    max_decompressed_size: _Count
    max_vertices: _Count
    max_instances: _Count
    max_nodes: _Count
    max_node_depth: _Count
    max_image_pixels: _Count
    max_reading_time: _Number
    detector: _Detector
    kernel: _Kernel
    depth_map: _DepthMap
    depth_threshold: _Number
    normal_threshold: _Number
    normal_lights: _NormalLights
    light_space: _LightSpace
    profile_limit: _Number
    edge_limit: _Number
    function: _Text

class FrameSettings(TypedDict, total=False):
    preset: str
    camera_position: _Text
    eye: _Text
    camera_focal_point: _Text
    target: _Text
    camera_view_up: _Text
    camera_view_angle: _Number
    fov: _Number
    camera_orthographic: _Number
    camera_direction: _Text
    view: _View
    framing: _Framing
    camera_azimuth_angle: _Number
    azimuth: _Number
    camera_elevation_angle: _Number
    elevation: _Number
    camera_index: _Count
    camera_zoom_factor: _Number
    zoom: _Number

class LookAtSettings(TypedDict, total=False):
    preset: str
    camera_position: _Text
    camera_focal_point: _Text
    camera_view_up: _Text
    camera_view_angle: _Number
    fov: _Number
    camera_orthographic: _Number
    camera_direction: _Text
    view: _View
    framing: _Framing
    camera_azimuth_angle: _Number
    azimuth: _Number
    camera_elevation_angle: _Number
    elevation: _Number
    camera_index: _Count
    camera_zoom_factor: _Number
    zoom: _Number

class RenderSettings(TypedDict, total=False):
    preset: str
    maps: str | Sequence[_Maps]
    normal_space: _NormalSpace
    size: _Text
    crop: _Text
    scale: _Text
    line_color: _Text
    background: _Text
    line_width: _Text
    dpi: _Number
    page_size: _Text
    supersampling: _Count
    tile_size: _Count
    lines: str | Sequence[_Lines]
    line_style: _Text
    lines_from: _LinesFrom
    contour: _Contour
    contour_finder: _ContourFinder
    hidden: _Hidden
    coincident: _Coincident
    stroke_width: _StrokeWidth
    stroke_taper: _Number
    brush: _Text
    simplify: _Number
    fit_curves: _Number
    path_order: _PathOrder
    subdivide_adaptive: _Count
    isolines: _Text
    feature_size: _Number
    suggestive_threshold: _Number
    ridge_threshold: _Number
    apparent_threshold: _Number
    style: _Style
    hatch_bend: _Number
    hatch_shade: _Number
    hatch_width: _Number
    sumi_width: _Number
    sumi_length: _Number
    sumi_streaks: _Count
    pencil_strokes: _Count
    pencil_looseness: _Number
    pencil_seed: _Count
    shade: _Shade
    light: _Text
    detector: _Detector
    kernel: _Kernel
    depth_map: _DepthMap
    depth_threshold: _Number
    normal_threshold: _Number
    normal_lights: _NormalLights
    light_space: _LightSpace
    profile_limit: _Number
    edge_limit: _Number
    function: _Text

class LinesSettings(TypedDict, total=False):
    preset: str
    size: _Text
    crop: _Text
    scale: _Text
    line_color: _Text
    background: _Text
    line_width: _Text
    dpi: _Number
    page_size: _Text
    supersampling: _Count
    tile_size: _Count
    lines: str | Sequence[_Lines]
    line_style: _Text
    lines_from: _LinesFrom
    contour: _Contour
    contour_finder: _ContourFinder
    hidden: _Hidden
    coincident: _Coincident
    stroke_width: _StrokeWidth
    stroke_taper: _Number
    brush: _Text
    simplify: _Number
    fit_curves: _Number
    path_order: _PathOrder
    subdivide_adaptive: _Count
    isolines: _Text
    feature_size: _Number
    suggestive_threshold: _Number
    ridge_threshold: _Number
    apparent_threshold: _Number
    style: _Style
    hatch_bend: _Number
    hatch_shade: _Number
    hatch_width: _Number
    sumi_width: _Number
    sumi_length: _Number
    sumi_streaks: _Count
    pencil_strokes: _Count
    pencil_looseness: _Number
    pencil_seed: _Count
    shade: _Shade
    light: _Text
    detector: _Detector
    kernel: _Kernel
    depth_map: _DepthMap
    depth_threshold: _Number
    normal_threshold: _Number
    normal_lights: _NormalLights
    light_space: _LightSpace
    profile_limit: _Number
    edge_limit: _Number
    function: _Text

# /settings
class Error(Exception): ...
class RuntimeError(Error, builtins.RuntimeError): ...
class UsageError(Error, ValueError): ...
class InputError(Error, OSError): ...
class ContextError(Error, builtins.RuntimeError): ...
class OutputError(Error, OSError): ...
class StoppedError(Error, builtins.RuntimeError): ...
class Warning(UserWarning): ...

class LineType(enum.IntFlag):
    OUTLINE = 1
    OCCLUSION = 2
    BOUNDARY = 4
    CREASE = 8
    INTERSECTION = 16
    OBJECT = 32
    ISOPARAMETRIC = 64
    MARKED = 128
    SUGGESTIVE = 256
    RIDGE = 512
    VALLEY = 1024
    APPARENT = 2048
    TANGENT = 4096

@final
class Setting:
    @property
    def name(self) -> str: ...
    @property
    def short_name(self) -> str: ...
    @property
    def flag(self) -> str: ...
    @property
    def group(self) -> str: ...
    @property
    def kind(self) -> Literal["number", "count", "choice", "list", "text"]: ...
    @property
    def choices(self) -> tuple[str, ...]: ...
    @property
    def values(self) -> str: ...
    @property
    def range(self) -> str: ...
    @property
    def default(self) -> str: ...
    @property
    def help(self) -> str: ...

@final
class Instance:
    @property
    def id(self) -> int: ...
    @property
    def node(self) -> str: ...
    @property
    def mesh(self) -> str: ...
    @property
    def materials(self) -> list[int]: ...
    @property
    def transform(self) -> NDArray[np.float64]: ...

@final
class Scene:
    @staticmethod
    def load(path: _Path, **settings: Unpack[LoadSettings]) -> Scene: ...
    @staticmethod
    def from_arrays(
        vertices: ArrayLike | Sequence[ArrayLike],
        faces: ArrayLike | Sequence[ArrayLike] | None,
        normals: ArrayLike | Sequence[ArrayLike | None] | None = None,
        uv: ArrayLike | Sequence[ArrayLike | None] | None = None,
        transforms: ArrayLike | Sequence[ArrayLike | None] | None = None,
        names: str | Sequence[str] | Sequence[str | Sequence[str] | None] | None = None,
        **settings: Unpack[ArraysSettings],
    ) -> Scene: ...
    @property
    def triangles(self) -> int: ...
    @property
    def box(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
    @property
    def centre(self) -> NDArray[np.float64]: ...
    @property
    def radius(self) -> float: ...
    @property
    def up(self) -> NDArray[np.float64]: ...
    @property
    def front(self) -> NDArray[np.float64]: ...
    @property
    def instances(self) -> list[Instance]: ...
    @property
    def material_names(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...

@final
class CameraMatrices:
    @property
    def size(self) -> tuple[int, int]: ...
    @property
    def view(self) -> NDArray[np.float64]: ...
    @property
    def projection(self) -> NDArray[np.float64]: ...
    @property
    def world_to_camera(self) -> NDArray[np.float64]: ...
    @property
    def K(self) -> NDArray[np.float64]: ...
    @property
    def near(self) -> float: ...
    @property
    def far(self) -> float: ...
    @property
    def orthographic_height(self) -> float: ...
    def to_dict(self) -> dict[str, Any]: ...

@final
class Camera:
    @staticmethod
    def frame(scene: Scene, **settings: Unpack[FrameSettings]) -> Camera: ...
    @staticmethod
    def look_at(
        eye: ArrayLike, target: ArrayLike, up: ArrayLike | None = None, **settings: Unpack[LookAtSettings]
    ) -> Camera: ...
    @staticmethod
    def from_matrices(view: ArrayLike, projection: ArrayLike) -> Camera: ...
    @staticmethod
    def from_intrinsics(
        K: ArrayLike, pose: ArrayLike, convention: Literal["opencv", "opengl"] = "opencv"
    ) -> Camera: ...
    def matrices(self, scene: Scene, **settings: Unpack[RenderSettings]) -> CameraMatrices: ...

@final
class Backend:
    @property
    def backend(self) -> str: ...
    @property
    def platform(self) -> str: ...
    @property
    def vendor(self) -> str: ...
    @property
    def renderer(self) -> str: ...
    @property
    def version(self) -> str: ...
    @property
    def software(self) -> bool: ...

@final
class Maps(Mapping[str, NDArray[Any]]):
    def __getitem__(self, key: str) -> NDArray[Any]: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def keys(self) -> KeysView[str]: ...
    def values(self) -> ValuesView[NDArray[Any]]: ...
    def items(self) -> ItemsView[str, NDArray[Any]]: ...
    @property
    def camera(self) -> CameraMatrices: ...
    @property
    def instance_names(self) -> list[str]: ...
    @property
    def material_names(self) -> list[str]: ...
    @property
    def backend(self) -> Backend: ...
    @property
    def times(self) -> dict[str, float]: ...
    @property
    def warnings(self) -> list[str]: ...

@final
class Lines:
    def __len__(self) -> int: ...
    @property
    def pixels(self) -> list[NDArray[np.float64]]: ...
    @property
    def positions(self) -> list[NDArray[np.float64]]: ...
    @property
    def strengths(self) -> list[NDArray[np.float64]]: ...
    @property
    def types(self) -> NDArray[np.uint16]: ...
    @property
    def ids(self) -> NDArray[np.uint32]: ...
    @property
    def visible(self) -> NDArray[np.bool_]: ...
    @property
    def closed(self) -> NDArray[np.bool_]: ...
    @property
    def objects(self) -> NDArray[np.uint32]: ...
    @property
    def patches(self) -> NDArray[np.uint32]: ...
    @property
    def widths(self) -> NDArray[np.float64]: ...
    @property
    def camera(self) -> CameraMatrices: ...
    @property
    def instances(self) -> list[Instance]: ...
    @property
    def times(self) -> dict[str, float]: ...
    @property
    def warnings(self) -> list[str]: ...
    def svg(self) -> str: ...
    def write(self, path: _Path) -> None: ...

@final
class Renderer:
    def __init__(
        self, backend: _Backend = "auto", device: int | None = None, *, lazy: bool = False
    ) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *raised: object) -> None: ...
    def close(self) -> None: ...
    @property
    def backend(self) -> Backend: ...
    def render(
        self, scene: Scene, camera: Camera, *, writable: bool = False, **settings: Unpack[RenderSettings]
    ) -> Maps: ...
    def lines(self, scene: Scene, camera: Camera, **settings: Unpack[LinesSettings]) -> Lines: ...

@final
class LinesComparison:
    @property
    def same(self) -> bool: ...
    @property
    def share(self) -> float: ...
    @property
    def changes(self) -> list[dict[str, Any]]: ...
    def write(self, path: _Path) -> None: ...

@final
class PictureComparison:
    @property
    def same(self) -> bool: ...
    @property
    def share(self) -> float: ...
    @property
    def maximum(self) -> float: ...

def compare_lines(
    before: Lines | _Path, after: Lines | _Path, *, distance: float = 1.5, share: float = 0.0, speck: float = 4.0
) -> LinesComparison: ...
def compare_pictures(
    a: _Path,
    b: _Path,
    *,
    level: float = 0.0,
    share: float = 0.0,
    hard_limit: float | None = None,
    difference: _Path | None = None,
) -> PictureComparison: ...
def write_png(path: _Path, pixels: NDArray[np.uint8]) -> None: ...
