"""What tests of the Python module share: a random mesh, rays of it, and their nearest hits by Möller & Trumbore (1997)
in double, every ray against every triangle."""

import os
import pathlib
import re

import numpy as np


def random_generator():
    """Seeded anew; MASU_TEST_SEED=N repeats a run."""
    seed = int(os.environ.get("MASU_TEST_SEED", 0)) or int.from_bytes(os.urandom(4), "little")
    print("seed", seed, flush=True)
    return np.random.default_rng(seed)


def same_bits(test, found, expected):
    """Of dictionaries of arrays: those that are found may be PyTorch's or CuPy's, on any device."""
    test.assertEqual(found.keys(), expected.keys())
    for name, wanted in expected.items():
        array = found[name]
        array = array.cpu().numpy() if hasattr(array, "cpu") else array.get() if hasattr(array, "get") else array
        test.assertEqual((array.dtype, array.shape), (wanted.dtype, wanted.shape), name)
        test.assertEqual(array.tobytes(), wanted.tobytes(), name)


def random_mesh(random, count):
    """Separate triangles about the unit cube."""
    corners = random.uniform(0, 1, (count, 1, 3)) + random.uniform(-0.2, 0.2, (count, 3, 3))
    return corners.reshape(-1, 3).astype(np.float32), np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)


def cube():
    """From -1 to 1, fronts outside."""
    corners = np.array([[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], np.float32)
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return corners, np.array([face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))], np.uint32)


def random_rays(random, count):
    """From around the unit cube into it; directions of any length."""
    origins = random.uniform(-1, 2, (count, 3))
    directions = (random.uniform(0, 1, (count, 3)) - origins) * random.uniform(0.1, 10, (count, 1))
    return np.concatenate([origins, directions], 1).astype(np.float32)


def brute_force(vertices, faces, rays):
    """Of each ray: t and index of the nearest hit (infinity and -1 for a miss), and whether a tracer that rounds must
    find the same: no triangle's edge is close to the ray, and no other hit to the nearest."""
    a, b, c = (vertices[faces[:, corner]].astype(np.float64)[None] for corner in range(3))
    origin, direction = (part.astype(np.float64)[:, None] for part in (rays[:, :3], rays[:, 3:]))
    with np.errstate(divide="ignore", invalid="ignore"):
        p = np.cross(direction, c - a)
        determinant = ((b - a) * p).sum(-1)
        s = origin - a
        u = (s * p).sum(-1) / determinant
        q = np.cross(s, b - a)
        v = (direction * q).sum(-1) / determinant
        t = ((c - a) * q).sum(-1) / determinant
        inside = np.minimum(np.minimum(u, v), 1 - u - v)
    flat = np.abs(determinant) < 1e-4 * np.linalg.norm(direction, axis=-1) * np.linalg.norm(p, axis=-1)
    hit_t = np.where((inside >= 0) & (t > 0), t, np.inf)
    index = hit_t.argmin(1)
    nearest = hit_t.min(1)
    near = t < nearest[:, None] * 1.001
    unclear = near & (t > -1e-3) & ((np.abs(inside) < 1e-4) | (np.abs(t) < 1e-3) | flat)
    others = near & (hit_t < np.inf)
    return nearest, np.where(np.isinf(nearest), -1, index), ~unclear.any(1) & (others.sum(1) <= 1)


def documented_examples():
    """The blocks of docs/library/README.md that begin with ```python."""
    text = pathlib.Path(__file__).resolve().parent.parent.parent.joinpath("docs/library/README.md").read_text(encoding="utf-8")
    return re.findall("^```python\n(.*?)^```", text, re.M | re.S)
