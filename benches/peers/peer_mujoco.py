"""MuJoCo: a box on a plane, in the plane (two slides and a hinge), shaken (see block.py). Its contacts are soft; they are made as stiff as the step allows."""

from block import Body, by_rate, listed, serve  # first: what a simulator prints must not reach standard output

import os

import mujoco

SOFT = float(os.environ.get("SOFT", 2))  # the time in which a contact gives way, in steps; MuJoCo takes no less than 2

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
    body = Body(case)

    def simulate(shaking):
        step = shaking.step
        measures = {"step": step, "solref": SOFT * step, "h": body.half_height, "b": body.half_width, "inertia": body.inertia}
        model = mujoco.MjModel.from_xml_string(WORLD.format(**{name: repr(value) for name, value in measures.items()}))
        data = mujoco.MjData(model)
        for n in range(shaking.steps):
            model.opt.gravity[:] = (-body.shake * shaking((n + 0.5) * step), 0.0, -body.gravity)
            mujoco.mj_step(model, data)
            # About y, from z to x: to the right is positive for both.
            yield (n + 1) * step, data.qpos[2] / case.alpha, data.qvel[2] / case.alpha

    return listed(case, simulate, by_rate)


if __name__ == "__main__":
    serve("MuJoCo", mujoco.__version__, answer, "nonlinear")
