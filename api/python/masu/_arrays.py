"""Whose arrays rays are. _numpy, _torch and _cupy each have the same functions for one library's arrays:

    adopted(array, stream)  another library's array as one of this library; queued on the stream
    gpu(array)            the number of the GPU that it lies on; None in host memory
    packed(array, name)   the same numbers as float32 or float64, contiguous and aligned: itself or a copy; name: the
                          argument, for errors
    packed_int32(array)   the same numbers as int32, contiguous
    is_float64(array)     of a packed array
    pointer(array)        of a packed array
    to_host(array)        NumPy's, of the same numbers
    empty(shape, type, array)  a new array where that one is; type: "float32", "float64", "int32", "uint8", "bool"
    queue(array, stream)  a context in which all of that is queued on the stream, or the current one if that is None; it
                          yields the stream's handle
"""

import importlib
import sys
from typing import Any, Tuple

_DLPACK_CPU, _DLPACK_CUDA, _DLPACK_CUDA_HOST, _DLPACK_CUDA_MANAGED = 1, 2, 3, 13


def recognize(array: Any, stream: Any) -> Tuple[Any, Any]:
    """The module for an array's library, and the array, which is that library's then. Other libraries' arrays on a GPU
    become tensors of PyTorch or arrays of CuPy where they lie; everything else becomes NumPy's."""
    torch = sys.modules.get("torch")  # whoever has their arrays has imported them
    if torch is not None and isinstance(array, torch.Tensor):
        return importlib.import_module("._torch", __package__), array
    cupy = sys.modules.get("cupy")
    if cupy is not None and isinstance(array, cupy.ndarray):
        return importlib.import_module("._cupy", __package__), array
    if _lies_on_gpu(array):
        return _adopted(array, stream)
    try:
        numpy = importlib.import_module("._numpy", __package__)
    except ImportError as error:
        raise TypeError("{} needs NumPy: {}".format(type(array).__name__, error)) from error
    return numpy, numpy.adopted(array, stream)


def on_host(array: Any) -> Any:
    """The same numbers in host memory; those on a GPU are copied once what its library queued is done."""
    module, array = recognize(array, None)
    return module.to_host(array)


def _lies_on_gpu(array: Any) -> bool:
    if hasattr(array, "__dlpack_device__"):
        kind = int(array.__dlpack_device__()[0])
        if kind in (_DLPACK_CUDA, _DLPACK_CUDA_MANAGED):
            return True
        if kind not in (_DLPACK_CPU, _DLPACK_CUDA_HOST):
            raise TypeError("{}: neither in host memory nor on a CUDA GPU".format(type(array).__name__))
        return False
    return hasattr(array, "__cuda_array_interface__")


def _adopted(array: Any, stream: Any) -> Tuple[Any, Any]:
    # The library that the program uses already comes first.
    for name in sorted(("torch", "cupy"), key=lambda name: name not in sys.modules):
        try:
            module = importlib.import_module("._" + name, __package__)
        except ImportError:
            continue
        return module, module.adopted(array, stream)
    raise TypeError("{} on a GPU needs PyTorch or CuPy to be read: install one".format(type(array).__name__))
