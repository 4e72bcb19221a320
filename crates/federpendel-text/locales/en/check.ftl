# The article’s claims in other words, and what was found of each: check-ID, and an attribute for each verdict.
# Every sentence is true of all experiments with that verdict; the numbers stand beside it.

-no-swing = Dry friction holds the mass where it is released, so that there is no swing.
-no-motion = The mass does not move, so that there is no friction to measure.
-no-oscillation = At this damping, $\gamma\ge\omega_0$, the mass does not oscillate: there is no angular frequency $\omega$, and the article’s solution for $\gamma<\omega_0$ does not apply.
-runs-away = With friction this strong the scheme runs away at its usual step, so that it gives no positions to compare.
-too-many-steps = Dry friction is so weak here that the scheme would take more steps to the end of the motion than are computed.
-no-order = No order can be read off: at one of the steps tried, at least, the scheme runs away or shows no error.
-weak-for-order = Friction is so weak here that its share of the error does not show at the steps tried.
-goes-on = The mass comes to rest and sticks, whereas the formulas go on: a linearly falling amplitude passes through zero and from there grows without bound.
-third-side = takes the third side of (68) for $v_A$, which has a factor $C$ too many. Right is $v_A=2f\omega_0/\pi$ with the offset $f=\mu F_N/C$.
-one-newton-per-metre = Here that does not show in the number, because $C$ has the value 1 in N/m.

## Section 1: no friction

check-harmonic = With $\omega_0^2=C/m$ the cosine, the sine and every sum of multiples of the two solve the equation of motion (3).
    .holds = What remains is the error of a second derivative formed numerically.
check-angular-frequency = The angular frequency of the motion without friction follows from $\omega_0^2=C/m$.
    .holds = Only the positive root counts as angular frequency; the ± in (8) and (16) can be dropped.
check-constants = The initial conditions fix the two constants: $C_1=x_0$ and $C_2=v_0/\omega_0$.
check-general-solution = (20) is the motion without friction for every release.
check-imaginary-roots = The exponential ansatz solves (3) with the two imaginary values $\lambda=\pm i\omega_0$.
check-both-routes = The sum of two complex exponentials (25) is real and describes the same motion as (20).
check-chain-25-27 = Euler’s formula turns (25) into (26), and sorting by cosine and sine gives (27).
check-lost-factor = On the way from (27) to (28) the constant of the sine is $C_2=\tilde C_1-\tilde C_2$.
    .fails = The brace leaves out the factor $i$ that stands in front of it; the difference alone is imaginary. With $C_2=i(\tilde C_1-\tilde C_2)$ the constant is real and equals $v_0/\omega_0$.
    .holds-here = The brace leaves out the factor $i$ that stands in front of it. Here that makes no difference, because the initial velocity, and with it the constant, is zero to rounding.

## Section 2.1: Stokes friction

check-only-linear = Of the three laws of friction only Stokes’ leaves the equation of motion linear.
    .holds = Twice the displacement and twice the velocity at the release make twice the motion with Stokes friction, but not with the other two.
    .not-applicable = This experiment cannot show that the equations with dry and with Newton friction are not linear.
check-stokes-force = The force of Stokes friction is proportional to the velocity, with the constant $D$.
check-characteristic-roots = The two values (36) are the roots of the characteristic equation (35).
check-oscillates-below-critical = The mass swings to and fro only where the discriminant $D^2/(4m^2)-\omega_0^2$ in (36) is negative.
    .holds = Released from rest it turns again and again for $\gamma<\omega_0$, and never at or above critical damping. Strictly periodic, as the article has it, this motion is not either, since its amplitude falls.
check-conjugate-roots = Below critical damping the roots are $-\gamma\pm i\omega$, with $\gamma$ and $\omega$ of (41).
    .not-applicable = { -no-oscillation }
check-complex-form = Below critical damping the two complex exponentials (38) can be written as the real solution (40).
    .not-applicable = { -no-oscillation }
check-damped-constants = The initial conditions fix the constants of (40): $C_1=x_0$ and $C_2=(v_0+\gamma x_0)/\omega$.
    .not-applicable = { -no-oscillation }
check-derivative = (43) is the derivative of (40) with respect to time.
    .not-applicable = { -no-oscillation }
check-damped-solution = Below critical damping (46) is the motion with Stokes friction for every release.
    .not-applicable = { -no-oscillation }
check-frequency-lowered = Stokes friction lowers the angular frequency from $\omega_0$ to the $\omega$ of (37).
    .not-applicable = { -no-oscillation }
check-exponential-decay = With Stokes friction the amplitude falls exponentially with time.
    .holds = Every turning point is the same share of the one before.
    .not-applicable = The damping is critical, above it or only just below: there are no turning points to compare.
