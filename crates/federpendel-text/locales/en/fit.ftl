# What is said of recordings and their fits. The folder de holds the same ids with the same variables.

### Recordings that are refused; file and line stand before the sentence

recording-line = line { $line }
recording-allowed = a table of times and values: text (.csv, .txt) alone or in a .zip, or an Excel workbook (.xlsx, .xls)
recording-empty = nothing stands in the file, or in its table; allowed is { $allowed }
recording-no-table = this is { $found }; allowed is { $allowed }
recording-no-table-text = this is { $found } (“{ $text }”); allowed is { $allowed }
recording-too-large = unpacked this has { $bytes } bytes or more; allowed are { $most }
recording-long-line = the line has more than { $most } bytes; allowed is a table with each measurement in a line of its own
recording-password = a password locks this workbook; allowed is one without: open it in its program and save it without a password
recording-damaged = the file cannot be opened (its reader says: { $reason }); allowed is an archive or a workbook that is whole
    .page = The file cannot be opened; allowed is an archive or a workbook that is whole
recording-several-tables = the file holds several tables and none is named (--table); allowed are { $tables }
    .page = The file holds several tables; choose one of them: { $tables }
recording-no-tables = the file holds no table; allowed is a .zip with a .csv, .txt, .tsv, .dat, .asc or .lvm in it, or a workbook with a sheet of numbers
recording-no-named-tables = the table asked for is “{ $asked }”, but this file holds none with a name; allowed is to ask for none
recording-table-not-found = the table asked for is “{ $asked }”; allowed are { $tables }
recording-too-many-columns = the table has { $found } columns or more; allowed are { $most } at most
recording-no-rows = nothing stands below the header “{ $header }”; at least { $least } rows of numbers are needed
recording-header-cells = this header has { $found } cells, the rows below it { $expected }; allowed are as many
recording-commas = the commas in “{ $text }” may stand between columns or be decimal signs; allowed is a tab or semicolon between columns, or a header with a cell for each column
recording-cells = this row has { $found ->
    [one] one cell
   *[other] { $found } cells
}, the table { $expected ->
    [one] one column
   *[other] { $expected } columns
}; allowed are as many, and decimal commas only where no commas stand between cells
recording-no-number = the column “{ $column }” holds “{ $value }”; allowed is a number with a decimal { $sign ->
    [comma] comma
   *[point] point
} and without thousands separators
recording-out-of-range = the column “{ $column }” holds “{ $value }”; allowed is a number of at most { $most } in magnitude
recording-column-not-found = the column asked for as { $field } is “{ $asked }”; allowed are { $columns }, or their numbers
recording-column-ambiguous = the column asked for as { $field } is “{ $asked }”, which fits { $columns }; allowed is a name that fits one of them, or its number
recording-field-time = time
recording-field-value = value
recording-run-not-found = the run asked for is “{ $asked }”; allowed are { $runs }
recording-no-runs = the run asked for is “{ $asked }”, but this file has no runs with a name; allowed is to ask for none
recording-no-time = none of the columns { $columns } is known to hold the times; one of them must be named, or a rate given (--time, or --rate)
    .page = None of the columns { $columns } is known to hold the times; choose one of them, or give a sampling rate
recording-time-unit = the column “{ $column }” is in “{ $unit }”; allowed for a time are { $allowed }
recording-no-value = none of the columns { $columns } is known to hold values; needed is one of numbers besides the times, or one that is named
recording-quantity-unit = the column “{ $column }” is in “{ $unit }”; allowed for { $quantity } are { $allowed } and the like
recording-quantity-position = a position
recording-quantity-velocity = a velocity
recording-quantity-acceleration = an acceleration
recording-rate = the rate is { $value }; allowed is { $allowed }
recording-rate-and-time = --rate and --time (“{ $time }”) are both given; allowed is one of them
    .page = A sampling rate and a column of times (“{ $time }”) are both given; allowed is one of them
