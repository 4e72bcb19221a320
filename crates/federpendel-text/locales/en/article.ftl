# The report on the article: its text. Formulas stand between dollar signs, in the notation of TeX, without braces.

### The whole

article-title = The spring pendulum with friction: an article, checked
article-title-worksheet = The spring pendulum with friction: worksheet
article-title-solutions = The spring pendulum with friction: solutions to the worksheet
article-lead = The German article “Das Federpendel mit verschiedenen Arten von Reibung” (The spring pendulum with different kinds of friction) follows a mass on a spring without friction, with Stokes (viscous), Coulomb (dry) and Newton (quadratic) friction: with formulas where it finds them, with a simple difference scheme elsewhere.
article-lead-report = This report goes through it section by section for one experiment and compares every claim with the motion itself, which is known in closed form without Newton friction and to rounding with it.
article-lead-worksheet = This worksheet goes through it section by section for one experiment.
article-own-values = The article has no numeric example, and the values behind its graphs are not known. For each graph that it mentions there is one of the same kind here, with the values in the table of quantities. Numbers in brackets are the article’s own equation numbers.
article-result = Of the { $checks } claims checked here { $holds } hold and { $fails } fail.
article-result-readings = { $claims ->
        [one] One of these is
       *[other] { $claims } of these are
    } not stated in the article but { $claims ->
        [one] tests
       *[other] test
    } how far it reaches.
article-result-here = { $claims ->
        [one] One is
       *[other] { $claims } are
    } wrong in general but right in number for this experiment.
article-result-open = This experiment cannot tell of { $claims ->
        [one] one claim
       *[other] { $claims } claims
    }.
article-errata = What to correct in the article
article-errata-text = All claims that do not hold, in the order of the article.
article-task = Beside each claim stands what was computed and what to compare it with. Tiny differences such as 10⁻¹⁰ are rounding. Decide: does the claim hold, does it fail, does it only happen to be right for the numbers of this experiment, or can this experiment not tell? Say why.
article-see-claims = Claims that fail, or hold here only
article-colophon = Made by federpendel { $version }. Every number on this page was computed with the values in the table of quantities.
article-head-number = No.
article-head-equation = Equation
article-head-claim = Claim
article-head-verdict = Verdict
article-head-right = Right is

### The experiment

article-experiment = The experiment
article-experiment-text = A mass $m$ on a spring of stiffness $C$ is released at $x_0$ with the velocity $v_0$. Displacements count from where the spring is relaxed; for a hanging mass, from where it hangs at rest.
article-sketch-none = The mass and the force of the spring, without friction.
article-sketch-stokes = The mass in a viscous fluid: the spring pulls it to the middle, friction acts against the velocity.
article-sketch-newton = The mass in a fluid with eddies: friction acts against the velocity and grows with its square.
article-sketch-coulomb = The mass on its guide, on its way back to the middle. Dry friction is drawn where it acts, at the contact with the guide, with the weight and the normal force of the guide.
article-experiment-motion = The motion of this experiment, with all its laws of friction at once ({ $mix }).
article-quantities = Quantities of this report
article-symbols = How to read the numbers beside the claims: max|Δx| is the largest distance from the motion, $t_n$ and $x_n$ are time and place of the $n$-th turning point, $x_N$ is where the mass rests, $A$ the amplitude without friction, n(…) a count, p(…) the order observed: half the step leaves one part in $2^p$ of the error.
article-head-quantity = Quantity
article-head-symbol = Symbol
article-head-value = Value
article-head-origin = Origin
article-origin-given = given
article-origin-built-in = default
article-origin-added = added
article-origin-derived = derived
article-quantity-force = force of dry friction
article-quantity-omega = angular frequency without friction
article-quantity-period = period without friction
article-quantity-offset = offset of the middle
article-quantity-rate = damping rate
article-quantity-drag-rate = rate of Newton friction
article-quantity-thrown = initial velocity, where the article has one
article-quantity-displaced = displacement, where the article has one
article-lacks = The experiment has no { $laws }. The sections on it use a default value, marked so in the table.
article-faint = The { $laws } of the experiment is so weak that nothing of it would be seen. The sections on it use a default value, marked so in the table.
article-added-velocity = The experiment is released from rest, or nearly so. Where the article lets the mass start with a velocity, { $velocity } is taken here, once against the displacement and once along it.
article-built-in-release = The experiment leaves the mass at rest in the middle, where nothing moves. Everywhere in this report it is released at { $position } instead.
article-added-position = The experiment starts in the middle, or near it. Where the article releases a displaced mass, { $position } is taken here, the amplitude without friction.
article-pressed = The force on the guide is given: where the article writes $\mu m g$, this report has $\mu F_N$.
article-law-stokes = Stokes friction
article-law-coulomb = Coulomb friction
article-law-newton = Newton friction

