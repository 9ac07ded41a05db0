"""Pymunk (Chipmunk2D, doubles): a rectangle on a floor that is shaken (see block.py)."""

from block import Body, by_rate, listed, serve  # first: what a simulator prints must not reach standard output

import os

import pymunk

SLOP = float(os.environ.get("SLOP", 1e-9))  # how deep contacts sink; without any they flicker


def world(case):
    body = Body(case)
    space = pymunk.Space()
    space.iterations = 50
    space.collision_slop = SLOP
    space.collision_bias = 0.0  # how much of a depth beyond that is left after a second
    block = pymunk.Body(1.0, body.inertia)
    b, h = body.half_width, body.half_height
    shape = pymunk.Poly(block, [(-b, -h), (b, -h), (b, h), (-b, h)])
    floor = pymunk.Segment(space.static_body, (-50.0, -1.0), (50.0, -1.0), 1.0)
    for part in (shape, floor):
        part.friction, part.elasticity = 100.0, 0.0
    block.position = (0.0, h)
    space.add(block, shape, floor)
    return body, space, block


def answer(case):
    def simulate(shaking):
        body, space, block = world(case)
        for n in range(shaking.steps):
            space.gravity = (-body.shake * shaking((n + 0.5) * shaking.step), -body.gravity)
            space.step(shaking.step)
            # Turning to the left is negative for the paper and positive for Chipmunk.
            yield (n + 1) * shaking.step, -block.angle / case.alpha, -block.angular_velocity / case.alpha

    return listed(case, simulate, by_rate)


if __name__ == "__main__":
    serve("Pymunk", pymunk.version, answer, "nonlinear")
