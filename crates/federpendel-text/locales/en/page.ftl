# What the page says. The folder de holds the same names with the same variables.

page-title = Mass on a spring, with friction
page-skip = Skip to the content
page-language = Language
page-theme = Colours
page-theme-system = as the system
page-theme-light = light
page-theme-dark = dark
page-link = Copy link
page-link-copied = The link to this experiment has been copied.
page-link-in-address = The address of this page now leads to this experiment.
page-link-of-file = The link has been copied. It leads to this file on this device; who has the file elsewhere opens it there and adds the part from the sign # on.
page-link-broken = The end of the address is no experiment that this page can read; it shows another one.
page-print = Print
page-footer = All numbers are computed on this page by federpendel. Nothing leaves your device.

## The experiment

page-experiment = Experiment
page-preset = Example
page-preset-own = your own
page-body = Mass and spring
page-place = How the mass moves
page-lying = lying
page-hanging = hanging
page-friction = Friction
page-critical = Set critical damping
page-release = Release
page-whole-motion = Show the whole motion

## The scene

page-stage = The motion
page-scene-description = A mass on a spring, drawn to scale
page-mass-handle = Mass: displacement at the release
page-scene-hint = Drag the mass and let it go, or throw it.
page-scene-keys = Arrow keys move the mass, with Shift in small steps; Enter lets it go.
page-sticks = sticks
page-force-spring = Spring
page-force-weight = Weight
page-force-sum = Sum
page-forces = Forces
page-play = Play
page-pause = Pause
page-restart = Release again
page-previous-turning-point = Back to the turning point before
page-next-turning-point = On to the next turning point
page-speed = Speed
page-time = Time
page-released = Released at { $position } with { $velocity }.
page-at-rest = The mass has come to rest at { $position }, after { $time }.
page-at-end = The record ends at { $time } and begins anew.
page-stands = At { $time } the mass is at { $position }.
page-calm = As you prefer little motion, the picture jumps to the next turning point; Play shows the motion itself.
page-energy-hanging = Potential (spring and weight)

## The plots

page-plots = Plots
page-plots-shown = Which plots are shown
page-show-motion = Displacement
page-show-phase = Phase portrait
page-show-energy = Energy
page-show-decrement = Loss of amplitude
page-plot-motion = Displacement against time
page-plot-phase = Phase portrait
page-plot-energy = Where the energy is
page-plot-energy-mean = Where the energy is, averaged over each period
page-plot-energy-description = Kinetic and potential energy and the heat of each kind of friction as areas on top of each other; their sum stays the energy of the release.
page-plot-decrement = Loss of amplitude per swing
page-plot-decrement-description = What each swing costs, against its mean amplitude: Coulomb friction is the intercept, Stokes friction the slope, Newton friction the curvature.
page-plot-no-swings = No swing: the mass does not turn round twice
page-plot-still = The mass does not move
page-plot-keys = Plus and minus zoom, arrow keys move the picture, 0 shows all.
page-plot-hint = Drag to enlarge a part, with Shift to move it; two fingers or Ctrl and the wheel zoom; a double click shows all.
page-plot-hint-touch = One finger moves the picture, two enlarge it; a double tap shows all.
page-zoom-in = Zoom in
page-zoom-out = Zoom out
page-zoom-all = Show all
page-save = Save
page-csv = CSV
page-csv-german = CSV with semicolons
page-energies = kinetic { $kinetic }, potential { $potential }, heat { $heat }
page-swing = Swing { $number }: amplitude { $amplitude }, loss { $loss }
page-keep = Keep this curve
page-forget = Remove { $curve }

## The numbers

page-numbers = Numbers
page-number = No.
page-known-as = Known as
page-point-time = t in s
page-point-position = x in m
page-rest-time = At rest after
page-rest-position = At rest at

## The error lens

page-lens = How good is the formula, how good is the scheme?
page-lens-text = Choose a formula of the article or a numeric scheme: its motion stands beside the right one, and below it how far it is off.
page-method = Method
page-formulas = Formulas of the article
page-schemes = Numeric schemes
page-plot-method = { $method } beside the motion
page-plot-error = Error of { $method }
method-article-printed = Formula as printed
method-article-corrected = Formula, corrected
method-article-scheme = Difference scheme of the article
method-symplectic-euler = Euler, symplectic
method-verlet = Verlet
method-verlet-located = Verlet with exact reversals
method-rk4 = Runge–Kutta
method-rk4-located = Runge–Kutta with exact reversals
method-rk4-tanh = Runge–Kutta with smoothed friction
method-dopri5 = Dormand–Prince
method-dopri5-located = Dormand–Prince with exact reversals
method-moreau-jean = Moreau–Jean

## The recording

page-recording = Which friction acts in my recording?
page-recording-text = The file stays on your device. The page finds the free decay in it, fits all mixes of the three kinds of friction and says which act.
page-drop = Drop a recording here, or
page-choose-file = Choose a file
page-file-kinds = Excel (.xlsx, .xls) or text (.csv, .txt, alone or in a .zip) from phyphox, Tracker, PASCO Capstone, Vernier, or any other table with a column of times
page-class-mode = For the class: hide the verdict until asked
page-fitting = Fitting { $name } …
page-fit-fault = { $name } brought the fit to a fault of its own, not of yours; the program federpendel may do better.
page-fitted = { $name } has been fitted.
page-run = Run
page-reveal = Show the verdict
page-verdict-hidden = The recording is fitted. Which friction do you see? The loss of amplitude per swing gives it away.
page-overlay = Lay the simulated motion over it
page-simulated = Simulated
page-simulate-fit = Simulate the fitted motion
page-report-footer = Fitted by federpendel, saved on { $date }.
page-report = Save the report
page-plot-recording = Recording
page-plot-residuals = What the fit leaves
page-drop-now = Let go: the file is fitted.
page-first-of-many = { $count } files at once: the first is fitted, { $name }.
page-folder = { $name }: that is a folder; allowed is a file with a recording.
page-unreadable = { $name }: the file cannot be read; it may have been moved, locked, or be too large.
page-cancel = Cancel
page-cancelled = { $name }: the fit was cancelled.
page-asked = About the experiment
page-asked-text = None of this is needed. With the mass of the body or the stiffness, damping and forces follow; with the force on the guide, coefficients of friction.
page-as-found = as found
page-support-unknown = none or unknown
page-support-horizontal = level: its weight presses
page-support-force = a known force presses
asked-unit = Unit of the values
asked-rate = Sampling rate
asked-table = Table
asked-from = Beginning of the fitted part
asked-to = End of the fitted part
asked-mass = Mass of the body
asked-stiffness = Stiffness of the spring
asked-spring-mass = Mass of the spring
asked-support = Guide
asked-normal-force = Force on the guide
page-fit-shown = Fit only the part shown
page-fit-whole = Find beginning and end again
page-no-simulation-unit = To simulate the fitted motion the unit of its lengths is missing: give the unit of the values under “About the experiment”, such as cm.
page-no-simulation-angle = This motion cannot be simulated here: the recording holds angles, and the mass of the scene moves along a line.
page-simulating = The scene shows the fitted motion now.
page-details = Details
