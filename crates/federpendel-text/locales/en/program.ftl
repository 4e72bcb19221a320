# What the program says. The folder de holds the same ids with the same variables.

### Terms of the field

term-turning-point = turning point

### Quotes around what was typed

quoted = “{ $text }”

### Counts

count-swings = { $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
}

### Parameters: what each is called, and one line that says what it is

parameter-mass = mass
    .description = Mass of the body
parameter-stiffness = stiffness
    .description = Stiffness of the spring: force per length
parameter-gravity = gravity
    .description = Acceleration of gravity, which presses the mass on its guide
parameter-normal-force = normal force
    .description = Force that presses the mass on its guide, given instead of gravity
parameter-damping = damping
    .description = Damping of Stokes (viscous) friction: force per velocity
parameter-kinetic = kinetic coefficient
    .description = Kinetic coefficient of Coulomb (dry) friction
parameter-static = static coefficient
    .description = Static coefficient of Coulomb (dry) friction, at least the kinetic one
parameter-density = density
    .description = Density of the medium in which Newton friction acts
parameter-drag-coefficient = drag coefficient
    .description = Drag coefficient of the body for Newton friction
parameter-area = area
    .description = Frontal area of the body for Newton friction
parameter-newton-coefficient = Newton coefficient
    .description = Coefficient of Newton (quadratic) friction: force per velocity squared
parameter-position = position
    .description = Position of release, from where the spring is relaxed; hanging: from where it hangs at rest
parameter-velocity = velocity
    .description = Velocity of release
parameter-duration = duration
    .description = Length of the record
parameter-samples = samples
    .description = Number of samples of the record, both ends included
parameter-dt = time step
    .description = Time step of a numeric scheme
parameter-tolerance = tolerance
    .description = Error that a method which chooses its steps may make in one, over the amplitude
parameter-width = width of smooth friction
    .description = Velocity over which smooth friction stands in for the jump of dry friction
parameter-time = time
    .description = Time at which the motion is asked for

### Measured values

measured-interval = { $low } to { $high }

### Quantities made of the parameters

derived-angular-frequency = angular frequency without friction
summary-period = period
summary-period-small = period at small amplitude
derived-frequency = frequency
derived-damping-rate = damping rate
derived-offset = offset of Coulomb friction
derived-sticking-offset = half width of the sticking band
derived-newton-rate = rate of Newton friction
derived-acceleration = acceleration
derived-amplitude = amplitude
derived-energy = energy

### What is allowed

range-positive = a finite number greater than 0
range-non-negative = a finite number, 0 or greater
range-finite = a finite number
range-fraction = a number greater than 0 and less than 1
range-count-from-two = a whole number, 2 or greater

### Errors of the core

error-parameter = { $name } is { $value }; allowed is { $allowed }
error-static-below-kinetic = { $name } is { $static }; allowed is at least kinetic, { $kinetic }
error-no-normal-force = { $name } is { $value }; Coulomb friction needs a normal force greater than 0
error-magnitude = { $name } is { $value }; allowed are magnitudes from { $smallest } to { $largest }
error-derived = { $fields }: from the values given follows { $quantity } = { $value }; allowed are magnitudes from { $smallest } to { $largest }
error-drag-too-strong = Newton friction is too strong: rate κ times amplitude is { $value }; allowed is at most { $limit }
error-too-many-swings = { $name } is { $time }; this motion can be followed up to { $reached } ({ $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
})
error-length = { $name } has { $found ->
    [one] { $found } element
   *[other] { $found } elements
}; { $expected } are needed
error-order = { $name } holds { $value } after { $before }; allowed is an order that does not fall
error-no-such-solution = The article’s solution { $solution } does not hold here; the oscillator is { $regime }
solution-overdamped = for overdamped motion
solution-critical = for critical damping
error-no-phase = Position and velocity are 0; a phase (equation 77 of the article) needs one that is not
error-diverged = { $name } is { $step }; with it the scheme diverges at { $time }, a smaller step may hold
error-too-many-steps = { $name } is { $step }; up to { $time } that makes { $steps } steps, at most { $limit } are taken
error-not-in-article = The article solves motion without friction, with Stokes or with Coulomb friction; not with { $mix }

### Which laws of friction act

mix-none = without friction
mix-stokes = Stokes friction
mix-coulomb = Coulomb friction
mix-newton = Newton friction
mix-stokes-coulomb = Stokes and Coulomb friction
mix-stokes-newton = Stokes and Newton friction
mix-coulomb-newton = Coulomb and Newton friction
mix-all = Stokes, Coulomb and Newton friction

### How strongly Stokes friction damps

