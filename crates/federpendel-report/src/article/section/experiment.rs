//! The experiment: what is given, what is built in, and its own motion.

use std::f64::consts::PI;

use federpendel::parameter::{self, ParameterInfo};
use federpendel::{Result, State};

use crate::article::figure;
use crate::article::writer::Writer;
use crate::article::{Case, Laboratory};
use crate::document::{Block, Row, Section};

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory) -> Result<Section> {
    let mut blocks = vec![
        writer.say("article-experiment-text"),
        table(writer, laboratory),
        writer.say("article-symbols"),
    ];
    blocks.extend(notices(writer, laboratory));
    let mix = writer.catalogue.mix(laboratory.own.oscillator().friction().mix());
    blocks.push(Block::Figure {
        id: "figure-own".to_owned(),
        plots: vec![figure::motion(writer, &laboratory.own)?],
        caption: writer.catalogue.format("article-experiment-motion", &[("mix", mix.into())]),
    });
    Ok(writer.section("experiment", blocks, vec![]))
}

/// Where a value comes from.
#[derive(Clone, Copy)]
enum Origin {
    Given,
    BuiltIn,
    Added,
    Derived,
}

impl Origin {
    fn of(built_in: bool) -> Self {
        if built_in { Origin::BuiltIn } else { Origin::Given }
    }

    fn id(self) -> &'static str {
        match self {
            Origin::Given => "article-origin-given",
            Origin::BuiltIn => "article-origin-built-in",
            Origin::Added => "article-origin-added",
            Origin::Derived => "article-origin-derived",
        }
    }
}

fn table(writer: &Writer<'_>, laboratory: &Laboratory) -> Block {
    let text = |id: &str| writer.catalogue.text(id);
    let row = |name: String, symbol: &str, value: f64, unit: &str, origin: Origin| {
        vec![
            name,
            format!("${symbol}$"),
            writer.catalogue.quantity(value, unit, 6),
            text(origin.id()),
        ]
    };
    let given = |info: &ParameterInfo, symbol: &str, value: f64, origin: Origin| {
        row(writer.catalogue.parameter(info).name, symbol, value, info.unit, origin)
    };
    let (own, stokes, coulomb, newton) =
        (&laboratory.own, &laboratory.stokes, &laboratory.coulomb, &laboratory.newton);
    let oscillator = own.oscillator();
    let State { position, velocity } = own.release();
    let release = Origin::of(laboratory.built_in_release);
    let mut rows = vec![
        given(&parameter::MASS, "m", oscillator.mass(), Origin::Given),
        given(&parameter::STIFFNESS, "C", oscillator.stiffness(), Origin::Given),
        given(&parameter::POSITION, "x_0", position, release),
        given(&parameter::VELOCITY, "v_0", velocity, release),
    ];
    if laboratory.added_position {
        let displaced = laboratory.coulomb.release().position;
        rows.push(row(text("article-quantity-displaced"), "x_0", displaced, "m", Origin::Added));
    }
    // Thrown both ways: the article's formulas differ in that.
    for thrown in &laboratory.thrown {
        let velocity = thrown.release().velocity;
        if velocity != own.release().velocity {
            rows.push(row(text("article-quantity-thrown"), "v_0", velocity, "m/s", Origin::Added));
        }
    }
    if let Some(law) = stokes.oscillator().friction().stokes {
        rows.push(given(&parameter::DAMPING, "D", law.damping(), Origin::of(stokes.built_in)));
    }
    if let Some(law) = coulomb.oscillator().friction().coulomb {
        let origin = Origin::of(coulomb.built_in);
        rows.push(given(&parameter::KINETIC, r"\mu", law.kinetic(), origin));
        rows.push(given(&parameter::STATIC, r"\mu_s", law.static_coefficient(), origin));
        let force = law.kinetic() * law.normal_force().force(oscillator.mass());
        rows.push(row(text("article-quantity-force"), r"\mu F_N", force, "N", Origin::Derived));
    }
    if let Some(law) = newton.oscillator().friction().newton {
        let info = &parameter::NEWTON_COEFFICIENT;
        rows.push(given(
            info,
            r"\frac{1}{2}\rho c_w A",
            law.coefficient(),
            Origin::of(newton.built_in),
        ));
    }
    rows.extend(derived(writer, laboratory, row));
    Block::Table {
        caption: text("article-quantities"),
        head: ["quantity", "symbol", "value", "origin"]
            .map(|head| text(&format!("article-head-{head}")))
            .to_vec(),
        rows: rows.into_iter().map(Row::from).collect(),
    }
}

fn derived(
    writer: &Writer<'_>,
    laboratory: &Laboratory,
    row: impl Fn(String, &str, f64, &str, Origin) -> Vec<String>,
) -> Vec<Vec<String>> {
    let omega0 = laboratory.own.oscillator().angular_frequency();
    let of = |case: &Case| *case.oscillator();
    [
        ("article-quantity-omega", r"\omega_0", omega0, "1/s"),
        ("article-quantity-period", "T", 2.0 * PI / omega0, "s"),
        ("article-quantity-rate", r"\gamma", of(&laboratory.stokes).damping_rate(), "1/s"),
        ("article-quantity-offset", "f", of(&laboratory.coulomb).offset(), "m"),
        ("article-quantity-drag-rate", r"\kappa", of(&laboratory.newton).newton_rate(), "1/m"),
    ]
    .into_iter()
    .map(|(id, symbol, value, unit)| {
        row(writer.catalogue.text(id), symbol, value, unit, Origin::Derived)
    })
    .collect()
}

/// What differs from the experiment as it was given.
fn notices(writer: &Writer<'_>, laboratory: &Laboratory) -> Vec<Block> {
    let mut notices = Vec::new();
    let laws = [
        ("stokes", &laboratory.stokes),
        ("coulomb", &laboratory.coulomb),
        ("newton", &laboratory.newton),
    ];
    let mix = laboratory.own.oscillator().friction().mix();
    let acts = [mix.stokes, mix.coulomb, mix.newton];
    for ((law, _), acts) in laws.iter().zip(acts).filter(|((_, case), _)| case.built_in) {
        let name = writer.catalogue.text(&format!("article-law-{law}"));
        let id = if acts { "article-faint" } else { "article-lacks" };
        notices.push(writer.notice(id, &[("laws", name.into())]));
    }
    if laboratory.built_in_release {
        let position = writer.length(laboratory.own.release().position);
        notices.push(writer.notice("article-built-in-release", &[("position", position)]));
    }
    if laboratory.added_position {
        let position = writer.length(laboratory.coulomb.release().position);
        notices.push(writer.notice("article-added-position", &[("position", position)]));
    }
    if laboratory.added_velocity {
        let velocity = writer.velocity(laboratory.thrown[0].release().velocity.abs());
        notices.push(writer.notice("article-added-velocity", &[("velocity", velocity)]));
    }
    if laboratory.pressed {
        notices.push(writer.notice("article-pressed", &[]));
    }
    notices
}
