"""Arrays of numpy that code makes for certain: images that a bridge or OpenCV gives, and arrays of many elements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from archlint.syntax import facts

_NONE: Mapping[str, Sequence[facts.Expr | None]] = MappingProxyType({})

_OF_BRIDGES = frozenset({"imgmsg_to_cv2", "compressed_imgmsg_to_cv2"})
"""Methods of ``cv_bridge.CvBridge``, by names that nobody else has."""
_OF_CV2 = frozenset(
    {"cvtColor", "resize", "flip", "rotate", "GaussianBlur", "medianBlur", "Canny", "undistort", "inRange"}
)
_COPIES = frozenset({"array", "asarray", "copy"})
_FILLED = frozenset({"zeros", "ones", "empty", "full"})
_NUMPY = ("np", "numpy")
_OPENCV = ("cv2", "cv")
_DEPTH = 3
ATTRIBUTES = frozenset(
    {"T", "all", "any", "argmax", "argmin", "argpartition", "argsort", "astype", "base"}
    | {"byteswap", "choose", "clip", "compress", "conj", "conjugate", "copy", "ctypes", "cumprod"}
    | {"cumsum", "data", "device", "diagonal", "dot", "dtype", "dump", "dumps", "fill"}
    | {"flags", "flat", "flatten", "getfield", "imag", "item", "itemset", "itemsize", "mT"}
    | {"max", "mean", "min", "nbytes", "ndim", "newbyteorder", "nonzero", "partition", "prod"}
    | {"ptp", "put", "ravel", "real", "repeat", "reshape", "resize", "round", "searchsorted"}
    | {"setfield", "setflags", "shape", "size", "sort", "squeeze", "std", "strides", "sum"}
    | {"swapaxes", "take", "to_device", "tobytes", "tofile", "tolist", "tostring", "trace", "transpose"}
    | {"var", "view"}
)
"""What an array has in any release of numpy, but for names that begin with two underscores."""


def is_array(
    value: facts.Expr | None, variables: Mapping[str, Sequence[facts.Expr | None]] = _NONE, depth: int = _DEPTH
) -> bool:
    """Whether an expression makes an array of more than one element, whatever it is made of; ``variables`` has all that
    is assigned to those that it names."""
    if isinstance(value, facts.Name) and depth and variables.get(value.id):
        return all(is_array(each, _NONE, depth - 1) for each in variables[value.id])
    if not isinstance(value, facts.Call) or not depth:
        return False
    owner, _, name = value.func.dotted.rpartition(".")
    if (name or value.func.last_name) in _OF_BRIDGES:
        return True
    if owner in _OPENCV:
        return name in _OF_CV2
    if owner not in _NUMPY or not value.args or value.args[0].star or value.args[0].keyword is not None:
        return False
    first = value.args[0].value
    if name in _COPIES:
        return is_array(first, variables, depth - 1) or _has_many(first) or first.last_name == "ranges"
    if name == "linspace":
        return _has_many_steps(value.args)
    return name in _FILLED and _is_of_many(first)


def _has_many(value: facts.Expr) -> bool:
    """``[0.0, 0.0]``"""
    return isinstance(value, facts.Sequence) and len(value.elements) > 1


def _has_many_steps(given: Sequence[facts.Argument]) -> bool:
    """``np.linspace(low, high)``, which makes 50 steps, and one that is told how many: nobody wants a single one."""
    third = [each.value for each in given if each.keyword == "num"] or [each.value for each in given[2:3]]
    plain = not any(each.star for each in given)
    return plain and (not third or not isinstance(third[0], facts.Literal) or third[0].value not in (0, 1))


def _is_of_many(shape: facts.Expr) -> bool:
    """``3``, or ``(480, 640)``."""
    match shape:
        case facts.Literal(value=int() as number):
            return number > 1
        case facts.Sequence(elements=elements):
            sizes = [item.value if isinstance(item, facts.Literal) else None for item in elements]
            return any(isinstance(size, int) and size > 1 for size in sizes)
    return False


__all__ = ["ATTRIBUTES", "is_array"]
