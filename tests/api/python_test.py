"""The Python module on the CPU, with arrays of NumPy. Environment: PYTHONPATH=api/python MASU_LIBRARY=…/libmasu.so."""

import concurrent.futures
import copy
import functools
import gc
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock
import warnings

import numpy as np

import masu
from python_scene import brute_force, cube, random_generator, random_mesh, random_rays, same_bits

INFINITY = np.float32(np.inf)


def run_python(text, **environment):
    return subprocess.run([sys.executable, "-c", text], env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)


def run_threads(works):
    """Calls each on a thread of its own; raises what one of them raised."""
    with concurrent.futures.ThreadPoolExecutor(len(works)) as threads:
        for future in [threads.submit(work) for work in works]:
            future.result()


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.random = random_generator()

    def file(self, name):
        return os.path.join(self.folder, name)

    def scene(self, count=200, **options):
        vertices, faces = random_mesh(self.random, count)
        self.made = masu.Scene(vertices, faces, **options)
        self.grid = self.made.build()
        return vertices, faces

    def assert_refused(self, status, says, call, *arguments, **options):
        with self.assertRaises(masu.Error) as raised:
            call(*arguments, **options)
        self.assertEqual(raised.exception.status, status)
        self.assertIn(says, str(raised.exception))

    def assert_freed(self, make):
        """That of what make(scene) makes of scenes nothing stays in memory."""
        def used():
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        mesh = random_mesh(self.random, 20000)  # a megabyte
        for i in range(40):
            make(masu.Scene(*mesh))
            if i == 10:
                before = used()
        self.assertLess(used(), before + 2e7)

    def tracer(self):
        tracer = masu.Tracer(self.made, self.grid)
        self.addCleanup(tracer.close)
        return tracer

    def tracer_and_rays(self, rays, triangles=200):
        self.scene(triangles)
        return self.tracer(), random_rays(self.random, rays)


