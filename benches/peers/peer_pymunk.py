"""Pymunk (Chipmunk2D, doubles): a rectangle on a floor that is shaken (see block.py)."""

from block import Body, Shaking, by_rate, by_rotation, listed, serve  # first: what a simulator prints must not reach standard output

import pymunk



def world(case):
    body = Body(case)
    space = pymunk.Space()
    space.iterations = 50
    space.collision_slop = 1e-9  # how deep contacts sink; 0 lets them flicker
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
    shaking = Shaking(case)
    body, space, block = world(case)

    def states():
        for n in range(shaking.steps):
            space.gravity = (-body.shake * shaking((n + 0.5) * shaking.step), -body.gravity)
            space.step(shaking.step)
            # Turning to the left is negative for the paper and positive for Chipmunk.
            yield (n + 1) * shaking.step, -block.angle / case.alpha, -block.angular_velocity / case.alpha

    return listed(case, shaking.step, states(), by_rate if __import__('os').environ.get('RATE') else by_rotation)


if __name__ == "__main__":
    serve("Pymunk", f"{pymunk.version} (Chipmunk {pymunk.chipmunk_version})", answer, "nonlinear")
