# What stands in the drawings of the report.

### Drawings

sketch-guide = { $law ->
   *[none] Mass on a horizontal guide, without friction
    [stokes] Mass on a horizontal guide, in a viscous fluid
    [coulomb] Mass on a horizontal guide, with dry friction
    [newton] Mass on a horizontal guide, in a fluid with turbulent drag
}
    .description = A spring joins a mass to a wall on its left. The mass is displaced to the { $side ->
       *[left] left of the position in which the spring is relaxed, and moves to the right
        [right] right of the position in which the spring is relaxed, and moves to the left
    }; the spring force points the same way as the velocity. Weight and normal force cancel each other. { $law ->
       *[none] There is no friction.
        [stokes] The friction force acts on the body, against the velocity.
        [coulomb] The friction force acts where mass and guide touch, against the velocity.
        [newton] The friction force acts on the body, against the velocity.
    }
sketch-loss = The energy that dry friction takes in half a period
    .description = Above, the mass at the start, with the spring stretched by x0; below, half a period later, with the spring compressed by the shorter length x1. Beside each, the energy of the spring; between them, the way of length x0 + x1 and the work of friction along it.
sketch-stream = Body in a stream of fluid
    .description = Fluid streams from the left around a round body and tears off in eddies behind it. The friction force points downstream. It depends on the density of the fluid, on the frontal area and on the drag coefficient.
    .density = density $ρ$
    .area = area $A$
    .coefficient = drag coefficient $c_w$
