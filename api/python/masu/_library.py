"""libmasu.so by ctypes: the structures and functions of masu.h, and its errors as exceptions."""

import ctypes
import enum
import os
import pathlib
from ctypes import (POINTER, byref, c_char_p, c_double, c_float, c_int, c_size_t, c_uint32, c_uint64, c_void_p)
from typing import Any, List, Union

__version__ = "0.1.0"  # of the interface: the library's must be of the same minor version

Path = Union[str, bytes, "os.PathLike[Any]"]


class Status(enum.IntEnum):
    """What kind of error it was."""
    USAGE = 1  # an argument
    INPUT = 2  # a file that can't be read or is invalid
    OUTPUT = 3  # a file that can't be written
    DEVICE = 4  # the GPU or its driver
    MEMORY = 5  # there isn't enough memory in the host


class Error(Exception):
    """What the library refuses: a line `place: what is wrong: what to do`, and `status`, what kind of error it is."""

    def __init__(self, status: Status, message: str) -> None:
        super().__init__(status, message)
        self.status = status

    def __str__(self) -> str:
        return str(self.args[1])


# --- masu.h: the same names and order of fields -------------------------------------------------------------------

class DescriptionRecord(ctypes.Structure):
    _fields_ = [("triangles", c_uint32), ("spheres", c_uint32), ("cones", c_uint32), ("materials", c_uint32),
                ("bounds_min", c_double * 3), ("bounds_max", c_double * 3), ("scene_bytes", c_uint64),
                ("grid_bytes", c_uint64), ("is_float64", c_int), ("device", c_int), ("origin", c_double * 3),
                ("error_bound", c_double)]


class PrimitiveRecord(ctypes.Structure):
    _fields_ = [("kind", c_int), ("object", c_uint32), ("material", c_uint32), ("color", c_float * 3),
                ("diffuse", c_float), ("specular", c_float), ("shine", c_float), ("transmittance", c_float),
                ("refraction_index", c_float)]


class QueryRecord(ctypes.Structure):
    _fields_ = [("format", c_int), ("precision", c_int), ("coherent", c_int), ("stream", c_void_p),
                ("relative", c_int)]


class HitsRecord(ctypes.Structure):
    _fields_ = [("t", c_void_p), ("primitive", c_void_p), ("object", c_void_p), ("uv", c_void_p),
                ("normal", c_void_p), ("face", c_void_p)]


class MeshRecord(ctypes.Structure):
    _fields_ = [("vertices", c_void_p), ("vertices64", c_void_p), ("vertex_count", c_size_t), ("indices", c_void_p),
                ("triangle_count", c_size_t), ("color", POINTER(c_float))]


class GridOptionsRecord(ctypes.Structure):
    _fields_ = [("kind", c_int), ("division", c_char_p), ("box_overlap", c_int), ("cube_space", c_int),
                ("target", c_uint32), ("alpha", c_double), ("step_cost", c_double), ("detail", c_double),
                ("nested", c_int), ("expansions", c_int), ("gpu", c_int), ("threads", c_int),
                ("for_cpu", c_int)]


PRECISIONS = {"auto": 0, "fast": 1, "robust": 2, "double": 3}
STORES = {"auto": 0, "float32": 1, "float64": 2}
GRID_KINDS = {"auto": 0, "uniform": 1, "x": 2, "balance": 3, "irregular": 4, "bvh": 5, "fastest": 6}
KINDS = ("triangle", "sphere", "cone")
CPU = -1


# --- The library --------------------------------------------------------------------------------------------------

def _has_avx2() -> bool:
    """Whether the processor has what a wheel's library in x86-64-v3 was compiled for (MASU_AVX2)."""
    try:
        with open("/proc/cpuinfo", encoding="ascii", errors="replace") as lines:
            flags = next((line.split() for line in lines if line.startswith("flags")), [])
    except OSError:
        return False
    return {"avx2", "fma", "bmi1", "bmi2", "abm", "popcnt"}.issubset(flags)


def _candidates() -> List[str]:
    name = "libmasu.so." + __version__.split(".")[0]
    package = pathlib.Path(__file__).resolve().parent
    folders = [package, package.parent]
    if (package / "x86-64-v3").exists() and _has_avx2():
        folders.insert(0, package / "x86-64-v3")
    if package.parent.name == "dist-packages":  # PREFIX/lib/python3/dist-packages, as cmake --install has it
        folders.append(package.parents[2])
    return [str(folder / name) for folder in folders if (folder / name).exists()] + [name]


def _load() -> ctypes.CDLL:
    chosen = os.environ.get("MASU_LIBRARY")
    failures = []
    for path in [chosen] if chosen else _candidates():
        try:
            loaded = ctypes.CDLL(path)
            break
        except OSError as error:
            failures.append(str(error))
    else:
        raise ImportError("libmasu.so can't be loaded: {}: install it, or name its file in the environment variable "
                          "MASU_LIBRARY".format("; ".join(failures)))

    def declare(name: str, result: Any, *arguments: Any) -> None:
        try:
            function = getattr(loaded, name)
        except AttributeError:
            raise ImportError("{}: this isn't Masu's library: it has no {}".format(path, name)) from None
        function.restype = result
        function.argtypes = arguments

    declare("masu_version", c_char_p)
    version = loaded.masu_version().decode()
    if version.split(".")[:2] != __version__.split(".")[:2]:  # its structures may be others
        raise ImportError("{}: version {} of the library, {} of the module: install the same".format(
            path, version, __version__))
    declare("masu_error", c_char_p)
    declare("masu_gpu_count", c_int, POINTER(c_int))
    declare("masu_open_devices", c_int, c_char_p, c_char_p, POINTER(c_int), c_size_t, POINTER(c_void_p))
    declare("masu_open_brute_force", c_int, c_char_p, POINTER(c_int), c_size_t, POINTER(c_void_p))
    declare("masu_close", None, c_void_p)
    declare("masu_describe", c_int, c_void_p, POINTER(DescriptionRecord))
    declare("masu_describe_primitive", c_int, c_void_p, c_uint32, POINTER(PrimitiveRecord))
    declare("masu_nearest", c_int, c_void_p, c_void_p, c_size_t, POINTER(QueryRecord), POINTER(HitsRecord))
    declare("masu_occluded", c_int, c_void_p, c_void_p, c_size_t, POINTER(QueryRecord), c_void_p)
    declare("masu_write_scene", c_int, c_char_p, POINTER(MeshRecord), c_size_t, c_int, POINTER(c_double))
    declare("masu_default_grid_options", None, POINTER(GridOptionsRecord))
    declare("masu_build_grid", c_int, c_char_p, c_char_p, POINTER(GridOptionsRecord))
    return loaded


library = _load()


def check(status: int) -> None:
    """Raises what the thread's last call said, if it failed."""
    if status:
        raise Error(Status(status), (library.masu_error() or b"").decode(errors="replace"))


def gpu_count() -> int:
    """How many GPUs can be used: 0 where the library was built without CUDA, or there is none."""
    count = c_int()
    check(library.masu_gpu_count(byref(count)))
    return count.value


# --- Arguments ----------------------------------------------------------------------------------------------------

def path_bytes(path: Path) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:  # C would read the name up to there
        raise ValueError("a file's name can't hold a null character")
    return encoded


def choice(name: str, value: str, choices: "dict[str, int]") -> int:
    if not isinstance(value, str):
        raise TypeError("{}: a string is needed, not {}".format(name, type(value).__name__))
    if value not in choices:
        raise ValueError("{}: {!r} isn't one of {}".format(name, value, ", ".join(choices)))
    return choices[value]
