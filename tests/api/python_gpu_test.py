"""The Python module with tensors of PyTorch and arrays of CuPy, on a GPU.

    PYTHONPATH=api/python MASU_LIBRARY=…/libmasu.so python3 tests/api/python_gpu_test.py [torch] [cupy]

By default both. Exits with 77 where there is no GPU, or one of them isn't installed: nothing is tested then."""

import importlib
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "api/python"))

import numpy as np

import masu
from python_scene import cube, documented_examples, random_generator, random_mesh, random_rays, same_bits

torch = cupy = None  # imported in main()


class WithTracers(unittest.TestCase):
    def setUp(self):
        self.random = random_generator()
        self.mesh = random_mesh(self.random, 2000)
        scene = masu.Scene(*self.mesh)
        grid = scene.build()
        self.cpu = masu.Tracer(scene, grid)
        self.gpu = masu.Tracer(scene, grid, "cuda:0")
        self.addCleanup(self.cpu.close)
        self.addCleanup(self.gpu.close)

    def lists(self, count=20000):
        """Rays of every format, as NumPy's."""
        rays = random_rays(self.random, count)
        long = np.concatenate([rays[:, :3], self.random.uniform(0, 0.5, (count, 1)), rays[:, 3:],
                               self.random.uniform(0, 2, (count, 1))], 1)
        return [rays, rays.astype(np.float64), long.astype(np.float32), long]

    def same(self, hits, expected):
        same_bits(self, hits, expected)

    def every(self, tracer, rays, **options):
        return {**tracer.nearest(rays, fields=masu.FIELDS, **options), "occluded": tracer.occluded(rays, **options)}


class HostMemory(WithTracers):
    def test_numpy_on_a_gpu_gives_the_bits_of_the_cpu(self):
        for rays in self.lists():
            self.same(self.every(self.gpu, rays), self.every(self.cpu, rays))
            self.same(self.every(self.gpu, rays, precision="double"), self.every(self.cpu, rays, precision="double"))

    def test_devices(self):
        self.assertGreater(masu.gpu_count(), 0)
        self.assertEqual((self.gpu.device, self.cpu.device), ("cuda:0", "cpu"))


class OnTheDevice(WithTracers):
    """Tests of either library's arrays: on_gpu(NumPy's), of_type(array, name), by_columns(array)."""

    def test_results_are_the_bits_of_the_cpu_and_on_the_device(self):
        for rays in self.lists():
            given = self.on_gpu(rays)
            hits = self.every(self.gpu, given, coherent=True)
            for array in hits.values():
                self.assertEqual((type(array), array.device), (type(given), given.device))
            self.same(hits, self.every(self.cpu, rays))

    def expect_any_layout_and_type(self, rays, array, wide):
        expected = self.every(self.cpu, rays)
        wide[::2, 1:7] = array
        for given in (wide[::2, 1:7], self.by_columns(array), self.of_type(array, "float64")):
            self.same(self.every(self.gpu, given), expected)
        shaped = self.every(self.gpu, array.reshape(4, 3, 20, 6))
        self.assertEqual(tuple(shaped["primitive_normals"].shape), (4, 3, 20, 3))
        self.same({name: part.reshape((240,) + tuple(part.shape[3:])) for name, part in shaped.items()}, expected)
        whole = self.of_type((array * 4).round(), "int64")
        self.same(self.every(self.gpu, whole), self.every(self.cpu, np.rint(rays * 4)))
        for leading in ((0,), (3, 0)):
            empty = self.every(self.gpu, array[:0].reshape(leading + (6,)))
            self.assertEqual(tuple(empty["primitive_uvs"].shape), leading + (2,))
        self.assertEqual(self.gpu.occluded(array[0]).shape, ())

    def test_wrong_arrays_are_refused(self):
        rays = self.on_gpu(np.zeros((5, 6), np.float32))
        for error, array in ((ValueError, rays[:, :5]), (TypeError, rays > 0), (TypeError, self.of_type(rays, "complex64"))):
            self.assertRaises(error, self.gpu.nearest, array)
        self.assertRaises(ValueError, self.cpu.nearest, rays)
        self.assertRaises(TypeError, self.gpu.nearest, rays, stream="1")


