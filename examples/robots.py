"""Lidars of walking robots: `robots.py [DEVICE [WORLDS [STEPS]]]` lets a robot of 13 links walk over a terrain in each of 1024
worlds, which don't see each other, and scans all of them at every step, in one call. Prints what that takes, and writes what
the first robot sees in the end: scan.pgm, near things bright. With DEVICE cuda in PyTorch, else in NumPy."""

import math
import sys
import time

import masu
import numpy as np

device = sys.argv[1] if len(sys.argv) > 1 else "cpu"
worlds, steps = (int(word) for word in (sys.argv[2:] + ["1024", "100"][len(sys.argv[2:]):]))
if device == "cuda":
    import torch
    on_device = lambda array: torch.as_tensor(array, device=device)
    on_host = lambda array: array.cpu().numpy()
    wait, xp = torch.cuda.synchronize, torch
else:
    on_device = on_host = np.asarray
    wait, xp = lambda: None, np

beams, columns, reach = 32, 64, 40.0
hips = [(x, y) for x in (0.3, -0.3) for y in (0.2, -0.2)]
bodies = [(0.9, 0.4, 0.2)] + [size for _ in hips for size in ((0.09, 0.09, 0.3), (0.07, 0.07, 0.3), (0.14, 0.08, 0.05))]


def height(x, y, of=np):
    return 0.4 * of.sin(0.35 * x) * of.cos(0.3 * y) + 0.08 * of.sin(1.9 * x + 0.7 * y)


def terrain(half=60.0, squares=256):
    line = np.linspace(-half, half, squares + 1)
    x, y = np.meshgrid(line, line, indexing="ij")
    corner = np.arange((squares + 1) ** 2).reshape(x.shape)
    a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
    faces = np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)]).reshape(-1, 3)
    return np.stack([x, y, height(x, y)], -1).reshape(-1, 3).astype(np.float32), faces


def box():
    corners = np.array(np.meshgrid(*[(-0.5, 0.5)] * 3, indexing="ij"), np.float32).reshape(3, 8).T
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([triangle for a, b, c, d in faces for triangle in ((a, b, c), (a, c, d))])


def poses(step):
    """Transforms (worlds, 13, 3, 4) of unit boxes, and the lidars' places (worlds, 3), with the yaws' cosines and sines."""
    angle = phases + 0.004 * step
    x, y, cosine, sine = radii * xp.cos(angle), radii * xp.sin(angle), -xp.sin(angle), xp.cos(angle)
    base = height(x, y, xp) + 0.75
    links = xp.zeros((worlds, len(bodies), 3, 4), **number)

    def put(link, at, pitch):
        for axis, (row, size) in enumerate(zip(((xp.cos(pitch), 0, -xp.sin(pitch)), (0, 1, 0), (xp.sin(pitch), 0, xp.cos(pitch))),
                                               bodies[link])):
            forward, left, up = row  # of the box's axis in the body's space
            links[:, link, 0, axis] = size * (forward * cosine - left * sine)
            links[:, link, 1, axis] = size * (forward * sine + left * cosine)
            links[:, link, 2, axis] = size * (up + 0 * cosine)
        for row in range(3):
            links[:, link, row, 3] = at[row]

    put(0, (x, y, base), 0 * angle)
    for leg, (ahead, aside) in enumerate(hips):
        swing = 0.5 * xp.sin(40 * angle + math.pi * (leg in (0, 3)))
        knee = 0.6 * swing - 0.3
        at = [x + ahead * cosine - aside * sine, y + ahead * sine + aside * cosine, base]
        for link, (pitch, length) in enumerate(((swing, 0.3), (knee, 0.3), (0 * knee, 0.05)), 1 + 3 * leg):
            forward = -xp.sin(pitch) * length  # in the body's space
            along = forward * cosine, forward * sine, -xp.cos(pitch) * length
            put(link, [a + b / 2 for a, b in zip(at, along)], -pitch)
            at = [a + b for a, b in zip(at, along)]
    lidars = xp.stack([x, y, base + 0.35], -1)
    return links, lidars, cosine, sine


