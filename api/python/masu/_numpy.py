"""NumPy's arrays: see _arrays."""

import contextlib
from typing import Any, ContextManager, Tuple

import numpy as np


def adopted(array: Any, stream: Any) -> "np.ndarray[Any, Any]":
    if not hasattr(array, "__array__") and hasattr(array, "__dlpack__"):
        return np.from_dlpack(array)
    if not hasattr(array, "__array__") and hasattr(array, "numpy"):  # Open3D's tensors
        array = array.numpy()
    return np.asarray(array)


def gpu(array: "np.ndarray[Any, Any]", name: str) -> None:
    return None


def packed(array: "np.ndarray[Any, Any]", name: str) -> "np.ndarray[Any, Any]":
    if array.dtype in (np.float32, np.float64) and array.flags.c_contiguous and array.flags.aligned:
        return array
    if array.dtype.kind not in "fiu":
        raise TypeError("{}: real numbers are needed, not {}".format(name, array.dtype))
    number = np.float32 if array.dtype.newbyteorder("=") == np.float32 else np.float64
    return np.require(array, number, ["C_CONTIGUOUS", "ALIGNED"])


def packed_int32(array: "np.ndarray[Any, Any]", name: str) -> "np.ndarray[Any, Any]":
    if array.size and array.dtype.kind not in "biu":
        raise TypeError("{}: whole numbers are needed, not {}".format(name, array.dtype))
    if array.size and not -2**31 <= int(array.min()) <= int(array.max()) < 2**32:
        raise ValueError("{}: numbers from {} to {} aren't of 32 bits".format(name, array.min(), array.max()))
    return np.ascontiguousarray(array, np.int32)


def pointer(array: "np.ndarray[Any, Any]") -> int:
    return int(array.ctypes.data)


def to_host(array: "np.ndarray[Any, Any]") -> "np.ndarray[Any, Any]":
    return array


def empty(shape: Tuple[int, ...], number: str, array: "np.ndarray[Any, Any]") -> "np.ndarray[Any, Any]":
    return np.empty(shape, number)


def queue(array: "np.ndarray[Any, Any]", stream: Any) -> ContextManager[None]:
    return contextlib.nullcontext()
