//! Figures: a plot of a motion that dry friction ends, and every sketch.

use federpendel::{Coulomb, Motion, NormalForce, Oscillator, State};
use federpendel_report::sketch::{self, Given, Law, Side};
use federpendel_report::{Block, Section};
use federpendel_text::Catalogue;
use federpendel_text::plot::{MotionData, Plot};

use crate::content::Speaker;

pub fn section(catalogue: &Catalogue, say: &Speaker) -> federpendel::Result<Section> {
    Ok(Section {
        id: "figures".to_owned(),
        heading: say.one_of("Figures", "Abbildungen"),
        blocks: vec![Block::Figure {
            id: "motion".to_owned(),
            plots: vec![motion(catalogue)?],
            caption: say.one_of(
                "Displacement $x(t)$ with dry friction.",
                "Auslenkung $x(t)$ bei trockener Reibung.",
            ),
        }],
        sections: vec![Section {
            id: "sketches".to_owned(),
            heading: say.one_of("Sketches", "Skizzen"),
            blocks: sketches(catalogue, say),
            sections: vec![],
        }],
    })
}

fn sketches(catalogue: &Catalogue, say: &Speaker) -> Vec<Block> {
    let laws = [
        ("none", Law::None, Side::Right),
        ("stokes", Law::Stokes, Side::Right),
        ("coulomb", Law::Coulomb, Side::Right),
        ("newton", Law::Newton, Side::Left),
        ("coulomb-left", Law::Coulomb, Side::Left),
    ];
    let mut drawn: Vec<_> = laws
        .map(|(id, law, side)| {
            (id, sketch::guide(id, law, side, catalogue), say.one_of("The forces.", "Die Kräfte."))
        })
        .into();
    let given = Given {
        start: catalogue.quantity(0.1, "m", 3),
        turn: catalogue.quantity(0.09019, "m", 3),
        start_energy: catalogue.quantity(0.1, "J", 3),
        turn_energy: catalogue.quantity(0.08134, "J", 3),
        work: catalogue.quantity(0.01866, "J", 3),
    };
    let caption = say.one_of("Where the energy goes.", "Wo die Energie bleibt.");
    drawn.push(("loss", sketch::loss("loss", &given, catalogue), caption));
    let caption = say.one_of("Drag.", "Strömungswiderstand.");
    drawn.push(("stream", sketch::stream("stream", catalogue), caption));
    let block = |(id, svg, caption): (&str, _, _)| Block::Sketch {
        id: format!("sketch-of-{id}"),
        svg,
        caption,
    };
    drawn.into_iter().map(block).collect()
}

fn motion(catalogue: &Catalogue) -> federpendel::Result<Plot> {
    let friction = Coulomb::new(0.02, 0.02, NormalForce::Weight(9.81))?;
    let oscillator = Oscillator::new(0.5, 20.0, friction)?;
    let motion = Motion::new(oscillator, State::new(0.1, 0.0)?)?;
    let times: Vec<f64> = (0..601).map(|i| 0.01 * f64::from(i)).collect();
    let (mut positions, mut velocities) = (vec![0.0; 601], vec![0.0; 601]);
    motion.sample(&times, &mut positions, &mut velocities)?;
    let turning_points: Vec<_> =
        motion.turning_points().take_while(|point| point.time <= 6.0).collect();
    let data = MotionData {
        mix: motion.oscillator().friction().mix(),
        times: &times,
        positions: &positions,
        turning_points: &turning_points,
        from_rest: true,
        outcome: &motion.outcome(),
        sticking_offset: motion.oscillator().sticking_offset(),
    };
    Ok(Plot::motion(catalogue, &data))
}