regime-undamped = undamped
regime-underdamped = underdamped
regime-critical = critically damped
regime-overdamped = overdamped
regime-sentence-underdamped = It is underdamped: damping ratio { $ratio }.
regime-sentence-critical = It is critically damped.
regime-sentence-overdamped = It is overdamped: damping ratio { $ratio }.

### How a motion is known

kind-closed-form = exact, in closed form
kind-first-integral = exact turning points, from a first integral
kind-series = series, to rounding
motion-exact = exact motion
motion-to-rounding = motion to rounding

### How a motion ends

outcome-rests = comes to rest after { $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
}, { $time }, { $distance } from the centre
outcome-rests-at-once = stays at rest where it is released, { $distance } from the centre
outcome-creeps = creeps without end towards a place { $distance } from the centre
outcome-creeps-to-centre = creeps without end towards the centre
outcome-swings = swings without end
outcome-decays = swings on, weaker and weaker, and never quite comes to rest
outcome-unknown = still swings after { $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
}, { $time }; whether it ever rests was not followed further

### Plots

plot-axis = { $name } { $symbol } in { $unit }
plot-axis-pure = { $name } { $symbol }
plot-time = Time
plot-position = Displacement
plot-exact-motion = Exact motion
plot-motion-to-rounding = Motion to rounding
plot-envelope = Envelope
plot-turning-points = Turning points
plot-rest = Rest: { $time }, { $position }
plot-sticking-band = Sticking band ±{ $offset }

### Quantities as they are written

dimension-mass = a mass
dimension-length = a length
dimension-time = a time
dimension-force = a force
dimension-stiffness = a stiffness
dimension-damping = a damping
dimension-mass-per-length = a mass per length
dimension-velocity = a velocity
dimension-acceleration = an acceleration
dimension-density = a density
dimension-area = an area
dimension-number = a pure number
dimension-frequency = a frequency
dimension-volume = a volume
dimension-energy = an energy
dimension-power = a power
dimension-pressure = a pressure
quantity-empty = nothing is given
quantity-too-long = it has { $length } bytes, more than { $limit }
quantity-no-number = it does not begin with a number
quantity-ambiguous = the number can mean { $decimal } or { $grouped }; write { $point } (or { $comma }) for the one, { $grouped } for the other
quantity-grouped = numbers are written without thousands separators, perhaps { $plain }
quantity-not-finite = it is not a finite number
quantity-overflow = it is too large for a number of double precision
quantity-underflow = it is not zero, but too small for a number of double precision
quantity-unknown-unit = the unit “{ $unit }” is unknown
quantity-unknown-unit-near = the unit “{ $unit }” is unknown, the nearest is “{ $nearest }”
quantity-unit-grammar = “{ $unit }” cannot be read as a unit
quantity-wrong-dimension = “{ $unit }” is a unit of another kind: { $found }
quantity-nameless-dimension = “{ $unit }” is a unit of another kind

### Experiments that are refused

experiment-refusal = { $name } is { $value }; allowed is { $allowed }
experiment-quantity = { $name } is { $value }: { $problem }; allowed is { $allowed }

### The summary

summary-sentence = The mass { $outcome }.
summary-tie = Its last swing ends on the edge of the sticking band; within the rounding of the given numbers it sticks there.
summary-tie-at-release = It is released on the edge of the sticking band; within the rounding of the given numbers it sticks there.
summary-none = none
derived-damping-ratio = damping ratio
derived-quality-factor = quality factor
derived-logarithmic-decrement = logarithmic decrement
remark-equation = Equation ({ $number }) of the article
remark-scheme = The scheme
remark-sticks-at-once = { $method } knows no sticking and lets the mass swing, which in fact stays where it is released.
remark-no-sticking = { $method } knows no sticking and goes on where the mass has come to rest.
remark-wrong-decay = { $method } lets the amplitude fall at a rate that is wrong by the factor C, and goes on after the mass sticks.
remark-grows = { $method } holds for x0 > 0 only: here, with x0 < 0, its amplitude grows where it should fall.
remark-wrong-phase = { $method } loses the quadrant of the phase for v0 < 0, as here, and starts on the wrong side.
remark-wrong-phase-and-decay = { $method } loses the quadrant of the phase for v0 < 0, as here, and its decay is wrong by the factor C.
remark-only-at-turning-points = { $method } meets the exact motion only at its turning points and knows no sticking.
remark-misses-turning-points = { $method } misses even the turning points for v0 ≠ 0, as here, and knows no sticking.
remark-chatters = { $method } has no static friction: it never rests but chatters, to and fro with every step, and creeps.
remark-first-order = { $method } is of first order, because of its backward difference: half the step halves its error.
remark-second-order = { $method } is of second order, since there is no friction: half the step leaves a quarter of its error.