check-overdamped-solution = Where the discriminant in (36) is positive, a sum of two real exponentials solves (30).
check-critical-solution = Where the discriminant in (36) is zero, an exponential and $t$ times the same exponential together solve (30).

## Section 2.2: difference quotients

check-quotient-orders = The difference quotients (48) and (49) are suitable in place of the derivatives, which is taken here to mean that both are of second order.
    .fails = The central quotient (49) is of second order, but the backward quotient (48) only of first: half the step only halves its error. A central quotient over two steps would be of second order for the velocity as well.
check-recursion-stokes = (51) is the discretised equation (50), solved for the next position.
    .not-applicable = { -runs-away }
check-scheme-order-stokes = The scheme (51) is suitable for Stokes friction, which is taken here to mean that it is of second order with friction and without.
    .fails = The backward quotient (48) leaves only first order where friction acts: half the step only halves the error. Without friction (48) drops out, and the scheme is of second order.
    .holds-here = In general the backward quotient (48) leaves only first order. { -weak-for-order }
    .not-applicable = { -no-order }
check-stability = The recursion (51), for which the article names no limit of the step $\Delta t$, stays bounded for every step.
    .fails = There is a limit, which the article does not name: the recursion stays bounded only for $\omega_0^2\Delta t^2+4\gamma\Delta t<4$. With a step just above it the amplitude grows without bound.
check-start-order = The difference quotient (52) for the acceleration at the start is of second order.
    .fails = If the order of accuracy is meant, it is only of first order. For the first step (54) that is enough, because there the quotient enters with the square of the step.
    .holds-here = In general (52) is only of first order. Its leading error is proportional to the third derivative of the motion at the start, and that is next to zero for this release.
check-start-stokes = (54) is equation (53), solved for the first position $x_1$.
check-agreement-stokes = Drawn as graphs, the numeric solution (51) and the analytic solution (46) coincide.
    .fails = At the usual step of the scheme they lie further apart than a line is wide: for this damping the step is too long.
    .not-applicable = { -runs-away }
    .holds = The distance is less than the width of a line; they are not equal, since the scheme is an approximation.

## Section 3.1: Coulomb friction, the equation and the scheme

check-friction-force = Dry friction has the magnitude $\mu F_N$, whatever the velocity.
    .not-applicable = { -no-swing }
check-normal-force = What presses the mass on its guide is its weight, $F_N=mg$.
    .not-applicable = The force on the guide is given, whatever the weight.
check-opposes-motion = Thanks to the sign function in (57) friction always acts against the motion.
    .not-applicable = { -no-motion }
check-static-friction = With the sign function (57) and (59) also describe a mass that dry friction holds in its place.
    .fails = Since sign(0) = 0, a mass at rest feels no friction in (59). Released at rest in the sticking band it leaves its place, although the spring is too weak to move it.
    .not-applicable = { -too-many-steps }
check-recursion-coulomb = (59) is the discretised equation (58), solved for the next position.
check-start-coulomb = (60) gives the first position for every release, for one from rest as well.
    .fails = With $v_0=0$ the sign in (60) is zero, so that friction is missing: the first step is as long as without friction. What counts is the direction in which the mass is about to move.
    .not-applicable = { -no-swing }
check-linear-decay = With dry friction the amplitude falls linearly with time.
    .holds = Every swing loses $2f$, with the offset $f=\mu F_N/C$, and takes the same time.
    .not-applicable = The mass makes fewer than three swings, too few to compare what they lose.
check-scheme-rests = The scheme (59) describes the motion up to its end, where the mass rests.
    .fails = The scheme has no static friction. When the mass has long come to rest, it still rattles to and fro and creeps towards $x=0$.
    .not-applicable = { -too-many-steps }
check-scheme-order-coulomb = The scheme (59) is suitable for dry friction, which is taken here to mean that it is of second order.
    .fails = Dry friction changes its direction somewhere between two points of the grid, which (59) notices only at the next. That costs the second order; what is left is mostly about first, and it varies, since it depends on where between them this happens.
    .holds-here = In general mostly about first order is left, because the reversals fall between the points of the grid. { -weak-for-order }
    .not-applicable = { -no-order }

## Section 3.2.1: energy and the decay velocity

check-work-energy = On the way from $x_0$ to the next turning point $x_1$ friction does the work $F_R x_0+F_R x_1$, and the spring loses as much energy.
    .not-applicable = { -no-swing }
check-energy-chain = The conversions in (65) and (66) leave the balance of energy (64) as it is.
    .not-applicable = { -no-swing }