class Queries(WithFolder):
    def test_hits_are_those_of_brute_force(self):
        for store in ("float32", "float64"):
            vertices, faces = self.scene(store=store)
            rays = random_rays(self.random, 3000)
            t, primitive, certain = brute_force(vertices, faces, rays)
            self.assertGreater(certain.mean(), 0.5)
            self.assertGreater((certain & np.isinf(t)).sum(), 10)
            self.assertGreater((certain & np.isfinite(t)).sum(), 10)
            tracer = self.tracer()
            automatic = tracer.nearest(rays, fields=masu.FIELDS)
            for precision in ("robust", "double") if store == "float32" else ("double",):
                hits = tracer.nearest(rays, fields=masu.FIELDS, precision=precision)
                np.testing.assert_array_equal(hits["primitive_ids"][certain], primitive[certain])
                np.testing.assert_allclose(hits["t_hit"][certain], t[certain], rtol=1e-4, atol=1e-5)
                if precision == "robust" or store == "float64":
                    same_bits(self, hits, automatic)
        self.made = masu.Scene(vertices, faces)
        masu.Tracer(self.made).nearest(rays, precision="fast")

    def test_attributes_belong_to_the_hit(self):
        vertices, faces = self.scene()
        rays = random_rays(self.random, 3000)
        hits = self.tracer().nearest(rays, fields=masu.FIELDS)
        hit = hits["primitive_ids"] >= 0
        np.testing.assert_array_equal(np.isfinite(hits["t_hit"]), hit)
        np.testing.assert_array_equal(hits["geometry_ids"], np.where(hit, 0, -1))
        np.testing.assert_array_equal(hits["face_ids"], hits["primitive_ids"])
        self.assertFalse(hits["primitive_normals"][~hit].any())
        self.assertFalse(hits["primitive_uvs"][~hit].any())
        a, b, c = np.moveaxis(vertices[faces[hits["primitive_ids"][hit]]].astype(np.float64), 1, 0)
        u, v = hits["primitive_uvs"][hit].astype(np.float64).T[:, :, None]
        point = rays[hit, :3] + hits["t_hit"][hit, None].astype(np.float64) * rays[hit, 3:]
        np.testing.assert_allclose((1 - u - v) * a + u * b + v * c, point, atol=1e-4)
        across = np.cross(b - a, c - a)
        area = np.linalg.norm(across, axis=1)
        normals = hits["primitive_normals"][hit]
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=1e-5)
        large = area > 1e-3
        np.testing.assert_allclose(normals[large], (across / area[:, None])[large], atol=1e-3)

    def test_fields_are_those_asked_for_and_the_same_in_any_choice(self):
        tracer, rays = self.tracer_and_rays(500)
        every = tracer.nearest(rays, fields=masu.FIELDS)
        self.assertEqual(tuple(every), masu.FIELDS)
        self.assertEqual(set(tracer.nearest(rays)), {"t_hit", "primitive_ids"})
        self.assertEqual(tracer.nearest(rays, fields=()), {})
        for name in masu.FIELDS:
            same_bits(self, tracer.nearest(rays, fields=name), {name: every[name]})
            same_bits(self, tracer.nearest(rays, fields=iter([name])), {name: every[name]})
        self.assertEqual({name: str(array.dtype) for name, array in every.items()},
                         {"t_hit": "float32", "primitive_ids": "int32", "geometry_ids": "int32",
                          "primitive_uvs": "float32", "primitive_normals": "float32", "face_ids": "int32",
                          "t_hit64": "float64", "front": "bool", "positions": "float64", "normals": "float32"})

    def test_all_hits_are_counted_and_listed_in_order(self):
        self.made = masu.Scene(*cube())
        self.grid = self.made.build()
        tracer = self.tracer()
        # On a lattice, where rays meet edges and corners exactly.
        origins = self.random.integers(-6, 7, (4, 250, 3)) / 4 + 0.125
        directions = self.random.integers(-2, 3, (4, 250, 3))
        directions[(directions == 0).all(-1)] = 1
        rays = np.concatenate([origins, directions], -1)
        inside = np.abs(origins).max(-1) < 1
        counts = tracer.count_hits(rays)
        np.testing.assert_array_equal(counts % 2 == 1, inside)
        np.testing.assert_array_equal(tracer.inside(rays), inside)
        lists = tracer.all_hits(rays, 3, fields=masu.FIELDS)
        np.testing.assert_array_equal(lists["counts"], counts)
        self.assertEqual(lists["primitive_uvs"].shape, (4, 250, 3, 2))
        np.testing.assert_array_equal((lists["primitive_ids"] >= 0).sum(-1), counts)
        self.assertTrue((lists["t_hit"][..., 1:] >= lists["t_hit"][..., :-1]).all())
        np.testing.assert_array_equal(lists["front"].sum(-1), tracer.count_hits(rays, faces="front"))
        without = tracer.nearest(rays, exclude=np.full((4, 250), -1), fields=masu.FIELDS)
        same_bits(self, without, tracer.nearest(rays, fields=masu.FIELDS))
        others = tracer.nearest(rays, exclude=without["primitive_ids"])["primitive_ids"]
        self.assertFalse(((others == without["primitive_ids"]) & (others >= 0)).any())
        same_bits(self, tracer.nearest(rays, object_masks=[True], fields=masu.FIELDS), without)
        masks = self.random.integers(0, 2**32, (4, 250), np.uint32)
        chosen = tracer.nearest(rays, object_masks=[1 << 31], ray_masks=masks)["primitive_ids"]
        np.testing.assert_array_equal(chosen, np.where(masks >> 31, without["primitive_ids"], -1))
        self.assertFalse(tracer.occluded(rays, object_masks=[0]).any())
        one = int(without["primitive_ids"].max())
        same_bits(self, tracer.nearest(rays, exclude=one, object_masks=True, ray_masks=np.uint32(2**32 - 1)),
                  tracer.nearest(rays, exclude=np.full((4, 250), one)))
        for given in (np.zeros((4, 250)), np.zeros((4, 250), complex)):
            with self.assertRaisesRegex(TypeError, "^exclude: "):
                tracer.nearest(rays, exclude=given)
        for wrong in (lambda: tracer.nearest(rays, exclude=np.full((4, 250), 2**32)), lambda: tracer.nearest(rays, exclude=2**32),
                      lambda: tracer.nearest(rays, loop="cells"),
                      lambda: tracer.all_hits(rays, 0), lambda: tracer.nearest(rays, object_masks=[1, 1]),
                      lambda: tracer.nearest(rays, object_masks=[1], ray_masks=[1]), lambda: tracer.nearest(rays, faces="none"),
                      lambda: tracer.nearest(rays, exclude=[1, 2])):
            with self.assertRaises(ValueError):
                wrong()

    def test_positions_are_on_the_primitive_in_the_rays_coordinates(self):
        vertices, faces = random_mesh(self.random, 300)
        spheres = np.concatenate([self.random.uniform(0, 1, (20, 3)), np.full((20, 1), 0.1)], 1)
        away = np.float64([4096, -512, 0])
        scene = masu.Scene(vertices + away, faces, spheres=spheres + np.append(away, 0))
        self.assertTrue(any(scene.describe().origin))
        rays = random_rays(self.random, 3000).astype(np.float64)
        local = rays.copy()
        local[:, :3] += away - np.float64(scene.describe().origin)
        rays[:, :3] += away
        with masu.Tracer(scene) as tracer:
            hits = tracer.nearest(rays, fields=masu.FIELDS)
            kinds = [(hits["primitive_ids"] >= 0) & (hits["primitive_ids"] < 300), hits["primitive_ids"] >= 300]
            for kind in kinds:
                self.assertGreater(kind.sum(), 20)
                points = rays[:, :3] + hits["t_hit64"][:, None] * rays[:, 3:]
                np.testing.assert_allclose(hits["positions"][kind], points[kind], atol=1e-4)
            on_face = kinds[0]
            uv = hits["primitive_uvs"][on_face].astype(np.float64)
            corners = (vertices + away)[faces[hits["primitive_ids"][on_face]]]
            weights = np.concatenate([1 - uv.sum(1, keepdims=True), uv], 1)
            np.testing.assert_allclose((weights[:, :, None] * corners).sum(1), hits["positions"][on_face], atol=1e-6)
            self.assertTrue(np.isnan(hits["positions"][hits["primitive_ids"] < 0]).all())
            np.testing.assert_array_equal(hits["normals"], hits["primitive_normals"])
            relative = tracer.nearest(local, fields="positions", relative=True)["positions"]
            np.testing.assert_allclose(relative + scene.describe().origin, hits["positions"], atol=1e-9)
            listed = tracer.all_hits(rays, 2, fields=masu.FIELDS)
            np.testing.assert_array_equal(listed["positions"][:, 0], hits["positions"])

    def test_normals_are_those_of_corners_interpolated(self):
        with open(self.file("a.nff"), "w") as file:
            file.write("f 1 1 1 1 0 0 0 1\npp 3\n0 0 0 0 0 1\n1 0 0 1 0 1\n0 1 0 0 2 0\ns 4 0 0 1\n")
        corner_normals = np.float64([[0, 0, 1], [0.5 ** 0.5, 0, 0.5 ** 0.5], [0, 1, 0]])
        rays = np.zeros((1000, 6))
        rays[:, :2], rays[:, 2], rays[:, 5] = self.random.uniform(0, 1, (1000, 2)) * [6, 1], 5, -1
        with masu.Tracer(masu.load(self.file("a.nff"))) as tracer:
            hits = tracer.nearest(rays, fields=masu.FIELDS)
            closest = tracer.closest(rays[:, :3], fields=masu.CLOSEST_FIELDS)
        for found in (hits, closest):
            faces = found["primitive_ids"] == 0
            self.assertTrue(0 < faces.sum() < 1000)
            expected = masu.interpolate(found, corner_normals[None])
            expected /= np.maximum(np.linalg.norm(expected, axis=1, keepdims=True), 1e-30)
            np.testing.assert_allclose(found["normals"][faces], expected[faces], atol=1e-6)
            np.testing.assert_array_equal(found["normals"][~faces], found["primitive_normals"][~faces])

    def test_values_are_interpolated(self):
        tracer, rays = self.tracer_and_rays(2000)
        vertices, faces = random_mesh(self.random, 200)
        hits = tracer.all_hits(rays.reshape(40, 50, 6), 3, fields=("primitive_ids", "primitive_uvs"))
        ids, uvs = hits["primitive_ids"], hits["primitive_uvs"].astype(np.float64)
        self.assertTrue((ids < 0).any() and (ids >= 0).any())
        weights = np.concatenate([1 - uvs.sum(-1, keepdims=True), uvs], -1)
        values = self.random.uniform(-1, 1, (len(vertices), 5))
        faces = self.random.permutation(faces.ravel()).reshape(-1, 3)
        for number in (np.float32, np.float64):
            by_index = masu.interpolate(hits, values.astype(number), faces)
            self.assertEqual((by_index.dtype, by_index.shape), (np.float32, (40, 50, 3, 5)))
            expected = np.where((ids >= 0)[..., None], (values[faces][ids] * weights[..., None]).sum(-2), 0)
            np.testing.assert_allclose(by_index, expected, atol=1e-6)
            np.testing.assert_array_equal(masu.interpolate(hits, values.astype(number)[faces]), by_index)
        per_face = values[:len(faces)].astype(np.float32)
        np.testing.assert_array_equal(masu.interpolate({"primitive_ids": ids}, per_face),
                                      np.where((ids >= 0)[..., None], per_face[ids], 0))
        ones = masu.interpolate(hits, np.ones((len(vertices), 1)), faces)
        np.testing.assert_array_equal(ones[..., 0], ids >= 0)
        self.assertEqual(masu.interpolate(hits, np.zeros((len(vertices), 0)), faces).shape, (40, 50, 3, 0))
        beyond = faces.copy()
        beyond[7] = len(vertices)
        np.testing.assert_array_equal(masu.interpolate(hits, values, beyond)[ids == 7], 0)
        np.testing.assert_array_equal(masu.interpolate(hits, values[:0], faces), np.zeros((40, 50, 3, 5)))
        for wrong in (lambda: masu.interpolate(hits, values[0], faces), lambda: masu.interpolate(hits, values, faces[:, :2]),
                      lambda: masu.interpolate(hits, np.zeros((5, 2, 3))), lambda: masu.interpolate({**hits, "primitive_uvs": uvs[0]}, values, faces),
                      lambda: masu.interpolate({"primitive_ids": ids}, values, faces)):
            self.assertRaises(ValueError, wrong)
        self.assertRaises(TypeError, masu.interpolate, hits, values, faces.astype(float))
        self.assertRaises(KeyError, masu.interpolate, {}, values)

    def test_closest_points_of_a_cube(self):
        corners, faces = cube()
        points = self.random.uniform(-2, 2, (3, 200, 3))
        outside = np.clip(points, -1, 1)
        depth = 1 - np.abs(points).max(-1)
        inside = depth > 0
        expected = np.where(inside, depth, np.linalg.norm(points - outside, axis=-1))
        with masu.Tracer(masu.Scene(corners, faces)) as tracer:
            found = tracer.closest(points, fields=masu.CLOSEST_FIELDS)
            np.testing.assert_allclose(found["distances"], expected, atol=1e-12)
            np.testing.assert_allclose(found["points"][~inside], outside[~inside], atol=1e-12)
            self.assertEqual(found["primitive_normals"].shape, (3, 200, 3))
            np.testing.assert_array_equal(found["geometry_ids"], 0)
            triangles = corners[faces][found["primitive_ids"]]
            uv = found["primitive_uvs"]
            weights = np.concatenate([1 - uv.sum(-1, keepdims=True), uv], -1)
            np.testing.assert_allclose((triangles * weights[..., None]).sum(-2), found["points"], atol=1e-6)
            nothing = tracer.closest(points, object_masks=[0])
            self.assertTrue(np.isinf(nothing["distances"]).all() and np.isnan(nothing["points"]).all())
            for wrong in (lambda: tracer.closest(np.zeros((5, 6))), lambda: tracer.closest(points, fields="t_hit"),
                          lambda: tracer.closest(points, exclude=[1])):
                self.assertRaises(ValueError, wrong)
        scene = masu.RaycastingScene()
        scene.add_triangles(corners, faces)
        scene.add_triangles(corners + np.float32([9, 0, 0]), faces)
        np.testing.assert_allclose(scene.compute_distance(points), expected, atol=1e-6)
        np.testing.assert_allclose(scene.compute_signed_distance(points.astype(np.float32)), np.where(inside, -1, 1) * expected,
                                   atol=1e-6)
        np.testing.assert_array_equal(scene.compute_occupancy(points), inside)
        closest = scene.compute_closest_points(points + np.float64([9, 0, 0]))
        np.testing.assert_array_equal(closest["geometry_ids"], 1)
        self.assertTrue((closest["primitive_ids"] < 12).all())
        self.assertEqual(closest["points"].dtype, np.float32)
        self.assertRaises(ValueError, scene.compute_distance, np.zeros((2, 6)))

    def test_winding_numbers_tell_inside_where_parity_does_not(self):
        corners, faces = cube()
        points = self.random.uniform(-2, 2, (20, 100, 3))
        inside = np.abs(points).max(-1) < 1
        with masu.Tracer(masu.Scene(corners, faces)) as tracer:
            np.testing.assert_allclose(tracer.winding_numbers(points), inside, atol=1e-3)
            np.testing.assert_array_equal(tracer.inside(points, rule="winding"), inside)
            np.testing.assert_array_equal(tracer.inside(points), inside)
            self.assertRaises(ValueError, tracer.inside, points, rule="both")
            self.assertRaises(ValueError, tracer.inside, np.zeros((5, 6)), rule="winding")
            self.assert_refused(masu.Status.USAGE, "masks", tracer.inside, points, rule="winding", object_masks=[1])
            self.assert_refused(masu.Status.USAGE, "bound", tracer.winding_numbers, points, bound=2)
        # Two that overlap, and one without a lid and with a face turned, finely divided.
        overlapping = [(corners, faces), (corners * np.float32(0.5) + np.float32([1, 0, 0]), faces)]
        in_either = inside | (np.abs(points - [1, 0, 0]).max(-1) < 0.5)
        with masu.Tracer(masu.Scene(meshes=overlapping)) as tracer:
            np.testing.assert_array_equal(tracer.inside(points, rule="winding"), in_either)
            self.assertTrue((tracer.inside(points) == 2).any())
        turned = faces.copy()
        turned[-1] = turned[-1, ::-1]
        deep = points[np.abs(points + [0.6, 0, 0]).max(-1) < 0.3]
        for structure in ("bvh", "grid"):
            scene = masu.Scene(corners, turned[2:])
            with masu.Tracer(scene, scene.build(structure=structure)) as tracer:
                numbers = tracer.winding_numbers(points, bound=0.25)
                np.testing.assert_allclose(numbers, tracer.winding_numbers(points, bound=0), atol=0.25)
                same_bits(self, {"": numbers}, {"": tracer.winding_numbers(points, bound=0.25, threads=1)})
                np.testing.assert_array_equal(tracer.inside(deep, rule="winding"), tracer.winding_numbers(deep, bound=0) >= 0.5)
        with masu.Tracer(masu.Scene(spheres=[[0, 0, 0, 1]])) as tracer:
            self.assert_refused(masu.Status.USAGE, "spheres", tracer.winding_numbers, points)

    def test_results_depend_neither_on_the_grid_nor_on_coherence(self):
        tracer, rays = self.tracer_and_rays(2000)
        expected = tracer.nearest(rays, fields=masu.FIELDS)
        with masu.Tracer(self.made, brute_force=True) as tracer:
            self.assertIsNone(tracer.grid)
            same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), expected)
        for options, structure, merge in (
                ({"division": 7}, "grid", "none"), ({"merge": "irregular"}, "grid", "irregular"),
                ({"structure": "bvh"}, "bvh", "none"), ({"structure": "bvh", "quality": "fast"}, "bvh", "none"), ({"merge": "x", "division": (8, 4, 6)}, "grid", "x"),
                ({"box_overlap": True, "cube_space": True, "merge": "balance", "threads": 1}, "grid", "balance")):
            self.grid = self.made.build(**options)
            about = self.grid.describe()
            self.assertEqual((about.structure, about.merge, about.cells > 0, about.nodes > 0),
                             (structure, merge, merge != "none", structure == "bvh"))
            same_bits(self, self.tracer().nearest(rays, fields=masu.FIELDS, coherent=True, threads=1), expected)

    def test_without_a_grid_what_answers_soonest_is_built(self):
        of_grid, rays = self.tracer_and_rays(500)
        with masu.Tracer(self.made) as tracer:
            self.assertEqual(tracer.grid.describe(), self.made.build(structure="bvh", quality="fast").describe())
            same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), of_grid.nearest(rays, fields=masu.FIELDS))
        self.assertRaises(TypeError, masu.Tracer, self.made, self.grid, brute_force=True)

    def test_occlusion_is_a_nearest_hit_before_tmax(self):
        tracer, short = self.tracer_and_rays(5000)
        t = tracer.nearest(short)["t_hit"]
        occluded = tracer.occluded(short)
        self.assertEqual(occluded.dtype, bool)
        np.testing.assert_array_equal(occluded, np.isfinite(t))
        rays = np.empty((len(short), 8), np.float32)
        rays[:, :3], rays[:, 4:7] = short[:, :3], short[:, 3:]
        rays[:, 3] = 0
        rays[:, 7] = INFINITY
        same_bits(self, tracer.nearest(rays), tracer.nearest(short))
        rays[:, 7] = self.random.uniform(0, 3, len(rays))
        different = rays[:, 7] != t
        expected = t < rays[:, 7]
        np.testing.assert_array_equal(tracer.occluded(rays)[different], expected[different])
        np.testing.assert_array_equal(np.isfinite(tracer.nearest(rays)["t_hit"])[different], expected[different])
        rays[:, 3] = self.random.uniform(0, 1, len(rays))
        found = tracer.nearest(rays)["t_hit"]
        hit = np.isfinite(found)
        np.testing.assert_array_equal(tracer.occluded(rays), hit)
        self.assertTrue((found > rays[:, 3])[hit].all() and (found < rays[:, 7])[hit].all())

    def test_leading_shape_is_kept(self):
        tracer, rays = self.tracer_and_rays(24)
        flat = tracer.nearest(rays, fields=masu.FIELDS)
        for leading in ((24,), (4, 6), (2, 3, 4), (24, 1), (1, 1, 24)):
            shaped = rays.reshape(leading + (6,))
            hits = tracer.nearest(shaped, fields=masu.FIELDS)
            same_bits(self, hits, {name: array.reshape(leading + array.shape[1:]) for name, array in flat.items()})
            self.assertEqual(tracer.occluded(shaped).shape, leading)
        one = tracer.nearest(rays[0], fields=masu.FIELDS)
        same_bits(self, one, {name: array[0:1].reshape(array.shape[1:]) for name, array in flat.items()})
        self.assertEqual(tracer.occluded(rays[0]).shape, ())

    def test_no_rays_give_no_hits(self):
        self.scene()
        tracer = self.tracer()
        for leading in ((0,), (0, 5), (5, 0)):
            for width in (6, 8):
                hits = tracer.nearest(np.empty(leading + (width,), np.float32), fields=masu.FIELDS)
                self.assertEqual(hits["t_hit"].shape, leading)
                self.assertEqual(hits["primitive_normals"].shape, leading + (3,))
                self.assertEqual(tracer.occluded(np.empty(leading + (width,), np.float32)).shape, leading)

    def test_any_layout_and_type_is_the_same_as_a_contiguous_array(self):
        tracer, rays = self.tracer_and_rays(60)
        expected = tracer.nearest(rays)
        wide = np.full((120, 9), np.nan, np.float32)
        wide[::2, 1:7] = rays
        unaligned = np.frombuffer(b"x" + rays.tobytes(), np.uint8)[1:].view(np.float32).reshape(-1, 6)
        self.assertFalse(unaligned.flags.aligned)
        read_only = rays.copy()
        read_only.flags.writeable = False
        for given in (wide[::2, 1:7], rays[::-1].copy()[::-1], rays[:, ::-1].copy()[:, ::-1], np.asfortranarray(rays),
                      rays.astype(">f4"), rays.astype(">f8"), rays.astype(np.float64), rays.astype(np.longdouble),
                      rays.tolist(), memoryview(rays), unaligned, read_only):
            same_bits(self, tracer.nearest(given), expected)
        same_bits(self, tracer.nearest(np.broadcast_to(rays[0], (3, 4, 6))),
                  {name: np.broadcast_to(array[0], (3, 4)) for name, array in expected.items()})
        half = rays.astype(np.float16)
        same_bits(self, tracer.nearest(half), tracer.nearest(half.astype(np.float32)))
        whole = np.rint(rays * 4).astype(np.int64)
        same_bits(self, tracer.nearest(whole), tracer.nearest(whole.astype(np.float32)))

    def test_errors_name_the_argument(self):
        tracer, rays = self.tracer_and_rays(2, 10)

        class Elsewhere:
            def __dlpack_device__(self):
                return 7, 0  # Vulkan

            def __dlpack__(self, **options):
                raise AssertionError("it was read")

        class Triangle:
            vertices, faces = np.eye(3), [[0, 1, 2]]

        meshes = masu.RayMeshIntersector(Triangle)
        for array, error in (([[0, 0], [0]], ValueError), (Elsewhere(), TypeError)):
            for name, call in (("rays", tracer.nearest), ("points", tracer.closest), ("vertices", tracer.update),
                               ("vertices", masu.Scene), ("exclude", lambda given: tracer.occluded(rays, exclude=given)),
                               ("query_points", masu.RaycastingScene().compute_distance),
                               ("rays", masu.RaycastingScene().cast_rays), ("points", meshes.contains_points),
                               ("ray_origins", lambda given: meshes.intersects_any(given, given))):
                with self.assertRaisesRegex(error, "^{}: ".format(name)):
                    call(array)
        for name, call in (("rays", masu.RaycastingScene().cast_rays), ("points", meshes.contains_points),
                           ("pose", lambda given: masu.RaycastingScene.create_rays_lidar(given, [0], [0]))):
            with self.assertRaisesRegex(TypeError, "^{}: real numbers".format(name)):
                call([["a"] * 6])
        for options in ({"ray_masks": [1, 1]}, {"object_masks": [1, 1]}):
            with self.assertRaisesRegex((ValueError, masu.Error), "^{}: ".format(*options)):
                tracer.occluded(rays, **options)


