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

### Quantities made of the parameters

derived-angular-frequency = angular frequency without friction
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
plot-motion-title = Mass on a spring, { $mix }
plot-motion-description = { $title }: displacement over { $duration }, from { $start } at the release, between { $lowest } and { $highest }. The mass { $outcome }.
plot-comparison-description = Dashed beside it: { $name }, between { $lowest } and { $highest }.

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

experiment-too-large = The file is larger than { $limit } bytes, the most that is read
experiment-not-utf8 = The file is not UTF-8 text (byte { $offset }); allowed is a TOML file with the sections { $sections }
experiment-empty = The file is empty; allowed is a TOML file with the sections { $sections }
toml-unquoted = { $key } = { $value } is not TOML; a number with a unit or a decimal comma must stand in quotes: { $key } = "{ $value }"
toml-typographic = This is not TOML: typographic quotes mean nothing there, only straight ones do: { $example }
toml-unquoted-text = This is not TOML: a value that is no plain number must stand in quotes: { $example }
toml-twice = This is not TOML: { $key } stands twice; allowed is once
toml-bad-text = This is not TOML: a text lacks its closing quote or holds signs that are not allowed; written rightly: { $example }
toml-unclosed-section = This is not TOML: the name of a section lacks its closing bracket; written rightly: { $example }
toml-unclosed-table = This is not TOML: the closing brace is missing; written rightly: { $example }
toml-unclosed-list = This is not TOML: the closing bracket of a list is missing; an experiment needs no lists
toml-no-equals = This is not TOML: “=” and a value must follow a key: { $example }
toml-no-value = This is not TOML: no value stands behind “=”; written rightly: { $example }
toml-bad-key = This is not TOML: a key of plain letters must stand before “=”: { $example }
toml-comma = This is not TOML: one comma must stand between two values in braces: { $example }
toml-bad-number = This is not TOML: the number is not written as TOML allows; in quotes more is allowed: { $example }
toml-trailing = This is not TOML: something stands behind the end of a value or a section; every key begins a line of its own
toml-too-deep = This is not TOML that can be read: too many brackets or dots within one another
toml-other = This is not TOML (the reader says: { $problem })
experiment-unknown-key = { $name } is unknown; allowed here: { $allowed }
experiment-unknown-key-near = { $name } is unknown; did you mean { $nearest }? Allowed here: { $allowed }
experiment-allowed-keys = a section with { $keys }
experiment-refusal = { $name } is { $value }; allowed is { $allowed }
experiment-quantity = { $name } is { $value }: { $problem }; allowed is { $allowed }
experiment-missing = { $name } (or --{ $flag }) is missing; allowed is { $allowed }
experiment-too-many-samples = { $name } is { $value }; at most { $fit } samples fit into the memory that is free
experiment-both = { $name } is { $value } and { $other } is { $otherValue }; only one of the two may be given
experiment-static-below-kinetic = { $name } is { $value }; allowed is at least { $other }, { $otherValue }
experiment-static-without-kinetic = { $name } is { $value }, but { $missing } is missing; static friction is allowed only beside kinetic friction
experiment-incomplete = { $name } is { $value }, but { $missing } is missing; Newton friction needs { $density }, { $drag } and { $area }, or { $coefficient } alone
experiment-no-normal-force = { $name } is { $value }; Coulomb friction needs a normal force greater than 0

### The command line

