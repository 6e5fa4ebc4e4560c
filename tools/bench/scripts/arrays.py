#!/usr/bin/env python3
"""Milliseconds from arrays of triangles to the first hit, in Python: the scene, its hierarchy (quality="fast"), the
tracer, one ray. Then of an update to moved vertices, in host memory and, with PyTorch, on the GPU.

    PYTHONPATH=api/python MASU_LIBRARY=…/libmasu.so tools/bench/scripts/arrays.py [TRIANGLES [DEVICE]]

By default 100,000 triangles on the CPU. Three times: the first one on a GPU creates its context."""

import sys
import time

import numpy as np

import masu


def waves(triangles):
    """Vertices and faces of a surface with about so many triangles."""
    n = int((triangles / 2) ** 0.5) + 1
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
    vertices = np.stack([x, y, 0.05 * np.sin(17 * x) * np.cos(23 * y)], -1).reshape(-1, 3).astype(np.float32)
    i = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.stack([i, i + 1, i + n], 1), np.stack([i + 1, i + n + 1, i + n], 1)])
    return vertices, faces.astype(np.uint32)


def main():
    vertices, faces = waves(int(sys.argv[1]) if len(sys.argv) > 1 else 100000)
    device = sys.argv[2] if len(sys.argv) > 2 else "cpu"
    ray = np.array([[0.5, 0.5, 2, 0, 0, -1]], np.float32)
    print(len(faces), "triangles, on", device)
    for _ in range(3):
        times = [time.perf_counter()]
        scene = masu.Scene(vertices, faces)
        times.append(time.perf_counter())
        grid = scene.build(structure="bvh", quality="fast", device=device)
        times.append(time.perf_counter())
        tracer = masu.Tracer(scene, grid, device)
        times.append(time.perf_counter())
        hit = tracer.nearest(ray)
        times.append(time.perf_counter())
        assert np.isfinite(hit["t_hit"]).all()
        names = ("scene", "build", "tracer", "first hit")
        parts = [f"{name} {1e3 * (b - a):.1f}" for name, a, b in zip(names, times, times[1:])]
        print(", ".join(parts), f"ms; all {1e3 * (times[-1] - times[0]):.1f}")
    moved = [("host", vertices)]
    if device != "cpu":
        try:
            import torch
        except ImportError:
            pass
        else:
            moved.append(("device", torch.as_tensor(vertices, device=device)))
    for place, array in moved:
        times = []
        for _ in range(7):
            begin = time.perf_counter()
            tracer.update(array)
            times.append(1e3 * (time.perf_counter() - begin))
        print(f"update from {place} memory: the first {times[0]:.1f}, median {sorted(times[1:])[3]:.2f} ms")


if __name__ == "__main__":
    main()
