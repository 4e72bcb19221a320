//! From what a fit found and what was measured beside the recording to physical numbers: masses, stiffness, forces,
//! coefficients of friction.

use crate::covariance::NORMAL;
use crate::propagation::{Estimate, Measured, Propagated, Source, Sources};
use crate::report::{FitReport, Model};

/// What was measured beside the recording.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Given {
    /// Mass of the body without the spring, kg, above zero.
    pub mass: Option<Measured>,
    /// Stiffness of the spring, N/m, above zero.
    pub stiffness: Option<Measured>,
    /// Mass of the spring, kg; none counts as zero.
    pub spring_mass: Option<Measured>,
    /// What presses the body on its guide; none where nothing is known of that, as for one that hangs.
    pub normal: Option<Normal>,
}

/// What presses the body on its guide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Normal {
    /// This force, N, above zero.
    Force(Measured),
    /// The weight m g of the body alone under this gravity, m/s²: a level guide that does not carry the spring.
    Weight(Measured),
}

/// Why a number is not given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Absent {
    /// The recording holds angles, to which masses and springs have no meaning.
    Angle,
    /// The number needs lengths in metres, and those of the recording are in another unit.
    Length,
    /// It needs the mass or the stiffness.
    Mass,
    /// It needs the normal force.
    NormalForce,
    /// A third of the mass of the spring is more than all that moves.
    SpringMass,
    /// The law does not act.
    Law,
    /// The mass does not come to rest within the recording, so that nothing shows how strongly it is held.
    NoRest,
}

impl Absent {
    /// The reason in files.
    pub fn name(self) -> &'static str {
        match self {
            Absent::Angle => "angle",
            Absent::Length => "length",
            Absent::Mass => "mass",
            Absent::NormalForce => "normal-force",
            Absent::SpringMass => "spring-mass",
            Absent::Law => "law",
            Absent::NoRest => "no-rest",
        }
    }
}

/// A number, or why it is not given.
pub type Answer = Result<Estimate, Absent>;

/// Whether the given mass and stiffness make the frequency of the recording.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// C/M over ω0².
    pub ratio: f64,
    /// C/M − ω0² in its standard deviations.
    pub deviation: f64,
}

/// Physical numbers of a fit, SI, by the names of experiment files where those have one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Physical {
    /// What they are made from.
    pub given: Given,
    /// Mass m of the body: as given, else M − m_s/3.
    pub mass: Answer,
    /// Moving mass M: m + m_s/3 if the mass is given, else C/ω0².
    ///
    /// A spring whose windings move in proportion to their place adds a third of its mass (Rayleigh, Theory of
    /// Sound, § 156). With both given the mass counts: scales weigh better than the extension of a spring is
    /// measured, and no frequency enters.
    pub moving_mass: Answer,
    /// Stiffness C: as given, else M ω0².
    pub stiffness: Answer,
    /// Damping D = 2γM of Stokes friction.
    pub damping: Answer,
    /// Force F_c = M a_c of Coulomb friction.
    pub coulomb_force: Answer,
    /// Newton coefficient ½ρc_wA = κM.
    pub newton_coefficient: Answer,
    /// Kinetic coefficient μ = M a_c/N.
    pub kinetic: Answer,
    /// Static coefficient μ_s = M a_s/N: an interval, since a rest only shows between what it lies. Its ends are moved
    /// outwards by what M/N is uncertain.
    pub static_: Answer,
    /// Whether mass and stiffness agree with the recording, if both are given.
    pub agreement: Option<Agreement>,
}