cli-error = error
cli-system-refuses = { $name }: { $problem }
cli-stdout = standard output
cli-computing = computing
cli-writing = writing
cli-written = written: { $name }
cli-about = The exact motion of a mass on a spring with Stokes, Coulomb and Newton friction
cli-heading-usage = Usage
cli-heading-commands = Commands
cli-heading-arguments = Arguments
cli-heading-options = Options
cli-heading-overrides = Overrides: a number and its unit; each replaces its field of the experiment
cli-value-command = COMMAND
cli-value-file = FILE
cli-value-options = OPTIONS
cli-value-name = NAME
cli-value-quantity = QUANTITY
cli-help = Print help
cli-version = Print the version
cli-lang = Language of all texts: de or en (default: from the environment)
cli-simulate = Compute the motion of one experiment
cli-completions = Write completions for a shell to standard output
cli-man = Write the manual page to standard output
man-name = NAME
man-synopsis = SYNOPSIS
man-description = DESCRIPTION
man-extra = EXAMPLES
man-version = VERSION
cli-shell = bash, elvish, fish, powershell or zsh
cli-experiment = Experiment file, “-” for standard input; without one the built-in experiment runs: 0.5 kg on 20 N/m, released at 10 cm, kinetic coefficient 0.02
cli-method = Method of computing the samples: { $methods } (default: exact)
cli-noise = Noise of a sensor (standard deviation) for tables; its unit says what is recorded: “1 mm” positions, “1 mm/s” velocities, “1 cm/s^2” accelerations
cli-seed = Seed of the noise (default: 0); the same seed gives the same noise
cli-noise-without-csv = --noise is for tables; it needs a file that ends in .csv, or --format csv
cli-seed-without-noise = --seed belongs to --noise
cli-dt = Time step of article-scheme (default: a thousandth of the period)
cli-experiment-file = An experiment file is TOML; a value is a number and its unit in quotes, a bare number is SI. Only mass, stiffness and position must be given. Instead of gravity it may give normal_force, instead of density, drag_coefficient and area a coefficient in newton.
cli-output = Write a file; its extension says which form: { $forms }; “-” is standard output. May be repeated
cli-format = What standard output gets: summary (default), csv or json
cli-csv-dialect = standard (default), or german with semicolons and decimal commas
cli-details = Let the summary tell everything
cli-examples =
    Examples:
      federpendel simulate
      federpendel simulate my.toml -o motion.csv -o motion.svg
      federpendel simulate --help
cli-simulate-examples =
    Without duration the record ends shortly after the mass comes to rest, or after 12 periods if it rests later than 200 periods or never; where it only creeps, after ten time constants.

    Examples:
      federpendel simulate
      federpendel simulate my.toml -o motion.csv -o motion.svg
      federpendel simulate my.toml --kinetic 0.05 --position "-5 cm" --details
      federpendel simulate my.toml --format json > motion.json
      federpendel simulate --method article-scheme --dt "10 ms"
cli-completions-examples =
    Examples:
      federpendel completions bash > ~/.local/share/bash-completion/completions/federpendel
      federpendel completions fish > ~/.config/fish/completions/federpendel.fish
cli-man-examples =
    Examples:
      federpendel man | man -l -
      federpendel man > ~/.local/share/man/man1/federpendel.1
cli-unknown-argument = { $argument } is unknown; federpendel --help lists what is allowed
cli-unknown-argument-near = { $argument } is unknown; did you mean { $nearest }?
cli-unknown-command = { $argument } is no command; allowed are { $allowed }
cli-unknown-command-near = { $argument } is no command; did you mean { $nearest }?
cli-invalid-value-near = { $argument } is “{ $value }”; did you mean { $nearest }? Allowed are { $allowed }
cli-second-file = “{ $argument }” is one file too many: only one experiment file is allowed
cli-missing-value = { $argument } has no value; one must follow it
cli-invalid-value = { $argument } is “{ $value }”; allowed are { $allowed }
cli-given-twice = { $argument } is given twice; allowed is once
cli-missing-argument = { $argument } is missing; allowed are { $allowed }
cli-no-value-allowed = { $argument } is “{ $value }”; it takes no value
cli-argument-not-utf8 = An argument is not UTF-8 text
cli-output-twice = --output “{ $name }” names a file that is already in use by this command
cli-output-folder = --output “{ $name }” is a folder; allowed is a file
cli-output-nowhere = --output “{ $name }”: the folder “{ $folder }” is missing
cli-output-special = --output “{ $name }” is no ordinary file
cli-output-extension = --output “{ $name }” has an extension of no known form; allowed are { $allowed }

