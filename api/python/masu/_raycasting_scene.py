"""Open3D's RaycastingScene, by its names: for programs that were written for it."""

import math
import operator
import threading
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union

from . import _arrays
from ._scene import Mesh, Scene, mesh_of
from ._tracer import Tracer, rays_from


class RaycastingScene:
    """Meshes, and rays that are cast at them, with the names and results of open3d.t.geometry.RaycastingScene; arrays are
    NumPy's. What differs: hits are watertight, and the same bits on every device and machine; a mesh may have other
    numbers than float32; device may be "cuda".

        scene = RaycastingScene()
        cube_id = scene.add_triangles(vertices, triangles)
        depth = scene.cast_rays(scene.create_rays_pinhole(60, center, eye, up, 640, 480))["t_hit"]

    The first query after add_triangles() builds a scene and its grid; `tracer` is the masu.Tracer then."""

    INVALID_ID = 0xffffffff  # of a miss

    def __init__(self, nthreads: Union[int, "RaycastingScene"] = 0, device: Union[str, int, Any] = "cpu") -> None:
        """RaycastingScene(other) is a copy."""
        if isinstance(nthreads, RaycastingScene):
            self.__setstate__(nthreads.__getstate__())
        else:
            self.__setstate__({"_nthreads": nthreads, "_device": _device(device), "_meshes": []})

    def __getstate__(self) -> Dict[str, Any]:
        with self._lock:
            return {"_nthreads": self._nthreads, "_device": self._device, "_meshes": list(self._meshes)}

    def __setstate__(self, state: Dict[str, Any]) -> None:
        self._nthreads: int = state["_nthreads"]
        self._device: Any = state["_device"]
        self._meshes: List[Mesh] = state["_meshes"]
        self._lock = threading.RLock()  # a handler of a signal may query while a grid is built
        self._tracer: Optional[Tracer] = None

    def add_triangles(self, vertex_positions: Any, triangle_indices: Any = None) -> int:
        """Adds a mesh: arrays (V, 3) and (F, 3), or one object that has them as Open3D's and trimesh's meshes do. Returns
        its geometry_id."""
        mesh = mesh_of(vertex_positions, triangle_indices)
        with self._lock:
            self._meshes.append(mesh)
            self._tracer = None
            return len(self._meshes) - 1

    @property
    def tracer(self) -> Tracer:
        with self._lock:
            if self._tracer is None:
                scene = Scene(meshes=self._meshes)
                self._tracer = Tracer(scene, device=self._device)
            return self._tracer

    def cast_rays(self, rays: Any, nthreads: int = 0) -> Dict[str, Any]:
        """The first hit of each ray (..., 6), origin and direction: t_hit (infinity for a miss), geometry_ids and
        primitive_ids, the triangle's index in its mesh (uint32; INVALID_ID for a miss), primitive_uvs, primitive_normals."""
        hits = self.tracer.nearest(_vectors("rays", rays, 6), fields=("t_hit", "geometry_ids", "primitive_ids", "primitive_uvs",
                                                        "primitive_normals"), threads=nthreads or self._nthreads)
        return self._numbered(hits)

    def test_occlusions(self, rays: Any, tnear: float = 0.0, tfar: float = math.inf, nthreads: int = 0) -> Any:
        """Whether each ray (..., 6) hits anything at tnear < t < tfar."""
        import numpy as np
        rays = _vectors("rays", rays, 6)
        segments = np.empty(rays.shape[:-1] + (8,), rays.dtype)
        segments[..., :3], segments[..., 3], segments[..., 4:7], segments[..., 7] = rays[..., :3], tnear, rays[..., 3:], tfar
        return self.tracer.occluded(segments, threads=nthreads or self._nthreads)

    def count_intersections(self, rays: Any, nthreads: int = 0) -> Any:
        """How many hits each ray (..., 6) has, all of them. A closed mesh is crossed as often inwards as outwards."""
        return self.tracer.count_hits(_vectors("rays", rays, 6), threads=nthreads or self._nthreads)

    def list_intersections(self, rays: Any, nthreads: int = 0) -> Dict[str, Any]:
        """All hits of all rays (..., 6), one after the other: t_hit, geometry_ids, primitive_ids, primitive_uvs, and
        ray_ids, the ray of each; those of ray i are from ray_splits[i] to below ray_splits[i + 1]. Both are int64, for more
        hits than Open3D's uint32 can number."""
        import numpy as np
        flat = _vectors("rays", rays, 6).reshape(-1, 6)
        threads = nthreads or self._nthreads
        counts = self.tracer.count_hits(flat, threads=threads)
        lists = hit_lists(self.tracer, flat, counts, ("t_hit", "geometry_ids", "primitive_ids", "primitive_uvs"), threads)
        splits = np.concatenate([[0], np.cumsum(counts, dtype=np.int64)])
        return {"ray_splits": splits, "ray_ids": np.repeat(np.arange(len(flat)), counts), **self._numbered(lists)}

    def compute_closest_points(self, query_points: Any, nthreads: int = 0) -> Dict[str, Any]:
        """The closest point of the meshes to each point (..., 3): points, geometry_ids, primitive_ids, primitive_uvs,
        primitive_normals."""
        import numpy as np
        found = self.tracer.closest(_vectors("query_points", query_points, 3), threads=nthreads or self._nthreads, fields=(
            "points", "geometry_ids", "primitive_ids", "primitive_uvs", "primitive_normals"))
        return {**self._numbered(found), "points": found["points"].astype(np.float32)}

    def compute_distance(self, query_points: Any, nthreads: int = 0) -> Any:
        """The distance of each point (..., 3) to the meshes. Points on the tracer's GPU are those of PyTorch or CuPy there,
        and so are the results, as for compute_signed_distance() and compute_occupancy()."""
        found = self.tracer.closest(self._query_points(query_points), fields="distances", threads=nthreads or self._nthreads)
        return _arrays.float32(found["distances"])

    def compute_signed_distance(self, query_points: Any, nthreads: int = 0, nsamples: int = 1) -> Any:
        """The same, negative where compute_occupancy() is 1."""
        points = self._query_points(query_points)
        return (1 - 2 * self.compute_occupancy(points, nthreads, nsamples)) * self.compute_distance(points, nthreads)

    def compute_occupancy(self, query_points: Any, nthreads: int = 0, nsamples: int = 1) -> Any:
        """1 for points (..., 3) inside the meshes, else 0: float32. Inside is where most of nsamples rays in fixed
        directions, an odd number, cross the meshes an odd number of times. Crossings are counted exactly: of closed meshes
        one ray tells what more do."""
        return _arrays.float32(
            crosses_oddly(self.tracer, self._query_points(query_points), nthreads or self._nthreads, nsamples))

    def _query_points(self, points: Any) -> Any:
        """NumPy's, or where they lie if the tracer is there."""
        arrays, array = _arrays.recognize("query_points", points, None)
        if array.shape[-1:] == (3,) and arrays.gpu(array, "query_points") in self.tracer._gpus:
            return array
        return _vectors("query_points", points, 3)

    def _numbered(self, hits: Dict[str, Any]) -> Dict[str, Any]:
        """With primitives numbered in their meshes, and the misses' numbers Open3D's."""
        import numpy as np
        ids, primitives = hits["geometry_ids"], hits["primitive_ids"]
        if len(self._meshes) > 1:
            counts = [len(mesh.faces) for mesh in self._meshes[:-1]]
            first = np.cumsum([0] + counts, dtype=np.int64).astype(np.int32)
            primitives = primitives - np.append(first, np.int32(0))[ids]  # -1: of a miss
        return {**hits, "geometry_ids": ids.view(np.uint32), "primitive_ids": primitives.view(np.uint32)}

    @staticmethod
    def create_rays_pinhole(*camera: Any, **named: Any) -> Any:
        """Rays (height, width, 6) through the centres of a pinhole camera's pixels, as Open3D's:

            create_rays_pinhole(intrinsic_matrix, extrinsic_matrix, width_px, height_px)
            create_rays_pinhole(fov_deg, center, eye, up, width_px, height_px)

        The matrices are (3, 3), and (4, 4) from the world to the camera. fov_deg is the horizontal angle; as in Open3D,
        rows follow `up`. Directions have the length 1 along the camera's axis: t_hit is depth. Rays are float32 if the
        arrays that they are made of are, else float64: they keep their digits."""
        if len(camera) + len(named) == 4:
            return _pinhole(*camera, **named)
        return _pinhole_at(*camera, **named)

    @staticmethod
    def create_rays_lidar(pose: Any, elevations_deg: Any, azimuths_deg: Any) -> Any:
        """Rays (N, M, 6) of a spinning lidar: a row for each of N elevations, a column for each of M azimuths, in degrees:
        float32 if all three arrays are, else float64. pose is (4, 4), from the lidar to the world: its rotation, and its
        position in the last column. The lidar's x points ahead, y to the left, z up: azimuths turn from x to y, elevations
        rise from that plane. Directions have the length 1: t_hit is range. Open3D has no such function."""
        import numpy as np
        to_world = _vector("pose", pose, (4, 4))
        (level, up), (ahead, left) = _angles("elevations_deg", elevations_deg), _angles("azimuths_deg", azimuths_deg)
        directions = np.stack(np.broadcast_arrays(level[:, None] * ahead, level[:, None] * left, up[:, None]), -1)
        rays = np.empty(directions.shape[:2] + (6,), _number(pose, elevations_deg, azimuths_deg))
        rays[..., :3], rays[..., 3:] = to_world[:3, 3], directions @ to_world[:3, :3].T
        return rays

    def __repr__(self) -> str:
        return "<masu.RaycastingScene on {}: {} meshes, {} triangles>".format(
            self._device, len(self._meshes), sum(len(mesh.faces) for mesh in self._meshes))


