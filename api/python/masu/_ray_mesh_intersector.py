"""trimesh's RayMeshIntersector, by its names."""

from typing import Any, Union

from ._scene import Scene, mesh_of
from ._tracer import Tracer


class RayMeshIntersector:
    """Rays through one mesh, with the names and results of trimesh.ray's RayMeshIntersector: origins (n, 3), directions
    (n, 3) of any length. mesh has vertices and faces, as a trimesh.Trimesh. Arrays are NumPy's. `tracer` is the
    masu.Tracer."""

    def __init__(self, mesh: Any, device: Union[str, int, Any] = "cpu") -> None:
        self.mesh = mesh
        self.tracer = Tracer(Scene(meshes=[mesh_of(mesh)]), device=device)

    def intersects_any(self, ray_origins: Any, ray_directions: Any) -> Any:
        """Whether each ray hits the mesh."""
        return self.tracer.occluded(_rays(ray_origins, ray_directions))

    def intersects_first(self, ray_origins: Any, ray_directions: Any) -> Any:
        """The index of the first face that each ray hits, -1 for none."""
        return self.tracer.nearest(_rays(ray_origins, ray_directions))["primitive_ids"].astype("int64")

    def __repr__(self) -> str:
        return "<masu.RayMeshIntersector: {!r}>".format(self.tracer)


def _rays(origins: Any, directions: Any) -> Any:
    import numpy as np
    origins, directions = np.asarray(origins, np.float64), np.asarray(directions, np.float64)
    for name, array in (("ray_origins", origins), ("ray_directions", directions)):
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError("{}: the shape (n, 3) is needed, not {}".format(name, array.shape))
    if len(origins) != len(directions):
        raise ValueError("ray_directions: {} are needed, one per origin, not {}".format(len(origins), len(directions)))
    return np.concatenate([origins, directions], 1)
