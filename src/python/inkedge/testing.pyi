from os import PathLike
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from . import Lines, Maps

__all__ = ["assert_same_lines", "assert_same_picture"]

_Path: TypeAlias = str | PathLike[str]

def assert_same_lines(
    actual: Lines | _Path,
    reference: _Path,
    *,
    distance: float = 1.5,
    share: float = 0.0,
    speck: float = 4.0,
    folder: _Path = "candidates",
) -> None: ...
def assert_same_picture(
    actual: NDArray[np.uint8] | Maps | _Path,
    reference: _Path,
    *,
    level: float = 0.0,
    share: float = 0.0,
    hard_limit: float | None = None,
    folder: _Path = "candidates",
) -> None: ...
