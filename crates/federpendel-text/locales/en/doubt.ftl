# What makes a fit less sure than its standard errors say.

# $effect: percents, for softening and hardening of the period, else of the motion.
fit-slight-softening = The period grows by { $effect } towards large swings: laws and values may be off by more than their errors.
fit-slight-hardening = The period falls by { $effect } towards large swings: laws and values may be off by more than their errors.
fit-slight-period-drift = The period drifts, by up to { $effect } of the motion: laws and values may be off by more than their errors.
fit-slight-losses = The losses of amplitude are not quite those of any mix, by up to { $effect } of the motion: laws and values may be off by more than their errors.
fit-slight-zero-drift = The zero of the sensor drifts, by up to { $effect } of the motion: laws and values may be off by more than their errors.
fit-slight-shape = The swings have another shape, as of a sensor that is not linear, by up to { $effect } of the motion: laws and values may be off by more than their errors.

# $from, $to: the earliest and the latest time.
fit-rests-between = It is open whether the mass comes to rest as early as { $from } or as late as { $to }.
fit-rests-or-not = It is open whether the mass comes to rest at { $from } or swings on to the end of the fitted part.