### 1 Without friction

article-undamped = 1 Without friction
article-undamped-text = Newton’s second law with Hooke’s spring gives the equation of motion. The article solves it twice.
article-trigonometric = 1.1 First route: cosine and sine
article-trigonometric-text = Two functions return to themselves, but for the sign, after two derivatives: cosine and sine. Each solves (3) if $\omega_0$ has the value (16), and so does their sum, whose two constants follow from the release.
article-exponential = 1.2 Second route: exponentials
article-exponential-text = The standard attempt for linear equations is an exponential. It leads to an equation for $\lambda$ with two imaginary roots, and Euler’s formula brings the sum of both solutions back to cosine and sine.
article-undamped-figure = Both routes to the solution, (20) and (25), drawn over the motion without friction; below, their distance from it. Released at $x_0$ = { $position } with $v_0$ = { $velocity }.
article-name-20 = (20)
article-name-25 = (25)

### 2 Stokes

article-stokes = 2 Stokes friction
article-stokes-text = In a fluid that flows without eddies friction grows in proportion to the velocity, with the damping $D$. The equation stays linear, and the theory of linear equations applies as it stands.
article-stokes-analytic = 2.1 Analytic solution
article-stokes-roots-text = The exponential leads to the characteristic equation. Its roots decide how the mass moves.
article-stokes-roots-figure = The roots (36) in the complex plane as $D$ grows from zero. Below critical damping they are a conjugate pair on the circle of radius $\omega_0$; they meet on the real axis at $-\omega_0$ and then part along it. Those of this experiment are marked.
article-stokes-solution-text = Below critical damping the roots are $-\gamma \pm i\omega$, and the solution is an oscillation under an exponential. The article names the two other cases and does not pursue them; here they are drawn as well.
article-stokes-regimes-figure = The same mass on the same spring, released in the same way, below, at and above critical damping.
article-stokes-regime-below = below: γ = { $ratio } ω₀
article-stokes-regime-critical = critical: γ = ω₀
article-stokes-regime-above = above: γ = 2 ω₀
article-stokes-numeric = 2.2 Numeric solution
article-stokes-scheme-text = For the scheme the derivatives are replaced by difference quotients on a grid with the step $\Delta t$. Solved for the newest position they give a recursion, which needs one more position to start from. Throughout this report $\Delta t$ is about a thousandth of the period, chosen so that no turning point falls on a step.
article-stokes-figure = The motion with Stokes friction, the formula (46) and the scheme (51) with $\Delta t$ = { $step }; below, their distance from the motion. Released at $x_0$ = { $position } with $v_0$ = { $velocity }.
article-name-46 = formula (46)
article-name-51 = scheme (51)

### 3 Coulomb

article-coulomb = 3 Coulomb friction
article-coulomb-text = Dry friction has the same strength at every speed and acts against the velocity. The equation of motion is linear between two turning points only, since its right side changes sign at each of them.
article-coulomb-scheme = 3.1 Numeric solution
article-coulomb-scheme-text = The article first looks at what the scheme makes of a release from rest, and takes from the graph that the amplitude falls linearly.
article-coulomb-scheme-figure = A release from rest with Coulomb friction: the motion and the scheme (59) with $\Delta t$ = { $step }; below, its distance from the motion.
article-name-59 = scheme (59)
article-coulomb-rest = 3.2.1 Analytic solution for a release from rest
article-coulomb-energy-text = If friction leaves the frequency alone, the solution should be a cosine whose amplitude falls at a constant rate $v_A$, (61). The rate follows from an energy argument: on the way from one turning point to the next, friction does as much work as the spring loses energy.
article-coulomb-energy-sketch = The energy argument with the numbers of this experiment: from $x_0$ to the turning point $x_1$ on the other side, half a period later.
article-coulomb-energy-mirrored = Magnitudes are drawn; here the motion begins on the other side.
article-coulomb-envelope-figure = The motion between its envelopes, with its turning points and the sticking band: where $|C x| \le \mu_s F_N$ a turning point holds the mass for ever.
article-coulomb-formula-text = With the loss per half period (67) the article writes out the rate, (68), and inserts it, (69).
article-coulomb-right-text = Right is, from turning point to turning point, as long as the mass does not stick ($x_0>0$, $n$ swings after the release):
article-coulomb-figure = Release from rest: the motion, formula (69) as printed, the same with the rate $\Delta x/(T/2)$, and the scheme (59); below, their distances from the motion.
article-name-69 = (69), printed
article-name-61 = (61) with v_A = Δx/(T/2)
article-coulomb-thrown = 3.2.2 Analytic solution for any release
article-coulomb-thrown-text = For a release with a velocity the article writes the solution without friction as one sine with the amplitude $A$ and the phase $\varphi$, and lets the amplitude fall as before.
article-coulomb-forward-figure = Release at $x_0$ = { $position } with $v_0$ = { $velocity }: the motion, (79) as printed, (78) with the phase in the right quadrant and the rate $\Delta x/(T/2)$, and the scheme (59); below, their distances from the motion.
article-name-79 = (79), printed
article-name-78 = (78) with v_A = Δx/(T/2)
article-coulomb-stuck = Dry friction is so strong here that the mass stays where it is released: the graphs of a release from rest show a level line.

