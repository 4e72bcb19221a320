//! What each swing costs, as the recording itself shows it, beside what the fit says.

use federpendel_fit::Quantity;
use federpendel_text::Catalogue;
use federpendel_text::plot::{AveragedLaw, DecrementData, Plot};

use super::Fitted;
use super::writer::Writer;
use crate::document::{Block, Section};

/// The averaged law as it is set.
const LAW: &str = r"$\Delta A = 2f + \frac{\pi\gamma}{\omega_0} A + \frac{4}{3} \kappa A^2$";

/// Most points of the plot: of more swings each point is a mean of some.
const MOST_POINTS: usize = 24;

/// The plot, and how to read it.
pub fn section(writer: &Writer<'_>) -> Section {
    let mut blocks = vec![writer.say("measured-loss-text", &[])];
    blocks.extend(figure(writer));
    writer.section("loss", "measured-loss", blocks)
}

/// The plot with its caption, or why there is none.
pub fn figure(writer: &Writer<'_>) -> Vec<Block> {
    let plot = writer.fit.decrement(writer.catalogue);
    if plot.series.is_empty() {
        return vec![writer.say("measured-loss-none", &[])];
    }
    let mut caption = writer.catalogue.format("measured-loss-caption", &[("law", LAW.into())]);
    let conversion = match writer.fit.report.quantity {
        Quantity::Position => None,
        Quantity::Velocity => Some("measured-loss-velocity"),
        Quantity::Acceleration => Some("measured-loss-acceleration"),
    };
    if let Some(id) = conversion {
        caption = [caption, writer.text(id)].join(" ");
    }
    vec![Block::Figure { id: writer.id("figure-loss"), plots: vec![plot], caption }]
}

impl Fitted {
    /// The loss of amplitude per swing that the recording shows, with the averaged law of the verdict's mix; without series
    /// where there is no swing.
    pub fn decrement(&self, catalogue: &Catalogue) -> Plot {
        let (swings, mean_of) = self.report.swings(&self.read.recording, MOST_POINTS);
        let swings: Vec<_> = swings.iter().map(|swing| (swing.amplitude, swing.loss)).collect();
        let (law, length) = (self.averaged_law(), self.report.length_unit());
        Plot::decrement(
            catalogue,
            &DecrementData { law, swings: &swings, mean_of, length: &length },
        )
    }

    /// The averaged law with the coefficients of the verdict's mix.
    fn averaged_law(&self) -> AveragedLaw {
        let Some(model) = self.report.best() else { return AveragedLaw::default() };
        let value = |name: &str| model.parameter(name).and_then(|parameter| parameter.value);
        let omega = model.value("angular_frequency");
        AveragedLaw {
            offset: value("coulomb_acceleration").map(|force| force / (omega * omega)),
            damping_ratio: value("damping_rate").map(|rate| rate / omega),
            newton_rate: value("newton_rate"),
        }
    }
}
