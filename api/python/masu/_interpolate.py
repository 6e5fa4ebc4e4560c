"""Values at the corners of triangles, interpolated at hits."""

import math
from ctypes import byref
from typing import Any, Mapping

from . import _arrays
from ._library import call, library
from ._records import ValuesRecord, sized


def interpolate(hits: Mapping[str, Any], values: Any, faces: Any = None, *, stream: Any = None) -> Any:
    """Values at hits, such as normals, texture coordinates and colours: an array (..., K) of float32 of the hits' shape.

    hits: results of a query, with primitive_ids and primitive_uvs. values: (V, K) at the vertices of faces, (F, 3), as a
    scene is made of; or without faces (F, 3, K) at the corners of each face, or (F, K) of each face, without
    interpolation and primitive_uvs. They are numbered as the scene's primitives, through all its meshes, and computed as
    float32. A miss, a sphere or cone, and a face whose indices aren't below V have zeros.

    All are arrays of one library, in host memory or on one GPU, where the work is queued on the library's current stream
    or on `stream`. There are no gradients."""
    arrays, ids = _arrays.recognize("primitive_ids", hits["primitive_ids"], stream)
    given = {"values": values, "faces": faces, "primitive_uvs": hits.get("primitive_uvs")}
    for name, array in given.items():
        if array is not None:
            given[name] = _arrays.beside(ids, name, array, stream)
            if given[name] is None:
                raise ValueError("{}: an array of the library of primitive_ids is needed, where these are".format(name))
    values, faces, uvs = given.values()
    shape, needed = tuple(values.shape), "(V, K)" if faces is not None else "(F, K) or (F, 3, K)"
    are_corners = faces is None and len(shape) == 3 and shape[1] == 3
    _arrays.check_shape("values", values, len(shape) == 2 or are_corners, needed)
    if faces is not None:
        _arrays.check_shape("faces", faces, len(faces.shape) == 2 and faces.shape[1] == 3, "(F, 3)")
    per_face = faces is None and len(shape) == 2
    if not per_face and (uvs is None or tuple(uvs.shape) != tuple(ids.shape) + (2,)):
        raise ValueError("primitive_uvs: they are needed of all primitive_ids: ask for both fields")
    record = sized(ValuesRecord(width=shape[-1], count=math.prod(shape[:-1]), per_face=int(per_face),
                                triangle_count=shape[0] if faces is None else faces.shape[0]))
    with arrays.queue(ids, stream) as record.stream:
        def floats(name: str, array: Any) -> Any:
            packed = arrays.packed(array, name)
            return _arrays.float32(packed) if _arrays.is_float64(packed) else packed

        values, ids = floats("values", values), arrays.packed_int32(ids, "primitive_ids")
        faces = None if faces is None else arrays.packed_int32(faces, "faces")
        uvs = None if per_face else floats("primitive_uvs", uvs)
        record.values = arrays.pointer(values)
        record.indices = None if faces is None else arrays.pointer(faces)
        results = arrays.empty(tuple(ids.shape) + (shape[-1],), "float32", ids)
        count = math.prod(tuple(ids.shape))
        if count and shape[-1]:
            call(library.masu_interpolate, byref(record), arrays.pointer(ids), None if uvs is None else arrays.pointer(uvs),
                 count, arrays.pointer(results))
    return results
