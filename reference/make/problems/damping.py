"""Near critical damping and beyond it."""

from .build import SHORT, problem, scaled

CREEP = 6.0  # slow e-folds that are followed


def problems():
    return near_critical() + overdamped() + overdamped_with_drag() + slow()


def near_critical():
    result = []
    linear = [("exactly", 0.0)] + [(f"{'below' if s < 0 else 'above'}-1e-{k}", s * 10.0 ** -k)
                                   for k in (3, 6, 9, 12) for s in (-1, 1)]
    for mix in ("stokes", "stokes-coulomb"):
        result += [critical(mix, name, gap) for name, gap in linear]
    for mix in ("stokes-newton", "stokes-coulomb-newton"):
        result += [critical(mix, name, gap) for name, gap in linear[:5]]
    return result + [critical(mix, name, gap, -7.0) for name, gap in linear[::4]
                     for mix in ("stokes", "stokes-coulomb")]


def critical(mix, name, gap, v0=0.0):
    thrown = "-thrown" if v0 else ""
    return problem(mix, f"critical-{SHORT[mix]}-{name}{thrown}", "near-critical",
                   f"gamma/omega0 = 1 {'+' if gap >= 0 else '-'} {abs(gap):g}" + (", thrown inward" if v0 else ""),
                   scaled(mix, 1.0, 1 + gap, 0.02, 0.3), 1.0, v0,
                   periods=FAR if "coulomb" in mix and gap < 0 else 6.0, edge=True,
                   logarithmic="coulomb" in mix and gap < 0)


FAR = 1e9  # a barely underdamped swing lasts pi/sqrt(1 - (gamma/omega0)^2)


def overdamped():
    result = []
    for ratio in (2.0, 5.0, 10.0, 100.0, 1e4):
        for mix in ("stokes", "stokes-coulomb"):
            for name, x0, v0 in (("rest", 1.0, 0.0), ("thrown", -0.5, 4 * ratio)):
                result.append(problem(
                    mix, f"overdamped-{SHORT[mix]}-{ratio:g}-{name}", "overdamped",
                    f"gamma/omega0 = {ratio:g}, " + ("from rest" if not v0 else "thrown through the centre"),
                    scaled(mix, 1.0, ratio, 0.05), x0, v0, periods=CREEP * ratio / 3, logarithmic=True))
    return result


def overdamped_with_drag():
    result = []
    for ratio in (3.0, 10.0, 100.0, 1e3, 1e4):
        for mix in ("stokes-newton", "stokes-coulomb-newton"):
            for drag in (0.1, 10.0):
                result.append(strongly(mix, ratio, drag, "rest", -1.0, 0.0))
            result.append(strongly(mix, ratio, 0.5, "thrown", 0.1, -2 * ratio))
    return result


def strongly(mix, ratio, drag, name, x0, v0):
    return problem(mix, f"overdamped-{SHORT[mix]}-{ratio:g}-kappa-{drag:g}-{name}", "overdamped-drag",
                   f"gamma/omega0 = {ratio:g}, kappa = {drag:g}/m" + (", thrown through the centre" if v0 else ""),
                   scaled(mix, 1.0, ratio, 0.03, drag), x0, v0, periods=CREEP * ratio / 3, logarithmic=True)


# Ratio, position and velocity for kappa = 1/m, on the slow motion to which every release from rest is drawn: its
# fast part has died away, while those of the linear motion from there and of what drag adds are large and cancel.
SLOW = [(1.5, 0.126286816012219, -0.047069516426147), (2, 0.127295105625805, -0.033753491958823), (2.5, 0.127808469136925, -0.026514639392705),
        (2.95, 0.128069535865125, -0.022276647533364), (3.5, 0.128262683031860, -0.018660225661118), (10, 0.128677327319004, -0.006447937424874)]


def slow():
    return [problem("stokes-newton", f"slow-sn-{ratio:g}", "overdamped-drag",
                    f"gamma/omega0 = {ratio:g}, released on the slow motion",
                    scaled("stokes-newton", 1.0, ratio, newton=1.0), x0, v0, periods=CREEP * ratio / 3,
                    logarithmic=True) for ratio, x0, v0 in SLOW]