class Scenes(WithFolder):
    def test_meshes_are_numbered_in_order(self):
        meshes = [random_mesh(self.random, count) for count in (5, 1, 20)]
        color = (1.0, 0.5, 0.25)
        scene = masu.Scene(meshes=[masu.Mesh(*meshes[0], color), meshes[1], meshes[2]])
        tracer = masu.Tracer(scene)
        description = scene.describe()
        self.assertEqual((description.triangles, description.spheres, description.cones, description.objects), (26, 0, 0, 3))
        self.assertFalse(description.is_float64)
        vertices = np.concatenate([mesh[0] for mesh in meshes])
        np.testing.assert_array_equal(description.bounds_min, vertices.min(0))
        np.testing.assert_array_equal(description.bounds_max, vertices.max(0))
        objects = [scene.primitive(index).object for index in range(26)]
        self.assertEqual(objects, [0] * 5 + [1] + [2] * 20)
        self.assertEqual((scene.primitive(4).kind, scene.primitive(4).color), ("triangle", color))
        np.testing.assert_allclose(scene.primitive(5).color, 0.8)
        for index in (-1, 26, 2**32):
            self.assertRaises(IndexError, scene.primitive, index)
        hits = tracer.nearest(random_rays(self.random, 2000), fields=("primitive_ids", "geometry_ids"))
        np.testing.assert_array_equal(hits["geometry_ids"], np.array(objects + [-1])[hits["primitive_ids"]])

    def test_checks_say_what_is_wrong_with_a_mesh(self):
        corners, faces = cube()
        whole = masu.Scene(corners, faces).check()
        self.assertTrue(whole.is_closed and whole.is_oriented)
        self.assertEqual((whole.points, whole.edges, whole.nonmanifold_edges), (8, 18, masu.Faults(0, [])))
        turned = faces.copy()
        turned[5] = turned[5, ::-1]
        check = masu.Scene(corners, turned).check()
        self.assertTrue(check.is_closed and not check.is_oriented)
        self.assertEqual(check.inconsistent_edges.count, 3)
        self.assertTrue(all(turned[face, corner] in faces[5] for face, corner in check.inconsistent_edges.examples))
        open_box = masu.Scene(corners, np.concatenate([faces[:10], [[3, 3, 5], faces[9]]])).check()
        self.assertFalse(open_box.is_closed)
        self.assertEqual((open_box.faces_without_area, open_box.duplicate_faces), (masu.Faults(1, [10]), masu.Faults(1, [11])))

    def test_any_layout_and_type_of_vertices_and_faces(self):
        vertices, faces = random_mesh(self.random, 30)

        def bytes_of(*arrays, **options):
            masu.Scene(*arrays, **options).write(self.file("a.scene"))
            return pathlib.Path(self.file("a.scene")).read_bytes()

        expected = bytes_of(vertices, faces)
        for v in (vertices, vertices.astype(">f4"), np.asfortranarray(vertices), vertices.astype(np.float64)):
            for f in (faces, faces.astype(np.int64), np.asfortranarray(faces), faces.astype(">i2"), faces.tolist()):
                self.assertEqual(bytes_of(v, f), expected)
        self.assertEqual(bytes_of(vertices[faces].reshape(-1, 3)), expected)
        self.assertFalse(masu.load(self.file("a.scene")).describe().is_float64)
        bytes_of(vertices.astype(np.float64) / 3, faces, store="float64")
        self.assertTrue(masu.load(self.file("a.scene")).describe().is_float64)

    def test_spheres_and_cones_follow_the_triangles(self):
        vertices, faces = random_mesh(self.random, 3)
        scene = masu.Scene(vertices, faces, spheres=[masu.Quadrics([[9, 0, 0, 1], [12, 0, 0, 1]]), masu.Quadrics([[15, 0, 0, 1]])],
                           cones=np.float64([[18, 0, 0, 1, 18, 0, 2, 1]]))
        self.assertEqual([scene.primitive(index)[:2] for index in range(3, 7)],
                         [("sphere", 1), ("sphere", 1), ("sphere", 2), ("cone", 3)])
        rays = np.float32([[x, 9, 0.5, 0, -1, 0] for x in (9, 12, 15, 18)])
        hits = masu.Tracer(scene).nearest(rays, fields=("primitive_ids", "geometry_ids", "t_hit"))
        self.assertEqual(hits["primitive_ids"].tolist(), [3, 4, 5, 6])
        self.assertEqual(hits["geometry_ids"].tolist(), [1, 1, 2, 3])
        self.assertAlmostEqual(float(hits["t_hit"][3]), 8, delta=1e-5)  # of coordinates rounded from a random origin on
        for wrong in ({"spheres": [[0, 0, 0]]}, {"cones": [[0, 0, 0, 1]]}):
            self.assertRaises(ValueError, masu.Scene, **wrong)
        self.assert_refused(masu.Status.USAGE, "spheres", masu.Scene, spheres=[[0, 0, 0, 0.0]])

    def test_files_are_those_of_the_tools_and_none_is_written_unasked(self):
        with unittest.mock.patch.dict(os.environ, TMPDIR=self.folder):  # where a temporary file would be written
            vertices, faces = self.scene()
            rays = random_rays(self.random, 200)
            expected = self.tracer().nearest(rays, fields=masu.FIELDS)
        self.assertEqual(os.listdir(self.folder), [])
        self.made.write(self.file("a.scene"))
        self.grid.write(self.file("a.grid"))
        self.assertEqual(self.made.describe().bytes, os.path.getsize(self.file("a.scene")))
        self.assertEqual(self.grid.describe().bytes, os.path.getsize(self.file("a.grid")))
        with masu.Tracer(masu.load(self.file("a.scene")), masu.load_grid(self.file("a.grid"))) as tracer:
            same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), expected)
        tools = pathlib.Path(os.environ.get("MASU_LIBRARY", "/nowhere/libmasu.so")).resolve().parent.parent / "bin"
        if not (tools / "gridbuild").exists():
            self.skipTest("no tools beside the library")
        for name, options, made in (
                ("b", [], self.grid), ("c", ["--structure", "bvh"], self.made.build(structure="bvh"))):
            grid = self.file(name + ".grid")
            subprocess.run([tools / "gridbuild", self.file("a.scene"), "-o", grid, "-q"] + options, check=True)
            made.write(self.file("d.grid"))
            self.assertEqual(pathlib.Path(grid).read_bytes(), pathlib.Path(self.file("d.grid")).read_bytes())
        nff = self.file("tile.nff")
        pathlib.Path(nff).write_text("p 3\n0 0 0\n1 0 0\n0 1 0\ns 0 0 3 1\n")
        subprocess.run([tools / "nff2bin", nff, "-o", self.file("tile.scene"), "-q"], check=True)
        masu.load(nff).write(self.file("again.scene"))
        self.assertEqual(pathlib.Path(self.file("tile.scene")).read_bytes(), pathlib.Path(self.file("again.scene")).read_bytes())
        if not (tools / "mesh2bin").exists():
            return
        obj = self.file("mesh.obj")
        pathlib.Path(obj).write_text("".join("v {} {} {}\n".format(*v) for v in vertices.tolist()) +
                                     "".join("f {} {} {}\n".format(*f) for f in (faces + 1).tolist()))
        same_bits(self, masu.Tracer(masu.load(obj)).nearest(rays), self.tracer().nearest(rays))
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            masu.load(obj)
            self.assertEqual(said, [])
            with open(obj, "a") as file:
                file.write("p 1\nl 1 2\n")
            same_bits(self, masu.Tracer(masu.load(obj)).nearest(rays), self.tracer().nearest(rays))
        self.assertEqual([(one.category, one.filename) for one in said], [(UserWarning, __file__)])
        self.assertEqual(str(said[0].message), obj + ": warning: 2 point(s) and line(s) left out")
        pathlib.Path(obj).write_text("v\n")
        self.assert_refused(masu.Status.INPUT, "mesh.obj", masu.load, obj)
        self.assertRaises(ValueError, masu.load, obj, store="float16")

    def test_representations_tell_what_it_is(self):
        self.scene(10)
        self.assertRegex(repr(self.made), "^<masu.Scene: 10 triangles, float32, [0-9]+ bytes>$")
        self.assertRegex(repr(self.grid), "^<masu.Grid: .*, [0-9]+ references, [0-9]+ bytes>$")
        self.assertRegex(repr(self.tracer()), "^<masu.Tracer on cpu: <masu.Scene: .*>, <masu.Grid: .*>>$")
        with self.made:
            pass
        self.assertEqual(repr(self.made), "<masu.Scene: closed>")
        self.assertRaises(ValueError, self.made.build)
        self.assertRaises(ValueError, masu.Tracer, self.made, self.grid)
        self.assertRaises(TypeError, masu.Grid)

    def test_wrong_meshes_are_refused(self):
        vertices, faces = random_mesh(self.random, 3)
        for error, arguments in (
                (ValueError, (vertices, faces + 1)), (ValueError, (vertices, faces.astype(int) - 1)),
                (ValueError, (vertices, [[0, 1, 2**32]])), (ValueError, (vertices[:, :2], faces)),
                (ValueError, (vertices, faces[:, :2])), (ValueError, (vertices.ravel(), faces)),
                (TypeError, (vertices, faces.astype(float))), (TypeError, (vertices * 1j, faces)),
                (TypeError, (vertices.astype(str), faces)), (TypeError, (vertices, faces > 0)),
                (ValueError, (vertices, faces, (1, 1))), (ValueError, ([], faces)), (ValueError, (vertices[:-1],)), (TypeError, (None, faces))):
            with self.assertRaises(error, msg=str(arguments)):
                masu.Scene(*arguments)
        self.assertRaises(TypeError, masu.Scene, vertices, faces, meshes=[(vertices, faces)])
        self.assertRaises(ValueError, masu.Scene, vertices, faces, store="float16")
        self.assertRaises(TypeError, masu.Scene, vertices, faces, store=1)
        self.assertRaises(ValueError, masu.Scene, vertices, faces, origin=(0, 0))
        self.assert_refused(masu.Status.USAGE, "", masu.Scene, np.where(vertices == vertices[0, 0], np.nan, vertices), faces)
        self.assert_refused(masu.Status.OUTPUT, "nowhere", masu.Scene(vertices, faces).write, self.file("nowhere/a.scene"))
        self.assertEqual(os.listdir(self.folder), [])
        self.assertEqual(masu.Scene().describe()[:3], (0, 0, 0))

    def test_wrong_options_of_grids_are_refused(self):
        self.scene(10)
        for error, options in (
                (TypeError, {"kind": "x"}), (TypeError, {"merge": 1}), (ValueError, {"structure": "octree"}),
                (masu.Error, {"structure": "bvh", "merge": "x"}), (masu.Error, {"merge": "x", "quality": "fast"}), (masu.Error, {"structure": "grid", "quality": "fast"}), (ValueError, {"quality": "best"}),
                (ValueError, {"device": "gpu"}),
                (TypeError, {"division": 1.5}), (TypeError, {"division": (1.5, 1, 1)}), (masu.Error, {"division": (8, 4)}), (ValueError, {"division": "8\0"}), (masu.Error, {"division": "x"}),
                (ValueError, {"target": -1}), (ValueError, {"target": 2**32}), (TypeError, {"target": 1.5}),
                (ValueError, {"threads": -1}), (ValueError, {"threads": 2**40}), (TypeError, {"alpha": []}),
                (ValueError, {"alpha": "much"})):
            with self.assertRaises(error, msg=str(options)):
                self.made.build(**options)

    def test_a_refitted_hierarchy_gives_the_hits_of_the_moved_scene(self):
        faces = np.arange(300).reshape(-1, 3)
        vertices = np.float32(self.random.uniform(-1, 1, (300, 3)))
        grid = masu.Scene(vertices, faces).build(structure="bvh", quality="fast")
        for bend in (0.01, 1):
            moved = masu.Scene(vertices + np.float32(bend) * np.sin(vertices[:, ::-1]), faces)
            grid = grid.refit(moved)
            rays = random_rays(self.random, 500)
            with masu.Tracer(moved, grid) as tracer, masu.Tracer(moved, brute_force=True) as expected:
                same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), expected.nearest(rays, fields=masu.FIELDS))
        self.assertRaises(masu.Error, grid.refit, masu.Scene(vertices[:297], faces[:99]))
        self.assertRaises(masu.Error, moved.build(merge="none").refit, moved)

    def test_an_updated_tracer_gives_the_hits_of_a_new_scene(self):
        vertices, faces = random_mesh(self.random, 100)
        faces[3] = faces[4]  # vertices are shared
        scene = masu.Scene(vertices, faces)
        rays = random_rays(self.random, 500)
        with masu.Tracer(scene, scene.build(structure="bvh", quality="fast")) as tracer:
            for most in (0.01, 0.5):
                moved = vertices + self.random.uniform(-most, most, vertices.shape)
                for array in (moved, moved.astype(np.float32), np.asfortranarray(moved)):
                    tracer.update(array)
                    expected = masu.Tracer(masu.Scene(array, faces, origin=scene.describe().origin), brute_force=True)
                    same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), expected.nearest(rays, fields=masu.FIELDS))
            for error, wrong, says in ((ValueError, vertices[:, :2], "vertices: "), (masu.Error, vertices[1:], "vertices: "),
                                       (TypeError, vertices > 0, "vertices: "), (masu.Error, vertices * np.nan, "vertices: ")):
                with self.assertRaisesRegex(error, says):
                    tracer.update(wrong)
            with self.assertRaisesRegex(masu.Error, "scene: has no triangles"):
                ball = masu.Scene(spheres=[[0, 0, 0, 1]])
                masu.Tracer(ball, ball.build(structure="bvh")).update(np.zeros((0, 3)))
            self.assertRaises(ValueError, tracer.update, vertices, stream=1)
            same_bits(self, tracer.nearest(rays, fields=masu.FIELDS), expected.nearest(rays, fields=masu.FIELDS))
        with self.assertRaisesRegex(masu.Error, "grid: isn't a hierarchy"):
            masu.Tracer(scene, scene.build(structure="grid")).update(vertices)

    def test_paths_of_any_kind(self):
        vertices, faces = random_mesh(self.random, 3)
        for path in (pathlib.Path(self.folder) / "b ü.scene", os.fsencode(self.file("c.scene"))):
            masu.Scene(vertices, faces).write(path)
            masu.load(path).close()
        for load in (masu.load, masu.load_grid):
            self.assertRaises(ValueError, load, self.file("a\0b"))
            self.assertRaises(TypeError, load, 5.5)
            self.assertRaises(FileNotFoundError, load, self.file("none"))
        for wrong in (str(path), 5, None):
            self.assertRaises(TypeError, masu.Tracer, wrong)
        self.assertRaises(TypeError, masu.Tracer, masu.load(path), "a.grid")


