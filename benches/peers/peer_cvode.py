"""SUNDIALS CVODE: the library inside the wheel of scikit-sundae called from C, and through the wheel's own Python interface."""

from rocking import AT_START, SILENT, WRONG_SIGN, serve, told

import ctypes
import glob
import math
import os
import subprocess
import tempfile

import numpy as np
import sksundae
from sksundae.cvode import CVODE

METHODS = {"Adams": 1, "BDF": 2}
CLOCKS = {"one clock": 0, "careful start": 1, "rescaled flights": 2}
ENDS = {
    0: "",
    1: SILENT,
    2: "loud: the solver failed",
    3: WRONG_SIGN,
    4: AT_START,
}


def library():
    """The C program, compiled and bound to the libraries in the wheel."""
    folder = os.path.join(os.path.dirname(os.path.dirname(sksundae.__file__)), "scikit_sundae.libs")
    for name in ("core", "cvode"):
        ctypes.CDLL(glob.glob(f"{folder}/libsundials_{name}-*")[0], mode=ctypes.RTLD_GLOBAL)
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "peer_cvode.c")
    with tempfile.TemporaryDirectory() as place:
        built = os.path.join(place, "peer_cvode.so")
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-o", built, source, "-lm"], check=True)
        return ctypes.CDLL(built)


FOLLOW = library().follow
FOLLOW.argtypes = [ctypes.c_int] * 2 + [ctypes.c_double] * 6 + [ctypes.c_int] + [ctypes.c_void_p] * 5


def from_c(clock, method, rtol, atol):
    def run(case):
        columns = [np.empty(case.impacts) for _ in range(3)]
        count, evaluations = ctypes.c_int(), ctypes.c_long()
        places = (*(column.ctypes.data for column in columns), ctypes.addressof(count), ctypes.addressof(evaluations))
        asked = (case.epsilon, case.omega, case.eta, case.end, case.impacts)
        ended = FOLLOW(CLOCKS[clock], METHODS[method], rtol, atol, *asked, *places)
        times, velocities, intervals = (column[: count.value] for column in columns)
        return told(case, times, velocities, ENDS[ended], intervals, evaluations.value)

    return run


def from_python(rtol, atol):
    """One clock, with the equation and the event in Python, as the wheel means it; a solver that is used again finds its first root again."""

    def run(case):
        omega, eta, end = case.omega, case.eta, case.end
        a = 1.0 + case.epsilon
        psi, tau, velocity = math.asin(1.0 / a), 0.0, 0.0
        flight = {"i": -1.0}
        times, velocities, rhs = [], [], 0

        def equation(t, y, dy):
            dy[0] = y[1]
            dy[1] = y[0] - flight["i"] - a * math.sin(omega * t + psi)

        def event(t, y, events):
            events[0] = y[0]

        event.terminal = [True]
        options = {"method": "Adams", "rtol": rtol, "atol": atol, "eventsfn": event, "num_events": 1, "max_num_steps": 20000}
        while len(times) < case.impacts:
            solver = CVODE(equation, **options)
            found = solver.solve(np.array([tau, end]), np.array([0.0, velocity]))
            rhs += found.nfev
            if not found.success or found.t_events is None:
                ended = ENDS[1] if found.success else f"loud: {found.message}"
                return told(case, times, velocities, ended, rhs=rhs)
            landed, velocity = float(found.t_events[0]), eta * float(found.y_events[0][1])
            if landed <= tau:
                return told(case, times, velocities, AT_START, rhs=rhs)
            times.append(landed)
            velocities.append(velocity)
            tau, flight["i"] = landed, -flight["i"]
        return told(case, times, velocities, rhs=rhs)

    return run


SETTINGS = {
    "C, one clock, Adams, rtol 1e-12, atol 1e-15": from_c("one clock", "Adams", 1e-12, 1e-15),
    "C, careful start, Adams, rtol 1e-12": from_c("careful start", "Adams", 1e-12, 1e-12),
    "C, careful start, BDF, rtol 1e-12": from_c("careful start", "BDF", 1e-12, 1e-12),
    **{
        f"C, rescaled flights, {method}, rtol {rtol:g}": from_c("rescaled flights", method, rtol, rtol)
        for method, rtol in (("Adams", 1e-6), ("Adams", 1e-9), ("Adams", 1e-12), ("BDF", 1e-9))
    },
    "Python, one clock, Adams, rtol 1e-12, atol 1e-15": from_python(1e-12, 1e-15),
}

if __name__ == "__main__":
    serve("SUNDIALS CVODE", f"{sksundae.SUNDIALS_VERSION} (scikit-sundae {sksundae.__version__})", SETTINGS)
