#!/usr/bin/env python3
"""For developers: nearest hits of Masu's Python module on this machine's CPU, beside Embree 4 or 3 (rtcIntersect1), Open3D's
RaycastingScene (which calls Embree) and trimesh, for the table of docs/performance.md.

    nffgen teapot --size 60 | tools/bench/scripts/python_rays.py [RAYS]

The mesh is the polygons of an NFF text. RAYS, a million by default, start at one point outside the mesh (a picture, row
by row), or in its bounds in all directions. The results are t, triangle, object, u v and normal (of trimesh triangles
alone), on one thread (CPU time) and on all (wall-clock time); the best of three runs counts. A library that isn't there
is left out. Embree is called by a few lines of C, which cc compiles. Where Embree or Open3D hit another triangle than
Masu, exact arithmetic says which is the nearer one.
"""

import concurrent.futures
import ctypes
import fractions
import importlib
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

import masu

FIELDS = ("t_hit", "primitive_ids", "geometry_ids", "primitive_uvs", "primitive_normals")


def triangles_of_nff(lines):
    """(N, 3, 3) float32: the polygons, which are convex, as fans."""
    found = []
    for line in lines:
        words = line.split()
        if words[:1] in (["p"], ["pp"]):
            corners = [[float(word) for word in next(lines).split()[:3]] for corner in range(int(words[1]))]
            found += [[corners[0], *pair] for pair in zip(corners[1:], corners[2:])]
    return np.array(found, np.float32)


def picture_rays(triangles, count):
    low, high = triangles.min((0, 1)), triangles.max((0, 1))
    eye = (low + high) / 2 + np.float32([0.3, -1, 0.4]) * np.linalg.norm(high - low)
    side = int(np.sqrt(count))
    forward = (low + high) / 2 - eye
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward) / np.linalg.norm(forward)
    x = (np.linspace(-0.4, 0.4, side) * np.linalg.norm(forward)).reshape(1, -1, 1)
    directions = forward + right * x - up * x.reshape(-1, 1, 1)
    return np.concatenate(np.broadcast_arrays(eye, directions), -1).astype(np.float32).reshape(-1, 6)


def random_rays(triangles, count):
    random = np.random.default_rng(1)
    origins = random.uniform(triangles.min((0, 1)), triangles.max((0, 1)), (count, 3))
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return np.concatenate([origins, directions], 1).astype(np.float32)


# --- Libraries: each makes a function of rays and a number of threads (0: all) that returns triangles' indices -----

def of_masu(triangles, precision="robust"):
    tracer = masu.Tracer(masu.Scene(triangles.reshape(-1, 3)))
    options = {"fields": FIELDS, "precision": precision}
    return lambda rays, threads: tracer.nearest(rays, threads=threads, **options)["primitive_ids"]


def of_masu_double(triangles):
    return of_masu(triangles, "double")


EMBREE = """
#include <embreeVERSION/rtcore.h>
#include <math.h>

static void intersect(RTCScene scene, struct RTCRayHit* hit) {
#if RTC_VERSION_MAJOR > 3
  rtcIntersect1(scene, hit, 0);
#else
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, hit);
#endif
}

RTCScene made(const float* vertices, unsigned triangles) {
  RTCDevice device = rtcNewDevice(0);
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  unsigned* indices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles);
  float* corners = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 3 * triangles);
  for (unsigned i = 0; i < 3 * triangles; ++i) indices[i] = i;
  for (unsigned i = 0; i < 9 * triangles; ++i) corners[i] = vertices[i];
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcCommitScene(scene);
  return scene;
}

void traced(RTCScene scene, const float* rays, long first, long end, float* t, unsigned* triangle, unsigned* object,
            float* uv, float* normal) {
  for (long i = first; i < end; ++i) {
    const float* n = rays + 6 * i;
    struct RTCRayHit hit = {{n[0], n[1], n[2], 0, n[3], n[4], n[5], 0, INFINITY, -1, 0, 0}, {0, 0, 0, 0, 0, -1, -1, {-1}}};
    intersect(scene, &hit);
    t[i] = hit.ray.tfar;
    triangle[i] = hit.hit.primID;
    object[i] = hit.hit.geomID;
    uv[2 * i] = hit.hit.u, uv[2 * i + 1] = hit.hit.v;
    normal[3 * i] = hit.hit.Ng_x, normal[3 * i + 1] = hit.hit.Ng_y, normal[3 * i + 2] = hit.hit.Ng_z;
  }
}
"""


