"""Structures and numbers of masu.h: the same names and order of fields."""

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_float, c_int, c_size_t, c_uint32, c_uint64, c_void_p, py_object
from typing import Any, List, TypeVar


class SceneDescriptionRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("triangles", c_uint32), ("spheres", c_uint32), ("cones", c_uint32),
                ("materials", c_uint32), ("objects", c_uint64), ("bounds_min", c_double * 3), ("bounds_max", c_double * 3),
                ("origin", c_double * 3), ("error_bound", c_double), ("bytes", c_uint64), ("is_float64", c_int),
                ("reserved", c_int)]


class GridDescriptionRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("structure", c_int), ("merge", c_int), ("division", c_uint32 * 3),
                ("reserved", c_uint32), ("cells", c_uint64), ("nodes", c_uint64), ("references", c_uint64),
                ("bytes", c_uint64)]


class PrimitiveRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("kind", c_int), ("object", c_uint32), ("material", c_uint32), ("face", c_uint32),
                ("color", c_float * 3), ("diffuse", c_float), ("specular", c_float), ("shine", c_float),
                ("transmittance", c_float), ("refraction_index", c_float)]


class FaultsRecord(ctypes.Structure):
    _fields_ = [("count", c_uint64), ("primitives", c_uint32 * 8), ("corners", c_uint32 * 8)]


class MeshCheckRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("points", c_uint64), ("edges", c_uint64),
                *((name, FaultsRecord) for name in ("open_edges", "inconsistent_edges", "nonmanifold_edges",
                                                    "faces_without_area", "duplicate_faces"))]


GoOn = CFUNCTYPE(c_int, py_object, c_double)
_GO_ON: List[Any] = [("go_on", GoOn), ("user", c_void_p)]  # the last fields of options: see call()


class QueryRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("format", c_int), ("precision", c_int), ("coherent", c_int), ("relative", c_int),
                ("stream", c_void_p), ("threads", c_int), ("faces", c_int), ("exclude", c_void_p),
                ("object_masks", c_void_p), ("object_count", c_size_t), ("ray_masks", c_void_p), ("loop", c_int),
                ("reserved", c_int), *_GO_ON, ("exclude_objects", c_void_p), ("worlds", c_void_p)]


class HitsRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("t", c_void_p), ("primitive", c_void_p), ("object", c_void_p), ("uv", c_void_p),
                ("normal", c_void_p), ("face", c_void_p), ("t64", c_void_p), ("front", c_void_p),
                ("position", c_void_p), ("shading", c_void_p)]


class ValuesRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("values", c_void_p), ("width", c_size_t), ("count", c_size_t), ("indices", c_void_p),
                ("triangle_count", c_size_t), ("per_face", c_int), ("reserved", c_int), ("stream", c_void_p)]


class MeshRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("vertices", c_void_p), ("vertices64", c_void_p), ("vertex_count", c_size_t),
                ("indices", c_void_p), ("triangle_count", c_size_t), ("color", POINTER(c_float))]


class QuadricsRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("values", c_void_p), ("values64", c_void_p), ("count", c_size_t),
                ("color", POINTER(c_float))]


class PlacementRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("transform", c_double * 12), ("mesh", c_uint32), ("mask", c_uint32), ("world", c_uint32),
                ("reserved", c_uint32)]


class GeometryRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("meshes", POINTER(MeshRecord)), ("mesh_count", c_size_t),
                ("spheres", POINTER(QuadricsRecord)), ("sphere_count", c_size_t), ("cones", POINTER(QuadricsRecord)),
                ("cone_count", c_size_t), ("origin", POINTER(c_double)), ("store", c_int), ("reserved", c_int), *_GO_ON,
                ("placements", POINTER(PlacementRecord)), ("placement_count", c_size_t)]


class BuildOptionsRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("structure", c_int), ("merge", c_int), ("division", c_char_p),
                ("box_overlap", c_int), ("cube_space", c_int), ("alpha", c_double), ("step_cost", c_double),
                ("detail", c_double), ("target", c_uint32), ("nested", c_int), ("expand", c_int), ("device", c_int),
                ("threads", c_int), ("for_cpu", c_int), ("quality", c_int), ("reserved", c_int), *_GO_ON]


class TracerOptionsRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("gpus", POINTER(c_int)), ("gpu_count", c_size_t), ("brute_force", c_int),
                ("quality", c_int), *_GO_ON]


class VerticesRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("values", c_void_p), ("values64", c_void_p), ("count", c_size_t), ("stream", c_void_p)]


class TransformsRecord(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("values", c_void_p), ("values64", c_void_p), ("count", c_size_t), ("indices", c_void_p),
                ("square", c_int), ("reserved", c_int), ("stream", c_void_p)]


Record = TypeVar("Record", bound=ctypes.Structure)


def sized(record: Record) -> Record:
    """The same record, whose size is set."""
    record.size = ctypes.sizeof(record)
    return record


FACES = {"both": 0, "front": 1, "back": 2}
LOOPS = {"auto": 0, "thread_per_ray": 1, "warp": 2, "warp_refill": 3}
PRECISIONS = {"auto": 0, "fast": 1, "robust": 2, "double": 3}
STORES = {"auto": 0, "float32": 1, "float64": 2}
STRUCTURES = {"grid": 0, "bvh": 1, "fastest": 2, "auto": 3}
MERGES = {"auto": 0, "none": 1, "x": 2, "balance": 3, "irregular": 4}
QUALITIES = {"high": 0, "fast": 1}
KINDS = ("triangle", "sphere", "cone")
CPU = -1
EVERY_WORLD = 2**32 - 1
