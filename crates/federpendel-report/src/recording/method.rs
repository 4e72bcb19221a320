//! How the report is to be read: the equation, its letters, the method.

use federpendel_text::Catalogue;

use crate::document::{Block, Section};

/// The equation of motion.
const EQUATION: &str = r"\ddot x = -\omega_0^2 x - 2\gamma \dot x - a_c \operatorname{sgn} \dot x - \kappa |\dot x| \dot x";

/// The same for every recording.
pub fn section(catalogue: &Catalogue) -> Section {
    let say = |id: &str| Block::Paragraph(catalogue.text(id));
    let symbols = [
        "measured-symbols-omega",
        "measured-symbols-gamma",
        "measured-symbols-coulomb",
        "measured-symbols-kappa",
        "measured-symbols-length",
    ];
    Section {
        id: "method".to_owned(),
        heading: catalogue.text("measured-method"),
        blocks: vec![
            say("measured-equation"),
            Block::Formula { number: None, tex: EQUATION.to_owned() },
            Block::List(symbols.map(|id| catalogue.text(id)).into()),
            say("measured-steps"),
            say("measured-confidence"),
        ],
        sections: vec![],
    }
}
