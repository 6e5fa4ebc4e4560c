"""What performance.sh measures through the Python module; JSON. On a GPU with PyTorch, else on all cores.

library.py rates SCENE GRID PREFIX       million rays per second of queries of the sets that gridbench rays saved
library.py arrays TRIANGLES cuda|cpu     milliseconds from arrays to the first hit, and of an update to moved vertices
"""
import json
import statistics
import sys
import time

import masu
import numpy as np

QUERIES = {
    "nearest": lambda tracer, rays, options: tracer.nearest(rays, **options),
    "occluded": lambda tracer, rays, options: tracer.occluded(rays, **options),
    "count_hits": lambda tracer, rays, options: tracer.count_hits(rays, relative=True),
    "all_hits, 4": lambda tracer, rays, options: tracer.all_hits(rays, 4, relative=True),
    "all_hits, 16": lambda tracer, rays, options: tracer.all_hits(rays, 16, relative=True),
}


def seconds_on_cpu(query):
    times = []
    for repeat in range(6):
        begin = time.perf_counter()
        query()
        times.append(time.perf_counter() - begin)
    return statistics.median(times[1:])


def seconds_on_gpu(query):
    """Of the kernels, on the GPU's clock."""
    import torch
    start, stop = (torch.cuda.Event(enable_timing=True) for event in range(2))
    times = []
    for repeat in range(30):
        torch.cuda._sleep(4000000)  # while the GPU is busy, the query is queued whole
        start.record()
        query()
        stop.record()
        stop.synchronize()
        times.append(start.elapsed_time(stop) / 1000)
    return statistics.median(times[5:])


def rates(scene, grid, prefix):
    gpu = masu.gpu_count() > 0
    found = {}
    with masu.Tracer(masu.load(scene), masu.load_grid(grid), device="cuda" if gpu else "cpu") as tracer:
        for kind in ("primary", "diffuse", "random"):
            rays = np.fromfile(f"{prefix}{kind}.f64").reshape(-1, 8)
            with np.errstate(over="ignore"):  # of tmax, to infinity
                rays = rays.astype(np.float32)
            options = {"coherent": kind == "primary", "relative": True}
            hits = float(tracer.count_hits(rays, relative=True).mean())
            if gpu:
                import torch
                rays = torch.from_numpy(rays).cuda()
            seconds = seconds_on_gpu if gpu else seconds_on_cpu
            found[kind] = {"hits_a_ray": hits, **{
                name: len(rays) / 1e6 / seconds(lambda: query(tracer, rays, options)) for name, query in QUERIES.items()}}
    return found


def waves(triangles):
    """Vertices and faces of a surface with about so many triangles."""
    n = int((triangles / 2) ** 0.5) + 1
    x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
    vertices = np.stack([x, y, 0.05 * np.sin(17 * x) * np.cos(23 * y)], -1).reshape(-1, 3).astype(np.float32)
    i = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.stack([i, i + 1, i + n], 1), np.stack([i + 1, i + n + 1, i + n], 1)])
    return vertices, faces.astype(np.uint32)


def arrays(triangles, device):
    """Three times: the first one on a GPU creates its context."""
    vertices, faces = waves(int(triangles))
    ray = np.array([[0.5, 0.5, 2, 0, 0, -1]], np.float32)
    runs = []
    for repeat in range(3):
        times = [time.perf_counter()]
        scene = masu.Scene(vertices, faces)
        times.append(time.perf_counter())
        grid = scene.build(structure="bvh", quality="fast", device=device)
        times.append(time.perf_counter())
        tracer = masu.Tracer(scene, grid, device)
        times.append(time.perf_counter())
        assert np.isfinite(tracer.nearest(ray)["t_hit"]).all()
        times.append(time.perf_counter())
        runs.append({name: 1e3 * (b - a) for name, a, b in
                     zip(("scene", "build", "tracer", "first hit"), times, times[1:])})
    moved = {"host": vertices}
    if device != "cpu":
        import torch
        moved["device"] = torch.as_tensor(vertices, device=device)
    updates = {where: 1e3 * seconds_on_cpu(lambda: tracer.update(array)) for where, array in moved.items()}
    return {"triangles": len(faces), "runs_ms": runs, "update_ms": updates}


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    made = {"rates": rates, "arrays": arrays}[sys.argv[1]](*sys.argv[2:])
    print(json.dumps(made, indent=1))