check-loss = From one turning point to the next the amplitude falls by $\Delta x=2\mu F_N/C$.
    .not-applicable = { -no-swing }
check-half-period = The way from $x_0$ to $x_1$ takes half a period, $T/2$.
    .not-applicable = { -no-swing }
check-period-chain = With dry friction too the period is $T=2\pi/\omega_0$ with $\omega_0^2=C/m$.
    .not-applicable = The mass makes fewer than two swings, so that no two turning points lie a swing apart.
check-decay-left = The amplitude falls at the velocity $v_A=\Delta x/(T/2)$, the first side of (68).
    .not-applicable = { -no-swing }
check-decay-middle = The second side of (68) is equal to the first.
    .fails = The second side divides by the whole period $T$ instead of by $T/2$; it is half of the first.
check-decay-right = The third side of (68) is equal to the first.
    .fails = The third side is $C$ times the first: a division by $C$ got lost. Right is $v_A=2\mu F_N\omega_0/(\pi C)$.
    .holds-here = The third side is $C$ times the first: a division by $C$ got lost, and the unit is wrong. { -one-newton-per-metre }
check-decay-dimension = The sides of (68) are velocities, so that their values do not depend on whether masses are given in kilograms or in grams.
    .fails = The third side is no velocity. Its unit is N/s instead of m/s, and its value changes with the unit of mass, as $C$ does.

## Section 3.2.1: the solution from rest

check-letter-c = In (61) $\omega_0$ is the square root of $c/m$, in agreement with (16).
    .fails = What must stand there is the spring constant $C$. A small $c$ occurs in the article only as the drag coefficient $c_w$, a pure number.
    .holds-here = What must stand there is the spring constant $C$. A small $c$ occurs in the article only as the drag coefficient $c_w$, a pure number, which happens to have the value of $C$ in N/m here.
    .not-applicable = { -no-swing }
check-frequency-unchanged = Dry friction does not change the frequency.
    .holds = The turning points follow one another at half the period without friction. The zero crossings in between are delayed.
    .not-applicable = { -no-swing }
check-analytic-exists = In spite of the sign function the equation of motion (57) has an analytic solution.
    .holds = From one turning point to the next the motion is a cosine about a centre that friction shifts by $f=\mu F_N/C$.
    .not-applicable = { -no-swing }
check-linear-solution = (61) with $v_A=\Delta x/(T/2)$ is the solution of (57) for a release from rest.
    .fails = It is no solution: (61) swings about $x=0$, whereas friction shifts the centre of every swing against the direction of motion by $f=\mu F_N/C$.
check-linear-turning-points = (61) with $v_A=\Delta x/(T/2)$ gives the turning points of a mass released from rest.
    .not-applicable = { -no-swing }
check-linear-start = (61) satisfies the initial condition of a release from rest, $v_0=0$.
    .fails = (61) begins with the speed $v_A$ towards the centre, because its amplitude falls from the very start.
check-negative-release = (61) and (69) hold for every $x_0$, whichever side of the centre it lies on.
    .fails = For $x_0<0$ the magnitude of $x_0-v_A t$ grows instead of falling. Right is $|x_0|-v_A t$ with the sign of $x_0$ in front.
    .not-applicable = { -no-swing }
check-written-out = (69) is (61) with $v_A$ written out and has the same turning points.
    .fails = (69) { -third-side }
    .holds-here = (69) { -third-side } { -one-newton-per-metre }
    .not-applicable = { -no-swing }
check-after-rest = (61) and (69) describe the motion at all times.
    .fails = { -goes-on }
    .not-applicable = Whether and when the mass comes to rest is not known here.
check-agreement-coulomb = Drawn as graphs, the numeric solution (59) and the analytic solution (69) coincide.
    .fails = At least one of the two leaves the motion by more than the width of a line. In (69) it is the factor $C$ in $v_A$ and the missing offset $f$ of the centre that lead astray; in (59) the errors of the swings add up.
    .not-applicable = { -too-many-steps }
check-agreement-proves = The agreement of the two graphs proves that dry friction leaves the frequency as it is.
    .fails = A drawing does not prove it: dry friction delays the zero crossings, which (61) places as if there were no friction. Only the turning points keep their distance of half a period, and that follows from the solution of (57), not from a graph.
    .not-applicable = The mass does not pass $x=0$ on its first swing, so that there is no zero crossing to compare.

## Section 3.2.2: any release

check-one-sine = Cosine and sine of (71) can be put together into a single sine $A\sin(\omega_0 t+\varphi)$.
check-coefficients = Comparing the coefficients gives $x_0=A\sin\varphi$ and $v_0/\omega_0=A\cos\varphi$.
check-amplitude = The square of the amplitude without friction is $A^2=x_0^2+(v_0/\omega_0)^2$.
    .not-applicable = The motion has no turning point at which the amplitude could be read off.