class Tracers(WithFolder):
    def test_wrong_rays_are_refused(self):
        self.scene(10)
        tracer = self.tracer()
        for error, rays in (
                (ValueError, np.zeros((5, 7), np.float32)), (ValueError, np.zeros((6, 5), np.float32)),
                (ValueError, np.float32(1)), (ValueError, np.zeros(0, np.float32)), (ValueError, []), (ValueError, 1.5),
                (TypeError, np.zeros((5, 6), bool)), (TypeError, np.zeros((5, 6), complex)),
                (TypeError, np.zeros((5, 6), "S4")), (TypeError, np.zeros((5, 6), object)),
                (TypeError, np.zeros((5, 6), "datetime64[s]")), (ValueError, [[0, 0, 0, 1, 1, 1], [1, 2]]),
                (ValueError, None), (ValueError, "rays")):
            for query in (tracer.nearest, tracer.occluded):
                with self.assertRaises(error, msg=repr(rays)):
                    query(rays)
        rays = random_rays(self.random, 5)
        self.assertRaises(ValueError, tracer.nearest, rays, fields="t")
        self.assertRaises(ValueError, tracer.nearest, rays, fields=("t_hit", "depth"))
        self.assertRaises(ValueError, tracer.nearest, rays, precision="half")
        self.assertRaises(TypeError, tracer.occluded, rays, precision=1)
        self.assertRaises(ValueError, tracer.nearest, rays, stream=0)
        self.assertRaises(TypeError, tracer.nearest, rays, ("t_hit",))
        self.assertTrue(np.isfinite(tracer.nearest(rays)["t_hit"]).shape == (5,))

    def test_arrays_of_others_in_host_memory_are_read(self):
        tracer, rays = self.tracer_and_rays(20, 50)

        class Other:
            def __dlpack_device__(self):
                return rays.__dlpack_device__()

            def __dlpack__(self, **options):
                return rays.__dlpack__(**options)

        class Interface:
            __array_interface__ = rays.__array_interface__

        expected = tracer.nearest(rays)
        same_bits(self, tracer.nearest(Other()), expected)
        same_bits(self, tracer.nearest(Interface()), expected)

    def test_devices(self):
        self.scene(10)
        for device in ("gpu", "cuda:", "cuda:-1", "cuda:1.0", "CPU", -1, 2**40, True, None, 1.5, "cuda:0,cuda:1",
                       [], ["cpu"], [0, "cpu"], [True], [[0]]):
            with self.assertRaises(ValueError, msg=repr(device)):
                masu.Tracer(self.made, device=device)
        beyond = masu.gpu_count()
        for device in (beyond, "cuda:{}".format(beyond)):
            self.assert_refused(masu.Status.DEVICE, "", masu.Tracer, self.made, self.grid, device=device)

    def test_a_closed_tracer_is_refused(self):
        tracer, rays = self.tracer_and_rays(5, 10)
        with tracer:
            tracer.nearest(rays)
        tracer.close()
        self.made.close()
        self.grid.close()
        for use in (lambda: tracer.nearest(rays), lambda: tracer.occluded(rays), lambda: tracer.nearest(rays[:0]),
                    self.made.describe, lambda: self.made.primitive(0), self.made.build, self.grid.describe,
                    lambda: self.made.write(self.file("a")), lambda: self.grid.write(self.file("a"))):
            self.assertRaises(ValueError, use)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_tracer_keeps_what_it_uses(self):
        tracer, rays = self.tracer_and_rays(50, 100)
        expected = tracer.nearest(rays)
        self.made.close()
        self.grid.close()
        same_bits(self, tracer.nearest(rays), expected)

    def test_a_tracer_lives_as_long_as_its_query(self):
        tracer, rays = self.tracer_and_rays(50, 100)
        expected = tracer.nearest(rays)
        nearest = masu.Tracer(self.made).nearest
        gc.collect()
        same_bits(self, nearest(rays), expected)
        self.assertTrue(callable(nearest))

    def test_what_nobody_holds_is_freed(self):
        self.assert_freed(lambda scene: masu.Tracer(scene, scene.build(merge="none", division=8)))

    def test_threads_use_one_tracer(self):
        self.scene()
        tracer = self.tracer()
        lists = [random_rays(self.random, 500) for _ in range(8)]
        expected = [tracer.nearest(rays) for rays in lists]

        def work(rays, hits):
            for _ in range(10):
                same_bits(self, tracer.nearest(rays), hits)
                with self.assertRaises(IndexError):
                    self.made.primitive(10**6)

        run_threads([functools.partial(work, *pair) for pair in zip(lists, expected)])

    def test_closing_waits_for_other_threads(self):
        self.scene()
        rays = random_rays(self.random, 2000)
        expected = self.tracer().nearest(rays)
        for _ in range(5):
            tracer = self.tracer()
            begun = threading.Barrier(5)

            def work():
                begun.wait()
                with self.assertRaises(ValueError):
                    while True:
                        same_bits(self, tracer.nearest(rays), expected)

            def close():
                begun.wait()
                tracer.close()

            run_threads([work] * 4 + [close])


