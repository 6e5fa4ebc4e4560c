#!/usr/bin/env python3
"""For developers: rates of the library's queries, for a table of docs/performance.md: nearest hits beside gridbench's, by
the same rays through the same grid, and other queries of the same rays.

    tools/bench/scripts/library_rates.py BIN OUT [SCENE...]

BIN has the programs, OUT keeps scenes, grids and rays. A SCENE is one of nffgen's with its size, such as teapot-60. With
PyTorch and a GPU, rays and results lie in its memory, and times are the kernels' on its clock (medians of 25); else in
host memory, on all cores (medians of 5). Rates are of millions of rays a second; hits are those of count_hits.
"""

import json
import os
import statistics
import subprocess
import sys
import time

import numpy as np

import masu

QUERIES = {
    "occluded": lambda tracer, rays, options: tracer.occluded(rays, **options),
    "count_hits": lambda tracer, rays, options: tracer.count_hits(rays, relative=True),
    "all_hits, 4": lambda tracer, rays, options: tracer.all_hits(rays, 4, relative=True),
    "all_hits, 16": lambda tracer, rays, options: tracer.all_hits(rays, 16, relative=True),
}


def prepare(binaries, scene):
    name, _, size = scene.partition("-")
    tool = lambda *words: os.path.join(binaries, words[0]) + "".join(" " + word for word in words[1:])
    if not os.path.exists(scene + ".grid"):
        subprocess.run("{} | {} && {}".format(tool("nffgen", name, *(["--size", size] if size else [])),
                                              tool("nff2bin", "-", "-q", "-o", scene + ".scene"),
                                              tool("gridbuild", scene + ".scene", "-q", "-o", scene + ".grid")),
                       shell=True, check=True)


def bench(binaries, scene, backend):
    done = subprocess.run([os.path.join(binaries, "gridbench"), "rays", scene + ".scene", scene + ".grid", "--json",
                           "--sets", "primary,diffuse,random", "--save", scene + ".", "--backend", backend,
                           "--repeat", "25" if backend == "cuda" else "3"], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)


def seconds_on_cpu(query):
    times = []
    for repeat in range(6):
        begin = time.perf_counter()
        query()
        times.append(time.perf_counter() - begin)
    return statistics.median(times[1:])


def seconds_on_gpu(torch, query):
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


def main():
    binaries, out = os.path.abspath(sys.argv[1]), sys.argv[2]
    scenes = sys.argv[3:] or ["teapot-60", "mount-10", "tetra-9", "balls"]
    os.makedirs(out, exist_ok=True)
    os.chdir(out)
    torch = None
    if masu.gpu_count():
        import torch
    print("| scene, rays | gridbench | nearest (its ratio) | {} | hits per ray |".format(" | ".join(QUERIES)))
    print("|" + " --- |" * (len(QUERIES) + 4))
    for scene in scenes:
        prepare(binaries, scene)
        with masu.Tracer(masu.load(scene + ".scene"), masu.load_grid(scene + ".grid"),
                         device="cuda" if torch else "cpu") as tracer:
            for row in bench(binaries, scene, "cuda" if torch else "cpu"):
                rays = np.fromfile("{}.{}.f64".format(scene, row["rays"])).reshape(-1, 8)
                with np.errstate(over="ignore"):  # of tmax, to infinity
                    rays = rays.astype(np.float32)
                options = {"coherent": row["rays"] == "primary", "relative": True}
                hits = tracer.count_hits(rays, relative=True).mean()
                if torch:
                    rays = torch.from_numpy(rays).cuda()
                rate = lambda query: len(rays) / 1e6 / (seconds_on_gpu(torch, query) if torch else seconds_on_cpu(query))
                nearest = rate(lambda: tracer.nearest(rays, **options))
                others = [rate(lambda: query(tracer, rays, options)) for query in QUERIES.values()]
                print("| {}, {} | {:.4g} | {:.4g} ({:.2f}) | {} | {:.2f} |".format(
                    scene, row["rays"], row["mrays_per_second"], nearest, nearest / row["mrays_per_second"],
                    " | ".join("{:.4g}".format(other) for other in others), hits), flush=True)


main()