### The summary

summary-sentence = The mass { $outcome }.
summary-tie = Its last swing ends on the edge of the sticking band; within the rounding of the given numbers it sticks there.
summary-tie-at-release = It is released on the edge of the sticking band; within the rounding of the given numbers it sticks there.
summary-none = none
summary-given-row = given
summary-friction = friction
summary-period = period
summary-period-value = { $period } (frequency { $frequency })
summary-period-small-value = { $period } at small amplitude (frequency { $frequency })
summary-period-small = period at small amplitude
summary-damping = damping ratio
summary-damping-value = { $ratio } ({ $regime })
summary-energy = energy
summary-energy-value = { $initial } at release, { $left } at the end of the record
summary-record = record
summary-record-value = { $samples } samples over { $duration }
summary-method = method
summary-kind = known as
summary-given = Given
summary-derived = Derived
summary-spent = Energy at the end of the record
summary-certainty = How well it is known
summary-turning-points = Turning points
summary-more-points = … and more; --format json writes all
summary-energy-initial = at release
summary-energy-kinetic = kinetic
summary-energy-potential = potential
summary-heat-stokes = heat of Stokes friction
summary-heat-coulomb = heat of Coulomb friction
summary-heat-newton = heat of Newton friction
summary-error-bound = error of positions below
summary-margin = rest inside the sticking band
summary-margin-value = { $distance } from its edge, { $margin } % of the offset f
derived-damping-ratio = damping ratio
derived-quality-factor = quality factor
derived-logarithmic-decrement = logarithmic decrement
summary-point-time = t in s
summary-point-position = x in m
output-too-many-points = The record of { $duration } holds about { $number } turning points; a JSON file lists at most { $limit }. Allowed is a shorter duration
summary-deviation = { $method } is up to { $distance } away from that motion, most at { $time }.
summary-agrees = { $method } agrees with that motion to rounding.
summary-method-equation = { $method }, equation { $equation }
summary-method-overdamped = { $method }, the article’s solution for overdamped motion
summary-method-critical = { $method }, the article’s solution for critical damping
summary-method-steps = { $method }, steps of { $step }
summary-method-interpolated = { $method }, steps of { $step }; samples between steps are interpolated
cli-dt-without-scheme = --dt is “{ $value }”, but the method is { $method }; a time step is allowed only with --method article-scheme
cli-not-found = no such file or folder
cli-permission-denied = permission denied
cli-is-a-folder = this is a folder, not a file
cli-is-no-folder = a part of this path is a file, not a folder
cli-name-too-long = this name is too long or holds a sign that the system does not allow
cli-storage-full = no space left on the device
cli-read-only = this file system can only be read
remark-equation = Equation ({ $number })
remark-scheme = The scheme
remark-sticks-at-once = { $method } knows no sticking and lets the mass swing, which in fact stays where it is released.
remark-no-sticking = { $method } knows no sticking and goes on where the mass has come to rest.
remark-wrong-decay = { $method } lets the amplitude fall at a rate that is wrong by the factor C, and goes on after the mass sticks.
remark-grows = { $method } holds for x0 > 0 only: here, with x0 < 0, its amplitude grows where it should fall.
remark-wrong-phase = { $method } loses the quadrant of the phase for v0 < 0, as here, and starts on the wrong side.
remark-wrong-phase-and-decay = { $method } loses the quadrant of the phase for v0 < 0, as here, and its decay is wrong by the factor C.
remark-only-at-turning-points = { $method } meets the exact motion only at its turning points and knows no sticking.
remark-misses-turning-points = { $method } misses even the turning points for v0 ≠ 0, as here, and knows no sticking.
remark-chatters = { $method } has no static friction: it never rests but chatters and creeps.
remark-first-order = { $method } is of first order, because of its backward difference: half the step halves its error.
remark-second-order = { $method } is of second order, since there is no friction: half the step leaves a quarter of its error.
step-unstable = a time step of { $step } is too long: with it the scheme is unstable and runs away from the motion. It is stable below { $longest }; safe is --dt "{ $proposed }"
step-coarse = a time step of { $step } is too long for this record: the error of the scheme has become larger than the motion. Try --dt "{ $proposed }" or a shorter record
cli-warning = warning
summary-energy-values = { $initial } at release; at the end of the record { $left } ({ $motion }), { $other } ({ $method })
summary-heading-of = { $heading } ({ $whose })
summary-margin-tie = on the edge, within rounding
summary-margin-distance = { $distance } from its edge

