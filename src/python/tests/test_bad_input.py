"""What is no input: a clear error, and no panic."""

from typing import Any

import numpy as np
import pytest

import chattercheck as cc

UNALIGNED = np.frombuffer(b"\0" + np.full(3, 1.02).tobytes(), dtype=np.uint8)[1:].view(np.float64)


@pytest.mark.parametrize(
    "a",
    [
        [1.02, 1.02, 1.02],
        (1.02, 1.02, 1.02),
        np.full(6, 1.02)[::2],
        np.full(3, 1.02)[::-1],
        np.full((3, 2), 1.02, order="F")[:, 0],
        np.full(3, 1.02, dtype=">f8"),
        np.array([1.02, 1.02, 1.02], dtype=object),
        np.broadcast_to(1.02, 3),
        UNALIGNED,
    ],
)
def test_every_array_of_numbers_is_read(a: Any) -> None:
    found = cc.chatter(a, 2, 0.8)
    assert list(found.tau_ch) == [cc.chatter(1.02, 2, 0.8).tau_ch] * 3


def test_read_only_and_single_precision_are_read() -> None:
    a = np.full(3, 1.02)
    a.flags.writeable = False
    assert cc.chatter(a, 2, 0.8).tau_ch.shape == (3,)
    single = np.float32(1.02)
    assert cc.chatter(np.array([single]), 2, 0.8).tau_ch[0] == cc.chatter(float(single), 2, 0.8).tau_ch


def test_nothing_gives_nothing() -> None:
    assert cc.chatter([], 2, 0.8).tau_ch.shape == (0,)
    assert cc.chatter(np.empty((0, 3)), 2, 0.8).ending.shape == (0, 3)
    assert list(cc.impacts([], 2, 0.8).offsets) == [0]
    assert cc.critical_amplitude([], 0.8).a_cr.shape == (0,)


BLOCK = cc.Block(0.6, 2.0)
PULSE = cc.GroundMotion.one_sine(0.5, 1.0)


