"""A lidar's sweep: `lidar.py [DEVICE]` makes a street of boxes, drives past them and writes what a lidar with 64 beams
measures: sweep.ply, a cloud of points with the box that each lies on. Needs NumPy."""

import sys

import masu
import numpy as np


def box(low, high):
    corners = np.array(np.meshgrid(*zip(low, high), indexing="ij"), np.float32).reshape(3, 8).T
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([triangle for a, b, c, d in faces for triangle in ((a, b, c), (a, c, d))])


def make_street():
    random = np.random.default_rng(1)
    meshes = [box((-60, -60, -1), (60, 60, 0))]
    for x in range(-50, 50, 10):
        for y in (-12, 12):
            width, depth, height = random.uniform((3, 3, 4), (9, 9, 15))
            meshes.append(box((x, y - depth / 2, 0), (x + width, y + depth / 2, height)))
    return masu.Scene(meshes=meshes)


def sweep_rays(positions, beams=64, steps=900):
    """(positions, beams, steps, 8): origin, least distance, direction, range."""
    pose = np.eye(4)  # the lidar's axes are the street's
    beam = masu.RaycastingScene.create_rays_lidar(pose, np.linspace(-25, 10, beams), np.linspace(0, 360, steps, endpoint=False))
    rays = np.empty((len(positions), beams, steps, 8), np.float32)
    rays[..., :3], rays[..., 4:7] = positions[:, None, None], beam[..., 3:]
    rays[..., 3], rays[..., 7] = 0.5, 80
    return rays


rays = sweep_rays(np.array([(x, 0, 1.8) for x in np.linspace(-40, 40, 5)]))
with masu.Tracer(make_street(), device=sys.argv[1] if len(sys.argv) > 1 else "cpu") as tracer:
    found = tracer.nearest(rays, fields=("t_hit", "geometry_ids"))
hit = np.isfinite(found["t_hit"])
points = rays[hit][:, :3] + found["t_hit"][hit, None] * rays[hit][:, 4:7]
with open("sweep.ply", "w") as file:
    file.write("ply\nformat ascii 1.0\nelement vertex {}\n".format(len(points)))
    file.write("property float x\nproperty float y\nproperty float z\nproperty int box\nend_header\n")
    np.savetxt(file, np.column_stack([points, found["geometry_ids"][hit]]), "%.3f %.3f %.3f %d")
print("{} of {} beams met something".format(len(points), hit.size))