### Further plots

plot-motion = Motion
plot-speed = Velocity
plot-release = Release: { $position }, { $velocity }
plot-phase-rest = Rest: { $position }
plot-phase-title = Phase portrait, { $mix }
plot-phase-description = { $title }: velocity against displacement, from { $position } and { $velocity } at the release; displacements between { $lowest } and { $highest }, velocities between { $slowest } and { $fastest }. The mass { $outcome }.
plot-energy = Energy
plot-energy-title = Where the energy is, { $mix }
plot-energy-kinetic = Kinetic
plot-energy-potential = Potential
plot-energy-stokes = Heat of Stokes friction
plot-energy-coulomb = Heat of Coulomb friction
plot-energy-newton = Heat of Newton friction
plot-energy-description = { $title }: stacked areas over { $duration }; their sum is the energy of the release, { $total }. At the end, from top to bottom: { $parts }.
plot-energy-part = { $name } { $energy }
plot-mean-amplitude = Mean amplitude
plot-loss = Loss per swing
plot-decrement-title = Loss of amplitude, { $mix }
plot-decrement-swings = Swings
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
plot-errors-title = Error of the displacement, { $mix }
plot-errors-description = { $title }: distance from the exact motion over { $duration }, on a logarithmic axis. Largest error: { $methods }.
plot-errors-method = { $name } { $error }
plot-largest-error = Largest error
plot-time-step = Time step
plot-steps = Steps
plot-convergence-title = Largest error against time step, { $mix }
plot-convergence-description = { $title }, both axes logarithmic. { $methods }.
plot-convergence-method = { $name }: order { $order } by design, { $observed } observed, error down to { $error }
plot-convergence-unobserved = none
plot-order = Order
plot-order-observed = { $name } (p ≈ { $order })
plot-work-title = Largest error against steps taken, { $mix }
plot-work-description = { $title }, both axes logarithmic. { $methods }.
plot-work-method = { $name }: { $error } with { $steps } steps
plot-no-errors = No error above zero to show
plot-overlay-title = Motion and methods, { $mix }
plot-overlay-last-swings = The last swings, seen closer
plot-overlay-last-periods = The last two periods, seen closer
plot-overlay-description = { $title }: displacement over { $duration }, and the part from { $from } to { $until } seen closer. The mass { $outcome }. Displacement at the end: { $methods }.
plot-beside-description = { $title }: displacement over { $duration }. The mass { $outcome }. Displacement at the end: { $methods }.
plot-after-rest-title = After the rest, { $mix }
plot-after-rest-none = In this time the mass does not come to rest
plot-after-rest-description = { $title }: displacement from { $from } to { $until }, as high as the sticking band ±{ $offset }. The mass rests from { $rest } on. Displacement at the end: { $methods }.
plot-courses-description = { $title }: displacement over { $duration }. { $courses }.
plot-courses-course = { $name }: from { $start }, between { $lowest } and { $highest }, { $end } at the end
plot-losses-title = Loss of amplitude per swing
plot-losses-description = { $title }, against the mean amplitude. { $motions } The lines are the averaged law.
plot-losses-motion =
    { $name }: { $swings ->
        [one] one swing costs
       *[other] { $swings } swings cost
    } between { $least } and { $most }, at mean amplitudes up to { $largest }; { $formula }.
