# Every English sentence of federpendel. de.ftl holds the same ids with the same variables.

### Terms of the field

term-turning-point = turning point

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
    .description = Position of release, from the place where the spring is relaxed
parameter-velocity = velocity
    .description = Velocity of release
parameter-duration = duration
    .description = Length of the record
parameter-samples = samples
    .description = Number of samples of the record, both ends included
parameter-dt = time step
    .description = Time step of a numeric scheme
parameter-time = time
    .description = Time at which the motion is asked for

### Quantities made of the parameters

derived-angular-frequency = angular frequency without friction
derived-damping-rate = damping rate
derived-offset = offset of Coulomb friction
derived-sticking-offset = half width of the sticking band
derived-newton-rate = rate of Newton friction
derived-drag-strength = drag strength (newton_rate times amplitude)
derived-amplitude = amplitude
derived-energy = energy

### What is allowed

range-positive = a finite number greater than 0
range-non-negative = a finite number, 0 or greater
range-finite = a finite number
range-count-from-two = a whole number, 2 or greater

### Errors of the core

error-parameter = { $name } is { $value }; allowed is { $allowed }
error-static-below-kinetic = { $name } is { $static }; allowed is at least kinetic, { $kinetic }
error-no-normal-force = { $name } is { $value }; Coulomb friction needs a normal force greater than 0
error-derived = The given values make { $quantity } = { $value }; it must be an ordinary finite number
error-derived-too-large = The given values make { $quantity } = { $value }; that is too large to be computed
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

### How a motion is known

kind-closed-form = exact, in closed form
kind-first-integral = exact turning points, from a first integral
kind-series = series, to rounding

### How a motion ends

outcome-rests = comes to rest after { $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
}, { $time }, { $distance } from the centre
outcome-rests-at-once = stays at rest where it is released, { $distance } from the centre
outcome-creeps = creeps without end towards a place { $distance } from the centre
outcome-creeps-to-centre = creeps without end towards the centre
outcome-swings = swings without end
outcome-unknown = still swings after { $swings ->
    [one] { $swings } swing
   *[other] { $swings } swings
}, { $time }; whether it ever rests was not followed further

### Plots

plot-axis = { $name } { $symbol } in { $unit }
plot-axis-pure = { $name } { $symbol }
plot-time = Time
plot-position = Displacement
plot-envelope = Envelope
plot-turning-points = Turning points
plot-rest = Rest: { $time }, { $position }
plot-sticking-band = Sticking band ±{ $offset }
plot-motion-title = Mass on a spring, { $mix }
plot-motion-description = { $title }: displacement over { $duration }, from { $start } at the release, between { $lowest } and { $highest }. The mass { $outcome }.
