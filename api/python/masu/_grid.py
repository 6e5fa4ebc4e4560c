"""Grids and hierarchies in memory, built of scenes or read from files."""

import operator
import os
from ctypes import byref
from typing import TYPE_CHECKING, Any, NamedTuple, Tuple

from ._library import Path, Written, check, choice, device_number, library, told
from ._records import MERGES, QUALITIES, STRUCTURES, BuildOptionsRecord, GridDescriptionRecord, sized

if TYPE_CHECKING:
    from ._scene import Scene


class GridDescription(NamedTuple):
    """What a grid is."""
    structure: str  # "grid" or "bvh"
    merge: str  # "none", "x", "balance" or "irregular"
    division: Tuple[int, int, int]  # voxels along each axis; of an irregular grid at the top
    cells: int  # of a merged grid; else 0
    nodes: int  # of a bvh; else 0
    references: int
    bytes: int


class Grid(Written):
    """A grid or bounding volume hierarchy of a scene, in memory: made by Scene.build() or load_grid()."""

    _name = "grid"

    def __init__(self) -> None:
        raise TypeError("Grid: use Scene.build() or load_grid()")

    @classmethod
    def _build(cls, scene: "Scene", given: "dict[str, Any]") -> "Grid":
        options = sized(BuildOptionsRecord())
        check(library.masu_default_build_options(byref(options)))
        for name, choices in (("structure", STRUCTURES), ("merge", MERGES), ("quality", QUALITIES)):
            setattr(options, name, choice(name, given[name], choices))
        division = given["division"]
        if division is not None:
            voxels = division if isinstance(division, (tuple, list)) else [division]
            try:
                text = division if isinstance(division, str) else "x".join(str(operator.index(n)) for n in voxels)
            except TypeError:
                raise TypeError("division: text, one whole number or three are needed, not {!r}".format(division)) from None
            if "\0" in text:
                raise ValueError("division: a null character")
            options.division = text.encode()
        options.device = device_number(given["device"])
        for name in ("box_overlap", "cube_space", "for_cpu"):
            setattr(options, name, int(bool(given[name])))
        for name, largest in (("target", 2**32 - 1), ("nested", 2**31 - 1), ("expand", 2**31 - 1),
                              ("threads", 2**31 - 1)):
            if given[name] is not None:
                if not 0 <= operator.index(given[name]) <= largest:  # ctypes would keep its low bits
                    raise ValueError("{}: {} isn't from 0 to {}".format(name, given[name], largest))
                setattr(options, name, operator.index(given[name]))
        for name in ("alpha", "step_cost", "detail"):
            if given[name] is not None:
                setattr(options, name, float(given[name]))
        return cls._of(library.masu_grid_build, scene, byref(options), options=options, progress=given["progress"])

    def refit(self, scene: "Scene") -> "Grid":
        """A hierarchy of a scene whose primitives have moved, which has as many as the one this was built from, in their
        order. Nodes and references are this one's, and their boxes are computed again, in a tenth of a build's time or
        less. Hits are those through a grid that is built anew. Build with quality="fast" what will move."""
        return self._of(library.masu_grid_refit, self, scene)

    def describe(self) -> GridDescription:
        """Structure and sizes."""
        about = told(library.masu_grid_describe, self, record=GridDescriptionRecord())
        about["structure"], about["merge"] = list(STRUCTURES)[about["structure"]], list(MERGES)[about["merge"]]
        return GridDescription(**about)

    def __repr__(self) -> str:
        if self._handle is None:
            return "<masu.Grid: closed>"
        about = self.describe()
        what = "bvh, {} nodes".format(about.nodes) if about.structure == "bvh" else "{}x{}x{} voxels, merge {}".format(
            *about.division, about.merge)
        return "<masu.Grid: {}, {} references, {} bytes>".format(what, about.references, about.bytes)


def load_grid(path: Path) -> Grid:
    """Reads a grid file. FileNotFoundError where there is none, masu.Error for what can't be read."""
    os.stat(path)
    return Grid._read(path)
