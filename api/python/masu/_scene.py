"""Scenes in memory, from arrays or files."""

import operator
import os
import pathlib
import shutil
import subprocess
import warnings
from ctypes import byref, c_double, c_float
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _arrays, _mesh_objects
from ._grid import Grid
from ._library import (Error, Path, Progress, Status, Written, call, choice, library, memory_file, told)
from ._records import (EVERY_WORLD, KINDS, STORES, FaultsRecord, GeometryRecord, MeshCheckRecord, MeshRecord,
                       PlacementRecord, PrimitiveRecord, QuadricsRecord, SceneDescriptionRecord, sized)

Vector = Tuple[float, float, float]
Color = Optional[Sequence[float]]  # 3, of a matte material; 0.8 each by default


class Mesh(NamedTuple):
    """Triangles: an object of a scene."""
    vertices: Any  # (V, 3), float32 or float64
    faces: Any = None  # (F, 3), integers below V; None: the vertices in threes
    color: Color = None


class Quadrics(NamedTuple):
    """Spheres or cones: an object of a scene."""
    values: Any  # (N, 4), centre and radius; (N, 8), base, radius there, apex, radius there
    color: Color = None


class Placement(NamedTuple):
    """A mesh where it is in the world."""
    mesh: int  # its index
    transform: Any  # (3, 4) or (4, 4): vertices are M v + t
    mask: int = 0  # of the rays that hit it; 0: all bits
    world: Optional[int] = 0  # of the rays that see it; None: of all


class Description(NamedTuple):
    """What a scene holds."""
    triangles: int  # primitives are numbered in this order:
    spheres: int
    cones: int
    materials: int
    objects: int
    bounds_min: Vector  # of all primitives, in the world; min > max where there is none
    bounds_max: Vector
    origin: Vector  # the point in the world that stored coordinates are relative to
    error_bound: float  # in scene units: how far from its surface a hit may be, with precision "auto"
    bytes: int  # in memory, and of its file
    is_float64: bool  # whether coordinates are stored, and rays traced, in float64


class Primitive(NamedTuple):
    """A primitive, and its material."""
    kind: str  # "triangle", "sphere" or "cone"
    object: int  # its mesh, or its index in the NFF text
    material: int
    face: int  # as `face_ids`
    color: Vector
    diffuse: float
    specular: float
    shine: float
    transmittance: float
    refraction_index: float


class Faults(NamedTuple):
    """How many there are of a kind, and the first of them, at most 8: a face as a primitive's index, an edge as that of a
    triangle and the corner, 0 to 2, from which it runs to the next one."""
    count: int  # type: ignore[assignment]
    examples: List[Any]


class MeshCheck(NamedTuple):
    """What is wrong with a scene's triangles, all as one mesh: see Scene.check()."""
    points: int  # corners with the same stored coordinates are one
    edges: int  # with a length, of triangles that can be hit
    open_edges: Faults  # of an odd number of triangles
    inconsistent_edges: Faults  # of an even number that don't run along it half each way
    nonmanifold_edges: Faults  # of more than two
    faces_without_area: Faults  # corners on a line, exactly, or one point
    duplicate_faces: Faults  # of the same points as one before, in any order

    @property
    def is_closed(self) -> bool:
        """Whether every line crosses the mesh an even number of times: then the parity of count_hits() tells inside from
        outside."""
        return self.open_edges.count == 0

    @property
    def is_oriented(self) -> bool:
        """Whether every line also enters as often as it leaves, which Tracer.inside() needs."""
        return self.is_closed and self.inconsistent_edges.count == 0


def _faults(record: FaultsRecord, of_edges: bool) -> Faults:
    places = list(zip(record.primitives, record.corners))[:record.count]
    return Faults(record.count, places if of_edges else [primitive for primitive, _ in places])


# --- Arrays -------------------------------------------------------------------------------------------------------

def _numbers(name: str, array: Any, columns: int) -> Any:
    import numpy as np
    array = _arrays.real_numbers(name, array)
    _arrays.check_shape(name, array, not array.size or array.shape[1:] == (columns,), "(N, {})".format(columns))
    is_float32 = array.dtype.newbyteorder("=") == np.float32
    return np.require(array, np.float32 if is_float32 else np.float64, ["C_CONTIGUOUS", "ALIGNED"])


def _set_numbers(record: Any, name: str, array: Any) -> None:
    setattr(record, name if array.dtype.itemsize == 4 else name + "64", array.ctypes.data)


