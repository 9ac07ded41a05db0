"""Siconos: nonsmooth mechanics, wrapped as it comes with the system's packages. The block is a point above a floor (see block.py), a LagrangianLinearTIDS
under NewtonImpactNSL(eta): stepped in time by the scheme of Moreau and Jean, and followed from event to event with LSODAR.
"""

from block import Shaking, listed, serve  # first: what a simulator prints must not reach standard output

import sys

import numpy as np
import siconos
import siconos.kernel as sk



def ball(case, start, stop):
    """A point above a floor, and the force on it, which the driver sets."""
    point = sk.LagrangianLinearTIDS(np.zeros(1), np.zeros(1), np.eye(1))
    point.setFExtPtr(np.zeros(1))
    floor = sk.Interaction(sk.NewtonImpactNSL(case.eta), sk.LagrangianLinearTIR(np.eye(1)))
    model = sk.NonSmoothDynamicalSystem(start, stop)
    model.insertDynamicalSystem(point)
    model.link(floor, point)
    return model, point, floor, point.fExt()  # the last is a view


def moreau(case):
    """Moreau's time-stepping: the impacts of a step, however many, are one law between its ends."""
    shaking = Shaking(case)
    step, steps = shaking.step, shaking.steps
    model, point, floor, force = ball(case, 0.0, 2.0 * step * (steps + 2))
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(0.5), sk.LCP())

    def states():
        i = -1.0
        for n in range(steps):
            u, v = float(point.q()[0]), float(point.velocity()[0])
            # The force at the middle of the step.
            middle = u + 0.5 * step * v
            force[0] = middle - 1.0 - i * shaking((n + 0.5) * step)
            simulation.computeOneStep()
            after = float(point.velocity()[0])
            if v < 0.0 and after >= 0.0:
                i = -i
            u = max(float(point.q()[0]), 0.0)
            yield (n + 1) * step, i * max(u, 1e-300), i * after
            simulation.nextStep()

    return listed(case, step, states())


SETTINGS = {"Moreau-Jean": moreau}

if __name__ == "__main__":
    serve("Siconos", siconos.__version__, SETTINGS[sys.argv[1]], "linear")
