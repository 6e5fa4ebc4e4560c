"""libmasu.so by ctypes: the functions of masu.h, their errors as exceptions, and the objects they make."""

import atexit
import contextlib
import copy
import ctypes
import enum
import functools
import operator
import os
import pathlib
import queue
import re
import sys
import types
import weakref
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p
from typing import Any, Callable, Dict, Generator, Iterator, List, Optional, Tuple, Type, TypeVar, Union

from ._records import (CPU, BuildOptionsRecord, GeometryRecord, GoOn, GridDescriptionRecord, HitsRecord, MeshCheckRecord,
                       PrimitiveRecord, QueryRecord, SceneDescriptionRecord, TracerOptionsRecord, TransformsRecord,
                       ValuesRecord, VerticesRecord, sized)

Owned = TypeVar("Owned", bound="Resource")

__version__ = "0.1.0"  # of the interface: the library's must be of the same minor version

Path = Union[str, bytes, "os.PathLike[Any]"]


class Status(enum.IntEnum):
    """What kind of error it was."""
    USAGE = 1  # an argument
    INPUT = 2  # a file that can't be read or is invalid
    OUTPUT = 3  # a file that can't be written
    DEVICE = 4  # the GPU or its driver
    MEMORY = 5  # there isn't enough memory in the host
    INTERRUPTED = 6


class Error(Exception):
    """What the library refuses: a line `place: what is wrong: what to do`, and `status`, what kind of error it is."""

    def __init__(self, status: Status, message: str) -> None:
        super().__init__(status, message)
        self.status = status

    def __str__(self) -> str:
        return str(self.args[1])


# --- The library --------------------------------------------------------------------------------------------------

def _has_avx2() -> bool:
    """Whether the processor has what a wheel's library in x86-64-v3 was compiled for (MASU_AVX2)."""
    try:
        with open("/proc/cpuinfo", encoding="ascii", errors="replace") as lines:
            flags = next((line for line in lines if line.startswith("flags")), "").split()
    except OSError:
        return False
    return {"avx2", "fma", "bmi1", "bmi2", "abm", "popcnt"}.issubset(flags)


def _candidates() -> List[str]:
    name = "libmasu.so." + __version__.split(".")[0]
    package = pathlib.Path(__file__).resolve().parent
    folders = [package, package.parent]
    if (package / "x86-64-v3").exists() and _has_avx2():
        folders.insert(0, package / "x86-64-v3")
    if package.parent.name == "dist-packages":  # PREFIX/lib/python3/dist-packages, as cmake --install has it
        folders.append(package.parents[2])
    return [str(folder / name) for folder in folders if (folder / name).exists()] + [name]


def _load() -> ctypes.CDLL:
    chosen = os.environ.get("MASU_LIBRARY")
    failures = []
    for path in [chosen] if chosen else _candidates():
        try:
            loaded = ctypes.CDLL(path)
            break
        except OSError as error:
            failures.append(str(error))
    else:
        raise ImportError("libmasu.so can't be loaded: {}: install it, or name its file in the environment variable "
                          "MASU_LIBRARY".format("; ".join(failures)))

    def declare(name: str, result: Any, *arguments: Any) -> None:
        try:
            function = getattr(loaded, name)
        except AttributeError:
            raise ImportError("{}: this isn't Masu's library: it has no {}".format(path, name)) from None
        function.restype = result
        function.argtypes = arguments

    declare("masu_version", c_char_p)
    version = loaded.masu_version().decode()
    if version.split(".")[:2] != __version__.split(".")[:2]:  # its structures may be others
        raise ImportError("{}: version {} of the library, {} of the module: install the same".format(
            path, version, __version__))
    declare("masu_error", c_char_p)
    declare("masu_gpu_count", c_int, POINTER(c_int))
    handle = POINTER(c_void_p)
    declare("masu_scene_create", c_int, POINTER(GeometryRecord), handle)
    declare("masu_scene_read", c_int, c_char_p, handle)
    declare("masu_scene_write", c_int, c_void_p, c_char_p)
    declare("masu_scene_free", None, c_void_p)
    declare("masu_scene_describe", c_int, c_void_p, POINTER(SceneDescriptionRecord))
    declare("masu_scene_primitive", c_int, c_void_p, c_uint32, POINTER(PrimitiveRecord))
    declare("masu_scene_check", c_int, c_void_p, POINTER(MeshCheckRecord))
    declare("masu_default_build_options", c_int, POINTER(BuildOptionsRecord))
    declare("masu_grid_build", c_int, c_void_p, POINTER(BuildOptionsRecord), handle)
    declare("masu_grid_refit", c_int, c_void_p, c_void_p, handle)
    declare("masu_grid_read", c_int, c_char_p, handle)
    declare("masu_grid_write", c_int, c_void_p, c_char_p)
    declare("masu_grid_free", None, c_void_p)
    declare("masu_grid_describe", c_int, c_void_p, POINTER(GridDescriptionRecord))
    declare("masu_tracer_create", c_int, c_void_p, c_void_p, POINTER(TracerOptionsRecord), handle)
    declare("masu_tracer_grid", c_int, c_void_p, handle)
    declare("masu_tracer_update", c_int, c_void_p, POINTER(VerticesRecord))
    declare("masu_tracer_place", c_int, c_void_p, POINTER(TransformsRecord))
    declare("masu_tracer_free", None, c_void_p)
    declare("masu_nearest", c_int, c_void_p, c_void_p, c_size_t, POINTER(QueryRecord), POINTER(HitsRecord))
    declare("masu_occluded", c_int, c_void_p, c_void_p, c_size_t, POINTER(QueryRecord), c_void_p)
    query = (c_void_p, c_void_p, c_size_t, POINTER(QueryRecord))
    declare("masu_all_hits", c_int, *query, c_uint32, POINTER(HitsRecord), c_void_p)
    declare("masu_count_hits", c_int, *query, c_void_p)
    declare("masu_inside", c_int, *query, c_void_p)
    declare("masu_closest", c_int, *query, POINTER(HitsRecord), c_void_p)
    declare("masu_winding", c_int, *query, c_double, c_void_p, c_void_p)
    declare("masu_interpolate", c_int, POINTER(ValuesRecord), c_void_p, c_void_p, c_size_t, c_void_p)
    return loaded