def hit_lists(tracer: Tracer, rays: Any, counts: Any, fields: Sequence[str], threads: int = 0) -> Dict[str, Any]:
    """All hits of each ray (n, 6), which are so many, one after the other."""
    import numpy as np
    limit = max(1, int(counts.max(initial=0)))
    if len(rays) > 1 and limit * len(rays) > 1 << 22:  # rows of one length would take much memory
        parts = [hit_lists(tracer, rays[part], counts[part], fields, threads)
                 for part in (slice(len(rays) // 2), slice(len(rays) // 2, None))]
        return {name: np.concatenate([part[name] for part in parts]) for name in fields}
    hits = tracer.all_hits(rays, limit, fields=fields, threads=threads)
    are_hits = np.arange(limit) < counts[:, None]
    return {name: hits[name][are_hits] for name in fields}


def crosses_oddly(tracer: Tracer, points: Any, threads: int = 0, samples: int = 1) -> Any:
    """Whether most of so many rays from each point (..., 3) cross the surfaces an odd number of times."""
    if operator.index(samples) < 1 or samples % 2 == 0:
        raise ValueError("nsamples: {} isn't an odd number from 1 on".format(samples))
    votes = sum(tracer.count_hits(rays_from(points, direction), threads=threads) % 2 for direction in _directions(samples))
    return 2 * votes > samples


def _directions(count: int) -> Iterator[Tuple[float, float, float]]:
    """Along x; several, spread over the sphere on a Fibonacci lattice."""
    for i in range(count):
        x = 1 - 2 * i / count
        angle, across = i * math.pi * (3 - math.sqrt(5)), math.sqrt(1 - x * x)
        yield x, across * math.cos(angle), across * math.sin(angle)


def _device(device: Any) -> Any:
    """Open3D's devices are "CPU:0" and "CUDA:0"."""
    name = str(device)
    return "cpu" if name == "CPU:0" else name.lower() if name.startswith("CUDA:") else device


def _vectors(name: str, numbers: Any, length: int) -> Any:
    import numpy as np
    vectors = _arrays.real_numbers(name, numbers)
    _arrays.check_shape(name, vectors, vectors.shape[-1:] == (length,), "(..., {})".format(length))
    return vectors if vectors.dtype == np.float32 else vectors.astype(np.float64, copy=False)


def _number(*arrays: Any) -> str:
    """Of what is made of them."""
    return "float32" if all(str(getattr(array, "dtype", "")).lower().endswith("float32") for array in arrays) else "float64"


def _vector(name: str, numbers: Any, shape: Tuple[int, ...]) -> Any:
    import numpy as np
    array = _arrays.real_numbers(name, numbers).astype(np.float64)
    _arrays.check_shape(name, array, array.shape == shape, shape)
    return array


def _angles(name: str, degrees: Any) -> Any:
    """Their cosines and sines."""
    import numpy as np
    angles = np.radians(_arrays.real_numbers(name, degrees).astype(np.float64))
    _arrays.check_shape(name, angles, angles.ndim == 1, "(N,)")
    return np.cos(angles), np.sin(angles)


def _pinhole(intrinsic_matrix: Any, extrinsic_matrix: Any, width_px: int, height_px: int, number: str = "") -> Any:
    import numpy as np
    number = number or _number(intrinsic_matrix, extrinsic_matrix)
    extrinsic = _vector("extrinsic_matrix", extrinsic_matrix, (4, 4))
    to_world = extrinsic[:3, :3].T
    directions = (to_world @ np.linalg.inv(_vector("intrinsic_matrix", intrinsic_matrix, (3, 3)))).astype(number)
    rays = np.empty((height_px, width_px, 6), number)
    rays[..., :3] = -to_world @ extrinsic[:3, 3]
    x, y = (np.arange(0.5, pixels, dtype=number) for pixels in (width_px, height_px))
    rays[..., 3:] = x[None, :, None] * directions[:, 0] + y[:, None, None] * directions[:, 1] + directions[:, 2]
    return rays


def _pinhole_at(fov_deg: float, center: Sequence[float], eye: Sequence[float], up: Sequence[float], width_px: int,
                height_px: int) -> Any:
    import numpy as np
    place = _vector("eye", eye, (3,))
    forward = _vector("center", center, (3,)) - place
    forward /= np.linalg.norm(forward)
    right = np.cross(_vector("up", up, (3,)), forward)
    right /= np.linalg.norm(right)
    extrinsic = np.eye(4)
    extrinsic[:3, :3] = right, np.cross(forward, right), forward
    extrinsic[:3, 3] = -extrinsic[:3, :3] @ place
    focal = 0.5 * width_px / math.tan(math.radians(0.5 * fov_deg))
    intrinsic = np.array([[focal, 0, 0.5 * width_px], [0, focal, 0.5 * height_px], [0, 0, 1]])
    return _pinhole(intrinsic, extrinsic, width_px, height_px, _number(center, eye, up))
