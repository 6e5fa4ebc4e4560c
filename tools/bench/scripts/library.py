"""What performance.sh measures through the Python module; JSON. On a GPU with PyTorch, else on all cores.

library.py rates SCENE GRID PREFIX       million rays per second of queries of the sets that gridbench rays saved
library.py arrays TRIANGLES cuda|cpu     milliseconds from arrays to the first hit, and of an update to moved vertices
library.py answer TRIANGLES cuda|cpu     of each tracer milliseconds to prepare, with its first thousand rays, and million random
                                         rays per second; on a CPU beside Embree 3 where it is installed; with the bytes
                                         per triangle that are taken of the memory
library.py closest TRIANGLES cuda|cpu    million points per second whose distance is found; on a CPU beside Open3D where it
                                         is installed
"""
import concurrent.futures
import ctypes
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import threading
import time
from ctypes import c_size_t, c_void_p

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


class Embree:
    """Embree 3 by its C interface: triangles; lists of rays, by a thread a core. Robust, but for high quality: with that
    flag it builds as for medium."""
    RECORD = np.dtype([("origin", "f4", 3), ("tmin", "f4"), ("direction", "f4", 3), ("time", "f4"), ("t", "f4"),
                       ("mask", "u4"), ("id", "u4"), ("flags", "u4"), ("normal", "f4", 3), ("uv", "f4", 2),
                       ("primitive", "u4"), ("geometry", "u4"), ("instance", "u4")])

    def __init__(self, vertices, faces, quality):
        self.embree = embree = ctypes.CDLL("libembree3.so.3")

        def made(create, *arguments):
            create.restype = c_void_p
            return c_void_p(create(*arguments))
        self.device = made(embree.rtcNewDevice, None)
        self.scene = made(embree.rtcNewScene, self.device)
        embree.rtcSetSceneFlags(self.scene, 0 if quality == "high" else 4)  # RTC_SCENE_FLAG_ROBUST
        embree.rtcSetSceneBuildQuality(self.scene, ("low", "medium", "high").index(quality))
        geometry = made(embree.rtcNewGeometry, self.device, 0)
        self.kept = faces, np.append(vertices, np.zeros((1, 3), np.float32), 0)  # read 16 bytes at a time
        for kind, layout, rows in (0, 0x5003, len(faces)), (1, 0x9003, len(vertices)):  # indices; vertices
            embree.rtcSetSharedGeometryBuffer(geometry, kind, 0, layout, c_void_p(self.kept[kind].ctypes.data),
                                              c_size_t(0), c_size_t(12), c_size_t(rows))
        embree.rtcCommitGeometry(geometry)
        embree.rtcAttachGeometry(self.scene, geometry)
        embree.rtcReleaseGeometry(geometry)
        embree.rtcCommitScene(self.scene)
        self.threads = concurrent.futures.ThreadPoolExecutor(os.cpu_count())

    def __del__(self):
        self.embree.rtcReleaseScene(self.scene)
        self.embree.rtcReleaseDevice(self.device)

    def packed(self, rays):
        records = np.zeros(len(rays), self.RECORD)
        records["origin"], records["direction"] = rays[:, :3], rays[:, 3:]
        records["t"], records["mask"], records["geometry"] = np.inf, 0xffffffff, 0xffffffff
        return records

    def trace(self, records):
        def part(rays):
            context = (ctypes.c_uint32 * 16)(0, 0, 0, 0, 0xffffffff)  # in no instance
            self.embree.rtcIntersect1M(self.scene, context, c_void_p(rays.ctypes.data), len(rays), c_size_t(rays.itemsize))
        list(self.threads.map(part, np.array_split(records, max(1, len(records) // 4096))))
        return records["t"]


class Masu:
    def __init__(self, vertices, faces, device, quality=None):
        self.device, scene = device, masu.Scene(vertices, faces)
        grid = scene.build(structure="bvh", quality=quality, device=device) if quality else None
        self.tracer = masu.Tracer(scene, grid, device)

    def packed(self, rays):
        if self.device == "cpu":
            return rays
        import torch
        return torch.from_numpy(rays).cuda()

    def trace(self, rays):
        return self.tracer.nearest(rays)["t_hit"]

    def distances(self, points):
        return self.tracer.closest(points, fields="distances")["distances"]


TRACERS = {"Masu": Masu, "Masu, `high`": lambda *given: Masu(*given, "high"),
           "Embree, medium": lambda vertices, faces, device: Embree(vertices, faces, "medium"),
           "Embree, high": lambda vertices, faces, device: Embree(vertices, faces, "high")}


def peak(triangles, name):
    """Bytes of the host's memory, at most, per triangle, until a tracer on a CPU is there; of a process that makes no other."""
    vertices, faces = waves(int(triangles))
    own = pathlib.Path("/proc/self")
    kilobytes = lambda kind: int(re.search(kind + r":\s*(\d+)", (own / "status").read_text())[1])
    (own / "clear_refs").write_text("5")  # what counts as the most begins here
    before = kilobytes("VmRSS")
    tracer = TRACERS[name](vertices, faces, "cpu")
    return (kilobytes("VmHWM") - before) * 1024 / len(faces)


def bytes_taken(vertices, faces):
    """Of a GPU's memory by a tracer through a hierarchy, per triangle: then, while it is made at most, and likewise where it
    builds the hierarchy."""
    import torch
    scene = masu.Scene(vertices, faces)
    free = lambda: torch.cuda.mem_get_info()[0]

    def taken(make):
        before, seen, done = free(), [], threading.Event()
        watch = threading.Thread(target=lambda: [seen.append(free()) for _ in iter(lambda: done.wait(2e-4), True)])
        watch.start()
        tracer = make()
        done.set()
        watch.join()
        return (before - free()) / len(faces), (before - min(seen + [free()])) / len(faces)
    grid = scene.build(structure="bvh", quality="fast", device="cuda")
    held, most = taken(lambda: masu.Tracer(scene, grid, "cuda"))
    return {"held": held, "most": most, "most_of_building": taken(lambda: masu.Tracer(scene, device="cuda"))[1]}


def answer(triangles, device):
    vertices, faces = waves(int(triangles))
    ends = np.random.default_rng(1).uniform((0, 0, -0.1), (1, 1, 0.1), (2, 1 << (20 if device == "cpu" else 22), 3))
    rays = np.concatenate([ends[0], ends[1] - ends[0]], 1).astype(np.float32)
    found, hits = {}, set()
    for name, make in TRACERS.items():
        if device == "cuda" and name.startswith("Embree"):
            continue
        prepared, seconds, tracer = [], [], None
        try:
            for repeat in range(5):  # the first one on a GPU creates its context
                tracer = None
                begin = time.perf_counter()
                tracer = make(vertices, faces, device)
                tracer.trace(tracer.packed(rays[:1000]))
                prepared.append(time.perf_counter() - begin)
        except OSError:
            continue  # isn't installed
        for repeat in range(1 if device == "cuda" else 7):
            packed = tracer.packed(rays)
            begin = time.perf_counter()
            t = tracer.trace(packed)
            seconds.append(seconds_on_gpu(lambda: tracer.trace(packed)) if device == "cuda" else time.perf_counter() - begin)
        hits.add(int(np.isfinite(np.asarray(t.cpu() if device == "cuda" else t)).sum()))
        found[name] = {"prepare_ms": 1e3 * statistics.median(prepared[1:]), "mrays": len(rays) / 1e6 / statistics.median(seconds)}
    assert max(hits) - min(hits) < 1e-4 * len(rays), hits
    if device == "cuda":
        taken = bytes_taken(vertices, faces)
    else:
        taken = {name: json.loads(subprocess.check_output([sys.executable, "-B", __file__, "peak", triangles, name]))
                 for name in found}
    return {"triangles": len(faces), "tracers": found, "bytes_a_triangle": taken}


class Open3D:
    def __init__(self, vertices, faces):
        import open3d
        self.packed = open3d.core.Tensor
        self.scene = open3d.t.geometry.RaycastingScene()
        self.scene.add_triangles(self.packed(vertices), self.packed(faces))

    def distances(self, points):
        return self.scene.compute_distance(points).numpy()


def closest(triangles, device):
    """Of points near the surface, off by up to a hundredth of its side along each axis, and anywhere in the cube around it."""
    vertices, faces = waves(int(triangles))
    random, count = np.random.default_rng(1), 1 << 20
    points = {"near": random.choice(vertices, count) + random.uniform(-0.01, 0.01, (count, 3)),
              "anywhere": random.uniform((0, 0, -0.5), (1, 1, 0.5), (count, 3))}
    makers, found, sums = {"Masu": lambda: Masu(vertices, faces, device)}, {}, set()
    if device == "cpu":
        makers["Open3D"] = lambda: Open3D(vertices, faces)
    for name, make in makers.items():
        try:
            tracer = make()
        except ImportError:
            continue  # isn't installed
        for where, of in points.items():
            packed = tracer.packed(of.astype(np.float32))
            seconds = (seconds_on_cpu if device == "cpu" else seconds_on_gpu)(lambda: tracer.distances(packed))
            found.setdefault(name, {})[where] = count / 1e6 / seconds
        sums.add(float(tracer.distances(packed).sum()))
    assert max(sums) - min(sums) < 1e-6 * max(sums), sums
    return {"triangles": len(faces), "mpoints": found}


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    made = {"rates": rates, "arrays": arrays, "answer": answer, "peak": peak, "closest": closest}[sys.argv[1]](*sys.argv[2:])
    print(json.dumps(made, indent=1))
