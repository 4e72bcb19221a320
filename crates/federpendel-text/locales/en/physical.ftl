# Physical numbers of a fit, and what was measured beside the recording. The folder de holds the same ids with the same variables.

### Rows and sentences

physical-row-moving-mass = moving mass M = m + m_s/3
physical-row-coulomb-force = force of dry friction F_c
physical-row-agreement = C/M as given
physical-row-equivalent = equivalent damping ratio at { $amplitude }
physical-more = { $percent } % greater than ω₀² ({ $deviation } standard deviations)
physical-less = { $percent } % less than ω₀² ({ $deviation } standard deviations)
physical-contradicts = Mass and stiffness do not agree with the recording: C/M is { $difference }. All else is computed from the mass.
physical-contradicts-spring = Mass and stiffness do not agree with the recording: C/M is { $difference }. Was the mass of the spring left out? All else is computed from the mass.
physical-weight = For the coefficients of friction the normal force is the weight of the body alone, on a level guide that does not carry the spring.
physical-absent-angle = The recording holds angles, to which the mass and the spring of a straight motion have no meaning: no forces and no masses are given.
physical-absent-mass = Forces and masses need the mass of the body or the stiffness of the spring.
physical-absent-normal-force = There is no coefficient of friction, since nothing is said of what presses the body on a guide; a hanging body has no such force.
physical-absent-spring-mass = A third of the mass of the spring is more than all that moves by stiffness and frequency: no mass of the body is given.
physical-absent-length = The recording measures lengths in { $unit }, but forces, coefficients of friction and drag need metres: --unit m, cm or mm says what its lengths are in.
    .page = The recording measures lengths in { $unit }; forces, coefficients of friction and drag need metres: give the unit of the values, such as m, cm or mm.
physical-absent-unit = The recording says no unit: masses, stiffness and damping hold only if it measures lengths and not angles, and forces, coefficients of friction and drag need metres: --unit m, cm or mm says what its lengths are in.
    .page = The recording names no unit: masses, stiffness and damping only hold if it measures lengths, not angles, and forces, coefficients of friction and drag need metres: give the unit of the values, such as m, cm or mm.

### What is given

physical-help-heading = Measured beside the recording, as "250(1) g" or "12.0 ± 0.3 N/m"
physical-horizontal-twice = --normal-force is { $value }, but --horizontal already makes the weight the normal force; only one of the two may be given
physical-gravity-alone = --gravity is { $value }; it is allowed only together with --horizontal
quantity-uncertainty-negative = its uncertainty is negative
quantity-uncertainty-unit = its uncertainty has no unit, though the value has one; write the unit once, at the end, or for both
quantity-uncertainty-grammar = it is no value with one uncertainty, as 250(1) g, 12.0 ± 0.3 N/m or (12.0 ± 0.3) N/m

### What a fit says beside its values

fit-window-reversed = { $begin } is { $from } and { $end } is { $to }; allowed is a { $begin } before { $end }
    .page = The fitted part would begin at { $from } and end at { $to }; allowed is an end after the beginning
plot-residual-axis = Residual
physical-bare-number = { $name } has no unit: { $value } is taken.
quantity-uncertainty-large = its uncertainty is more than half of the value, too much to be carried on into other numbers
fit-row-plus-minus = ±
fit-plus-minus = one standard error
physical-hint = --mass adds stiffness, D and forces.
    .guided = --mass adds stiffness, D and forces; --horizontal, for a body on a level guide, also μ.
    .page = With a mass under “About the experiment” stiffness, D and forces follow too, with the force on the guide also μ.
