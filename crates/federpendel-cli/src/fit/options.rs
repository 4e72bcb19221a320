//! What the arguments of `fit` choose.

use federpendel::Mix;
use federpendel::parameter::{ParameterInfo, Range};
use federpendel_fit::read::Choice;
use federpendel_fit::{Bootstrap, Intervals, Laws, Loss, Options};
use federpendel_text::Catalogue;

use crate::args::Fit;
use crate::failure::Failure;
use crate::quantity::{Dimension, parse};
use crate::words::flag_value_of;

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

/// The flags with quantities.
const RATE: ParameterInfo = flag("rate", Range::Positive);
const SIGMA: ParameterInfo = flag("sigma", Range::Positive);
const FROM: ParameterInfo = flag("from", Range::Finite);
const TO: ParameterInfo = flag("to", Range::Finite);

const fn flag(name: &'static str, range: Range) -> ParameterInfo {
    ParameterInfo { name, symbol: "", unit: "", range, default: None }
}

/// What a standard deviation may measure; a number is in the unit of the values.
const SIGMAS: [Dimension; 4] =
    [Dimension::Number, Dimension::Length, Dimension::Velocity, Dimension::Acceleration];

/// What is read of each file.
pub fn choice(arguments: &Fit, catalogue: &Catalogue) -> Result<Choice, Failure> {
    Ok(Choice {
        time: arguments.time.clone(),
        value: arguments.value.clone(),
        quantity: arguments.quantity,
        unit: arguments.unit.clone(),
        run: arguments.run.clone(),
        table: arguments.table.clone(),
        rate: value(&RATE, &arguments.rate, &[Dimension::Frequency], catalogue)?,
    })
}

/// The choices for the fit.
pub fn options(arguments: &Fit, catalogue: &Catalogue) -> Result<Options, Failure> {
    let value = |info, written, dimensions| value(info, written, dimensions, catalogue);
    let from = value(&FROM, &arguments.from, &[Dimension::Time])?;
    let to = value(&TO, &arguments.to, &[Dimension::Time])?;
    if let Some((from, to)) = from.zip(to).filter(|(from, to)| from >= to) {
        let [from, to] = [from, to].map(|time| catalogue.exact_quantity(time, "s").into());
        let [begin, end] = ["--from", "--to"].map(Into::into);
        let variables = [("begin", begin), ("end", end), ("from", from), ("to", to)];
        return Err(Failure::Input(catalogue.format("fit-window-reversed", &variables)));
    }
    Ok(Options {
        laws: laws(arguments.laws.as_deref(), catalogue)?,
        from,
        to,
        sigma: value(&SIGMA, &arguments.sigma, &SIGMAS)?,
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

/// A quantity of one of the dimensions, if it is written.
fn value(
    info: &ParameterInfo,
    written: &Option<String>,
    dimensions: &[Dimension],
    catalogue: &Catalogue,
) -> Result<Option<f64>, Failure> {
    let read = |written: &String| flag_value_of(catalogue, info, dimensions, written);
    let found = written.as_ref().map(read).transpose().map_err(Failure::Input)?;
    Ok(found.map(|(_, value)| value))
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
