"""trimesh's RayMeshIntersector, by its names."""

import operator
from typing import Any, Optional, Tuple, Union

from . import _arrays
from ._raycasting_scene import crosses_oddly, hit_lists
from ._scene import Scene, mesh_of
from ._tracer import Tracer


class RayMeshIntersector:
    """Rays through one mesh, with the names and results of trimesh.ray's RayMeshIntersector: origins (n, 3), directions
    (n, 3) of any length. mesh has vertices and faces, as a trimesh.Trimesh. Arrays are NumPy's. `tracer` is the
    masu.Tracer. scale_to_box changes nothing: hits are as accurate at any size."""

    def __init__(self, mesh: Any, scale_to_box: bool = True, *, device: Union[str, int, Any] = "cpu") -> None:
        if not isinstance(scale_to_box, bool):
            raise TypeError("scale_to_box: True or False is needed, not {!r}: device is given by name".format(scale_to_box))
        self.mesh = mesh
        self.tracer = Tracer(Scene(meshes=[mesh_of(mesh)]), device=device)

    def intersects_any(self, ray_origins: Any, ray_directions: Any) -> Any:
        """Whether each ray hits the mesh."""
        return self.tracer.occluded(_rays(ray_origins, ray_directions))

    def intersects_first(self, ray_origins: Any, ray_directions: Any) -> Any:
        """The index of the first face that each ray hits, -1 for none."""
        return self.tracer.nearest(_rays(ray_origins, ray_directions))["primitive_ids"].astype("int64")

    def intersects_id(self, ray_origins: Any, ray_directions: Any, return_locations: bool = False,
                      multiple_hits: bool = True, max_hits: Optional[int] = None) -> Tuple[Any, ...]:
        """The faces that are hit and the rays that hit them: index_tri, index_ray, and locations if they are asked for. All
        hits in the rays' order, the first max_hits of each ray, or without multiple_hits the first alone. The order of
        arguments is that of trimesh.ray.ray_triangle; ray_pyembree has another."""
        import numpy as np
        rays = _rays(ray_origins, ray_directions)
        if multiple_hits:
            counts = self.tracer.count_hits(rays)
            if max_hits is not None:
                if operator.index(max_hits) < 1:
                    raise ValueError("max_hits: {} isn't at least 1".format(max_hits))
                counts = np.minimum(counts, max_hits)
            hits = hit_lists(self.tracer, rays, counts, ("t_hit64", "primitive_ids"))
            ray = np.repeat(np.arange(len(rays)), counts)
        else:
            hits = self.tracer.nearest(rays, fields=("t_hit64", "primitive_ids"))
            ray = np.flatnonzero(hits["primitive_ids"] >= 0)
            hits = {name: array[ray] for name, array in hits.items()}
        triangle = hits["primitive_ids"].astype(np.int64)
        if not return_locations:
            return triangle, ray
        return triangle, ray, rays[ray, :3] + hits["t_hit64"][:, None] * rays[ray, 3:]

    def intersects_location(self, ray_origins: Any, ray_directions: Any, multiple_hits: bool = True,
                            max_hits: Optional[int] = None) -> Tuple[Any, Any, Any]:
        """Where rays hit: locations (m, 3), index_ray, index_tri."""
        triangle, ray, locations = self.intersects_id(ray_origins, ray_directions, True, multiple_hits, max_hits)
        return locations, ray, triangle

    def contains_points(self, points: Any) -> Any:
        """Whether each point (n, 3) is inside the mesh, which must be closed: whether a ray from it crosses the mesh an odd
        number of times, whichever way its faces are turned."""
        return crosses_oddly(self.tracer, _vectors("points", points))

    def __repr__(self) -> str:
        return "<masu.RayMeshIntersector: {!r}>".format(self.tracer)


def _rays(origins: Any, directions: Any) -> Any:
    import numpy as np
    origins, directions = _vectors("ray_origins", origins), _vectors("ray_directions", directions)
    if len(origins) != len(directions):
        raise ValueError("ray_directions: {} are needed, one per origin, not {}".format(len(origins), len(directions)))
    return np.concatenate([origins, directions], 1)


def _vectors(name: str, numbers: Any) -> Any:
    array = _arrays.real_numbers(name, numbers).astype("float64")
    _arrays.check_shape(name, array, array.ndim == 2 and array.shape[1] == 3, "(n, 3)")
    return array
