# How to plan an experiment. The folder de holds the same ids with the same variables.

### The command line

cli-plan = Plan an experiment: from how far to release, how long to record, so that the laws of friction separate
cli-plan-examples =
    The experiment is what you expect: mass, spring, friction. Its position is the farthest release that you allow (or --max-amplitude), its duration the longest recording.

    Examples:
      federpendel plan --noise 1mm
      federpendel plan my.toml --noise 1mm --rate 50Hz --max-amplitude 30cm
      federpendel plan my.toml --noise "2 cm/s^2" --rate "100 Hz" --duration "60 s" --details
      federpendel plan my.toml --noise 1mm --laws auto -o plan.svg -o plan.json
cli-plan-noise = Noise of the sensor (standard deviation of a value); its unit says what is recorded: “1 mm” positions, “1 mm/s” velocities, “1 cm/s^2” accelerations
cli-plan-rate = Values per second of the recording (default: 50 Hz)
cli-plan-quantity = What is recorded: position, velocity or acceleration (default: what the unit of --noise says)
cli-plan-min-amplitude = Smallest amplitude of release that is looked at (default: ten times the noise)
cli-plan-max-amplitude = Largest amplitude of release (default: the release of the experiment)
cli-plan-laws = Laws that the fit will take besides those expected: auto (all three), none (default), or a list of stokes, coulomb, newton

plan-no-noise = --noise is missing; allowed is the standard deviation of a value of your sensor, as in --noise 1mm
plan-no-samples = --samples has no place in a plan; allowed are --rate, values per second, and --duration
plan-no-release = The experiment is released at its centre; needed is a largest amplitude, as in --max-amplitude 10cm
plan-rate-too-low = --rate is { $rate }; allowed is at least { $least }, four values in each swing
plan-duration-too-short = --duration is { $duration }; allowed is at least { $least }, five swings
plan-no-swings = With the friction that is expected the mass does not swing: its damping ratio is { $ratio }; allowed is a ratio below 1
plan-sticks = Released from { $amplitude } the mass does not move, for static friction holds it up to { $held }; allowed is a larger --max-amplitude or position
plan-reversed = --min-amplitude is { $from }; allowed is less than the largest amplitude, { $to }
plan-drowned = The noise is worth { $noise } of amplitude; at most { $amplitude } are allowed for the release, less than ten times as much. Needed is less noise, or a larger --max-amplitude or position
plan-not-computed = The motion with these coefficients cannot be computed: numbers on the way are too large or too small
plan-too-long = The motion can be followed up to { $reached } only; allowed is a shorter --duration

### The picture

plan-plot-title = What a release shows: { $mix }
plan-plot-amplitude = Amplitude of release
plan-plot-significance = Coefficient / standard error
plan-plot-threshold = resolved from { $threshold } on
plan-plot-description = { $title }: coefficient over standard error for amplitudes of release from { $from } to { $to }, both axes logarithmic. { $laws }. A law is resolved from { $threshold } on.
plan-plot-law = { $name } rises from { $first } to { $last }

### What a plan says

plan-none-expected = No friction is expected.
plan-advice-one = Release from at least { $amplitude } and record { $duration }: then { $mix } shows.
plan-advice-some = Release from at least { $amplitude } and record { $duration }: then { $mix } separate.
plan-advice-none = Nothing can be resolved up to { $amplitude }.
plan-drowns = Below { $amplitude } { $law } does not show.
plan-unresolved = { $law } is not resolved even from { $amplitude }: there its coefficient is { $significance } standard errors from zero. Noise { $factor } times smaller would do, or { $square } times the rate.
plan-unresolved-beyond = { $law } is not resolved even from { $amplitude }: there its coefficient is { $significance } standard errors from zero. Noise { $factor } times smaller would do, or { $square } times the rate, or a release from { $beyond }.
plan-unseen = { $law } cannot be seen at all up to { $amplitude }.
plan-confused = At { $amplitude } { $one } and { $other } look much alike (correlation of their coefficients { $correlation }).
plan-limit = { $law }, which is not expected, would show from { $value } on ({ $amplitude }, { $duration }).
plan-head-law = law
plan-head-coefficient = coefficient
plan-head-amplitude = amplitude
plan-head-duration = duration
plan-head-stderr = standard error
plan-coefficient-stokes = γ = { $value }
plan-coefficient-coulomb = a_c = { $value }
plan-coefficient-newton = κ = { $value }
plan-as-given-stokes = D = { $value }
plan-as-given-coulomb = μF_N = { $value }
plan-as-given-newton = ½ρc_wA = { $value }
plan-row-recording = recording
plan-recording-value = { $quantity }, noise { $noise }, { $rate } values per second
plan-row-amplitudes = amplitudes
plan-amplitudes-value = { $from } to { $to }
plan-row-fitted = fitted together
plan-row-fit = to be fitted by
plan-coefficient-value = { $reduced }, { $given }
plan-row-largest = { $law }, from { $amplitude }
plan-largest-value = { $significance } standard errors from zero in { $duration }
plan-pair-value = correlation { $correlation } at { $amplitude }
plan-row-limit = { $law }, not expected
plan-limit-value = would show from { $reduced } on ({ $given }); found zero, it is below { $upper } with 95 %
plan-assumed = Assumed are noise without memory from value to value, the same for all, and a motion that is exactly that of a mass on a spring with these laws: a spring that softens at large amplitudes, a sensor that drifts or a cart that shakes take more. “Shows” and “separate” mean a coefficient at least five standard errors from zero; the duration is that after which more of it makes the standard error at most 5 % smaller.
