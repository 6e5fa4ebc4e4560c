"""CUDA streams of other libraries."""

import operator
from typing import Any


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