check-tangent = The tangent of the phase is $\tan\varphi=x_0\omega_0/v_0$.
check-quadrant = The phase is $\varphi=\arctan(x_0\omega_0/v_0)$, whatever the direction of $v_0$.
    .fails = For $v_0<0$ the arc tangent is off by half a turn, so that the formula begins at $-x_0$. Right is the arc tangent with two arguments, atan2($x_0\omega_0$, $v_0$), which knows the quadrant.
check-phase-at-rest = (77) gives a phase for every release, for $v_0=0$ as well.
    .fails = For $v_0=0$ the denominator is zero. If $x_0$ is not zero, the limit $\varphi=\pm\pi/2$ with the sign of $x_0$ is meant; for $x_0=v_0=0$ there is no phase, and none is needed, since the mass stays at rest.
check-general-linear-solution = (78) with $v_A=\Delta x/(T/2)$ and the phase by (75) is the solution of (57) for every release.
    .fails = It is no solution: (78) swings about $x=0$, whereas friction shifts the centre of every swing against the direction of motion by $f=\mu F_N/C$.
check-general-turning-points = (78) with $v_A=\Delta x/(T/2)$ and the phase by (75) gives the turning points for every release.
    .fails = A mass released with a velocity begins in the middle of a swing about a shifted centre, whereas (76) and (77) reckon amplitude and phase about $x=0$. So (78) misses the turning points too.
check-general-written-out = (79) is (78) with amplitude, decay velocity and phase written out.
    .fails = (79) { -third-side }
    .holds-here = (79) { -third-side } { -one-newton-per-metre }
    .not-applicable = The motion has no turning point at which the two could be compared.
check-general-after-rest = (78) and (79) describe the motion at all times.
    .fails = { -goes-on }
    .not-applicable = Whether and when the mass comes to rest is not known here.
check-agreement-general = Drawn as graphs, the numeric solution (59) and the analytic solution (79) coincide for every release, which confirms the derivation.
    .fails = For $v_0<0$ they do not coincide, even if $v_A$ is put right: with the phase as printed the curve begins at $-x_0$ and runs mirrored.
    .not-applicable = { -too-many-steps }
    .holds-here = In general they do not agree. Here the mirrored curve cannot be told from the motion, since the displacement at release is small beside the amplitude.

## Section 4: Newton friction, and how amplitudes fall

check-drag-force = Newton friction has the magnitude $\rho c_w A\dot x^2/2$.
    .not-applicable = { -no-motion }
check-recursion-newton = (85) is the discretised equation (84), solved for the next position.
    .not-applicable = { -runs-away }
check-start-newton = (86) is equation (83) with the quotient (52), solved for the first position $x_1$.
check-scheme-order-newton = The scheme (85) is suitable for Newton friction, which is taken here to mean that it is of second order.
    .fails = With Newton friction too the backward quotient (48) leaves only first order: in the end half the step only halves the error.
    .holds-here = In general the backward quotient (48) leaves only first order. { -weak-for-order }
    .not-applicable = { -no-order }
check-only-numeric = With Newton friction a numeric solution is probably the only sensible one; nothing can be given in closed form.
    .fails = It is true of the position as a function of time; but the turning points and the velocity at every position are known in closed form, the turning points by Lambert’s function $W$.
    .not-applicable = The mass makes fewer than two swings, so that there are no two turning points to compare.
check-series-possible = With Newton friction an analytic solution may be possible by way of a series.
    .holds = The motion is computed here as a series, swing by swing, and its turning points are those of the closed form.
check-neither-decay = With Newton friction the amplitude falls neither linearly nor exponentially.
    .holds = Neither the losses of two swings nor their ratios are equal. Where friction is weak, a swing from $x_0$ loses about $4\kappa x_0^2/3$ with $\kappa=\rho c_w A/(2m)$, and the amplitude falls hyperbolically.
    .not-applicable = There are no two swings whose losses can be told apart.
check-decrement-plot = The way in which amplitudes fall tells the laws of friction apart: linear for dry friction, exponential for Stokes friction, neither of them for Newton friction.
    .holds = Plotted over the amplitude, the loss of a swing is a parabola where friction is weak. Dry friction is its intercept $2f$, Stokes friction its slope $\pi\gamma/\omega_0$, Newton friction its curvature $4\kappa/3$.
    .not-applicable = At least one of the three laws, each taken alone, is too strong for the averaged law of weak friction, too weak to show in three swings, or lets the mass make fewer than three.