@pytest.mark.parametrize(
    ("error", "said", "call"),
    [
        (ValueError, "a = nan is outside the allowed range: 0 <= a <= 1e9 (at index [1, 0])", lambda: cc.chatter([[1.1, 1.1], [np.nan, 1]], 2, 0.9)),
        (ValueError, "a = inf is", lambda: cc.chatter([np.inf], 2, 0.9)),
        (ValueError, "can't be broadcast together: a (2,), omega (3,), eta ()", lambda: cc.chatter([1, 2], [1, 2, 3], 0.9)),
        (ValueError, "too large", lambda: cc.chatter(10**400, 2, 0.9)),
        (ValueError, "one of a and epsilon", lambda: cc.chatter(1.1, 2, 0.9, epsilon=0.1)),
        (ValueError, "one of a and epsilon", lambda: cc.chatter(None, 2, 0.9)),
        (ValueError, "normalisation = slender", lambda: cc.chatter(1.1, 2, 0.9, normalisation="slender")),
        (ValueError, "impacts = 0 is", lambda: cc.chatter(1.1, 2, 0.9, impacts=0)),
        (ValueError, "impacts = 10 is not used by enclosure", lambda: cc.chatter(1.1, 2, 0.9, impacts=10, oracle="enclosure")),
        (ValueError, "alpha", lambda: cc.chatter(1.1, 2, 0.9, oracle="taylor")),
        (ValueError, "alpha", lambda: cc.chatter(1.1, 2, 0.9, 0.2, oracle="closed-form")),
        (ValueError, "in the shape of an array", lambda: cc.chatter([[1, 2], [3]], 2, 0.9)),
        (TypeError, "a: numbers are expected", lambda: cc.chatter("1.1", 2, 0.9)),
        (TypeError, "a: numbers are expected", lambda: cc.chatter(1.1j, 2, 0.9)),
        (TypeError, "a: numbers are expected", lambda: cc.chatter(True, 2, 0.9)),
        (TypeError, "omega: numbers are expected, not object", lambda: cc.chatter(1.1, object(), 0.9)),  # type: ignore[arg-type]
        (TypeError, "omega: numbers are expected, not NoneType", lambda: cc.chatter(1.1, None, 0.9)),  # type: ignore[arg-type]
        (TypeError, "masked", lambda: cc.chatter(np.ma.masked_equal([1.1, 2], 2), 2, 0.9)),
        (TypeError, "impacts: a whole number", lambda: cc.chatter(1.1, 2, 0.9, impacts=1.5)),  # type: ignore[arg-type]
        (TypeError, "until: one number", lambda: cc.chatter(1.1, 2, 0.9, until=[1, 2])),  # type: ignore[arg-type]
        (ValueError, "half_height is half of the height", lambda: cc.Block(1.0, half_height=2.0)),
        (ValueError, "width = -1.0 is outside the allowed range: 1e-6 to 1e6 (metres)", lambda: cc.Block(-1, 2)),
        (ValueError, "restitution", lambda: cc.Block(1, 2, restitution="elastic")),
        (ValueError, "restitution = 1.0 is", lambda: cc.Block(1, 2, restitution=1)),
        (ValueError, "needs width and height", lambda: cc.Block(1)),
        (TypeError, "width: numbers are expected", lambda: cc.Block("1", 2)),  # type: ignore[arg-type]
        (ValueError, 'units = "ft/s2" is outside the allowed range: "g"', lambda: cc.GroundMotion([1, 2], 0.1, units="ft/s2")),
        (ValueError, "units = 1 is", lambda: cc.GroundMotion([1, 2], 0.1, units=1)),  # type: ignore[arg-type]
        (ValueError, "sample = nan (at index [1]) is", lambda: cc.GroundMotion([1, np.nan], 0.1)),
        (ValueError, "samples = 1 is outside the allowed range: 2 to 10000000", lambda: cc.GroundMotion([1], 0.1)),
        (ValueError, "samples = 0 is", lambda: cc.GroundMotion([], 0.1)),
        (ValueError, "dimension", lambda: cc.GroundMotion([[1, 2], [3, 4]], 0.1)),
        (ValueError, "dt = -0.1 is", lambda: cc.GroundMotion([1, 2], -0.1)),
        (ValueError, "dt = nan is", lambda: cc.GroundMotion([1, 2], np.nan)),
        (ValueError, "one of dt", lambda: cc.GroundMotion([1, 2])),
        (ValueError, "frequency = { hz = -1.0 } is", lambda: cc.rock(BLOCK, cc.GroundMotion.one_sine(0.5, -1.0))),
        (ValueError, "one of hz", lambda: cc.GroundMotion.one_sine(0.5)),
        (ValueError, "one of center", lambda: cc.GroundMotion.ricker(0.5, 1.0)),
        (ValueError, "units", lambda: cc.GroundMotion.one_sine(0.5, 1.0, units="gal")),
        (FileNotFoundError, "nowhere.AT2", lambda: cc.GroundMotion.at2("nowhere.AT2")),
        (TypeError, "block: a chattercheck.Block", lambda: cc.rock(PULSE, BLOCK)),  # type: ignore[arg-type]
        (ValueError, "t_span", lambda: cc.rock(BLOCK, PULSE, (1.0, 2.0))),
        (ValueError, "t_span", lambda: cc.rock(BLOCK, PULSE, 5.0)),  # type: ignore[arg-type]
        (ValueError, "until = nan is", lambda: cc.rock(BLOCK, PULSE, (0, np.nan))),
        (ValueError, "steps = 0 is", lambda: cc.rock(BLOCK, PULSE, steps=0)),
        (ValueError, "rotation = 2.0 is", lambda: cc.rock(BLOCK, PULSE, rotation=2.0)),
        (ValueError, "model = cubic is", lambda: cc.rock(BLOCK, PULSE, model="cubic")),
        (ValueError, "not used by closed-form", lambda: cc.rock(BLOCK, PULSE, oracle="closed-form")),
        (ValueError, "to-scale = 0.5 is", lambda: cc.criterion(BLOCK, PULSE, to_scale=0.5)),
        (ValueError, "to = 0.1 is", lambda: cc.overturning(BLOCK, PULSE, (1.0, 0.1))),
        (ValueError, "tolerance = 2.0 is", lambda: cc.plan(BLOCK, PULSE, 2.0)),
        (ValueError, "eta = 0.99", lambda: cc.critical_amplitude(2, 0.99)),
        (TypeError, "engine: a function", lambda: cc.verify(3)),  # type: ignore[arg-type]
        (TypeError, "cases: a whole number", lambda: cc.verify(len, cases=1.5)),  # type: ignore[arg-type]
        (ValueError, "cases = -1 is", lambda: cc.verify(len, cases=-1)),  # type: ignore[arg-type]
        (ValueError, "cases = 2000000 is", lambda: cc.verify(len, cases=2_000_000)),  # type: ignore[arg-type]
        (ValueError, "can't be sent", lambda: cc.verify(_unsendable())),
        (ValueError, "class: allowed is", lambda: cc.verify(abs, known=[{"class": "nonsense", "reason": "x"}])),  # type: ignore[arg-type]
    ],
)
def test_an_error_says_what_is_wrong(error: type[Exception], said: str, call: Any) -> None:
    with pytest.raises(error) as caught:
        call()
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


def _unsendable() -> Any:
    import threading

    lock = threading.Lock()
    return lambda case: lock