library = _load()


def check(status: int) -> None:
    """Raises what the thread's last call said, if it failed."""
    if status:
        raise Error(Status(status), (library.masu_error() or b"").decode(errors="replace"))


def gpu_count() -> int:
    """How many GPUs can be used: 0 where the library was built without CUDA, or there is none."""
    count = c_int()
    check(library.masu_gpu_count(byref(count)))
    return count.value


@contextlib.contextmanager
def memory_file(contents: bytes = b"") -> Iterator[Tuple[int, str]]:
    """A file in memory: its descriptor, and its path in this process."""
    with open(os.memfd_create("masu"), "w+b") as file:
        file.write(contents)
        file.flush()
        yield file.fileno(), "/proc/self/fd/{}".format(file.fileno())


# --- Calls --------------------------------------------------------------------------------------------------------

Progress = Optional[Callable[[float], Any]]  # gets the share of the work that is done


def _listener(progress: Progress, raised: List[BaseException]) -> Generator[bool, float, None]:
    """Whether a call goes on, for each share of its work that is done. Python calls handlers of signals where it resumes:
    what they raise, as KeyboardInterrupt, ends the call."""
    try:
        while True:
            done = yield True
            if progress is not None:
                progress(done)
    except GeneratorExit:
        pass
    except BaseException as error:
        raised.append(error)
        yield False


# A function of C, for in one of Python's handlers would be called before it comes to its `try`.
_go_on = GoOn(types.GeneratorType.send)


def call(function: Callable[..., int], *arguments: Any, options: Any = None, progress: Progress = None) -> None:
    """Calls a function of the library, and raises what it says if it fails. Of resources it gets the handles. options: the
    record among the arguments that has go_on: handlers of signals and progress are called meanwhile, and end the call by
    what they raise."""
    raised: List[BaseException] = []
    listener = _listener(progress, raised)
    if options is not None:
        next(listener)
        options.go_on, options.user = _go_on, id(listener)
    status = function(*[each._opened() if isinstance(each, Resource) else each for each in arguments])
    if raised:
        del listener  # it refers to what it caught
        raise raised.pop()
    check(status)


def told(function: Callable[..., int], *arguments: Any, record: ctypes.Structure) -> Dict[str, Any]:
    """What the function says in a record: numbers by name, and tuples for its arrays."""
    call(function, *arguments, byref(sized(record)))
    values = {name: getattr(record, name) for name, *_ in record._fields_ if name not in ("size", "reserved")}
    return {name: tuple(value) if isinstance(value, ctypes.Array) else value for name, value in values.items()}


# --- Objects ------------------------------------------------------------------------------------------------------

class Free(weakref.ref["Held"]):
    """Frees an object of the library when its Held goes. Nothing of it is a function of Python's, for what a handler of a
    signal raises in one that runs as an object goes, as KeyboardInterrupt, would be lost."""

    _as_parameter_ = 0  # a callback gets this reference: one argument more to the function of C, which doesn't look at it


_frees: "dict[weakref.ref[Held], Free]" = {}
atexit.register(_frees.clear)  # other threads may still use what is held; the process's end frees everything


class Held:
    """An object of the library, freed when nobody refers to this one."""

    is_moved = False  # a tracer's: by update()

    def __init__(self, free: Callable[[c_void_p], None]) -> None:
        self.pointer = c_void_p()  # to be set; else nothing is freed
        _frees[weakref.ref(self, _frees.pop)] = Free(self, functools.partial(free, self.pointer))


