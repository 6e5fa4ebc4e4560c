"""Queries as operators of PyTorch, 2.4 or later, which torch.compile and torch.export take into a graph:

    import masu.torch

    @torch.compile(fullgraph=True)
    def depth(rays):
        return masu.torch.nearest(tracer, rays)["t_hit"]

The functions have the arguments and results of the methods of masu.Tracer, but for `progress` and `stream`: on a GPU it is
the current one. Rays are tensors. There are no gradients: a backward pass through a result is an error.

The operators are torch.ops.masu.nearest, occluded, count_hits and inside. A tracer is a number to them, which keeps nobody
alive: where its tracer is closed or freed, or in another process, they raise a ValueError."""

from typing import Any, Dict, Iterable, List, Union

import torch

if not hasattr(torch.library, "custom_op"):
    raise ImportError("masu.torch needs PyTorch 2.4 or later, and {} is installed".format(torch.__version__))

from ._tracer import Field, Tracer, chosen, tracer_of

_OPTIONS = ["str precision='auto'", "bool relative=False", "SymInt threads=0", "Tensor? object_masks=None",
            "Tensor? ray_masks=None"]
_FILTERS = ["str faces='both'", "Tensor? exclude=None"]
_SCHEDULE = ["bool coherent=False", "str loop='auto'"]


def _define(name: str, result: str, options: List[str]) -> None:
    """result: of one number for each ray its type; or "fields"."""
    names = [option.split("=")[0].split()[-1] for option in options]

    def query(tracer: int, rays: "torch.Tensor", *given: Any) -> Any:
        found = getattr(tracer_of(tracer), name)(rays, **dict(zip(names, given)))
        return list(found.values()) if isinstance(found, dict) else found

    def fake(tracer: int, rays: "torch.Tensor", *given: Any) -> Any:
        fields = chosen(given[0]).values() if result == "fields" else [Field("", result, ())]
        empty = [rays.new_empty(rays.shape[:-1] + field.shape, dtype=getattr(torch, field.number)) for field in fields]
        return empty if result == "fields" else empty[0]

    schema = "(SymInt tracer, Tensor rays, {}) -> Tensor{}".format(", ".join(options), "[]" if result == "fields" else "")
    torch.library.custom_op("masu::" + name, query, mutates_args=(), schema=schema).register_fake(fake)


_define("nearest", "fields", ["str[] fields", *_OPTIONS, *_FILTERS, *_SCHEDULE])
_define("occluded", "bool", [*_OPTIONS, *_FILTERS, *_SCHEDULE])
_define("count_hits", "int32", [*_OPTIONS, *_FILTERS])
_define("inside", "uint8", _OPTIONS)


def nearest(tracer: Tracer, rays: "torch.Tensor", *, fields: Union[str, Iterable[str]] = ("t_hit", "primitive_ids"),
            **options: Any) -> "Dict[str, torch.Tensor]":
    """Tracer.nearest()."""
    names = [fields] if isinstance(fields, str) else list(fields)
    return dict(zip(names, torch.ops.masu.nearest(tracer.number, rays, names, **options)))


def occluded(tracer: Tracer, rays: "torch.Tensor", **options: Any) -> Any:
    """Tracer.occluded()."""
    return torch.ops.masu.occluded(tracer.number, rays, **options)


def count_hits(tracer: Tracer, rays: "torch.Tensor", **options: Any) -> Any:
    """Tracer.count_hits()."""
    return torch.ops.masu.count_hits(tracer.number, rays, **options)


def inside(tracer: Tracer, rays: "torch.Tensor", **options: Any) -> Any:
    """Tracer.inside()."""
    return torch.ops.masu.inside(tracer.number, rays, **options)
