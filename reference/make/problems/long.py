"""A million periods, and friction so small that there are millions of swings."""

from .build import SHORT, problem, scaled


def problems():
    return linear() + dry() + turbulent()


def linear():
    cases = [("undamped", "undamped", 0.0, 1e6, 0.0), ("undamped", "undamped-thrown", 0.0, 1e9, -2.5),
             ("stokes", "1e-7", 1e-7, 1e6, 0.0), ("stokes", "1e-9", 1e-9, 1e6, 0.4), ("stokes", "1e-5", 1e-5, 1e6, 0.0)]
    return [problem(mix, f"million-{SHORT[mix]}-{name}", "million-periods",
                    f"{periods:g} periods, gamma/omega0 = {g:g}",
                    scaled(mix, 1.0, g, mass=0.3, stiffness=7.0), 1.0, v0, periods=periods, many=True)
            for mix, name, g, periods, v0 in cases]


def dry():
    cases = [("coulomb", 0.0, 1e-4, 0.0), ("coulomb", 0.0, 1.3e-6, 0.0), ("coulomb", 0.0, 1.1e-9, 0.0),
             ("coulomb", 0.0, 1.7e-7, -3.0), ("stokes-coulomb", 1e-3, 1e-6, 0.0),
             ("stokes-coulomb", 1e-9, 1.2e-9, 0.0), ("stokes-coulomb", 2e-6, 3e-8, 5.0),
             ("stokes-coulomb", 1e-12, 1e-3, 0.0)]
    return [problem(mix, f"tiny-{SHORT[mix]}-{f:g}", "tiny-friction",
                    f"offset/x0 = {f:g}" + (f", gamma/omega0 = {g:g}" if g else ""),
                    scaled(mix, 1.0, g, f, mass=0.3, stiffness=7.0), 1.0, v0, periods=1e12, many=True)
            for mix, g, f, v0 in cases]


def turbulent():
    """`many` is the number of swings where the mass does not come to rest."""
    cases = [("newton", 1e-5, 0.0), ("newton", 1e-7, 0.0), ("coulomb-newton", 1e-5, 1e-6), ("coulomb-newton", 1e-4, 2.3e-5)]
    return [problem(mix, f"million-{SHORT[mix]}-{k:g}", "million-periods",
                    f"kappa x0 = {k:g}" + (f", offset/x0 = {f:g}" if f else ", a million periods"),
                    scaled(mix, 1.0, 0.0, f, k, mass=0.3, stiffness=7.0), 1.0, periods=1e6, many=2_000_000)
            for mix, k, f in cases]
