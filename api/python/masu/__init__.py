"""Masu: rays traced through voxel grids, on a CPU or a CUDA GPU.

    import masu, numpy
    scene = masu.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    hits = masu.Tracer(scene).nearest(numpy.float32([[0.2, 0.2, 1, 0, 0, -1]]))
    print(hits["t_hit"], hits["primitive_ids"])

The module calls libmasu.so. It looks for it where the environment variable MASU_LIBRARY says, then beside the module,
then where the system's loader looks. NumPy, PyTorch and CuPy are imported when their arrays are used.
"""

from ._grid import Grid, GridDescription, load_grid
from ._interpolate import interpolate
from ._library import Error, Status, __version__, gpu_count
from ._ray_mesh_intersector import RayMeshIntersector
from ._raycasting_scene import RaycastingScene
from ._scene import Description, Faults, Mesh, MeshCheck, Placement, Primitive, Quadrics, Scene, load
from ._tracer import CLOSEST_FIELDS, FIELDS, Tracer

__all__ = ["CLOSEST_FIELDS", "Description", "Error", "FIELDS", "Faults", "Grid", "GridDescription", "Mesh", "MeshCheck",
           "Placement", "Primitive", "Quadrics", "RayMeshIntersector", "RaycastingScene", "Scene", "Status", "Tracer",
           "__version__", "gpu_count", "interpolate", "load", "load_grid"]