plot-real-part = Real part
plot-imaginary-part = Imaginary part
plot-roots-title = Roots of the characteristic equation
plot-roots-path = { $symbol } for γ from 0 to { $most } ω₀
plot-roots-marks = Marked γ
plot-roots-own = This experiment, γ = { $gamma }
plot-roots-own-pair = This experiment, γ = { $gamma } 1/s: λ = ({ $real } ± { $imaginary } i) 1/s
plot-roots-own-real = This experiment, γ = { $gamma } 1/s: λ₁ = { $slow } 1/s, λ₂ = { $fast } 1/s
plot-roots-description = { $title } λ² + 2γλ + ω₀² = 0 in the complex plane, ω₀ = { $omega }. For γ from 0 to ω₀ they run as a conjugate pair from ±iω₀ along the circle of radius ω₀ to −ω₀, then apart on the real axis, at γ = { $most } ω₀ to { $slow } and { $fast }. { $own }.

### Methods beside the exact motion

cli-compare = Hold methods beside the exact motion of an experiment: how far off, of what order, at what cost
cli-compare-examples =
    Examples:
      federpendel compare
      federpendel compare my.toml --against rk4,rk4-located --dt "5 ms"
      federpendel compare my.toml --plot convergence -o orders.svg
      federpendel compare --against dopri5-located --tolerance 1e-9 --details
      federpendel compare --format json > comparison.json
cli-value-names = NAMES
cli-value-numbers = NUMBERS
cli-value-number = NUMBER
cli-against = Methods, with commas between them: { $methods } (default: all that apply)
cli-compare-dt = Time step of the methods that take one (default: about a thousandth of the period, so that no reversal falls on a step)
cli-tolerance = Error that dopri5 and dopri5-located may make in a step, over the amplitude (default: 1e-6)
cli-width = Velocity over which rk4-tanh smooths dry friction (default: 1 % of ω0 times the amplitude)
cli-theme = What pictures are drawn on: light (default) or dark
cli-plot-motion = What pictures show: { $plots } (default: motion)
cli-plot-comparison = What pictures show: { $plots } (default: error)
compare-unknown-method = --against names “{ $name }”; allowed are { $allowed }
compare-unknown-method-near = --against names “{ $name }”; did you mean { $nearest }? Allowed are { $allowed }
compare-does-not-apply = --against names “{ $name }”, which does not apply here. { $reason }
compare-one = { $method } is up to { $error } away from it.
compare-range = Nearest to it stays { $nearest }, within { $least }; farthest off is { $farthest }, by { $most }.
compare-head-method = method
compare-head-error = error
compare-head-order = order
compare-head-rest = at rest
compare-head-steps = steps
compare-head-time = run time
compare-order-note = order: declared → observed over six halvings of the step
compare-failed = failed
compare-sticks = sticks
compare-creeps = creeps { $speed }
compare-goes-on = swings on
compare-no-order = { $method } shows no order: { $reason }.
compare-failed-rung = with { $setting } it fails; { $reason }
compare-failure = { $method } failed: { $reason }.
compare-detail-largest = largest error of a position
compare-detail-when = when that was
compare-detail-mean = root mean square error
compare-detail-energy = largest error of the energy, over that of the release
compare-detail-final = position at the end
compare-detail-rungs = error for shorter and shorter steps
compare-detail-creep = After rest: watched during the second undamped period after the mass has come to rest.
error-step-underflow = at { $time } the step has shrunk to { $step }, where time no longer advances; a larger tolerance may hold
error-step-limit = at { $time } the { $limit } steps allowed were used up

### Samples of other programs against the reference problems

cli-score = Score another program’s samples against a reference problem: how far off, and whether they stand still at rest
cli-score-examples =
    A file of samples is CSV with a header: the columns time and position, velocity if known, in SI units; times in any order. Commas between cells, or semicolons, with which decimal commas are allowed. Other columns are ignored.

    Examples:
      federpendel score --list coulomb
      federpendel score --problem laboratory-c --times > times.txt
      federpendel score mine.csv --problem laboratory-c
      federpendel score mine.csv --problem laboratory-c --format json
