"""Siconos: nonsmooth mechanics, as it comes with the system's packages. The block is a point above a floor (see block.py), a LagrangianLinearTIDS under
NewtonImpactNSL(eta): stepped in time by the scheme of Moreau and Jean, or followed from event to event by LSODAR.
"""

from block import by_rotation, listed, serve  # first: what a simulator prints must not reach standard output

import math
import os
import sys
from importlib.metadata import version

import numpy as np
import siconos.kernel as sk

import protocol
from closing import closed

IMPACT = 2  # the type of an event
THETA = float(os.environ.get("THETA", 0.5))  # of Moreau's scheme
RTOL = os.environ.get("RTOL")  # of LSODAR, if not Siconos's own


def moreau(case):
    """Moreau's time-stepping: the impacts of a step, however many, are one law between its ends."""

    def simulate(shaking):
        step, steps = shaking.step, shaking.steps
        point = sk.LagrangianLinearTIDS(np.zeros(1), np.zeros(1), np.eye(1))
        point.setFExtPtr(np.zeros(1))
        force = point.fExt()  # a view
        floor = sk.Interaction(sk.NewtonImpactNSL(case.eta), sk.LagrangianLinearTIR(np.eye(1)))
        model = sk.NonSmoothDynamicalSystem(0.0, step * (steps + 2))
        model.insertDynamicalSystem(point)
        model.link(floor, point)
        simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(THETA), sk.LCP())
        i = -1.0
        for n in range(steps):
            u, v = float(point.q()[0]), float(point.velocity()[0])
            force[0] = u + 0.5 * step * v - 1.0 - i * shaking((n + 0.5) * step)  # at the middle of the step
            simulation.computeOneStep()
            after = float(point.velocity()[0])
            if v < 0.0 <= after:
                i = -i
            yield (n + 1) * step, i * max(float(point.q()[0]), 1e-300), i * after
            simulation.nextStep()

    return listed(case, simulate, by_rotation, give=0.0)


def events(case):
    """From event to event. The shaking is a second coordinate, s'' = -omega^2 s, that pulls the first: u'' = u - 1 - i s.

    It begins a little after the start, with the power series of the first flight: at the start the gap has a triple root.
    """
    omega, r = case.omega, math.sqrt(case.epsilon * (2.0 + case.epsilon))
    start = 0.01 * 4.0 * r / omega / (1.0 + r)
    shaking = (math.cos(omega * start) + r * math.sin(omega * start), omega * (r * math.cos(omega * start) - math.sin(omega * start)))
    # The third to the sixth derivative of u at the start.
    derivatives = (r * omega, -(omega**2), r * omega * (1.0 - omega**2), omega**2 * (omega**2 - 1.0))
    gap, rate = (sum(d * start ** (k - n) / math.factorial(k - n) for k, d in enumerate(derivatives, 3)) for n in (0, 1))
    system = sk.LagrangianLinearTIDS(np.array([gap, shaking[0]]), np.array([rate, shaking[1]]), np.eye(2))
    system.setKPtr(np.array([[-1.0, -1.0], [0.0, omega * omega]]))
    system.setFExtPtr(np.array([-1.0, 0.0]))
    stiffness = system.K()  # a view
    floor = sk.Interaction(sk.NewtonImpactNSL(case.eta), sk.LagrangianLinearTIR(np.array([[1.0, 0.0]])))
    model = sk.NonSmoothDynamicalSystem(start, case.end)
    model.insertDynamicalSystem(system)
    model.link(floor, system)
    simulation = sk.EventDriven(model, sk.TimeDiscretisation(start, (case.end - start) / 200.0))
    integrator = sk.LsodarOSI()
    if RTOL:
        integrator.setTol(1, float(RTOL), 1e-3 * float(RTOL))
    simulation.insertIntegrator(integrator)
    simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_IMPACT)
    simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_SMOOTH_ACC)
    simulation.initialize()
    i, times, velocities = -1.0, [], []
    try:
        while simulation.hasNextEvent():
            simulation.advanceToEvent()
            event = simulation.eventsManager().nextEvent()
            is_impact, time = event.getType() == IMPACT, event.getDoubleTimeOfEvent()
            simulation.processEvents()
            if is_impact:
                i = -i
                stiffness[0, 1] = i
                times.append(time)
                velocities.append(i * float(system.velocity()[0]))
                if len(times) == case.impacts:
                    return protocol.History(times, velocities, "limit-reached")
    except Exception as error:  # it stops here: what came before is its answer
        return protocol.History(times, velocities, "lost", notes={"why": f"loud: {error}"})
    return protocol.History(times, velocities, case.still_rocking)


SETTINGS = {"Moreau-Jean": moreau, "event-driven, LSODAR": events}

if __name__ == "__main__":
    serve("Siconos", version("siconos"), SETTINGS[sys.argv[1]], "linear", closed)