class Handle(c_void_p):
    """A resource refers to its handle until it is closed, and a call that uses it for as long as it runs, for ctypes refers
    to its arguments. So calls aren't counted, and none can be left over where a handler of a signal raises."""

    held: Held


class Resource:
    """Holds an object of the library until it is closed, or nobody refers to it; also a context manager. Threads may use
    it at the same time. Copies hold the same object, and are closed each for itself."""

    _handle: Optional[Handle] = None  # None once it is closed

    _name: str  # in the functions' names

    def _own(self, create: Callable[..., int], *arguments: Any, options: Any = None, progress: Progress = None) -> None:
        held = Held(getattr(library, "masu_{}_free".format(self._name)))
        call(create, *arguments, byref(held.pointer), options=options, progress=progress)
        self._hold(held)

    @classmethod
    def _of(cls: Type[Owned], create: Callable[..., int], *arguments: Any, **options: Any) -> Owned:
        made = cls.__new__(cls)
        made._own(create, *arguments, **options)
        return made

    def _hold(self, held: Held) -> None:
        handle = Handle(held.pointer.value)
        handle.held = held
        self._handle = handle

    def __copy__(self: Owned) -> Owned:
        copied = type(self).__new__(type(self))
        copied.__dict__.update(self.__dict__)
        copied._hold(self._opened().held)
        return copied

    def __deepcopy__(self: Owned, memo: Any) -> Owned:
        return copy.copy(self)  # nothing changes what they hold

    def close(self) -> None:
        """Waits for calls that run, and gives memory back. Using it afterwards is a ValueError. Within a call that uses it,
        as in the handler of a signal, it is a RuntimeError."""
        if self._is_used_by_this_thread():
            raise RuntimeError("the {} can't be closed from within a call that uses it: close it afterwards".format(self._name))
        handle, self._handle = self._handle, None
        if handle is None:
            return
        unused: "queue.SimpleQueue[Any]" = queue.SimpleQueue()
        last = weakref.ref(handle, unused.put)
        del handle
        unused.get()
        del last

    def _is_used_by_this_thread(self) -> bool:
        frame: Optional[types.FrameType] = sys._getframe()
        while frame is not None:
            if frame.f_code is call.__code__ and any(each is self for each in frame.f_locals["arguments"]):
                return True
            frame = frame.f_back
        return False

    def __enter__(self: Owned) -> Owned:
        return self

    def __exit__(self, *error: Any) -> None:
        self.close()

    def _opened(self) -> Handle:
        return self._handle or self._closed()  # no variable: the traceback of what a handler raises would refer to it

    def _closed(self) -> Handle:
        raise ValueError("the {} is closed".format(self._name))


class Written(Resource):
    """One that can be written to a file, and is pickled as its bytes."""

    @classmethod
    def _read(cls: Type[Owned], path: Path) -> Owned:
        return cls._of(getattr(library, "masu_{}_read".format(cls._name)), path_bytes(path))

    def write(self, path: Path) -> None:
        """Writes a file of it, whole or not at all."""
        call(getattr(library, "masu_{}_write".format(self._name)), self, path_bytes(path))

    def __reduce__(self) -> Any:
        with memory_file() as (_, path):
            self.write(path)
            return _read, (type(self), pathlib.Path(path).read_bytes())


def _read(kind: Any, contents: bytes) -> Any:
    with memory_file(contents) as (_, path):
        return kind._read(path)


# --- Arguments ----------------------------------------------------------------------------------------------------

def path_bytes(path: Path) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:  # C would read the name up to there
        raise ValueError("a file's name can't hold a null character")
    return encoded


def choice(name: str, value: str, choices: "dict[str, int]") -> int:
    if not isinstance(value, str):
        raise TypeError("{}: a string is needed, not {}".format(name, type(value).__name__))
    if value not in choices:
        raise ValueError("{}: {!r} isn't one of {}".format(name, value, ", ".join(choices)))
    return choices[value]


def device_number(device: Union[str, int, Any]) -> int:
    """CPU, or a GPU's number."""
    if not isinstance(device, (str, bool)):
        try:
            number = operator.index(device)
        except TypeError:
            device = str(device)  # torch.device
        else:
            if not 0 <= number < 2**31:
                raise ValueError("device: {} isn't a GPU's number".format(number))
            return number
    if device == "cpu":
        return CPU
    match = re.fullmatch("cuda(?::([0-9]{1,9}))?", device) if isinstance(device, str) else None
    if not match:
        raise ValueError("device: {!r} isn't \"cpu\", \"cuda\", \"cuda:N\" or a GPU's number".format(device))
    return int(match[1] or 0)