def _set_color(record: Any, place: str, color: Color) -> None:
    if color is None:
        return
    if len(color) != 3:
        raise ValueError("{}color: 3 numbers are needed, not {}".format(place, len(color)))
    record.color = (c_float * 3)(*(float(part) for part in color))


def _set_mesh(record: MeshRecord, mesh: Mesh, place: str) -> Tuple[Any, Any]:
    """Returns the arrays that the record points to, whose indices may be none of vertices."""
    import numpy as np
    vertices = _numbers(place + "vertices", mesh.vertices, 3)
    count = vertices.size // 3
    _set_numbers(record, "vertices", vertices)
    record.vertex_count = count
    _set_color(record, place, mesh.color)
    if mesh.faces is None:
        if count % 3:
            raise ValueError("{}vertices: without faces they must be in threes, not {}".format(place, count))
        record.triangle_count = count // 3
        return vertices, None
    faces = _arrays.on_host(place + "faces", mesh.faces)
    _arrays.check_shape(place + "faces", faces, not faces.size or faces.shape[1:] == (3,), "(N, 3)")
    if faces.size and faces.dtype.kind not in "iu":
        raise TypeError("{}faces: integers are needed, not {}".format(place, faces.dtype))
    if faces.dtype.itemsize > 4:  # the library looks at others
        _check_indices(place, faces, count)
    faces = np.require(faces, np.int32 if faces.dtype == np.int32 else np.uint32, ["C_CONTIGUOUS", "ALIGNED"])
    record.indices = faces.ctypes.data
    record.triangle_count = faces.size // 3
    return vertices, faces


def _check_indices(place: str, faces: Any, count: int) -> None:
    if faces.size and not 0 <= int(faces.min()) <= int(faces.max()) < count:
        raise ValueError("{}faces: indices from {} to {}, but there are {} vertices".format(
            place, faces.min(), faces.max(), count))


def _quadrics(name: str, given: Any, columns: int) -> Tuple[Any, Any]:
    """Records of one array or several Quadrics, and the arrays that they point to."""
    several = isinstance(given, (list, tuple)) and bool(given) and all(isinstance(one, Quadrics) for one in given)
    listed = [] if given is None else list(given) if several else [given if isinstance(given, Quadrics) else Quadrics(given)]
    records = (QuadricsRecord * len(listed))()
    kept = []
    for record, one in zip(records, listed):
        sized(record)
        values = _numbers(name, one.values, columns)
        _set_numbers(record, "values", values)
        record.count = values.size // columns
        _set_color(record, name + ": ", one.color)
        kept.append(values)
    return records, kept


def _placements(given: Sequence[Any], meshes: int) -> Any:
    import numpy as np
    records = (PlacementRecord * len(given))()
    for index, (record, one) in enumerate(zip(records, given)):
        placement = one if isinstance(one, Placement) else Placement(*one)
        place = "placement {}: ".format(index)
        transform = np.asarray(_arrays.real_numbers(place + "transform", placement.transform), np.float64)
        _arrays.check_shape(place + "transform", transform, transform.shape in ((3, 4), (4, 4)), "(3, 4) or (4, 4)")
        if not 0 <= operator.index(placement.mesh) < meshes:
            raise ValueError("{}mesh: {} isn't one of the {}".format(place, placement.mesh, meshes))
        sized(record).transform[:] = transform[:3].ravel().tolist()
        record.mesh, record.mask = placement.mesh, operator.index(placement.mask)
        record.world = EVERY_WORLD if placement.world is None else operator.index(placement.world)
    return records


def mesh_of(vertices: Any, faces: Any = None) -> Mesh:
    """Copies of arrays, or without faces, of those of another library's mesh."""
    import numpy as np
    if faces is None:
        vertices, faces = _mesh_objects.arrays_of(vertices)
    mesh = Mesh(np.array(_arrays.on_host("vertices", vertices)), np.array(_arrays.on_host("faces", faces)))
    _set_mesh(MeshRecord(), mesh, "")  # checks it
    _check_indices("", mesh.faces, len(mesh.vertices))
    return mesh


# --- Scenes -------------------------------------------------------------------------------------------------------

