"""What each does, with its units and errors, stands in the headers of include/toile."""
import os
from typing import Any, Optional, Sequence, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Path = Union[str, "os.PathLike[str]"]
Json = dict[str, Any]

class Error(Exception): ...

class Mesh:
    """points (n, 3), in the file's unit; triangles (m, 3), indices of points, or empty."""
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    def __init__(self, points: ArrayLike, triangles: ArrayLike = ...) -> None: ...

class Body:
    """points (n, 3), metres, y up; triangles (m, 3), outward; joints as body.body.json."""
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    joints: Optional[Json]
    report: Optional[Json]
    def __init__(self, points: ArrayLike, triangles: ArrayLike,
                 joints: Optional[Json] = ...) -> None: ...

class SewingPattern:
    """json as docs/pattern.schema.json states it; name stands for the file in messages."""
    json: Json
    name: str
    report: Optional[Json]
    def __init__(self, json: Json, name: str = ...) -> None: ...

class Garment:
    """flat (n, 2) and placed (n, 3), metres, per material point; triangles (m, 3) of them."""
    flat: NDArray[np.float64]
    placed: NDArray[np.float64]
    triangles: NDArray[np.int32]
    json: Json
    report: Optional[Json]
    def __init__(self, flat: ArrayLike, placed: ArrayLike, triangles: ArrayLike,
                 json: Json) -> None: ...

class Drape:
    """points (k, 3), metres: nodes; triangles (m, 3) of nodes, in the garment's order."""
    points: NDArray[np.float64]
    triangles: NDArray[np.int32]
    garment: Garment
    started: NDArray[np.float64]
    report: Optional[Json]
    def __init__(self, points: ArrayLike, triangles: ArrayLike, garment: Garment) -> None: ...

def read_mesh(file: Path) -> Mesh: ...
def read_body(file: Path) -> Body: ...
def read_pattern(file: Path) -> SewingPattern: ...
def read_garment(file: Path) -> Garment: ...
def read_drape(file: Path, garment: Garment) -> Drape: ...
def write(value: Union[Body, SewingPattern, Garment, Drape], file: Path) -> None: ...
@overload
def clean(mesh: Mesh, *, metres_per_unit: Optional[float] = ..., height: Optional[float] = ...,
          up: str = ..., front: str = ..., as_points: bool = ...,
          edge_length: Optional[float] = ...) -> Body: ...
@overload
def clean(files: Sequence[Path], *, metres_per_unit: Optional[float] = ...,
          height: Optional[float] = ..., up: str = ..., front: str = ..., as_points: bool = ...,
          edge_length: Optional[float] = ...) -> Body: ...
def mannequin(measures: dict[str, float] = ..., figure: str = ...) -> Body: ...
def measure(body: Body, *, freehand: Sequence[str] = ..., unit: str = ...) -> Json: ...
def import_pattern(drawing: Path, *, metres_per_unit: Optional[float] = ..., size: str = ...,
                   seam_allowance: Optional[float] = ..., unfold: Sequence[str] = ...,
                   names: Sequence[str] = ..., pairs: Sequence[str] = ...,
                   singles: Sequence[str] = ..., without: Sequence[str] = ...,
                   cut_line: bool = ...) -> SewingPattern: ...
def find_seams(pattern: SewingPattern, *, keep: bool = ..., sewn: Sequence[str] = ...,
               with_: Sequence[str] = ..., without: Sequence[str] = ...,
               min_confidence: float = ..., time_limit: float = ...) -> SewingPattern: ...
def mesh(pattern: SewingPattern, *, edge_length: float = ..., subdivisions: int = ...) -> Garment: ...
def dress(garment: Garment, body: Body, *, fabric: str = ..., fabrics: dict[str, str] = ...,
          quality: str = ..., has_floor: bool = ..., earlier: Optional[Drape] = ...) -> Drape: ...
def judge(drape: Drape, body: Body) -> Json: ...
def ease(drape: Drape, body: Body, *, target: str = ..., heights: Sequence[float] = ...,
         contact: Optional[float] = ...) -> Json: ...
def gaps(drape: Drape, body: Body) -> NDArray[np.float64]: ...
