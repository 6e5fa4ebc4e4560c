"""What performance.sh measures through the Python module; JSON. On a GPU with PyTorch, else on all cores.

library.py rates SCENE GRID PREFIX       million rays per second of queries of the sets that gridbench rays saved
library.py answer TRIANGLES cuda|cpu     of each tracer milliseconds to prepare, with its first thousand rays, and million random
                                         rays per second; on a CPU beside Embree 3 where it is installed; with the bytes
                                         per triangle that are taken of the memory, and milliseconds to move all vertices
library.py closest TRIANGLES cuda|cpu    million points per second whose distance is found; on a CPU beside Open3D where it
                                         is installed
library.py placed PLACEMENTS cuda|cpu    million rays per second, nearest and any hits, through placed meshes, beside the same
                                         written out, and milliseconds until those have moved
library.py moves PLACEMENTS cuda|cpu     milliseconds until placed meshes have moved
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
    return sheet(x, y, 0.05 * np.sin(17 * x) * np.cos(23 * y))


def sheet(*coordinates):
    """Vertices and faces of a surface through n x n points."""
    n = len(coordinates[0])
    i = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    faces = np.concatenate([np.stack([i, i + 1, i + n], 1), np.stack([i + 1, i + n + 1, i + n], 1)])
    return np.stack(coordinates, -1).reshape(-1, 3).astype(np.float32), faces.astype(np.uint32)


def milliseconds_to_move(move, array, device):
    """By the clock of the GPU, where it is on one, and by the caller's: of one of many, each over before the next."""
    times, clocks = 3, {}
    if device != "cpu":
        import torch
        array, times = torch.from_numpy(array).cuda(), 30
        clocks["gpu"] = 1e3 * seconds_on_gpu(lambda: move(array))
    return {**clocks, "call": 1e3 / times * seconds_on_cpu(lambda: [move(array) for repeat in range(times)])}


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
            for repeat in range(13 if device == "cuda" else 5):  # the first one on a GPU creates its context
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
        if name == "Masu":
            found[name]["move_ms"] = milliseconds_to_move(tracer.tracer.update, vertices, device)
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


def bumpy_sphere(n):
    """Of 2 n^2 triangles."""
    a, b = np.meshgrid(np.linspace(0, np.pi, n + 1), np.linspace(0, 2 * np.pi, n + 1), indexing="ij")
    r = 1 + 0.1 * np.sin(7 * a) * np.cos(5 * b)
    return sheet(r * np.sin(a) * np.cos(b), r * np.sin(a) * np.sin(b), r * np.cos(a))


def turned(random, count, extent):
    """Transforms (count, 3, 4) that turn, and move within the cube around the origin."""
    a, b = random.uniform(0, 2 * np.pi, (2, count))
    c, s, d, e = np.cos(a), np.sin(a), np.cos(b), np.sin(b)
    rotations = np.stack([c, -s * d, s * e, s, c * d, -c * e, 0 * a, e, d], -1).reshape(-1, 3, 3)
    return np.concatenate([rotations, random.uniform(-extent, extent, (count, 3, 1))], -1)


class Placements:
    """So many of 30 meshes."""
    def __init__(self, random, count, extent=None):
        self.extent = extent or 2 * count ** (1 / 3)
        self.meshes = [bumpy_sphere(16 + i) for i in range(30)]
        self.placed = [(i % 30, matrix) for i, matrix in enumerate(turned(random, count, self.extent))]
        self.elsewhere = turned(random, count, self.extent)

    def scene(self, worlds=1):
        placements = [masu.Placement(*one, world=world) for world in range(worlds) for one in self.placed]
        return masu.Scene(meshes=self.meshes, placements=placements)

    def written_out(self):
        return [((vertices @ matrix[:, :3].T + matrix[:, 3]).astype(np.float32), faces)
                for mesh, matrix in self.placed for vertices, faces in [self.meshes[mesh]]]


def moves(placements, device):
    made = Placements(np.random.default_rng(1), int(placements))
    with masu.Tracer(made.scene(), device=device) as tracer:
        return {"move_ms": milliseconds_to_move(tracer.place, made.elsewhere, device)}


def traced(scene, extent, device, worlds=1):
    """Rates of nearest and any hits of rays from a camera and of random ones, and the tracer's bytes on a GPU."""
    random, side = np.random.default_rng(1), 512 if device == "cpu" else 2048
    pixels = np.stack([*np.meshgrid(*[np.arange(side) / side - 0.5] * 2), np.full((side, side), -1.0)], -1).reshape(-1, 3)
    ends = random.uniform(-1, 1, (2, len(pixels), 3))
    kinds = {"camera": [np.broadcast_to([0, 0, 2.5], pixels.shape), pixels], "random": [ends[0], ends[1] - ends[0]]}
    there, seconds, free = np.asarray, seconds_on_cpu, lambda: 0
    if device != "cpu":
        import torch
        there, seconds = (lambda array: torch.from_numpy(array).cuda()), seconds_on_gpu
        free = lambda: torch.cuda.mem_get_info()[0]
    before, found = free(), {}
    tracer = masu.Tracer(scene, device=device)
    found["bytes"] = before - free()
    for kind, rays in kinds.items():
        rays = there((np.concatenate(rays, 1) * extent).astype(np.float32))
        options = {"coherent": kind == "camera"}
        if worlds > 1:
            options["worlds"] = there((np.arange(len(rays)) * worlds // len(rays)).astype(np.int32))
        queries = (lambda: tracer.nearest(rays, fields="t_hit", **options)), (lambda: tracer.occluded(rays, **options))
        found[kind] = [len(rays) / 1e6 / seconds(query) for query in queries]
    return tracer, found


def placed(placements, device):
    random, (vertices, faces) = np.random.default_rng(1), bumpy_sphere(500)
    many, few = Placements(random, int(placements)), Placements(random, 14, 5)
    written = many.written_out()
    scenes = {"placed": (many.scene(), many.extent), "written out": (masu.Scene(meshes=written), many.extent),
              "by the identity": (masu.Scene(meshes=[(vertices, faces)], placements=[(0, np.eye(4))]), 1),
              "not placed": (masu.Scene(vertices, faces), 1),
              "one world": (few.scene(), 5), "4096 worlds": (few.scene(4096), 5, 4096)}
    found = {}
    for name, (scene, extent, *worlds) in scenes.items():
        tracer, found[name] = traced(scene, extent, device, *worlds)
        if name == "written out":
            found[name]["move_ms"] = milliseconds_to_move(tracer.update, np.concatenate([of for of, _ in written]), device)
    return found


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sections = {of.__name__: of for of in (rates, answer, peak, closest, placed, moves)}
    print(json.dumps(sections[sys.argv[1]](*sys.argv[2:]), indent=1))
