"""The tracer: a scene and its grid on a device, and queries of them."""

import copy
import functools
import math
import operator
import secrets
import weakref
from ctypes import byref, c_int
from typing import Any, Callable, Dict, Iterable, NamedTuple, Optional, Tuple, Union

from . import _arrays
from ._grid import Grid
from ._library import Progress, Resource, call, choice, device_number, library
from ._records import (CPU, FACES, LOOPS, PRECISIONS, QUALITIES, HitsRecord, QueryRecord, TracerOptionsRecord,
                       TransformsRecord, VerticesRecord, sized)
from ._scene import Scene


class Field(NamedTuple):
    record: str  # its name in masu_hits
    number: str
    shape: Tuple[int, ...]  # a ray


_FIELDS = {
    "t_hit": Field("t", "float32", ()),
    "primitive_ids": Field("primitive", "int32", ()),
    "geometry_ids": Field("object", "int32", ()),
    "primitive_uvs": Field("uv", "float32", (2,)),
    "primitive_normals": Field("normal", "float32", (3,)),
    "face_ids": Field("face", "int32", ()),
    "t_hit64": Field("t64", "float64", ()),
    "front": Field("front", "bool", ()),
    "positions": Field("position", "float64", (3,)),
    "normals": Field("shading", "float32", (3,)),
}
FIELDS = tuple(_FIELDS)  # of Tracer.nearest() and all_hits()
_CLOSEST_FIELDS = {
    "distances": Field("t64", "float64", ()),
    "points": _FIELDS["positions"],
    **{name: _FIELDS[name] for name in ("primitive_ids", "geometry_ids", "primitive_uvs", "primitive_normals", "face_ids",
                                           "normals")},
}
CLOSEST_FIELDS = tuple(_CLOSEST_FIELDS)  # of Tracer.closest()


def chosen(fields: Union[str, Iterable[str]], known: Dict[str, Field] = _FIELDS) -> Dict[str, Field]:
    chosen = (fields,) if isinstance(fields, str) else tuple(fields)
    for name in chosen:
        if name not in known:
            raise ValueError("fields: {!r} isn't one of {}".format(name, ", ".join(known)))
    return {name: known[name] for name in chosen}


def _hits(pointers: Dict[str, int], known: Dict[str, Field] = _FIELDS) -> Any:
    return byref(sized(HitsRecord(**{known[name].record: pointer for name, pointer in pointers.items()})))


_tracers: "dict[int, weakref.ref[Tracer]]" = {}  # of those that are there


def _int32(name: str, number: int) -> int:
    """Of its 32 bits."""
    if not -2**31 <= number < 2**32:
        raise ValueError("{}: {} isn't of 32 bits".format(name, number))
    return (number + 2**31) % 2**32 - 2**31


def tracer_of(number: int) -> "Tracer":
    """The tracer whose `number` it is. A ValueError where none has it that is still there."""
    reference = _tracers.get(number)
    tracer = reference() if reference else None
    if tracer is None:
        raise ValueError("tracer: {} is the number of none that is there in this process".format(number))
    return tracer


def _made_again(kind: Any, scene: Scene, grid: Optional[Grid], gpus: Tuple[int, ...]) -> "Tracer":
    made: Tracer = kind(scene, grid, list(gpus) or "cpu", brute_force=grid is None)
    return made


def rays_from(points: Any, direction: Iterable[float] = (1, 0, 0), stream: Any = None) -> Any:
    """A ray (..., 6) from each point (..., 3), of the same library and in the same memory."""
    arrays, points = _arrays.recognize("points", points, stream)
    with arrays.queue(points, stream):
        points = arrays.packed(points, "points")
        rays = arrays.empty(tuple(points.shape[:-1]) + (6,), "float64" if _arrays.is_float64(points) else "float32", points)
        rays[..., :3] = points
        for axis, component in enumerate(direction):
            rays[..., 3 + axis] = component
    return rays


