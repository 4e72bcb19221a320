# What was asked for and cannot be had. The folder de holds the same ids with the same variables.

### The command line

cli-missing-recording = A file with a recording is missing, as in federpendel fit recording.csv
cli-no-seed = { $argument } is “{ $value }”; allowed is a whole number from 0 to 18446744073709551615
quantity-or = { $one } or { $other }

### A plan

plan-too-few-swings = Below { $amplitude } fewer than five swings (half periods) remain: not planned.

### What fit takes

fit-sigma-unit = { $name }: --sigma is in { $unit }, the values are in { $found }; allowed is their unit, or a number in it
fit-note-files =
    { $count ->
        [one] { $first } and one more file
       *[other] { $first } and { $count } more files
    }
fit-some-failed = { $failed } of { $all } recordings could not be fitted
physical-help-mass = Mass of the body without the spring: gives forces and the stiffness
physical-help-stiffness = Stiffness of the spring: gives the mass, or is compared with one that is given
physical-help-spring-mass = Mass of the spring, a third of which moves with the body (default: 0)
physical-help-normal-force = Force that presses the body on its guide: gives the coefficients of friction
physical-help-horizontal = The body slides on a level guide: the normal force is its weight
physical-help-gravity = Acceleration of gravity for --horizontal (default: 9.81 m/s^2)
cli-plot-fit = What pictures show: { $plots } (default: fit)
