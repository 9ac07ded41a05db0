"""MuJoCo: a box on a plane, in the plane (two slides and a hinge), shaken (see block.py). Its contacts are soft; they are made as stiff as the step allows."""

from block import Body, Shaking, by_rate, by_rotation, listed, serve  # first: what a simulator prints must not reach standard output

import mujoco


WORLD = """
<mujoco>
  <option timestep="{step}" cone="elliptic" impratio="100" integrator="implicitfast" solver="Newton" iterations="100" tolerance="0"/>
  <default><geom friction="100 0 0" condim="3" solref="{solref} 1" solimp="0.999 0.9999 1e-9"/></default>
  <worldbody>
    <geom type="plane" size="50 50 1"/>
    <body pos="0 0 {h}">
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>
      <geom type="box" size="{b} 0.5 {h}"/>
    </body>
  </worldbody>
</mujoco>
"""


def answer(case):
    shaking = Shaking(case)
    body = Body(case)
    step = shaking.step
    text = WORLD.format(step=repr(step), solref=repr(2.0 * step), h=repr(body.half_height), b=repr(body.half_width), inertia=repr(body.inertia))
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)

    def states():
        for n in range(shaking.steps):
            model.opt.gravity[:] = (-body.shake * shaking((n + 0.5) * step), 0.0, -body.gravity)
            mujoco.mj_step(model, data)
            # About y, from z to x: to the right is positive for both.
            yield (n + 1) * step, data.qpos[2] / case.alpha, data.qvel[2] / case.alpha

    return listed(case, step, states(), by_rate if __import__('os').environ.get('RATE') else by_rotation)


if __name__ == "__main__":
    serve("MuJoCo", mujoco.__version__, answer, "nonlinear")
