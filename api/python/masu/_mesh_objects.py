"""Meshes as other libraries have them: Open3D's, trimesh's, PyVista's, meshio's, and any with the same attributes."""

from typing import Any, Tuple

from . import _arrays


def is_mesh_object(given: Any) -> bool:
    return any(hasattr(given, name) for name in ("vertex", "vertices", "points"))


def arrays_of(mesh: Any) -> Tuple[Any, Any]:
    """Its vertices (V, 3) and triangles (F, 3). A TypeError by its name for what is no mesh, or has other cells."""
    name = "{}.{}".format(type(mesh).__module__.split(".")[0], type(mesh).__name__)
    if hasattr(mesh, "triangle") and hasattr(mesh, "vertex"):  # of Open3D's tensors
        return mesh.vertex["positions"], mesh.triangle["indices"]
    vertices = getattr(mesh, "vertices", None)
    if vertices is None:
        vertices = getattr(mesh, "points", None)
    faces = getattr(mesh, "faces", None)
    if faces is None:
        faces = getattr(mesh, "triangles", None)
    if faces is None and isinstance(getattr(mesh, "cells", None), (list, tuple)):
        faces = _triangles_of_blocks(name, mesh.cells)
    if vertices is None or faces is None:
        raise TypeError("{}: a mesh with vertices and faces is needed".format(name))
    if len(getattr(mesh, "strips", ())):
        raise TypeError("{}: has strips, which aren't read: take its triangulate()".format(name))
    return vertices, _triangles_of_list(name, faces)


def _triangles_of_blocks(name: str, blocks: Any) -> Any:
    """meshio's: a type and an array each. Points and lines are left out."""
    import numpy as np
    others = sorted({block.type for block in blocks} - {"triangle", "vertex", "line"})
    if others:
        raise TypeError("{}: has cells of type {}: triangles alone are read".format(name, ", ".join(others)))
    return np.concatenate([np.zeros((0, 3), np.int64)] + [block.data for block in blocks if block.type == "triangle"])


def _triangles_of_list(name: str, faces: Any) -> Any:
    """PyVista's list has before each face the number of its corners. Other arrays stay as they are."""
    faces = _arrays.on_host("faces", faces)
    if faces.ndim != 1:
        return faces
    if faces.size % 4 or (faces[::4] != 3).any():
        raise TypeError("{}: has faces of more than three corners, which aren't read: take its triangulate()".format(name))
    return faces.reshape(-1, 4)[:, 1:]
