# What was asked for and cannot be had, and what a fit says beside its values. The folder de holds the same ids with the same variables.

### The command line

cli-missing-recording = A file with a recording is missing, as in federpendel fit recording.csv
cli-no-seed = { $argument } is “{ $value }”; allowed is a whole number from 0 to 18446744073709551615
quantity-or = { $one } or { $other }
fit-window-reversed = --from is { $from } and --to is { $to }; allowed is a --from before --to