recording-value-unit = --unit is “{ $asked }”; allowed are units of a position (m, cm, mm, rad, °), of a velocity (m/s, rad/s, …) and of an acceleration (m/s², g, …)
    .page = The unit of the values is “{ $asked }”; allowed are units of a position (m, cm, mm, rad, °), a velocity (m/s, rad/s, …) and an acceleration (m/s², g, …)
recording-too-few-rows = the recording has { $rows ->
    [one] one row
   *[other] { $rows } rows
} with time and value, at different times; at least { $least } are needed
recording-starts-over = the time { $value } follows { $before } here, where another recording begins; allowed is one recording
recording-constant-time = the column “{ $column }” is { $value } in every row; allowed are times that rise
recording-constant-value = the column “{ $column }” is { $value } in every row (in SI units, if its unit is known); allowed are values that change

### What a file is instead of a table

found-binary = no text
found-picture = a picture
found-pdf = a PDF document
found-gzip = a file packed by gzip, which must be unpacked first
found-media = a sound or a film
found-hdf5 = a file of HDF5 or MATLAB
found-xml = XML or HTML, perhaps a project of Tracker or Logger Pro, from which a table can be exported
found-json = JSON
found-prose = text without rows of numbers

### What was assumed, left out and put in order in a recording

recording-note-time = No header names the time; the first column, which rises, is taken for it.
recording-note-time-unit = The file gives the time no unit; seconds are assumed.
recording-note-time-ignored = The column “{ $column }” of times is not read, since a rate is given.
recording-note-quantity = Neither unit nor name say what was recorded; a position is assumed.
recording-note-name = By its name the column of values holds { $quantity }, by its unit it does not; the unit counts.
recording-note-cut-off = The last line, { $line }, ends too early and is left out.
recording-note-missing =
    { $count ->
        [one] One row lacks time or value and is left out: line { $line }.
       *[other] { $count } rows lack time or value and are left out, the first of them line { $line }.
    }
recording-note-sorted =
    { $count ->
        [one] The time falls once, in line { $line }; all rows are sorted by time.
       *[other] The time falls { $count } times, first in line { $line }; all rows are sorted by time.
    }
recording-note-averaged =
    { $count ->
        [one] One row, line { $line }, has the time of another; the mean of their values stands.
       *[other] { $count } rows, the first of them line { $line }, have the time of another; the mean of their values stands.
    }
recording-note-gaps =
    { $count ->
        [one] The times have a gap of { $longest } before line { $line }; { $usual } is usual.
       *[other] The times have { $count } gaps of up to { $longest }, the first before line { $line }; { $usual } is usual.
    }
recording-note-run = The run “{ $run }” is left out: { $reason }.
recording-note-nameless-run = A run without a name is left out: { $reason }.

### Recordings to which nothing can be fitted; the file stands before the sentence

fit-refused-length = the recording has { $times } times and { $values } values; allowed are as many
fit-refused-too-few = from { $from } to { $to } the recording has { $found ->
    [one] one value
   *[other] { $found } values
}; at least { $needed } are needed
fit-refused-time = time number { $number } is { $value }; allowed is a finite number greater than the time before
fit-refused-value = value number { $number } is { $value }; allowed is { $allowed }
fit-refused-option = { $name } is { $value }; allowed is { $allowed }
fit-refused-still = from { $from } to { $to } all values are the same; allowed is a part in which the mass moves
fit-refused-no-oscillation = from { $from } to { $to } nothing swings: the values show no more than noise or a ramp; allowed is a part with at least a few swings
fit-refused-no-fit = from { $from } to { $to } no motion of a mass on a spring can be fitted; allowed is a part in which it swings freely

### Why the fitted part begins or ends where it does

fit-edge-recording = as the recording does
fit-edge-given = as asked for
fit-edge-held = before this the mass was held, or lay still
fit-edge-driven = before this something else moved the mass: its swings were growing
fit-edge-misfit = the values before this do not belong to the motion that follows
fit-edge-still = after this the mass lies still
fit-edge-disturbed = after this something else moves the mass
fit-edge-unrest = after this swings no longer shrink: something else keeps the mass in motion, as the ground does
fit-edge-stopped = after this the swings are gone all of a sudden: a hand or the like stopped them
fit-edge-clipped = before this the sensor clips the swings

