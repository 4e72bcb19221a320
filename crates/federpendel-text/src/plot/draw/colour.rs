//! Colours by role. They are those of Okabe and Ito, or near them, which people who see fewer colours
//! tell apart too; dashes and markers say the same once more.

use crate::plot::Role;

/// What a picture is drawn on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Background {
    /// White.
    #[default]
    Light,
    /// Nearly black.
    Dark,
}

/// Colours of what is held beside the exact motion, on light and dark. Far from its blue in lightness too, since
/// they lie on it; neighbours differ in lightness as well as in hue.
const COMPARISONS: [(&str, &str); 12] = [
    ("#00402b", "#e9ff9c"),
    ("#d55e00", "#ff9248"),
    ("#8a5a9e", "#d3a4e6"),
    ("#009e73", "#1fc08e"),
    ("#5c1a00", "#ffd9c2"),
    ("#c9709f", "#ff7fb6"),
    ("#2f2483", "#a9a2ff"),
    ("#a08000", "#e0b83a"),
    ("#7a1f4b", "#d0567f"),
    ("#5f7f1f", "#a4c95a"),
    ("#222222", "#f2f2f2"),
    ("#808080", "#a0a0a0"),
];

/// The colour of a role as `#rrggbb`.
pub(super) fn css(role: Role, background: Background) -> &'static str {
    let (light, dark) = match role {
        Role::Exact => ("#0072b2", "#56b4e9"),
        Role::Envelope => ("#c05200", "#f0a24a"),
        Role::TurningPoints | Role::Swings => ("#222222", "#f2f2f2"),
        Role::Release => ("#00664b", "#7be0bd"),
        Role::Rest => ("#b3006b", "#ff8fd0"),
        Role::Sticking => ("#b4b4b4", "#70787f"),
        // Neighbours in a stack of areas differ in lightness.
        Role::Kinetic => ("#f0e442", "#f0e442"),
        Role::Potential => ("#56b4e9", "#3d8fc4"),
        Role::Stokes => ("#00b383", "#2bc397"),
        Role::Coulomb => ("#d55e00", "#ee7a1e"),
        Role::Newton => ("#7b3f73", "#c98bc0"),
        Role::Guide => ("#5a5a5a", "#b4b4b4"),
        Role::Comparison(n) => COMPARISONS[n % COMPARISONS.len()],
    };
    match background {
        Background::Light => light,
        Background::Dark => dark,
    }
}

/// The colour of bands as `#rrggbb`, to be drawn over whatever is behind them.
pub(super) fn band(background: Background) -> &'static str {
    match background {
        Background::Light => "#d9d9d9",
        Background::Dark => "#444a50",
    }
}

/// The colour of a role in a terminal, as the number of an ANSI escape: the sixteen that the user's
/// own palette defines, so that they suit its background.
pub(super) fn ansi(role: Role) -> u8 {
    const COMPARISONS: [u8; 12] = [31, 32, 34, 33, 35, 91, 92, 94, 93, 95, 39, 90];
    match role {
        Role::Exact | Role::Potential => 36,
        Role::Envelope | Role::Kinetic => 33,
        Role::TurningPoints | Role::Swings | Role::Guide => 39,
        Role::Rest | Role::Newton => 35,
        Role::Release | Role::Stokes => 32,
        Role::Coulomb => 31,
        Role::Sticking => 90,
        Role::Comparison(n) => COMPARISONS[n % COMPARISONS.len()],
    }
}
