//! The motion that was fitted, as an experiment of the page.

use federpendel::Oscillator;
use federpendel_fit::Parameters;
use federpendel_quantity::{Dimension, parse};
use federpendel_report::recording::Fitted;
use federpendel_text::Catalogue;

use crate::experiment::{Experiment, Laws};

/// The fitted motion as an experiment, lying, with the moving mass where that is known and else the built-in one: a motion
/// alone does not tell a mass, and what it says of forces it says per mass. None where no mix describes it or its lengths
/// have no unit.
pub fn experiment(fit: &Fitted) -> Option<Experiment> {
    let report = &fit.report;
    if !report.adequacy.adequate {
        return None;
    }
    let metre = metre(fit)?;
    let model = report.best()?;
    let parameters = Parameters {
        angular_frequency: model.value("angular_frequency"),
        damping_rate: model.value("damping_rate"),
        coulomb_acceleration: metre * model.value("coulomb_acceleration"),
        newton_rate: model.value("newton_rate") / metre,
        position0: metre * model.value("position0"),
        velocity0: metre * model.value("velocity0"),
        equilibrium: 0.0,
    };
    let motion = parameters.motion(metre * model.value("static_acceleration")).ok()?;
    let mut experiment = Experiment::default();
    let mass = fit.physical.and_then(|physical| physical.moving_mass.ok()?.value);
    if let Some(mass) = mass {
        experiment.values.insert("mass".to_owned(), mass);
    }
    experiment.set_per_mass(motion.oscillator());
    experiment.values.insert("position".to_owned(), parameters.position0);
    experiment.values.insert("velocity".to_owned(), parameters.velocity0);
    experiment.duration = report.window.to - report.window.from;
    Some(experiment)
}

/// Why a motion that a mix describes cannot be simulated: its lengths are angles, or in a unit that is none of length.
pub fn absent(fit: &Fitted, catalogue: &Catalogue) -> Option<String> {
    if !fit.report.adequacy.adequate || metre(fit).is_some() {
        return None;
    }
    let angles = fit.read.value.is_angle() || fit.report.length_unit() == "rad";
    Some(catalogue.text(if angles {
        "page-no-simulation-angle"
    } else {
        "page-no-simulation-unit"
    }))
}

/// The unit of length of the recording, m; none where it is none of length.
fn metre(fit: &Fitted) -> Option<f64> {
    parse(&format!("1 {}", fit.report.length_unit()), Dimension::Length).ok()
}

impl Experiment {
    /// Takes over the motion of an oscillator of 1 kg, which any other mass has with forces in proportion: stiffness,
    /// damping and ½ρc_wA grow with it, and so does a weight.
    fn set_per_mass(&mut self, unit: &Oscillator) {
        let friction = unit.friction();
        let (mass, gravity) = (self.value("mass"), self.value("gravity"));
        let mut set = |name: &str, value: f64| {
            self.values.insert(name.to_owned(), value);
        };
        set("stiffness", mass * unit.stiffness());
        let mix = friction.mix();
        self.laws = Laws { stokes: mix.stokes, coulomb: mix.coulomb, newton: mix.newton };
        if let Some(law) = friction.stokes.filter(|_| mix.stokes) {
            set("damping", mass * law.damping());
        }
        if let Some(law) = friction.coulomb.filter(|_| mix.coulomb) {
            let pressing = law.normal_force().force(unit.mass());
            set("kinetic", law.kinetic() * pressing / gravity);
            set("static", law.static_coefficient() * pressing / gravity);
        }
        if let Some(law) = friction.newton.filter(|_| mix.newton) {
            // Of ρ, c_w and A only the product is known: A takes what the others leave.
            let others = 0.5 * self.value("density") * self.value("drag_coefficient");
            self.values.insert("area".to_owned(), mass * law.coefficient() / others);
        }
    }
}
