//! What the arguments of `fit` choose.

use federpendel::Mix;
use federpendel_fit::read::Choice;
use federpendel_fit::{Bootstrap, Intervals, Laws, Loss, Options};
use federpendel_text::Catalogue;

use crate::args::Fit;
use crate::failure::Failure;
use crate::quantity::{self, Dimension, parse};
use crate::words::quantity_problem;

/// Refits for intervals from a bootstrap: enough for the ends of the middle 95 % to be sure to a tenth.
const BOOTSTRAP: Bootstrap = Bootstrap { repeats: 1000, seed: 1 };

/// How intervals are found, by name.
pub const INTERVALS: [(&str, Intervals); 3] = [
    ("profile", Intervals::Profile),
    ("covariance", Intervals::Covariance),
    ("bootstrap", Intervals::Bootstrap(BOOTSTRAP)),
];

/// How residuals count, by name.
pub const LOSSES: [(&str, Loss); 3] =
    [("squares", Loss::Squares), ("huber", Loss::Huber), ("tukey", Loss::Tukey)];

/// What is read of each file.
pub fn choice(arguments: &Fit, catalogue: &Catalogue) -> Result<Choice, Failure> {
    Ok(Choice {
        time: arguments.time.clone(),
        value: arguments.value.clone(),
        quantity: arguments.quantity,
        unit: arguments.unit.clone(),
        run: arguments.run.clone(),
        table: arguments.table.clone(),
        rate: value("rate", &arguments.rate, Dimension::Frequency, catalogue)?,
    })
}

/// The choices for the fit.
pub fn options(arguments: &Fit, catalogue: &Catalogue) -> Result<Options, Failure> {
    let value = |name, written, dimension| value(name, written, dimension, catalogue);
    Ok(Options {
        laws: laws(arguments.laws.as_deref(), catalogue)?,
        from: value("from", &arguments.from, Dimension::Time)?,
        to: value("to", &arguments.to, Dimension::Time)?,
        sigma: value(
            "sigma",
            &arguments.sigma,
            sigma_dimension(arguments.sigma.as_deref().unwrap_or_default()),
        )?,
        loss: arguments.loss,
        intervals: arguments.intervals,
        ..Options::default()
    })
}

/// The unit that a standard deviation is in: an SI unit, or none for a number in the unit of the values.
pub fn sigma_unit(arguments: &Fit) -> Option<&'static str> {
    let written = arguments.sigma.as_deref()?;
    let dimension = sigma_dimension(written);
    (dimension != Dimension::Number).then(|| dimension.units()[0])
}

/// What a standard deviation measures.
fn sigma_dimension(written: &str) -> Dimension {
    let all = [Dimension::Number, Dimension::Length, Dimension::Velocity, Dimension::Acceleration];
    let fits = |dimension: &Dimension| parse(written, *dimension).is_ok();
    all.into_iter().find(fits).unwrap_or(Dimension::Number)
}

/// A quantity, if it is written.
fn value(
    name: &str,
    written: &Option<String>,
    dimension: Dimension,
    catalogue: &Catalogue,
) -> Result<Option<f64>, Failure> {
    let Some(written) = written else { return Ok(None) };
    match parse(written, dimension) {
        Ok(value) => Ok(Some(value)),
        Err(error) => Err(refused(name, written, &error, catalogue)),
    }
}

fn refused(name: &str, written: &str, error: &quantity::Error, catalogue: &Catalogue) -> Failure {
    let variables = [
        ("name", format!("--{name}").into()),
        ("value", catalogue.quoted(written).into()),
        ("problem", quantity_problem(catalogue, error).into()),
    ];
    Failure::Input(catalogue.format("fit-option-refused", &variables))
}

/// The laws: `auto` for those that show, `none`, or a list of those that act.
pub fn laws(written: Option<&str>, catalogue: &Catalogue) -> Result<Laws, Failure> {
    let mut mix = Mix::default();
    match written {
        None | Some("auto") => return Ok(Options::default().laws),
        Some("none") => return Ok(Laws::Exactly(mix)),
        Some(list) => {
            for name in list.split(',') {
                match name.trim() {
                    "stokes" => mix.stokes = true,
                    "coulomb" => mix.coulomb = true,
                    "newton" => mix.newton = true,
                    other => {
                        let variables = [("value", other.into())];
                        return Err(Failure::Input(
                            catalogue.format("fit-laws-refused", &variables),
                        ));
                    }
                }
            }
        }
    }
    Ok(Laws::Exactly(mix))
}
