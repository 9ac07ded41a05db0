"""Blocks and motions of the ground, in physical units."""

from __future__ import annotations

import json
import os
import re
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _native
from ._numbers import Floats, floats, number, refused, whole

_AMPLITUDES = {
    "g": "g",
    "m/s2": "m-per-s2",
    "threshold": "over-threshold",
    "slender-threshold": "over-slender-threshold",
}


def toml(value: Any) -> str:
    """A value in TOML, on one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        # As in JSON but for what JSON leaves as it is.
        return json.dumps(value).replace("\x7f", "\\u007f")
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(name)} = {toml(of)}" for name, of in value.items()) + " }"
    return repr(value)


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else toml(name)


def _table(name: str, fields: dict[str, Any]) -> str:
    lines = [f"{field} = {toml(value)}" for field, value in fields.items() if value is not None]
    return "\n".join([f"[{name}]", *lines, ""])


class Block:
    """A rectangular rigid block.

    Parameters
    ----------
    width, height
        Of the whole block, in metres; or ``half_width`` and ``half_height``, half of them; or ``radius`` and ``slenderness``, half of the diagonal in metres and
        ``alpha = atan(width/height)`` in radians.
    restitution
        The coefficient of restitution ``eta``, between 0 and 1 (Eq. 13), or ``"housner"``: ``1 - 3/2 sin(alpha)^2``.
    gravity
        In m/s2.

    Raises ValueError with the line of the command for what is missing, given twice or out of range.
    """

    def __init__(
        self,
        width: float | None = None,
        height: float | None = None,
        *,
        half_width: float | None = None,
        half_height: float | None = None,
        radius: float | None = None,
        slenderness: float | None = None,
        restitution: float | str = "housner",
        gravity: float = 9.81,
    ) -> None:
        lengths = {
            "width": width,
            "height": height,
            "half_width": half_width,
            "half_height": half_height,
            "radius": radius,
            "slenderness": slenderness,
        }
        fields: dict[str, Any] = {name: number(name, of) for name, of in lengths.items() if of is not None}
        fields["restitution"] = restitution if isinstance(restitution, str) else number("restitution", restitution)
        fields["gravity"] = number("gravity", gravity)
        self._toml = _table("block", fields)
        self._given = fields
        scene = _native.Scene(self._toml + _STILL)
        #: The slenderness angle ``alpha``, in radians.
        self.alpha: float = scene.alpha
        #: Half of the diagonal, in metres.
        self.radius: float = scene.radius
        #: ``eta``.
        self.restitution: float = scene.restitution
        #: m/s2.
        self.gravity: float = scene.gravity
        #: ``p = sqrt(3 g/(4 R))``, 1/s: ``tau = p t``.
        self.frequency_parameter: float = scene.frequency_parameter
        #: The acceleration of the ground at which it begins to rock, in g.
        self.threshold: float = scene.threshold

    def __repr__(self) -> str:
        return f"Block({', '.join(f'{name}={value!r}' for name, value in self._given.items())})"


_STILL = '[ground]\namplitude = { g = 0.0 }\nfrequency = { omega = 1.0 }\n'


class GroundMotion:
    """A motion of the ground: samples of its acceleration, linear in between, nothing before the first and after the last.

    Parameters
    ----------
    acc
        The acceleration at ``k dt``; shape (n,), 2 <= n <= 10,000,000, finite.
    dt
        The time between samples, in seconds.
    units
        Of the samples: ``"g"``, ``"m/s2"``, ``"cm/s2"`` or ``"threshold"``, multiples of that at which the block begins to rock.
    scale
        What the samples are multiplied with.
    dt_tau
        The time between samples in ``1/p`` of the block, in place of ``dt``.

    Nothing is corrected, filtered or resampled. Other motions: :meth:`at2`, :meth:`read`, :meth:`sine`, :meth:`one_sine`, :meth:`one_cosine`, :meth:`ricker`,
    :meth:`mavroeidis_papageorgiou`, :meth:`sinusoids`.
    """

    def __init__(
        self,
        acc: ArrayLike,
        dt: float | None = None,
        units: str = "g",
        *,
        scale: float = 1.0,
        dt_tau: float | None = None,
    ) -> None:
        samples = np.ascontiguousarray(floats("acc", acc))
        if samples.ndim != 1:
            raise ValueError(f"acc: an array of one dimension is expected, not of shape {samples.shape}")
        if (dt is None) == (dt_tau is None):
            raise ValueError("one of dt, in seconds, and dt_tau is expected")
        if units not in ("g", "m/s2", "cm/s2", "threshold"):
            raise refused("units", _quoted(units), '"g", "m/s2", "cm/s2" or "threshold"')
        if not np.all(np.isfinite(samples)):
            at = int(np.flatnonzero(~np.isfinite(samples))[0])
            raise refused("sample", f"{samples[at]} (at index [{at}])", "finite, up to 1e6 thresholds")
        if not 2 <= len(samples) <= 10_000_000:
            raise refused("samples", len(samples), "2 to 10000000")
        step = number("dt", dt if dt is not None else dt_tau)
        if not 0 < step <= 1e9:
            raise refused("dt", step, "above 0, up to 1e9")
        #: What happens to the ground, in words.
        self.name = "a record"
        #: What a reader of its file should know.
        self.notes: tuple[str, ...] = ()
        #: The format of its file.
        self.format: str | None = None
        self._ground = _STILL
        self._samples: _native.Samples | None = {
            "acc": samples,
            "units": units,
            "scale": number("scale", scale),
            "dt": step if dt is not None else None,
            "dt_tau": step if dt is None else None,
        }

    @property
    def acc(self) -> Floats:
        """The samples, as they were given; only of a record."""
        if self._samples is None:
            raise AttributeError(f"{self.name} has no samples")
        return self._samples["acc"]

    @property
    def dt(self) -> float:
        """The time between samples, in seconds; only of a record."""
        step = None if self._samples is None else self._samples["dt"]
        if step is None:
            raise AttributeError(f"{self.name} has no time between samples in seconds")
        return step

    @property
    def units(self) -> str:
        """The units of the samples; only of a record."""
        if self._samples is None:
            raise AttributeError(f"{self.name} has no samples")
        return self._samples["units"]

    @classmethod
    def read(
        cls,
        path: str | os.PathLike[str],
        *,
        units: str | None = None,
        dt: float | None = None,
        column: int | None = None,
        scale: float = 1.0,
    ) -> "GroundMotion":
        """A record from its file: PEER AT2, SMC, COSMOS V1 and V2, CSMIP V2, K-NET, or numbers in rows or columns.

        ``units``, ``dt`` (seconds) and ``column`` (the first is 1) are given where the file does not say them; where it does and they differ, that is an error.
        Raises ValueError with the line of the file and what is wrong there.
        """
        found = _native.read_record(
            os.fspath(path),
            units,
            None if dt is None else number("dt", dt),
            None if column is None else whole("column", column),
        )
        motion = cls(found["acc"], found["dt"], found["units"], scale=scale)
        motion.notes, motion.format = tuple(found["notes"]), found["format"]
        return motion

    @classmethod
    def at2(cls, path: str | os.PathLike[str], *, scale: float = 1.0) -> "GroundMotion":
        """A record from a file of PEER, in any of the dialects of AT2. Raises ValueError for a file of another format."""
        motion = cls.read(path, scale=scale)
        if motion.format != "PEER AT2":
            raise ValueError(f"{os.fspath(path)}: the format is {motion.format}; expected is PEER AT2, and GroundMotion.read for others")
        return motion

    @classmethod
    def _of(cls, name: str, fields: dict[str, Any]) -> "GroundMotion":
        motion = cls.__new__(cls)
        motion.name, motion.notes, motion.format, motion._samples = name, (), None, None
        motion._ground = _table("ground", fields)
        return motion

    @classmethod
    def _pulse(cls, pulse: str, sine: tuple[Any, str, Any, Any], **fields: Any) -> "GroundMotion":
        return cls._of(pulse, {"pulse": pulse, **_sine(*sine), **fields})

    @classmethod
    def one_sine(
        cls, amplitude: float, hz: float | None = None, *, omega: float | None = None, units: str = "g"
    ) -> "GroundMotion":
        """One period of a sine.

        ``amplitude`` is the peak in ``units``: ``"g"``, ``"m/s2"``, ``"threshold"`` (of g tan(alpha)) or ``"slender-threshold"`` (of g alpha). The frequency is
        ``hz``, in cycles a second, or ``omega``, over the frequency parameter of the block.
        """
        return cls._pulse("one-sine", (amplitude, units, hz, omega))

    @classmethod
    def one_cosine(
        cls, amplitude: float, hz: float | None = None, *, omega: float | None = None, units: str = "g"
    ) -> "GroundMotion":
        """One period of a cosine; as :meth:`one_sine`."""
        return cls._pulse("one-cosine", (amplitude, units, hz, omega))

    @classmethod
    def ricker(
        cls,
        amplitude: float,
        hz: float | None = None,
        center: float | None = None,
        *,
        omega: float | None = None,
        center_tau: float | None = None,
        antisymmetric: bool = False,
        units: str = "g",
    ) -> "GroundMotion":
        """A wavelet of Ricker over twice ``center``, the time of its middle in seconds (or ``center_tau`` in ``1/p``); the rest as :meth:`one_sine`."""
        pulse = "ricker-antisymmetric" if antisymmetric else "ricker"
        return cls._pulse(pulse, (amplitude, units, hz, omega), center=_time("center", center, center_tau))

    @classmethod
    def mavroeidis_papageorgiou(
        cls,
        amplitude: float,
        hz: float | None = None,
        gamma: float = 1.0,
        phase: float = 0.0,
        *,
        omega: float | None = None,
        units: str = "g",
    ) -> "GroundMotion":
        """The pulse of Mavroeidis and Papageorgiou (2003), of ``gamma`` cycles and with ``phase`` nu in radians; the rest as :meth:`one_sine`."""
        of = {"gamma": number("gamma", gamma), "phase": number("phase", phase)}
        return cls._pulse("mavroeidis-papageorgiou", (amplitude, units, hz, omega), **of)

    @classmethod
    def sine(
        cls,
        amplitude: float,
        hz: float | None = None,
        *,
        omega: float | None = None,
        phase: float | None = None,
        duration: float | None = None,
        cycles: float | None = None,
        units: str = "g",
    ) -> "GroundMotion":
        """A sinusoid, ``A sin(2 pi f t + phase)`` with ``phase`` in radians; unless given it starts at the threshold, so that the block begins to rock at once.

        It ends after ``duration`` seconds or so many ``cycles``, or does not end. The rest as :meth:`one_sine`.
        """
        if duration is not None and cycles is not None:
            raise ValueError("one of duration and cycles is expected, not both")
        fields = _sine(amplitude, units, hz, omega)
        if phase is not None:
            fields["phase"] = number("phase", phase)
        if duration is not None:
            fields["duration"] = {"seconds": number("duration", duration)}
        if cycles is not None:
            fields["duration"] = {"cycles": number("cycles", cycles)}
        return cls._of("a sinusoid", fields)

    @classmethod
    def sinusoids(
        cls,
        amplitudes: ArrayLike,
        hz: ArrayLike | None = None,
        phases: ArrayLike = 0.0,
        *,
        omega: ArrayLike | None = None,
        duration: float | None = None,
        duration_tau: float | None = None,
        units: str = "g",
    ) -> "GroundMotion":
        """A sum of sinusoids, over ``duration`` seconds (or ``duration_tau``): arrays of shape (n,), or numbers, that broadcast. The rest as :meth:`one_sine`."""
        frequencies = hz if omega is None else omega
        if frequencies is None or (hz is not None and omega is not None):
            raise ValueError("one of hz and omega is expected")
        of = floats("amplitudes", amplitudes), floats("omega" if hz is None else "hz", frequencies)
        try:
            rows = np.broadcast_arrays(*of, floats("phases", phases))
        except ValueError:
            raise ValueError("the shapes of amplitudes, frequencies and phases can't be broadcast together") from None
        terms = [
            {**_sine(size, units, None if hz is None else f, f if hz is None else None), "phase": float(phase)}
            for size, f, phase in zip(*(np.atleast_1d(row).tolist() for row in rows))
        ]
        lasts = None if duration is None and duration_tau is None else _time("duration", duration, duration_tau)
        return cls._of("a sum of sinusoids", {"sinusoids": terms, "duration": lasts})

    def __repr__(self) -> str:
        if self._samples is None:
            return f"GroundMotion({self.name})"
        return f"GroundMotion({len(self.acc)} samples in {self.units})"


def _quoted(text: object) -> str:
    return json.dumps(text) if isinstance(text, str) else repr(text)


def _sine(amplitude: Any, units: str, hz: Any, omega: Any) -> dict[str, Any]:
    way = _AMPLITUDES.get(units) if isinstance(units, str) else None
    if way is None:
        raise refused("units", _quoted(units), '"g", "m/s2", "threshold" or "slender-threshold"')
    if (hz is None) == (omega is None):
        raise ValueError("one of hz, in cycles a second, and omega, over p, is expected")
    frequency = {"hz": number("hz", hz)} if hz is not None else {"omega": number("omega", omega)}
    return {"amplitude": {way: number("amplitude", amplitude)}, "frequency": frequency}


def _time(name: str, in_seconds: Any, in_tau: Any) -> dict[str, float]:
    if (in_seconds is None) == (in_tau is None):
        raise ValueError(f"one of {name}, in seconds, and {name}_tau is expected")
    return {"seconds": number(name, in_seconds)} if in_seconds is not None else {"tau": number(name + "_tau", in_tau)}


def scene(
    block: Block, motion: GroundMotion, model: str = "nonlinear", rotation: float = 0.0, velocity: float = 0.0
) -> _native.Scene:
    """What the part in Rust takes."""
    if not isinstance(block, Block):
        raise TypeError(f"block: a chattercheck.Block is expected, not {type(block).__name__}")
    if not isinstance(motion, GroundMotion):
        raise TypeError(f"motion: a chattercheck.GroundMotion is expected, not {type(motion).__name__}")
    start = {"rotation": number("rotation", rotation), "velocity": number("velocity", velocity)}
    if model not in ("linear", "nonlinear"):
        raise refused("model", model, "linear or nonlinear")
    parts = [block._toml, motion._ground, _table("ask", {"model": model}), _table("start", start)]
    return _native.Scene("\n".join(parts), motion._samples)
