"""OpenSees: the block as an oscillator with one degree of freedom, as earthquake engineers do it (Eq. 4): a spring that is stiff up to a moment of 1 and
has a negative stiffness from there on, Newmark's method, and where phi changes its sign the velocity is set to eta times itself and the analysis begun anew.
"""

from block import by_rotation, listed, serve  # first: what a simulator prints must not reach standard output

import math
import os

import openseespy.opensees as ops

STIFF = float(os.environ.get("STIFF", 1e-9))  # the rotation at which the spring has its full moment


def oscillator(case):
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0)
    ops.fix(1, 1)
    ops.mass(2, 1.0)
    far = 20.0
    ops.uniaxialMaterial("ElasticMultiLinear", 1, "-strain", -far, -STIFF, STIFF, far, "-stress", far - 1.0, -1.0, 1.0, 1.0 - far)
    ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
    psi = math.asin(1.0 / (1.0 + case.epsilon))
    long = 2.0 * case.end + 1.0
    ops.timeSeries("Trig", 1, 0.0, long, 2.0 * math.pi / case.omega, "-factor", 1.0 + case.epsilon, "-shift", psi)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    # At rest on the edge of the stiff part: the shaking begins at 1.
    ops.setNodeDisp(2, 1, -STIFF, "-commit")


def begin_analysis():
    """Newmark's method takes the state of the nodes where an analysis begins, and only there."""
    ops.wipeAnalysis()
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-15, 100)
    ops.algorithm("NewtonLineSearch")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def stepped(step):
    """Whether a step is done; where Newton's method goes to and fro over the kink of the spring, by another algorithm, as users of OpenSees do."""
    if ops.analyze(1, step) == 0:
        return True
    for algorithm in ("KrylovNewton", "ModifiedNewton", "NewtonLineSearch"):
        ops.algorithm(algorithm)
        parts = 1 if algorithm != "NewtonLineSearch" else 10
        if all(ops.analyze(1, step / parts) == 0 for _ in range(parts)):
            ops.algorithm("NewtonLineSearch")
            return True
    return False


def answer(case):
    def simulate(shaking):
        oscillator(case)
        begin_analysis()
        side = -1.0
        for n in range(shaking.steps):
            if not stepped(shaking.step):
                raise ArithmeticError(f"no convergence at step {n}")
            phi, velocity = ops.nodeDisp(2, 1), ops.nodeVel(2, 1)
            if side * phi < 0.0 and side * velocity < 0.0:
                side, velocity = -side, velocity * case.eta
                ops.setNodeVel(2, 1, velocity, "-commit")
                begin_analysis()
            yield (n + 1) * shaking.step, phi, velocity

    return listed(case, simulate, by_rotation, give=2.0 * STIFF)


if __name__ == "__main__":
    serve("OpenSees", ops.version(), answer, "linear")
