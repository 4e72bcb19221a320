//! Experiments to begin with: the article's graphs and some that one knows from the laboratory.

use federpendel_text::Catalogue;
use serde::Serialize;

use crate::experiment::{Experiment, Laws};
use crate::parameters::{CONTROLS, DURATION};

/// An experiment with a name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Preset {
    /// A key of letters and hyphens.
    pub id: &'static str,
    /// What it is called.
    pub label: String,
    /// The experiment.
    pub experiment: Experiment,
    /// The method that the graph of the article shows beside it.
    pub method: Option<&'static str>,
}

/// A preset by what differs from the values to begin with.
struct Recipe {
    id: &'static str,
    /// Stokes, Coulomb, Newton.
    laws: [bool; 3],
    hanging: bool,
    values: &'static [(&'static str, f64)],
    method: Option<&'static str>,
}

const STOKES: [bool; 3] = [true, false, false];
const COULOMB: [bool; 3] = [false, true, false];
const NEWTON: [bool; 3] = [false, false, true];

const RECIPES: [Recipe; 9] = [
    // The five graphs of the article, which names no numbers.
    Recipe {
        id: "article-stokes",
        laws: STOKES,
        hanging: false,
        values: &[],
        method: Some("article-scheme"),
    },
    Recipe {
        id: "article-coulomb",
        laws: COULOMB,
        hanging: false,
        values: &[],
        method: Some("article-scheme"),
    },
    Recipe {
        id: "article-coulomb-formula",
        laws: COULOMB,
        hanging: false,
        values: &[],
        method: Some("article-printed"),
    },
    Recipe {
        id: "article-coulomb-thrown",
        laws: COULOMB,
        hanging: false,
        values: &[("velocity", 0.3)],
        method: Some("article-printed"),
    },
    Recipe {
        id: "article-newton",
        laws: NEWTON,
        hanging: false,
        values: &[("velocity", 0.3)],
        method: Some("article-scheme"),
    },
    Recipe {
        id: "block-on-table",
        laws: COULOMB,
        hanging: false,
        values: &[("mass", 0.2), ("stiffness", 50.0), ("kinetic", 0.08), ("static", 0.1)],
        method: None,
    },
    Recipe {
        id: "card-in-air",
        laws: NEWTON,
        hanging: true,
        values: &[
            ("mass", 0.05),
            ("stiffness", 5.0),
            ("position", 0.15),
            ("density", 1.2),
            ("drag_coefficient", 1.2),
            ("area", 0.03),
        ],
        method: None,
    },
    Recipe {
        id: "heavy-oil",
        laws: STOKES,
        hanging: true,
        values: &[("mass", 0.2), ("damping", 6.0)],
        method: None,
    },
    Recipe {
        id: "all-three",
        laws: [true, true, true],
        hanging: false,
        values: &[("damping", 0.05), ("kinetic", 0.005), ("static", 0.007), ("area", 2e-4)],
        method: None,
    },
];

impl Default for Experiment {
    /// The built-in experiment of the command line.
    fn default() -> Self {
        let values = CONTROLS.iter().map(|(info, _, value)| (info.name.to_owned(), *value));
        let laws = Laws { coulomb: true, ..Laws::default() };
        Experiment { values: values.collect(), laws, hanging: false, duration: DURATION }
    }
}

impl Recipe {
    fn experiment(&self) -> Experiment {
        let mut experiment = Experiment::default();
        let [stokes, coulomb, newton] = self.laws;
        experiment.laws = Laws { stokes, coulomb, newton };
        experiment.hanging = self.hanging;
        for (name, value) in self.values {
            experiment.values.insert((*name).to_owned(), *value);
        }
        // A recipe that the core refuses has no motion; a test refuses it.
        if let Ok(motion) = experiment.motion() {
            experiment.duration = motion.default_duration();
        }
        experiment
    }
}

/// All presets.
pub fn presets(catalogue: &Catalogue) -> Vec<Preset> {
    let preset = |recipe: &Recipe| Preset {
        id: recipe.id,
        label: catalogue.text(&format!("preset-{}", recipe.id)),
        experiment: recipe.experiment(),
        method: recipe.method,
    };
    RECIPES.iter().map(preset).collect()
}
