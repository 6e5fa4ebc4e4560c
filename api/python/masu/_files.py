"""Offline: scene files from meshes, and grid files from scene files."""

import ctypes
import operator
from ctypes import byref, c_double, c_float
from typing import Any, NamedTuple, Optional, Sequence, Tuple, Union

from ._library import (GRID_KINDS, STORES, GridOptionsRecord, MeshRecord, Path, check, choice, library, path_bytes)


class Mesh(NamedTuple):
    """Triangles: an object of a scene."""
    vertices: Any  # (V, 3), float32 or float64
    faces: Any  # (F, 3), integers below V
    color: Optional[Sequence[float]] = None  # 3, of a matte material; 0.8 each by default


def write_scene(path: Path, vertices: Any = None, faces: Any = None, color: Optional[Sequence[float]] = None, *,
                meshes: Optional[Sequence[Union[Mesh, Tuple[Any, ...]]]] = None, store: str = "auto",
                origin: Optional[Sequence[float]] = None) -> None:
    """Writes a scene file of one mesh, or of several:

        write_scene("a.scene", vertices, faces)
        write_scene("b.scene", meshes=[(floor_vertices, floor_faces), masu.Mesh(vertices, faces, (1, 0.5, 0.2))])

    vertices (V, 3) are float32 or float64, faces (F, 3) integers from 0 to V - 1; both are NumPy's arrays, or what NumPy
    makes arrays from. Triangle i of mesh m is primitive i plus the triangles of the meshes before m; m is its
    `geometry_ids`. Triangles without area are kept and can't be hit. `store`, the type of coordinates in the file, is
    "auto" (float32 unless its arithmetic is too coarse for the scene), "float32" or "float64". Coordinates are stored
    relative to `origin`, so that errors follow the scene's extent and not its position in the world: by default the
    bounds' centre, or zero where that is nearer than half their diagonal.

    The file appears whole or not at all. Raises masu.Error; TypeError and ValueError for arrays of other types, shapes
    and contents."""
    if (meshes is None) == (vertices is None) or (vertices is None) != (faces is None):
        raise TypeError("write_scene needs either vertices and faces, or meshes")
    if meshes is None:
        meshes = [Mesh(vertices, faces, color)]
    elif color is not None:
        raise TypeError("color is of vertices and faces; each of meshes has its own")
    listed = [Mesh(*mesh) for mesh in meshes]
    records = (MeshRecord * max(1, len(listed)))()
    kept = []  # the arrays that the records point to
    for index, (mesh, record) in enumerate(zip(listed, records)):
        kept.append(_fill(record, mesh, "mesh {}: ".format(index) if len(listed) > 1 else ""))
    check(library.masu_write_scene(path_bytes(path), records, len(listed), choice("store", store, STORES),
                                   None if origin is None else (c_double * 3)(*origin)))


def _fill(record: MeshRecord, mesh: Mesh, place: str) -> Any:
    import numpy as np
    vertices = np.asarray(mesh.vertices)
    faces = np.asarray(mesh.faces)
    for name, array in (("vertices", vertices), ("faces", faces)):
        if array.size and (array.ndim != 2 or array.shape[1] != 3):
            raise ValueError("{}{}: the shape (N, 3) is needed, not {}".format(place, name, array.shape))
    if vertices.size and vertices.dtype.kind not in "fiu":
        raise TypeError("{}vertices: real numbers are needed, not {}".format(place, vertices.dtype))
    if faces.size and faces.dtype.kind not in "iu":
        raise TypeError("{}faces: integers are needed, not {}".format(place, faces.dtype))
    count = vertices.size // 3
    if faces.size and not 0 <= int(faces.min()) <= int(faces.max()) < count:
        raise ValueError("{}faces: indices from {} to {}, but there are {} vertices".format(
            place, faces.min(), faces.max(), count))
    is_float32 = vertices.dtype.newbyteorder("=") == np.float32
    vertices = np.require(vertices, np.float32 if is_float32 else np.float64, ["C_CONTIGUOUS", "ALIGNED"])
    faces = np.require(faces, np.uint32, ["C_CONTIGUOUS", "ALIGNED"])
    if is_float32:
        record.vertices = vertices.ctypes.data
    else:
        record.vertices64 = vertices.ctypes.data
    record.vertex_count = count
    record.indices = faces.ctypes.data
    record.triangle_count = faces.size // 3
    color = None
    if mesh.color is not None:
        if len(mesh.color) != 3:
            raise ValueError("{}color: 3 numbers are needed, not {}".format(place, len(mesh.color)))
        color = (c_float * 3)(*(float(part) for part in mesh.color))
        record.color = ctypes.cast(color, ctypes.POINTER(c_float))
    return vertices, faces, color


def build_grid(scene: Path, grid: Path, *, kind: Optional[str] = None, division: Union[str, int, None] = None,
               box_overlap: Optional[bool] = None, cube_space: Optional[bool] = None, target: Optional[int] = None,
               alpha: Optional[float] = None, step_cost: Optional[float] = None, detail: Optional[float] = None,
               nested: Optional[int] = None, expansions: Optional[int] = None, gpu: Optional[bool] = None,
               threads: Optional[int] = None, for_cpu: Optional[bool] = None) -> None:
    """Writes the grid file of a scene file. The options are gridbuild's; None is the default.

    kind: "auto", "uniform", "x", "balance", "irregular", "bvh" or "fastest"; division: "auto", 64, "64x64x32",
    "cleary:1", …; box_overlap: a voxel lists the primitives whose bounding box meets it, not their surface; cube_space:
    the smallest cube about the origin is divided, not the primitives' bounds; target, alpha, step_cost, detail, nested,
    expansions: of merged and irregular grids; gpu: built on the first GPU; threads: 0 for all cores;
    for_cpu: what is chosen automatically is chosen for tracing on a CPU, not on a GPU.

    The file appears whole or not at all. Raises masu.Error."""
    options = GridOptionsRecord()
    library.masu_default_grid_options(byref(options))
    if kind is not None:
        options.kind = choice("kind", kind, GRID_KINDS)
    if division is not None:
        text = division if isinstance(division, str) else str(operator.index(division))
        if "\0" in text:
            raise ValueError("division: a null character")
        options.division = text.encode()
    for name, flag in (("box_overlap", box_overlap), ("cube_space", cube_space), ("gpu", gpu), ("for_cpu", for_cpu)):
        if flag is not None:
            setattr(options, name, int(bool(flag)))
    for name, integer, largest in (("target", target, 2**32 - 1), ("nested", nested, 2**31 - 1),
                                   ("expansions", expansions, 2**31 - 1), ("threads", threads, 2**31 - 1)):
        if integer is not None:
            if not 0 <= operator.index(integer) <= largest:  # ctypes would keep its low bits
                raise ValueError("{}: {} isn't from 0 to {}".format(name, integer, largest))
            setattr(options, name, operator.index(integer))
    for name, real in (("alpha", alpha), ("step_cost", step_cost), ("detail", detail)):
        if real is not None:
            setattr(options, name, float(real))
    check(library.masu_build_grid(path_bytes(scene), path_bytes(grid), byref(options)))