def of_embree(triangles):
    with tempfile.TemporaryDirectory() as folder:
        library = os.path.join(folder, "embree.so")
        for version in ("4", "3"):
            done = subprocess.run(["cc", "-O3", "-march=native", "-shared", "-fPIC", "-xc", "-", "-o", library, "-lembree" + version],
                                  input=EMBREE.replace("VERSION", version, 1).encode(), stderr=subprocess.PIPE)
            if done.returncode == 0:
                break
        else:
            raise ImportError(done.stderr.decode().splitlines()[0])
        embree = ctypes.CDLL(library)
    pointer = lambda array: array.ctypes.data_as(ctypes.c_void_p)
    embree.made.restype = ctypes.c_void_p
    scene = ctypes.c_void_p(embree.made(pointer(triangles), len(triangles)))
    pool = concurrent.futures.ThreadPoolExecutor(os.cpu_count())

    def trace(rays, threads):
        count = len(rays)
        results = [np.empty((count, width), number) for width, number in (
            (1, np.float32), (1, np.int32), (1, np.int32), (2, np.float32), (3, np.float32))]
        steps = range(0, count, count if threads == 1 else 4096)
        list(pool.map(lambda first: embree.traced(
            scene, pointer(rays), ctypes.c_long(first), ctypes.c_long(min(first + steps.step, count)),
            *(pointer(result) for result in results)), steps))
        return results[1].reshape(-1)

    return trace


def of_open3d(triangles):
    o3d = importlib.import_module("open3d")
    scene = o3d.t.geometry.RaycastingScene()
    indices = np.arange(3 * len(triangles), dtype=np.uint32).reshape(-1, 3)
    scene.add_triangles(o3d.core.Tensor(triangles.reshape(-1, 3)), o3d.core.Tensor(indices))
    return lambda rays, threads: scene.cast_rays(o3d.core.Tensor(rays), threads)["primitive_ids"].numpy().view(np.int32)


def of_trimesh(triangles):
    trimesh = importlib.import_module("trimesh")
    mesh = trimesh.Trimesh(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3), process=False)
    return lambda rays, threads: mesh.ray.intersects_first(rays[:, :3], rays[:, 3:])


def seconds(trace, rays, threads):
    clock = time.process_time if threads == 1 else time.perf_counter
    times = []
    for repeat in range(3):
        begin = clock()
        trace(rays, threads)
        times.append(clock() - begin)
    return min(times)


# --- Exact arithmetic ---------------------------------------------------------------------------------------------

def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def exact_t(triangle, ray):
    """Where the ray meets the closed triangle (Möller & Trumbore, 1997), or infinity."""
    a, b, c = ([fractions.Fraction(float(x)) for x in corner] for corner in triangle)
    origin, direction = ([fractions.Fraction(float(x)) for x in part] for part in (ray[:3], ray[3:]))
    edge1, edge2, s = ([x - y for x, y in zip(p, a)] for p in (b, c, origin))
    p, q = cross(direction, edge2), cross(s, edge1)
    determinant = dot(edge1, p)
    if determinant == 0:
        return float("inf")
    u, v, t = dot(s, p) / determinant, dot(direction, q) / determinant, dot(edge2, q) / determinant
    return t if u >= 0 and v >= 0 and u + v <= 1 and t > 0 else float("inf")


def judged(triangles, rays, ours, theirs):
    """How many results differ, and how often ours is the nearer one in exact arithmetic, and theirs. A miss is right where
    the ray doesn't meet the other's triangle."""
    nearer = [0, 0]
    which = np.flatnonzero(ours != theirs)
    for i in which:
        t = [exact_t(triangles[index], rays[i]) if index >= 0 else None for index in (ours[i], theirs[i])]
        if None in t:
            miss = t.index(None)
            nearer[miss if t[1 - miss] == float("inf") else 1 - miss] += 1
        elif t[0] != t[1]:
            nearer[t[1] < t[0]] += 1
    return len(which), *nearer


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000000
    triangles = triangles_of_nff(iter(sys.stdin))
    print("{} triangles, {} rays, {} cores; millions of rays per second".format(len(triangles), count, os.cpu_count()))
    sets = {"picture": picture_rays(triangles, count), "random": random_rays(triangles, count)}
    results = {}
    libraries = {"Masu": of_masu, "Masu in double": of_masu_double, "Embree": of_embree, "Open3D": of_open3d, "trimesh": of_trimesh}
    for name, make in libraries.items():
        try:
            begin = time.process_time()
            trace = make(triangles)
            print("{}: prepared in {:.2f} s of CPU time".format(name, time.process_time() - begin))
        except ImportError as error:
            print("{}: left out: {}".format(name, error))
            continue
        for kind, rays in sets.items():
            used = rays[::10000] if name == "trimesh" else rays  # which takes hours
            rates = [len(used) / seconds(trace, used, threads) / 1e6 for threads in (1, 0)]
            print("{}, {}: {:.3g} on one thread, {:.3g} on all".format(name, kind, *rates), flush=True)
            if name != "trimesh":
                results[name, kind] = trace(rays, 0)
    for name, kind in results:
        for other in ("Embree", "Open3D"):
            if name.startswith("Masu") and (other, kind) in results:
                differ, ours, theirs = judged(triangles, sets[kind], results[name, kind], results[other, kind])
                print("{}, {}: {} hits differ from {}'s: {} of ours are the nearer ones, {} of theirs".format(
                    name, kind, differ, other, ours, theirs))


main()
