# What was asked for and cannot be had, and what a fit says beside its values. The folder de holds the same ids with the same variables.

### The command line

cli-missing-recording = A file with a recording is missing, as in federpendel fit recording.csv
cli-no-seed = { $argument } is “{ $value }”; allowed is a whole number from 0 to 18446744073709551615
quantity-or = { $one } or { $other }
fit-window-reversed = { $begin } is { $from } and { $end } is { $to }; allowed is a { $begin } before { $end }

### A plan

plan-too-few-swings = Below { $amplitude } fewer than five swings (half periods) remain: not planned.

### The pictures of a fit

plot-residual-axis = Residual

### What was measured beside a recording

physical-bare-number = { $name } has no unit: { $value } is taken.
quantity-uncertainty-large = its uncertainty is more than half of the value, too much to be carried on into other numbers

### The summary of a fit

fit-row-plus-minus = ±
fit-plus-minus = one standard error
physical-hint = --mass and --horizontal add stiffness, D, forces and μ.