def scans(lidars, cosine, sine):
    rays = xp.zeros((worlds, beams * columns, 8), **number)  # origin, least distance, direction, range
    rays[..., :3] = lidars[:, None]
    rays[..., 4] = pattern[:, 0] * cosine[:, None] - pattern[:, 1] * sine[:, None]
    rays[..., 5] = pattern[:, 0] * sine[:, None] + pattern[:, 1] * cosine[:, None]
    rays[..., 6] = pattern[:, 2]
    rays[..., 7] = reach
    return rays


random = np.random.default_rng(1)
radii = on_device(random.uniform(5, 40, worlds).astype(np.float32))
phases = on_device(random.uniform(0, 2 * math.pi, worlds).astype(np.float32))
number = {"dtype": radii.dtype, "device": radii.device} if device == "cuda" else {"dtype": radii.dtype}
up, around = np.meshgrid(np.radians(np.linspace(-40, 10, beams)), np.linspace(0, 2 * math.pi, columns, endpoint=False), indexing="ij")
pattern = on_device(np.stack([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)], -1).reshape(-1, 3).astype(np.float32))

links, *_ = poses(0)
first = on_host(links)
ground = masu.Placement(0, np.eye(4), world=None)  # of every world
placements = [ground] + [masu.Placement(1, link, world=world) for world in range(worlds) for link in first[world]]
scene = masu.Scene(meshes=[terrain(), box()], placements=placements, origin=(0, 0, 0))
own_world = on_device(np.repeat(np.arange(worlds, dtype=np.int32), beams * columns).reshape(worlds, -1))
moving = on_device(np.arange(1, len(placements), dtype=np.int32))

with masu.Tracer(scene, device=device) as tracer:
    spent = dict.fromkeys(("poses", "place", "scan"), 0.0)
    for step in range(-3, steps):  # the first three aren't timed
        begin = time.perf_counter()
        links, *lidars = poses(max(step, 0))
        rays = scans(*lidars)
        wait()
        posed = time.perf_counter()
        tracer.place(links.reshape(-1, 3, 4), moving)
        placed = time.perf_counter()
        found = tracer.nearest(rays, fields=("t_hit", "geometry_ids"), worlds=own_world)
        wait()
        for name, seconds in zip(spent, (posed - begin, placed - posed, time.perf_counter() - placed)):
            spent[name] += seconds * (step >= 0)
t, seen = on_host(found["t_hit"]), on_host(found["geometry_ids"])
foreign = (seen > 0) & ((seen - 1) // len(bodies) != np.arange(worlds)[:, None])
assert not foreign.any(), "a lidar saw another world"
print("{} scans of {} rays in each of {} steps: {:.0f} scans and {:.3g} rays a second; {:.0%} hit".format(
    worlds, beams * columns, steps, worlds * steps / sum(spent.values()), t.size * steps / spent["scan"],
    np.isfinite(t).mean()))
print("a step: " + ", ".join("{} {:.2f} ms".format(name, 1e3 * seconds / steps) for name, seconds in spent.items()))

# The first robot's surroundings, finely.
up, around = np.meshgrid(np.radians(np.linspace(12, -60, 180)), np.linspace(math.pi, -math.pi, 720), indexing="ij")
fine = np.zeros((180, 720, 6), np.float32)
fine[..., :3] = on_host(lidars[0][0])
c, s = (float(part[0]) for part in lidars[1:])
x, y = np.cos(up) * np.cos(around), np.cos(up) * np.sin(around)
fine[..., 3], fine[..., 4], fine[..., 5] = x * c - y * s, x * s + y * c, np.sin(up)
with masu.Tracer(scene, device="cpu") as tracer:
    tracer.place(on_host(links).reshape(-1, 3, 4), on_host(moving))
    t = tracer.nearest(fine)["t_hit"]
with open("scan.pgm", "wb") as file:
    file.write(b"P5 720 180 255\n" + np.where(np.isfinite(t), 255 * np.exp(-t / 8), 0).astype(np.uint8).tobytes())
