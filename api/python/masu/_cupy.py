"""CuPy's arrays: see _arrays."""

import contextlib
from typing import Any, Iterator, Tuple

import cupy

from ._arrays import handle_of


def adopted(array: Any, stream: Any) -> "cupy.ndarray":
    if not hasattr(array, "__dlpack__"):
        with _chosen(stream, cupy.cuda.Device().id):
            return cupy.asarray(array)
    number = int(array.__dlpack_device__()[1])
    with cupy.cuda.Device(number), _chosen(stream, number):
        return cupy.from_dlpack(array)


def _chosen(stream: Any, device: int) -> Any:
    if stream is None:
        return cupy.cuda.get_current_stream()
    if isinstance(stream, (cupy.cuda.Stream, cupy.cuda.ExternalStream)):
        return stream
    handle = handle_of(stream)
    return cupy.cuda.ExternalStream(handle, device) if handle else cupy.cuda.Stream.null


def gpu(array: "cupy.ndarray", name: str) -> int:
    return int(array.device.id)


def packed(array: "cupy.ndarray", name: str) -> "cupy.ndarray":
    if array.dtype.kind not in "fiu":
        raise TypeError("{}: real numbers are needed, not {}".format(name, array.dtype))
    array = cupy.ascontiguousarray(array, array.dtype if array.dtype in (cupy.float32, cupy.float64) else cupy.float64)
    return array.copy() if array.data.ptr % array.itemsize else array


def packed_int32(array: "cupy.ndarray", name: str) -> "cupy.ndarray":
    if array.dtype.kind not in "biu":
        raise TypeError("{}: whole numbers are needed, not {}".format(name, array.dtype))
    return cupy.ascontiguousarray(array, cupy.int32)


def pointer(array: "cupy.ndarray") -> int:
    return int(array.data.ptr)


def to_host(array: "cupy.ndarray") -> Any:
    with array.device:
        return cupy.asnumpy(array)


def empty(shape: Tuple[int, ...], number: str, array: "cupy.ndarray") -> "cupy.ndarray":
    return cupy.empty(shape, number)


@contextlib.contextmanager
def queue(array: "cupy.ndarray", stream: Any) -> Iterator[int]:
    # CuPy's pool uses memory again only in the order of the stream that was current, so copies may be given back
    # before the queued query has read them.
    with array.device:
        with _chosen(stream, array.device.id) as chosen:
            yield int(chosen.ptr)
