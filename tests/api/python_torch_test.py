"""The operators of masu.torch, on the CPU and, where there is one, a GPU. Exits with 77 where PyTorch 2.4 isn't installed.

    PYTHONPATH=api/python MASU_LIBRARY=…/libmasu.so python3 tests/api/python_torch_test.py"""

import contextlib
import gc
import io
import sys
import unittest

import numpy as np

try:
    import torch
    import masu.torch
except ImportError as error:
    print("skipped: {}".format(error))
    sys.exit(77)

from python_scene import documented_examples, random_generator, random_mesh, random_rays, same_bits

DEVICES = ["cpu"] + (["cuda:0"] if torch.cuda.is_available() and masu.gpu_count() > 0 else [])


def every(tracer, rays, **options):
    """Results of all operators."""
    sides = {"faces": "front", "exclude": torch.zeros(rays.shape[:-1], dtype=torch.int32, device=rays.device)}
    return {**masu.torch.nearest(tracer, rays * 1, fields=masu.FIELDS, **options),
            "side": masu.torch.occluded(tracer, rays, **sides), "occluded": masu.torch.occluded(tracer, rays, **options),
            "counts": masu.torch.count_hits(tracer, rays, threads=1), "inside": masu.torch.inside(tracer, rays)}


def expected(tracer, rays, **options):
    """The same by the tracer's methods."""
    return {**tracer.nearest(rays, fields=masu.FIELDS, **options),
            "side": tracer.occluded(rays, faces="front", exclude=np.zeros(rays.shape[:-1], np.int32)),
            "occluded": tracer.occluded(rays, **options), "counts": tracer.count_hits(rays), "inside": tracer.inside(rays)}


class Operators(unittest.TestCase):
    def setUp(self):
        self.random = random_generator()
        self.scenes = [masu.Scene(*random_mesh(self.random, 200)) for _ in range(2)]
        torch.compiler.reset()

    def test_they_are_what_pytorch_demands_of_operators(self):
        rays = random_rays(self.random, 60)
        segments = np.concatenate([rays[:, :3], np.zeros((60, 1)), rays[:, 3:], np.ones((60, 1))], 1)
        ops = torch.ops.masu
        comparable = [field for field in masu.FIELDS if field != "positions"]  # NaN for a miss: unequal to itself
        for device in DEVICES:
            tracer = masu.Tracer(self.scenes[0], device=device)
            for array in (rays, segments.reshape(5, 12, 8)):
                tensor = torch.as_tensor(array, device=device)
                none = torch.full(tensor.shape[:-1], -1, dtype=torch.int32, device=device)
                masks = {"object_masks": none.flatten()[:1], "ray_masks": none}
                for operator, given, options in (
                        (ops.nearest, (comparable,), {"precision": "double", "exclude": none}),
                        (ops.nearest, (["primitive_uvs"],), masks), (ops.occluded, (), {"faces": "back", "loop": "warp"}),
                        (ops.count_hits, (), masks), (ops.inside, (), {"relative": True})):
                    passed = torch.library.opcheck(operator, (tracer.number, tensor, *given), options)
                    self.assertEqual(set(passed.values()), {"SUCCESS"})

    def test_compiled_functions_have_the_tracers_results(self):
        for device in DEVICES:
            for backend in self.backends(device):
                tracers = [masu.Tracer(scene, device=device) for scene in self.scenes]
                compiled = torch.compile(every, fullgraph=True, backend=backend)
                for tracer in tracers:
                    for count in (500, 40, 41):
                        rays = random_rays(self.random, count)
                        results = compiled(tracer, torch.as_tensor(rays, device=device), precision="double")
                        self.assertEqual({str(result.device) for result in results.values()}, {device})
                        same_bits(self, results, expected(tracer, rays, precision="double"))

    def backends(self, device):
        """inductor where it can compile for the device."""
        yield "eager"
        yield "aot_eager"
        try:
            torch.compile(lambda x: x + 1)(torch.zeros(3, device=device))
        except Exception as error:  # of any kind: no compiler, no headers, no setuptools
            print("without inductor on {}: {}".format(device, str(error).splitlines()[0]))
        else:
            yield "inductor"

    def test_exported_programs_hold_operators(self):
        tracer = masu.Tracer(self.scenes[0])

        class Depth(torch.nn.Module):
            def forward(self, rays):
                return masu.torch.nearest(tracer, rays, fields="t_hit")["t_hit"]

        rays = random_rays(self.random, 50)
        program = torch.export.export(Depth(), (torch.as_tensor(rays),))
        same_bits(self, {"t_hit": program.module()(torch.as_tensor(rays))}, tracer.nearest(rays, fields="t_hit"))

    def test_the_documented_example_runs(self):
        blocks = documented_examples()
        [example] = [block for block in blocks if "import masu.torch" in block]
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec((blocks[0] + example).replace("fullgraph=True", "fullgraph=True, backend='aot_eager'"), {})
        self.assertEqual(printed.getvalue(), "tensor([0., -inf])\n")

    def test_a_number_of_no_tracer_is_refused(self):
        rays = torch.as_tensor(random_rays(self.random, 5))
        tracer = masu.Tracer(self.scenes[0])
        number = tracer.number
        compiled = torch.compile(lambda rays: torch.ops.masu.occluded(number, rays), fullgraph=True, backend="aot_eager")
        self.assertEqual(compiled(rays).tolist(), tracer.occluded(rays).tolist())
        tracer.close()
        self.assertRaises(ValueError, masu.torch.occluded, tracer, rays)
        self.assertRaises(ValueError, compiled, rays)
        del tracer
        gc.collect()
        for wrong in (number, 0, -1, 2**62):
            self.assertRaises(ValueError, torch.ops.masu.inside, wrong, rays)
        self.assertRaises(ValueError, compiled, rays)

    def test_wrong_arguments_are_refused(self):
        tracer = masu.Tracer(self.scenes[0])
        rays = torch.as_tensor(random_rays(self.random, 5))
        for error, call in ((ValueError, lambda: masu.torch.nearest(tracer, rays[:, :5])),
                            (ValueError, lambda: masu.torch.nearest(tracer, rays, fields="t")),
                            (ValueError, lambda: masu.torch.occluded(tracer, rays, faces="none")),
                            (TypeError, lambda: masu.torch.occluded(tracer, rays > 0)),
                            (RuntimeError, lambda: masu.torch.inside(tracer, rays, faces="front"))):
            self.assertRaises(error, call)
        t = masu.torch.nearest(tracer, rays.requires_grad_())["t_hit"]
        self.assertRaises(RuntimeError, t.sum().backward)  # no gradients


if __name__ == "__main__":
    unittest.main()