class Placed(unittest.TestCase):
    """Of rotations by 90 degrees, a scale of 2 and whole numbers all sums of M v + t are exact."""
    meshes = [cube(), (np.float32([[0, 0, 0], [3, 0, 0], [0, 3, 0]]), [[0, 1, 2]])]
    moves = np.float64([[[0, -2, 0, 7], [2, 0, 0, 1], [0, 0, -2, 3]], [[1, 0, 0, -9], [0, 1, 0, 0], [0, 0, 1, 4]],
                        [[2, 0, 0, 0], [0, 2, 0, -8], [0, 0, 2, 0]]])
    of_mesh = [0, 1, 0]

    def placed(self, **options):
        return masu.Scene(meshes=self.meshes, placements=list(zip(self.of_mesh, self.moves)), origin=(0, 0, 0), **options)

    def written(self, moves):
        placed = []
        for mesh, move in zip(self.of_mesh, moves):
            vertices, faces = self.meshes[mesh]
            placed.append((np.float64(vertices) @ np.float64(move)[:3, :3].T + np.float64(move)[:3, 3], faces))
        return masu.Scene(meshes=placed, origin=(0, 0, 0), store="float32")

    def rays(self, count=2000):
        random = np.random.default_rng(5)
        origins = random.uniform(-12, 12, (count, 3))
        return np.concatenate([origins, random.uniform(-9, 9, (count, 3)) - origins], 1)

    def expect_same(self, tracer, moves, **options):
        rays = self.rays()
        written = masu.Tracer(self.written(moves))
        fields = [field for field in masu.FIELDS if field not in ("primitive_ids", "face_ids")]
        found, expected = tracer.nearest(rays, fields=fields, **options), written.nearest(rays, fields=fields)
        for field in fields:
            np.testing.assert_array_equal(found[field], expected[field])
        np.testing.assert_array_equal(tracer.count_hits(rays, **options), written.count_hits(rays))
        np.testing.assert_array_equal(tracer.inside(rays, **options), written.inside(rays))
        points = tracer.closest(rays[:, :3], fields=("distances", "geometry_ids"), **options)
        for field, values in written.closest(rays[:, :3], fields=("distances", "geometry_ids")).items():
            np.testing.assert_array_equal(points[field], values)
        return found

    def test_finds_and_moves_as_written_out(self):
        tracer = masu.Tracer(self.placed(), quality="fast")
        self.assertIsNone(tracer.grid)
        found = self.expect_same(tracer, self.moves)
        self.assertEqual(set(found["geometry_ids"].tolist()), {-1, 0, 1, 2})
        moved = self.moves[::-1].copy()
        tracer.place(moved)
        self.expect_same(tracer, moved)
        square = np.zeros((1, 4, 4), np.float32)
        square[0, :3] = moved[1] = self.moves[0]
        square[0, 3, 3] = 1
        tracer.place(square, [1])
        self.expect_same(tracer, moved)
        with self.assertRaisesRegex(masu.Error, "placements: number 2 can't be inverted"):
            tracer.place(np.zeros((1, 3, 4)), [2])
        with self.assertRaises(ValueError):
            tracer.place(moved[:, :2])
        self.expect_same(tracer, moved)

    def test_exclude_pairs_and_worlds(self):
        rays = self.rays()
        tracer = masu.Tracer(self.placed())
        found = tracer.nearest(rays, fields=("geometry_ids", "primitive_ids"))
        pairs = np.stack([found["geometry_ids"], found["primitive_ids"]], 1)
        again = tracer.nearest(rays, fields=("geometry_ids", "primitive_ids"), exclude=pairs)
        self.assertFalse(((pairs == np.stack([again["geometry_ids"], again["primitive_ids"]], 1)).all(1) &
                          (pairs[:, 0] >= 0)).any())
        worlds = masu.Tracer(masu.Scene(meshes=self.meshes, placements=[
            masu.Placement(0, self.moves[0], world=3), masu.Placement(1, self.moves[1], mask=4, world=None)]))
        seen = lambda **options: set(worlds.nearest(rays, fields="geometry_ids", **options)["geometry_ids"].tolist())
        self.assertEqual(seen(), {-1, 1})
        self.assertEqual(seen(worlds=3), {-1, 0, 1})
        self.assertEqual(seen(worlds=3, ray_masks=3), {-1, 0})

    def test_is_in_memory_alone(self):
        scene = self.placed(spheres=[[0, 0, 0, 1]])
        self.assertEqual(scene.describe().objects, 4)
        for use in (lambda: scene.write("never"), scene.build, scene.check):
            self.assertRaisesRegex(masu.Error, "scene: is of placed meshes", use)
        self.assertRaisesRegex(masu.Error, "the scene has placements", masu.Tracer(scene).winding_numbers, [[0, 0, 0]])
        self.assertRaises(TypeError, copy.deepcopy, masu.Tracer(scene))
        self.assertRaises(ValueError, masu.Scene, meshes=self.meshes, placements=[(2, self.moves[0])])