cli-score-samples = File of samples, “-” for standard input
cli-score-problem = Name of the problem
cli-score-format = What standard output gets: summary (default) or json
cli-score-list = List the problems; with a text only those in whose name, mix or description it stands
cli-score-times = Print the times at which the problem stores 36 digits
cli-value-text = TEXT
cli-second-samples = “{ $argument }” is one file too many: only one file of samples is allowed
score-lists-alone = --list stands alone, --times only with --problem; neither goes with a file of samples or with --format
score-no-problem = --problem is missing; allowed is a name that federpendel score --list shows
score-no-samples = The file of samples is missing; allowed is a CSV file with the columns time and position, or “-” for standard input
score-unknown-problem = --problem is “{ $name }”, which no problem is called; federpendel score --list shows the names
score-unknown-problem-near = --problem is “{ $name }”, which no problem is called; did you mean { $nearest }?
score-none-listed = --list is “{ $part }”, which stands in no problem’s name, mix or description; federpendel score --list shows all
score-beyond = { $file }: { $reason }
samples-too-large = { $place } is too large; allowed are { $limit } bytes
samples-not-utf8 = { $place }: this line is not UTF-8; allowed is UTF-8 text
samples-empty = { $place } is empty; allowed is a header with the columns time and position, and rows of numbers below it
samples-no-rows = { $place } has a header but no samples; at least one row of numbers is needed
samples-missing-column = { $place }: the header “{ $header }” has no column { $name }; it may be called { $name } or { $short }
samples-column-twice = { $place }: the column { $column } stands twice in the header; allowed is once
samples-unit = { $place }: the column { $column } is in “{ $unit }”; allowed is { $allowed }
samples-cells = { $place }: this row has { $found } cells, the header { $expected }; allowed are as many, and decimal commas only with semicolons between cells
samples-no-number = { $place }: { $column } is “{ $value }”; allowed is a number
samples-not-finite = { $place }: { $column } is “{ $value }”; allowed is a finite number, at most { $largest } in magnitude
samples-negative-time = { $place }: { $column } is “{ $value }”; allowed is 0 or greater
score-of-amplitude = { $error } of the amplitude
score-of-speed = { $error } of ω₀ times the amplitude
score-agrees = The samples agree with the exact motion to rounding.
score-sentence = The samples are up to { $error } off the exact motion, most at { $time }.
score-rest-sticks = After the rest at { $time } they stand still.
score-rest-creeps = After the rest at { $time } they creep on, at { $speed }.
score-rest-moves = After the rest at { $time } they keep moving, within { $range }.
score-rest-unknown = Too few of them lie after the rest at { $time } to tell whether they stand still.
score-problem = problem
score-samples = samples
score-samples-value = { $samples }, the last at { $time }
score-position = position
score-velocity = velocity
score-errors-value = largest error { $error }, at { $time }; root mean square { $mean }
score-last = last sample off by
score-stored = against stored digits
score-stored-value =
    { $error } at most, at { $samples ->
        [one] one stored time
       *[other] { $samples } stored times
    }
score-bound = motion known to

### The article's claims

cli-article = Check the claims of the article for an experiment and write the report
cli-article-examples =
    Examples:
      federpendel article -o article.html
      federpendel article my.toml --lang de -o artikel.html
      federpendel article --worksheet -o sheet.html
      federpendel article --stiffness "1 N/m" --details
      federpendel article --format json > checks.json
cli-article-output = File to write, by its extension: { $forms }; may be repeated
cli-article-format = What standard output gets: summary (default) or json
cli-article-worksheet = Leave the verdicts of the page blank for a class; the solutions are written beside it
cli-article-claims = Put only these claims on the page, by their numbers: 43-47,54 (default: all)
cli-article-no-page = --worksheet needs a file that ends in .html: -o sheet.html
cli-article-no-claim = --claims is “{ $value }”; allowed are numbers from 1 to { $last } and ranges like 43-47, with commas between them
cli-article-claims-without-page = --claims chooses what stands on the page; that needs a file that ends in .html
cli-article-details = Tell of every claim what was computed and found
article-solutions-file = -solutions
article-hint = -o article.html writes the report; --details tells of every claim here.

