"""PyBullet (Bullet, doubles): a box on a plane that is shaken (see block.py), turning about one axis only."""

from block import Body, by_rate, listed, serve  # first: what a simulator prints must not reach standard output

import os
from importlib.metadata import version

import pybullet as bullet

ITERATIONS = int(os.environ.get("ITERATIONS", 200))
ERP = float(os.environ.get("ERP", 0.9))  # the share of a depth that a step takes back; 0.2 unless told otherwise


def world(case, step):
    body = Body(case)
    bullet.resetSimulation()
    bullet.setPhysicsEngineParameter(
        fixedTimeStep=step,
        numSolverIterations=ITERATIONS,
        numSubSteps=1,
        solverResidualThreshold=0.0,
        contactSlop=0.0,
        contactERP=ERP,
        restitutionVelocityThreshold=0.0,
        allowedCcdPenetration=0.0,
    )
    b, h = body.half_width, body.half_height
    plane = bullet.createMultiBody(0.0, bullet.createCollisionShape(bullet.GEOM_PLANE))
    box = bullet.createCollisionShape(bullet.GEOM_BOX, halfExtents=[b, 1.0, h])
    block = bullet.createMultiBody(1.0, box, basePosition=[0.0, 0.0, h])
    for part in (plane, block):
        bullet.changeDynamics(part, -1, lateralFriction=100.0, spinningFriction=0.0, rollingFriction=0.0, restitution=0.0)
    bullet.changeDynamics(
        block,
        -1,
        localInertiaDiagonal=[body.inertia] * 3,
        linearDamping=0.0,
        angularDamping=0.0,
        collisionMargin=0.0,
        activationState=bullet.ACTIVATION_STATE_DISABLE_SLEEPING,
    )
    return body, block


def answer(case):
    def simulate(shaking):
        body, block = world(case, shaking.step)
        for n in range(shaking.steps):
            bullet.setGravity(-body.shake * shaking((n + 0.5) * shaking.step), 0.0, -body.gravity)
            bullet.stepSimulation()
            _, turned = bullet.getBasePositionAndOrientation(block)
            _, rate = bullet.getBaseVelocity(block)
            # About y, from z to x: to the right is positive for both. Small: the quaternion's y is half the angle.
            yield (n + 1) * shaking.step, 2.0 * turned[1] / case.alpha, rate[1] / case.alpha

    return listed(case, simulate, by_rate)


if __name__ == "__main__":
    bullet.connect(bullet.DIRECT)
    serve("PyBullet", version("pybullet"), answer, "nonlinear")
