# What only programs say and draw: the page has pictures of its own. The folder de holds the same names with the same variables.

### Pictures

plot-motion-title = Mass on a spring, { $mix }
plot-motion-description = { $title }: displacement over { $duration }, from { $start } at the release, between { $lowest } and { $highest }. The mass { $outcome }.
plot-comparison-description = Dashed beside it: { $name }, between { $lowest } and { $highest }.
plot-phase-title = Phase portrait, { $mix }
plot-phase-description = { $title }: velocity against displacement, from { $position } and { $velocity } at the release; displacements between { $lowest } and { $highest }, velocities between { $slowest } and { $fastest }. The mass { $outcome }.
plot-energy-title = Where the energy is, { $mix }
plot-energy-description = { $title }: stacked areas over { $duration }; their sum is the energy of the release, { $total }. At the end, from top to bottom: { $parts }.
plot-energy-part = { $name } { $energy }
plot-errors-title = Error of the displacement, { $mix }
plot-errors-description = { $title }: distance from the exact motion over { $duration }, on a logarithmic axis. Largest error: { $methods }.
plot-errors-method = { $name } { $error }
plot-largest-error = Largest error
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

### On the command line

output-too-many-points = The record of { $duration } holds about { $number } turning points; a JSON file lists at most { $limit }. Allowed is a shorter duration
article-solutions-file = -solutions
article-hint = -o article.html writes the report; --details tells of every claim here.
fit-laws-alone = --laws names “{ $value }” beside others; it stands alone
fit-laws-refused = --laws names “{ $value }”; allowed are auto, none, stokes, coulomb, newton
fit-pictures-of-one = A picture shows one recording; { $count } were fitted. Choose one, or its --run
fit-heading-models = Mixes, by AICc
fit-heading-all-the-same = The best mix all the same, for comparison
fit-model-row = AICc { $aicc }, BIC { $bic }, rms { $rms }
fit-row-evaluations = evaluations of the model
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
fit-interval = { $value } (95 %: { $interval })

### The report of many recordings

measured-colophon = Made by federpendel { $version }.
measured-title-many = Which friction acts in { $count } recordings?
measured-title-some = Which friction acts in { $count } of { $all } recordings?
measured-not-fitted = Not fitted
measured-lead-one =
    { $adequate ->
        [0] No mix of Stokes, Coulomb and Newton friction describes the one recording that was fitted.
       *[other] A mix of Stokes, Coulomb and Newton friction describes the one recording that was fitted.
    }
measured-lead-many =
    { $adequate ->
        [0] No mix of Stokes, Coulomb and Newton friction describes any of these { $count } recordings.
        [one] A mix of Stokes, Coulomb and Newton friction describes one of these { $count } recordings.
       *[other] A mix of Stokes, Coulomb and Newton friction describes { $adequate } of these { $count } recordings.
    }
measured-summary = Summary
measured-summary-caption = All recordings: the laws that act, with standard errors, or why no mix describes the motion. Where viscous friction does not act alone, damping ratio and quality factor are the equivalent ones from the first amplitude to the last.
measured-head-recording = Recording
measured-brief-mixes = Mixes by AICc, with the difference from the best: { $mixes }.
measured-brief-mix = { $mix } { $difference }
measured-brief-part = Fitted: { $from } to { $to }, { $samples } values ({ $effective } independent ones), column { $column }; residual (rms) { $rms }.
measured-brief-edges = It begins there: { $begins }. It ends there: { $ends }.