class Torch(OnTheDevice):
    def on_gpu(self, array):
        return torch.as_tensor(array, device="cuda:0")

    def of_type(self, array, name):
        return array.to(getattr(torch, name))

    def by_columns(self, array):
        return array.t().contiguous().t()

    def test_a_scene_of_tensors_is_that_of_numpy(self):
        rays = self.lists()[0]
        for device in ("cpu", "cuda:0"):
            scene = masu.Scene(*(torch.tensor(array.astype(np.int64) if array.dtype == np.uint32 else array, device=device)
                                 for array in self.mesh))
            self.same(self.every(masu.Tracer(scene), rays), self.every(self.cpu, rays))

    def test_a_tracer_is_updated_by_tensors(self):
        vertices, faces = self.mesh
        scene = masu.Scene(vertices, faces)
        grid = scene.build(structure="bvh", quality="fast")
        rays = self.lists()[0]
        cpu, gpu = masu.Tracer(scene, grid), masu.Tracer(scene, grid, "cuda:0")
        for dtype in (torch.float32, torch.float64, torch.float16):
            moved = torch.as_tensor(vertices, device="cuda:0") + 0.1 * torch.rand(vertices.shape, device="cuda:0")
            moved = moved.to(dtype)
            cpu.update(moved.to(torch.float64).cpu().numpy())
            stream = torch.cuda.Stream()
            with torch.cuda.stream(stream):
                late = torch.zeros(len(vertices), 6, device="cuda:0", dtype=dtype)
                stream.wait_stream(torch.cuda.default_stream())
                late[:, ::2] = moved
                gpu.update(late[:, ::2])
            for tracer in (gpu, cpu):
                self.same(self.every(tracer, rays), self.every(cpu, rays))
            cpu.update(moved)
            self.same(self.every(gpu, torch.as_tensor(rays, device="cuda:0")), self.every(cpu, rays))
        self.assertRaises(TypeError, gpu.update, moved > 0)
        self.assertRaises(ValueError, gpu.update, moved[:, :2])

    def test_closest_points_are_found_where_points_lie(self):
        for points in (self.random.uniform(-1, 2, (70, 30, 3)), self.random.uniform(-1, 2, (500, 3)).astype(np.float32)):
            expected = self.cpu.closest(points, fields=masu.CLOSEST_FIELDS)
            self.same(self.gpu.closest(points, fields=masu.CLOSEST_FIELDS), expected)
            tensor = torch.as_tensor(points, device="cuda:0")
            found = self.gpu.closest(tensor, fields=masu.CLOSEST_FIELDS)
            self.assertEqual(found["points"].device, tensor.device)
            self.same(found, expected)
            stream = torch.cuda.Stream()
            found = self.gpu.closest(tensor, fields=masu.CLOSEST_FIELDS, stream=stream)
            stream.synchronize()
            self.same(found, expected)
            self.same({"": self.gpu.inside(tensor)}, {"": self.cpu.inside(points)})

    def test_distances_of_the_other_names_are_found_where_points_lie(self):
        on_cpu, on_gpu = masu.RaycastingScene(), masu.RaycastingScene(device="cuda:0")
        for scene in (on_cpu, on_gpu):
            scene.add_triangles(*cube())
        points = self.random.uniform(-2, 2, (40, 50, 3)).astype(np.float32)
        tensor = torch.as_tensor(points, device="cuda:0")
        for name in ("compute_distance", "compute_signed_distance", "compute_occupancy"):
            expected = getattr(on_cpu, name)(points)
            found = getattr(on_gpu, name)(tensor)
            self.assertEqual(found.device, tensor.device)
            self.same({name: found}, {name: expected})
            self.same({name: getattr(on_gpu, name)(points)}, {name: expected})
            self.same({name: getattr(on_cpu, name)(tensor)}, {name: expected})

    def test_values_are_interpolated_where_they_lie(self):
        rays = self.lists()[0]
        values, faces = self.random.uniform(-1, 1, (len(self.mesh[0]), 4)), self.mesh[1]
        hits = self.cpu.nearest(rays, fields=("primitive_ids", "primitive_uvs"))
        on_gpu = self.gpu.nearest(torch.as_tensor(rays, device="cuda:0"), fields=("primitive_ids", "primitive_uvs"))
        expected = masu.interpolate(hits, values, faces)
        found = masu.interpolate(on_gpu, torch.as_tensor(values, device="cuda:0"),
                                 torch.as_tensor(faces.astype(np.int64), device="cuda:0"))
        self.assertEqual(found.device, torch.device("cuda:0"))
        self.same({"values": found}, {"values": expected})
        self.assertRaises(ValueError, masu.interpolate, on_gpu, values, faces)

    def test_tensors_in_host_memory(self):
        for rays in self.lists(500):
            for tracer in (self.cpu, self.gpu):
                hits = self.every(tracer, torch.from_numpy(rays))
                for array in hits.values():
                    self.assertEqual(array.device, torch.device("cpu"))
                self.same(hits, self.every(self.cpu, rays))

    def test_any_layout_and_type(self):
        rays = random_rays(self.random, 240)
        expected = self.every(self.cpu, rays)
        for device in ("cpu", "cuda:0"):
            tensor = torch.as_tensor(rays, device=device)
            self.expect_any_layout_and_type(rays, tensor, torch.full((480, 9), float("nan"), device=device))
            self.same(self.every(self.gpu, tensor.clone().requires_grad_()), expected)
            half = tensor.to(torch.float16)
            self.same(self.every(self.gpu, half), self.every(self.cpu, half.cpu().numpy().astype(np.float32)))
            shifted = torch.empty(240 * 6 + 1, device=device)[1:].view(240, 6)  # not aligned to 16 bytes
            shifted.copy_(tensor)
            self.same(self.every(self.gpu, shifted), expected)

    def test_wrong_tensors_are_refused(self):
        rays = torch.zeros(5, 6, device="cuda:0")
        for error, tensor in ((ValueError, torch.zeros(5, 7, device="cuda:0")), (TypeError, rays.to_sparse()),
                              (TypeError, torch.zeros(5, 6, device="meta"))):
            self.assertRaises(error, self.gpu.nearest, tensor)
        self.assertRaises(ValueError, self.gpu.nearest, rays.cpu(), stream=torch.cuda.current_stream())
        self.assertRaises(ValueError, self.gpu.nearest, rays, stream=-1)

    def test_a_query_is_queued_on_the_current_or_the_given_stream(self):
        rays = random_rays(self.random, 20000)
        expected = self.every(self.cpu, rays)
        source = torch.as_tensor(rays, device="cuda:0")
        stream = torch.cuda.Stream()
        delay = torch.rand(4096, 4096, device="cuda:0")
        torch.cuda.synchronize()
        for given in (None, stream, stream.cuda_stream):
            for columns in (6, 12):  # contiguous, and with a temporary copy
                with torch.cuda.stream(stream):
                    for _ in range(20):  # what comes before on the stream must be waited for
                        delay = delay @ delay / 4096
                    late = torch.zeros(len(rays), columns, device="cuda:0")
                    late[:, :6] = source
                    if given is None:
                        hits = self.every(self.gpu, late[:, :6])
                if given is not None:
                    hits = self.every(self.gpu, late[:, :6], stream=given)
                del late  # its memory may be taken again at once
                torch.full((len(rays), columns), float("nan"), device="cuda:0")
                with torch.cuda.stream(stream):
                    torch.full((len(rays), columns), float("nan"), device="cuda:0")
                stream.synchronize()
                self.same(hits, expected)

    def test_a_tensor_may_be_deleted_while_its_query_is_queued_on_another_stream(self):
        rays = random_rays(self.random, 20000)
        expected = self.every(self.cpu, rays)
        stream = torch.cuda.Stream()
        delay = torch.rand(4096, 4096, device="cuda:0")
        tensor = torch.as_tensor(rays, device="cuda:0")
        torch.cuda.synchronize()
        with torch.cuda.stream(stream):
            for _ in range(20):
                delay = delay @ delay / 4096
        hits = self.every(self.gpu, tensor, stream=stream)
        del tensor
        torch.full((len(rays), 6), float("nan"), device="cuda:0")  # would take the memory, and not wait
        torch.cuda.synchronize()
        self.same(hits, expected)

    def test_dlpack_and_the_cuda_array_interface(self):
        rays = random_rays(self.random, 500)
        tensor = torch.as_tensor(rays, device="cuda:0")

        class Interface:
            __cuda_array_interface__ = tensor.__cuda_array_interface__

        class Exchange:
            def __dlpack__(self, **options):
                return tensor.__dlpack__(**options)

            def __dlpack_device__(self):
                return tensor.__dlpack_device__()

        for array in (Interface(), Exchange()):
            hits = self.every(self.gpu, array)
            self.assertIsInstance(hits["t_hit"], torch.Tensor)
            self.same(hits, self.every(self.cpu, rays))

    def test_the_documented_example_runs_as_typed(self):
        blocks = documented_examples()
        blocks = blocks[:1] + [block for block in blocks if "cuda" in block and "import torch" in block]
        self.assertEqual(len(blocks), 2)
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                exec("".join(blocks), {})
            finally:
                os.chdir(before)

    def test_the_current_device_stays(self):
        for device in range(masu.gpu_count()):
            with torch.cuda.device(device):
                self.gpu.nearest(torch.zeros(5, 6, device="cuda:0"))
                self.gpu.nearest(np.zeros((5, 6)))
                self.assertEqual(torch.cuda.current_device(), device)
                if device:
                    other = torch.zeros(5, 6, device="cuda")
                    self.assertRaises(ValueError, self.gpu.nearest, other)