class Scene(Written):
    """What rays are traced through: triangles, spheres and cones, in memory.

        Scene(vertices, faces)
        Scene(meshes=[(floor_vertices, floor_faces), masu.Mesh(vertices, faces, (1, 0.5, 0.2))])
        Scene(mesh)  # of Open3D, trimesh, PyVista or meshio; also one of `meshes`
        Scene(spheres=centres_and_radii)

    vertices (V, 3) are float32 or float64, faces (F, 3) integers from 0 to V - 1; without faces each three vertices are a
    triangle. spheres (N, 4) are centres and radii, cones (N, 8) bases, radii there, apices, radii there; an array of them
    is an object, and so is each of a list of masu.Quadrics. Arrays are NumPy's, what NumPy makes arrays from, or on a GPU,
    and are copied. Triangle i of mesh m is primitive i plus the triangles of the meshes before m; m is its `geometry_ids`.
    Spheres follow, then cones. Triangles of which two corners are one point are kept and can't be hit.

    `store`, the type of coordinates, is "auto" (float32 unless its arithmetic is too coarse for the scene), "float32" or
    "float64". Coordinates are stored relative to `origin`, so that errors follow the scene's extent and not its position
    in the world: by default the bounds' centre, or zero where that is nearer than half their diagonal.

    **Placed meshes.** Scene(meshes=…, placements=[(mesh, transform), …]), or a list of masu.Placement, has each mesh as often
    as it is placed, and stores it once; Tracer.place() moves them. `geometry_ids` are then the placements' indices, and
    `primitive_ids` the triangles' within their mesh; spheres and cones stand beside them. Hits are those of the scene of
    all vertices written out, each M v + t by fused multiply-adds from the last column on, in the store's arithmetic and
    relative to the origin. Such a scene is in memory alone.

    Raises masu.Error; TypeError and ValueError for arrays of other types, shapes and contents."""

    _name = "scene"
    _placements = 0  # how many there are

    def __init__(self, vertices: Any = None, faces: Any = None, color: Color = None, *,
                 meshes: Optional[Sequence[Any]] = None, spheres: Any = None, cones: Any = None,
                 store: str = "auto", origin: Optional[Sequence[float]] = None,
                 placements: Optional[Sequence[Any]] = None) -> None:
        if meshes is not None and vertices is not None:
            raise TypeError("Scene: either vertices, or meshes")
        if vertices is None and (faces is not None or color is not None):
            raise TypeError("Scene: faces and color are of vertices; each of meshes has its own")
        if faces is None and _mesh_objects.is_mesh_object(vertices):
            vertices, faces = _mesh_objects.arrays_of(vertices)
        listed = [Mesh(*(mesh if isinstance(mesh, (tuple, list)) else _mesh_objects.arrays_of(mesh)))
                  for mesh in meshes or ()] if vertices is None else [Mesh(vertices, faces, color)]
        records = (MeshRecord * len(listed))()
        places = ["mesh {}: ".format(index) if len(listed) > 1 else "" for index in range(len(listed))]
        kept: List[Any] = [_set_mesh(sized(record), mesh, place) for mesh, record, place in zip(listed, records, places)]
        sphere_records, sphere_arrays = _quadrics("spheres", spheres, 4)
        cone_records, cone_arrays = _quadrics("cones", cones, 8)
        kept += sphere_arrays + cone_arrays
        geometry = sized(GeometryRecord(
            meshes=records, mesh_count=len(records), spheres=sphere_records, sphere_count=len(sphere_records),
            cones=cone_records, cone_count=len(cone_records), store=choice("store", store, STORES)))
        placed = _placements(placements or (), len(records))
        self._placements = geometry.placement_count = len(placed)
        geometry.placements = placed
        if origin is not None:
            if len(origin) != 3:
                raise ValueError("origin: 3 numbers are needed, not {}".format(len(origin)))
            geometry.origin = (c_double * 3)(*(float(part) for part in origin))
        try:
            self._own(library.masu_scene_create, byref(geometry), options=geometry)
        except Error:
            for (vertices, faces), place in zip(kept, places):
                if faces is not None:
                    _check_indices(place, faces, len(vertices))
            raise

    def describe(self) -> Description:
        """Counts, bounds and sizes."""
        about = told(library.masu_scene_describe, self, record=SceneDescriptionRecord())
        about["is_float64"] = bool(about["is_float64"])
        return Description(**about)

    def primitive(self, index: int) -> Primitive:
        """The primitive of an index as `primitive_ids` has it; an IndexError where there is none."""
        index = operator.index(index)
        count = sum(self.describe()[:3])
        if not 0 <= index < count:
            raise IndexError("primitive {}: there are {}".format(index, count))
        about = told(library.masu_scene_primitive, self, index, record=PrimitiveRecord())
        about["kind"] = KINDS[about["kind"]]
        return Primitive(**about)

    def check(self) -> MeshCheck:
        """What is wrong with the triangles as a mesh: edges where it is open, turned or branches, faces without area or there
        twice. Spheres, which are closed, and cones, which aren't, are left out."""
        record = sized(MeshCheckRecord())
        call(library.masu_scene_check, self, byref(record))
        return MeshCheck(record.points, record.edges, *(
            _faults(getattr(record, name), name.endswith("edges")) for name in MeshCheck._fields[2:]))

    def build(self, *, structure: str = "auto", merge: str = "auto", division: Union[str, int, Sequence[int], None] = None,
              quality: str = "high", box_overlap: bool = False, cube_space: bool = False, target: Optional[int] = None,
              alpha: Optional[float] = None, step_cost: Optional[float] = None, detail: Optional[float] = None,
              nested: Optional[int] = None, expand: Optional[int] = None, device: Union[str, int, Any] = "cpu",
              threads: int = 0, for_cpu: bool = False, progress: Progress = None) -> "Grid":
        """A grid of the scene. The options are gridbuild's; None is the default.

        structure: "grid", "bvh", "fastest" of both on a GPU or, for_cpu, a CPU, or "auto", which is "bvh"; the last two
        are a grid if merge or division is given; merge: "auto",
        "none", "x", "balance" or "irregular"; division: "auto", 64, (64, 64, 32), "cleary:1", …; quality: of a hierarchy,
        "high", or "fast", which takes a third of the time; box_overlap: a voxel lists the primitives whose bounding
        box meets it, not their surface; cube_space: the smallest cube about the origin is divided, not the primitives'
        bounds; target, alpha, step_cost, detail, nested, expand: of merged and irregular grids; device: where to build,
        "cpu", "cuda" or a GPU's number; threads: 0 for all cores; for_cpu: what is chosen automatically is chosen for
        tracing on a CPU, not on a GPU; progress: a function that gets the share of the work that is done, from 0 to 1, about
        every tenth of a second. What it raises, or the handler of a signal, as KeyboardInterrupt, ends the build."""
        return Grid._build(self, locals())

    def __repr__(self) -> str:
        if self._handle is None:
            return "<masu.Scene: closed>"
        about = self.describe()
        counts = ["{} {}".format(count, name) for count, name in zip(about, about._fields[:3]) if count]
        return "<masu.Scene: {}, {}, {} bytes>".format(", ".join(counts) or "empty",
                                                      "float64" if about.is_float64 else "float32", about.bytes)