class Copies(WithFolder):
    def all_three(self):
        self.scene(60)
        return self.made, self.grid, masu.Tracer(self.made, self.grid)

    def test_copies_share_what_they_hold_and_are_closed_each_for_itself(self):
        rays = random_rays(self.random, 50)
        for of in range(3):
            for close in (lambda one: None, lambda one: one.close()):
                use = (lambda one: one.describe(), lambda one: one.describe(),
                       lambda one: one.nearest(rays)["t_hit"].tolist())[of]
                one = self.all_three()[of]
                expected = use(one)
                for again in (copy.copy, copy.deepcopy):
                    again(one).close()
                    self.assertEqual(use(one), expected)
                    other = again(one)
                    self.assertIsInstance(other, type(one))
                    close(one)
                    self.assertEqual(use(other), expected)
                    one = other
                del other
                gc.collect()
                self.assertEqual(use(one), expected)
                one.close()
                self.assertRaises(ValueError, copy.copy, one)
                self.assertRaises(ValueError, use, one)

    def test_what_copies_hold_is_freed_with_the_last_of_them(self):
        def make(scene):
            copies = [copy.copy(scene), copy.deepcopy(copy.copy(scene)), pickle.loads(pickle.dumps(scene))]
            copies[1].close()

        self.assert_freed(make)

    def test_pickles_go_through_the_bytes_of_files(self):
        scene, grid, tracer = self.all_three()
        rays = random_rays(self.random, 50)
        for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
            for one in (scene, grid):
                one.write(self.file("a"))
                pickle.loads(pickle.dumps(one, protocol)).write(self.file("b"))
                self.assertEqual(pathlib.Path(self.file("a")).read_bytes(), pathlib.Path(self.file("b")).read_bytes())
        for one in (tracer, masu.Tracer(scene, brute_force=True)):
            again = pickle.loads(pickle.dumps(one))
            self.assertEqual(repr(again), repr(one))
            self.assertNotEqual(again.number, one.number)
            same_bits(self, again.nearest(rays, fields=masu.FIELDS), one.nearest(rays, fields=masu.FIELDS))

    def test_a_tracer_that_was_moved_says_what_to_do_instead(self):
        vertices, faces = random_mesh(self.random, 20)
        scene = masu.Scene(vertices, faces)
        tracer = masu.Tracer(scene, scene.build(structure="bvh", quality="fast"))
        twin, apart = copy.copy(tracer), copy.deepcopy(tracer)
        rays = random_rays(self.random, 50)
        before = tracer.nearest(rays)
        self.assertNotEqual(len({each.number for each in (tracer, twin, apart)}), 1)
        tracer.update(vertices + np.float32([0, 0, 5]))
        same_bits(self, twin.nearest(rays), tracer.nearest(rays))
        same_bits(self, apart.nearest(rays), before)
        for each in (tracer, twin):
            for again in (copy.deepcopy, pickle.dumps):
                with self.assertRaisesRegex(TypeError, "make a masu.Scene of the vertices"):
                    again(each)
        apart.update(vertices)  # as many vertices as the scene was made of

    def test_scenes_and_intersectors_of_other_names_are_copied(self):
        meshes = [random_mesh(self.random, count) for count in (30, 20)]
        rays = random_rays(self.random, 50)
        scene = masu.RaycastingScene(nthreads=1)
        scene.add_triangles(*meshes[0])
        expected = scene.cast_rays(rays)
        copies = [copy.copy(scene), copy.deepcopy(scene), pickle.loads(pickle.dumps(scene)), masu.RaycastingScene(scene)]
        for each in copies:
            same_bits(self, each.cast_rays(rays), expected)
            self.assertEqual(each.add_triangles(*meshes[1]), 1)
        same_bits(self, scene.cast_rays(rays), expected)
        self.assertEqual(repr(scene), "<masu.RaycastingScene on cpu: 1 meshes, 30 triangles>")

        intersector = masu.RayMeshIntersector(Attributes(vertices=meshes[0][0], faces=meshes[0][1]))
        first = intersector.intersects_first(rays[:, :3], rays[:, 3:])
        for each in (copy.copy(intersector), copy.deepcopy(intersector), pickle.loads(pickle.dumps(intersector))):
            np.testing.assert_array_equal(each.intersects_first(rays[:, :3], rays[:, 3:]), first)

    def test_object_masks_outlive_the_closing_of_the_scene(self):
        scene = masu.Scene(meshes=[random_mesh(self.random, 20) for _ in range(3)])
        tracer, rays = masu.Tracer(scene), random_rays(self.random, 50)
        expected = tracer.nearest(rays, object_masks=[1, 0, 1])
        scene.close()
        same_bits(self, tracer.nearest(rays, object_masks=[1, 0, 1]), expected)
        same_bits(self, tracer.closest(rays[:, :3], object_masks=[0, 1, 0]), tracer.closest(rays[:, :3], object_masks=[0, 2, 0]))


class Attributes(types.SimpleNamespace):
    """An object with these attributes."""