class CuPy(OnTheDevice):
    def on_gpu(self, array):
        return cupy.asarray(array)

    def of_type(self, array, name):
        return array.astype(name)

    def by_columns(self, array):
        return cupy.asfortranarray(array)

    def test_any_layout_and_type(self):
        rays = random_rays(self.random, 240)
        array = cupy.asarray(rays)
        self.expect_any_layout_and_type(rays, array, cupy.full((480, 9), cupy.nan, cupy.float32))
        self.same(self.every(self.gpu, array[:, ::-1].copy()[:, ::-1]), self.every(self.cpu, rays))
        self.same(self.every(self.gpu, self.of_type(cupy.rint(array * 4), "int32")), self.every(self.cpu, np.rint(rays * 4)))

    def test_a_query_is_queued_on_the_current_or_the_given_stream(self):
        rays = random_rays(self.random, 20000)
        expected = self.every(self.cpu, rays)
        source = cupy.asarray(rays)
        stream = cupy.cuda.Stream(non_blocking=True)
        delay = cupy.random.random((2048, 2048), cupy.float32)
        cupy.cuda.Device().synchronize()
        for given in (None, stream, stream.ptr):
            for columns in (6, 12):
                with stream:
                    for _ in range(20):
                        delay = delay @ delay / 2048
                    late = cupy.zeros((len(rays), columns), cupy.float32)
                    late[:, :6] = source
                    if given is None:
                        hits = self.every(self.gpu, late[:, :6])
                if given is not None:
                    hits = self.every(self.gpu, late[:, :6], stream=given)
                with stream:
                    del late
                    cupy.full((len(rays), columns), cupy.nan, cupy.float32)
                stream.synchronize()
                self.same(hits, expected)


def main(names):
    global torch, cupy
    unknown = set(names) - {"torch", "cupy"}
    if unknown:
        sys.exit("python_gpu_test.py: {}: torch or cupy is expected".format(", ".join(unknown)))
    if masu.gpu_count() == 0:
        print("skipped: no GPU, or a library without CUDA")
        sys.exit(77)
    cases = [HostMemory]
    for name in names or ("torch", "cupy"):
        try:
            globals()[name] = importlib.import_module(name)
        except ImportError as error:
            print("skipped: {}".format(error))
            sys.exit(77)
        cases.append({"torch": Torch, "cupy": CuPy}[name])
    suite = unittest.TestSuite(map(unittest.defaultTestLoader.loadTestsFromTestCase, cases))
    sys.exit(not unittest.TextTestRunner().run(suite).wasSuccessful())


if __name__ == "__main__":
    main(sys.argv[1:])
