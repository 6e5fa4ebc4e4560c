"""Whose arrays rays are. _numpy, _torch and _cupy each have the same functions for one library's arrays; name is the
argument's, for errors:

    adopted(array, stream)  another library's array as one of this library; queued on the stream
    gpu(array, name)      the number of the GPU that it lies on; None in host memory
    packed(array, name)   the same numbers as float32 or float64, contiguous and aligned: itself or a copy
    packed_int32(array, name)  the same whole numbers as int32, contiguous; of uint32 the same bits
    pointer(array)        of a packed array
    to_host(array)        NumPy's, of the same numbers
    empty(shape, type, array)  a new array where that one is; type: "float32", "float64", "int32", "uint8", "bool"
    queue(array, stream)  a context in which all of that is queued on the stream, or the current one if that is None; it
                          yields the stream's handle
"""

import importlib
import operator
import sys
from typing import Any, Tuple

_DLPACK_CPU, _DLPACK_CUDA, _DLPACK_CUDA_HOST, _DLPACK_CUDA_MANAGED = 1, 2, 3, 13


def recognize(name: str, array: Any, stream: Any) -> Tuple[Any, Any]:
    """The module for an array's library, and the array, which is that library's then. Other libraries' arrays on a GPU
    become tensors of PyTorch or arrays of CuPy where they lie; everything else becomes NumPy's."""
    torch = sys.modules.get("torch")  # whoever has their arrays has imported them
    if torch is not None and isinstance(array, torch.Tensor):
        return importlib.import_module("._torch", __package__), array
    cupy = sys.modules.get("cupy")
    if cupy is not None and isinstance(array, cupy.ndarray):
        return importlib.import_module("._cupy", __package__), array
    numpy = sys.modules.get("numpy")
    is_numpy = numpy is not None and type(array) is numpy.ndarray
    if not is_numpy and _lies_on_gpu(name, array):
        return _adopted(name, array, stream)
    try:
        from . import _numpy
    except ImportError as error:
        raise TypeError("{}: {} needs NumPy: {}".format(name, type(array).__name__, error)) from error
    try:
        return _numpy, array if is_numpy else _numpy.adopted(array, stream)
    except ValueError as error:  # rows of different lengths
        raise ValueError("{}: no array of numbers: {}".format(name, error)) from None


def beside(first: Any, name: str, array: Any, stream: Any) -> Any:
    """An array as one of the library of a recognized one; None if it isn't, or doesn't lie where that does."""
    arrays, _ = recognize(name, first, stream)
    others, array = recognize(name, array, stream)
    return array if others is arrays and arrays.gpu(array, name) == arrays.gpu(first, name) else None


def on_host(name: str, array: Any) -> Any:
    """The same numbers in host memory; those on a GPU are copied once what its library queued is done."""
    module, array = recognize(name, array, None)
    return module.to_host(array)


def real_numbers(name: str, array: Any) -> Any:
    """The same as an array of NumPy's. A TypeError for what isn't real numbers."""
    array = on_host(name, array)
    if array.size and array.dtype.kind not in "fiu":
        raise TypeError("{}: real numbers are needed, not {}".format(name, array.dtype))
    return array


def float32(array: Any) -> Any:
    """The same numbers, rounded, as an array of the same library in the same memory."""
    arrays, array = recognize("results", array, None)
    rounded = arrays.empty(tuple(array.shape), "float32", array)
    rounded[...] = array
    return rounded


def is_float64(packed: Any) -> bool:
    return str(packed.dtype).endswith("float64")


def handle_of(stream: Any) -> int:
    """The cudaStream_t as a number: of a stream of PyTorch, CuPy or CUDA Python, or that number itself."""
    if hasattr(stream, "__cuda_stream__"):
        return int(stream.__cuda_stream__()[1])
    for name in ("cuda_stream", "ptr"):
        if hasattr(stream, name):
            return int(getattr(stream, name))
    try:
        handle = operator.index(stream)
    except TypeError:
        raise TypeError("stream: a CUDA stream is needed, not {}".format(type(stream).__name__)) from None
    if not 0 <= handle < 2**64:
        raise ValueError("stream: {} isn't a stream's handle".format(handle))
    return handle


def check_shape(name: str, array: Any, is_right: bool, needed: Any) -> None:
    """Of any library's array, or of an object with a shape."""
    if not is_right:
        raise ValueError("{}: the shape {} is needed, not {}".format(name, needed, tuple(array.shape)))


def _lies_on_gpu(name: str, array: Any) -> bool:
    if hasattr(array, "__dlpack_device__"):
        kind = int(array.__dlpack_device__()[0])
        if kind in (_DLPACK_CUDA, _DLPACK_CUDA_MANAGED):
            return True
        if kind not in (_DLPACK_CPU, _DLPACK_CUDA_HOST):
            raise TypeError("{}: {} lies neither in host memory nor on a CUDA GPU".format(name, type(array).__name__))
        return False
    return hasattr(array, "__cuda_array_interface__")


def _adopted(name: str, array: Any, stream: Any) -> Tuple[Any, Any]:
    # The library that the program uses already comes first.
    for library in sorted(("torch", "cupy"), key=lambda library: library not in sys.modules):
        try:
            module = importlib.import_module("._" + library, __package__)
        except ImportError:
            continue
        return module, module.adopted(array, stream)
    raise TypeError("{}: {} on a GPU needs PyTorch or CuPy to be read: install one".format(name, type(array).__name__))
