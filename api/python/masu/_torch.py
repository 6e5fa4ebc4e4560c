"""PyTorch's tensors, in host memory or on a GPU: see _arrays."""

import contextlib
from typing import Any, Iterator, Optional, Tuple

import torch

from ._arrays import handle_of


def adopted(array: Any, stream: Any) -> "torch.Tensor":
    if not hasattr(array, "__dlpack__"):
        with torch.cuda.stream(_chosen(stream, torch.device("cuda", torch.cuda.current_device()))):
            return torch.as_tensor(array, device="cuda")
    with torch.cuda.stream(_chosen(stream, torch.device("cuda", int(array.__dlpack_device__()[1])))):
        return torch.from_dlpack(array)


def _chosen(stream: Any, device: "torch.device") -> "torch.cuda.Stream":
    if stream is None:
        return torch.cuda.current_stream(device)
    if isinstance(stream, torch.cuda.Stream):
        return stream
    handle = handle_of(stream)
    return torch.cuda.ExternalStream(handle, device=device) if handle else torch.cuda.default_stream(device)


def gpu(array: "torch.Tensor", name: str) -> Optional[int]:
    if array.layout != torch.strided or array.device.type not in ("cpu", "cuda"):
        raise TypeError("{}: a dense tensor on the CPU or a CUDA GPU is needed, not one of {} on {}".format(
            name, array.layout, array.device))
    return array.get_device() if array.is_cuda else None


def packed(array: "torch.Tensor", name: str) -> "torch.Tensor":
    if array.is_complex() or array.is_quantized or array.dtype == torch.bool:
        raise TypeError("{}: real numbers are needed, not {}".format(name, array.dtype))
    array = array.detach().resolve_neg()
    if array.dtype not in (torch.float32, torch.float64):
        array = array.to(torch.float64)
    array = array.contiguous()
    return array.clone() if array.data_ptr() % array.element_size() else array


def packed_int32(array: "torch.Tensor", name: str) -> "torch.Tensor":
    if array.is_floating_point() or array.is_complex() or array.is_quantized:
        raise TypeError("{}: whole numbers are needed, not {}".format(name, array.dtype))
    return array.detach().to(torch.int32).contiguous()


def pointer(array: "torch.Tensor") -> int:
    return int(array.data_ptr())


def to_host(array: "torch.Tensor") -> Any:
    return array.detach().cpu().numpy()


def empty(shape: Tuple[int, ...], number: str, array: "torch.Tensor") -> "torch.Tensor":
    return torch.empty(shape, dtype=getattr(torch, number), device=array.device)


@contextlib.contextmanager
def queue(array: "torch.Tensor", stream: Any) -> Iterator[Optional[int]]:
    if not array.is_cuda:
        yield None
        return
    chosen = _chosen(stream, array.device)
    # Memory that the allocator hands out in this context is used again only in the stream's order, so copies may be
    # given back before the queued query has read them. The caller's tensor may be of another stream.
    with torch.cuda.stream(chosen):
        array.detach().record_stream(chosen)
        yield chosen.cuda_stream
