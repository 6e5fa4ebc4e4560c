"""The tracer: a scene and its grid on a device, and queries of them."""

import contextlib
import math
import operator
import re
import threading
import weakref
from ctypes import byref, c_int, c_void_p
from typing import Any, Callable, Dict, Iterable, Iterator, NamedTuple, Optional, Tuple, Union

from . import _arrays
from ._library import (CPU, KINDS, PRECISIONS, DescriptionRecord, HitsRecord, Path, PrimitiveRecord, QueryRecord, check,
                       choice, library, path_bytes)

Vector = Tuple[float, float, float]


class _Field(NamedTuple):
    record: str  # its name in masu_hits
    number: str
    shape: Tuple[int, ...]  # a ray


_FIELDS = {
    "t_hit": _Field("t", "float32", ()),
    "primitive_ids": _Field("primitive", "int32", ()),
    "geometry_ids": _Field("object", "int32", ()),
    "primitive_uvs": _Field("uv", "float32", (2,)),
    "primitive_normals": _Field("normal", "float32", (3,)),
    "face_ids": _Field("face", "int32", ()),
}
FIELDS = tuple(_FIELDS)  # of Tracer.nearest()


class Description(NamedTuple):
    """What a tracer holds."""
    triangles: int  # primitives are numbered in this order:
    spheres: int
    cones: int
    materials: int
    bounds_min: Vector  # of all primitives, in the world; min > max where there is none
    bounds_max: Vector
    scene_bytes: int  # of the files, or as a file for a grid in memory; 0 for no grid
    grid_bytes: int
    is_float64: bool  # whether coordinates are stored, and rays traced, in float64
    device: str  # as Tracer.device
    origin: Vector  # the point in the world that stored coordinates are relative to
    error_bound: float  # in scene units: how far from its surface a hit may be, with precision "auto"


class Primitive(NamedTuple):
    """A primitive, and its material."""
    kind: str  # "triangle", "sphere" or "cone"
    object: int  # its mesh, or its index in the NFF text
    material: int
    color: Vector
    diffuse: float
    specular: float
    shine: float
    transmittance: float
    refraction_index: float


def _device_number(device: Union[str, int, Any]) -> int:
    if not isinstance(device, (str, bool)):
        try:
            number = operator.index(device)
        except TypeError:
            device = str(device)  # torch.device
        else:
            if not 0 <= number < 2**31:
                raise ValueError("device: {} isn't a GPU's number".format(number))
            return number
    if device == "cpu":
        return CPU
    match = re.fullmatch("cuda(?::([0-9]{1,9}))?", device) if isinstance(device, str) else None
    if not match:
        raise ValueError("device: {!r} isn't \"cpu\", \"cuda\", \"cuda:N\" or a GPU's number".format(device))
    return int(match[1] or 0)


def _gpu_numbers(device: Any) -> Tuple[int, ...]:
    """None for the CPU."""
    if isinstance(device, (list, tuple)):
        numbers = tuple(_device_number(each) for each in device)
        if not numbers or CPU in numbers:
            raise ValueError("device: a list is of GPUs, at least one")
        return numbers
    number = _device_number(device)
    return () if number == CPU else (number,)


def _device_name(gpus: Iterable[int]) -> str:
    return ",".join("cuda:{}".format(gpu) for gpu in gpus) or "cpu"