### Recordings

plot-recorded = Recorded
plot-not-fitted = Recorded, not fitted
plot-fit = Fit
plot-residual = Recorded minus fitted
plot-recording-description = { $title }: { $samples } values over { $duration }, between { $lowest } and { $highest }, and the fitted motion.
plot-residuals-description = What the fit leaves, with a root mean square of { $rms }.

cli-fit = Fit recordings of a free decay: which friction acts, how strongly, how surely
cli-fit-examples =
    Examples:
      federpendel fit recording.csv -o report.html
      federpendel fit phyphox.zip --value "Acceleration y" --details
      federpendel fit *.txt --format json > fits.json
      federpendel fit recording.csv --laws stokes,coulomb --from "1.2 s" -o fit.svg -o fit.json
cli-value-recordings = RECORDING…
cli-value-column = COLUMN
cli-value-unit = UNIT
cli-fit-recordings = Files as measuring programs write them: text with commas, semicolons, tabs or spaces, .zip, .xlsx, .xls
cli-fit-time = Column of times, by heading, name or number (default: the one that its header calls so)
cli-fit-value = Column of values (default: the component that oscillates most)
cli-fit-quantity = What the values are: position, velocity or acceleration (default: what unit or name say)
cli-fit-unit = Unit of the values, whatever the file says (Tracker names none): m, cm, rad, m/s, g …
cli-fit-rate = Samples a second, for a file without times: "50 Hz"
cli-fit-run = The run, where a file holds several (default: all of them)
cli-fit-table = Sheet of a workbook or file of a .zip, where it holds several
cli-fit-laws = auto (default): the laws that the recording shows; none: no friction; or the mix to be fitted, a list of stokes, coulomb, newton
cli-fit-from = When the fitted part begins (default: where the free decay does)
cli-fit-to = When it ends (default: where the mass no longer moves)
cli-fit-sigma = Standard deviation of a value, if known (“1 mm”, or a number in the unit of the values); χ² is measured in it
cli-fit-output = File to write, by its extension: { $forms }; may be repeated
cli-fit-intervals = How 95 % intervals are found: profile (default: of the sum of squares), covariance (from standard errors) or bootstrap (refits to residuals drawn anew)
cli-fit-loss = How residuals count: squares (default), or huber or tukey, which outliers do not sway
cli-fit-format = What standard output gets: summary (default), csv (a row for each recording) or json
fit-laws-refused = --laws names “{ $value }”; allowed are auto, none, stokes, coulomb, newton
fit-pictures-of-one = A picture shows one recording; { $count } were fitted. Choose one, or its --run
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
fit-row-window = fitted part
fit-window-value = { $from } to { $to }, { $samples } values
fit-row-residual = residual (rms)
fit-row-begins = it begins there
fit-row-ends = it ends there
fit-row-column = column
fit-heading-models = Mixes, by AICc
fit-heading-all-the-same = The best mix all the same, for comparison
fit-model-row = AICc { $aicc }, BIC { $bic }, rms { $rms }
fit-row-evaluations = evaluations of the model
fit-row-reduced = reduced χ²
fit-stop-step-limit = at its last allowed step
fit-stop-no-progress = as no step lowered χ² further (a kink or jump is near)
fit-stop-converged = as it converged
fit-row-stop = the search ended
fit-row-bic = BIC
fit-row-aicc = AICc
fit-row-aic = AIC
fit-row-effective = effective number of values
fit-row-p-value = p-value of no { $law }
fit-heading-correlations = Correlations of at least { $floor }
fit-unit-nameless = of the recording, which names none
fit-row-unit = unit u
fit-row-chi = χ²
fit-interval = { $value } (95 %: { $interval })