class OtherNames(WithFolder):
    """The classes with Open3D's and trimesh's names."""

    def test_a_raycasting_scene_numbers_primitives_in_their_mesh(self):
        meshes = [random_mesh(self.random, count) for count in (60, 1, 90)]
        scene = masu.RaycastingScene(nthreads=1)
        rays = random_rays(self.random, 600).reshape(20, 30, 6)
        self.assertTrue((scene.cast_rays(rays)["geometry_ids"] == scene.INVALID_ID).all())
        self.assertEqual([scene.add_triangles(*mesh) for mesh in meshes], [0, 1, 2])
        hits = scene.cast_rays(rays)
        self.assertEqual({name: (str(array.dtype), array.shape) for name, array in hits.items()},
                         {"t_hit": ("float32", (20, 30)), "geometry_ids": ("uint32", (20, 30)),
                          "primitive_ids": ("uint32", (20, 30)), "primitive_uvs": ("float32", (20, 30, 2)),
                          "primitive_normals": ("float32", (20, 30, 3))})
        expected = masu.Tracer(masu.Scene(meshes=meshes)).nearest(rays, fields=masu.FIELDS)
        for name in ("t_hit", "primitive_uvs", "primitive_normals"):
            np.testing.assert_array_equal(hits[name], expected[name])
        np.testing.assert_array_equal(hits["geometry_ids"].view(np.int32), expected["geometry_ids"])
        hit = expected["primitive_ids"] >= 0
        self.assertGreater(hit.sum(), 50)
        first = np.array([0, 60, 61])[expected["geometry_ids"][hit]]
        np.testing.assert_array_equal(hits["primitive_ids"][hit] + first, expected["primitive_ids"][hit])
        self.assertTrue((hits["primitive_ids"][~hit] == scene.INVALID_ID).all())
        np.testing.assert_array_equal(scene.test_occlusions(rays), hit)
        np.testing.assert_array_equal(scene.test_occlusions(rays, 0.5, 2.0),
                                      scene.tracer.occluded(np.concatenate([rays[..., :3], np.full((20, 30, 1), 0.5, np.float32),
                                                                            rays[..., 3:], np.full((20, 30, 1), 2, np.float32)], -1)))
        self.assertEqual(repr(scene), "<masu.RaycastingScene on cpu: 3 meshes, 151 triangles>")
        self.assertRaises(ValueError, scene.cast_rays, np.zeros((5, 8)))
        self.assertRaises(ValueError, scene.add_triangles, meshes[0][0], meshes[0][1] + 1)
        self.assertRaises(TypeError, scene.add_triangles, meshes[0][0])

    def test_occupancy_is_the_majority_of_an_odd_number_of_rays(self):
        corners, faces = cube()
        points = self.random.uniform(-2, 2, (1000, 3))
        inside = np.abs(points).max(-1) < 1
        closed, with_hole = masu.RaycastingScene(), masu.RaycastingScene()
        closed.add_triangles(corners, faces)
        with_hole.add_triangles(corners, np.delete(faces, np.flatnonzero((corners[faces][:, :, 0] == 1).all(1))[0], 0))
        for samples in (1, 3, 9):
            np.testing.assert_array_equal(closed.compute_occupancy(points, nsamples=samples), inside)
            self.assertEqual((closed.compute_signed_distance(points, 0, samples) < 0).tolist(), inside.tolist())
        wrong = [(with_hole.compute_occupancy(points, nsamples=samples) != inside).sum() for samples in (1, 31)]
        self.assertGreater(wrong[0], 10)
        self.assertLess(wrong[1], wrong[0] / 2)
        for samples in (0, 2, -1):
            self.assertRaises(ValueError, closed.compute_occupancy, points, nsamples=samples)
        self.assertRaises(TypeError, closed.compute_occupancy, points, nsamples=1.0)

    def test_all_intersections_are_listed_once(self):
        scene = masu.RaycastingScene()
        for count in (40, 70):
            scene.add_triangles(*random_mesh(self.random, count))
        rays = random_rays(self.random, 300)
        counts, lists = scene.count_intersections(rays), scene.list_intersections(rays)
        self.assertEqual(str(counts.dtype), "int32")
        np.testing.assert_array_equal(np.diff(lists["ray_splits"]), counts)
        np.testing.assert_array_equal(lists["ray_ids"], np.repeat(np.arange(300), counts))
        first = scene.cast_rays(rays)
        hit = counts > 0
        np.testing.assert_array_equal(hit, np.isfinite(first["t_hit"]))
        begin = lists["ray_splits"][:-1][hit]
        np.testing.assert_array_equal(lists["t_hit"][begin], first["t_hit"][hit])
        for name in ("geometry_ids", "primitive_ids", "primitive_uvs"):
            np.testing.assert_array_equal(lists[name][begin], first[name][hit])
        same_ray = lists["ray_ids"][1:] == lists["ray_ids"][:-1]
        self.assertTrue((lists["t_hit"][1:] >= lists["t_hit"][:-1])[same_ray].all())
        self.assertGreater(counts.max(), 2)
        none = scene.list_intersections(np.zeros((0, 6), np.float32))
        self.assertEqual((none["ray_splits"].tolist(), none["t_hit"].shape), ([0], (0,)))

    def test_rays_of_a_pinhole_camera_pass_its_pixels(self):
        width, height = 40, 30
        rotation = np.linalg.qr(self.random.normal(size=(3, 3)))[0]
        extrinsic = np.eye(4)
        extrinsic[:3, :3], extrinsic[:3, 3] = rotation, self.random.normal(size=3)
        intrinsic = np.float64([[50, 0, 21], [0, 60, 14], [0, 0, 1]])
        rays = masu.RaycastingScene.create_rays_pinhole(intrinsic, extrinsic, width, height).astype(np.float64)
        self.assertEqual(rays.shape, (height, width, 6))
        at = rays[..., :3] + 3 * rays[..., 3:]
        inside = at @ rotation.T + extrinsic[:3, 3]
        np.testing.assert_allclose(inside[..., 2], 3, atol=1e-5)
        pixels = inside @ intrinsic.T / 3
        np.testing.assert_allclose(pixels[..., 0], np.broadcast_to(np.arange(width) + 0.5, (height, width)), atol=1e-3)
        np.testing.assert_allclose(pixels[..., 1], np.arange(height)[:, None].repeat(width, 1) + 0.5, atol=1e-3)
        eye, center, up = np.float64([1, 2, 3]), np.float64([1, 5, 3]), np.float64([0, 0, 2])
        rays = masu.RaycastingScene.create_rays_pinhole(fov_deg=90, center=center, eye=eye, up=up, width_px=width,
                                                        height_px=height)
        np.testing.assert_array_equal(rays[..., :3], np.broadcast_to(eye, (height, width, 3)))
        np.testing.assert_allclose(rays[..., 4], 1, atol=1e-6)
        np.testing.assert_allclose(rays[:, -1, 3] - rays[:, 0, 3], -2 + 2 / width, atol=1e-5)
        self.assertTrue((np.diff(rays[:, 0, 5]) > 0).all())  # rows follow up
        self.assertRaises(ValueError, masu.RaycastingScene.create_rays_pinhole, intrinsic, intrinsic, 4, 4)

    def test_rays_of_a_lidar_have_its_angles(self):
        elevations, azimuths = self.random.uniform(-90, 90, 5), self.random.uniform(-360, 720, 7)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = np.linalg.qr(self.random.normal(size=(3, 3)))[0], self.random.normal(size=3)
        rays = masu.RaycastingScene.create_rays_lidar(pose, elevations, azimuths)
        self.assertEqual((rays.dtype, rays.shape), (np.float64, (5, 7, 6)))
        for row, elevation in zip(rays.astype(np.float64), np.deg2rad(elevations)):
            for ray, azimuth in zip(row, np.deg2rad(azimuths)):
                direction = [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
                np.testing.assert_allclose(ray[3:], sum(pose[:3, axis] * direction[axis] for axis in range(3)), atol=1e-7)
                np.testing.assert_array_equal(ray[:3], pose[:3, 3])
        for name, arguments in (("pose", (pose[:3], [0], [0])), ("elevations_deg", (pose, 0, [0])),
                                ("azimuths_deg", (pose, [0], [[0]]))):
            with self.assertRaisesRegex(ValueError, "^{}: ".format(name)):
                masu.RaycastingScene.create_rays_lidar(*arguments)

    def test_a_ray_mesh_intersector_has_the_hits_of_the_tracer(self):
        vertices, faces = random_mesh(self.random, 100)
        mesh = Attributes(vertices=vertices.astype(np.float64), faces=faces.astype(np.int64))
        intersector = masu.RayMeshIntersector(mesh)
        rays = random_rays(self.random, 400)
        origins, directions = rays[:, :3], rays[:, 3:]
        expected = intersector.tracer.nearest(rays.astype(np.float64))
        np.testing.assert_array_equal(intersector.intersects_first(origins, directions), expected["primitive_ids"])
        np.testing.assert_array_equal(intersector.intersects_any(origins, directions), expected["primitive_ids"] >= 0)
        triangles, ray, locations = intersector.intersects_id(origins, directions, multiple_hits=False, return_locations=True)
        np.testing.assert_array_equal(expected["primitive_ids"][ray], triangles)
        self.assertEqual(len(ray), (expected["primitive_ids"] >= 0).sum())
        for more in (False, True):
            locations, ray, triangles = intersector.intersects_location(origins, directions, multiple_hits=more)
            a, b, c = np.moveaxis(mesh.vertices[mesh.faces[triangles]], 1, 0)
            normals = np.cross(b - a, c - a)
            distance = ((locations - a) * normals).sum(1) / np.linalg.norm(normals, axis=1)
            np.testing.assert_allclose(distance, 0, atol=1e-5)
            self.assertEqual(set(ray.tolist()), set(np.flatnonzero(expected["primitive_ids"] >= 0).tolist()))
        self.assertGreater(len(ray), len(set(ray.tolist())))
        self.assertRaises(ValueError, intersector.intersects_any, origins[:, :2], directions)
        self.assertRaises(ValueError, intersector.intersects_any, origins, directions[1:])
        self.assertRaises(TypeError, masu.RayMeshIntersector, vertices)

    def test_points_in_a_closed_mesh_are_told_from_those_outside_whichever_way_faces_are_turned(self):
        vertices, faces = cube()
        points = self.random.uniform(-2, 2, (500, 3))
        points = points[(np.abs(np.abs(points) - 1) > 1e-3).all(1)]
        for turned in (0, len(faces), 3, *self.random.integers(1, len(faces), 3)):
            some = self.random.permutation(len(faces))[:turned]
            faces[some] = faces[some, ::-1]
            contains = masu.RayMeshIntersector(Attributes(vertices=vertices, faces=faces)).contains_points(points)
            self.assertEqual(contains.dtype, bool)
            np.testing.assert_array_equal(contains, (np.abs(points) < 1).all(1), str(some))

    def test_made_rays_keep_the_digits_of_what_they_are_made_from(self):
        scene, intrinsic = masu.RaycastingScene, np.float64([[50, 0, 2], [0, 50, 2], [0, 0, 1]])
        pose = np.eye(4)
        pose[:3, 3] = 5.4e6 + self.random.uniform(0, 1, 3)
        extrinsic = np.linalg.inv(pose)
        eye = pose[:3, 3]
        for number in (np.float32, np.float64):
            made = [scene.create_rays_lidar(pose.astype(number), np.zeros(2, number), np.zeros(2, number)),
                    scene.create_rays_pinhole(intrinsic.astype(number), extrinsic.astype(number), 4, 4),
                    scene.create_rays_pinhole(60, (eye + [0, 0, 1]).astype(number), eye.astype(number), np.array([0, 1, 0], number), 4, 4)]
            for rays in made:
                self.assertEqual(rays.dtype, number)
                np.testing.assert_allclose(rays[..., :3], np.broadcast_to(eye, rays[..., :3].shape), rtol=0, atol=2e-9 if number is np.float64 else 1)
        self.assertEqual(scene.create_rays_lidar(pose.tolist(), [0], [0]).dtype, np.float64)
        self.assertEqual(scene.create_rays_lidar(np.float32(pose), np.float64([0]), np.float32([0])).dtype, np.float64)

        # Four walls 10 m around a lidar in UTM coordinates.
        corners = cube()[0].astype(np.float64) * 10 + eye
        walls = scene()
        walls.add_triangles(corners, cube()[1])
        hits = walls.cast_rays(scene.create_rays_lidar(pose, [0], [0, 90, 180, 270]))
        np.testing.assert_allclose(hits["t_hit"], 10, atol=1e-5)
        whole = np.int64([[2**24 + 1, 3, 0, 0, 0, 1]])  # float32 has no such number
        tile = scene()
        tile.add_triangles(np.float64([[0, 0, 5], [1, 0, 5], [0, 6, 5]]) + [2**24 + 0.75, 0, 0], [[0, 1, 2]])
        self.assertEqual(tile.cast_rays(whole)["t_hit"].tolist(), [5])

    def test_float64_rays_hit_what_they_are_aimed_at_from_any_distance(self):
        vertices, faces = cube()
        for at in (0, 5e6):
            scene = masu.Scene(vertices + np.float64(at), faces)
            self.assertFalse(scene.describe().is_float64)
            tracer = masu.Tracer(scene)
            for distance in (3, 1e3, 1e5, 1e7, 1e9):
                away = self.random.normal(size=(200, 3))
                origins = at + away / np.linalg.norm(away, axis=1)[:, None] * distance
                targets = at + self.random.uniform(-0.9, 0.9, (200, 3))
                rays = np.concatenate([origins, targets - origins], 1)
                hits = tracer.nearest(rays, fields=("t_hit64", "t_hit", "primitive_ids"))
                exact = tracer.nearest(rays, fields=("t_hit64", "primitive_ids"), precision="double")
                self.assertTrue((hits["primitive_ids"] >= 0).all(), distance)
                np.testing.assert_array_equal(hits["t_hit"], hits["t_hit64"].astype(np.float32))
                # Where float32 has an edge of the cube elsewhere, t may be of its neighbour: as near.
                np.testing.assert_allclose((hits["t_hit64"] - exact["t_hit64"]) * distance, 0, atol=1e-4 + 1e-15 * (distance + at))
                self.assertTrue((tracer.count_hits(rays) == 2).all())
                self.assertTrue(tracer.occluded(rays).all())

    def test_the_neighbours_own_argument_lists_are_understood_by_position(self):
        vertices, faces = random_mesh(self.random, 100)
        rays = random_rays(self.random, 100)
        origins, directions = rays[:, :3], rays[:, 3:]
        # trimesh.ray.ray_triangle: intersects_id(ray_origins, ray_directions, return_locations, multiple_hits)
        for intersector in (masu.RayMeshIntersector(Attributes(vertices=vertices, faces=faces)),
                            masu.RayMeshIntersector(Attributes(vertices=vertices, faces=faces), True)):
            every = intersector.intersects_id(origins, directions)
            self.assertEqual(len(every), 2)
            located = intersector.intersects_id(origins, directions, True)
            self.assertEqual(len(located), 3)
            for one, other in zip(every, located):
                np.testing.assert_array_equal(one, other)
            first = intersector.intersects_id(origins, directions, False, False)
            self.assertEqual(len(first), 2)
            np.testing.assert_array_equal(first[0], intersector.intersects_first(origins, directions)[first[1]])
            self.assertLess(len(first[0]), len(every[0]))
            for most in (1, 2, 1000):
                some = intersector.intersects_id(origins, directions, True, True, most)
                kept = np.concatenate([np.flatnonzero(every[1] == ray)[:most] for ray in range(100)])
                for one, other in zip(some, located):
                    np.testing.assert_array_equal(one, other[kept])
            np.testing.assert_array_equal(intersector.intersects_location(origins, directions, True)[0], located[2])
            self.assertEqual(len(intersector.intersects_location(origins, directions, False)[1]), len(first[1]))
            self.assertEqual(intersector.intersects_any(origins, directions).tolist(), np.isin(np.arange(100), every[1]).tolist())
            self.assertRaises(ValueError, intersector.intersects_id, origins, directions, False, True, 0)
        self.assertRaises(TypeError, masu.RayMeshIntersector, Attributes(vertices=vertices, faces=faces), "cpu")

        # open3d.t.geometry.RaycastingScene
        scene = masu.RaycastingScene(2, "CPU:0")
        self.assertEqual(scene.add_triangles(vertices, faces), 0)
        same_bits(self, scene.cast_rays(rays, 1), scene.cast_rays(rays))
        np.testing.assert_array_equal(scene.test_occlusions(rays, 0.25, 0.75, 1), scene.test_occlusions(rays, tnear=0.25, tfar=0.75))
        np.testing.assert_array_equal(scene.count_intersections(rays, 1), np.bincount(every[1], minlength=100))
        same_bits(self, scene.list_intersections(rays, 1), scene.list_intersections(rays))
        same_bits(self, scene.compute_closest_points(origins, 1), scene.compute_closest_points(origins))
        for compute in (scene.compute_distance, scene.compute_signed_distance, scene.compute_occupancy):
            np.testing.assert_array_equal(compute(origins, 1), compute(origins))
        for compute in (scene.compute_signed_distance, scene.compute_occupancy):
            np.testing.assert_array_equal(compute(origins, 0, 3), compute(origins, nsamples=3))
        self.assertEqual(scene.create_rays_pinhole(np.eye(3), np.eye(4), 5, 4).shape, (4, 5, 6))
        self.assertEqual(scene.create_rays_pinhole(60.0, [0, 0, 1], [0, 0, 0], [0, 1, 0], 5, 4).shape, (4, 5, 6))

    def test_rays_of_any_number_of_hits_are_listed(self):
        count = 66_000
        vertices = np.tile(np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), (count, 1))
        vertices[:, 2] = np.repeat(self.random.permutation(count) / np.float32(2**17), 3)  # exact
        faces = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
        rays = np.float32([[0.25, 0.25, -1, 0, 0, 1], [2, 2, -1, 0, 0, 1]])
        scene, one = masu.RaycastingScene(), masu.Scene(vertices, faces)
        scene.add_triangles(vertices, faces)
        scene._tracer = masu.Tracer(one, one.build(structure="bvh", quality="fast"))  # takes less time than the usual one
        lists = scene.list_intersections(rays)
        self.assertEqual(lists["ray_splits"].tolist(), [0, count, count])
        np.testing.assert_array_equal(lists["t_hit"], np.sort(vertices[::3, 2]) + 1)
        np.testing.assert_array_equal(lists["primitive_ids"], np.argsort(vertices[::3, 2]))

    def test_meshes_of_other_libraries_are_read_or_refused_by_name(self):
        vertices, faces = random_mesh(self.random, 30)
        rays = random_rays(self.random, 50)
        expected = masu.Tracer(masu.Scene(vertices, faces)).nearest(rays)
        flat = np.column_stack([np.full(len(faces), 3), faces]).ravel()

        class PolyData(Attributes):
            pass

        class Block(Attributes):
            pass

        read = (Attributes(vertices=vertices, faces=faces), Attributes(vertices=vertices, triangles=faces),
                Attributes(vertex={"positions": vertices}, triangle={"indices": faces}),
                PolyData(points=vertices, faces=flat, strips=np.zeros(0, int)), Attributes(points=vertices, faces=faces),
                Attributes(points=vertices.astype(float), cells=[
                    Block(type="vertex", data=[[0]]), Block(type="triangle", data=faces[:20]),
                    Block(type="line", data=[[0, 1]]), Block(type="triangle", data=faces[20:])]))
        for mesh in read:
            scene = masu.RaycastingScene()
            scene.add_triangles(mesh)
            for tracer in (masu.Tracer(masu.Scene(mesh)), masu.Tracer(masu.Scene(meshes=[mesh])), scene.tracer,
                           masu.RayMeshIntersector(mesh).tracer):
                same_bits(self, tracer.nearest(rays), expected)
        both = masu.Scene(meshes=[(vertices, faces), read[3], masu.Mesh(vertices, faces)])
        self.assertEqual(both.describe().objects, 3)
        refused = ((PolyData(points=vertices, faces=np.append(flat, [4, 0, 1, 2, 3])), "PolyData: .*triangulate"),
                   (PolyData(points=vertices, faces=flat, strips=np.array([4, 0, 1, 2, 3])), "PolyData: .*triangulate"),
                   (Attributes(points=vertices, cells=[Block(type="quad", data=[[0, 1, 2, 3]])]), "Attributes: .*quad"),
                   (Attributes(points=vertices, cells=flat), "Attributes: a mesh with vertices and faces"),
                   (Attributes(points=vertices), "Attributes: a mesh with vertices and faces"))
        for mesh, says in refused:
            for use in (masu.Scene, lambda mesh: masu.Scene(meshes=[mesh]), masu.RaycastingScene().add_triangles,
                        masu.RayMeshIntersector):
                with self.assertRaisesRegex(TypeError, says) as raised:
                    use(mesh)
                self.assertNotIn("\n", str(raised.exception))
        self.assertRaises(ValueError, masu.Scene, Attributes(points=vertices[:, :2], faces=faces))
        self.assertRaises(TypeError, masu.RayMeshIntersector, vertices)


