# What only the command line says. The folder de holds the same ids with the same variables.

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
cli-file-without-command = { $file } is a file, and a command must stand before it, as in federpendel { $command } { $file }
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

summary-given-row = given
summary-friction = friction
summary-period-value = { $period } (frequency { $frequency })
summary-period-small-value = { $period } at small amplitude (frequency { $frequency })
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
summary-point-time = t in s
summary-point-position = x in m
summary-deviation = { $method } is up to { $distance } away from that motion, most at { $time }.
summary-agrees = { $method } agrees with that motion to rounding.
summary-method-equation = { $method }, equation { $equation }
summary-method-overdamped = { $method }, the article’s solution for overdamped motion
summary-method-critical = { $method }, the article’s solution for critical damping
summary-method-steps = { $method }, steps of { $step }
summary-method-interpolated = { $method }, steps of { $step }; samples between steps are interpolated
cli-dt-without-scheme = --dt is “{ $value }”, but the method is { $method }; a time step is allowed only with --method article-scheme
cli-temporary-folder = the folder for temporary files, { $folder } (TMPDIR)
cli-not-found = no such file or folder
cli-permission-denied = permission denied
cli-is-a-folder = this is a folder, not a file
cli-is-no-folder = a part of this path is a file, not a folder
cli-name-too-long = this name is too long or holds a sign that the system does not allow
cli-storage-full = no space left on the device
cli-read-only = this file system can only be read
step-unstable = a time step of { $step } is too long: with it the scheme is unstable and runs away from the motion. It is stable below { $longest }; safe is --dt "{ $proposed }"
step-coarse = a time step of { $step } is too long for this record: the error of the scheme has become larger than the motion. Try --dt "{ $proposed }" or a shorter record
cli-warning = warning
summary-energy-values = { $initial } at release; at the end of the record { $left } ({ $motion }), { $other } ({ $method })
summary-heading-of = { $heading } ({ $whose })
summary-margin-tie = on the edge, within rounding
summary-margin-distance = { $distance } from its edge

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

### Recordings

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

### The page

cli-serve = Show the page: drag the mass, see the plots, fit a recording; nothing leaves this machine
cli-serve-examples =
    Examples:
      federpendel serve
      federpendel serve --port 8080 --no-open
cli-serve-port = Port to listen on; any that is free by default
cli-serve-no-open = Leave the browser closed
serve-address = The page is at { $address }; Ctrl+C ends it.
serve-no-page = this program has been built without the page; with Node and npm, web/build makes it, and cargo run --release --features page -- serve shows it
serve-no-port = --port is { $value }; allowed is a whole number from 1 to 65535
serve-port-taken = --port is { $port }, which cannot be listened on: { $problem }
serve-no-browser = No browser could be opened; open the address in one.