### 4 Newton

article-newton = 4 Newton friction
article-newton-text = In a fluid with eddies friction grows with the square of the velocity; $\rho$ is the density of the fluid, $c_w$ the drag coefficient and $A$ the area that meets the flow.
article-newton-sketch = The mass in the fluid, as seen from the mass: the fluid meets the area $A$ with the velocity $v$, and friction acts along the flow, that is against the motion of the mass.
article-newton-scheme-text = The article keeps to the scheme and supposes that a series might lead to an analytic solution.
article-newton-known-text = Two things can be added. Between two turning points a first integral gives the speed at every position, and with it the next turning point in closed form, by Lambert’s function $W$. And the series is carried out: position against time is known to rounding.
article-newton-figure = The motion with Newton friction and the scheme (85) with $\Delta t$ = { $step }; below, its distance from the motion. Released at $x_0$ = { $position } with $v_0$ = { $velocity }.
article-name-85 = scheme (85)
article-newton-decrement-figure = What each swing loses, against its mean amplitude.

### Which friction is it?

article-which = Which friction is it?
article-which-text = Three masses, released alike, each with one law of friction. All three curves look like a fading oscillation. What tells the laws apart is what a swing loses: under Coulomb friction always the same, under Stokes friction a fixed share of the amplitude, under Newton friction a share that itself grows with the amplitude.
article-which-motions-figure = Three motions, one law of friction each.
article-which-losses-figure = The decrement plot of the same three motions: loss of amplitude per swing against mean amplitude. Coulomb friction is a level line (intercept $2f$), Stokes friction a straight line through zero (slope $\pi\gamma/\omega_0$), Newton friction a parabola through zero (curvature $4\kappa/3$). A mix is the sum of these.
article-which-losses-blank-figure = The same three motions: loss of amplitude per swing against mean amplitude.
article-which-table = How the laws differ
article-which-head-law = Law
article-which-head-loss = Loss per swing
article-which-head-decay = Decay of the amplitude
article-which-head-measured = First swing here
article-which-linear = linear, ends at rest
article-which-exponential = exponential
article-which-hyperbolic = hyperbolic

### How wrong is the simple scheme?

article-scheme = How wrong is the simple scheme?
article-scheme-order-text = Halve the step: a method of second order then leaves a quarter of its error, one of first order half. The central quotient (49) is of second order, the backward quotient (48) of first order only. Dry friction adds something: in general no reversal falls on a step, and in the step that holds one, friction acts in the wrong direction for a while.
article-scheme-order-title = Largest error of the scheme against the step
article-scheme-order-figure = Largest error of the scheme against the step, without friction and with each law, over six halvings.
article-scheme-name-none = no friction
article-scheme-name-stokes = Stokes
article-scheme-name-coulomb = Coulomb
article-scheme-name-newton = Newton
article-scheme-table = Order of the scheme
article-scheme-head-friction = Friction
article-scheme-head-order = Order observed
article-scheme-head-error = Largest error, shortest step
article-scheme-rest-text = In the scheme, friction has no value at rest, since sign(0) = 0. It cannot hold the mass: where the mass sticks, the scheme’s velocity changes sign from step to step, and the position creeps to the middle. Moreau–Jean time stepping does not compute friction from the velocity before the step; it asks which friction, within its limits, brings the velocity to zero at the end of the step, and lets the mass stick if there is one.
article-scheme-rest-figure = After coming to rest, enlarged: the motion, the article’s scheme and Moreau–Jean time stepping, all with $\Delta t$ = { $step }.
article-scheme-rest-table = After coming to rest
article-scheme-head-method = Method
article-scheme-head-place = Position at { $time }
article-scheme-head-rests = Rests
article-scheme-head-creep = Creep
article-scheme-motion = the motion
article-scheme-own = article’s scheme
article-scheme-moreau = Moreau–Jean
article-yes = yes
article-no = no