class Module(unittest.TestCase):
    def test_it_is_of_the_librarys_version_and_lists_what_it_has(self):
        from masu import _library
        self.assertEqual(masu.__version__, _library.library.masu_version().decode())
        for name in masu.__all__:
            self.assertTrue(hasattr(masu, name), name)
        for name in (name for name in masu.__all__ if callable(getattr(masu, name))):
            self.assertTrue(getattr(masu, name).__doc__, name)

    def test_numpy_is_imported_when_it_is_used(self):
        result = run_python("import masu, sys\nmasu.gpu_count()\nassert 'numpy' not in sys.modules")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_without_the_library_it_says_what_to_do(self):
        for path in ("/nowhere/libmasu.so", sys.executable):
            result = run_python("import masu", MASU_LIBRARY=path)
            self.assertEqual(result.returncode, 1)
            self.assertIn("ImportError", result.stderr)
            self.assertIn(path, result.stderr)
        other = run_python("import masu", MASU_LIBRARY="libm.so.6")
        self.assertIn("this isn't Masu's library", other.stderr)

    def test_a_process_may_end_with_open_tracers(self):
        with tempfile.TemporaryDirectory() as folder:
            result = run_python("import masu, os, threading\nos.chdir({!r})\n".format(folder) + """
tracer = masu.Tracer(masu.Scene([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
def work():
    while True: tracer.nearest([[0.2, 0.2, 1, 0, 0, -1]] * 1000)
threading.Thread(target=work, daemon=True).start()
print(tracer.nearest([0.2, 0.2, 2, 0, 0, -1])["t_hit"])
""")
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "2.0\n", ""))


class Documentation(unittest.TestCase):
    def test_the_modules_own_example_runs(self):
        text = "".join(line[4:] + "\n" for line in masu.__doc__.splitlines() if line.startswith("    "))
        with tempfile.TemporaryDirectory() as folder:
            result = run_python("import os\nos.chdir({!r})\n".format(folder) + text)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "[1.] [0]\n", ""))


if __name__ == "__main__":
    unittest.main()
