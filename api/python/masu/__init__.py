"""Masu: rays traced through voxel grids, on a CPU or a CUDA GPU.

    import masu, numpy
    masu.write_scene("tile.scene", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    masu.build_grid("tile.scene", "tile.grid")
    with masu.Tracer("tile.scene", "tile.grid") as tracer:
        hits = tracer.nearest(numpy.float32([[0.2, 0.2, 1, 0, 0, -1]]))
    print(hits["t_hit"], hits["primitive_ids"])

The module calls libmasu.so. It looks for it where the environment variable MASU_LIBRARY says, then beside the module,
then where the system's loader looks. NumPy, PyTorch and CuPy are imported when their arrays are used.
"""

from ._files import Mesh, build_grid, write_scene
from ._library import Error, Status, __version__, gpu_count
from ._tracer import FIELDS, Description, Primitive, Tracer

__all__ = ["Description", "Error", "FIELDS", "Mesh", "Primitive", "Status", "Tracer", "__version__", "build_grid",
           "gpu_count", "write_scene"]
