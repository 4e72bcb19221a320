# The report of a fit. The folder de holds the same ids with the same variables.

measured-none = –

### One recording

measured-title = Which friction acts in { $name }?

## Result

measured-result = Result
measured-fit-caption = { $name }: the recording with the fitted motion of a mass on a spring, { $mix }; below it what the fit leaves, recorded minus fitted.
measured-closest = These values belong to the simplest mix that is not rejected: { $mix }. Since no mix describes this motion, they do not measure its friction.
measured-values-caption = The fitted values, rounded to their uncertainty.
measured-head-parameter = Parameter
measured-head-value = Value ± standard error
measured-head-interval = 95 % interval
measured-head-unit = Unit

## Damping and physical numbers

measured-figures = Damping and physical numbers
measured-head-quantity = Quantity
measured-damping-text = What other tests call damping: the ratio is that of the viscous friction which takes as much energy from a cycle of this amplitude, $\zeta_A = \gamma/\omega_0 + 2a_c/(\pi\omega_0^2 A) + 4\kappa A/(3\pi)$. Only viscous friction alone makes it the same at every amplitude; the quality factor is $Q = 1/(2\zeta)$.
measured-damping-caption = Damping, with standard errors.
measured-physical-caption = Physical numbers, with standard errors from the fit and from what was measured beside it.

## Loss of amplitude

measured-loss = Loss of amplitude per swing
measured-loss-text = What a swing (half a period) costs tells the laws apart. The same loss at every amplitude, a level row of points, means dry (Coulomb) friction; a straight line through zero viscous (Stokes) friction; a parabola quadratic (Newton) friction. Where several act, their losses add up.
measured-loss-caption = The points come from the turning points of the recording alone: half the difference of two widths from peak to peak, in which the zero of the sensor cancels. The line is the averaged law { $law } with the values of the table above; it is not fitted to the points.
measured-loss-velocity = Since a velocity was recorded, its extremes over $\omega_0$ stand for the amplitudes, which is right as long as a swing loses a small part of its amplitude.
measured-loss-acceleration = Since an acceleration was recorded, its extremes over $\omega_0^2$ stand for the amplitudes, which is right as long as a swing loses a small part of its amplitude; the jump of dry friction at the turning points may shift amplitudes by up to $f$, but not their losses.
measured-loss-none = The recording has too few turning points for a picture of its losses.

## Mixes

measured-mixes = Which mix of laws?
measured-mixes-text =
    { $count ->
        [one] One mix was allowed and fitted.
       *[other] { $count } mixes of laws were fitted. The verdict is the simplest mix that is not rejected; a mix is rejected where one with further laws fits so much better that chance would do this less often than once in a hundred ($p$ < 0.01). AICc and BIC weigh how well a mix fits against its number of parameters: lower is better, and differences below 2 mean little.
    }
measured-mixes-caption = The mixes, by AICc. AICc and BIC are given as differences from the best; $p$ is the probability that chance alone makes a larger mix fit that much better. The residual is the root mean square of what is left.
measured-verdict = { $mix } (verdict)
measured-nearest = { $mix } (simplest not rejected)
measured-head-mix = Mix
measured-head-aicc = ΔAICc
measured-head-bic = ΔBIC
measured-head-rms = Residual
measured-head-p = p
measured-below = < { $value }

## Uncertainty

measured-uncertainty = How sure are the values?
measured-uncertainty-text = The standard errors follow from how fast the sum of squares grows around its minimum, and from the residuals themselves.
measured-uncertainty-effective = Residuals whose neighbours hang together count for less: these { $samples } values tell as much as { $effective } independent ones.
measured-correlations-caption = Correlations of the fitted values. Near 1 or −1 the recording hardly tells two of them apart, and a change of the one is made up for by the other.
measured-correlations-largest = The largest is { $value }, of { $one } and { $other }.
measured-symbol-zero = zero
measured-statistics-caption = Statistics of the fit.
measured-head-statistic = Statistic
measured-head-number = Value
measured-samples = values, n
measured-effective = effective number of values
measured-fitted = fitted parameters
measured-evaluations = evaluations of the model, all mixes
measured-stop = the search ended because
measured-stop-converged = no further step would lower the sum of squares
measured-stop-no-progress = no step lowered the sum of squares any more, though one was expected to
measured-stop-step-limit = the largest number of steps was reached

## What was read

measured-reading = What was read and fitted
measured-reading-caption = The recording and the part of it that was fitted.
measured-head-what = What
measured-head-said = Found
measured-file = file
measured-run = run
measured-values-column = column of values
measured-times-column = column of times
measured-rate = times even, at a rate of
measured-quantity = quantity
measured-unit = unit
measured-unit-none = none given
measured-length = whole recording
measured-length-value = { $from } to { $to }, { $samples } values
measured-rest = rest
measured-rest-value = at { $time }, { $position } from the middle, after { $turns ->
    [one] one turning point
   *[other] { $turns } turning points
}
measured-notes = Notes of the reader:
measured-findings-none = The residuals show no pattern that goes with the motion: nothing speaks against the model.
measured-findings = Patterns in the residuals that go with the motion:
measured-finding-softening = The period grows with amplitude, as a pendulum’s does: the widest swings are slower than the smallest by { $effect }.
measured-finding-hardening = The period falls with amplitude: the widest swings are faster than the smallest by { $effect }.
measured-finding-period-drift = The period drifts, by up to { $effect } of the motion.
measured-finding-losses = The losses of amplitude are those of no mix of the laws, by up to { $effect } of the motion.
measured-finding-growing = The amplitude grows instead of falling; that is up to { $effect } of the motion.
measured-finding-zero-drift = The zero of the sensor drifts, by up to { $effect } of the motion.
measured-finding-shape = The swings have another shape, as of a sensor that is not linear, by up to { $effect } of the motion.
measured-finding-residual = What the fit leaves is far more than the noise from value to value: { $effect } of the widest swing.
measured-grave = { $finding } This is so much that no mix describes the motion.
measured-slight = { $finding } This is little beside the motion; the standard errors take it for noise, and values may be off by more.

## How to read this

measured-method = How to read this
measured-equation = A mass on a spring with viscous, dry and quadratic friction obeys
measured-symbols-omega = $\omega_0$ is the angular frequency without friction; the mass oscillates about the middle, $x = 0$.
measured-symbols-gamma = $\gamma$ is the damping rate of viscous (Stokes) friction, a force $-2m\gamma\dot x$.
measured-symbols-coulomb = $a_c$ is the force of dry (Coulomb) friction over the mass; $f = a_c/\omega_0^2$ is how far it shifts the middle of a swing.
measured-symbols-kappa = $\kappa$ is the rate of quadratic (Newton) friction, a force $-m\kappa|\dot x|\dot x$.
measured-symbols-length = Lengths are in the unit of the recording. With $x$ in volts, $a_c$ is in volts per second squared.
measured-steps = The part of the recording in which the mass swings freely is found, and the turning points in it give a first idea of the coefficients. Then the whole motion, through every reversal and until rest, is fitted by least squares, once for each mix of the three laws. The verdict is the simplest mix that is not rejected, and the residuals are searched for what no mix can explain.
measured-confidence = The standard error says how far a value would typically be off if the experiment were repeated; the 95 % interval holds the true value in 19 of 20 cases, provided the model is right.
