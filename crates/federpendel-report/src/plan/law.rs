//! Laws of friction and their coefficients as they are written.

use federpendel::Oscillator;
use federpendel_fit::Quantity;
use federpendel_fit::plan::Law;
use federpendel_text::Catalogue;
use federpendel_text::plot::Role;

/// Digits of a coefficient.
const DIGITS: usize = 3;

/// What a law is called: “Stokes friction”.
pub fn name(catalogue: &Catalogue, law: Law) -> String {
    catalogue.mix(law.alone())
}

/// A value of its reduced coefficient, SI, with its symbol: “γ = 0.05 1/s”.
pub fn coefficient(catalogue: &Catalogue, law: Law, value: f64) -> String {
    let value = [("value", catalogue.quantity(value, law.unit(), DIGITS).into())];
    match law {
        Law::Stokes => catalogue.format("plan-coefficient-stokes", &value),
        Law::Coulomb => catalogue.format("plan-coefficient-coulomb", &value),
        Law::Newton => catalogue.format("plan-coefficient-newton", &value),
    }
}

/// The same in the quantity that an experiment gives: “D = 0.05 kg/s”, the force of dry friction, “½ρc_wA = 0.2 kg/m”.
pub fn as_given(catalogue: &Catalogue, law: Law, value: f64, oscillator: &Oscillator) -> String {
    let whole = oscillator.mass() * value;
    let value = |value: f64, unit| [("value", catalogue.quantity(value, unit, DIGITS).into())];
    match law {
        Law::Stokes => catalogue.format("plan-as-given-stokes", &value(2.0 * whole, "kg/s")),
        Law::Coulomb => catalogue.format("plan-as-given-coulomb", &value(whole, "N")),
        Law::Newton => catalogue.format("plan-as-given-newton", &value(whole, "kg/m")),
    }
}

/// What a recording holds: “Position”.
pub fn quantity(catalogue: &Catalogue, quantity: Quantity) -> String {
    catalogue.text(match quantity {
        Quantity::Position => "fit-quantity-position",
        Quantity::Velocity => "fit-quantity-velocity",
        Quantity::Acceleration => "fit-quantity-acceleration",
    })
}

/// What its curve stands for.
pub fn role(law: Law) -> Role {
    match law {
        Law::Stokes => Role::Stokes,
        Law::Coulomb => Role::Coulomb,
        Law::Newton => Role::Newton,
    }
}
