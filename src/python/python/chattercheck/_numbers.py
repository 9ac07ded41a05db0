"""Numbers as users give them."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

EPSILON = 2.0**-52


def refused(field: str, value: object, allowed: str) -> ValueError:
    """The error of a value, in the words of the command."""
    return ValueError(f"{field} = {value} is outside the allowed range: {allowed}")


def floats(name: str, value: ArrayLike) -> Floats:
    """An array of doubles; the same one if it is one."""
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise TypeError(f"{name}: a number is expected for every element, and some are masked")
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise ValueError(f"{name}: numbers in the shape of an array are expected: {error}") from None
    if array.dtype.kind == "O":
        try:
            array = np.array([float(one) for one in array.ravel()], dtype=np.float64).reshape(array.shape)
        except OverflowError:
            raise ValueError(f"{name}: a whole number is too large for a double") from None
        except (TypeError, ValueError):
            raise TypeError(f"{name}: numbers are expected, not {_kind(array)}") from None
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name}: numbers are expected, not {array.dtype}")
    # In the order of bytes and the alignment that Rust reads.
    return np.require(array, np.float64, ["A"])


def _kind(array: NDArray[Any]) -> str:
    first = array.ravel()[0] if array.size else None
    return type(first).__name__


def number(name: str, value: Any) -> float:
    """One number."""
    if type(value) is float:
        return value
    array = floats(name, value)
    if array.ndim != 0:
        raise TypeError(f"{name}: one number is expected, not an array of shape {array.shape}")
    return float(array)


def whole(name: str, value: Any) -> int:
    """One whole number."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name}: a whole number is expected, not {value!r}")
    return int(value)


def together(names: Sequence[str], values: Sequence[ArrayLike]) -> list[Floats]:
    """Arrays of one shape, without copies."""
    arrays = [floats(name, value) for name, value in zip(names, values)]
    try:
        return list(np.broadcast_arrays(*arrays))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(names, arrays))
        raise ValueError(f"the shapes can't be broadcast together: {shapes}") from None


def outward(value: float, direction: float) -> float:
    """A bound after one rounding, further to this side."""
    return math.nextafter(value, direction)


def seconds(tau: Any, p: float) -> Any:
    """Times in seconds."""
    return tau / p


def seconds_off(uncertainty: Any, tau: Any, p: float) -> Any:
    """How far off times in seconds may be: what was known of them, and the rounding of the division."""
    return (uncertainty / p + EPSILON * np.abs(tau) / p) * (1 + 4 * EPSILON)