def _gpu_numbers(device: Any) -> Tuple[int, ...]:
    """None for the CPU."""
    if isinstance(device, (list, tuple)):
        numbers = tuple(device_number(each) for each in device)
        if not numbers or CPU in numbers:
            raise ValueError("device: a list is of GPUs, at least one")
        return numbers
    number = device_number(device)
    return () if number == CPU else (number,)


def _device_name(gpus: Iterable[int]) -> str:
    return ",".join("cuda:{}".format(gpu) for gpu in gpus) or "cpu"


class Tracer(Resource):
    """A scene and its grid on a device, for queries until it is closed; also a context manager.

    Without a grid what answers soonest is built on the device: scene.build(structure="bvh", quality="fast"), or a grid
    where the scene is too large for a hierarchy. Of placed meshes each gets a hierarchy of that `quality`. brute_force:
    instead of that every ray is tested against every primitive, which only comparisons want. device: "cpu"; "cuda", the
    first GPU; "cuda:N" or N, the GPU of that number, from 0; or a list of such GPUs, which share arrays in host memory.
    Raises masu.Error.

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

    Threads may use a tracer at the same time. close() waits for them.

    **Long calls.** `progress` is a function that gets the share of the work that is done, from 0 to 1, about every tenth of a
    second: of building a grid, or of a query of arrays in host memory. What it raises ends the call, and so does what
    the handler of a signal raises, as KeyboardInterrupt; on a GPU after the million rays that are traced then. close()
    in a handler that is called within a query is a RuntimeError.

    **Copies** by copy.copy() share the tracer, update() moves all of them, and each is closed for itself; so do copies of
    scenes and grids. copy.deepcopy() makes another tracer of the same scene and grid. Pickling goes through the bytes of
    files: of a scene that was pickled, update() takes vertices as of one from a file. A tracer that was moved is a
    TypeError."""

    _name = "tracer"
    scene: Scene
    number: int  # by which operators of PyTorch know it: drawn, so that it is nobody else's in another process

    def __init__(self, scene: Scene, grid: Optional[Grid] = None, device: Union[str, int, Any] = "cpu", *,
                 brute_force: bool = False, quality: str = "high", progress: Progress = None) -> None:
        if not isinstance(scene, Scene):
            raise TypeError("scene: a masu.Scene is needed, not {}: masu.load() reads files".format(type(scene).__name__))
        if grid is not None and not isinstance(grid, Grid):
            raise TypeError("grid: a masu.Grid is needed, not {}: masu.load_grid() reads files".format(type(grid).__name__))
        if brute_force and grid is not None:
            raise TypeError("brute_force uses no grid: leave one of both out")
        self._gpus = _gpu_numbers(device)
        self._objects = scene.describe().objects  # the scene may be closed while the tracer lives
        options = sized(TracerOptionsRecord(gpus=(c_int * len(self._gpus))(*self._gpus), gpu_count=len(self._gpus),
                                            brute_force=int(brute_force), quality=choice("quality", quality, QUALITIES)))
        self._is_placed = scene._placements > 0
        self._own(library.masu_tracer_create, scene, grid, byref(options), options=options, progress=progress)
        self._is_built = grid is None and not brute_force and not self._is_placed
        if self._is_built and not self._gpus:
            grid = Grid._of(library.masu_tracer_grid, self)
        self.scene, self._grid = scene, grid
        self._register()

    def _register(self) -> None:
        self.number = secrets.randbits(62)
        _tracers[self.number] = weakref.ref(self, functools.partial(_tracers.pop, self.number))  # of C, as Free is

    def __copy__(self) -> "Tracer":
        copied = super().__copy__()
        copied._register()
        return copied

    def __deepcopy__(self, memo: Any) -> "Tracer":
        scene, grid = self._parts()
        return _made_again(type(self), copy.copy(scene), copy.copy(grid), self._gpus)

    def __reduce__(self) -> Any:
        return _made_again, (type(self), *self._parts(), self._gpus)

    def _parts(self) -> Tuple[Scene, Optional[Grid]]:
        if self._is_placed:
            raise TypeError("a tracer of placed meshes isn't copied or pickled")
        if self._opened().held.is_moved:
            raise TypeError("a tracer that update() has moved isn't copied or pickled: make a masu.Scene of the vertices")
        return self.scene, self.grid

    @property
    def grid(self) -> Optional[Grid]:
        """None for brute force and placed meshes. What was built on GPUs is copied from there when it is first asked for."""
        if self._grid is None and self._is_built:
            self._grid = Grid._of(library.masu_tracer_grid, self)
        return self._grid

    @property
    def device(self) -> str:
        """ "cpu", "cuda:0", "cuda:0,cuda:1", … """
        return _device_name(self._gpus)

    def __repr__(self) -> str:
        if self._handle is None:
            return "<masu.Tracer: closed>"
        return "<masu.Tracer on {}: {!r}, {!r}>".format(self.device, self.scene, self.grid or (
            "placed meshes" if self._is_placed else "brute force"))

    def update(self, vertices: Any, *, stream: Any = None) -> None:
        """Moves the triangles of the scene, and refits the tracer's hierarchy, which must be one (structure="bvh", best with
        quality="fast"); spheres and cones stay. vertices: (V, 3) of float32 or float64, as many as the scene was made of, of
        all meshes one after the other, or of a scene from a file three per triangle. Where they lie on a GPU and the tracer
        is there, nothing is copied to the host. Hits are those of a new scene of these vertices with the same origin and
        store.

        The tracer alone moves: its scene and grid stay what it was made of. Queries of other threads are of the positions
        before or after, all their rays alike. After an error the tracer is as it was. stream: as nearest() has it, of what
        writes the vertices; it is waited for."""
        arrays, vertices = _arrays.recognize("vertices", vertices, stream)
        _arrays.check_shape("vertices", vertices, len(vertices.shape) == 2 and vertices.shape[1] == 3, "(N, 3)")
        if arrays.gpu(vertices, "vertices") is None and stream is not None:
            raise ValueError("stream: it is for vertices on a GPU, and these are in host memory")
        record = sized(VerticesRecord(count=len(vertices)))
        held = self._opened().held
        with arrays.queue(vertices, stream) as record.stream:
            vertices = arrays.packed(vertices, "vertices")
            setattr(record, "values64" if _arrays.is_float64(vertices) else "values", arrays.pointer(vertices))
            call(library.masu_tracer_update, self, byref(record))
        held.is_moved = True

    def place(self, transforms: Any, indices: Any = None, *, stream: Any = None) -> None:
        """Moves the scene's placements. transforms: (N, 3, 4) or (N, 4, 4) of float32 or float64, of all of them in their
        order, or of those of the indices (N,). Hits are those of a new scene with the same origin and store. The tracer
        alone moves; queries of other threads are of the placements before or after, and after an error it is as it was.
        stream: as update() has it."""
        arrays, transforms = _arrays.recognize("transforms", transforms, stream)
        shape = tuple(transforms.shape)
        _arrays.check_shape("transforms", transforms, shape[1:] in ((3, 4), (4, 4)), "(N, 3, 4) or (N, 4, 4)")
        if arrays.gpu(transforms, "transforms") is None and stream is not None:
            raise ValueError("stream: it is for transforms on a GPU, and these are in host memory")
        record = sized(TransformsRecord(count=len(transforms), square=int(shape[1] == 4)))
        with arrays.queue(transforms, stream) as record.stream:
            transforms = arrays.packed(transforms, "transforms")
            setattr(record, "values64" if _arrays.is_float64(transforms) else "values", arrays.pointer(transforms))
            if indices is not None:
                others, indices = _arrays.recognize("indices", indices, stream)
                _arrays.check_shape("indices", indices, tuple(indices.shape) == shape[:1], shape[:1])
                indices = others.packed_int32(indices, "indices")
                record.indices = others.pointer(indices)
            call(library.masu_tracer_place, self, byref(record))

    def nearest(self, rays: Any, *, fields: Union[str, Iterable[str]] = ("t_hit", "primitive_ids"),
                precision: str = "auto", coherent: bool = False, stream: Any = None, relative: bool = False,
                threads: int = 0, faces: str = "both", exclude: Any = None, object_masks: Any = None,
                ray_masks: Any = None, worlds: Any = None, loop: str = "auto", progress: Progress = None) -> Dict[str, Any]:
        """The nearest hit of each ray: a dictionary of the fields requested, each an array of the rays' leading shape.

        t_hit              float32: t, infinity for a miss
        primitive_ids      int32: the primitive's index, -1 for a miss
        geometry_ids       int32: its object (the mesh), -1 for a miss
        primitive_uvs      (..., 2) float32: the point of a triangle a b c is (1 - u - v) a + u b + v c; 0 on others
        primitive_normals  (..., 3) float32: geometric, of unit length, on the primitive's front; 0 for a miss
        face_ids           int32: of a scene from mesh2bin, the number of the file's face, through all objects in their
                           order; of others as primitive_ids; -1 for a miss
        t_hit64            float64: t with all digits that the precision has
        front              bool: whether the ray meets the front
        positions          (..., 3) float64: the point of the primitive that is hit, in the rays' coordinates; NaN for a miss
        normals            (..., 3) float32: shading normals, of unit length: interpolated where a scene from a file has them
                           at its corners (masu.load(path, smooth=True)), else primitive_normals

        precision: "auto" ("robust", or "double" for a scene in float64), "robust", "double", or "fast", which is for
        comparison. coherent: neighbours in the array have similar origins and directions, which changes the speed
        alone. stream: for rays on a GPU, as if the call stood in that stream's context: a stream of PyTorch, CuPy or
        CUDA Python, or a cudaStream_t as a number. relative: the rays' origins are relative to scene.describe().origin,
        where float32 keeps its digits, and not in the world. threads: of this machine, for rays in its memory; 0: all
        cores. faces: "both", "front" or "back", which alone are hit. exclude: for each ray a primitive that it doesn't
        hit, or -1: whole numbers of the rays' leading shape, where the rays are. object_masks: whole numbers of 32 bits,
        or bool, for each object of the scene, where the rays are; a ray hits the objects whose mask isn't 0, or, with
        ray_masks, one for each ray, those whose mask shares a bit with its own. For each of these three one number may
        stand for all. Of placed meshes alone: exclude has another dimension, of 2, for pairs of geometry_ids and
        primitive_ids; worlds: the number of each ray's world, or of all rays', 0 by default; with ray_masks alone those of
        placements count. loop: how a GPU schedules rays without t_hit64, front, sides, exclude and masks, which changes the
        speed alone: "auto" (by a look at the rays, or by `coherent`), "thread_per_ray", "warp" or
        "warp_refill"."""
        return self._query(library.masu_nearest, lambda pointers: (_hits(pointers),), chosen(fields), locals())

    def occluded(self, rays: Any, *, precision: str = "auto", coherent: bool = False, stream: Any = None,
                 relative: bool = False, threads: int = 0, faces: str = "both", exclude: Any = None,
                 object_masks: Any = None, ray_masks: Any = None, worlds: Any = None, loop: str = "auto",
                 progress: Progress = None) -> Any:
        """Whether each ray hits anything at tmin < t < tmax: an array of bool of the rays' leading shape. Arguments are
        those of nearest()."""
        return self._query_one(library.masu_occluded, "bool", locals())

    def all_hits(self, rays: Any, limit: int, *,
                 fields: Union[str, Iterable[str]] = ("t_hit", "primitive_ids", "front"), precision: str = "auto",
                 stream: Any = None, relative: bool = False, threads: int = 0, faces: str = "both",
                 exclude: Any = None, object_masks: Any = None, ray_masks: Any = None,
                 progress: Progress = None) -> Dict[str, Any]:
        """The first `limit` hits of each ray, at least 1, in their order: each field of nearest() with a dimension of
        that length after the rays' leading shape, the hits and then misses; and "counts", int32: how many hits there are
        in a row. Other arguments are those of nearest(), but for "fast".

        Hits are crossings: where a ray passes an edge or a corner that triangles share, one of those on either side is
        crossed, so that every line crosses a closed mesh as often inwards as outwards, exactly."""
        if not 1 <= operator.index(limit) < 2**31:
            raise ValueError("limit: {} isn't from 1 to 2147483647".format(limit))
        rows = {name: field._replace(shape=(operator.index(limit),) + field.shape)
                for name, field in chosen(fields).items()}

        def arguments(pointers: Dict[str, int]) -> Tuple[Any, ...]:
            counts = pointers.pop("counts")
            return operator.index(limit), _hits(pointers), counts

        return self._query(library.masu_all_hits, arguments, {**rows, "counts": Field("", "int32", ())}, locals())

    def count_hits(self, rays: Any, *, precision: str = "auto", stream: Any = None, relative: bool = False,
                   threads: int = 0, faces: str = "both", exclude: Any = None, object_masks: Any = None,
                   ray_masks: Any = None, worlds: Any = None, progress: Progress = None) -> Any:
        """How many hits each ray has, as all_hits() finds them: an array of int32 of the rays' leading shape."""
        return self._query_one(library.masu_count_hits, "int32", locals())

    def inside(self, rays: Any, *, rule: str = "parity", precision: str = "auto", stream: Any = None, relative: bool = False,
               threads: int = 0, object_masks: Any = None, ray_masks: Any = None, worlds: Any = None,
               progress: Progress = None) -> Any:
        """Whether each point (..., 3), or the start of each ray, in any direction, is inside the surfaces, whose fronts are
        outside: an array of uint8 of the leading shape.

        rule "parity": 1 where one more of the ray's hits is of a back than of a front, 0 where as many are; else 2, and the
        surfaces aren't closed, or their fronts not outside, or one lies in another. From a point the ray is along x.
        rule "winding", for points in host memory and triangles, which may be open, overlap or be turned: 1 where
        winding_numbers() are at least 1/2, else 0, which is exact unless they are within 1/1000 of that."""
        if choice("rule", rule, {"parity": 0, "winding": 1}):
            return self._query(library.masu_winding, lambda pointers: (1e-3, None, pointers["found"]),
                               {"found": Field("", "uint8", ())}, {**locals(), "points": rays}, "points", (3,))["found"]
        if getattr(rays, "shape", ())[-1:] == (3,):
            rays = rays_from(rays, stream=stream)
        return self._query_one(library.masu_inside, "uint8", locals())

    def winding_numbers(self, points: Any, *, bound: float = 1e-3, relative: bool = False, threads: int = 0,
                        progress: Progress = None) -> Any:
        """The generalised winding number of the scene's triangles about each of the points (..., 3) in host memory: an array
        of float64 of the leading shape. It is 1 in a closed mesh whose fronts are outside, 0 outside; where surfaces are
        open, overlap or are turned, the sum of what the point sees of them, signed solid angles over 4 pi. Numbers are
        within `bound`, from 0 to 1, the same with any number of threads, and computed on the CPU in float64."""
        return self._query(library.masu_winding, lambda pointers: (float(bound), pointers["found"], None),
                           {"found": Field("", "float64", ())}, locals(), "points", (3,))["found"]

    def closest(self, points: Any, *, fields: Union[str, Iterable[str]] = ("distances", "points", "primitive_ids"),
                stream: Any = None, relative: bool = False, threads: int = 0, exclude: Any = None, object_masks: Any = None,
                ray_masks: Any = None, worlds: Any = None, progress: Progress = None) -> Dict[str, Any]:
        """The point of the surfaces that is closest to each of the points (..., 3), which lie where rays may, or of placed
        meshes in host memory: a dictionary of the fields requested, each an array of the points' leading shape.

        distances          float64; infinity where there is no surface
        points             (..., 3) float64: the closest points
        primitive_ids, geometry_ids, primitive_uvs, primitive_normals, face_ids, normals   as nearest() has them, of these

        Other arguments are those of nearest(), masks and exclude of points instead of rays. All is computed in float64. Of
        primitives at the same distance the lowest index is reported. If the grid isn't a hierarchy, the first call builds
        one."""
        return self._query(library.masu_closest, lambda pointers: (_hits(pointers, _CLOSEST_FIELDS), None),
                           chosen(fields, _CLOSEST_FIELDS), locals(), "points", (3,))

    def _query_one(self, function: Callable[..., int], number: str, given: Dict[str, Any]) -> Any:
        return self._query(function, lambda pointers: (pointers["found"],), {"found": Field("", number, ())},
                           given)["found"]

    def _query(self, function: Callable[..., int], arguments: Callable[[Dict[str, int]], Tuple[Any, ...]],
               fields: Dict[str, Field], given: Dict[str, Any], name: str = "rays",
               numbers: Tuple[int, ...] = (6, 8)) -> Dict[str, Any]:
        """arguments: the function's last ones, made of the pointers to the results. given: those of the method by name."""
        threads, stream = operator.index(given["threads"]), given.get("stream")
        if not 0 <= threads <= 4096:
            raise ValueError("threads: {} isn't from 0 to 4096".format(threads))
        record = sized(QueryRecord(relative=int(bool(given["relative"])), threads=threads,
                                   coherent=int(bool(given.get("coherent")))))
        for option, choices in (("precision", PRECISIONS), ("faces", FACES), ("loop", LOOPS)):
            if option in given:
                setattr(record, option, choice(option, given[option], choices))
        arrays, rays = _arrays.recognize(name, given[name], stream)
        gpu = arrays.gpu(rays, name)
        shape = tuple(rays.shape)
        _arrays.check_shape(name, rays, bool(shape) and shape[-1] in numbers,
                            " or ".join("(..., {})".format(number) for number in numbers))
        if gpu is None and stream is not None:
            raise ValueError("stream: it is for {} on a GPU, and these are in host memory".format(name))
        if gpu is not None and gpu not in self._gpus:
            raise ValueError("{} are on {}, the tracer on {}: copy them, or open a tracer there".format(
                name, _device_name([gpu]), self.device))
        count = math.prod(shape[:-1])
        self._opened()
        with arrays.queue(rays, stream) as record.stream:
            rays = arrays.packed(rays, name)
            objects = (self._objects,) if given.get("object_masks") is not None else ()
            filters = {}  # kept until the query is queued
            pair = (2,) if self._is_placed else ()
            for each, needed in (("exclude", shape[:-1] + pair), ("ray_masks", shape[:-1]), ("object_masks", objects),
                                 ("worlds", shape[:-1])):
                if given.get(each) is None:
                    continue
                if hasattr(given[each], "__index__") and getattr(given[each], "shape", ()) == ():  # one for all
                    filters[each] = arrays.empty(needed, "int32", rays)
                    filters[each][...] = _int32(each, operator.index(given[each]))
                else:
                    array = _arrays.beside(rays, each, given[each], stream)
                    if array is None or tuple(array.shape) != needed:
                        raise ValueError("{}: whole numbers of the shape {} are needed, where the {} are, or one".format(
                            each, needed, name))
                    filters[each] = arrays.packed_int32(array, each)
                if each == "exclude" and pair:
                    filters["exclude_objects"] = arrays.packed_int32(filters[each][..., 0], each)
                    filters[each] = arrays.packed_int32(filters[each][..., 1], each)
                    record.exclude_objects = arrays.pointer(filters["exclude_objects"])
                setattr(record, each, arrays.pointer(filters[each]))
            record.object_count = sum(objects)
            record.format = 2 * int(_arrays.is_float64(rays)) + int(shape[-1] == 6)  # masu_ray_format
            results = {each: arrays.empty(shape[:-1] + field.shape, field.number, rays)
                       for each, field in fields.items()}
            if count and results:
                pointers = {each: arrays.pointer(result) for each, result in results.items()}
                call(function, self, arrays.pointer(rays), count, byref(record), *arguments(pointers), options=record,
                     progress=given["progress"])
        return results
