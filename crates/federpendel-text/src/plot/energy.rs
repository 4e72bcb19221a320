//! Where the energy is: stacked areas against time.

use federpendel::{Ledger, Mix};

use super::{Axis, Plot, Role, Style};
use crate::catalogue::Catalogue;
use crate::describe::DIGITS;

/// What the plot of the energy shows, in SI units.
#[derive(Debug, Clone, Copy)]
pub struct EnergyData<'a> {
    /// Which laws of friction act.
    pub mix: Mix,
    /// Where the energy is, at rising times. Each swing needs some dozens.
    pub ledgers: &'a [Ledger],
}

type Energy = fn(&Ledger) -> f64;

/// A share of the energy.
struct Share {
    name: String,
    role: Role,
    energy: Energy,
}

impl Plot {
    /// Kinetic and potential energy on top of the heat of each law that acts; together they are the
    /// energy of the release. The legend lists them from top to bottom.
    pub fn energy(catalogue: &Catalogue, data: &EnergyData<'_>) -> Self {
        let shares = shares(catalogue, data.mix);
        let sum = |ledger: &Ledger| shares.iter().map(|share| (share.energy)(ledger)).sum::<f64>();
        let total = data.ledgers.first().map_or(0.0, sum);
        let duration = data.ledgers.last().map_or(0.0, |ledger| ledger.time);
        let time = Axis::new(catalogue, &catalogue.text("plot-time"), "t", "s", duration);
        let energy = Axis::new(catalogue, &catalogue.text("plot-energy"), "E", "J", total);
        let title =
            catalogue.format("plot-energy-title", &[("mix", catalogue.mix(data.mix).into())]);
        let mut plot = Plot::new(catalogue, title, time, energy.from_zero());
        plot.description = description(catalogue, data, &shares, &plot.title, (duration, total));
        for (i, share) in shares.iter().enumerate() {
            // Heights above the floor, share by share from the bottom: so rounding never opens a gap.
            let height = |ledger: &Ledger, from: usize| {
                shares[from..].iter().rev().map(|share| (share.energy)(ledger)).sum::<f64>()
            };
            let upper = data.ledgers.iter().map(|ledger| (ledger.time, height(ledger, i)));
            plot.add(share.name.clone(), share.role, Style::SOLID, upper);
            let size = plot.y.unit_size;
            let lower = data.ledgers.iter().map(|ledger| height(ledger, i + 1) / size).collect();
            if let Some(series) = plot.series.last_mut() {
                series.lower = Some(lower);
            }
        }
        plot
    }
}

/// The shares from top to bottom.
fn shares(catalogue: &Catalogue, mix: Mix) -> Vec<Share> {
    let all: [(&str, bool, Role, Energy); 5] = [
        ("plot-energy-kinetic", true, Role::Kinetic, |ledger| ledger.kinetic),
        ("plot-energy-potential", true, Role::Potential, |ledger| ledger.potential),
        ("plot-energy-stokes", mix.stokes, Role::Stokes, |ledger| ledger.heat.stokes),
        ("plot-energy-coulomb", mix.coulomb, Role::Coulomb, |ledger| ledger.heat.coulomb),
        ("plot-energy-newton", mix.newton, Role::Newton, |ledger| ledger.heat.newton),
    ];
    all.into_iter()
        .filter(|(_, acts, ..)| *acts)
        .map(|(id, _, role, energy)| Share { name: catalogue.text(id), role, energy })
        .collect()
}

fn description(
    catalogue: &Catalogue,
    data: &EnergyData<'_>,
    shares: &[Share],
    title: &str,
    (duration, total): (f64, f64),
) -> String {
    let part = |share: &Share| {
        let energy = data.ledgers.last().map_or(0.0, share.energy);
        let energy = catalogue.quantity(energy, "J", DIGITS);
        let variables = [("name", share.name.clone().into()), ("energy", energy.into())];
        catalogue.format("plot-energy-part", &variables)
    };
    let parts: Vec<_> = shares.iter().map(part).collect();
    catalogue.format(
        "plot-energy-description",
        &[
            ("title", title.into()),
            ("duration", catalogue.quantity(duration, "s", DIGITS).into()),
            ("total", catalogue.quantity(total, "J", DIGITS).into()),
            ("parts", parts.join("; ").into()),
        ],
    )
}