### Further plots

plot-motion = Motion
plot-speed = Velocity
plot-release = Release: { $position }, { $velocity }
plot-phase-rest = Rest: { $position }
plot-energy = Energy
plot-energy-kinetic = Kinetic
plot-energy-potential = Potential
plot-energy-stokes = Heat of Stokes friction
plot-energy-coulomb = Heat of Coulomb friction
plot-energy-newton = Heat of Newton friction
plot-mean-amplitude = Mean amplitude
plot-loss = Loss per swing
plot-decrement-title = Loss of amplitude, { $mix }
plot-decrement-swings = Swings
measured-swings = Means of up to { $count } swings
plot-decrement-some = Swings (1 in { $stride })
plot-decrement-law = Averaged law { $formula }
plot-decrement-coulomb = Intercept 2f = { $value } (Coulomb)
plot-decrement-stokes = Slope πγ/ω₀ = { $value } (Stokes)
plot-decrement-newton = Curvature (4/3)κ = { $value } (Newton)
plot-decrement-empty = There is no swing: fewer than two amplitudes are known
plot-decrement-description =
    { $title }: { $swings ->
        [one] one swing loses
       *[other] { $swings } swings lose
    } between { $least } and { $most } each, at mean amplitudes up to { $largest }. The line is the averaged law { $formula }.
plot-error = Error
plot-time-step = Time step

### Methods beside the exact motion

compare-sticks = sticks
compare-creeps = creeps { $speed }
compare-goes-on = swings on
error-step-underflow = at { $time } the step has shrunk to { $step }, where time no longer advances; a larger tolerance may hold
error-step-limit = at { $time } the { $limit } steps allowed were used up

### Samples of other programs against the reference problems

samples-too-large = { $place } is too large; allowed are { $limit } bytes

### Recordings

plot-recorded = Recorded
plot-not-fitted = Recorded, not fitted
plot-fit = Fit
plot-residual = Recorded minus fitted
plot-recording-description = { $title }: { $samples } values over { $duration }, between { $lowest } and { $highest }, and the fitted motion.
plot-residuals-description = What the fit leaves, with a root mean square of { $rms }.
fit-title = { $name }: { $quantity }
fit-quantity-position = Position
fit-quantity-velocity = Velocity
fit-quantity-acceleration = Acceleration
fit-parameter-angular-frequency = angular frequency ω₀
fit-parameter-damping-rate = damping rate γ (Stokes)
fit-parameter-coulomb-acceleration = dry friction over mass a_c (Coulomb)
fit-parameter-newton-rate = drag over mass κ (Newton)
fit-parameter-position0 = position at the beginning
fit-parameter-velocity0 = velocity at the beginning
fit-parameter-equilibrium = zero of the scale
fit-parameter-static-acceleration = static friction over mass
fit-row-frequency = natural frequency
fit-row-damping-ratio = damping ratio
    .viscous = viscous damping ratio
fit-row-equivalent = equivalent damping ratio
fit-range = { $first } to { $last }
fit-range-at = { $values } ({ $from } to { $to })
fit-row-window = fitted part
fit-window-value = { $from } to { $to }, { $samples } values
fit-row-residual = residual (rms)
fit-row-begins = it begins there
fit-row-ends = it ends there
fit-row-column = column
fit-row-reduced = reduced χ²
fit-unit-nameless = of the recording, which names none
fit-row-unit = unit u
fit-row-chi = χ²

### Experiments of the page

preset-article-stokes = Stokes, scheme and solution (the article’s graph)
preset-article-coulomb = Coulomb, scheme (the article’s graph)
preset-article-coulomb-formula = Coulomb, formula and scheme (the article’s graph)
preset-article-coulomb-thrown = Coulomb, thrown (the article’s graph)
preset-article-newton = Newton (the article’s graph)
preset-block-on-table = A block on a table
preset-card-in-air = A card in air
preset-heavy-oil = Heavy oil
preset-all-three = All three at once

### What the error lens says

lens-error = Largest distance from the motion: { $error }.
lens-rounding = Largest distance from the motion: { $error }, which is only rounding.
lens-order = Half the step divides the error by { $factor } here: order { $observed }; promised is order { $declared }, as long as the force does not jump.
lens-no-order = Shorter steps show no order here; promised is order { $declared }, as long as the force does not jump.
lens-sticks = Where the mass has come to rest, this curve rests too.
lens-creeps = Where the mass has come to rest, this curve creeps on at { $speed }.
lens-goes-on = Where the mass has come to rest, this curve swings on.