class Tracer:
    """A scene and its grid on a device, for queries until it is closed; also a context manager.

    scene, grid: files. Without a grid one is built on the device, as build_grid(kind="fastest") does, and kept in memory:
    that takes seconds for some million primitives, at every call, where a grid file takes them once. brute_force: instead
    of that every ray is tested against every primitive, which only comparisons want. device: "cpu"; "cuda", the first GPU;
    "cuda:N" or N, the GPU of that number, from 0; or a list of such GPUs, which share arrays in host memory. The files
    are checked and, on a GPU, uploaded here. Raises masu.Error.

    **Rays** are an array (..., 6) of origin and direction, or (..., 8) of origin, tmin, direction, tmax: float32 or
    float64 (other real numbers are converted to float64). A ray's points are origin + t direction with tmin < t < tmax;
    t counts in lengths of the direction, which needn't be 1. Without them tmin is 0 and tmax infinity.

    **Where.** Arrays of NumPy, and everything that it makes arrays from, are in host memory; results are NumPy's, and
    there when the call returns. Tensors of PyTorch and arrays of CuPy on a GPU of the tracer's are read where they lie, and
    results are the same library's there; the query is only queued, on the library's current stream or on `stream`.
    Others' arrays on a GPU (those with __dlpack__ or __cuda_array_interface__) are taken over by whichever of both
    libraries is there, and so are their results. A copy is made of rays that aren't contiguous.

    **Late errors.** For rays on a GPU a query's masu.Error says that it couldn't be queued. A kernel that fails later is
    reported by what next waits for the GPU (torch.cuda.synchronize(), Tensor.cpu(), CuPy's Stream.synchronize()), in that
    library's exception, or by a later query as a masu.Error of Status.DEVICE. The process can then do nothing more on
    that GPU.

    Threads may use a tracer at the same time. close() waits for them."""

    def __init__(self, scene: Path, grid: Optional[Path] = None, device: Union[str, int, Any] = "cpu", *,
                 brute_force: bool = False) -> None:
        if brute_force and grid is not None:
            raise TypeError("brute_force uses no grid: leave one of both out")
        self._gpus = _gpu_numbers(device)
        self._idle = threading.Condition()
        self._calls = 0  # that use the handle now
        handle = c_void_p()
        gpus = (c_int * len(self._gpus))(*self._gpus), len(self._gpus)
        if brute_force:
            check(library.masu_open_brute_force(path_bytes(scene), *gpus, byref(handle)))
        else:
            check(library.masu_open_devices(path_bytes(scene), None if grid is None else path_bytes(grid), *gpus,
                                            byref(handle)))
        self._handle: Optional[c_void_p] = handle
        self._finalizer = weakref.finalize(self, library.masu_close, handle)
        self._finalizer.atexit = False  # other threads may still be tracing; the process's end frees everything

    def close(self) -> None:
        """Waits for queries that run, and gives memory back. Using the tracer afterwards is a ValueError."""
        with self._idle:
            self._handle = None
            self._idle.wait_for(lambda: self._calls == 0)
        self._finalizer()

    def __enter__(self) -> "Tracer":
        return self

    def __exit__(self, *error: Any) -> None:
        self.close()

    @contextlib.contextmanager
    def _opened(self) -> Iterator[c_void_p]:
        with self._idle:
            if self._handle is None:
                raise ValueError("the tracer is closed")
            handle = self._handle
            self._calls += 1
        try:
            yield handle
        finally:
            with self._idle:
                self._calls -= 1
                self._idle.notify_all()

    @property
    def device(self) -> str:
        """ "cpu", "cuda:0", "cuda:0,cuda:1", … """
        return _device_name(self._gpus)

    def describe(self) -> Description:
        """Counts, bounds and sizes."""
        record = DescriptionRecord()
        with self._opened() as handle:
            check(library.masu_describe(handle, byref(record)))
        return Description(record.triangles, record.spheres, record.cones, record.materials, tuple(record.bounds_min),
                           tuple(record.bounds_max), record.scene_bytes, record.grid_bytes, bool(record.is_float64),
                           self.device, tuple(record.origin), record.error_bound)

    def primitive(self, index: int) -> Primitive:
        """The primitive of an index as `primitive_ids` has it; an IndexError where there is none."""
        index = operator.index(index)
        description = self.describe()
        count = description.triangles + description.spheres + description.cones
        if not 0 <= index < count:
            raise IndexError("primitive {}: there are {}".format(index, count))
        record = PrimitiveRecord()
        with self._opened() as handle:
            check(library.masu_describe_primitive(handle, index, byref(record)))
        return Primitive(KINDS[record.kind], record.object, record.material, tuple(record.color), record.diffuse,
                         record.specular, record.shine, record.transmittance, record.refraction_index)

    def nearest(self, rays: Any, *, fields: Union[str, Iterable[str]] = ("t_hit", "primitive_ids"),
                precision: str = "auto", coherent: bool = False, stream: Any = None,
                relative: bool = False) -> Dict[str, Any]:
        """The nearest hit of each ray: a dictionary of the fields requested, each an array of the rays' leading shape.

        t_hit              float32: t, infinity for a miss
        primitive_ids      int32: the primitive's index, -1 for a miss
        geometry_ids       int32: its object (the mesh), -1 for a miss
        primitive_uvs      (..., 2) float32: the point of a triangle a b c is (1 - u - v) a + u b + v c; 0 on others
        primitive_normals  (..., 3) float32: geometric, of unit length, on the primitive's front; 0 for a miss
        face_ids           int32: of a scene from mesh2bin, the number of the file's face, through all objects in their
                           order; of others as primitive_ids; -1 for a miss

        precision: "auto" ("robust", or "double" for a scene in float64), "robust", "double", or "fast", which is for
        comparison. coherent: neighbours in the array have similar origins and directions, which changes the speed
        alone. stream: for rays on a GPU, as if the call stood in that stream's context: a stream of PyTorch, CuPy or
        CUDA Python, or a cudaStream_t as a number. relative: the rays' origins are relative to describe().origin, where
        float32 keeps its digits, and not in the world."""
        chosen = (fields,) if isinstance(fields, str) else tuple(fields)
        for name in chosen:
            if name not in _FIELDS:
                raise ValueError("fields: {!r} isn't one of {}".format(name, ", ".join(FIELDS)))

        def hits(pointers: Dict[str, int]) -> Any:
            return byref(HitsRecord(**{_FIELDS[name].record: pointer for name, pointer in pointers.items()}))

        return self._query(library.masu_nearest, hits, {name: _FIELDS[name] for name in chosen}, rays, precision, coherent,
                           stream, relative)

    def occluded(self, rays: Any, *, precision: str = "auto", coherent: bool = False, stream: Any = None,
                 relative: bool = False) -> Any:
        """Whether each ray hits anything at tmin < t < tmax: an array of bool of the rays' leading shape. Arguments are
        those of nearest()."""
        fields = {"occluded": _Field("", "bool", ())}
        return self._query(library.masu_occluded, lambda pointers: pointers["occluded"], fields, rays, precision, coherent,
                           stream, relative)["occluded"]

    def _query(self, function: Callable[..., int], argument: Callable[[Dict[str, int]], Any], fields: Dict[str, _Field],
               rays: Any, precision: str, coherent: bool, stream: Any, relative: bool) -> Dict[str, Any]:
        """argument: the function's last one, made of the pointers to the results."""
        record = QueryRecord(precision=choice("precision", precision, PRECISIONS), coherent=int(bool(coherent)),
                             relative=int(bool(relative)))
        arrays, rays = _arrays.recognize(rays, stream)
        gpu = arrays.gpu(rays)
        shape = tuple(rays.shape)
        if not shape or shape[-1] not in (6, 8):
            raise ValueError("rays: the shape (..., 6) or (..., 8) is needed, not {}".format(shape))
        if gpu is None and stream is not None:
            raise ValueError("stream: it is for rays on a GPU, and these are in host memory")
        if gpu is not None and gpu not in self._gpus:
            raise ValueError("rays are on {}, the tracer on {}: copy them, or open a tracer there".format(
                _device_name([gpu]), self.device))
        count = math.prod(shape[:-1])
        with self._opened() as handle, arrays.queue(rays, stream) as record.stream:
            rays = arrays.packed(rays)
            record.format = 2 * int(arrays.is_float64(rays)) + int(shape[-1] == 6)  # masu_ray_format
            results = {name: arrays.empty(shape[:-1] + field.shape, field.number, rays)
                       for name, field in fields.items()}
            if count and results:
                pointers = {name: arrays.pointer(array) for name, array in results.items()}
                check(function(handle, arrays.pointer(rays), count, byref(record), argument(pointers)))
        return results