impl Physical {
    /// All numbers with their names.
    pub fn numbers(&self) -> [(&'static str, Answer); 8] {
        [
            ("mass", self.mass),
            ("moving_mass", self.moving_mass),
            ("stiffness", self.stiffness),
            ("damping", self.damping),
            ("coulomb_force", self.coulomb_force),
            ("newton_coefficient", self.newton_coefficient),
            ("kinetic", self.kinetic),
            ("static", self.static_),
        ]
    }

    /// Whether the reason stands for any of the numbers.
    pub fn lacks(&self, reason: Absent) -> bool {
        self.numbers().iter().any(|(_, answer)| *answer == Err(reason))
    }
}

/// The physical numbers of the verdict's mix; none where nothing is given. `angles` says that the recording holds
/// angles, where its unit does not.
pub fn physical(report: &FitReport, given: &Given, angles: bool) -> Option<Physical> {
    let model = report.best().filter(|_| *given != Given::default())?;
    let body = Body::new(model, given);
    let unit = report.length_unit();
    let swings = if angles || unit == "rad" { Err(Absent::Angle) } else { Ok(()) };
    let metres = if unit == "m" { Ok(()) } else { Err(Absent::Length) };
    let law = |acts: bool| swings.and(if acts { Ok(()) } else { Err(Absent::Law) });
    let [stokes, coulomb, newton] =
        [model.mix.stokes, model.mix.coulomb, model.mix.newton].map(law);
    let rate = |source: Source| Ok(body.moving? * body.sources.number(source));
    let estimate = |allowed: Result<(), Absent>, number, fitted, unit| {
        allowed.and(number).map(|number| body.sources.estimate(number, fitted, unit))
    };
    use Source::{AngularFrequency, CoulombAcceleration, DampingRate, NewtonRate};
    let force = rate(CoulombAcceleration);
    let kinetic = body.over_normal.map(|ratio| ratio * body.sources.number(CoulombAcceleration));
    let dry = coulomb.and(metres);
    let damping = rate(DampingRate).map(|half| half * 2.0);
    Some(Physical {
        given: *given,
        mass: estimate(swings, body.mass, AngularFrequency, "kg"),
        moving_mass: estimate(swings, body.moving, AngularFrequency, "kg"),
        stiffness: estimate(swings, body.stiffness, AngularFrequency, "N/m"),
        damping: estimate(stokes, damping, DampingRate, "kg/s"),
        coulomb_force: estimate(dry, force, CoulombAcceleration, "N"),
        newton_coefficient: estimate(newton.and(metres), rate(NewtonRate), NewtonRate, "kg/m"),
        kinetic: estimate(dry, kinetic, CoulombAcceleration, "1"),
        static_: dry.and_then(|()| body.static_coefficient(model)),
        agreement: swings.ok().and_then(|()| body.agreement()),
    })
}

/// What swings, as numbers with their derivatives.
struct Body {
    given: Given,
    sources: Sources,
    mass: Result<Propagated, Absent>,
    moving: Result<Propagated, Absent>,
    stiffness: Result<Propagated, Absent>,
    /// M/N, kg/N.
    over_normal: Result<Propagated, Absent>,
}

impl Body {
    fn new(model: &Model, given: &Given) -> Self {
        let mut sources = Sources::of(model);
        let mut known = |source: Source, given: Option<Measured>| {
            let given = given?;
            sources.give(source, given);
            Some(sources.number(source))
        };
        let mass = known(Source::Mass, given.mass);
        let stiffness = known(Source::Stiffness, given.stiffness);
        let spring = known(Source::SpringMass, given.spring_mass);
        let normal = given.normal.map(|normal| match normal {
            Normal::Force(force) => (known(Source::NormalForce, Some(force)), None),
            Normal::Weight(gravity) => (None, known(Source::Gravity, Some(gravity))),
        });
        let omega = sources.number(Source::AngularFrequency);
        // Windings at the hook move with the body, those at the other end not at all.
        let third = spring.unwrap_or(Propagated::exact(0.0)) * (1.0 / 3.0);
        let moving = match (mass, stiffness) {
            (Some(mass), _) => Ok(mass + third),
            (None, Some(stiffness)) => Ok(stiffness / (omega * omega)),
            (None, None) => Err(Absent::Mass),
        };
        let rest = moving.map(|moving| moving - third);
        let body = match mass {
            Some(mass) => Ok(mass),
            None => rest.and_then(|m| if m.value > 0.0 { Ok(m) } else { Err(Absent::SpringMass) }),
        };
        let stiffness = stiffness.map_or_else(|| Ok(moving? * omega * omega), Ok);
        let over_normal = match normal {
            Some((Some(force), _)) => moving.map(|moving| moving / force),
            // Of a spring without mass the mass cancels.
            Some((_, Some(gravity))) if moving.is_err() && spring.is_none() => {
                Ok(Propagated::exact(1.0) / gravity)
            }
            Some((_, Some(gravity))) => body.and_then(|body| Ok(moving? / (body * gravity))),
            _ => Err(Absent::NormalForce),
        };
        Self { given: *given, sources, mass: body, moving, stiffness, over_normal }
    }

    /// μ_s from the acceleration of the spring where the mass rests, and one turning point earlier.
    fn static_coefficient(&self, model: &Model) -> Answer {
        let (low, high) = model.parameter("static_acceleration").ok_or(Absent::NoRest)?.interval95;
        let ratio = self.over_normal?;
        let error = self.sources.stderr(&ratio).map(|stderr| NORMAL * stderr);
        let end = |acceleration: Option<f64>, way: f64| {
            Some(acceleration? * (ratio.value + way * error?).max(0.0))
        };
        let interval95 = (end(low, -1.0), end(high, 1.0));
        Ok(Estimate { value: None, stderr: None, interval95, unit: "1" })
    }

    fn agreement(&self) -> Option<Agreement> {
        self.given.mass.and(self.given.stiffness)?;
        let omega = self.sources.number(Source::AngularFrequency);
        let (square, given) = (omega * omega, self.stiffness.ok()? / self.moving.ok()?);
        let difference = given - square;
        let deviation = difference.value / self.sources.stderr(&difference)?;
        Some(Agreement { ratio: given.value / square.value, deviation })
    }
}
