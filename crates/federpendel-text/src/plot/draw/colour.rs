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

/// The colour of a role as `#rrggbb`.
pub(super) fn css(role: Role, background: Background) -> &'static str {
    let (light, dark) = match role {
        Role::Exact => ("#0072b2", "#56b4e9"),
        Role::Envelope => ("#c05200", "#f0a24a"),
        Role::TurningPoints => ("#222222", "#f2f2f2"),
        Role::Rest => ("#b3006b", "#ff8fd0"),
        Role::Comparison(n) => {
            // Far from the blue of the exact curve in lightness too, since they lie on it.
            [("#00402b", "#e9ff9c"), ("#d55e00", "#ff9248"), ("#8a5a9e", "#d3a4e6")][n % 3]
        }
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
    match role {
        Role::Exact => 36,
        Role::Envelope => 33,
        Role::TurningPoints => 39,
        Role::Rest => 35,
        Role::Comparison(n) => [31, 32, 34][n % 3],
    }
}
