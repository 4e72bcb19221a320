//! What the arguments of `fit` choose.

use federpendel::Mix;
use federpendel::parameter::Range;
use federpendel_fit::read::Choice;
use federpendel_fit::{Bootstrap, Intervals, Laws, Loss, Options};
use federpendel_text::Catalogue;

use crate::args::Fit;
use crate::beside::{inputs, refused};
use crate::failure::Failure;
use crate::quantity::{Dimension, parse};

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

/// What a standard deviation may measure; a number is in the unit of the values.
const SIGMAS: [Dimension; 4] =
    [Dimension::Number, Dimension::Length, Dimension::Velocity, Dimension::Acceleration];

/// What is read of each file.
pub fn choice(arguments: &Fit, catalogue: &Catalogue) -> Result<Choice, Failure> {
    let rate = inputs(catalogue)
        .value("rate", Range::Positive, &[Dimension::Frequency], arguments.rate.as_deref())
        .map_err(refused)?;
    Ok(Choice {
        time: arguments.time.clone(),
        value: arguments.value.clone(),
        quantity: arguments.quantity,
        unit: arguments.unit.clone(),
        run: arguments.run.clone(),
        table: arguments.table.clone(),
        rate,
    })
}

/// The choices for the fit.
pub fn options(arguments: &Fit, catalogue: &Catalogue) -> Result<Options, Failure> {
    let inputs = inputs(catalogue);
    let [from, to] =
        inputs.window(arguments.from.as_deref(), arguments.to.as_deref()).map_err(refused)?;
    let sigma = inputs
        .value("sigma", Range::Positive, &SIGMAS, arguments.sigma.as_deref())
        .map_err(refused)?;
    Ok(Options {
        laws: laws(arguments.laws.as_deref(), catalogue)?,
        from,
        to,
        sigma,
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
    let fits = |dimension: &Dimension| parse(written, *dimension).is_ok();
    SIGMAS.into_iter().find(fits).unwrap_or(Dimension::Number)
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
                    "none" | "auto" => {
                        let variables = [("value", name.trim().into())];
                        return Err(Failure::Input(catalogue.format("fit-laws-alone", &variables)));
                    }
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
