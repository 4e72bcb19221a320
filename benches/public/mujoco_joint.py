"""MuJoCo: a slide joint with stiffness, damping and friction loss, everything else by default.

A setting is the time step in s, and “hard” behind it for dry friction as hard as MuJoCo allows."""

import time

import mujoco

MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint type="slide" axis="1 0 0" stiffness="{stiffness!r}" damping="{damping!r}" frictionloss="{loss!r}" {friction}/>
      <geom type="sphere" size="0.01" mass="{mass!r}"/>
    </body>
  </worldbody>
</mujoco>
"""


# By default dry friction is a soft constraint, with a time constant of 20 ms and an impedance of 0.9 to
# 0.95: this is the shortest one for a step, and the largest one.
HARD = 'solreffriction="{constant!r} 1" solimpfriction="0.9999 0.9999 0.001 0.5 2"'


def solve(problem, setting, limit):
    """Steps to the end; a row at each step."""
    step, _, hard = setting.partition(" ")
    if problem.newton:
        return [], 0, "does not apply: a joint has no quadratic friction"
    text = MODEL.format(
        step=step,
        stiffness=problem.stiffness,
        damping=problem.damping,
        loss=problem.kinetic_force,
        mass=problem.mass,
        friction=HARD.format(constant=2 * float(step)) if hard else "",
    )
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    begun = time.perf_counter()
    data.qpos[0], data.qvel[0] = problem.position, problem.velocity
    rows = [(0.0, problem.position, problem.velocity)]
    count = 0
    while data.time < problem.duration:
        mujoco.mj_step(model, data)
        count += 1
        # The sum of many steps is not their product.
        rows.append((count * float(step), float(data.qpos[0]), float(data.qvel[0])))
        if count % 1000 == 0 and time.perf_counter() - begun > limit:
            return rows, count, f"gave up after {limit:g} s, at {data.time:.9g} s"
    return rows, count, ""
