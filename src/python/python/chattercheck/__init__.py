"""The chattering of rocking blocks: chattering times, whole responses, and a gate for simulators of your own.

A block that rocks under weak ground shaking hits its base infinitely often in finite time and comes to rest. Times are ``tau = p t`` where it is not said that they are
in seconds, rotations ``phi = theta/alpha``; equation numbers are those of Giouvanidis, Dimitrakopoulos and Lourenco, *Chattering: an overlooked peculiarity of
rocking motion*.

>>> import chattercheck
>>> chattercheck.chatter(1.03, 2, 0.92).ending
'at-rest'
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._cases import Chattering as Chattering
    from ._cases import CriticalAmplitude as CriticalAmplitude
    from ._cases import Impacts as Impacts
    from ._cases import chatter as chatter
    from ._cases import critical_amplitude as critical_amplitude
    from ._cases import impacts as impacts
    from ._certainty import Changes as Changes
    from ._certainty import Criterion as Criterion
    from ._certainty import Overturning as Overturning
    from ._certainty import Plan as Plan
    from ._certainty import criterion as criterion
    from ._certainty import overturning as overturning
    from ._certainty import plan as plan
    from ._gate import Case as Case
    from ._gate import Decline as Decline
    from ._gate import EngineError as EngineError
    from ._gate import Finding as Finding
    from ._gate import Report as Report
    from ._gate import verify as verify
    from ._native import __version__ as __version__
    from ._response import Bout as Bout
    from ._response import Response as Response
    from ._response import rock as rock
    from ._scene import Block as Block
    from ._scene import GroundMotion as GroundMotion

# Where each name is. They are loaded when they are first used: NumPy alone takes longer than an import should.
_HOMES = {
    "_cases": ("Chattering", "CriticalAmplitude", "Impacts", "chatter", "critical_amplitude", "impacts"),
    "_certainty": ("Changes", "Criterion", "Overturning", "Plan", "criterion", "overturning", "plan"),
    "_gate": ("Case", "Decline", "EngineError", "Finding", "Report", "verify"),
    "_native": ("__version__",),
    "_response": ("Bout", "Response", "rock"),
    "_scene": ("Block", "GroundMotion"),
}
_HOME = {name: home for home, names in _HOMES.items() for name in names}

__all__ = sorted(_HOME)


def __getattr__(name: str) -> Any:
    home = _HOME.get(name)
    if home is None:
        raise AttributeError(f"module 'chattercheck' has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module("." + home, __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