### What was found in a recording

fit-law-stokes = Viscous (Stokes) friction
    .inside = viscous (Stokes) friction
fit-law-coulomb = Dry (Coulomb) friction
    .inside = dry (Coulomb) friction
fit-law-newton = Quadratic (Newton) friction
    .inside = quadratic (Newton) friction
fit-acts-none = No friction shows in this recording.
fit-acts-growing = In this recording the amplitude grows instead of falling: something feeds the mass with energy, and no friction shows.
fit-acts-alone = { $law } acts: { $value }
fit-open = The recording leaves open which mix acts: { $mixes }.
fit-physically = In physical numbers: { $values }.
fit-regime-strong = The damping is strong: its ratio is { $ratio }.
fit-regime-overdamped = The motion is overdamped: the damping ratio is { $ratio }.
fit-regime-critical = The damping is near critical: its ratio is { $ratio }.
fit-dominates = { $law } dominates: { $value }, { $share } of the lost energy
fit-leads = { $law } acts: { $value }, { $share } of the lost energy
fit-acts-too = { $law } acts as well: { $value } ({ $surely }{ $share })
fit-asked = Fitted as asked: { $values }.
fit-asked-none = Fitted as asked, without friction.
fit-and = { $one } and { $other }
fit-or = { $one } or { $other }
fit-not-needed =
    { $number ->
        [one] { $laws } is not needed.
       *[other] { $laws } are not needed.
    }
fit-cannot-separate = To tell { $one } from { $other }, release from at least { $amplitude }.
fit-never-separates = Larger amplitudes would not tell { $one } from { $other } either.
fit-no-mix = No mix describes this recording
fit-not-this-mix = This mix does not describe this recording
fit-not-undamped = An undamped motion does not describe this recording
fit-asked-rejected = This mix is rejected: with further laws the fit leaves so much less that chance would do this less often than once in a hundred. A fit without a choice of laws tells which.
fit-wrong-softening = { $said }: the period grows with amplitude, as for a pendulum at large angles (a softening spring).
fit-wrong-hardening = { $said }: the period falls with amplitude (a hardening spring).
fit-wrong-period-drift = { $said }: the period drifts.
fit-wrong-losses = { $said }: the losses of amplitude are those of no mix of the three laws.
fit-wrong-losses-asked = { $said }: its amplitude falls in another way.
fit-wrong-growing = { $said }: its amplitude grows instead of falling; something feeds the mass with energy.
fit-wrong-zero-drift = { $said }: the zero of the sensor drifts.
fit-wrong-shape = { $said }: the swings have another shape, as of a sensor that is not linear.
fit-wrong-residual = { $said }: the fit leaves far more than the noise of the sensor.
fit-wrong = { $said }.
fit-rests = The mass comes to rest at { $time }.
fit-rests-early = The mass comes to rest at { $time }: one swing before that tells only how strong dry friction is at least.
fit-caution-part = Only the part from { $from } to { $to } was fitted: { $why }.
fit-caution-swings = That rests on { $number } swings (half periods) only: verdicts on fewer than five often err.
fit-caution-one-swing = That rests on one swing (half period) only: verdicts on fewer than five often err.
fit-caution-values = With { $number } values in a swing (half a period) much of the motion goes unseen: record faster.
fit-clipped = The values stop at { $levels } at { $count } turning points: the sensor clips there. { $helps }
fit-clipped-left-out = Only what follows, from { $time } on, was fitted.
fit-clipped-later = Begin later, with { $flag } "{ $time }", or measure smaller swings.
fit-clipped-smaller = Measure smaller swings.
fit-caution-outliers =
    { $count ->
        [one] One value lies far off the others and sways the fit: --loss tukey leaves it aside.
       *[other] { $count } values lie far off the others and sway the fit: --loss tukey leaves them aside.
    }
    .page = { $count ->
        [one] One value lies far off the others and sways the fit: the program federpendel can leave it aside.
       *[other] { $count } values lie far off the others and sway the fit: the program federpendel can leave them aside.
    }