def load(path: Path, *, smooth: bool = False, store: str = "auto") -> Scene:
    """A scene of a file: a scene file, NFF (.nff), or a mesh of any format that mesh2bin reads (OBJ, PLY, STL, glTF, …).
    smooth and store are for what is converted: whether normals are interpolated, and the type of coordinates as Scene has
    it. FileNotFoundError where there is no such file, masu.Error for what can't be read; what the conversion warns of is
    a UserWarning."""
    os.stat(path)
    with open(path, "rb") as file:
        if file.read(8) == b"MASUSCN\0":
            return Scene._read(path)
    choice("store", store, STORES)
    is_nff = os.fsdecode(path).lower().endswith(".nff")
    options = ["--store", store] + (["--smooth"] if smooth and not is_nff else [])
    with memory_file() as (memory, output):  # the tool writes there, so that a damaged mesh can't harm this process
        tool = _tool("nff2bin" if is_nff else "mesh2bin", path)
        done = subprocess.run([tool, os.path.abspath(os.fsdecode(path)), "-q", "-o", output] + options, pass_fds=[memory],
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        lines = [line.split(": ", 1)[-1] for line in done.stderr.decode(errors="replace").splitlines() if line]
        if done.returncode != 0:
            raise Error(Status(done.returncode) if 1 <= done.returncode <= 4 else Status.INPUT,
                        lines[-1] if lines else "{} failed".format(tool))
        for line in lines:
            if ": warning: " in line:
                warnings.warn(line, stacklevel=2)
        return Scene._read(output)


def _tool(name: str, path: Path) -> str:
    # Beside the module, of the same prefix or build as the library, and where the system looks.
    module, installed = (pathlib.Path(file).resolve().parent for file in (__file__, library._name))
    places = [module / "bin", installed.parent / "bin", installed.parent.parent / "bin", os.environ.get("PATH", os.defpath)]
    found = shutil.which(name, path=os.pathsep.join(map(str, places)))
    if found is None:
        raise Error(Status.INPUT, "{}: isn't a scene file, and there is no {} to convert it: install it".format(
            os.fsdecode(path), name))
    return found
